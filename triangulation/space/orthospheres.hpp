#pragma once
/// The spheres of cells, rounded to floats: whether a site conflicts with a cell is told by them
/// nearly always, without looking at a single vertex.
///
/// Everything is in a frame. What the lemma says of p and v is asked of sites that lie within 1 of
/// the frame's origin along each axis and weigh W at most: of others nothing is told, and no sphere
/// is made (is_in). The
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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "cells.hpp"
#include "view.hpp"

namespace signum::spatial {

/// The bits of four floats, centre and power: kept as what a cell has four of, so that the memory
/// can become the result's.
using Orthosphere = Four;

namespace orthospheres {
using Floats = float __attribute__((vector_size(16)));
using Flags = std::int32_t __attribute__((vector_size(16)));

inline constexpr std::int32_t unknown = 0x7FC0'0000;
inline constexpr std::int32_t taken = 0x7FC0'0001;

/// Of what Cramer's rule may come to for the planes 2 m·p = lift, relative to the site, six
/// products: with the largest offset L and height H 6 L³ and 6 H L². One more e than there are
/// roundings (counted in orthospheres.cpp) pays for the terms in e², another one for those of the
/// errors themselves.
inline constexpr double determinant_error = 6 * 10 * filters::epsilon;
inline constexpr double numerator_error = 6 * 16 * filters::epsilon;
}  // namespace orthospheres

/// One that tells nothing, and that of a cell that is known to be in conflict. Their powers are two
/// NaNs, neither of which is what an operation makes.
inline constexpr Orthosphere unknown_sphere = {0, 0, 0, orthospheres::unknown};
inline constexpr Orthosphere taken_sphere = {0, 0, 0, orthospheres::taken};

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

/// Whether the lemma holds of a site in the frame: those that the frame was made of are in it.
[[nodiscard]] inline bool is_in(const Frame& frame, const std::array<double, 4>& site) noexcept {
    const double farthest =
        std::max(std::max(std::fabs(site[0]), std::fabs(site[1])), std::fabs(site[2]));
    return farthest <= 1.0 && static_cast<float>(std::fabs(site[3])) <= frame.largest_weight;
}

/// Whether a site conflicts with cells, as far as their spheres tell.
enum class Told : std::int32_t { nothing = 0, conflict = 1, none = 2, taken = 4 };
class SphereTest {
 public:
    SphereTest(const std::array<double, 4>& site, const Frame& frame) noexcept
        : x_(static_cast<float>(site[0])),
          y_(static_cast<float>(site[1])),
          z_(static_cast<float>(site[2])),
          weight_(static_cast<float>(site[3])),
          largest_weight_(frame.largest_weight) {}
    /// Of four at once. Whether it is told of all.
    [[gnu::always_inline]] bool operator()(const Orthosphere& a, const Orthosphere& b,
                                           const Orthosphere& c, const Orthosphere& d,
                                           std::array<Told, 4>& told) const noexcept {
        Judged judged;
        judge(judged, a, b, c, d);
        std::memcpy(told.data(), &judged.told, sizeof told);
        return is_zero(judged.told == 0);
    }
    /// How far four cells are from being in conflict: |g| as bits that compare as it does, and a
    /// negative number where a conflict is told. The last two bits are the place of the cell; of
    /// spheres that are unknown the number is the greatest.
    [[gnu::always_inline]] void distances(const Orthosphere& a, const Orthosphere& b,
                                          const Orthosphere& c, const Orthosphere& d,
                                          std::array<std::int32_t, 4>& numbers) const noexcept {
        Judged judged;
        judge(judged, a, b, c, d);
        constexpr Flags places = {0, 1, 2, 3};
        const Flags is_conflict = (judged.told & 1) != 0;
        const Flags result = (~is_conflict & (Flags)judged.difference & 0x7FFF'FFFC) |
                             (is_conflict & std::numeric_limits<std::int32_t>::min()) | places;
        std::memcpy(numbers.data(), &result, sizeof numbers);
    }

 private:
    using Floats = orthospheres::Floats;
    using Flags = orthospheres::Flags;

    struct Judged {
        Floats difference;
        Flags told;
    };
    [[gnu::always_inline]] static bool is_zero(const Flags& flags) noexcept {
        std::array<std::uint64_t, 2> halves;
        std::memcpy(halves.data(), &flags, sizeof halves);
        return (halves[0] | halves[1]) == 0;
    }
    [[gnu::always_inline]] static Floats load(const Orthosphere& sphere) noexcept {
        Floats floats;
        std::memcpy(&floats, sphere.data(), sizeof floats);
        return floats;
    }
    [[gnu::always_inline]] void judge(Judged& judged, const Orthosphere& of_a,
                                      const Orthosphere& of_b, const Orthosphere& of_c,
                                      const Orthosphere& of_d) const noexcept {
        const Floats a = load(of_a);
        const Floats b = load(of_b);
        const Floats c = load(of_c);
        const Floats d = load(of_d);
        const Floats ab_first = __builtin_shufflevector(a, b, 0, 4, 1, 5);
        const Floats cd_first = __builtin_shufflevector(c, d, 0, 4, 1, 5);
        const Floats ab_last = __builtin_shufflevector(a, b, 2, 6, 3, 7);
        const Floats cd_last = __builtin_shufflevector(c, d, 2, 6, 3, 7);
        const Floats x = x_ - __builtin_shufflevector(ab_first, cd_first, 0, 1, 4, 5);
        const Floats y = y_ - __builtin_shufflevector(ab_first, cd_first, 2, 3, 6, 7);
        const Floats z = z_ - __builtin_shufflevector(ab_last, cd_last, 0, 1, 4, 5);
        const Floats power = __builtin_shufflevector(ab_last, cd_last, 2, 3, 6, 7);
        const Floats square = x * x + y * y + z * z;
        judged.difference = (square - weight_) - power;
        const Floats magnitude = (Floats)((Flags)power & 0x7FFF'FFFF);
        const Floats bound = 0x1p-9F * (square + magnitude + largest_weight_);
        const Flags none = judged.difference > bound;
        const Flags conflict = judged.difference < -bound;
        const Flags taken = (Flags)power == orthospheres::taken;
        judged.told = (none & 2) | (conflict & 1) | (taken & 4);
    }

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
    /// Those of the site and facets, three vertices each: that of the i-th goes to
    /// spheres[cells[i]]. Where the lemma's conditions cannot be shown, as with the vertex at
    /// infinity, it is unknown.
    void make(std::span<const Facet> facets, const Index* cells,
              Orthosphere* spheres) const noexcept;

 private:
    struct Wide;

    const ViewRow* rows_;
    std::array<double, 4> site_;
    double scale_;
    double numerator_error_;
    double determinant_error_;
};

}  // namespace signum::spatial
