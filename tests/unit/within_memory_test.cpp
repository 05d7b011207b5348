/// signum triangulate --memory: the bytes that it writes without, from each file that it reads in
/// slices; and a sentence for what it does not.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "io_scratch.hpp"
#include "tool_call.hpp"

namespace signum {
namespace {

using test::contents;
using test::Outcome;
using test::run;
using test::Scratch;
using test::Words;

class WithinMemory : public testing::Test {
 protected:
    Scratch scratch;

    [[nodiscard]] std::string made(const std::string& name, const Words& more = {}) const {
        const std::string path = scratch.path(name);
        Words words = {"generate", "random", "-n", "60000", "--radius", "0:3", "-o", path};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(run(words).code, 0);
        return path;
    }
    void expect_the_same(const std::string& sites, const Words& more) const {
        for (const std::string ending : {".npy", ".i32"}) {
            const std::string whole = scratch.path("whole" + ending);
            const std::string parts = scratch.path("parts" + ending);
            Words words = {"triangulate", sites, "-o", whole};
            words.insert(words.end(), more.begin(), more.end());
            ASSERT_EQ(run(words).code, 0);
            words[3] = parts;
            words.insert(words.end(), {"--memory", "2M", "--threads", "1"});
            const Outcome outcome = run(words);
            ASSERT_EQ(outcome.code, 0) << outcome.err;
            EXPECT_NE(outcome.err.find("\nparts "), std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.err.find("\nparts    1\n"), std::string::npos) << outcome.err;
            EXPECT_EQ(contents(whole), contents(parts)) << sites << ending;
        }
    }
    void expect_refusal(const Words& words, const std::string& err) const {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err, err);
    }
};

TEST_F(WithinMemory, WritesTheSameBytes) {
    expect_the_same(made("sites.txt"), {"--metric", "power"});
    expect_the_same(made("sites.npy"), {"--metric", "euclidean"});
    expect_the_same(made("sites.f64"), {"--metric", "power", "--weight-is", "weight"});
    const Words space = {"--dimension", "3"};
    expect_the_same(made("space.txt", space), {"--metric", "power", "--dimension", "3"});
    expect_the_same(made("space.npy", space), {"--metric", "power", "--dimension", "3"});
}

TEST_F(WithinMemory, SaysWhatItDoesNotTake) {
    const std::string sites = scratch.file("sites.txt", "0 0\n1 0\n0 1\n1 seven\n");
    const std::string faces = scratch.path("faces.npy");
    const Words call = {"triangulate", sites, "--memory", "1G", "-o", faces};
    const auto with = [&](const Words& more) {
        Words words = call;
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    expect_refusal(call, sites +
                             ":4:1: in slices, lines of two or three numbers are read, x y and "
                             "perhaps r, under a header of these names or none\n");
    EXPECT_FALSE(std::filesystem::exists(faces));
    expect_refusal(with({"-o", scratch.path("a.i32")}),
                   "signum: --memory writes faces, or cells, as they come, into one file: -o "
                   "FILE.npy or FILE.i32\n");
    expect_refusal(with({"--dimension", "3"}),
                   "signum: --metric euclidean: sites in space, as those of " + sites +
                       " are, have tessellations of the power metric alone; leave --metric out\n");
    expect_refusal(
        with({"--check"}),
        "signum: --memory goes with the exact insertion, the order index, and neither "
        "--check nor --stats; leave --method, --arithmetic, --order, --check and --stats "
        "out\n");
    const std::string none = scratch.path("none.npy");
    expect_refusal({"triangulate", none, "--memory", "1G", "-o", faces},
                   none +
                       ": cannot open it (No such file or directory); give a file of sites, or - "
                       "for standard input\n");
    const std::string line = scratch.file("line.txt", "0 0\n1 1\n2 2\n");
    expect_refusal({"triangulate", line, "--metric", "power", "--memory", "1G", "-o", faces},
                   "signum: " + line +
                       ": the sites lie on one line, or are hidden by one of them; "
                       "leave --memory out\n");
    for (const std::string size : {"4", "G", "1K", "-1G", "four"}) {
        const Outcome outcome = run({"triangulate", sites, "--memory", size, "-o", faces});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_NE(outcome.err.find("is no size; give one of 1M or more"), std::string::npos)
            << outcome.err;
    }
    EXPECT_FALSE(std::filesystem::exists(faces));
}

TEST_F(WithinMemory, SaysThatTheDiskIsFull) {
    const std::string sites = made("sites.f64");
    const std::string faces = scratch.path("faces.i32");
    const std::size_t before = scratch.size();
    const Outcome outcome =
        run({"triangulate", sites, "--memory", "1G", "-o", faces}, {.file_size = rlim_t{1} << 20});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "signum: beside " + faces +
                               ": the files of the work cannot be written: File too large\n");
    EXPECT_EQ(scratch.size(), before);
}

}  // namespace
}  // namespace signum
