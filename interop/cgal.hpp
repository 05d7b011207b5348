#pragma once
/// CGAL's triangulations on signum's predicates, and results to and from them.
///
/// Laws:
///  1. Traits<Kernel> is Kernel, whose numbers are doubles, with other predicates: those that the
///     Delaunay and regular triangulations of plane and space ask while they are built, searched
///     and checked. Each has the sign that the kernel's own has, for all finite doubles, so that
///     the triangulation is the same. Points, constructions and all other predicates are the
///     kernel's.
///  2. CGAL decides ties by its own rule, by the order of coordinates. Where all weights are equal
///     signum's rule chooses the same; otherwise either choice is valid.
///  3. CGAL's points carry a weight, signum's Site a radius, whose square need not be a double. So
///     what goes from here to there, or back, are Point, power::Site, Point3 and power::Site3.
///
/// The header is as free as signum is; CGAL's triangulations are under the GPL.

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/enum.h>

#include "../core/index.hpp"
#include "../core/site.hpp"
#include "../predicates/ccw.hpp"
#include "../predicates/power.hpp"
#include "../predicates/space.hpp"
#include "../spatial/triangulate.hpp"
#include "../triangulation/arrays.hpp"
#include "../triangulation/tessellation.hpp"

namespace signum::cgal {

namespace details {

// ---- points -------------------------------------------------------------------------------------

/// One of CGAL's points, plain or weighted, of the plane or of space, as one of ours.
template <class P>
[[nodiscard, gnu::always_inline]] inline auto ours(const P& p) noexcept {
    if constexpr (HasCentre<P> || HasCentre3<P>)
        return p;
    else if constexpr (requires {
                           p.weight();
                           p.z();
                       })
        return power::Site3{p.x(), p.y(), p.z(), p.weight()};
    else if constexpr (requires { p.weight(); })
        return power::Site{p.x(), p.y(), p.weight()};
    else if constexpr (requires { p.z(); })
        return Point3{p.x(), p.y(), p.z()};
    else
        return Point{p.x(), p.y()};
}

/// And the other way.
template <class P, class S>
[[nodiscard]] P theirs(const S& s) {
    if constexpr (requires {
                      s.w;
                      s.z;
                  })
        return P({s.x, s.y, s.z}, s.w);
    else if constexpr (requires { s.w; })
        return P({s.x, s.y}, s.w);
    else if constexpr (requires { s.z; })
        return P(s.x, s.y, s.z);
    else
        return P(s.x, s.y);
}

/// CGAL's signs are enumerators from -1 to 1, whatever they are called.
template <class CgalSign>
[[nodiscard]] inline CgalSign sign_cast(Sign sign) noexcept {
    return static_cast<CgalSign>(sign);
}

// ---- ties on grids ------------------------------------------------------------------------------

/// Places relative to one of them, in multiples of one power of two: integers of so few bits that
/// determinants fit into 64. On grids, where ties abound, that is as fast as a filter.
template <class S, std::size_t number>
class SmallOffsets {
 public:
    /// From sites[origin]; the largest offset has `bits` bits.
    SmallOffsets(const S* const (&sites)[number], std::size_t origin, int bits) noexcept {
        double largest = 0.0;
        for (std::size_t m = 0; m < number; ++m)
            for (std::size_t k = 0; k < dimension; ++k) {
                const double offset = sites[m]->*axes[k] - sites[origin]->*axes[k];
                largest = std::max(largest, filters::magnitude(offset));
            }
        if (!filters::environment_is_default()) return;
        if (!(largest >= 0x1p-500 && largest <= 0x1p500)) return;
        constexpr std::uint64_t exponent = 0x7FF0'0000'0000'0000;
        const double scale =
            std::bit_cast<double>((std::uint64_t(2 * 1023 + bits - 1) << 52) -
                                  (std::bit_cast<std::uint64_t>(largest) & exponent));
        are_exact_ = true;
        for (std::size_t m = 0; m < number; ++m)
            for (std::size_t k = 0; k < dimension; ++k)
                offsets_[m][k] = integer(sites[m]->*axes[k], scale);
        for (std::size_t k = 0; k < dimension; ++k) {
            const std::int64_t from = offsets_[origin][k];
            for (std::size_t m = 0; m < number; ++m) offsets_[m][k] -= from;
        }
    }

