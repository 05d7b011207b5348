/// signum triangulate --memory: the bytes that it writes without, from each file that it reads in
/// slices; and a sentence for what it does not. With --resume, the same bytes after any end.

#include <sys/file.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

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

    [[nodiscard]] std::string made(const std::string& name, const Words& more = {},
                                   const std::string& count = "60000") const {
        const std::string path = scratch.path(name);
        Words words = {"generate", "random", "-n", count, "--radius", "0:3", "-o", path};
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

/// Calls with --resume, of sites in more than ten parts.
class Resumed : public WithinMemory {
 protected:
    const std::string faces = scratch.path("faces.i32");
    const std::string folder = faces + ".parts";

    [[nodiscard]] Words call(const std::string& sites, const Words& more = {}) const {
        Words words = {"triangulate", sites, "--metric", "power", "--memory", "2M",
                       "--threads",   "1",   "--resume", "-o",    faces};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    [[nodiscard]] std::string of_the_whole(const std::string& sites) const {
        const std::string whole = scratch.path("whole.i32");
        EXPECT_EQ(run({"triangulate", sites, "--metric", "power", "-o", whole}).code, 0);
        return contents(whole);
    }
    /// Files of the folder whose names begin and end so.
    [[nodiscard]] std::vector<std::string> files(const std::string& begin,
                                                 const std::string& end) const {
        std::vector<std::string> paths;
        std::error_code ignored;
        for (std::filesystem::directory_iterator each(folder, ignored), none; each != none;
             each.increment(ignored)) {
            const std::string name = each->path().filename().string();
            if (name.starts_with(begin) && name.ends_with(end)) paths.push_back(each->path());
        }
        return paths;
    }
    /// Kills a call when so many parts are settled.
    void kill_after(std::size_t settled, const std::string& sites) const {
        const Outcome outcome =
            run(call(sites),
                {.kill_when = [&] { return files("faces-", ".piece").size() >= settled; }});
        ASSERT_EQ(outcome.code, -SIGKILL) << outcome.err;
        EXPECT_FALSE(std::filesystem::exists(faces));
    }
};

TEST_F(Resumed, GoesOnWhereItWasKilled) {
    const std::string sites = made("sites.f64", {}, "200000");
    const std::string whole = of_the_whole(sites);
    const std::size_t before = scratch.size();
    kill_after(4, sites);
    EXPECT_EQ(scratch.size(), before + 1);
    const std::size_t there = files("", ".piece").size();
    const Outcome outcome = run(call(sites));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("taken    " + std::to_string(there) + " of "), std::string::npos)
        << outcome.err;
    EXPECT_EQ(contents(faces), whole);
    EXPECT_FALSE(std::filesystem::exists(folder));
    EXPECT_EQ(scratch.size(), before + 1);  // the faces
}

TEST_F(Resumed, GoesOnAfterAnyMoment) {
    const std::string sites = made("sites.txt");
    const std::string whole = of_the_whole(sites);
    const std::size_t before = scratch.size();
    int killed = 0;
    for (std::chrono::milliseconds time(20);; time += std::chrono::milliseconds(15), ++killed) {
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome =
            run(call(sites),
                {.kill_when = [&] { return std::chrono::steady_clock::now() - start > time; }});
        if (outcome.code == 0) break;
        ASSERT_EQ(outcome.code, -SIGKILL) << outcome.err;
    }
    EXPECT_GT(killed, 1);
    EXPECT_EQ(contents(faces), whole);
    EXPECT_EQ(scratch.size(), before + 1);
}

TEST_F(Resumed, MakesDamagedPiecesAnew) {
    const std::string sites = made("sites.f64");
    const std::string whole = of_the_whole(sites);
    kill_after(3, sites);
    const std::string damaged = files("faces-", ".piece").front();
    std::filesystem::resize_file(damaged, 1000);
    const Outcome outcome = run(call(sites, {"--quiet"}));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "signum: " + damaged + " is damaged, and is made anew\n");
    EXPECT_EQ(contents(faces), whole);
}

