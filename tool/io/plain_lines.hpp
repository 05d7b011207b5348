#pragma once
/// Lines of numbers and nothing else, read by all threads: what most files of sites hold.
///
/// Law: a line that is plain is read here as text_columns.hpp and its readers would read it. Any
/// other line is left to them: they know comments, quotes and headers, and what to say of mistakes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace signum {

/// What a line has to be.
struct PlainLayout {
    /// The columns of a site's numbers; the last one, a radius, may be missing.
    std::array<std::size_t, 4> places;
    std::size_t coordinates;    ///< how many of the places these are
    std::size_t least;          ///< columns in a line
    std::size_t most;           ///< columns in a line
    char separator;             ///< the only one; 0: blanks, or one tab, comma or semicolon
    bool has_radius;            ///< whether each line has to have one
    bool may_be_negative;       ///< the radius
    bool may_be_beyond_single;  ///< any number (number.hpp)
};

/// The first lines of a text.
struct PlainLines {
    std::vector<std::array<double, 4>> sites;  ///< as many numbers as coordinates, and the radius
    std::size_t bytes = 0;
    std::int64_t lines = 0;
    bool has_radii = false;  ///< whether a line has
};

/// Reads whole lines from the start of a text as far as they are plain. Empty lines are not.
[[nodiscard]] PlainLines read_plain_lines(std::string_view text, const PlainLayout& layout);

}  // namespace signum
