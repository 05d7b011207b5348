#pragma once
/// What CGAL's triangulations ask and signum's predicates do not answer as they stand: signs
/// whichever way the points turn, circles that lie in a plane of space; and ties on grids in
/// doubles that do not round.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <signum/core/contract.hpp>
#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/predicates/ccw.hpp>
#include <signum/predicates/power.hpp>
#include <signum/predicates/space.hpp>
#include "points.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::cgal::details {

// ---- ties on grids ------------------------------------------------------------------------------

/// Places relative to one of them that are integers of so few bits, all times one power of two g,
/// that determinants of them are doubles, and every number on the way. On grids, where ties abound,
/// that is as fast as a filter.
template <class S, std::size_t number>
class SmallOffsets {
 public:
    /// From sites[origin]; offsets are below 2^bits g.
    SmallOffsets(const std::array<S, number>& sites, std::size_t origin, int bits) noexcept {
        double largest = 0.0;
        for (std::size_t m = 0; m < number; ++m)
            for (std::size_t k = 0; k < dimension; ++k) {
                offsets_[m][k] = sites[m].*axes[k] - sites[origin].*axes[k];
                largest = std::max(largest, filters::magnitude(offsets_[m][k]));
            }
        // Five factors are far from the ends of the doubles.
        if (!filters::environment_is_default() || !(largest >= 0x1p-80 && largest <= 0x1p80))
            return;
        constexpr std::uint64_t exponent = 0x7FF0'0000'0000'0000;
        const double power =
            std::bit_cast<double>(std::bit_cast<std::uint64_t>(largest) & exponent);
        // 3/2 2^52 g: added to a magnitude below 2^51 g it makes a multiple of g, for there doubles
        // are g apart; above they are farther apart, and magnitudes from 2^53 g on are such
        // multiples themselves. (Of what is below 0 the sum could come to where doubles are g / 2
        // apart.) And the difference of two multiples of g that is rounded to less than 2^53 g is
        // exact.
        const double big =
            power * std::bit_cast<double>(std::uint64_t(1023 + 53 - bits) << 52) * 1.5;
        are_exact_ = true;
        for (std::size_t m = 0; m < number; ++m) {
            for (std::size_t k = 0; k < dimension; ++k) {
                const double distance = filters::opaque(filters::magnitude(sites[m].*axes[k]));
                are_exact_ &= (distance + big) - big == distance;
            }
            // Sites that lie on no grid are told by the first of them.
            if (!are_exact_) return;
        }
    }

    [[nodiscard]] bool are_exact() const noexcept { return are_exact_; }
    [[nodiscard]] double operator()(std::size_t site, std::size_t axis) const noexcept {
        return offsets_[site][axis];
    }
    [[nodiscard]] predicates::Offset3<double> operator[](std::size_t site) const noexcept {
        return {offsets_[site][0], offsets_[site][1], offsets_[site][2]};
    }

 private:
    static constexpr std::size_t dimension = HasCentre3<S> ? 3 : 2;
    static constexpr auto axes = [] {
        if constexpr (dimension == 3)
            return std::array{&S::x, &S::y, &S::z};
        else
            return std::array{&S::x, &S::y};
    }();

    bool are_exact_ = false;
    std::array<std::array<double, dimension>, number> offsets_;
};

template <class S, std::size_t number>
[[nodiscard]] inline bool weigh_the_same(const std::array<S, number>& sites) noexcept {
    return std::ranges::all_of(sites, [&](const S& each) {
        return power::weight_key(each) == power::weight_key(sites[0]);
    });
}

// ---- signs, however the points turn -------------------------------------------------------------
// Of CGAL's points or ours. The filters take them as they lie, and are inlined for that; what is
// behind the filters makes its own copies.

