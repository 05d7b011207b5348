#pragma once
/// A file, or standard input, read in blocks; knows the place of every byte it hands out.
///
/// Laws:
///  1. Memory is bounded by one block, whatever the file holds, or by what lines_ahead() is asked
///  for.
///  2. A NUL byte anywhere in text stops with an InputError.
///  3. What gzip compressed is read as what it holds where that is text; places are those in it.
///  4. A UTF-8 byte order mark of text is skipped; a UTF-16 one stops with an InputError.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "errors.hpp"

namespace signum {

/// A fuzzer's files are small, and are to go beyond lines and blocks.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr bool is_for_small_files = true;
#else
inline constexpr bool is_for_small_files = false;
#endif

/// What a file holds.
enum class Contents : std::uint8_t {
    text,
    bytes,
    mixed  ///< lines of text, behind which bytes may follow
};

/// The ending of a path without its point, in small letters; empty where there is none.
[[nodiscard]] std::string ending_of(const std::string& path);
/// The same of a file that is read: of a.pdb.gz that of a.pdb.
[[nodiscard]] std::string ending_of_input(const std::string& path);

class InputFile {
 public:
    /// The longest line, in bytes.
    static constexpr std::size_t longest_line = is_for_small_files ? 500 : 65'536;

    /// Opens `path`, or standard input for "-". `kind` says what the file should hold ("a file of
    /// sites") when it is a directory or cannot be opened, which is an InputError.
    InputFile(std::string path, std::string_view kind, Contents contents = Contents::text);
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile();

    [[nodiscard]] const std::string& path() const noexcept { return path_; }

    /// The bytes that the first block holds. To be asked before anything is read.
    [[nodiscard]] std::string_view first_bytes() const noexcept {
        return {buffer_.data() + begin_, end_ - begin_};
    }
    /// The first of them that is no blank, tab or line end; 0 when there is none.
    [[nodiscard]] char first_character() const noexcept;

    /// The next line without its end (LF or CRLF), valid until the next call; false at the end.
    /// A line longer than longest_line is an InputError that ends with the advice what to write;
    /// one that ends in CR alone is an InputError, too.
    [[nodiscard]] bool next_line(std::string_view& line, std::string_view advice);
    /// The number of the line that next_line() gave last, from 1.
    [[nodiscard]] std::int64_t line_number() const noexcept { return line_number_; }

    /// The whole lines that come next, as many as `most` bytes hold, valid until the next call;
    /// none where a line is longer, and at the end of a file that does not end with one.
    [[nodiscard]] std::string_view lines_ahead(std::size_t most);
    /// Goes on behind so many bytes of them, which are so many lines.
    void skip_lines(std::size_t bytes, std::int64_t lines) noexcept {
        begin_ += bytes;
        line_number_ += lines;
    }

    /// The next bytes, at most one block, valid until the next call; empty at the end. Not to be
    /// mixed with next_line(), but for what is mixed itself: behind the last line.
    [[nodiscard]] std::string_view next_block();
    /// How many bytes the file has; nothing where that is not known, as of a pipe.
    [[nodiscard]] std::optional<std::uint64_t> size() const;
    /// Passes over so many bytes of what next_block() gives. Precondition: the file has a size.
    void skip(std::uint64_t bytes);

    /// Throws an InputError of this file.
    [[noreturn]] void fail(Position position, std::string_view message) const;

 private:
    void fill();
    std::size_t read_bytes(char* to, std::size_t most);
    std::size_t read_inflated(char* to, std::size_t most);
    void look_at_start();
    void refuse_binary(std::size_t first_new_byte) const;

    std::string path_;
    std::string kind_;
    Contents contents_;
    int descriptor_ = -1;
    struct Inflation;
    std::unique_ptr<Inflation> inflation_;  ///< of a file that gzip compressed
    bool at_end_ = false;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;  ///< the bytes not handed out yet: buffer_[begin_, end_)
    std::size_t end_ = 0;
    std::int64_t line_number_ = 0;
    Position block_position_;  ///< of buffer_[begin_], for next_block() of text
};

}  // namespace signum
