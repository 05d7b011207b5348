#pragma once
/// Bands and charts of directions, and balls in them to a hundred bits: for the search of
/// cell.hpp where many balls are the greatest together, or nearly so. For sources only.
///
/// Where centres are nearly on a line or on a circle, or on a line with radii that fit, the
/// functions f = a·u + b (cell.hpp) have their (a, b) nearly on a line of R⁴, of the direction
/// (d, δ). Then all are nearly equal along the circle u·d = -δ, and hardly change along it. Squares
/// that tell them apart across the circle are far too small along it: there were 10^5 of them. A
/// Band is divided about the axis e = d / |d|: with a frame e, p, q the directions
///     u = s e + r (cos φ p + sin φ q),   r = √(1 - s²),
/// have s and φ in intervals, each of which is halved by itself.
///
/// Where centres are nearly in a plane or on a sphere, all f are nearly equal in one direction
/// alone. Squares around that one do, but doubles do not tell the f apart there. A Chart has
///     u = (e + s p + t q) / l,   l = |e + s p + t q|,
/// with s and t in intervals: there l f = a·e + s a·p + t a·q + l b is linear but for the last
/// term.
///
/// Laws:
///  1. halves of an interval cover it, and a region covers the directions that it is made around:
///     middles are doubles, exactly, or an interval has no halves; in φ `across` pays;
///  2. in a region f, in a chart l f, differs from the value in the middle by change(a·e, a·p, a·q,
///     b) at most, but for the value's error; and so do differences of such functions.
///
/// The frame is rounded, and what stands before e, p and q are the coefficients of u in it: so a·u
/// is exactly the sum of these times a·e, a·p and a·q. Of a frame that is orthonormal within 2^-48
/// the coefficients' squares sum to 1 within 2^-47. So r is in an interval, which `across`
/// contains, the greatest change of r cos φ and r sin φ together; and l, whose square is a
/// polynomial in s and t of the frame's products, changes by at most |s| + 2^-45 of what s does.
///
/// The numbers are double-doubles, whose operations err by 2^-102. X and R are exact, P errs by
/// 2^-98 k P with k = (X·X + R²) / P, a quotient by 2^-98 of itself, sums of four products by
/// 2^-99 (|a| + |b|) three times over: together less than 2^-94 (1 + k) (|a| + |b|), of which
/// `error` is sixteen times as much. It pays for differences of the low parts, too. Underflow loses
/// nothing beside that: |X| + |R| is at most 2^3 and at least 2^-400, so that |a| > 2^-3.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "../../core/site.hpp"
#include "../../filters/double_double.hpp"
#include "../vector3.hpp"

namespace signum::balls {

using filters::DoubleDouble;

/// f = a·u + b of a ball, by the coefficients of a.
struct FineForm {
    DoubleDouble x, y, z, b;
    double error;
};

/// As seen from ball i; nothing outside the window, or where P is not certain.
[[nodiscard]] inline std::optional<FineForm> fine_form(const Site3& i, const Site3& j) {
    const DoubleDouble x = filters::exact_difference(j.x, i.x);
    const DoubleDouble y = filters::exact_difference(j.y, i.y);
    const DoubleDouble z = filters::exact_difference(j.z, i.z);
    const DoubleDouble r = filters::exact_difference(j.r, i.r);
    const DoubleDouble square = x * x + y * y + z * z;
    const DoubleDouble square_of_r = r * r;
    const double both = square.high + square_of_r.high;
    const DoubleDouble p = square - square_of_r;
    if (!(both > 0x1p-800 && both < 0x1p5 && p.high > 0x1p-40 * both)) return {};
    const auto over_p = [&p](const DoubleDouble& number) -> DoubleDouble {
        const double quotient = 2.0 * number.high / p.high;
        const DoubleDouble rest = 2.0 * number - quotient * p;
        const TwoTerms sum = quick_two_sum(quotient, rest.high / p.high);
        return {sum.high, sum.low};
    };
    FineForm f{over_p(x), over_p(y), over_p(z), over_p(r), 0.0};
    const double size =
        std::fabs(f.x.high) + std::fabs(f.y.high) + std::fabs(f.z.high) + std::fabs(f.b.high);
    f.error = 0x1p-90 * (1.0 + both / p.high) * size + 0x1p-1000;
    return f;
}

/// Three directions, orthonormal within 2^-48.
struct Frame {
    Point3 e, p, q;
    std::array<DoubleDouble, 6> products;  // e·e, e·p, e·q, p·p, p·q, q·q

