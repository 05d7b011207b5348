#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "../../tool/io/output_file.hpp"

#include "io_scratch.hpp"

namespace signum {
namespace {

using test::contents;
using test::Scratch;

std::string failure(const std::string& path, std::size_t size) {
    try {
        OutputFile file(path);
        file.stream() << std::string(size, 'x');
        file.publish();
    } catch (const MachineError& error) {
        return error.what();
    } catch (const NameError& error) {
        return error.what();
    }
    return "no error";
}

TEST(OutputFile, AppearsWhenItIsComplete) {
    const Scratch scratch;
    const std::string path = scratch.file("out", "old");
    OutputFile file(path);
    file.stream() << std::string(1'000'000, 'x');
    EXPECT_EQ(contents(path), "old");
    file.finish();
    EXPECT_EQ(contents(path), "old");
    file.publish();
    EXPECT_EQ(contents(path), std::string(1'000'000, 'x'));
    EXPECT_EQ(scratch.size(), 1U);
}

TEST(OutputFile, LeavesNothingBehindUnlessPublished) {
    const Scratch scratch;
    {
        OutputFile file(scratch.path("out"));
        file.stream() << "half";
        EXPECT_EQ(scratch.size(), 1U);
    }
    EXPECT_EQ(scratch.size(), 0U);
    OutputFile file(scratch.path("out"));
    remove_unfinished_files();
    EXPECT_EQ(scratch.size(), 0U);
}

TEST(OutputFile, KeepsLinksAndPermissions) {
    const Scratch scratch;
    const std::string target = scratch.file("target", "old");
    ASSERT_EQ(::chmod(target.c_str(), 0640), 0);
    std::filesystem::create_symlink("target", scratch.path("link"));
    EXPECT_EQ(failure(scratch.path("link"), 3), "no error");
    EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link")));
    EXPECT_EQ(contents(target), "xxx");
    struct stat status = {};
    ASSERT_EQ(::stat(target.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640U);
}

/// Whom permissions bind: root they do not.
class Nobody {
 public:
    Nobody() {
        if (::geteuid() == 0) is_set_ = ::seteuid(65534) == 0;
    }
    Nobody(const Nobody&) = delete;
    Nobody& operator=(const Nobody&) = delete;
    ~Nobody() {
        if (is_set_) static_cast<void>(!::seteuid(0));
    }

 private:
    bool is_set_ = false;
};

TEST(OutputFile, DoesNotReplaceWhatIsProtected) {
    const Scratch scratch;
    const std::string path = scratch.file("out", "old");
    ASSERT_EQ(::chmod(scratch.path("").c_str(), 0777), 0);
    ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
    const Nobody nobody;
    if (::geteuid() == 0) GTEST_SKIP() << "root may write to everything";
    EXPECT_EQ(failure(path, 3), "cannot write " + path + ": Permission denied");
    EXPECT_EQ(failure(scratch.path("other"), 3), "no error");
    EXPECT_EQ(contents(path), "old");
    EXPECT_EQ(scratch.size(), 2U);
}

TEST(OutputFile, WritesDevicesDirectly) {
    EXPECT_EQ(failure("/dev/null", 1'000'000), "no error");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(OutputFile, SaysWhatFailed) {
    const Scratch scratch;
    const std::string other = "; give a file in a directory that is there";
    const std::string nowhere = scratch.path("no/such");
    EXPECT_EQ(failure(nowhere, 1),
              "cannot write " + nowhere + ": No such file or directory" + other);
    const std::string directory = scratch.path("");
    EXPECT_EQ(failure(directory, 1), "cannot write " + directory + ": Is a directory" + other);
    const std::string below = scratch.file("file", "") + "/out";
    EXPECT_EQ(failure(below, 1), "cannot write " + below + ": Not a directory" + other);
    EXPECT_EQ(failure("/dev/full", 1), "cannot write /dev/full: No space left on device");
    EXPECT_EQ(failure("/dev/full", 1'000'000), "cannot write /dev/full: No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

}  // namespace
}  // namespace signum