template <class P>
[[nodiscard, gnu::cold, gnu::noinline]] Sign turn_uncertain(const P& p, const P& q,
                                                            const P& r) noexcept {
    const std::array m = {ours(p), ours(q), ours(r)};
    // Two products of 52 bits.
    const SmallOffsets from(m, 2, 26);
    if (from.are_exact())
        return sign_of(predicates::ccw_determinant(from(0, 0), from(0, 1), from(1, 0), from(1, 1)));
    return predicates::Ccw::behind<Arithmetic::exact>(m[0], m[1], m[2]).sign;
}
template <class P>
[[nodiscard, gnu::cold, gnu::noinline]] Sign turn_uncertain(const P& p, const P& q, const P& r,
                                                            const P& s) noexcept {
    const std::array m = {ours(p), ours(q), ours(r), ours(s)};
    // Six products of 48 bits.
    const SmallOffsets from(m, 0, 16);
    if (from.are_exact()) return sign_of(predicates::ccw_determinant(from[1], from[2], from[3]));
    return predicates::Ccw3::behind<Arithmetic::exact>(m[0], m[1], m[2], m[3]).sign;
}
/// The orientation of three points of the plane or four of space.
template <class... P>
[[nodiscard, gnu::flatten]] inline Sign turn(const P&... points) noexcept {
    const filters::Verdict verdict = predicates::ccw_filter(ours(points)...);
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return turn_uncertain(points...);
}

/// The sign of the determinant where the filter leaves it open. It changes with every exchange of
/// two sites; so the last one is exchanged until the others turn, and turned positively. Where none
/// do, all sites are in one line or plane, and it is 0.
template <class P>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_circle_uncertain(const P& p, const P& q,
                                                                      const P& r,
                                                                      const P& t) noexcept {
    std::array m = {ours(p), ours(q), ours(r), ours(t)};
    if (weigh_the_same(m)) {
        // Twelve products of 48 bits: two squares, two products of a minor, three rows.
        const SmallOffsets from(m, 3, 12);
        if (from.are_exact()) {
            const auto row = [&](std::size_t k) {
                return power::Row<double>{from(k, 0), from(k, 1), 0.0};
            };
            return sign_of(power::in_circle_determinant(row(0), row(1), row(2)));
        }
    }
    for (std::size_t last = 4; last-- > 0;) {
        std::swap(m[last], m[3]);
        const Sign exchanged = last == 3 ? 1 : -1;
        const Sign around = turn(m[0], m[1], m[2]);
        if (around < 0) std::swap(m[0], m[1]);
        if (around != 0)
            return around * exchanged *
                   power::InCircle::behind<Arithmetic::exact>(m[0], m[1], m[2], m[3]).sign;
        std::swap(m[last], m[3]);
    }
    return 0;
}
template <class P>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_sphere_uncertain(const P& p, const P& q,
                                                                      const P& r, const P& s,
                                                                      const P& t) noexcept {
    std::array m = {ours(p), ours(q), ours(r), ours(s), ours(t)};
    if (weigh_the_same(m)) {
        // 72 products of 45 bits: three squares, six products of a minor, four rows.
        const SmallOffsets from(m, 4, 9);
        if (from.are_exact()) {
            const auto row = [&](std::size_t k) { return power::LiftedRow<double>{from[k], 0.0}; };
            return sign_of(power::in_sphere_determinant(row(0), row(1), row(2), row(3)));
        }
    }
    for (std::size_t last = 5; last-- > 0;) {
        std::swap(m[last], m[4]);
        const Sign exchanged = last == 4 ? 1 : -1;
        const Sign around = turn(m[0], m[1], m[2], m[3]);
        if (around < 0) std::swap(m[0], m[1]);
        if (around != 0)
            return around * exchanged *
                   power::InSphere::behind<Arithmetic::exact>(m[0], m[1], m[2], m[3], m[4]).sign;
        std::swap(m[last], m[4]);
    }
    return 0;
}
/// +1 where t conflicts with p, q, r, which turn counterclockwise; -1 where these turn clockwise.
template <class P>
[[nodiscard, gnu::flatten]] inline Sign side_of_circle(const P& p, const P& q, const P& r,
                                                       const P& t) noexcept {
    const filters::Verdict verdict = power::in_circle_filter(ours(p), ours(q), ours(r), ours(t));
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return side_of_circle_uncertain(p, q, r, t);
}
template <class P>
[[nodiscard, gnu::flatten]] inline Sign side_of_sphere(const P& p, const P& q, const P& r,
                                                       const P& s, const P& t) noexcept {
    const filters::Verdict verdict =
        power::in_sphere_filter(ours(p), ours(q), ours(r), ours(s), ours(t));
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return side_of_sphere_uncertain(p, q, r, s, t);
}

