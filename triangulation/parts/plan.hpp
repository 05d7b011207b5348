#pragma once
/// Sites of the plane, or of space, in parts: a tree of cuts along the axes, made from a sample.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../core/strided_sites.hpp"

namespace signum::triangulation {

/// What is known of the sites of a part, in D dimensions.
template <std::size_t D>
struct Box {
    std::array<double, D> low = filled(HUGE_VAL);  ///< of their centres
    std::array<double, D> high = filled(-HUGE_VAL);
    double greatest = -HUGE_VAL;  ///< third number: a weight w in the power metric, or a radius

    void include(const Box& other) noexcept {
        for (std::size_t axis = 0; axis < D; ++axis) {
            low[axis] = std::min(low[axis], other.low[axis]);
            high[axis] = std::max(high[axis], other.high[axis]);
        }
        greatest = std::max(greatest, other.greatest);
    }

 private:
    [[nodiscard]] static std::array<double, D> filled(double number) noexcept {
        std::array<double, D> all;
        all.fill(number);
        return all;
    }
};

/// A line, or a plane, that cuts a part in two: sites whose coordinate is less lie below it, the
/// others above.
struct Cut {
    std::size_t axis = 0;
    double at = 0.0;
};

/// The parts of a plan are the nodes of a complete binary tree, from the root, 0, to the leaves;
/// those below and above the cut of node k are 2k+1 and 2k+2.
struct Plan {
    int levels = 0;                   ///< of cuts; there are 2^levels leaves
    std::vector<Cut> cuts;            ///< of the nodes that are no leaves
    std::vector<std::size_t> begins;  ///< of each leaf's sites in `numbers`, and the end
    LargeArray<Index> numbers;        ///< of the sites in the input, leaf by leaf
    LargeArray<Index> ranks;          ///< of these along the curve, if asked for

    [[nodiscard]] std::size_t leaves() const noexcept { return std::size_t{1} << levels; }
    [[nodiscard]] std::span<Index> numbers_of(std::size_t leaf) noexcept {
        return std::span(numbers).subspan(begins[leaf], begins[leaf + 1] - begins[leaf]);
    }
};

/// How many levels of cuts give these workers enough to do: several leaves each, for they do not
/// take the same time, and none that is done before others have begun; 0 for one worker.
[[nodiscard]] int levels_for(std::size_t sites, const Workers& workers) noexcept;

/// A plan of that many levels. Leaves hold about as many sites each, unless many lie on a cut, and
/// each of them is in the order of insertion (spatial_order.hpp). O(n log n), by the workers.
/// Precondition: 16 levels at most.
[[nodiscard]] Plan make_plan(const StridedSites& sites, int levels, std::uint64_t seed,
                             const Workers& workers, bool with_ranks);
/// The same of sites of space, whose numbers are given, all different: place(i) is where site i
/// lies, and order(numbers) puts those of a leaf in the order of insertion. Leaves are as even as a
/// larger sample makes them, for of space there are few.
using PlaceInSpace = std::function<std::array<double, 3>(Index)>;
[[nodiscard]] Plan make_plan(std::span<const Index> given, const PlaceInSpace& place,
                             const std::function<void(std::span<Index>)>& order, int levels,
                             std::uint64_t seed, const Workers& workers);

}  // namespace signum::triangulation
