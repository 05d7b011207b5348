#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
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
        : file_(file),
          lines_(file,
                 "a PLY file begins with ply, format ascii 1.0 or a binary one, and element vertex "
                 "with properties x, y and z") {
        result_.dimension = 3;
    }

    SitesFile read() {
        read_header();
        if (is_binary_) return read_bytes();
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
        const std::string_view name = lines_.size() > 1 ? lines_[1] : std::string_view();
        is_big_endian_ = name == "binary_big_endian";
        is_binary_ = is_big_endian_ || name == "binary_little_endian";
        if (!is_binary_ && name != "ascii")
            lines_.fail_at(1, "a format is ascii, binary_little_endian or binary_big_endian");
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
        const auto type = std::ranges::find(types, lines_[1], &Type::name);
        if (lines_[1] != "list" && type == types.end())
            lines_.fail_at(1, fmt::format("{} is no type of PLY's; for a number give double",
                                          in_quotes(lines_[1])));
        if (lines_[1] == "list")
            lines_.fail_at(1, "a list in a vertex is not read; leave the property out");
        const std::size_t place = properties_.size();
        properties_.push_back({*type, bytes_of_vertex_});
        bytes_of_vertex_ += type->bytes;
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
        if (lines_.size() != properties_.size()) {
            lines_.fail_at(std::min(lines_.size(), properties_.size()),
                           fmt::format("{} numbers, but the header names {} properties of a vertex",
                                       lines_.size(), properties_.size()));
        }
        add_site(result_, lines_, places_);
    }

    /// The vertices behind the header, as the machine of the file had them.
    SitesFile read_bytes() {
        if (elements_.front().name != "vertex")
            lines_.fail_at_end(
                fmt::format("in binary files the vertices are to come first, and {} do "
                            "here",
                            elements_.front().name));
        const std::uint64_t count = elements_.front().count;
        if (count == 0) lines_.fail_at_end("no vertex in this file");
        std::vector<char> vertex;
        std::uint64_t read = 0;
        for (std::string_view block = file_.next_block(); !block.empty() && read < count;
             block = file_.next_block()) {
            while (!block.empty() && read < count) {
                const std::size_t take = std::min(block.size(), bytes_of_vertex_ - vertex.size());
                vertex.insert(vertex.end(), block.begin(),
                              block.begin() + static_cast<std::ptrdiff_t>(take));
                block.remove_prefix(take);
                if (vertex.size() < bytes_of_vertex_) break;
                add_vertex(vertex, read++);
                vertex.clear();
            }
        }
        if (read < count)
            throw InputError(file_.path(),
                             fmt::format("the file ends after {} of {} vertices", read, count));
        return std::move(result_);
    }

    void add_vertex(std::span<const char> bytes, std::uint64_t number) {
        std::array<double, 4> numbers = {};
        for (std::size_t which = 0; which < numbers.size(); ++which) {
            if (places_[which] == no_word) continue;
            const Property& property = properties_[places_[which]];
            std::array<char, 8> raw = {};
            const auto part = bytes.subspan(property.offset, property.type.bytes);
            if (is_big_endian_)
                std::ranges::reverse_copy(part, raw.begin());
            else
                std::ranges::copy(part, raw.begin());
            numbers[which] = property.type.value(raw);
            if (!std::isfinite(numbers[which]))
                throw InputError(file_.path(),
                                 fmt::format("vertex {}: a coordinate that is not finite; "
                                             "write a finite one",
                                             number));
        }
        result_.add(numbers, [](std::size_t) { return Position(); });
    }

    /// A number of this type from its bytes, the least first.
    template <class T>
    static double as(const std::array<char, 8>& raw) {
        static_assert(std::endian::native == std::endian::little);
        T value = {};
        std::memcpy(&value, raw.data(), sizeof(T));
        return static_cast<double>(value);
    }
    struct Type {
        std::string_view name;
        std::size_t bytes;
        double (*value)(const std::array<char, 8>&);
    };
    struct Property {
        Type type;
        std::size_t offset;  ///< in a vertex
    };
    static constexpr std::array<Type, 16> types = {{{"char", 1, as<std::int8_t>},
                                                    {"uchar", 1, as<std::uint8_t>},
                                                    {"short", 2, as<std::int16_t>},
                                                    {"ushort", 2, as<std::uint16_t>},
                                                    {"int", 4, as<std::int32_t>},
                                                    {"uint", 4, as<std::uint32_t>},
                                                    {"float", 4, as<float>},
                                                    {"double", 8, as<double>},
                                                    {"int8", 1, as<std::int8_t>},
                                                    {"uint8", 1, as<std::uint8_t>},
                                                    {"int16", 2, as<std::int16_t>},
                                                    {"uint16", 2, as<std::uint16_t>},
                                                    {"int32", 4, as<std::int32_t>},
                                                    {"uint32", 4, as<std::uint32_t>},
                                                    {"float32", 4, as<float>},
                                                    {"float64", 8, as<double>}}};
    static constexpr std::size_t radius = 3;
    static constexpr std::size_t most_elements = 1000;  ///< a file may name more than it has

    InputFile& file_;
    LineWords lines_;
    bool has_format_ = false;
    bool has_vertices_ = false;
    std::vector<Element> elements_;
    std::vector<Property> properties_;  ///< of a vertex
    std::size_t bytes_of_vertex_ = 0;
    bool is_binary_ = false;
    bool is_big_endian_ = false;
    /// Of x, y, z and r among them.
    std::array<std::size_t, 4> places_ = {no_word, no_word, no_word, no_word};
    SitesFile result_;
};

}  // namespace

SitesFile read_off_sites(InputFile& file) {
    LineWords lines(
        file,
        "an OFF file is OFF, the numbers of vertices, faces and edges, and a line x y z "
        "for each vertex",
        '#');
    if (!lines.next_with_words() || lines[0] != "OFF") lines.fail_at_end("this is no OFF file");
    // The numbers may stand behind the word.
    std::size_t first = 1;
    if (lines.size() == 1) {
        if (!lines.next_with_words()) lines.fail_at_end("the file ends within the header");
        first = 0;
    }
    const auto vertices = first < lines.size() ? parse_whole_number(lines[first]) : std::nullopt;
    if (!vertices) lines.fail_at(first, "the number of vertices is to stand here");
    SitesFile result;
    result.dimension = 3;
    for (std::uint64_t i = 0; i < *vertices; ++i) {
        if (!lines.next_with_words())
            lines.fail_at_end(fmt::format("the file ends after {} of {} vertices", i, *vertices));
        if (lines.size() < 3) lines.fail_at(lines.size(), "a vertex is a line x y z");
        add_site(result, lines, {0, 1, 2, no_word});
    }
    if (result.in_space.empty()) lines.fail_at_end("no vertex in this file");
    return result;
}

SitesFile read_ply_sites(InputFile& file) {
    return PlySites(file).read();
}

}  // namespace signum
