#pragma once
/// What balls strike that is no ball and no side of the box. An obstacle has no mass: strikes leave
/// it as it is.

#include <string_view>
#include <variant>

#include "field.hpp"
#include "vector.hpp"

namespace signum::motion {

/// Balls are where n·x >= offset + speed · t: an oblique wall, at rest or in uniform motion. n need
/// not be a unit vector. F = n·x - offset - speed · t - |n| (r + q t).
template <int D>
struct HalfSpace {
    Vector<D> normal{};   ///< not 0
    double offset = 0.0;  ///< of the wall at t = 0, times |n|
    double speed = 0.0;   ///< of the wall along n, times |n|

    static constexpr std::string_view kind = "half-space";  ///< as files have it
    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&HalfSpace::normal, {"normal"});
        visit(&HalfSpace::offset, {"offset", dimensions::length});
        visit(&HalfSpace::speed, {"speed", dimensions::speed});
    }
};

/// A circle or sphere with its centre at centre + velocity · t. D is the difference of the centres.
template <int D>
struct Sphere {
    /// On which side of it balls are.
    enum class Side {
        outside,  ///< it is a pillar
        inside    ///< it is a drum
    };
    Vector<D> centre{};    ///< at t = 0
    Vector<D> velocity{};  ///< for ever
    double radius = 0.0;   ///< above 0
    /// Where the balls are: F = |D|² - (radius + r + q t)² outside, (radius - r - q t)² - |D|²
    /// inside.
    Side side = Side::outside;

    static constexpr std::string_view kind = "sphere";  ///< as files have it
    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Sphere::side, {"side"});
        visit(&Sphere::radius, {.name = "radius",
                                .dimension = dimensions::length,
                                .range = from_0,
                                .written = above_0});
        visit(&Sphere::centre, {"centre", dimensions::length});
        visit(&Sphere::velocity, {"velocity", dimensions::speed});
    }
};

/// A thin wall at rest in the plane, struck from both sides and at its ends. A polyline is its
/// segments. Balls have a radius above 0 then: a point that is rounded onto a segment, or behind
/// it, would not know its side. F = d² - (r + q t)², d the distance of the centre from the nearest
/// point of it.
struct Segment {
    Vector<2> from{};  ///< one end
    Vector<2> to{};    ///< the other one, another point

    static constexpr std::string_view kind = "segment";  ///< as files have it
    /// Describes the members.
    static constexpr void each_field(const auto& visit) {
        visit(&Segment::from, {"from", dimensions::length});
        visit(&Segment::to, {"to", dimensions::length});
    }
};

/// Which kinds of obstacles there are.
template <int D>
struct ObstacleOf {
    using type = std::variant<HalfSpace<3>, Sphere<3>>;  ///< in space
};
/// In the plane segments, too.
template <>
struct ObstacleOf<2> {
    using type = std::variant<HalfSpace<2>, Sphere<2>, Segment>;  ///< in the plane
};
/// An obstacle of any kind.
template <int D>
using Obstacle = typename ObstacleOf<D>::type;

/// Whether an obstacle of some kind moves.
template <int D>
[[nodiscard]] bool is_moving(const HalfSpace<D>& wall) noexcept {
    return wall.speed != 0.0;
}
/// The same.
template <int D>
[[nodiscard]] bool is_moving(const Sphere<D>& wall) noexcept {
    return wall.velocity != Vector<D>{};
}
/// The same.
[[nodiscard]] inline bool is_moving(const Segment&) noexcept {
    return false;
}
/// The same.
template <class... Kinds>
[[nodiscard]] bool is_moving(const std::variant<Kinds...>& obstacle) noexcept {
    return std::visit([](const auto& each) { return is_moving(each); }, obstacle);
}

}  // namespace signum::motion
