#include <fmt/format.h>

#include "errors.hpp"

namespace signum {

namespace {

std::string escaped(char c) {
    return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

std::string without_controls(std::string_view message) {
    std::string result;
    for (std::size_t i = 0; i < message.size(); ++i) {
        const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(message[k]); };
        // In UTF-8 those from 0x80 to 0x9F are two bytes.
        const bool is_long = byte(i) == 0xC2 && i + 1 < message.size() && byte(i + 1) < 0xA0;
        if (byte(i) < ' ' || byte(i) == 0x7F || is_long)
            result += escaped(message[i]);
        else
            result += message[i];
        if (is_long) result += escaped(message[++i]);
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

}  // namespace

ShownError::ShownError(std::string_view message)
    : std::runtime_error(without_middle(without_controls(message))) {}

InputError::InputError(std::string_view file, Position position, std::string_view message)
    : ShownError(fmt::format("{}:{}:{}: {}", file, position.line, position.column, message)) {}

InputError::InputError(std::string_view file, std::string_view message)
    : ShownError(fmt::format("{}: {}", file, message)) {}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string result = "'";
    for (const char c : text.substr(0, longest)) {
        if (c >= ' ' && c <= '~') {
            result += c;
        } else {
            result += escaped(c);
        }
    }
    result += text.size() > longest ? "...'" : "'";
    return result;
}

}  // namespace signum
