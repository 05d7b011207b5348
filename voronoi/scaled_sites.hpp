#pragma once
/// Sites of space beside a box, both divided by the power of two that makes the box's longest side
/// 1 to 2, so that no product goes beyond the doubles; of the three kinds one. What is asked of the
/// sites as they were given is answered exactly. For sources only.

#include <array>
#include <cstddef>
#include <span>
#include <variant>

#include "../core/index.hpp"
#include "../core/large_array.hpp"
#include "../core/site.hpp"
#include "../spatial/triangulate.hpp"
#include "space_cells.hpp"
#include "vector3.hpp"

namespace signum {

using AnySites3 =
    std::variant<std::span<const Point3>, std::span<const Site3>, std::span<const power::Site3>>;

/// A site of any kind. The weight of a radius is its square, as the sum of two doubles.
struct ScaledSite {
    Point3 centre;
    double weight;
    double weight_low;
};

/// The points p at which a.p, a of length 1, is `height`: as near to one site as to another, seen
/// from the former, and turned to the latter.
struct Bisector {
    Point3 normal;
    double height;
    double height_beyond;  ///< the same, seen from the other site
};

class ScaledSites {
 public:
    /// Throws std::invalid_argument as space_cells() does.
    ScaledSites(const AnySites3& sites, const Box3& box);

    [[nodiscard]] std::size_t size() const noexcept { return scaled_.size(); }
    [[nodiscard]] const ScaledSite& operator[](Index i) const noexcept {
        return scaled_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Box3& box() const noexcept { return box_; }
    /// All has been divided by 2^exponent.
    [[nodiscard]] int exponent() const noexcept { return exponent_; }

    /// From site i to site j.
    [[nodiscard]] Point3 offset(Index i, Index j) const noexcept {
        return minus((*this)[j].centre, (*this)[i].centre);
    }
    /// That of j minus that of i.
    [[nodiscard]] double weight_difference(Index i, Index j) const noexcept {
        const ScaledSite& a = (*this)[i];
        const ScaledSite& b = (*this)[j];
        return (b.weight - a.weight) + (b.weight_low - a.weight_low);
    }
    /// Precondition: their centres differ.
    [[nodiscard]] Bisector bisector(Index i, Index j) const noexcept;

    /// The vertex of four sites that are not coplanar, from the first one: each number the double
    /// nearest to the exact one, or 2^1000 in magnitude where that is less.
    [[nodiscard, gnu::cold]] Point3 exact_vertex(const SpaceCell& cell) const;

 private:
    AnySites3 given_;
    LargeArray<ScaledSite> scaled_;
    Box3 box_;
    int exponent_ = 0;
};

}  // namespace signum
