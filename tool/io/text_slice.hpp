#pragma once
/// A slice of a file of plain lines: x y, or x y r, of space x y z, or x y z r, under a header of
/// these names or none, with empty lines and those that begin with #. For who reads more sites than
/// fit.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../../core/site.hpp"
#include "errors.hpp"

namespace signum {

struct TextSlice {
    std::vector<Site3> sites;           ///< in the plane z is 0
    bool has_radii = false;             ///< or weights: whether a line has one number more
    std::int64_t lines = 0;             ///< that begin in the slice
    std::optional<std::int64_t> wrong;  ///< the first of them that is none of the above, from 0
};

/// Slice `number` of so many, by bytes: the lines that begin there. Throws InputError for a file
/// that is none or no regular one, and for a line without end; MachineError.
[[nodiscard]] TextSlice read_text_slice(const std::string& name, int dimension,
                                        std::uint64_t number, std::uint64_t of);

/// What is wrong with a line, where so many are before its slice.
[[nodiscard]] InputError wrong_line(const std::string& name, int dimension,
                                    std::int64_t lines_before, const TextSlice& slice);

}  // namespace signum
