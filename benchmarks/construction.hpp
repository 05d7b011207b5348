#pragma once
/// A contestant of the benchmarks of whole constructions: something that builds a triangulation of
/// given sites, whoever wrote it.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "../triangulation/arrays.hpp"

namespace signum::benchmarks {

/// What was built. The triangulation lives as long as this, so that its end is not timed.
struct Built {
    std::int64_t visible = 0;
    std::shared_ptr<void> triangulation;
    /// For peers of the plane, as long as the construction is there: the faces, in any order,
    /// counterclockwise, those at infinity included; or the finite ones alone, in any orientation.
    /// Neighbours where two sites can share several edges.
    std::function<void(std::vector<Face>& faces, std::vector<Face>& neighbours)> write;
};

/// Builds the triangulation of the sites that it was made for, which it has in types of its own,
/// from scratch.
using Construction = std::function<Built()>;

}  // namespace signum::benchmarks
