#include "section.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "../io/errors.hpp"
#include "../io/nearest_word.hpp"
#include "../io/number.hpp"
#include "keys.hpp"

namespace signum {
namespace {

/// What the exact arithmetic of motion/ reckons with.
constexpr double largest_of_motion = 0x1p150;

/// The value as messages show it.
std::string shown(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return in_quotes(*text);
    if (const auto number = node.value_exact<std::int64_t>()) return fmt::format("{}", *number);
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
    return std::string(kind_of(node));
}

[[noreturn]] void fail_at_node(const Document& document, const toml::node& node,
                               std::string_view name, std::string_view message) {
    document.fail(node.source(), fmt::format("{}: {}", name, message));
}

double from_text(const Document& document, const toml::node& node, std::string_view name,
                 const Quantity& quantity, const std::string& text) {
    const auto fail = [&](const std::string& message) {
        fail_at_node(document, node, name, message);
    };
    const std::size_t unit_at = begin_of_unit(text);
    std::string_view digits(text.data(), unit_at);
    while (digits.ends_with(' ') || digits.ends_with('\t')) digits.remove_suffix(1);
    const std::string unit_here = document.units.name_of(quantity.dimension);
    const Number number = parse_number(digits);
    if (number.fault != NumberFault::none)
        fail(fmt::format("{} is no quantity; write a number{}", in_quotes(text),
                         unit_here.empty() ? "" : fmt::format(", or \"1 {}\"", unit_here)));
    const std::string_view unit_text = std::string_view(text).substr(unit_at);
    if (unit_text.empty())
        fail(
            fmt::format("{} has no unit; write {} without quotes{}", in_quotes(text), digits,
                        unit_here.empty() ? "" : fmt::format(", or \"{} {}\"", digits, unit_here)));
    const auto parsed = parse_unit(unit_text);
    if (const auto* const wrong = std::get_if<std::string>(&parsed))
        fail(fmt::format("{}: {}", in_quotes(text), *wrong));
    const Unit& unit = std::get<Unit>(parsed);
    if (unit.dimension != quantity.dimension)
        fail(fmt::format("{} is {}, and {} is meant; write {}", in_quotes(text),
                         in_words(unit.dimension), in_words(quantity.dimension),
                         unit_here.empty() ? fmt::format("{}", digits)
                                           : fmt::format("\"{} {}\"", digits, unit_here)));
    return document.units.plain(number.value, unit);
}

void read_into(double& value, const Document& document, const toml::node& node,
               std::string_view name, const Quantity& quantity) {
    if (const auto text = node.value_exact<std::string>()) {
        value = from_text(document, node, name, quantity, *text);
    } else if (const auto whole = node.value_exact<std::int64_t>()) {
        value = static_cast<double>(*whole);
    } else if (const auto number = node.value_exact<double>()) {
        value = *number;
    } else {
        const std::string unit = document.units.name_of(quantity.dimension);
        fail_at_node(
            document, node, name,
            fmt::format("{} where {} is meant; give a number{}", shown(node),
                        in_words(quantity.dimension),
                        unit.empty() ? "" : fmt::format(", or a text like \"1 {}\"", unit)));
    }
    if (!quantity.range.has(value))
        fail_at_node(document, node, name,
                     fmt::format("{} is not allowed; give {}", shown(node), quantity.range.words));
    const double magnitude = std::fabs(value);
    const bool is_time = quantity.dimension == dimensions::time;
    if (!is_time && magnitude != 0.0 &&
        (magnitude > largest_of_motion || magnitude < 1.0 / largest_of_motion))
        fail_at_node(document, node, name,
                     fmt::format("{} is beyond what is computed with; give 0 or a number of 2^-150 "
                                 "to 2^150",
                                 shown(node)));
}

template <int D>
void read_into(motion::Vector<D>& vector, const Document& document, const toml::node& node,
               std::string_view name, const Quantity& quantity) {
    const toml::array* const array = node.as_array();
    const std::string_view wanted = D == 2 ? "[x, y]" : "[x, y, z]";
    if (array == nullptr)
        fail_at_node(document, node, name,
                     fmt::format("{} is no vector; write {}", shown(node), wanted));
    if (array->size() != D)
        fail_at_node(document, node, name,
                     fmt::format("{} {}, but the scene lies in {}; give {}", array->size(),
                                 array->size() == 1 ? "number" : "numbers",
                                 D == 2 ? "the plane" : "space", D));
    for (int k = 0; k < D; ++k)
        read_into(vector[k], document, (*array)[static_cast<std::size_t>(k)], name, quantity);
}

}  // namespace

std::string_view kind_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a text";
        case toml::node_type::integer:
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

template <class Value>
Value read_value(const Document& document, const toml::node& node, std::string_view name,
                 const Quantity& quantity) {
    Value value{};
    read_into(value, document, node, name, quantity);
    return value;
}
template double read_value(const Document&, const toml::node&, std::string_view, const Quantity&);
template motion::Vector<2> read_value(const Document&, const toml::node&, std::string_view,
                                      const Quantity&);
template motion::Vector<3> read_value(const Document&, const toml::node&, std::string_view,
                                      const Quantity&);

Section::Section(const Document& document, const toml::table& table, std::string name)
    : document_(&document), table_(&table), name_(std::move(name)) {
    const std::span<const std::string_view> known = keys_of(name_);
    for (auto&& [key, node] : table) {
        if (std::ranges::find(known, key.str()) != known.end()) continue;
        const std::vector<std::string> words(known.begin(), known.end());
        const auto meant = nearest_word(key.str(), words);
        const std::string here = name_.empty() ? "a scene" : fmt::format("[{}]", name_);
        // A key that an override brought stands where the option stands.
        const toml::source_region& place =
            node.source().path && *node.source().path != document.path() ? node.source()
                                                                         : key.source();
        document.fail(place,
                      fmt::format("{} is no key of {}; {}", in_quotes(key.str()), here,
                                  meant ? fmt::format("did you mean {}?", *meant)
                                        : fmt::format("there are {}", fmt::join(words, ", "))));
    }
}

const toml::node& Section::get(std::string_view key, std::string_view advice) const {
    const toml::node* const node = find(key);
    if (node == nullptr) fail(fmt::format("{} is missing; {}", key, advice));
    return *node;
}

std::string Section::optional_text(std::string_view key) const {
    const toml::node* const node = find(key);
    if (node == nullptr) return "";
    const auto text = node->value_exact<std::string>();
    if (!text)
        fail_at(key,
                fmt::format("{} where a text is meant; write it between quotes", shown(*node)));
    if (text->empty()) fail_at(key, "an empty text; write something, or leave the key out");
    if (has_control_character(*text))
        fail_at(key, "a text of several lines, or with a control character; write it in one line");
    return *text;
}

bool Section::flag(std::string_view key, bool otherwise) const {
    const toml::node* const node = find(key);
    if (node == nullptr) return otherwise;
    const auto value = node->value_exact<bool>();
    if (!value) fail_at(key, fmt::format("{} is neither true nor false; give one", shown(*node)));
    return *value;
}

std::optional<std::uint64_t> Section::optional_whole(std::string_view key, std::uint64_t least,
                                                     std::uint64_t most) const {
    const toml::node* const node = find(key);
    if (node == nullptr) return std::nullopt;
    auto value = node->value_exact<std::int64_t>();
    // 1e6 is as whole as 1000000.
    if (const auto number = node->value_exact<double>();
        number && std::fabs(*number) < 0x1p63 && *number == std::trunc(*number))
        value = static_cast<std::int64_t>(*number);
    if (!value || *value < 0 || static_cast<std::uint64_t>(*value) < least ||
        static_cast<std::uint64_t>(*value) > most)
        fail_at(key, fmt::format("{} is no whole number from {} to {}; give one", shown(*node),
                                 least, most));
    return static_cast<std::uint64_t>(*value);
}

std::optional<std::string> Section::optional_word(std::string_view key,
                                                  std::span<const std::string> words) const {
    const std::string word = optional_text(key);
    if (word.empty()) return std::nullopt;
    for (const std::string& each : words)
        if (in_small_letters(each) == in_small_letters(word)) return each;
    const auto meant = nearest_word(word, words);
    fail_at(key, fmt::format("{} is unknown; {}it is one of {}", in_quotes(word),
                             meant ? fmt::format("did you mean \"{}\"? ", *meant) : "",
                             fmt::join(words, ", ")));
}

std::optional<Section> Section::optional_section(std::string_view key) const {
    const toml::node* const node = find(key);
    if (node == nullptr) return std::nullopt;
    if (!node->is_table())
        fail_at(key, fmt::format("{} is no table; write [{}] and its keys below", shown(*node),
                                 inner_name(key)));
    return Section(*document_, *node->as_table(), inner_name(key));
}

std::vector<Section> Section::sections(std::string_view key) const {
    std::vector<Section> result;
    const toml::node* const node = find(key);
    if (node == nullptr) return result;
    if (const toml::table* const table = node->as_table()) {
        result.emplace_back(*document_, *table, inner_name(key));
        return result;
    }
    const toml::array* const array = node->as_array();
    const std::string advice = fmt::format("write [[{}]] and its keys below", inner_name(key));
    if (array == nullptr) fail_at(key, fmt::format("{} is no table; {}", shown(*node), advice));
    for (const toml::node& each : *array) {
        if (!each.is_table())
            fail_at_node(*document_, each, key,
                         fmt::format("{} is no table; {}", shown(each), advice));
        result.emplace_back(*document_, *each.as_table(), inner_name(key));
    }
    return result;
}

void Section::fail_at(std::string_view key, std::string_view message) const {
    fail_at_node(*document_, *find(key), key, message);
}
void Section::fail(std::string_view message) const {
    document_->fail(table_->source(),
                    name_.empty() ? std::string(message) : fmt::format("[{}]: {}", name_, message));
}

std::string Section::inner_name(std::string_view key) const {
    return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

}  // namespace signum
