#pragma once
/// Pieces of the sphere of directions. For sources only.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../vector3.hpp"

namespace signum::balls {

/// The directions through a rectangle on a face of the cube: a convex piece of the unit sphere. So
/// the farthest of them from the one through the rectangle's middle are corners.
///
/// Where all centres are on one line, whose direction is the unit vector e, all a are multiples of
/// e, and f depends on s = u·e alone. There a patch are all u of which this lies in an interval,
/// v is s e for its middle s, and δ is half its length: |a·(u - v)| <= |a| δ, which is all that is
/// asked of them.
struct Patch {
    int face;
    double s, t, half;  // the middle of the rectangle, and half its side
    Point3 v;
    double delta;
    const Point3* line = nullptr;  // e

    Patch(int of_face, double middle_s, double middle_t, double half_side)
        : face(of_face), s(middle_s), t(middle_t), half(half_side), v(direction(s, t)), delta(0.0) {
        double square = 0.0;
        for (const double ds : {-half, half}) {
            for (const double dt : {-half, half}) {
                const Point3 off = minus(direction(s + ds, t + dt), v);
                square = std::max(square, dot(off, off));
            }
        }
        delta = std::sqrt(square) * (1.0 + 0x1p-48) + 0x1p-48;
    }
    Patch(const Point3& of_line, double middle, double half_length)
        : face(0),
          s(middle),
          t(0.0),
          half(half_length),
          v(times(of_line, middle)),
          delta(half + 0x1p-47),
          line(&of_line) {}
    [[nodiscard]] Patch quarter(int number) const {
        if (line != nullptr) return {*line, s + half * (0.5 * number - 0.75), 0.25 * half};
        const double h = 0.5 * half;
        return {face, s + ((number & 1) != 0 ? h : -h), t + ((number & 2) != 0 ? h : -h), h};
    }

 private:
    [[nodiscard]] Point3 direction(double at_s, double at_t) const {
        const double length = 1.0 / std::sqrt(1.0 + at_s * at_s + at_t * at_t);
        const auto axis = static_cast<std::size_t>(face % 3);
        Point3 result;
        result.*axes_of_space[axis] = face < 3 ? length : -length;
        result.*axes_of_space[(axis + 1) % 3] = at_s * length;
        result.*axes_of_space[(axis + 2) % 3] = at_t * length;
        return result;
    }
};

}  // namespace signum::balls