TEST_F(Resumed, GoesOnWhereTheDiskWasFull) {
    const std::string sites = made("sites.f64", {}, "100000");
    // For what is dealt, then for the faces of a part, and at last for all faces.
    for (const int kilobytes : {100, 215, 1024}) {
        const Outcome full = run(call(sites), {.file_size = static_cast<rlim_t>(kilobytes) << 10});
        EXPECT_EQ(full.code, 3);
        EXPECT_TRUE(full.err.ends_with("; the same call goes on from what is done\n")) << full.err;
        EXPECT_TRUE(std::filesystem::exists(folder));
        EXPECT_TRUE(files("", ".tmp").empty());
    }
    const Outcome outcome = run(call(sites));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(contents(faces), of_the_whole(sites));
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(Resumed, RefusesThePiecesOfAnotherCall) {
    const std::string sites = made("sites.f64");
    kill_after(2, sites);
    const auto expect_difference = [&](const Words& more, const std::string& difference) {
        Words words = call(sites);
        // An option that is there already has another value.
        for (std::size_t k = 0; k + 1 < more.size(); k += 2) {
            const auto option = std::ranges::find(words, more[k]);
            if (option == words.end())
                words.insert(words.end(), {more[k], more[k + 1]});
            else
                option[1] = more[k + 1];
        }
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 2);
        const std::string begin =
            "signum: the pieces in " + folder + " are another call's: " + difference;
        EXPECT_TRUE(outcome.err.starts_with(begin)) << outcome.err;
        EXPECT_TRUE(
            outcome.err.ends_with("; give the arguments of that call, delete the folder, "
                                  "or leave --resume out\n"))
            << outcome.err;
    };
    expect_difference({"--metric", "euclidean"},
                      "metric power there and euclidean here, it had --memory 2M --threads 1;");
    expect_difference({"--weight-is", "weight"}, "weight_is radius there and weight here, it had");
    expect_difference({"--memory", "3M"}, "parts 13 there and 9 here, it had");
    // Other sites in a file of the same size.
    std::string bytes = contents(sites);
    bytes[3] = static_cast<char>(bytes[3] ^ 1);
    static_cast<void>(scratch.file("sites.f64", bytes));
    expect_difference({}, "checksum ");
    static_cast<void>(scratch.file("faces.i32.parts/manifest.json", "{\"form"));
    expect_refusal(call(sites), "signum: " + folder +
                                    "/manifest.json is damaged; delete its folder, or leave "
                                    "--resume out\n");
    EXPECT_FALSE(files("faces-", ".piece").empty());
    // A folder that is somebody else's stays as it is.
    std::filesystem::remove(folder + "/manifest.json");
    expect_refusal(call(sites), "signum: " + folder +
                                    " is there, and has no pieces; move it away, or leave "
                                    "--resume out\n");
    EXPECT_FALSE(files("faces-", ".piece").empty());
    std::filesystem::remove_all(folder);
    EXPECT_EQ(run(call(sites)).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(Resumed, LeavesAFolderToOneProcessAtATime) {
    const std::string sites = made("sites.f64");
    kill_after(2, sites);
    const int manifest = ::open((folder + "/manifest.json").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(manifest, LOCK_EX | LOCK_NB), 0);
    const Outcome outcome = run(call(sites));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "signum: another process works in " + folder +
                               "; wait for its end, or give another -o\n");
    ::close(manifest);
    EXPECT_EQ(run(call(sites)).code, 0);
}

TEST_F(Resumed, LeavesNoFolderWhereNothingIsToBeResumed) {
    const std::string line = scratch.file("line.txt", "0 0\n1 1\n2 2\n");
    expect_refusal(call(line), "signum: " + line +
                                   ": the sites lie on one line, or are hidden by one of them; "
                                   "leave --memory out\n");
    const std::string wrong = scratch.file("wrong.txt", "0 0\n1 seven\n");
    EXPECT_EQ(run(call(wrong)).code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder));
    expect_refusal({"triangulate", line, "--resume", "-o", faces},
                   "signum: --resume goes with --memory, as in --memory 4G; add it, or leave "
                   "--resume out\n");
    expect_refusal({"triangulate", line, "--memory", "1G", "--resume", "--format", "i32"},
                   "signum: --resume keeps pieces beside a file; give one by -o\n");
    expect_refusal({"triangulate", line, "--memory", "1G", "--resume", "-o", "/nowhere/a.i32"},
                   "signum: cannot keep pieces in /nowhere/a.i32.parts: No such file or "
                   "directory; give a file in a directory that is there\n");
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
