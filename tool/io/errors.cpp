#include <algorithm>

#include <fmt/format.h>

#include "errors.hpp"

namespace signum {

namespace {

std::string escaped(char c) {
    return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

/// How many bytes the control character has that begins at a byte: two for those from 0x80 to 0x9F
/// in UTF-8; 0 where there is none.
std::size_t bytes_of_control(std::string_view text, std::size_t begin) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    if (byte(begin) < ' ' || byte(begin) == 0x7F) return 1;
    return byte(begin) == 0xC2 && begin + 1 < text.size() && byte(begin + 1) < 0xA0 ? 2 : 0;
}

std::string without_controls(std::string_view message) {
    std::string result;
    for (std::size_t i = 0; i < message.size(); ++i) {
        const std::size_t bytes = bytes_of_control(message, i);
        if (bytes == 0) result += message[i];
        for (std::size_t k = 0; k < bytes; ++k) result += escaped(message[i + k]);
        if (bytes == 2) ++i;
    }
    return result;
}

/// Short enough to be read, and cut between characters of UTF-8.
std::string without_middle(std::string message) {
    constexpr std::size_t most = 1600;
    if (message.size() <= most) return message;
    const auto continues = [&](std::size_t i) {
        return (static_cast<unsigned char>(message[i]) & 0xC0U) == 0x80U;
    };
    std::size_t first = most / 2;
    std::size_t second = message.size() - most / 2;
    while (first > 0 && continues(first)) --first;
    while (second < message.size() && continues(second)) ++second;
    return message.replace(first, second - first, "...");
}

/// How many bytes the character has that begins a text, in UTF-8 as RFC 3629 has it; 0 where that
/// is none that can be shown.
std::size_t bytes_of_character(std::string_view text) {
    if (bytes_of_control(text, 0) > 0) return 0;
    const auto byte = [&](std::size_t k) {
        return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
    };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t bytes = first < 0xC2   ? 0
                              : first < 0xE0 ? 2
                              : first < 0xF0 ? 3
                              : first < 0xF5 ? 4
                                             : 0;
    for (std::size_t k = 1; k < bytes; ++k)
        if ((byte(k) & 0xC0U) != 0x80U) return 0;
    // Longer than need be, surrogates, and what lies behind the last character.
    const bool is_wrong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
                          (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
    return is_wrong ? 0 : bytes;
}

}  // namespace

ShownError::ShownError(std::string_view message)
    : std::runtime_error(without_middle(without_controls(message))) {}

InputError::InputError(std::string_view file, Position position, std::string_view message)
    : ShownError(fmt::format("{}:{}:{}: {}", file, position.line, position.column, message)) {}

InputError::InputError(std::string_view file, std::string_view message)
    : ShownError(fmt::format("{}: {}", file, message)) {}

bool has_control_character(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (bytes_of_control(text, i) > 0) return true;
    return false;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string result = "'";
    std::size_t i = 0;
    while (i < text.size()) {
        const std::size_t bytes = bytes_of_character(text.substr(i));
        const std::size_t next = i + std::max<std::size_t>(bytes, 1);
        if (next > longest) break;
        result += bytes > 0 ? std::string(text.substr(i, bytes)) : escaped(text[i]);
        i = next;
    }
    result += i < text.size() ? "...'" : "'";
    return result;
}

}  // namespace signum
