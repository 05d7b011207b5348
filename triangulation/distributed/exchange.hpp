#pragma once
/// What parts of a tessellation ask of one another, whoever carries the questions: threads that
/// share memory, ranks that send messages, files that are read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/site.hpp"
#include "../../core/strided_sites.hpp"
#include "../metric.hpp"

namespace signum::distributed {

/// Which tessellation: of the plane, in any metric, or of space, in the power metric.
struct Kind {
    Metric metric = Power();
    WeightIs weight_is = WeightIs::radius;
    std::size_t dimension = 2;
};

/// A site, and its number in the whole. In the plane z is 0.
struct Placed {
    Placed() = default;  // at infinity
    Placed(const Site& s, std::int64_t number) noexcept : site{s.x, s.y, 0.0, s.r}, id(number) {}
    Placed(const Site3& s, std::int64_t number) noexcept : site(s), id(number) {}

    Site3 site;
    std::int64_t id = -1;
};

[[nodiscard]] inline Site in_plane(const Placed& placed) noexcept {
    return {placed.site.x, placed.site.y, placed.site.r};
}
[[nodiscard]] inline Point3 place_of(const Placed& placed) noexcept {
    return {placed.site.x, placed.site.y, placed.site.z};
}

/// An edge: its sites, and those of the faces on its left and right, perhaps at infinity.
using EdgeQuestion = std::array<Placed, 4>;

/// Of the centres of sites along three axes, and of what weighs them (weight_of() in few.hpp). Of
/// none, low is above high.
using Extent = Bounds<4>;
inline constexpr std::size_t axes = 3;
inline constexpr std::size_t weight_place = 3;

[[nodiscard]] constexpr Extent no_extent() noexcept {
    constexpr double far = __builtin_huge_val();
    return {{far, far, far, far}, {-far, -far, -far, -far}};
}
[[nodiscard]] inline bool is_empty(const Extent& extent) noexcept {
    return !(extent.low[0] <= extent.high[0]);
}

/// Whether they have a place in common; weights do not matter.
[[nodiscard]] inline bool meet(const Extent& a, const Extent& b) noexcept {
    bool result = true;
    for (std::size_t axis = 0; axis < axes; ++axis)
        result = result && a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
    return result;
}

/// A face, or a cell of space, that turns positively, without the vertex at infinity: of the former
/// the first three.
using Corners = std::array<Placed, 4>;

/// What one part asks another, of which all sites are meant that it owns.
struct Questions {
    /// Which have their centres in one of these? Weights do not matter.
    std::vector<Extent> boxes;
    /// Which of those that conflict with this face or cell are nearest to its vertex?
    std::vector<Corners> faces;
    /// Which of those that take the middle of this edge, and neither of its ends?
    std::vector<EdgeQuestion> edges;
    /// Which is nearer to the centre of the first site than the second one, and nearest of all?
    std::vector<std::array<Placed, 2>> hidden;

    [[nodiscard]] bool are_none() const noexcept {
        return boxes.empty() && faces.empty() && edges.empty() && hidden.empty();
    }
};
struct Answers {
    std::vector<Placed> sites;  ///< in boxes, in conflict with faces, and in edges
    /// Of each hidden site; the one that was asked about where none is nearer.
    std::vector<Placed> nearest;
};

/// Laws:
///  1. Where ranks work at the same time, all call ask() equally often, and is_for_any() too.
///  2. A failure anywhere is an exception everywhere.
class Exchange {
 public:
    Exchange() = default;
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;
    virtual ~Exchange() = default;

    /// Questions to each part; the answers of each.
    [[nodiscard]] virtual std::vector<Answers> ask(std::vector<Questions> questions) = 0;
    /// Whether it is true for any of those who work at the same time.
    [[nodiscard]] virtual bool is_for_any(bool own) = 0;
};

}  // namespace signum::distributed
