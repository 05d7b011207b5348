// The record of predicate calls (fuzz/record), a short stretch of it: every metric against oracles
// in integers, on ties moved by ulps and on raw bits, and each stage asked for by name.

#include <cstdint>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "../../fuzz/record/blocks.hpp"
#include "../thoroughness.hpp"

namespace signum::fuzz {
namespace {

/// Meeting times take twenty times as long as signs, and so do numbers of thousands of digits.
std::uint64_t calls_of(const Metric& metric) {
    const bool is_slow = metric.make_space != nullptr || metric.shares.extreme;
    return (is_fast ? 400'000U : 20'000U) / (is_slow ? 10 : 1);
}

class RecordOf : public testing::TestWithParam<std::string> {};

TEST_P(RecordOf, HasNoWrongSignAndHearsEveryStage) {
    const Metric* const metric = metric_of(GetParam());
    ASSERT_NE(metric, nullptr);
    const std::uint64_t calls = calls_of(*metric);
    std::ostringstream complaints;
    // A block that no record has: those count from 0.
    const Block block =
        run_block(*metric, 1'000'000, calls, complaints, "record_test.wrong", "here");
    EXPECT_EQ(block.wrong, 0) << complaints.str();
    EXPECT_GE(block.ledger.calls(), calls);
    std::uint64_t stages[stage_count] = {};
    std::uint64_t ties = 0;
    for (const Count& count : block.ledger.counts()) {
        for (std::size_t s = 0; s < stage_count; ++s) stages[s] += count.stages[s];
        ties += count.ties;
    }
    for (const Stage stage : metric->stages)
        EXPECT_GT(stages[static_cast<int>(stage)], calls / 1000) << name_of(stage);
    // Of magnitudes far apart fewer are tied.
    EXPECT_GT(ties, calls / (metric->shares.extreme ? 40 : 20));
}

std::string name_of_case(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    for (char& letter : name)
        if (letter == '-') letter = '_';
    return name;
}
std::set<std::string> names() {
    std::set<std::string> all;
    for (const Metric& metric : all_metrics()) all.emplace(metric.name);
    return all;
}
INSTANTIATE_TEST_SUITE_P(Metrics, RecordOf, testing::ValuesIn(names()), name_of_case);

TEST(Ledger, FindsAWrongSign) {
    Ledger ledger;
    Ledger::Wrong wrong;
    ledger.note(Predicate::ccw, {1, Stage::filter}, 1);
    EXPECT_FALSE(ledger.take_wrong(wrong));
    ledger.note(Predicate::ccw, {1, Stage::exact}, 0);
    EXPECT_TRUE(ledger.take_wrong(wrong));
    EXPECT_EQ(wrong.said, 1);
    EXPECT_EQ(wrong.right, 0);
    EXPECT_FALSE(ledger.take_wrong(wrong));
    const Count& count = ledger.counts()[0];
    EXPECT_EQ(count.calls, 2);
    EXPECT_EQ(count.wrong, 1);
    EXPECT_EQ(count.ties, 1);
    EXPECT_EQ(count.stages[static_cast<int>(Stage::exact)], 1);
}

TEST(Record, LinesAreReadBackAndCutOnesLeftOut) {
    std::ostringstream complaints;
    const Metric& metric = all_metrics()[0];
    const Block block = run_block(metric, 3, 1000, complaints, "record_test.wrong", "here");
    std::istringstream text("# a comment\n" + block.lines + "power ccw 4 1 100 90");
    std::uint64_t counted = 0;
    for (const Line& line : lines_of(text)) {
        EXPECT_EQ(line.metric, metric.name);
        EXPECT_EQ(line.block, 3);
        EXPECT_EQ(line.library, "here");
        counted += line.count.calls;
    }
    EXPECT_EQ(counted, block.ledger.calls());
    // Twice in a record it counts once.
    const auto summary_of = [](const std::string& lines) {
        std::istringstream in(lines);
        std::ostringstream out;
        print_summary(lines_of(in), out);
        return out.str();
    };
    EXPECT_EQ(summary_of(block.lines + block.lines), summary_of(block.lines));
    // The same block again is the same calls.
    EXPECT_EQ(run_block(metric, 3, 1000, complaints, "", "there").ledger.counts()[0].stages,
              block.ledger.counts()[0].stages);
}

TEST(Record, CorpusFilesAreAskedAgain) {
    std::ostringstream complaints;
    std::istringstream corpus(
        "# four points of a circle\n"
        "power points 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x1p+0 "
        "0x0p+0\n");
    EXPECT_EQ(replay_calls(corpus, complaints), 0);
    std::istringstream cut("power points 0x0p+0 0x0p+0 zero");
    EXPECT_THROW((void)replay_calls(cut, complaints), std::runtime_error);
    std::istringstream other("taxicab points 0x0p+0");
    EXPECT_THROW((void)replay_calls(other, complaints), std::runtime_error);
}

}  // namespace
}  // namespace signum::fuzz
