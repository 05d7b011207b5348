#include "attributes.hpp"

#include <algorithm>

namespace signum {
namespace {

/// What stands between quotes, in which two quotes are one.
std::string unquoted(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        result += text[i];
        if (text.substr(i, 2) == "\"\"") ++i;
    }
    return result;
}

}  // namespace

bool is_json_number(std::string_view text) noexcept {
    const auto skip_digits = [&] {
        const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
        text.remove_prefix(count);
        return count;
    };
    if (text.starts_with('-')) text.remove_prefix(1);
    const bool starts_with_zero = text.starts_with('0');
    const std::size_t whole = skip_digits();
    if (whole == 0 || (starts_with_zero && whole > 1)) return false;
    if (text.starts_with('.')) {
        text.remove_prefix(1);
        if (skip_digits() == 0) return false;
    }
    if (text.starts_with('e') || text.starts_with('E')) {
        text.remove_prefix(1);
        if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
        if (skip_digits() == 0) return false;
    }
    return text.empty();
}

AttributeColumns::AttributeColumns(const TextColumns& header, std::span<const std::size_t> taken) {
    for (std::size_t column = 0; column < header.size(); ++column) {
        if (std::ranges::count(taken, column) > 0 || header.text(column).empty()) continue;
        columns_.push_back(column);
        attributes_.push_back({.name = unquoted(header.text(column)), .values = {}});
    }
}

void AttributeColumns::read(const TextColumns& line) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        std::string value;
        if (columns_[i] < line.size()) {
            const std::string_view text = line.text(columns_[i]);
            const bool is_quoted = text.size() < line[columns_[i]].size();
            value = is_quoted ? unquoted(text) : std::string(text);
            if (!value.empty() && (is_quoted || !is_json_number(value)))
                attributes_[i].is_number = false;
        }
        attributes_[i].values.push_back(std::move(value));
    }
}

}  // namespace signum
