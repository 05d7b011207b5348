#pragma once
/// CGAL's triangulations on signum's predicates, and results to and from them.
///
/// Laws:
///  1. Traits<Kernel> is Kernel, whose numbers are doubles, with other predicates: those that the
///     Delaunay and regular triangulations of plane and space ask while they are built, searched and
///     checked. Each has the sign that the kernel's own has, for all finite doubles, so that the
///     triangulation is the same. Points, constructions and all other predicates are the kernel's.
///  2. CGAL decides ties by its own rule, by the order of coordinates. Where all weights are equal
///     signum's rule chooses the same; otherwise either choice is valid.
///  3. CGAL's points carry a weight, signum's Site a radius, whose square need not be a double. So
///     what goes from here to there, or back, are Point, power::Site, Point3 and power::Site3.
///
/// The header is as free as signum is; CGAL's triangulations are under the GPL.

#include <algorithm>
#include <array>
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

// ---- points ------------------------------------------------------------------------------------

/// One of CGAL's points, plain or weighted, of the plane or of space, as one of ours.
template <class P>
[[nodiscard]] inline auto ours(const P& p) noexcept {
    if constexpr (requires { p.weight(); p.z(); })
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
    if constexpr (requires { s.w; s.z; })
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

// ---- which side of a circle or sphere, however its points turn -----------------------------------

[[nodiscard]] inline Sign turn(const Point& a, const Point& b, const Point& c) noexcept {
    return ccw(a, b, c);
}
[[nodiscard]] inline Sign turn(const power::Site& a, const power::Site& b,
                               const power::Site& c) noexcept {
    return ccw(a, b, c);
}
template <power::PowerSite3 S>
[[nodiscard]] inline Sign turn(const S& a, const S& b, const S& c, const S& d) noexcept {
    return ccw(a, b, c, d);
}

/// The sign of the determinant where the filter leaves it open. It changes with every exchange of
/// two sites; so the last one is exchanged until the others turn, and turned positively. Where none
/// do, all sites are in one line or plane, and it is 0.
template <power::PowerSite S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_circle_uncertain(std::array<S, 4> m) noexcept {
    for (std::size_t k = 4; k-- > 0;) {
        std::swap(m[k], m[3]);
        const Sign exchanged = k == 3 ? 1 : -1;
        const Sign around = ccw(m[0], m[1], m[2]);
        if (around > 0) return exchanged * power::in_circle_cold(m[0], m[1], m[2], m[3]).sign;
        if (around < 0) return -exchanged * power::in_circle_cold(m[1], m[0], m[2], m[3]).sign;
        std::swap(m[k], m[3]);
    }
    return 0;
}
template <power::PowerSite3 S>
[[nodiscard, gnu::cold, gnu::noinline]] Sign side_of_sphere_uncertain(std::array<S, 5> m) noexcept {
    for (std::size_t k = 5; k-- > 0;) {
        std::swap(m[k], m[4]);
        const Sign exchanged = k == 4 ? 1 : -1;
        const Sign around = ccw(m[0], m[1], m[2], m[3]);
        if (around > 0)
            return exchanged * power::in_sphere_cold(m[0], m[1], m[2], m[3], m[4]).sign;
        if (around < 0)
            return -exchanged * power::in_sphere_cold(m[1], m[0], m[2], m[3], m[4]).sign;
        std::swap(m[k], m[4]);
    }
    return 0;
}
/// +1 where t conflicts with p, q, r, which turn counterclockwise; -1 where these turn clockwise.
template <power::PowerSite S>
[[nodiscard]] inline Sign side_of_circle(const S& p, const S& q, const S& r, const S& t) noexcept {
    const filters::Verdict verdict = power::in_circle_filter(p, q, r, t);
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return side_of_circle_uncertain<S>({p, q, r, t});
}
template <power::PowerSite3 S>
[[nodiscard]] inline Sign side_of_sphere(const S& p, const S& q, const S& r, const S& s,
                                         const S& t) noexcept {
    const filters::Verdict verdict = power::in_sphere_filter(p, q, r, s, t);
    if (verdict.is_certain()) [[likely]]
        return verdict.sign();
    return side_of_sphere_uncertain<S>({p, q, r, s, t});
}

// ---- circles in a plane of space -----------------------------------------------------------------

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
    if (ccw(Point{p.x, p.y}, Point{q.x, q.y}, Point{r.x, r.y}) == 0)
        axis = ccw(Point{p.y, p.z}, Point{q.y, q.z}, Point{r.y, r.z}) != 0 ? &S::x : &S::y;
    const S apex = moved(p, axis, std::max(extent_of(p, q), extent_of(p, r)));
    return side_of_sphere(p, q, r, apex, t) * ccw(p, q, r, apex);
}
/// The same for the segment of p and q, by two apexes. Precondition: p and q are not at one place.
template <power::PowerSite3 S>
[[nodiscard]] inline Sign conflict_on_line(const S& p, const S& q, const S& t) noexcept {
    const bool along_x = p.x != q.x;
    const bool along_y = !along_x && p.y != q.y;
    const double extent = extent_of(p, q);
    const S one = moved(p, along_x ? &S::y : &S::x, extent);
    const S other = moved(p, along_x || along_y ? &S::z : &S::y, extent);
    return side_of_sphere(p, q, one, other, t) * ccw(p, q, one, other);
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
    if (const Sign sign = ccw(xy(p), xy(q), xy(r)); sign != 0) return visit(sign, xy);
    if (const Sign sign = ccw(yz(p), yz(q), yz(r)); sign != 0) return visit(sign, yz);
    return visit(ccw(xz(p), xz(q), xz(r)), xz);
}

// ---- the predicates ------------------------------------------------------------------------------

template <class K>
struct Orientation_2 : K::Orientation_2 {
    using K::Orientation_2::operator();
    using Point_2 = typename K::Point_2;
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
        return sign_cast<CGAL::Orientation>(ccw(ours(p), ours(q), ours(r)));
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
        return sign_cast<CGAL::Orientation>(ccw(ours(p), ours(q), ours(r), ours(s)));
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
                return sign * ccw(flat(ours(p)), flat(ours(q)), flat(ours(s)));
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
        return sign_cast<CGAL::Bounded_side>(
            conflict_in_plane(ours(p), ours(q), ours(r), ours(t)));
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
    static_assert(std::same_as<typename Kernel::FT, double>,
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

}  // namespace signum::cgal

namespace CGAL {
/// A walk begins with rounded signs, as it does for the kernel.
template <class Kernel>
struct Triangulation_structural_filtering_traits<signum::cgal::Traits<Kernel>>
    : Triangulation_structural_filtering_traits<Kernel> {};
}  // namespace CGAL
