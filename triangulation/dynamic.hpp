#pragma once
/// A tessellation that changes: sites come, go and grow, and at any time it is the canonical one of
/// the sites that are there.

#include <cstddef>
#include <memory>

#include "../core/index.hpp"
#include "../core/site.hpp"
#include "tessellation.hpp"

namespace signum {

/// Laws:
///  1. tessellation() depends on the sites alone, not on how they came together: it is
///     triangulate() of the live sites in the order of their handles.
///  2. A handle names its site until that is erased; afterwards it may be given to another one.
///  3. What a site hid reappears when it goes, or shrinks.
class DynamicTessellation {
 public:
    /// Weights instead of radii exist in the power metric alone (std::invalid_argument).
    explicit DynamicTessellation(Metric metric, WeightIs weight_is = WeightIs::radius);
    DynamicTessellation(DynamicTessellation&&) noexcept;
    DynamicTessellation& operator=(DynamicTessellation&&) noexcept;
    ~DynamicTessellation();

    /// Adds a site and gives its handle, the least that is free. Throws std::invalid_argument
    /// unless its numbers are finite. Expected O(√n) for sites in no order, and less near the last
    /// change.
    Index insert(const Site& site);
    /// Takes a site away. Precondition: contains(handle). O(degree²) and the sites it hid, each as
    /// an insertion.
    void erase(Index handle);
    /// Gives a site another radius (or weight), and keeps its handle. As erase and insert.
    void change(Index handle, double third);

    [[nodiscard]] bool contains(Index handle) const noexcept;
    [[nodiscard]] std::size_t size() const noexcept;
    /// Precondition: contains(handle).
    [[nodiscard]] Site site(Index handle) const noexcept;

    /// The result of the live sites, numbered from 0 in the order of their handles. O(n log n).
    [[nodiscard]] Tessellation tessellation() const;

    /// How often all had to be built anew: for growth of the memory, and where what is left has no
    /// structure to change (all on one line in the power metric, two visible sites).
    [[nodiscard]] std::size_t rebuilds() const noexcept;

 private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace signum
