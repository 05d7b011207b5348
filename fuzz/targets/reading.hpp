#pragma once
/// Reading, which may fail in one way alone.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "../../tool/io/errors.hpp"

#include "target.hpp"

namespace signum::fuzz {

/// A message names the file first, is one line, and short enough to be read.
inline void judge_message(std::string_view message, std::string_view path) {
    must(message.starts_with(path) && message.substr(path.size()).starts_with(':'),
         "a message that does not begin with the file");
    must(!has_control_character(message), "a message with a control character");
    must(message.size() < 2000, "a message of more than 2000 bytes");
}

/// Whether these are the same doubles; 0 and -0 are not.
inline bool are_same_numbers(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool are_same_numbers(std::span<const double> a, std::span<const double> b) {
    return std::ranges::equal(a, b, [](double x, double y) { return are_same_numbers(x, y); });
}

/// What `read` gives of the file, or nothing where it throws InputError; whatever else it throws
/// ends the program.
template <class Read>
auto result_of(const std::string& path, const Read& read) -> std::optional<decltype(read(path))> {
    try {
        return read(path);
    } catch (const InputError& error) {
        judge_message(error.what(), path);
        return std::nullopt;
    }
}

}  // namespace signum::fuzz
