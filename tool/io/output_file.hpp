#pragma once
/// A file that is written beside its place and renamed into it when it is complete.
///
/// Laws:
///  1. Under its name there is never a part of a file: the old contents, none, or all of the new.
///  2. A file that is not published leaves nothing behind, after an exception or, when the program
///     calls remove_unfinished_files() from its signal handlers, after a signal.
///  3. Every failure to write is a MachineError that names the file and the reason, or a NameError
///     where the file cannot have its name. A file that may not be written to is not replaced.
/// What is no regular file (a device, a pipe) cannot be renamed into and is written directly.

#include <memory>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace signum {

/// Bytes to a file descriptor, which stays the caller's; a failure throws MachineError.
class DescriptorBuffer final : public std::streambuf {
 public:
    /// `name` is for the error message.
    DescriptorBuffer(int descriptor, std::string name);

 protected:
    int_type overflow(int_type c) override;
    int sync() override;

 private:
    void write_all();
    int descriptor_;
    std::string name_;
    std::vector<char> bytes_;
};

/// A stream whose failures throw MachineError instead of setting a bit.
class DescriptorStream final : public std::ostream {
 public:
    DescriptorStream(int descriptor, std::string name);

 private:
    DescriptorBuffer buffer_;
};

class OutputFile {
 public:
    /// Creates the file beside `path`, in the same directory, or in another one of its file system.
    explicit OutputFile(std::string path, const std::string& folder = {});
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;
    ~OutputFile();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }
    [[nodiscard]] std::ostream& stream() noexcept { return *stream_; }

    /// All bytes to the disk; the stream is closed after it.
    void finish();
    /// The file under its name. Calls finish() unless that has happened.
    void publish();

 private:
    std::string path_;
    std::string target_;      ///< path_ with symbolic links followed
    std::string unfinished_;  ///< the file beside it; empty when written directly
    int descriptor_ = -1;
    std::size_t slot_ = 0;  ///< in the list of unfinished files
    std::unique_ptr<DescriptorStream> stream_;
};

/// Removes the files of all OutputFile objects that are not published. For signal handlers:
/// async-signal-safe, leaves errno alone. The program is expected to end after it.
void remove_unfinished_files() noexcept;

}  // namespace signum
