#pragma once
/// The files of on_disk.hpp: values in files without names, which are gone with the process, and
/// values in pieces, which a later call takes again.
///
/// Law: under a piece's name there is never a part of it. It is written under another name, and
/// gets its own when all of it is on the disk. A seal at its end tells whether it is whole.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../core/insertion_rounds.hpp"

namespace signum::distributed {

/// A checksum of values that goes on from another one. O(n).
template <class T>
[[nodiscard]] std::uint64_t sum_of(std::span<const T> values, std::uint64_t sum) noexcept {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0);
    std::array<std::uint64_t, sizeof(T) / sizeof(std::uint64_t)> words;
    for (const T& value : values) {
        std::memcpy(words.data(), &value, sizeof(T));
        for (const std::uint64_t word : words) sum = mix(sum ^ word) + 1;
    }
    return sum;
}

/// Where a piece lies, and what its checksum begins with, so that it cannot stand for another one.
struct PieceName {
    std::string path;
    std::uint64_t sum;
};

/// The last bytes of a piece.
struct Seal {
    std::uint64_t values = 0;
    std::int64_t hidden = 0;  ///< sites, of a piece of faces
    std::uint64_t sum = 0;    ///< of the values, then of the two numbers above

    [[nodiscard]] static Seal of(std::uint64_t values, std::int64_t hidden, std::uint64_t sum) {
        const std::array<std::uint64_t, 2> numbers = {values, static_cast<std::uint64_t>(hidden)};
        return {values, hidden, sum_of<std::uint64_t>(numbers, sum)};
    }
    [[nodiscard]] bool operator==(const Seal&) const = default;
};

[[noreturn]] inline void fail_on_disk(const std::string& what) {
    throw std::system_error(errno, std::generic_category(), what);
}

/// A file that is closed with the object.
class Descriptor {
 public:
    /// Takes -1, where errno says why, for a failure.
    Descriptor(int number, const std::string& failure) : number_(number) {
        if (number_ < 0) fail_on_disk(failure);
    }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    operator int() const noexcept { return number_; }

 private:
    int number_;
};

