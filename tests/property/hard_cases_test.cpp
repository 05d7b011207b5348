// The hard cases of tests/hard/: what the library says of each is what the oracles have written
// there, whatever builds the tessellation and in every floating-point environment.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../hard/library_of_motion.hpp"
#include "../hard/library_of_plane.hpp"
#include "../hard/library_of_space.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

using hard::Case;
using hard::Lines;
using hard::Way;

/// Of the environments one in so many, and of the files: each takes long there.
const int share = is_fast ? 1 : environments;
const std::size_t share_of_files = is_fast ? 1 : 4;

std::vector<std::string> files() {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(SIGNUM_SOURCES "/tests/hard"))
        if (entry.path().extension() == ".txt") result.push_back(entry.path().string());
    std::ranges::sort(result);
    return result;
}

TEST(HardCases, AreThere) {
    EXPECT_GE(files().size(), 106U);
}

TEST(HardCases, ADifferenceIsFound) {
    using hard::agrees;
    EXPECT_EQ(hard::shortened({"-", "-", "0", "+"}), "-*2 0 +");
    EXPECT_TRUE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - - 0 +*3 +"));
    EXPECT_TRUE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - ? 0 ?*4"));
    EXPECT_FALSE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: -*2 0 +*5"));
    EXPECT_FALSE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - 0*2 +*4"));
    EXPECT_FALSE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 3: -*2 0 +*4"));
    EXPECT_FALSE(agrees("ccw 0 1 2: - ?", "ccw 0 1 2: - 0"));
    EXPECT_FALSE(agrees("  a 0 1 2, 0 2 3", "  a 0 1 2, 0 2 4"));
}

TEST(HardCases, MoveByUlpsAcrossZeroAndToTheEnds) {
    EXPECT_EQ(hard::moved_by_ulps(1.0, 1), 0x1.0000000000001p0);
    EXPECT_EQ(hard::moved_by_ulps(1.0, -1), 0x1.fffffffffffffp-1);
    EXPECT_EQ(hard::moved_by_ulps(0x1p-1074, -2), -0x1p-1074);
    EXPECT_EQ(hard::moved_by_ulps(-0.0, 3), 0x3p-1074);
    EXPECT_THROW(static_cast<void>(hard::moved_by_ulps(0x1.fffffffffffffp1023, 1)),
                 std::out_of_range);
}

/// Every environment, every method, every exact arithmetic.
std::vector<Way> all_ways() {
    std::vector<Way> ways;
    for (int environment = 0; environment < environments; environment += share)
        ways.push_back({{.seed = static_cast<std::uint64_t>(environment)}, environment});
    if (!is_fast) return ways;
    for (const Method method : {Method::flips, Method::sweep}) ways.push_back({{.method = method}});
    for (const Arithmetic arithmetic : all_arithmetics)
        if (is_exact(arithmetic)) ways.push_back({{.arithmetic = arithmetic}});
    return ways;
}

void expect_lines(const Lines& answered, const Lines& expected) {
    ASSERT_EQ(answered.size(), expected.size());
    for (std::size_t i = 0; i < answered.size(); ++i)
        ASSERT_TRUE(hard::agrees(answered[i], expected[i]))
            << "the library says " << answered[i] << "\n     the oracle says " << expected[i];
}

void expect_plane(const Case& given) {
    for (const Way& way : all_ways()) {
        SCOPED_TRACE(name_of_environment(way.environment) + ", " +
                     std::string(name_of(way.options.method)) + ", " +
                     std::string(name_of(way.options.arithmetic)));
        const Lines answered = hard::plane_answers(
            given,
            [&](const char* metric, const std::vector<Site>& sites) {
                return hard::library_of(metric, sites, way);
            },
            [&](const Site& a, const Site& b, const Site& c) {
                return within(way.environment, [&]() -> int { return ccw(a, b, c); });
            });
        ASSERT_NO_FATAL_FAILURE(expect_lines(answered, given.expected));
    }
}

void expect_space(const Case& given) {
    for (int environment = 0; environment < environments; environment += share) {
        SCOPED_TRACE(name_of_environment(environment));
        const Way way{{.seed = static_cast<std::uint64_t>(environment)}, environment};
        const Lines answered = hard::space_answers(given, [&](const std::vector<Site3>& sites) {
            return std::make_unique<hard::LibraryOfSpace>(sites, way);
        });
        ASSERT_NO_FATAL_FAILURE(expect_lines(answered, given.expected));
    }
}

template <std::size_t D>
void expect_motion(const Case& given) {
    for (const motion::Structure structure : motion::all_structures) {
        SCOPED_TRACE(std::string(motion::name_of(structure)));
        const Lines answered = hard::motion_answers<D>(given, [&](const auto& flights) {
            return hard::LibraryOfMotion<D>(flights, structure);
        });
        ASSERT_NO_FATAL_FAILURE(expect_lines(answered, given.expected));
        if (!given.until) break;  // what is asked needs no structure
    }
}

class HardCase : public testing::TestWithParam<std::string> {};

TEST_P(HardCase, IsWhatTheOraclesSay) {
    const Case given = hard::read_case(GetParam());
    ASSERT_FALSE(given.expected.empty()) << "run make_hard_cases";
    if (given.kind == "plane") expect_plane(given);
    if (given.kind == "space") expect_space(given);
    if (given.kind == "motion") expect_motion<2>(given);
    if (given.kind == "motion_in_space") expect_motion<3>(given);
}

std::vector<std::string> chosen_files() {
    std::vector<std::string> result;
    const std::vector<std::string> all = files();
    for (std::size_t i = 0; i < all.size(); i += share_of_files) result.push_back(all[i]);
    return result;
}

INSTANTIATE_TEST_SUITE_P(Files, HardCase, testing::ValuesIn(chosen_files()), [](const auto& file) {
    return std::filesystem::path(file.param).stem().string();
});

}  // namespace
}  // namespace signum
