#include "document.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../io/input_file.hpp"

namespace signum {
namespace {

std::string whole_text(const std::string& path) {
    InputFile file(path, "a scene");
    std::string text;
    for (std::string_view block = file.next_block(); !block.empty(); block = file.next_block())
        text += block;
    return text;
}

/// What the parser says, and what would be right.
std::string explained(const toml::parse_error& error) {
    const std::string_view what = error.description();
    std::string_view advice = "write TOML: key = value, one a line, texts between quotes";
    if (what.find("redefine") != std::string_view::npos)
        advice = "give a key once in its table";
    else if (what.find("representable") != std::string_view::npos ||
             what.find("could not be interpreted") != std::string_view::npos ||
             what.find("leading zeroes") != std::string_view::npos)
        advice = "write a number like 7, 0.5 or 1e300, whole ones below 2^63";
    else if (what.find("array") != std::string_view::npos)
        advice = "an array is written [1, 2, 3]";
    else if (what.find("string") != std::string_view::npos)
        advice = "a text stands between quotes on one line";
    return fmt::format("{}; {}", what, advice);
}

/// The number of the entry of an array that a key like "2" means.
std::size_t entry_of(const toml::array& array, std::string_view key, const std::string& option) {
    std::size_t number = 0;
    const auto [end, fault] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (fault == std::errc() && end == key.data() + key.size() && number < array.size())
        return number;
    throw OverrideError(
        array.empty()
            ? fmt::format("{}: there are no entries to name; give the whole array", option)
            : fmt::format("{}: {} is no entry of an array; they are 0 to {}", option,
                          in_quotes(key), array.size() - 1));
}

/// Whether a value can only be meant for a text: it begins like nothing of TOML, or goes on behind
/// a number.
bool is_text_without_quotes(std::string_view value) {
    value.remove_prefix(std::min(value.size(), value.find_first_not_of(" \t")));
    return !value.empty() &&
           std::string_view("\"'[{").find(value.front()) == std::string_view::npos &&
           begin_of_unit(value) < value.size();
}

/// How deep a text of TOML goes is asked before it is parsed: the parser takes dotted keys of any
/// depth, and tables within tables are destroyed one within the other, which takes the stack. This
/// is more than anyone writes: tables, arrays and parts of dotted keys, one within the other.
constexpr std::size_t deepest_nesting = 100;

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

/// The byte at which a text is nested deeper than that; nothing where it is not, or where it is no
/// TOML before. O(bytes).
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

const std::string too_deep =
    fmt::format("more than {} tables and arrays, one within the other; no scene goes that deep",
                deepest_nesting);

toml::table parsed_override(const Override& override) {
    const std::string& text = override.toml;
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos || text.find_first_of("\n\r") != std::string::npos ||
        text.find_first_of("[#") < sign)
        throw OverrideError(fmt::format(
            "{}: no key and value; write it like --set effects.restitution=0.8", override.option));
    if (too_deep_at(text)) throw OverrideError(fmt::format("{}: {}", override.option, too_deep));
    try {
        return toml::parse(text, override.option);
    } catch (const toml::parse_error& error) {
        if (is_text_without_quotes(std::string_view(text).substr(sign + 1)))
            throw OverrideError(fmt::format(
                "{}: no TOML; write KEY=VALUE, where a text stands between quotes of its own: "
                "--set 'run.structure=\"lists\"'",
                override.option));
        throw OverrideError(fmt::format("{}: {}", override.option, explained(error)));
    }
}

}  // namespace

Document::Document(const std::string& path, std::span<const Override> overrides)
    : path_(path), text_(whole_text(path)) {
    if (const auto place = too_deep_at(text_)) {
        const std::string_view before = std::string_view(text_).substr(0, *place);
        const auto line = 1 + std::ranges::count(before, '\n');
        const std::size_t last_end = before.rfind('\n');
        const std::size_t column =
            last_end == std::string_view::npos ? before.size() + 1 : before.size() - last_end;
        throw InputError(path_, {line, static_cast<std::int64_t>(column)}, too_deep);
    }
    try {
        root_ = toml::parse(text_, path_);
    } catch (const toml::parse_error& error) {
        throw InputError(path_, position_of(error.source().begin), explained(error));
    }
    for (const Override& each : overrides) {
        toml::table table = parsed_override(each);
        merge(root_, table, each.option);
    }
}

void Document::merge(toml::table& into, toml::table& from, const std::string& option) const {
    for (auto&& [key, node] : from) {
        toml::node* const old = into.get(key.str());
        // A dotted key leads into what is there; a table as a value takes its place.
        toml::table* const inner = node.as_table();
        const bool leads_on = inner != nullptr && !inner->is_inline();
        if (old != nullptr && leads_on && old->is_table()) {
            merge(*old->as_table(), *inner, option);
        } else if (old != nullptr && leads_on && old->is_array()) {
            toml::array& entries = *old->as_array();
            // Of one [[balls]] alone no number is needed.
            const bool is_numbered =
                !inner->empty() && inner->begin()->first.str().find_first_not_of("0123456789") ==
                                       std::string_view::npos;
            if (entries.size() == 1 && entries[0].is_table() && !is_numbered) {
                merge(*entries[0].as_table(), *inner, option);
                continue;
            }
            for (auto&& [number, value] : *inner) {
                const std::size_t entry = entry_of(entries, number.str(), option);
                toml::table* const below = value.as_table();
                if (below != nullptr && !below->is_inline() && entries[entry].is_table())
                    merge(*entries[entry].as_table(), *below, option);
                else
                    entries.replace(entries.begin() + static_cast<std::ptrdiff_t>(entry),
                                    std::move(value));
            }
        } else {
            into.insert_or_assign(key, std::move(node));
        }
    }
}

Position Document::position_of(const toml::source_position& position) const {
    // The parser counts code points, and we bytes. Whoever reads a list asks for places one behind
    // the other: so each goes on where the last one was found.
    const Position wanted{static_cast<std::int64_t>(position.line),
                          static_cast<std::int64_t>(position.column)};
    Walk& walk = walk_;
    if (std::pair(wanted.line, wanted.column) < std::pair(walk.line, walk.column)) walk = {};
    while (walk.line < wanted.line) {
        const std::size_t end = text_.find('\n', walk.byte);
        if (end == std::string::npos) return wanted;
        walk = {walk.line + 1, 1, end + 1, end + 1};
    }
    const auto is_continuation = [&](std::size_t i) {
        return i < text_.size() && (static_cast<unsigned char>(text_[i]) & 0xC0) == 0x80;
    };
    for (; walk.column < wanted.column; ++walk.column) {
        ++walk.byte;
        while (is_continuation(walk.byte)) ++walk.byte;
    }
    return {wanted.line, static_cast<std::int64_t>(walk.byte - walk.begin) + 1};
}

ScenePlace Document::place_of(const toml::source_region& where) const {
    if (where.path && *where.path != path_) return {"", {}, *where.path};
    return {path_, where.begin ? position_of(where.begin) : Position{}, ""};
}

void Document::fail(const toml::source_region& where, std::string_view message) const {
    place_of(where).fail(message);
}

void ScenePlace::fail(std::string_view message) const {
    if (file.empty()) throw OverrideError(fmt::format("{}: {}", option, message));
    throw InputError(file, position, message);
}

}  // namespace signum
