#pragma once
/// The traits: CGAL's kernel with signum's predicates. Laws 1 and 2 of ../cgal.hpp.

#include <concepts>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>
#include <CGAL/enum.h>

#include <signum/predicates/ccw.hpp>
#include <signum/predicates/power.hpp>
#include <signum/predicates/space.hpp>
#include "points.hpp"
#include "signs.hpp"

namespace signum::cgal {

namespace details {

/// A predicate of the kernel's that takes some P..., answered as one of ours; its others stay.
template <class Theirs, class... P>
struct Orientation : Theirs {
    using Theirs::operator();
    CGAL::Orientation operator()(const P&... points) const {
        return sign_cast<CGAL::Orientation>(turn(points...));
    }
};
template <class Theirs, class... P>
struct Compare_distance : Theirs {
    using Theirs::operator();
    CGAL::Comparison_result operator()(const P&... points) const {
        return sign_cast<CGAL::Comparison_result>(-power::nearer_decision(ours(points)...).sign);
    }
};
template <class Theirs, class... P>
struct Side_of_circle : Theirs {
    CGAL::Oriented_side operator()(const P&... points) const {
        return sign_cast<CGAL::Oriented_side>(side_of_circle(points...));
    }
};
template <class Theirs, class... P>
struct Side_of_sphere : Theirs {
    CGAL::Oriented_side operator()(const P&... points) const {
        return sign_cast<CGAL::Oriented_side>(side_of_sphere(points...));
    }
};

template <class K>
struct Power_side_of_oriented_power_circle_2 : K::Power_side_of_oriented_power_circle_2 {
    using Site_2 = typename K::Weighted_point_2;
    CGAL::Oriented_side operator()(const Site_2& p, const Site_2& q, const Site_2& r,
                                   const Site_2& t) const {
        return sign_cast<CGAL::Oriented_side>(side_of_circle(p, q, r, t));
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
struct Coplanar_side_of_bounded_circle_3 : K::Coplanar_side_of_bounded_circle_3 {
    using Point_3 = typename K::Point_3;
    CGAL::Bounded_side operator()(const Point_3& p, const Point_3& q, const Point_3& r,
                                  const Point_3& t) const {
        return sign_cast<CGAL::Bounded_side>(conflict_in_plane(ours(p), ours(q), ours(r), ours(t)));
    }
};

template <class K>
struct Power_side_of_oriented_power_sphere_3 : K::Power_side_of_oriented_power_sphere_3 {
    using Site_3 = typename K::Weighted_point_3;
    CGAL::Oriented_side operator()(const Site_3& p, const Site_3& q, const Site_3& r,
                                   const Site_3& s, const Site_3& t) const {
        return sign_cast<CGAL::Oriented_side>(side_of_sphere(p, q, r, s, t));
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

}  // namespace details

/// The traits: CGAL::Delaunay_triangulation_2<signum::cgal::Traits<>>, and so on. Points are those
/// of the kernel.
template <class Kernel = CGAL::Exact_predicates_inexact_constructions_kernel>
class Traits : public Kernel {
    static_assert(
        std::same_as<typename Kernel::FT, double>,
        "signum's predicates take doubles: Exact_predicates_inexact_constructions_kernel");

    using P2 = typename Kernel::Point_2;
    using W2 = typename Kernel::Weighted_point_2;
    using P3 = typename Kernel::Point_3;
    using W3 = typename Kernel::Weighted_point_3;

 public:
    using Orientation_2 = details::Orientation<typename Kernel::Orientation_2, P2, P2, P2>;
    using Side_of_oriented_circle_2 =
        details::Side_of_circle<typename Kernel::Side_of_oriented_circle_2, P2, P2, P2, P2>;
    using Compare_distance_2 =
        details::Compare_distance<typename Kernel::Compare_distance_2, P2, P2, P2>;
    using Power_side_of_oriented_power_circle_2 =
        details::Power_side_of_oriented_power_circle_2<Kernel>;
    using Compare_power_distance_2 =
        details::Compare_distance<typename Kernel::Compare_power_distance_2, P2, W2, W2>;
    using Orientation_3 = details::Orientation<typename Kernel::Orientation_3, P3, P3, P3, P3>;
    using Coplanar_orientation_3 = details::Coplanar_orientation_3<Kernel>;
    using Side_of_oriented_sphere_3 =
        details::Side_of_sphere<typename Kernel::Side_of_oriented_sphere_3, P3, P3, P3, P3, P3>;
    using Coplanar_side_of_bounded_circle_3 = details::Coplanar_side_of_bounded_circle_3<Kernel>;
    using Compare_distance_3 =
        details::Compare_distance<typename Kernel::Compare_distance_3, P3, P3, P3>;
    using Power_side_of_oriented_power_sphere_3 =
        details::Power_side_of_oriented_power_sphere_3<Kernel>;
    using Compare_power_distance_3 =
        details::Compare_distance<typename Kernel::Compare_power_distance_3, P3, W3, W3>;

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
