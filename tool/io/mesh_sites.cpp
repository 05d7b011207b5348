#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "number.hpp"
#include "sites_readers.hpp"

namespace signum {
namespace {

class PlySites {
 public:
    explicit PlySites(InputFile& file)
        : lines_(file,
                 "a PLY file begins with ply, format ascii 1.0, and element vertex with properties "
                 "x, y and z") {
        result_.dimension = 3;
    }

    SitesFile read() {
        read_header();
        for (const Element& element : elements_) {
            const bool is_vertex = element.name == "vertex";
            for (std::uint64_t i = 0; i < element.count; ++i) {
                if (!lines_.next_with_words()) {
                    lines_.fail_at_end(fmt::format("the file ends after {} of {} elements {}", i,
                                                   element.count, element.name));
                }
                if (is_vertex) read_vertex();
            }
        }
        // It may be a vertex that the header does not count.
        if (lines_.next_with_words()) {
            const Element& last = elements_.back();
            lines_.fail_at(
                0, fmt::format("a line beyond the {} {}", last.count,
                               last.name == "vertex" ? "vertices" : "elements " + last.name));
        }
        if (result_.in_space.empty()) lines_.fail_at_end("no vertex in this file");
        return std::move(result_);
    }

 private:
    struct Element {
        std::string name;
        std::uint64_t count = 0;
    };

    void read_header() {
        if (!lines_.next() || lines_.size() != 1 || lines_[0] != "ply")
            lines_.fail_at_end("this is no PLY file");
        while (lines_.next_with_words()) {
            const std::string_view what = lines_[0];
            if (what == "end_header") {
                if (lines_.size() > 1) lines_.fail_at(1, "end_header stands alone in its line");
                return check_header();
            }
            if (what == "format")
                read_format();
            else if (what == "element")
                read_element();
            else if (what == "property")
                read_property();
            else if (what != "comment" && what != "obj_info")
                lines_.fail_at(0, fmt::format("{} cannot stand in the header of a PLY file; it "
                                              "ends with end_header",
                                              in_quotes(what)));
        }
        lines_.fail_at_end("the file ends within the header");
    }

    void read_format() {
        has_format_ = true;
        if (lines_.size() > 1 && lines_[1] == "ascii") return;
        lines_.fail_at(1, "a PLY file is read in ASCII alone; save it as format ascii 1.0");
    }

    void read_element() {
        const auto count =
            lines_.size() == 3 ? parse_whole_number(lines_[2]) : std::optional<std::uint64_t>();
        if (!count) lines_.fail_at(1, "an element is a line element NAME NUMBER");
        if (lines_[1] == "vertex" && std::exchange(has_vertices_, true))
            lines_.fail_at(1, "a second element vertex; leave one of them out");
        if (elements_.size() == most_elements)
            lines_.fail_at(0, fmt::format("more than {} elements; leave some out", most_elements));
        elements_.push_back({std::string(lines_[1]), *count});
    }

    void read_property() {
        if (elements_.empty() || lines_.size() < 3)
            lines_.fail_at(0, "a property is a line property TYPE NAME below its element");
        if (elements_.back().name != "vertex") return;
        const std::string_view name = lines_[lines_.size() - 1];
        if (lines_[1] != "list" && std::ranges::find(types, lines_[1]) == types.end())
            lines_.fail_at(1, fmt::format("{} is no type of PLY's; for a number give double",
                                          in_quotes(lines_[1])));
        if (lines_[1] == "list")
            lines_.fail_at(1, "a list in a vertex is not read; leave the property out");
        const std::size_t place = properties_++;
        const std::size_t which = name == "x"                            ? 0
                                  : name == "y"                          ? 1
                                  : name == "z"                          ? 2
                                  : name == "radius" || name == "weight" ? radius
                                                                         : no_word;
        if (which == no_word) return;
        if (places_[which] != no_word)
            lines_.fail_at(lines_.size() - 1,
                           which == radius
                               ? "a second property of radii or weights; leave one of them out"
                               : fmt::format("a second property {}; leave one of them out", name));
        places_[which] = place;
        if (which == radius) result_.third = name == "weight" ? WeightIs::weight : WeightIs::radius;
    }

    void check_header() {
        if (!has_format_) lines_.fail_at_end("the header has no line format ascii 1.0");
        for (std::size_t which = 0; which < radius; ++which)
            if (places_[which] == no_word) lines_.fail_at_end("no vertices with x, y and z");
    }

    void read_vertex() {
        if (lines_.size() != properties_) {
            lines_.fail_at(std::min(lines_.size(), properties_),
                           fmt::format("{} numbers, but the header names {} properties of a vertex",
                                       lines_.size(), properties_));
        }
        add_site(result_, lines_, places_);
    }

    static constexpr std::array<std::string_view, 16> types = {
        "char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
        "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
    static constexpr std::size_t radius = 3;
    static constexpr std::size_t most_elements = 1000;  ///< a file may name more than it has

    LineWords lines_;
    bool has_format_ = false;
    bool has_vertices_ = false;
    std::vector<Element> elements_;
    std::size_t properties_ = 0;  ///< of a vertex
    /// Of x, y, z and r among them.
    std::array<std::size_t, 4> places_ = {no_word, no_word, no_word, no_word};
    SitesFile result_;
};

}  // namespace

SitesFile read_ply_sites(InputFile& file) {
    return PlySites(file).read();
}

}  // namespace signum
