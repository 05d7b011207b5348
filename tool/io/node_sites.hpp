#pragma once
/// Sites from the .node files of Triangle, which lie in the plane, and of TetGen, in space.
///
/// Laws: as of read_sites().

#include "input_file.hpp"
#include "read_sites.hpp"

namespace signum {

/// The number of points, their dimension, the numbers of attributes and of boundary markers, then a
/// line each: number x y [z] attributes marker. Numbers count from 0 or from 1, as the first one
/// says. What is an attribute and what a radius the file does not say: attributes and markers are
/// left out, and the note says so, unless options.columns choose one of the columns, numbered from
/// 1, for the radius, or options.attributes asks for all. Throws InputError.
[[nodiscard]] SitesFile read_node_sites(InputFile& file, const ReadOptions& options);

}  // namespace signum
