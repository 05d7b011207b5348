#pragma once
/// Numbers beside the centres of sites, for pictures of few.

#include "frame.hpp"
#include "legend.hpp"
#include "sites.hpp"
#include "style.hpp"
#include "svg_text.hpp"

#include <cstddef>
#include <initializer_list>
#include <span>

namespace signum {

/// Of more sites than that the picture shows no numbers; the pointer tells them.
inline constexpr std::size_t most_numbers = 60;

/// Writes each number where it covers the least of the lines and of other centres, and not at all
/// where it would cover another number: the legend says so. O(sites · lines).
void write_numbers(SvgText& text, Legend& legend, const DrawnSites& sites, const Frame& frame,
                   const Pens& pens, std::initializer_list<std::span<const Conic>> lines);

}  // namespace signum