    [[nodiscard]] bool are_exact() const noexcept { return are_exact_; }
    [[nodiscard]] std::int64_t operator()(std::size_t site, std::size_t axis) const noexcept {
        return offsets_[site][axis];
    }
    [[nodiscard]] predicates::Offset3<std::int64_t> operator[](std::size_t site) const noexcept {
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

    /// The scale is a power of two: what is lost is a coordinate that it makes 0.
    [[nodiscard]] std::int64_t integer(double coordinate, double scale) noexcept {
        const double value = coordinate * scale;
        if (!(filters::magnitude(value) <= 0x1p62)) {
            are_exact_ = false;
            return 0;
        }
        const auto result = static_cast<std::int64_t>(value);
        are_exact_ &= static_cast<double>(result) == value && (result != 0 || coordinate == 0.0);
        return result;
    }

    bool are_exact_ = false;
    std::array<std::array<std::int64_t, dimension>, number> offsets_{};
};

template <class S, class... Others>
[[nodiscard]] inline bool weigh_the_same(const S& first, const Others&... others) noexcept {
    if constexpr (requires { first.w; })
        return ((others.w == first.w) && ...);
    else
        return true;
}

// ---- signs, however the points turn -------------------------------------------------------------

template <class S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign turn_uncertain(const S& p, const S& q,
                                                            const S& r) noexcept {
    // Two products of 60 bits.
    const SmallOffsets from({&p, &q, &r}, 2, 30);
    if (from.are_exact()) {
        const auto determinant = predicates::ccw_determinant<std::int64_t>(from(0, 0), from(0, 1),
                                                                           from(1, 0), from(1, 1));
        return (determinant > 0) - (determinant < 0);
    }
    return predicates::ccw_cold({p.x, p.y}, {q.x, q.y}, {r.x, r.y}).sign;
}
template <class S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign turn_uncertain(const S& p, const S& q, const S& r,
                                                            const S& s) noexcept {
    // Six products of 57 bits.
    const SmallOffsets from({&p, &q, &r, &s}, 0, 19);
    if (from.are_exact()) {
        const std::int64_t determinant = predicates::ccw_determinant(from[1], from[2], from[3]);
        return (determinant > 0) - (determinant < 0);
    }
    return predicates::ccw_cold(centre3(p), centre3(q), centre3(r), centre3(s)).sign;
}
/// The orientation of three points of the plane or four of space.
template <class... S>
[[nodiscard]] inline Sign turn(const S&... points) noexcept {
    const filters::Verdict verdict = predicates::ccw_filter(points...);
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return turn_uncertain(points...);
}

/// The sign of the determinant where the filter leaves it open. It changes with every exchange of
/// two sites; so the last one is exchanged until the others turn, and turned positively. Where none
/// do, all sites are in one line or plane, and it is 0.
template <class S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_circle_uncertain(const S& p, const S& q,
                                                                      const S& r,
                                                                      const S& t) noexcept {
    if (weigh_the_same(p, q, r, t)) {
        // Heights of 29 bits, minors of 29, three products of 58.
        const SmallOffsets from({&p, &q, &r, &t}, 3, 14);
        if (from.are_exact()) {
            const auto row = [&](std::size_t k) {
                return power::Row<std::int64_t>{from(k, 0), from(k, 1), 0};
            };
            const std::int64_t determinant = power::in_circle_determinant(row(0), row(1), row(2));
            return (determinant > 0) - (determinant < 0);
        }
    }
    std::array m = {p, q, r, t};
    for (std::size_t last = 4; last-- > 0;) {
        std::swap(m[last], m[3]);
        const Sign exchanged = last == 3 ? 1 : -1;
        const Sign around = turn(m[0], m[1], m[2]);
        if (around > 0) return exchanged * power::in_circle_cold(m[0], m[1], m[2], m[3]).sign;
        if (around < 0) return -exchanged * power::in_circle_cold(m[1], m[0], m[2], m[3]).sign;
        std::swap(m[last], m[3]);
    }
    return 0;
}
template <class S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_sphere_uncertain(const S& p, const S& q,
                                                                      const S& r, const S& s,
                                                                      const S& t) noexcept {
    if (weigh_the_same(p, q, r, s, t)) {
        // Heights of 24 bits, minors of three rows of 36, four products of 60.
        const SmallOffsets from({&p, &q, &r, &s, &t}, 4, 11);
        if (from.are_exact()) {
            const auto row = [&](std::size_t k) {
                return power::LiftedRow<std::int64_t>{from[k], 0};
            };
            const std::int64_t determinant =
                power::in_sphere_determinant(row(0), row(1), row(2), row(3));
            return (determinant > 0) - (determinant < 0);
        }
    }
    std::array m = {p, q, r, s, t};
    for (std::size_t last = 5; last-- > 0;) {
        std::swap(m[last], m[4]);
        const Sign exchanged = last == 4 ? 1 : -1;
        const Sign around = turn(m[0], m[1], m[2], m[3]);
        if (around > 0) return exchanged * power::in_sphere_cold(m[0], m[1], m[2], m[3], m[4]).sign;
        if (around < 0)
            return -exchanged * power::in_sphere_cold(m[1], m[0], m[2], m[3], m[4]).sign;
        std::swap(m[last], m[4]);
    }
    return 0;
}
/// +1 where t conflicts with p, q, r, which turn counterclockwise; -1 where these turn clockwise.
template <class S>
[[nodiscard]] inline Sign side_of_circle(const S& p, const S& q, const S& r, const S& t) noexcept {
    const filters::Verdict verdict = power::in_circle_filter(p, q, r, t);
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return side_of_circle_uncertain(p, q, r, t);
}
template <class S>
[[nodiscard]] inline Sign side_of_sphere(const S& p, const S& q, const S& r, const S& s,
                                         const S& t) noexcept {
    const filters::Verdict verdict = power::in_sphere_filter(p, q, r, s, t);
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

// ---- the predicates -----------------------------------------------------------------------------

template <class K>
struct Orientation_2 : K::Orientation_2 {
    using K::Orientation_2::operator();
    using Point_2 = typename K::Point_2;
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
        return sign_cast<CGAL::Orientation>(turn(ours(p), ours(q), ours(r)));
    }
};

template <class K>
struct Side_of_oriented_circle_2 : K::Side_of_oriented_circle_2 {
    using Point_2 = typename K::Point_2;
    CGAL::Oriented_side operator()(const Point_2& p, const Point_2& q, const Point_2& r,
                                   const Point_2& t) const {
        return sign_cast<CGAL::Oriented_side>(side_of_circle(ours(p), ours(q), ours(r), ours(t)));
    }
};

template <class K>
struct Compare_distance_2 : K::Compare_distance_2 {
    using K::Compare_distance_2::operator();
    using Point_2 = typename K::Point_2;
    CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
        return sign_cast<CGAL::Comparison_result>(
            -power::nearer_decision(ours(p), ours(q), ours(r)).sign);
    }
};

template <class K>
struct Power_side_of_oriented_power_circle_2 : K::Power_side_of_oriented_power_circle_2 {
    using Site_2 = typename K::Weighted_point_2;
    CGAL::Oriented_side operator()(const Site_2& p, const Site_2& q, const Site_2& r,
                                   const Site_2& t) const {
        return sign_cast<CGAL::Oriented_side>(side_of_circle(ours(p), ours(q), ours(r), ours(t)));
    }
    CGAL::Oriented_side operator()(const Site_2& p, const Site_2& q, const Site_2& t) const {
        return sign_cast<CGAL::Oriented_side>(
            power::in_segment_decision(ours(p), ours(q), ours(t)).sign);
    }
    CGAL::Oriented_side operator()(const Site_2& p, const Site_2& t) const {
        return sign_cast<CGAL::Oriented_side>(conflict_at_place(ours(p), ours(t)));
    }
};

template <class K>
struct Compare_power_distance_2 : K::Compare_power_distance_2 {
    using Site_2 = typename K::Weighted_point_2;
    CGAL::Comparison_result operator()(const typename K::Point_2& p, const Site_2& q,
                                       const Site_2& r) const {
        return sign_cast<CGAL::Comparison_result>(
            -power::nearer_decision(ours(p), ours(q), ours(r)).sign);
    }
};

template <class K>
struct Orientation_3 : K::Orientation_3 {
    using K::Orientation_3::operator();
    using Point_3 = typename K::Point_3;
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r,
                                 const Point_3& s) const {
        return sign_cast<CGAL::Orientation>(turn(ours(p), ours(q), ours(r), ours(s)));
    }
};

template <class K>
struct Coplanar_orientation_3 : K::Coplanar_orientation_3 {
    using Point_3 = typename K::Point_3;
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r) const {
        return sign_cast<CGAL::Orientation>(
            first_turn(ours(p), ours(q), ours(r), [](Sign sign, auto) { return sign; }));
    }
    /// Whether r and s are on the same side of the line of p and q.
    CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r,
                                 const Point_3& s) const {
        return sign_cast<CGAL::Orientation>(
            first_turn(ours(p), ours(q), ours(r), [&](Sign sign, auto flat) {
                return sign * turn(flat(ours(p)), flat(ours(q)), flat(ours(s)));
            }));
    }
};

