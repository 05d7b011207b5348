#pragma once
/// The spheres of cells, rounded to floats: whether a site conflicts with a cell is told by them
/// nearly always, without looking at a single vertex.
///
/// Everything is in a frame in which the sites lie within 1 of the origin along each axis. The
/// orthosphere of a cell has the centre C and the power rho = |C-v|² - w_v of all its vertices v; a
/// site p conflicts where f(p) = |p-C|² - w_p - rho < 0. (Without weights, the circumsphere.)
///
/// Lemma: let a cell's floats c and r hold |c-C| <= 2^-12 D and |r - (|c-v|² - w_v)| <=
/// 2^-22 (D² + |w_v|) for one vertex v, D = |c-v| >= 2^-11, and let no weight exceed W in
/// magnitude. Then for any site p the rounded g = |p-c|² - w_p - r has the sign of f(p) wherever
///     |g| > 2^-9 (|p-c|² + |r| + W).
/// Proof: f is linear in C, so with d = |p-c| the centre's error changes it by 2 |p-v| |c-C| at
/// most, with |p-v| <= d + D: 2^-11 (d D + D²). To round p to floats moves it by less than 2^-23 <=
/// 2^-12 D: 2^-11 d D + 2^-24 D². As 2 d D <= d² + D², together 2^-12 (2 d² + 4.01 D²), and D² is
/// at most |r| + W but for a factor 1 + 2^-20: half of the bound. What floats round in g, some
/// 2^-21 of its terms, fits into the other half, in every rounding mode. Where something overflows
/// or is a NaN the comparison fails.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "view.hpp"

namespace signum::spatial {

struct alignas(16) Orthosphere {
    float x;
    float y;
    float z;
    float power;
};
/// One that tells nothing.
inline constexpr Orthosphere unknown_sphere = {0.0F, 0.0F, 0.0F,
                                               std::numeric_limits<float>::quiet_NaN()};

/// The frame of the sites. Where they extend too little or too far every sphere is unknown.
struct Frame {
    Point3 origin;
    double scale = 0.0;  // a power of two; 0 where there is none
    float largest_weight = 0.0F;
};
template <power::PowerSite3 S>
[[nodiscard]] Frame frame_of(std::span<const S> sites) noexcept;

/// The place of a site in the frame, and its weight there.
template <power::PowerSite3 S>
[[nodiscard]] inline std::array<double, 4> in_frame(const S& s, const Frame& frame) noexcept {
    double weight = 0.0;
    if constexpr (requires { s.w; }) weight = (s.w * frame.scale) * frame.scale;
    if constexpr (requires { s.r; }) weight = (s.r * frame.scale) * (s.r * frame.scale);
    return {(s.x - frame.origin.x) * frame.scale, (s.y - frame.origin.y) * frame.scale,
            (s.z - frame.origin.z) * frame.scale, weight};
}

/// Whether a site conflicts with cells, as far as their spheres tell.
enum class Told : std::int32_t { nothing = 0, conflict = 1, none = 2 };
class SphereTest {
 public:
    SphereTest(const std::array<double, 4>& site, const Frame& frame) noexcept
        : x_(static_cast<float>(site[0])),
          y_(static_cast<float>(site[1])),
          z_(static_cast<float>(site[2])),
          weight_(static_cast<float>(site[3])),
          largest_weight_(frame.largest_weight) {}
    /// Of four at once.
    [[gnu::always_inline]] void operator()(const Orthosphere& a, const Orthosphere& b,
                                           const Orthosphere& c, const Orthosphere& d,
                                           std::array<Told, 4>& told) const noexcept {
        const Floats x = x_ - Floats{a.x, b.x, c.x, d.x};
        const Floats y = y_ - Floats{a.y, b.y, c.y, d.y};
        const Floats z = z_ - Floats{a.z, b.z, c.z, d.z};
        const Floats power = {a.power, b.power, c.power, d.power};
        const Floats square = x * x + y * y + z * z;
        const Floats difference = (square - weight_) - power;
        const Floats magnitude = (Floats)((Flags)power & 0x7FFF'FFFF);
        const Floats bound = 0x1p-9F * (square + magnitude + largest_weight_);
        const Flags none = difference > bound;
        const Flags conflict = difference < -bound;
        const Flags result = (none & 2) | (conflict & 1);
        std::memcpy(told.data(), &result, sizeof told);
    }

 private:
    using Floats = float __attribute__((vector_size(16)));
    using Flags = std::int32_t __attribute__((vector_size(16)));
    float x_;
    float y_;
    float z_;
    float weight_;
    float largest_weight_;
};

/// What makes the spheres of new cells, from what a site sees.
class SphereMaker {
 public:
    /// `site`: that which sees, in the frame; largest, height: the largest offset seen and height.
    SphereMaker(const ViewRow* rows, const std::array<double, 4>& site, const Frame& frame,
                double largest, double height) noexcept;
    /// Those of the site and four facets, three vertices each. Where the lemma's conditions cannot
    /// be shown, as with the vertex at infinity, they are unknown.
    void make(const std::array<const std::array<Seen, 3>*, 4>& facets,
              std::array<Orthosphere, 4>& spheres) const noexcept;

 private:
    const ViewRow* rows_;
    std::array<double, 4> site_;
    double scale_;
    double numerator_error_;
    double determinant_error_;
};

}  // namespace signum::spatial
