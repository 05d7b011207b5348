#pragma once
/// A table of a scene as it is read: every key by its kind, and every way to be wrong with its
/// place and what would be right.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "../../motion/vector.hpp"
#include "document.hpp"
#include "units.hpp"

namespace signum {

using motion::above_0;
using motion::any_number;
using motion::from_0;
using motion::from_0_to_1;
using motion::Range;

struct Quantity {
    Dimension dimension;
    Range range = any_number;
};

/// "a text", "an array" and so on.
[[nodiscard]] std::string_view kind_of(const toml::node& node);

/// A double: a number, or a text with a unit, in the document's units; or a vector of them. `name`
/// is what messages call it. Throws as Document::fail.
template <class Value>
[[nodiscard]] Value read_value(const Document& document, const toml::node& node,
                               std::string_view name, const Quantity& quantity);

/// All functions with a key throw as Document::fail where the value is of another kind; those
/// without "optional" also where it is missing, at the section's own place.
class Section {
 public:
    /// Refuses keys that keys_of(name) does not have, at once.
    Section(const Document& document, const toml::table& table, std::string name);

    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    [[nodiscard]] const Document& document() const noexcept { return *document_; }
    [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
    /// Null where the key is missing.
    [[nodiscard]] const toml::node* find(std::string_view key) const { return table_->get(key); }
    [[nodiscard]] const toml::node& get(std::string_view key, std::string_view advice) const;

    /// A number, a double, or a vector.
    template <class Value>
    [[nodiscard]] std::optional<Value> optional(std::string_view key,
                                                const Quantity& quantity) const {
        const toml::node* const node = find(key);
        if (node == nullptr) return std::nullopt;
        return read_value<Value>(*document_, *node, key, quantity);
    }
    template <class Value>
    [[nodiscard]] Value required(std::string_view key, const Quantity& quantity,
                                 std::string_view advice) const {
        return read_value<Value>(*document_, get(key, advice), key, quantity);
    }
    /// Empty where the key is missing; refuses an empty text.
    [[nodiscard]] std::string optional_text(std::string_view key) const;
    [[nodiscard]] bool flag(std::string_view key, bool otherwise) const;
    [[nodiscard]] std::optional<std::uint64_t> optional_whole(std::string_view key,
                                                              std::uint64_t least,
                                                              std::uint64_t most) const;
    /// One of the words, or nothing.
    [[nodiscard]] std::optional<std::string> optional_word(
        std::string_view key, std::span<const std::string> words) const;
    [[nodiscard]] std::optional<Section> optional_section(std::string_view key) const;
    /// A table or an array of tables; none where the key is missing.
    [[nodiscard]] std::vector<Section> sections(std::string_view key) const;

    /// At the value of a key, which is there; `message` follows the key's name.
    [[noreturn]] void fail_at(std::string_view key, std::string_view message) const;
    /// At the section.
    [[noreturn]] void fail(std::string_view message) const;
    [[nodiscard]] ScenePlace place() const { return document_->place_of(table_->source()); }

 private:
    [[nodiscard]] std::string inner_name(std::string_view key) const;

    const Document* document_;
    const toml::table* table_;
    std::string name_;
};

}  // namespace signum
