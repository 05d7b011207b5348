#pragma once
/// What a file of sites says about them beside where they are: a population, the name of a city.
///
/// Law: a value is carried as it stands in the file, digit by digit.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text_columns.hpp"

namespace signum {

/// A column of other things than coordinates and radii.
struct Attribute {
    std::string name;
    /// One a site, without the quotes around it; empty where there is none.
    std::vector<std::string> values;
    /// Whether each value that is there is a number as JSON writes numbers, and not in quotes:
    /// 007 and +1 are words.
    bool is_number = true;

    friend bool operator==(const Attribute&, const Attribute&) = default;
};

/// Whether a text is a number of JSON.
[[nodiscard]] bool is_json_number(std::string_view text) noexcept;

/// The attributes of text whose first line is a header.
class AttributeColumns {
 public:
    /// None.
    AttributeColumns() = default;
    /// `header` stands at the first line; the columns in `taken` are no attributes, nor are those
    /// without a name.
    AttributeColumns(const TextColumns& header, std::span<const std::size_t> taken);

    /// The values of a further site.
    void read(const TextColumns& line);

    [[nodiscard]] std::vector<Attribute> attributes() && { return std::move(attributes_); }

 private:
    std::vector<std::size_t> columns_;  ///< by attribute
    std::vector<Attribute> attributes_;
};

}  // namespace signum
