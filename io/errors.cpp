#include <fmt/format.h>

#include "errors.hpp"

namespace signum {

namespace {

std::string escaped(char c) {
    return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

}  // namespace

std::string without_controls(std::string_view message) {
    std::string result;
    for (const char c : message)
        if (static_cast<unsigned char>(c) >= ' ' && c != '\x7f')
            result += c;
        else
            result += escaped(c);
    return result;
}

InputError::InputError(std::string_view file, Position position, std::string_view message)
    : std::runtime_error(without_controls(
          fmt::format("{}:{}:{}: {}", file, position.line, position.column, message))) {}

InputError::InputError(std::string_view file, std::string_view message)
    : std::runtime_error(without_controls(fmt::format("{}: {}", file, message))) {}

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
