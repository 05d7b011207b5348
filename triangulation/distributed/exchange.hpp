#pragma once
/// What parts of a tessellation ask of one another, whoever carries the questions: threads that
/// share memory, ranks that send messages, files that are read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../core/box_tree.hpp"
#include "../../core/site.hpp"

namespace signum::distributed {

/// A site, and its number in the whole.
struct Placed {
    Site site;
    std::int64_t id;
};

/// Instead of a site.
[[nodiscard]] constexpr Placed at_infinity() noexcept {
    return {{0.0, 0.0, 0.0}, -1};
}

/// An edge: its sites, and those of the faces on its left and right, perhaps at infinity.
using EdgeQuestion = std::array<Placed, 4>;

/// Of the centres and third numbers of sites. Of none, low is above high.
using Extent = Bounds<3>;

[[nodiscard]] constexpr Extent no_extent() noexcept {
    constexpr double far = __builtin_huge_val();
    return {{far, far, far}, {-far, -far, -far}};
}
[[nodiscard]] inline bool is_empty(const Extent& extent) noexcept {
    return !(extent.low[0] <= extent.high[0]);
}

/// Whether they have a place in common; third numbers do not matter.
[[nodiscard]] inline bool meet(const Extent& a, const Extent& b) noexcept {
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] &&
           b.low[1] <= a.high[1];
}

/// What one part asks another, of which all sites are meant that it owns.
struct Questions {
    /// Which have their centres in one of these? Third numbers do not matter.
    std::vector<Extent> boxes;
    /// Which of those that conflict with the face of these three are nearest to its vertex?
    std::vector<std::array<Placed, 3>> faces;
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
