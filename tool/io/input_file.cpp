#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "input_file.hpp"
#include "nearest_word.hpp"

namespace signum {
namespace {

constexpr std::size_t block_size = 4 * InputFile::longest_line;

/// Out of descriptors or memory: nothing that another name would cure.
bool is_failure_of_machine(int error) noexcept {
    return error == EMFILE || error == ENFILE || error == ENOMEM || error == EIO;
}

constexpr std::string_view gzip_mark = "\x1F\x8B";

/// What compressed a file that begins so; empty of all others.
std::string_view compressor_of(std::string_view start) noexcept {
    using namespace std::string_view_literals;
    constexpr std::array<std::array<std::string_view, 2>, 5> marks = {
        {{gzip_mark, "gzip"sv},
         {"\xFD\x37zXZ"sv, "xz"sv},
         {"BZh"sv, "bzip2"sv},
         {"\x28\xB5\x2F\xFD"sv, "zstd"sv},
         {"PK\x03\x04"sv, "zip"sv}}};
    for (const auto& [mark, name] : marks)
        if (start.starts_with(mark)) return name;
    return {};
}

/// The position after the text, which starts at `position`.
Position advance(Position position, std::string_view text) noexcept {
    const std::size_t last_end = text.rfind('\n');
    if (last_end == std::string_view::npos) {
        position.column += static_cast<std::int64_t>(text.size());
        return position;
    }
    position.line += std::count(text.begin(), text.end(), '\n');
    position.column = static_cast<std::int64_t>(text.size() - last_end);
    return position;
}

}  // namespace

std::string ending_of(const std::string& path) {
    const std::size_t point = path.rfind('.');
    if (point == std::string::npos || path.find('/', point) != std::string::npos) return "";
    return in_small_letters(path.substr(point + 1));
}

std::string ending_of_input(const std::string& path) {
    constexpr std::string_view compressed = ".gz";
    const bool is = in_small_letters(path).ends_with(compressed);
    return ending_of(is ? path.substr(0, path.size() - compressed.size()) : path);
}

/// zlib's state, and the compressed bytes that it has not taken yet.
struct InputFile::Inflation {
    explicit Inflation(std::string_view start) : compressed(start.begin(), start.end()) {
        constexpr int gzip_alone = 16 + MAX_WBITS;
        if (inflateInit2(&stream, gzip_alone) != Z_OK) throw std::bad_alloc();
    }
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;
    ~Inflation() { inflateEnd(&stream); }

    z_stream stream = {};
    std::vector<unsigned char> compressed;
    std::size_t taken = 0;    ///< of them
    bool has_member = false;  ///< a member has begun and not ended
};

InputFile::InputFile(std::string path, std::string_view kind, Contents contents)
    : path_(std::move(path)), kind_(kind), contents_(contents), buffer_(block_size) {
    if (path_ == "-") {
        descriptor_ = STDIN_FILENO;
    } else {
        descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
        if (descriptor_ < 0) {
            const int error = errno;
            if (is_failure_of_machine(error)) {
                throw MachineError(fmt::format("cannot open {}: {}", path_, std::strerror(error)));
            }
            throw InputError(path_.empty() ? "''" : path_,
                             fmt::format("cannot open it ({}); give {}, or - for standard input",
                                         std::strerror(error), kind_));
        }
    }
    // No destructor runs for a constructor that throws.
    try {
        struct stat status = {};
        if (::fstat(descriptor_, &status) == 0 && S_ISDIR(status.st_mode)) {
            throw InputError(path_, fmt::format("this is a directory; give {}", kind_));
        }
        fill();
        if (contents_ != Contents::bytes && first_bytes().starts_with(gzip_mark)) {
            inflation_ = std::make_unique<Inflation>(first_bytes());
            begin_ = end_ = 0;
            at_end_ = false;
            fill();
        }
        if (contents_ != Contents::bytes) look_at_start();
    } catch (...) {
        if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
        throw;
    }
}

InputFile::~InputFile() {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
}

/// Refuses what is no text.
void InputFile::look_at_start() {
    const std::string_view start(buffer_.data(), end_);
    if (start.starts_with("\xEF\xBB\xBF")) begin_ = 3;
    if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) {
        fail({}, "this is UTF-16 text; save the file as UTF-8 or ASCII");
    }
    if (start.starts_with("\x93NUMPY"))
        throw InputError(path_, kind_ == "a file of sites"
                                    ? "this is an array of NumPy's; add --read-as npy, or call it "
                                      ".npy"
                                    : fmt::format("this is an array of NumPy's, and no {}", kind_));
    if (const std::string_view by = compressor_of(start); !by.empty()) {
        throw InputError(path_, fmt::format("this is compressed by {}, and of compressed files "
                                            "those of gzip alone are read, where they hold text; "
                                            "decompress it first",
                                            by));
    }
    refuse_binary(begin_);
}

void InputFile::fail(Position position, std::string_view message) const {
    throw InputError(path_, position, message);
}

char InputFile::first_character() const noexcept {
    const std::string_view text = first_bytes();
    const std::size_t found = text.find_first_not_of(" \t\r\n");
    return found == std::string_view::npos ? '\0' : text[found];
}

/// Moves the bytes not handed out yet to the front and reads behind them until the buffer is full
/// or the file ends.
void InputFile::fill() {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    while (!at_end_ && end_ < buffer_.size()) {
        char* const to = buffer_.data() + end_;
        const std::size_t most = buffer_.size() - end_;
        const std::size_t count = inflation_ ? read_inflated(to, most) : read_bytes(to, most);
        at_end_ = count == 0;
        end_ += count;
    }
}

