#pragma once
/// Points of space as vectors. For sources only.

#include <cmath>

#include "../core/site.hpp"

namespace signum {

[[nodiscard]] inline double dot(const Point3& a, const Point3& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Point3 cross(const Point3& a, const Point3& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Point3 plus(const Point3& a, const Point3& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
[[nodiscard]] inline Point3 minus(const Point3& a, const Point3& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
[[nodiscard]] inline Point3 times(const Point3& a, double factor) noexcept {
    return {a.x * factor, a.y * factor, a.z * factor};
}
/// a + times b.
[[nodiscard]] inline Point3 plus(const Point3& a, const Point3& b, double times) noexcept {
    return {a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}
[[nodiscard]] inline double length(const Point3& a) noexcept {
    return std::sqrt(dot(a, a));
}

/// The coordinates, as 0, 1 and 2.
inline constexpr double Point3::*const axes_of_space[3] = {&Point3::x, &Point3::y, &Point3::z};

}  // namespace signum
