#pragma once
/// Sites of space beside a box, both divided by the power of two that makes the box's longest side
/// 1 to 2, so that no product goes beyond the doubles; of the three kinds one. What is asked of the
/// sites as they were given is answered exactly.
///
/// Planes that meet: those between a site and others, and sides of the box, by the numbers that
/// SpaceFace::beyond has for them. Where their corner lies doubles say with a bound of their error;
/// where that says too little, rationals. For sources only.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include "../core/error_free.hpp"
#include "../core/index.hpp"
#include "../core/large_array.hpp"
#include "../core/sign.hpp"
#include "../core/site.hpp"
#include "../triangulation/space/triangulate.hpp"
#include "space/cells.hpp"
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

/// Three planes of a site: what lies beyond each.
using ThreePlanes = std::array<Index, 3>;

/// Where planes meet, seen from their site's eye; each coordinate within `error` of the truth,
/// which is far below the distance from there.
struct Corner {
    Point3 place;
    double error;
};

/// A side of the box, 0 to 5 for -1 to -6: what lies outside is below a low side, above a high one.
struct Side {
    int number;
    explicit constexpr Side(int of_box) noexcept : number(of_box) {}
    [[nodiscard]] static constexpr Side named(Index beyond) noexcept {
        return Side(static_cast<int>(-1 - beyond));
    }
    [[nodiscard]] constexpr Index name() const noexcept { return static_cast<Index>(-1 - number); }
    [[nodiscard]] constexpr int axis_number() const noexcept { return number / 2; }
    [[nodiscard]] constexpr double Point3::*axis() const noexcept {
        return axes_of_space[number / 2];
    }
    [[nodiscard]] constexpr bool is_high() const noexcept { return number % 2 != 0; }
    [[nodiscard]] double of(const Box3& box) const noexcept {
        return is_high() ? box.high.*axis() : box.low.*axis();
    }
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

    /// From where the places of a site's cell are seen: its centre, or the point of the box that is
    /// nearest to it, so that places have the digits that the box has.
    [[nodiscard]] Point3 eye(Index i) const noexcept {
        const Point3& p = (*this)[i].centre;
        return {std::clamp(p.x, box_.low.x, box_.high.x), std::clamp(p.y, box_.low.y, box_.high.y),
                std::clamp(p.z, box_.low.z, box_.high.z)};
    }
    /// From eye to eye.
    [[nodiscard]] Point3 between_eyes(Index i, Index j) const noexcept {
        return minus(eye(j), eye(i));
    }
    /// From site i to site j.
    [[nodiscard]] Point3 offset(Index i, Index j) const noexcept {
        return minus((*this)[j].centre, (*this)[i].centre);
    }
    /// That of j minus that of i.
    [[nodiscard]] double weight_difference(Index i, Index j) const noexcept {
        const ScaledSite& a = (*this)[i];
        const ScaledSite& b = (*this)[j];
        // Of large weights the high parts may cancel what the low ones say.
        const TwoTerms high = two_difference(b.weight, a.weight);
        const TwoTerms low = two_difference(b.weight_low, a.weight_low);
        const TwoTerms sum = two_sum(high.high, low.high);
        return sum.high + (sum.low + (high.low + low.low));
    }
    /// The same, of length 1. Precondition: their centres differ.
    [[nodiscard]] Point3 direction(Index i, Index j) const noexcept;

    /// Precondition of all that is told of planes: they meet in one point.
    [[nodiscard]] Corner corner(Index i, const ThreePlanes& planes) const;
    /// Of a corner of which this is known: whether it lies beyond a side of the box, or on it.
    [[nodiscard]] bool is_outside(Index i, const ThreePlanes& planes, const Corner& corner,
                                  Side side) const;
    /// The same for all sides, a bit for each.
    [[nodiscard]] std::uint32_t sides_beyond(Index i, const ThreePlanes& planes,
                                             const Corner& corner) const;

    /// The sign of a coordinate of site j minus that of i.
    [[nodiscard]] Sign sign_of_offset(Index i, Index j, int axis) const;
    /// The sign of a coordinate of the cross product of the ways from i to j and from i to k.
    [[nodiscard]] Sign sign_of_cross(Index i, Index j, Index k, int axis) const;
    /// Whether the middle of the box is nearer to site j than to i.
    [[nodiscard]] bool is_middle_nearer(Index i, Index j) const;

 private:
    struct Rows {
        std::array<Point3, 3> m;
        std::array<double, 3> h;
        double size;  ///< of what was rounded
    };
    /// The centre as it was given.
    [[nodiscard]] Point3 given(Index i) const noexcept;
    [[nodiscard]] Rows rows(Index i, const ThreePlanes& planes) const noexcept;
    [[nodiscard]] Rows shortest_rows(Index i, const ThreePlanes& planes) const noexcept;
    [[nodiscard]] static bool meet(const Rows& rows, Corner& corner) noexcept;
    class Exact;

    AnySites3 given_;
    Box3 given_box_;
    LargeArray<ScaledSite> scaled_;
    Box3 box_;
    int exponent_ = 0;
};

}  // namespace signum