template <class K>
struct Side_of_oriented_sphere_3 : K::Side_of_oriented_sphere_3 {
    using Point_3 = typename K::Point_3;
    CGAL::Oriented_side operator()(const Point_3& p, const Point_3& q, const Point_3& r,
                                   const Point_3& s, const Point_3& t) const {
        return sign_cast<CGAL::Oriented_side>(
            side_of_sphere(ours(p), ours(q), ours(r), ours(s), ours(t)));
    }
};

template <class K>
struct Coplanar_side_of_bounded_circle_3 : K::Coplanar_side_of_bounded_circle_3 {
    using Point_3 = typename K::Point_3;
    CGAL::Bounded_side operator()(const Point_3& p, const Point_3& q, const Point_3& r,
                                  const Point_3& t) const {
        return sign_cast<CGAL::Bounded_side>(conflict_in_plane(ours(p), ours(q), ours(r), ours(t)));
    }
};

template <class K>
struct Compare_distance_3 : K::Compare_distance_3 {
    using K::Compare_distance_3::operator();
    using Point_3 = typename K::Point_3;
    CGAL::Comparison_result operator()(const Point_3& p, const Point_3& q, const Point_3& r) const {
        return sign_cast<CGAL::Comparison_result>(
            -power::nearer_decision(ours(p), ours(q), ours(r)).sign);
    }
};

