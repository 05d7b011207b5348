#pragma once
/// A sphere that touches three balls, roughly, and what certainly conflicts with it. For sources
/// only.

#include <cmath>

#include "../../predicates/space/ccw.hpp"
#include "../vector3.hpp"

namespace signum::balls {

/// A sphere that touches three balls, roughly: where the greatest distance along their curve is
/// least. Seen from the first ball it is the direction u with f_b(u) = f_c(u) (cell.hpp).
///
/// The bounds. Where P is more than a part of 2^-10 of what it is the difference of, a and b err by
/// a part of 2^-40; where the difference N of the two a is no smaller than a part of 2^-8 of them,
/// the circle's radius no smaller than 2^-5, and the part of a across N one of 2^-10 of it, u is
/// off by less than 2^-18 from a direction of the curve. What is more by 2^-14 is certainly more.
class RoughSphere {
 public:
    RoughSphere(const Site3& i, const Site3& j, const Site3& k) : first_(i) {
        Function b, c;
        if (!function(j, b) || !function(k, c)) return;
        const Point3 n = minus(b.a, c.a);
        const double square = dot(n, n);
        const double difference = b.b - c.b, lengths = b.length + c.length;
        if (!(square > 0x1p-16 * lengths * lengths)) return;
        const double radius = 1.0 - difference * difference / square;
        const Point3 across = plus(b.a, n, -dot(n, b.a) / square);
        const double rest = dot(across, across);
        if (!(radius > 0x1p-10) || !(rest > 0x1p-20 * b.length * b.length)) return;
        u_ = plus(times(across, std::sqrt(radius / rest)), n, -difference / square);
        value_ = at(b);
        length_ = b.length;
        is_known_ = value_ > 0x1p-14 * length_;
    }
    [[nodiscard]] bool certainly_conflicts(const Site3& q) const {
        Function f;
        return is_known_ && function(q, f) &&
               at(f) > value_ + 0x1p-14 * (length_ + f.length + std::fabs(f.b));
    }

 private:
    struct Function {
        Point3 a;
        double b, length;
    };
    [[nodiscard]] bool function(const Site3& j, Function& f) const {
        const Point3 x = minus(centre3(j), centre3(first_));
        const double r = j.r - first_.r, square = dot(x, x);
        const double p = square - r * r;
        if (!(p > 0x1p-10 * (square + r * r) && p > 0x1p-200 && p < 0x1p200)) return false;
        f = {{2.0 * x.x / p, 2.0 * x.y / p, 2.0 * x.z / p},
             2.0 * r / p,
             2.0 * std::sqrt(square) / p};
        return true;
    }
    [[nodiscard]] double at(const Function& f) const { return dot(f.a, u_) + f.b; }

    Site3 first_;
    Point3 u_;
    double value_ = 0.0;
    double length_ = 0.0;
    bool is_known_ = false;
};

}  // namespace signum::balls
