#pragma once
/// Numbers as bytes: what NumPy reads, and the same without a head.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace signum {

/// The head of an array of NumPy's, version 1.0: so many rows and columns of numbers of a type that
/// NumPy calls f8, i4 ...
inline void put_npy_head(std::ostream& out, std::string_view type, std::size_t rows,
                         std::size_t columns) {
    constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
    const std::string dictionary =
        fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': ({}, {}), }}", order, type,
                    rows, columns);
    // Blanks and a line's end, so that the numbers begin at a multiple of 64 bytes.
    constexpr std::size_t before = 10;
    constexpr std::size_t aligned = 128;
    const auto length = static_cast<char>(aligned - before);
    out.write("\x93NUMPY\x01\x00", 8).put(length).put(0);
    out << fmt::format("{:<{}}\n", dictionary, aligned - before - 1);
}

/// Numbers as they lie in memory.
template <class Number>
void put_bytes(std::ostream& out, std::span<const Number> numbers) {
    const auto bytes = std::as_bytes(numbers);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
}

/// The numbers of sites that stand in faces and cells: of 32 bits, or of 64 where there are more
/// sites.
class SiteNumbers {
 public:
    explicit SiteNumbers(std::int64_t sites) noexcept
        : are_long_(sites > std::numeric_limits<std::int32_t>::max()) {}
    /// As put_npy_head() takes it.
    [[nodiscard]] std::string_view type() const noexcept { return are_long_ ? "i8" : "i4"; }
    /// How many bytes a number takes.
    [[nodiscard]] std::size_t size() const noexcept { return are_long_ ? 8 : 4; }
    /// Numbers as they lie in a file.
    [[nodiscard]] std::vector<char> bytes(std::span<const std::int64_t> numbers) const {
        std::vector<char> result(size() * numbers.size());
        char* to = result.data();
        const auto put = [&to]<class Number>(Number number) {
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        };
        for (const std::int64_t site : numbers)
            are_long_ ? put(site) : put(static_cast<std::int32_t>(site));
        return result;
    }

 private:
    bool are_long_;
};

}  // namespace signum