    /// About an axis; q is orthogonal to `other`, too, if that is not nearly parallel to it. Both
    /// are of any length but 0.
    Frame(const Point3& axis, const Point3& other) : e(unit(axis)), p(), q(cross(e, unit(other))) {
        if (!(dot(q, q) > 0x1p-4)) {
            double Point3::*least = &Point3::x;
            for (const auto each : axes_of_space)
                if (std::fabs(e.*each) < std::fabs(e.*least)) least = each;
            Point3 apart;
            apart.*least = 1.0;
            q = cross(e, apart);
        }
        q = unit(q);
        p = unit(cross(q, e));
        const auto product = [](const Point3& a, const Point3& b) {
            const auto term = [](double s, double t) {
                return DoubleDouble{s, 0.0} * DoubleDouble{t, 0.0};
            };
            return term(a.x, b.x) + term(a.y, b.y) + term(a.z, b.z);
        };
        products = {product(e, e), product(e, p), product(e, q),
                    product(p, p), product(p, q), product(q, q)};
    }

    /// The coefficients of a form, in place of those along the axes.
    [[nodiscard]] FineForm of(const FineForm& f) const {
        const auto along = [&f](const Point3& d) { return d.x * f.x + d.y * f.y + d.z * f.z; };
        return {along(e), along(p), along(q), f.b, f.error};
    }

 private:
    [[nodiscard]] static Point3 unit(const Point3& v) {
        const double length = std::hypot(v.x, v.y, v.z);
        return {v.x / length, v.y / length, v.z / length};
    }
};

/// How far forms may differ in each coefficient: in those of p and q together, too.
struct Spread {
    double x = 0.0, y = 0.0, z = 0.0, yz = 0.0, b = 0.0;

    void take(double of_x, double of_y, double of_z, double of_b) {
        x = std::fmax(x, std::fabs(of_x));
        y = std::fmax(y, std::fabs(of_y));
        z = std::fmax(z, std::fabs(of_z));
        yz = std::fmax(yz, std::sqrt(of_y * of_y + of_z * of_z));
        b = std::fmax(b, std::fabs(of_b));
    }
};
/// A change of forms: what halves of the one interval halve, those of the other, and what none do.
struct Change {
    double in_first, in_second, rest;
};

/// The directions with s and φ in intervals. The first interval is that of s.
class Band {
 public:
    /// Around all unit vectors that differ from v by delta at most, in length.
    Band(const Point3& v, double delta, const Frame& frame) : Band(0.0, 0.0, 0.0, 0.0) {
        const double reach = delta + 0x1p-44;
        // Of few bits, so that many halves of it are exact.
        const double middle = 0x1p-20 * std::nearbyint(0x1p20 * dot(v, frame.e));
        double half = 0x1p-20;
        while (half < reach + 0x1p-20) half *= 2.0;
        const double along_p = dot(v, frame.p), along_q = dot(v, frame.q);
        const double r = std::hypot(along_p, along_q);
        if (r > 1.25 * reach)
            *this =
                Band(middle, half, std::atan2(along_q, along_p), std::asin(reach / r) + 0x1p-44);
        else
            *this = Band(middle, half, 0.0, std::numbers::pi + 0x1p-40);
    }

    /// f in the middle.
    [[nodiscard]] DoubleDouble value(const FineForm& f) const {
        return (s_ * f.x + f.b) + (y_ * f.y + z_ * f.z);
    }
    /// How much a form with these coefficients may change from the middle on.
    [[nodiscard]] double change(double x, double y, double z, double /*b*/) const {
        return half_s_ * std::fabs(x) + across_ * std::sqrt(y * y + z * z);
    }
    [[nodiscard]] Change parts_of_change(const Spread& spread) const {
        return {half_s_ * spread.x + (across_ - along_phi_ - least_across_) * spread.yz,
                along_phi_ * spread.yz, least_across_ * spread.yz};
    }
    /// By how much it is about greater at the upper end of each interval.
    [[nodiscard]] std::array<double, 2> rise(double x, double y, double z, double /*b*/) const {
        return {half_s_ * x, half_phi_ * (y_ * z - z_ * y)};
    }

    [[nodiscard]] bool has_halves(int interval) const {
        return interval == 0 ? has_exact_halves(s_, half_s_) : half_phi_ > 0x1p-46;
    }
    [[nodiscard]] Band half(int interval, int number) const {
        const double sign = number == 0 ? -0.5 : 0.5;
        return interval == 0 ? Band(s_ + sign * half_s_, 0.5 * half_s_, phi_, half_phi_)
                             : Band(s_, half_s_, phi_ + sign * half_phi_, 0.5 * half_phi_);
    }

