#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

class NodeSites {
 public:
    NodeSites(InputFile& file, const ReadOptions& options)
        : lines_(file,
                 "a .node file begins with the number of points, 2 or 3, the number of attributes "
                 "and 0 or 1 for boundary markers; then a line each: number x y [z] attributes "
                 "marker",
                 '#'),
          options_(options) {}

    SitesFile read() {
        read_head();
        choose();
        for (std::uint64_t i = 0; i < count_; ++i) {
            if (!lines_.next_with_words())
                lines_.fail_at_end(fmt::format("the file ends after {} of {} points", i, count_));
            read_point(i);
        }
        if (lines_.next_with_words())
            lines_.fail_at(0, fmt::format("a line beyond the {} points of the first line", count_));
        if (result_.sites.size() + result_.in_space.size() == 0)
            lines_.fail_at_end("no point in this file");
        if (!options_.attributes) say_what_is_left_out();
        return std::move(result_);
    }

 private:
    void read_head() {
        if (!lines_.next_with_words()) lines_.fail_at_end("no point in this file");
        std::array<std::uint64_t, 4> head = {0, 2, 0, 0};
        if (lines_.size() < 2) lines_.fail_at(1, "the dimension is missing; " + of_head);
        if (lines_.size() > head.size()) lines_.fail_at(head.size(), "one word more; " + of_head);
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const auto number = parse_whole_number(lines_[i]);
            if (!number)
                lines_.fail_at(
                    i, fmt::format("{} is no whole number; {}", in_quotes(lines_[i]), of_head));
            head.at(i) = *number;
        }
        const auto& [points, dimension, attributes, markers] = head;
        if (dimension != 2 && dimension != 3)
            lines_.fail_at(1, "the dimension of the points is 2 or 3");
        if (options_.dimension && static_cast<int>(dimension) != *options_.dimension) {
            lines_.fail_at(1,
                           fmt::format("the points have {} dimensions, and sites of {} are asked "
                                       "for",
                                       dimension, dimension == 3 ? "the plane" : "space"));
        }
        if (attributes > most_attributes)
            lines_.fail_at(2, fmt::format("at most {} attributes are read", most_attributes));
        if (markers > 1) lines_.fail_at(3, "there are 0 or 1 boundary markers");
        count_ = points;
        dimension_ = dimension;
        attributes_ = attributes;
        markers_ = markers;
        result_.dimension = static_cast<int>(dimension);
    }

    /// The columns of x, y, z and of the radius.
    void choose() {
        for (std::size_t k = 0; k < dimension_; ++k) places_.at(k) = k + 1;
        const Columns& chosen = options_.columns;
        if (!chosen.empty() && (chosen.size() < dimension_ || chosen.size() > dimension_ + 1)) {
            lines_.fail_at(1, fmt::format("{} columns are chosen, and points of {} dimensions have "
                                          "{}, and one more with a radius",
                                          chosen.size(), dimension_, dimension_));
        }
        for (std::size_t which = 0; which < chosen.size(); ++which) {
            const auto number = parse_whole_number(chosen[which]);
            if (!number || *number < 1 || *number > width()) {
                lines_.fail_at(0, fmt::format("column {} is chosen; the columns of this file have "
                                              "no names, and numbers from 1 to {}",
                                              in_quotes(chosen[which]), width()));
            }
            const std::size_t place = *number - 1;
            if (std::ranges::count(std::span(places_).first(which), place) > 0)
                lines_.fail_at(0, fmt::format("column {} is chosen twice", *number));
            places_.at(which) = place;
        }
        if (!options_.attributes) return;
        for (std::size_t i = 0; i < attributes_; ++i)
            result_.attributes.push_back({.name = fmt::format("attribute{}", i + 1), .values = {}});
        if (markers_ > 0) result_.attributes.push_back({.name = "marker", .values = {}});
    }

    void read_point(std::uint64_t index) {
        if (lines_.size() != width()) {
            lines_.fail_at(
                std::min(lines_.size(), width()),
                fmt::format("{} words, but by the first line a point has {}: its number, {} "
                            "coordinates, {} attributes and {} markers",
                            lines_.size(), width(), dimension_, attributes_, markers_));
        }
        const auto number = parse_whole_number(lines_[0]);
        if (index == 0) {
            if (!number || *number > 1)
                lines_.fail_at(0, "points are numbered from 0 or from 1, one after the other");
            first_ = *number;
            result_.first_number = static_cast<int>(first_);
        } else if (number != index + first_) {
            lines_.fail_at(0,
                           fmt::format("{} where point {} comes; they are numbered one after the "
                                       "other",
                                       in_quotes(lines_[0]), index + first_));
        }
        add_site(result_, lines_, places_);
        for (std::size_t i = 0; i < result_.attributes.size(); ++i) {
            Attribute& attribute = result_.attributes[i];
            const std::string_view value = lines_[1 + dimension_ + i];
            attribute.is_number = attribute.is_number && is_json_number(value);
            attribute.values.emplace_back(value);
        }
    }

    void say_what_is_left_out() {
        if (attributes_ + markers_ == 0 || !options_.columns.empty()) return;
        const std::string attributes =
            attributes_ == 1 ? "an attribute" : fmt::format("{} attributes", attributes_);
        const std::string_view coordinates = dimension_ == 2 ? "2,3" : "2,3,4";
        result_.note = fmt::format(
            "{}: {}{}{} left out{}. --columns {} leaves all of it out without a word",
            lines_.path(), attributes_ > 0 ? attributes : "",
            attributes_ > 0 && markers_ > 0 ? " and " : "",
            markers_ > 0       ? "the boundary markers are"
            : attributes_ == 1 ? " is"
                               : " are",
            attributes_ > 0
                ? fmt::format(": no attribute is called a radius; --columns {},{} takes "
                              "the first one for it",
                              coordinates, 2 + dimension_)
                : "",
            coordinates);
    }

    [[nodiscard]] std::size_t width() const { return 1 + dimension_ + attributes_ + markers_; }

    static constexpr std::uint64_t most_attributes = 1000;
    inline static const std::string of_head =
        "the first line is the number of points, their dimension, the number of attributes, and 0 "
        "or 1 for boundary markers";

    LineWords lines_;
    const ReadOptions& options_;
    std::uint64_t count_ = 0;
    std::size_t dimension_ = 2;
    std::size_t attributes_ = 0;
    std::size_t markers_ = 0;
    std::uint64_t first_ = 0;  ///< number of the first point
    /// Of x, y, in space z, and r in a line.
    std::array<std::size_t, 4> places_ = {no_word, no_word, no_word, no_word};
    SitesFile result_;
};

}  // namespace

SitesFile read_node_sites(InputFile& file, const ReadOptions& options) {
    return NodeSites(file, options).read();
}

}  // namespace signum