/// Values in a file.
template <class T>
class Scratch {
 public:
    /// In a file without a name.
    explicit Scratch(const std::string& folder) : file_(nameless(folder)) {}
    /// In a piece, which is left once keep() is called, and gone otherwise.
    explicit Scratch(const PieceName& name)
        : path_(name.path),
          sum_(name.sum),
          file_(::open(unfinished().c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666),
                "no file can be made: " + unfinished()) {}
    Scratch(Scratch&& other) noexcept
        : path_(std::exchange(other.path_, {})),
          sum_(other.sum_),
          file_(std::move(other.file_)),
          size_(other.size_),
          waiting_(std::move(other.waiting_)) {}
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    Scratch& operator=(Scratch&&) = delete;
    ~Scratch() {
        if (!path_.empty()) ::unlink(unfinished().c_str());
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_ + waiting_.size(); }
    void append(const T& value) {
        waiting_.push_back(value);
        if (waiting_.size() >= many) flush();
    }
    void append(std::span<const T> values) {
        flush();
        write(values);
    }
    [[nodiscard]] std::vector<T> read() {
        flush();
        std::vector<T> values(size_);
        read_at<T>(0, values);
        return values;
    }
    /// Calls use(values) for all of them, some at a time.
    template <class Use>
    void each(const Use& use) {
        flush();
        std::vector<T> some;
        for (std::size_t done = 0; done < size_; done += some.size()) {
            some.resize(std::min(many, size_ - done));
            read_at<T>(done * sizeof(T), some);
            use(std::span<const T>(some));
        }
    }
    [[nodiscard]] int descriptor() {
        flush();
        return file_;
    }
    /// Gives a piece its name, with all of it on the disk.
    void keep(std::int64_t hidden = 0) {
        flush();
        const Seal seal = Seal::of(size_, hidden, sum_);
        write_bytes(&seal, sizeof seal);
        // A file system that cannot synchronize says EINVAL or ENOSYS.
        if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOSYS) fail_to_write();
        if (::rename(unfinished().c_str(), path_.c_str()) != 0) fail_to_write();
        path_.clear();
    }

    /// The piece of a name and how many sites it says are hidden, if it is there and whole. Calls
    /// damaged() where it is there and is not. O(size).
    template <class Damaged>
    [[nodiscard]] static std::optional<std::pair<Scratch, std::int64_t>> kept(
        const PieceName& name, const Damaged& damaged) {
        const int opened = ::open(name.path.c_str(), O_RDONLY | O_CLOEXEC);
        if (opened < 0 && errno == ENOENT) return std::nullopt;
        Scratch piece(Descriptor(opened, "a file of the work cannot be opened"));
        try {
            struct stat status = {};
            Seal seal;
            if (::fstat(opened, &status) != 0) fail_on_disk("");
            const auto bytes = static_cast<std::size_t>(status.st_size);
            if (bytes >= sizeof seal && (bytes - sizeof seal) % sizeof(T) == 0) {
                piece.size_ = (bytes - sizeof seal) / sizeof(T);
                piece.template read_at<Seal>(bytes - sizeof seal, std::span(&seal, 1));
                std::uint64_t sum = name.sum;
                piece.each([&](std::span<const T> some) { sum = sum_of(some, sum); });
                if (seal == Seal::of(piece.size_, seal.hidden, sum))
                    return std::pair(std::move(piece), seal.hidden);
            }
        } catch (const std::system_error&) {
            // The disk does not give it back: it is as good as damaged.
        }
        damaged();
        return std::nullopt;
    }

 private:
    static constexpr std::size_t many = (std::size_t{1} << 16) / sizeof(T);

    explicit Scratch(Descriptor file) : file_(std::move(file)) {}
    [[nodiscard]] static Descriptor nameless(const std::string& folder) {
        const std::string failure = "no file can be made in " + folder;
        const int made = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
        if (made >= 0) return {made, failure};
        // Not every file system has such files.
        std::string name = folder + "/signum_XXXXXX";
        Descriptor file(::mkstemp(name.data()), failure);
        ::unlink(name.c_str());
        return file;
    }
    [[nodiscard]] std::string unfinished() const { return path_ + ".tmp"; }
    [[noreturn]] static void fail_to_write() {
        fail_on_disk("the files of the work cannot be written");
    }
    void flush() {
        write(waiting_);
        waiting_.clear();
    }
    void write(std::span<const T> values) {
        write_bytes(values.data(), values.size_bytes());
        size_ += values.size();
        if (!path_.empty()) sum_ = sum_of(values, sum_);
    }
    void write_bytes(const void* values, std::size_t all) {
        const auto* from = static_cast<const char*>(values);
        for (std::size_t done = 0; done < all;) {
            const ssize_t count = ::write(file_, from + done, all - done);
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) fail_to_write();
            done += static_cast<std::size_t>(count);
        }
    }
    template <class Value>
    void read_at(std::size_t place, std::span<Value> values) const {
        auto* to = reinterpret_cast<char*>(values.data());
        for (std::size_t done = 0; done < values.size_bytes();) {
            const ssize_t count = ::pread(file_, to + done, values.size_bytes() - done,
                                          static_cast<off_t>(place + done));
            if (count < 0 && errno == EINTR) continue;
            if (count <= 0) fail_on_disk("a file of the work cannot be read");
            done += static_cast<std::size_t>(count);
        }
    }

    std::string path_;       ///< of a piece that is not kept yet; otherwise empty
    std::uint64_t sum_ = 0;  ///< of a piece: of what is written
    Descriptor file_;
    std::size_t size_ = 0;
    std::vector<T> waiting_;
};

/// All values of a file, read as they are asked for. The file may be closed.
template <class T>
class Mapped {
 public:
    explicit Mapped(Scratch<T>& file) : size_(file.size()) {
        if (size_ == 0) return;
        void* const at =
            ::mmap(nullptr, size_ * sizeof(T), PROT_READ, MAP_PRIVATE, file.descriptor(), 0);
        if (at == MAP_FAILED) fail_on_disk("the sites cannot be mapped");
        values_ = static_cast<const T*>(at);
    }
    Mapped(const Mapped&) = delete;
    Mapped& operator=(const Mapped&) = delete;
    ~Mapped() {
        if (values_ != nullptr) ::munmap(const_cast<T*>(values_), size_ * sizeof(T));
    }
    [[nodiscard]] std::span<const T> all() const noexcept { return {values_, size_}; }
    /// What has been read is no longer kept.
    void forget() const noexcept {
        if (values_ != nullptr)
            ::madvise(const_cast<T*>(values_), size_ * sizeof(T), MADV_DONTNEED);
    }

 private:
    std::size_t size_;
    const T* values_ = nullptr;
};

}  // namespace signum::distributed