    /// Whether the middles of both halves of an interval are doubles.
    [[nodiscard]] static bool has_exact_halves(double middle, double half) {
        const double h = 0.5 * half;
        return (middle + h) - middle == h && (middle - h) - middle == -h;
    }

 private:
    Band(double s, double half_s, double phi, double half_phi)
        : s_(s), half_s_(half_s), phi_(phi), half_phi_(half_phi) {
        const auto rest = [](double x, double slack) {
            return std::sqrt(std::fmax(0.0, (1.0 - x * x) + slack));
        };
        const double far = std::fabs(s) + half_s, near = std::fmax(0.0, std::fabs(s) - half_s);
        const double r = rest(s, 0.0);
        y_ = r * std::cos(phi);
        z_ = r * std::sin(phi);
        along_phi_ = r * half_phi;
        const auto across = [&](double nearest, double farthest) {
            return std::fmax(rest(nearest, 0x1p-47) - r, r - rest(farthest, -0x1p-47)) + 0x1p-46;
        };
        across_ = along_phi_ + across(near, far);
        least_across_ = across(std::fabs(s), std::fabs(s));
    }

    double s_, half_s_, phi_, half_phi_;
    double y_, z_;      // r cos φ and r sin φ of the middle
    double along_phi_;  // the part of `across` that φ has
    double across_;
    double least_across_;  // what no halves take of it
};

/// The directions of e + s p + t q with s and t in intervals, near e.
class Chart {
 public:
    /// Around all unit vectors that differ from v by delta at most, in length. Precondition: so
    /// does v itself from e, but for rounding, and delta < 1/8.
    Chart(const Point3& /*v*/, double delta, const Frame& frame)
        : frame_(&frame), s_(0.0), half_s_(0x1p-2), t_(0.0), half_t_(0.0) {
        while (0.5 * half_s_ > 1.25 * (delta + 0x1p-44)) half_s_ *= 0.5;
        half_t_ = half_s_;
        find_length();
    }

    /// Of f, times the length of the middle.
    [[nodiscard]] DoubleDouble value(const FineForm& f) const {
        return (f.x + length_ * f.b) + (s_ * f.y + t_ * f.z);
    }
    [[nodiscard]] double change(double /*x*/, double y, double z, double b) const {
        return half_s_ * std::fabs(y) + half_t_ * std::fabs(z) +
               (of_length_in_s_ + of_length_in_t_ + least_of_length) * std::fabs(b);
    }
    [[nodiscard]] Change parts_of_change(const Spread& spread) const {
        return {half_s_ * spread.y + of_length_in_s_ * spread.b,
                half_t_ * spread.z + of_length_in_t_ * spread.b, least_of_length * spread.b};
    }
    [[nodiscard]] std::array<double, 2> rise(double /*x*/, double y, double z, double b) const {
        return {half_s_ * (y + s_ * b), half_t_ * (z + t_ * b)};
    }

    [[nodiscard]] bool has_halves(int interval) const {
        return interval == 0 ? Band::has_exact_halves(s_, half_s_)
                             : Band::has_exact_halves(t_, half_t_);
    }
    [[nodiscard]] Chart half(int interval, int number) const {
        const double sign = number == 0 ? -0.5 : 0.5;
        Chart result = *this;
        double& middle = interval == 0 ? result.s_ : result.t_;
        double& half = interval == 0 ? result.half_s_ : result.half_t_;
        middle += sign * half;
        half *= 0.5;
        result.find_length();
        return result;
    }

 private:
    /// What rounding makes of a length.
    static constexpr double least_of_length = 0x1p-92;

    void find_length() {
        const auto& g = frame_->products;
        const DoubleDouble square = (g[0] + s_ * (2.0 * g[1] + s_ * g[3])) +
                                    t_ * ((2.0 * g[2] + t_ * g[5]) + 2.0 * s_ * g[4]);
        const double root = std::sqrt(square.high);
        const DoubleDouble rest = square - DoubleDouble{root, 0.0} * DoubleDouble{root, 0.0};
        const TwoTerms sum = quick_two_sum(root, 0.5 * rest.high / root);
        length_ = {sum.high, sum.low};
        // Its slope is the coefficient, but for what the frame is not orthonormal by.
        of_length_in_s_ = half_s_ * (std::fabs(s_) + half_s_ + 0x1p-44);
        of_length_in_t_ = half_t_ * (std::fabs(t_) + half_t_ + 0x1p-44);
    }

    const Frame* frame_;
    double s_, half_s_, t_, half_t_;
    DoubleDouble length_{};                               // of the middle
    double of_length_in_s_ = 0.0, of_length_in_t_ = 0.0;  // how much it may change
};

}  // namespace signum::balls