template <class K>
struct Power_side_of_oriented_power_sphere_3 : K::Power_side_of_oriented_power_sphere_3 {
    using Site_3 = typename K::Weighted_point_3;
    CGAL::Oriented_side operator()(const Site_3& p, const Site_3& q, const Site_3& r,
                                   const Site_3& s, const Site_3& t) const {
        return sign_cast<CGAL::Oriented_side>(
            side_of_sphere(ours(p), ours(q), ours(r), ours(s), ours(t)));
    }
    CGAL::Oriented_side operator()(const Site_3& p, const Site_3& q, const Site_3& r,
                                   const Site_3& t) const {
        return sign_cast<CGAL::Oriented_side>(
            conflict_in_plane(ours(p), ours(q), ours(r), ours(t)));
    }
    CGAL::Oriented_side operator()(const Site_3& p, const Site_3& q, const Site_3& t) const {
        return sign_cast<CGAL::Oriented_side>(conflict_on_line(ours(p), ours(q), ours(t)));
    }
    CGAL::Oriented_side operator()(const Site_3& p, const Site_3& t) const {
        return sign_cast<CGAL::Oriented_side>(conflict_at_place(ours(p), ours(t)));
    }
};

template <class K>
struct Compare_power_distance_3 : K::Compare_power_distance_3 {
    using Site_3 = typename K::Weighted_point_3;
    CGAL::Comparison_result operator()(const typename K::Point_3& p, const Site_3& q,
                                       const Site_3& r) const {
        const auto [x, y, z] = ours(p);
        return sign_cast<CGAL::Comparison_result>(
            -power::nearer_decision(Point3{x, y, z}, ours(q), ours(r)).sign);
    }
};

}  // namespace details