// ---- circles in a plane of space ----------------------------------------------------------------

/// The same site elsewhere along an axis, about as far as `extent`, toward 0. Not a matter of
/// rounding: any other place will do, near ones make for certain filters.
template <power::PowerSite3 S>
[[nodiscard]] inline S moved(S site, double S::*axis, double extent) noexcept {
    const double x = site.*axis;
    const double least = std::max(0x1p-50 * (x < 0.0 ? -x : x), 0x1p-1000);
    const double step = std::max(std::min(extent, 0x1p1000), least);
    site.*axis = x > 0.0 ? x - step : x + step;
    return site;
}
/// The greatest difference of coordinates.
template <power::PowerSite3 S>
[[nodiscard]] inline double extent_of(const S& p, const S& q) noexcept {
    const auto apart = [](double a, double b) { return a < b ? b - a : a - b; };
    return std::max(apart(p.x, q.x), std::max(apart(p.y, q.y), apart(p.z, q.z)));
}

/// +1 where t conflicts with the circle of p, q, r, all in one plane, whichever way these turn.
/// The sphere through the circle and any apex off the plane meets it in the circle; and an apex
/// beside p along an axis is off the plane where p, q, r turn along that axis.
/// Precondition: p, q, r are not collinear.
template <power::PowerSite3 S>
[[nodiscard]] inline Sign conflict_in_plane(const S& p, const S& q, const S& r,
                                            const S& t) noexcept {
    double S::*axis = &S::z;
    if (turn(Point{p.x, p.y}, Point{q.x, q.y}, Point{r.x, r.y}) == 0)
        axis = turn(Point{p.y, p.z}, Point{q.y, q.z}, Point{r.y, r.z}) != 0 ? &S::x : &S::y;
    const S apex = moved(p, axis, std::max(extent_of(p, q), extent_of(p, r)));
    return side_of_sphere(p, q, r, apex, t) * turn(p, q, r, apex);
}
/// The same for the segment of p and q, by two apexes. Precondition: p and q are not at one place.
template <power::PowerSite3 S>
[[nodiscard]] inline Sign conflict_on_line(const S& p, const S& q, const S& t) noexcept {
    const bool along_x = p.x != q.x;
    const bool along_y = !along_x && p.y != q.y;
    const double extent = extent_of(p, q);
    const S one = moved(p, along_x ? &S::y : &S::x, extent);
    const S other = moved(p, along_x || along_y ? &S::z : &S::y, extent);
    return side_of_sphere(p, q, one, other, t) * turn(p, q, one, other);
}
/// The same at one place: who weighs more.
template <class S>
[[nodiscard]] inline Sign conflict_at_place(const S& p, const S& t) noexcept {
    return filters::compare_numbers(t.w, p.w);
}

/// The orientation of three points of space in the first coordinate plane where they have one, for
/// which CGAL takes xy, yz, xz, and which of these.
template <class Visit>
[[nodiscard]] inline Sign first_turn(const Point3& p, const Point3& q, const Point3& r,
                                     Visit visit) noexcept {
    const auto xy = [](const Point3& m) -> Point { return {m.x, m.y}; };
    const auto yz = [](const Point3& m) -> Point { return {m.y, m.z}; };
    const auto xz = [](const Point3& m) -> Point { return {m.x, m.z}; };
    if (const Sign sign = turn(xy(p), xy(q), xy(r)); sign != 0) return visit(sign, xy);
    if (const Sign sign = turn(yz(p), yz(q), yz(r)); sign != 0) return visit(sign, yz);
    return visit(turn(xz(p), xz(q), xz(r)), xz);
}

}  // namespace signum::cgal::details

SIGNUM_IEEE_END