/// Of the file as it is; 0 at its end.
std::size_t InputFile::read_bytes(char* to, std::size_t most) {
    for (;;) {
        const ssize_t count = ::read(descriptor_, to, most);
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno == EINTR) continue;
        const int error = errno;
        const std::string reason = std::strerror(error);
        if (is_failure_of_machine(error))
            throw MachineError(fmt::format("cannot read {}: {}", path_, reason));
        fail({line_number_ + 1, 1}, fmt::format("cannot read it ({}); give {}", reason, kind_));
    }
}

/// Of what gzip compressed, one member or several; 0 at the end of the last.
std::size_t InputFile::read_inflated(char* to, std::size_t most) {
    Inflation& state = *inflation_;
    state.stream.next_out = reinterpret_cast<Bytef*>(to);
    state.stream.avail_out = static_cast<uInt>(most);
    const auto given = [&] { return most - state.stream.avail_out; };
    while (given() == 0) {
        if (state.taken == state.compressed.size()) {
            state.compressed.resize(block_size);
            state.compressed.resize(
                read_bytes(reinterpret_cast<char*>(state.compressed.data()), block_size));
            state.taken = 0;
            if (state.compressed.empty() && !state.has_member) return 0;
            if (state.compressed.empty())
                throw InputError(path_, "this is compressed by gzip, and ends before its end");
        }
        state.stream.next_in = state.compressed.data() + state.taken;
        state.stream.avail_in = static_cast<uInt>(state.compressed.size() - state.taken);
        const int outcome = inflate(&state.stream, Z_NO_FLUSH);
        state.taken = state.compressed.size() - state.stream.avail_in;
        state.has_member = outcome != Z_STREAM_END;
        if (outcome == Z_MEM_ERROR) throw std::bad_alloc();
        if (outcome != Z_OK && outcome != Z_STREAM_END)
            throw InputError(path_,
                             fmt::format("this is compressed by gzip, and damaged{}{}",
                                         state.stream.msg == nullptr ? "" : ": ",
                                         state.stream.msg == nullptr ? "" : state.stream.msg));
        if (outcome == Z_STREAM_END) inflateReset(&state.stream);
    }
    return given();
}

/// Stops text at a NUL byte in buffer_[first_new_byte, end_); all before it is known to have none.
void InputFile::refuse_binary(std::size_t first_new_byte) const {
    if (contents_ != Contents::text) return;
    const void* found = std::memchr(buffer_.data() + first_new_byte, '\0', end_ - first_new_byte);
    if (found == nullptr) return;
    const char* start = buffer_.data() + begin_;
    const std::string_view before(
        start, static_cast<std::size_t>(static_cast<const char*>(found) - start));
    // Lines and blocks are counted by the reader that is in use; the other stays at the start.
    Position position = block_position_;
    if (line_number_ > 0) position = {line_number_ + 1, 1};
    fail(advance(position, before),
         fmt::format("a NUL byte, so this is a binary file; give {} as text", kind_));
}

bool InputFile::next_line(std::string_view& line, std::string_view advice) {
    const char* found = nullptr;
    for (int attempt = 0; attempt < 2 && found == nullptr; ++attempt) {
        if (attempt == 1) {
            if (at_end_) break;
            const std::size_t kept = end_ - begin_;
            fill();
            refuse_binary(kept);
        }
        found = static_cast<const char*>(std::memchr(buffer_.data() + begin_, '\n', end_ - begin_));
        // A line that is too long already needs no further block.
        if (found == nullptr && end_ - begin_ > longest_line + 1) break;
    }
    std::size_t size = end_ - begin_;
    if (size == 0) return false;
    if (found != nullptr) size = static_cast<std::size_t>(found - (buffer_.data() + begin_));
    line = std::string_view(buffer_.data() + begin_, size);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (const std::size_t lone = line.find('\r'); lone != std::string_view::npos) {
        fail({line_number_ + 1, static_cast<std::int64_t>(lone) + 1},
             "a line that ends in CR alone; save the file with LF at the ends of lines");
    }
    if (line.size() > longest_line) {
        fail({line_number_ + 1, static_cast<std::int64_t>(longest_line) + 1},
             fmt::format("a line of more than {} bytes; {}", longest_line, advice));
    }
    begin_ += size + (found != nullptr ? 1 : 0);
    ++line_number_;
    return true;
}

std::string_view InputFile::lines_ahead(std::size_t most) {
    if (end_ - begin_ < most && !at_end_) {
        if (buffer_.size() < most) buffer_.resize(most);
        const std::size_t kept = end_ - begin_;
        fill();
        refuse_binary(kept);
    }
    const std::string_view ahead(buffer_.data() + begin_, std::min(most, end_ - begin_));
    return ahead.substr(0, ahead.rfind('\n') + 1);
}

std::optional<std::uint64_t> InputFile::size() const {
    struct stat status = {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<std::uint64_t>(status.st_size);
}

void InputFile::skip(std::uint64_t bytes) {
    const auto ahead = std::min<std::uint64_t>(bytes, end_ - begin_);
    begin_ += ahead;
    if (bytes > ahead && ::lseek(descriptor_, static_cast<off_t>(bytes - ahead), SEEK_CUR) < 0)
        throw MachineError(fmt::format("cannot read {}: {}", path_, std::strerror(errno)));
}

std::string_view InputFile::next_block() {
    if (begin_ == end_) {
        fill();
        refuse_binary(0);
    }
    const std::string_view block(buffer_.data() + begin_, end_ - begin_);
    begin_ = end_;
    if (contents_ == Contents::text) block_position_ = advance(block_position_, block);
    return block;
}

}  // namespace signum