/// The traits: CGAL::Delaunay_triangulation_2<signum::cgal::Traits<>>, and so on. Points are those
/// of the kernel.
template <class Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Traits : public Kernel {
    static_assert(
        std::same_as<typename Kernel::FT, double>,
        "signum's predicates take doubles: Exact_predicates_inexact_constructions_kernel");

 public:
    using Orientation_2 = details::Orientation_2<Kernel>;
    using Side_of_oriented_circle_2 = details::Side_of_oriented_circle_2<Kernel>;
    using Compare_distance_2 = details::Compare_distance_2<Kernel>;
    using Power_side_of_oriented_power_circle_2 =
        details::Power_side_of_oriented_power_circle_2<Kernel>;
    using Compare_power_distance_2 = details::Compare_power_distance_2<Kernel>;
    using Orientation_3 = details::Orientation_3<Kernel>;
    using Coplanar_orientation_3 = details::Coplanar_orientation_3<Kernel>;
    using Side_of_oriented_sphere_3 = details::Side_of_oriented_sphere_3<Kernel>;
    using Coplanar_side_of_bounded_circle_3 = details::Coplanar_side_of_bounded_circle_3<Kernel>;
    using Compare_distance_3 = details::Compare_distance_3<Kernel>;
    using Power_side_of_oriented_power_sphere_3 =
        details::Power_side_of_oriented_power_sphere_3<Kernel>;
    using Compare_power_distance_3 = details::Compare_power_distance_3<Kernel>;

    Orientation_2 orientation_2_object() const { return {}; }
    Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
    Compare_distance_2 compare_distance_2_object() const { return {}; }
    Power_side_of_oriented_power_circle_2 power_side_of_oriented_power_circle_2_object() const {
        return {};
    }
    Compare_power_distance_2 compare_power_distance_2_object() const { return {}; }
    Orientation_3 orientation_3_object() const { return {}; }
    Coplanar_orientation_3 coplanar_orientation_3_object() const { return {}; }
    Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
    Coplanar_side_of_bounded_circle_3 coplanar_side_of_bounded_circle_3_object() const {
        return {};
    }
    Compare_distance_3 compare_distance_3_object() const { return {}; }
    Power_side_of_oriented_power_sphere_3 power_side_of_oriented_power_sphere_3_object() const {
        return {};
    }
    Compare_power_distance_3 compare_power_distance_3_object() const { return {}; }
};

// ---- results, to and from CGAL
// -------------------------------------------------------------------

namespace details {

/// Whether a triangulation is one of the plane, and whether its points carry weights.
template <class T>
inline constexpr bool is_planar = requires {
    typename T::Face_handle;
};
template <class T>
inline constexpr bool is_weighted = requires(const typename T::Point& p) {
    p.weight();
};

/// The points or sites that go to and from a triangulation.
template <class T>
using SiteOf =
    std::conditional_t<is_planar<T>, std::conditional_t<is_weighted<T>, power::Site, Point>,
                       std::conditional_t<is_weighted<T>, power::Site3, Point3>>;
template <class T>
using ResultOf = std::conditional_t<is_planar<T>, TessellationArrays, SpaceTessellation>;

/// The numbers of sites by what they are; of equal ones the first counts.
template <class S>
class Numbers {
 public:
    explicit Numbers(std::span<const S> sites) : sites_(sites), order_(sites.size()) {
        for (std::size_t i = 0; i < sites.size(); ++i) order_[i] = static_cast<Index>(i);
        std::ranges::stable_sort(order_, {}, [this](Index i) { return key(at(i)); });
    }
    [[nodiscard]] Index operator()(const S& site) const {
        const auto found =
            std::ranges::lower_bound(order_, key(site), {}, [this](Index i) { return key(at(i)); });
        if (found == order_.end() || key(at(*found)) != key(site))
            throw std::invalid_argument("a vertex of the triangulation is none of the sites");
        return *found;
    }

