#include "nesting.hpp"

#include <algorithm>
#include <vector>

namespace signum {
namespace {

/// Behind the string that begins at `start` with a quotation mark.
std::size_t end_of_text(std::string_view toml, std::size_t start) {
    const char mark = toml[start];
    const std::string_view three = mark == '"' ? R"(""")" : "'''";
    const bool is_long = toml.substr(start).starts_with(three);
    std::size_t i = start + (is_long ? three.size() : 1);
    for (; i < toml.size(); ++i) {
        if (mark == '"' && toml[i] == '\\') {
            ++i;
        } else if (is_long ? toml.substr(i).starts_with(three) : toml[i] == mark) {
            i += is_long ? three.size() : 1;
            // Up to two more marks belong to a long text.
            for (int more = 0; is_long && more < 2 && i < toml.size() && toml[i] == mark; ++more)
                ++i;
            return i;
        } else if (!is_long && toml[i] == '\n') {
            return i;
        }
    }
    return toml.size();
}

}  // namespace

std::optional<std::size_t> too_deep_at(std::string_view toml) {
    std::vector<std::size_t> open;  // how deep it is within each bracket that is open
    std::size_t depth = 0;
    const auto within = [&] { return open.empty() ? 0 : open.back(); };
    for (std::size_t i = 0; i < toml.size();) {
        const char c = toml[i];
        if (c == '"' || c == '\'') {
            i = end_of_text(toml, i);
            continue;
        }
        if (c == '#') {
            i = std::min(toml.find('\n', i), toml.size());
            continue;
        }
        if (c == '.') {
            ++depth;
        } else if (c == '[' || c == '{') {
            open.push_back(++depth);
        } else if (c == ']' || c == '}') {
            if (!open.empty()) open.pop_back();
            depth = within();
        } else if (c == ',' || (c == '\n' && open.empty())) {
            depth = within();
        }
        if (depth > deepest_nesting) return i;
        ++i;
    }
    return std::nullopt;
}

}  // namespace signum
