/// Scenes that cannot be: each file of tests/scenes/wrong says in its first line what is to be said
/// of it, and so do options that set keys.

#include <algorithm>
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

const std::filesystem::path folder = std::filesystem::path(SIGNUM_SOURCES) / "tests/scenes/wrong";

TEST(WrongScenes, AreRefusedAtTheirPlaceAndNothingIsWritten) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    EXPECT_GE(files.size(), 30U);
    std::ranges::sort(files);
    const Scratch scratch;
    const std::string log = scratch.path("log.csv");
    for (const std::filesystem::path& file : files) {
        const std::string text = contents(file.string());
        const std::string mark = "# expect: ";
        ASSERT_TRUE(text.starts_with(mark)) << file;
        const std::string expected = text.substr(mark.size(), text.find('\n') - mark.size());
        // Beside its file, so that names are those of the file alone.
        std::filesystem::current_path(folder);
        const std::string name = file.filename().string();
        const Outcome result = run({"simulate", name, "-o", log});
        EXPECT_EQ(result.code, 2) << name;
        EXPECT_EQ(result.out, "") << name;
        EXPECT_EQ(result.err, name + ":" + expected + "\n");
        EXPECT_EQ(scratch.size(), 0U) << name;
    }
}

TEST(WrongScenes, AnOptionIsNamed) {
    const Scratch scratch;
    const std::string scene = scratch.file("scene.toml",
                                           "[box]\nlow = [0, 0]\nhigh = [10, 10]\n[balls]\n"
                                           "list = [[5, 5, 1, 1, 0]]\n[run]\nuntil = 1\n");
    const auto refused = [&](const Words& more, const std::string& message) {
        Words words = {"simulate", scene};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome result = run(words);
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err, "signum: " + message + "\n");
    };
    refused(
        {"--set", "effects.restitution=2"},
        "--set effects.restitution=2: restitution: 2 is not allowed; give a number from 0 to 1");
    refused({"--set", "effects.restitutoin=1"},
            "--set effects.restitutoin=1: 'restitutoin' is no key of [effects]; did you mean "
            "restitution?");
    refused({"--set", "run.structure=lists"},
            "--set run.structure=lists: no TOML; write KEY=VALUE, where a text stands between "
            "quotes of its own: --set 'run.structure=\"lists\"'");
    // What is no text without quotes is told by the parser; behind that, what would be right.
    const std::string number = "; write a number like 7, 0.5 or 1e300, whole ones below 2^63";
    const std::string error = ": Error while parsing ";
    refused({"--set", "balls.radius=1e400"},
            "--set balls.radius=1e400" + error +
                "floating-point: '1e400' could not be interpreted as a value" + number);
    refused({"--set", "balls.number=99999999999999999999"},
            "--set balls.number=99999999999999999999" + error +
                "decimal integer: '99999999999999999999' is not representable in 64 bits" + number);
    refused(
        {"--set", "run.until=07"},
        "--set run.until=07" + error + "decimal integer: leading zeroes are prohibited" + number);
    refused({"--set", "box.low=[1, 2"},
            "--set box.low=[1, 2" + error +
                "array: encountered end-of-file; an array is written [1, 2, 3]");
    refused({"--set", "balls.radius=3mm"},
            "--set balls.radius=3mm: no TOML; write KEY=VALUE, where a text stands between quotes "
            "of its own: --set 'run.structure=\"lists\"'");
    refused({"--set", "ball.number=3"},
            "--set ball.number=3: 'ball' is no key of a scene; did you mean balls?");
    refused({"--set", "run.events=2.5"},
            "--set run.events=2.5: events: 2.5 is no whole number from 0 to 4611686018427387904; "
            "give one");
    refused({"--set", "restitution"},
            "--set restitution: no key and value; write it like --set effects.restitution=0.8");
    refused({"--set", "balls.list.1=[1, 1, 1, 0, 0]"},
            "--set balls.list.1=[1, 1, 1, 0, 0]: '1' is no entry of an array; they are 0 to 0");
    refused({"--set", "balls.list.0=[1, 1, 1, 0]"},
            "--set balls.list.0=[1, 1, 1, 0]: list: 4 entries, and a ball in the plane has 5, 6 or "
            "7; write [x, y, r, vx, vy, mass, spin]");
    refused({"--gravity", "0", "0", "-1"},
            "--gravity 0 0 -1: gravity: 3 numbers, but the scene lies in the plane; give 2");
    refused({"--box", "0", "0", "8", "8", "9"},
            "--box 0 0 8 8 9: 5 numbers; give 4 in the plane and 6 in space");
    refused({"-o", scene},
            "-o " + scene + " would overwrite a file of the scene; give another name");
    const std::string balls = scratch.file("balls.txt", "0 0 1 1 0\n");
    const Outcome result = run({"simulate", balls, "--until", "1", "--set", "run.until=2"});
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.err, "signum: --set is for scenes; give FILE.toml\n");
}

}  // namespace
}  // namespace signum