 private:
    [[nodiscard]] const S& at(Index i) const { return sites_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] static auto key(const S& s) {
        const double third = [&] {
            if constexpr (requires { s.z; })
                return s.z;
            else
                return 0.0;
        }();
        const double weight = [&] {
            if constexpr (requires { s.w; })
                return s.w;
            else
                return 0.0;
        }();
        return std::array{s.x, s.y, third, weight};
    }

    std::span<const S> sites_;
    std::vector<Index> order_;
};

/// Turns a row so that its smallest number comes first and, of a cell, the next smallest second;
/// the orientation stays. Of flat sites numbers rise.
template <std::size_t number>
void turn_row(std::array<Index, number>& row, std::array<Index, number>& neighbours,
              std::size_t used) {
    const auto exchange = [&](std::size_t a, std::size_t b) {
        std::swap(row[a], row[b]);
        std::swap(neighbours[a], neighbours[b]);
    };
    // By exchanges, of which an odd number is made even at the end, where that counts.
    bool is_odd = false;
    for (std::size_t k = 1; k < used; ++k)
        for (std::size_t m = k; m > 0 && row[m] < row[m - 1]; --m) {
            exchange(m, m - 1);
            is_odd = !is_odd;
        }
    if (is_odd && used == number) exchange(number - 2, number - 1);
}

/// Rows turned and sorted, each with its neighbours, which are renumbered.
template <std::size_t number>
void put_in_order(std::vector<std::array<Index, number>>& rows,
                  std::vector<std::array<Index, number>>& neighbours, std::size_t used = number) {
    const std::size_t count = rows.size();
    std::vector<Index> order(count);
    for (std::size_t i = 0; i < count; ++i) {
        order[i] = static_cast<Index>(i);
        turn_row(rows[i], neighbours[i], used);
    }
    std::ranges::sort(order, {}, [&](Index i) { return rows[static_cast<std::size_t>(i)]; });
    std::vector<Index> place(count);
    for (std::size_t i = 0; i < count; ++i)
        place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
    const auto sorted = [&](const auto& all) {
        auto result = all;
        for (std::size_t i = 0; i < count; ++i) result[i] = all[static_cast<std::size_t>(order[i])];
        return result;
    };
    rows = sorted(rows);
    neighbours = sorted(neighbours);
    for (auto& row : neighbours)
        for (std::size_t k = 0; k < used; ++k) row[k] = place[static_cast<std::size_t>(row[k])];
}

/// All faces or cells of a triangulation, infinite ones too, as rows of the sites' numbers.
template <std::size_t number, class T, class Handles, class Visit>
void read_rows(const T& triangulation, const Handles& handles, Visit number_of, std::size_t used,
               std::vector<std::array<Index, number>>& rows,
               std::vector<std::array<Index, number>>& neighbours) {
    using Handle = typename Handles::value_type;
    CGAL::Unique_hash_map<Handle, Index> numbers;
    Index count = 0;
    for (const Handle h : handles) numbers[h] = count++;
    for (const Handle h : handles) {
        auto& row = rows.emplace_back();
        auto& across = neighbours.emplace_back();
        row.fill(no_vertex);
        across.fill(no_vertex);
        for (std::size_t k = 0; k < used; ++k) {
            const auto v = h->vertex(static_cast<int>(k));
            row[k] = triangulation.is_infinite(v) ? infinite : number_of(v);
            across[k] = numbers[h->neighbor(static_cast<int>(k))];
        }
    }
}

/// The faces of visible sites on one line, in their order along it: between neighbours one on
/// either side, tied to infinity; beyond the ends the two sides meet.
inline void read_line(const std::vector<Index>& line, std::vector<Face>& faces,
                      std::vector<Face>& neighbours) {
    const auto last = static_cast<Index>(line.size()) - 2;
    for (Index i = 0; i <= last; ++i) {
        const Index a = line[static_cast<std::size_t>(i)];
        const Index b = line[static_cast<std::size_t>(i) + 1];
        const Index left = 2 * i;
        const Index right = left + 1;
        faces.push_back({a, b, infinite});
        neighbours.push_back({i == last ? right : left + 2, i == 0 ? right : left - 2, right});
        faces.push_back({b, a, infinite});
        neighbours.push_back({i == 0 ? left : right - 2, i == last ? left : right + 2, left});
    }
}

}  // namespace details

