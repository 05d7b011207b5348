#pragma once
/// A contestant of the triangulation benchmark: something that builds a triangulation of given
/// sites.

#include <cstdint>
#include <functional>
#include <memory>

namespace signum::benchmarks {

/// What was built. The triangulation lives as long as this, so that its end is not timed.
struct Built {
    std::int64_t visible = 0;
    std::shared_ptr<void> triangulation;
};

/// Builds the triangulation of the sites that it was made for, from scratch.
using Construction = std::function<Built()>;

}  // namespace signum::benchmarks