/// A Delaunay or regular triangulation of CGAL's, on any traits whose numbers are doubles, as
/// signum's arrays, in canonical order (triangulation/arrays.hpp, spatial/triangulate.hpp). `sites`
/// are the points that it was made of, Point, power::Site, Point3 or power::Site3, in any order:
/// they give the numbers; of equal ones the first is visible. Throws std::invalid_argument for a
/// vertex that is none of them. O(n log n), and for each hidden site the way to the nearest.
template <class T>
[[nodiscard]] details::ResultOf<T> arrays(const T& triangulation,
                                          std::span<const details::SiteOf<T>> sites) {
    using S = details::SiteOf<T>;
    const details::Numbers<S> numbers(sites);
    std::vector<bool> is_visible(sites.size(), false);
    std::vector<Index> visible;
    const auto number_of = [&](const auto& vertex) {
        return numbers(details::ours(vertex->point()));
    };
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
         ++v) {
        visible.push_back(number_of(v));
        is_visible[static_cast<std::size_t>(visible.back())] = true;
    }
    details::ResultOf<T> result;
    result.sites = static_cast<std::int64_t>(sites.size());
    const int dimension = triangulation.dimension();
    if constexpr (details::is_planar<T>) {
        if (details::is_weighted<T>) result.weight_is = WeightIs::weight;
        if (dimension == 2) {
            std::vector<typename T::Face_handle> handles;
            for (const auto f : triangulation.all_face_handles()) handles.push_back(f);
            details::read_rows(triangulation, handles, number_of, 3, result.faces,
                               result.neighbours);
        } else if (dimension == 1) {
            std::ranges::sort(visible, {}, [&](Index i) {
                const S& s = sites[static_cast<std::size_t>(i)];
                return std::pair(s.x, s.y);
            });
            details::read_line(visible, result.faces, result.neighbours);
        }
        details::put_in_order(result.faces, result.neighbours);
    } else {
        result.dimension = dimension;
        const auto used = static_cast<std::size_t>(dimension + 1);
        std::vector<typename T::Cell_handle> handles;
        if (dimension >= 0)
            for (auto c = triangulation.tds().raw_cells_begin();
                 c != triangulation.tds().raw_cells_end(); ++c)
                handles.push_back(c);
        details::read_rows(triangulation, handles, number_of, used, result.cells,
                           result.neighbours);
        details::put_in_order(result.cells, result.neighbours, used);
    }
    // Whoever is hidden: of points the equal one, of sites with weights the nearest.
    std::vector<Site> plane;
    if constexpr (details::is_planar<T> && details::is_weighted<T>)
        if (visible.size() < sites.size() && visible.size() > 1)
            for (const S& s : sites) plane.push_back({s.x, s.y, s.w});
    const Tessellation tessellation = [&]() -> Tessellation {
        if constexpr (details::is_planar<T>)
            if (!plane.empty()) return {result, std::move(plane), {}};
        return {};
    }();
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (is_visible[i]) continue;
        const S& s = sites[i];
        Index by = visible.front();
        if constexpr (!details::is_weighted<T>)
            by = numbers(s);
        else if constexpr (!details::is_planar<T>)
            by = number_of(triangulation.nearest_power_vertex({s.x, s.y, s.z}));
        else if (visible.size() > 1)
            by = tessellation.nearest({s.x, s.y});
        result.hidden.push_back({static_cast<Index>(i), by});
    }
    return result;
}

/// The other way: makes a triangulation of CGAL's out of signum's arrays, without asking a
/// predicate but for flat sites and hidden ones, and returns the vertex of every site: of a hidden
/// point that of the equal one, of a hidden site what CGAL's insert() returns, which keeps it among
/// its own hidden ones. Flat sites are inserted as CGAL does. Throws std::invalid_argument where
/// the sites are not as many as the arrays say. Precondition: the arrays are a tessellation of the
/// sites, with their neighbours; of whom one does not know that, validate() is to be asked. O(n),
/// and CGAL's insertions of those.
template <class T>
std::vector<typename T::Vertex_handle> assign(T& triangulation, const details::ResultOf<T>& result,
                                              std::span<const details::SiteOf<T>> sites) {
    if (result.sites != static_cast<std::int64_t>(sites.size()))
        throw std::invalid_argument("the tessellation is of " + std::to_string(result.sites) +
                                    " sites, and there are " + std::to_string(sites.size()));
    using Vertex_handle = typename T::Vertex_handle;
    std::vector<bool> is_hidden(sites.size(), false);
    for (const Hidden& h : result.hidden) is_hidden[static_cast<std::size_t>(h.site)] = true;
    std::vector<Vertex_handle> vertices(sites.size());
    const auto point = [&](std::size_t i) { return details::theirs<typename T::Point>(sites[i]); };

    const auto& rows = [&]() -> const auto& {
        if constexpr (details::is_planar<T>)
            return result.faces;
        else
            return result.cells;
    }
    ();
    const bool is_flat = [&] {
        if constexpr (details::is_planar<T>)
            return std::ranges::none_of(rows, [](const Face& face) { return face[0] >= 0; });
        else
            return result.dimension < 3;
    }();
    if (is_flat) {
        triangulation.clear();
        for (std::size_t i = 0; i < sites.size(); ++i)
            if (!is_hidden[i]) vertices[i] = triangulation.insert(point(i));
    } else {
        auto& tds = triangulation.tds();
        triangulation.clear();
        tds.clear();
        tds.set_dimension(details::is_planar<T> ? 2 : 3);
        const Vertex_handle at_infinity = tds.create_vertex();
        triangulation.set_infinite_vertex(at_infinity);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (is_hidden[i]) continue;
            vertices[i] = tds.create_vertex();
            vertices[i]->set_point(point(i));
        }
        const auto vertex = [&](Index i) {
            return i == infinite ? at_infinity : vertices[static_cast<std::size_t>(i)];
        };
        const auto create = [&](const auto& row) {
            if constexpr (details::is_planar<T>) {
                const auto f = tds.create_face(vertex(row[0]), vertex(row[1]), vertex(row[2]));
                for (const Index i : row) vertex(i)->set_face(f);
                return f;
            } else {
                const auto c =
                    tds.create_cell(vertex(row[0]), vertex(row[1]), vertex(row[2]), vertex(row[3]));
                for (const Index i : row) vertex(i)->set_cell(c);
                return c;
            }
        };
        std::vector<decltype(create(rows.front()))> handles;
        handles.reserve(rows.size());
        for (const auto& row : rows) handles.push_back(create(row));
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t k = 0; k < rows[i].size(); ++k)
                handles[i]->set_neighbor(
                    static_cast<int>(k),
                    handles[static_cast<std::size_t>(result.neighbours[i][k])]);
    }
    for (const auto& [site, by] : result.hidden) {
        Vertex_handle& hidden = vertices[static_cast<std::size_t>(site)];
        if constexpr (details::is_weighted<T>)
            hidden = triangulation.insert(point(static_cast<std::size_t>(site)));
        else
            hidden = vertices[static_cast<std::size_t>(by)];
    }
    return vertices;
}

}  // namespace signum::cgal

namespace CGAL {
/// A walk begins with rounded signs, as it does for the kernel.
template <class Kernel>
struct Triangulation_structural_filtering_traits<signum::cgal::Traits<Kernel>>
    : Triangulation_structural_filtering_traits<Kernel> {};
}  // namespace CGAL
