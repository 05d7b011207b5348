#pragma once
/// The predicates of a metric, of the plane and of space, by its type and by names that all metrics
/// share: what lets one text ask all of them, whether algorithm, tool or binding.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/interval.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/additive.hpp"
#include "../../predicates/arithmetic.hpp"
#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/supremum.hpp"
#include "../metric.hpp"

namespace signum::triangulation {

using filters::Interval;

/// Of sites whose third numbers are what `weight_is` says. What users call, as
/// predicates/additive.hpp describes it:
///   exists, in_circle, in_circle_infinite, hidden, nearer
///   in_circle_perturbed, in_circle_infinite_perturbed
/// For sites as a tessellation keeps them:
///   in_circle_decision  without the tie rule, 0 where q touches; `ranks` of i, j, k and q
///   is_nearer           whether a point is nearer to a than to b, ties going to the first in the
///                       tie rule's order
/// With additive weights:
///   Perturbed           all predicates under the tie rule, in an arithmetic
///   in_circle_of_any    in_circle_decision where i, j or k may hide q
///   norm                an interval around the length of a vector, from its coordinates'
///                       absolute values
/// And InSpace, those of space:
///   are_numbered        whether four sites may have several spheres; else n is 0
///   spheres             how many touch i, j, k and l, or infinitely_many
///   in_sphere_decision  of q in number n of them, which is there
///   hidden              whether i alone hides q
///   hides_decision      with additive weights the same, and who decided
/// A metric without its own does not compile.
template <class Metric, WeightIs weight_is = WeightIs::radius>
struct PredicatesOf;

/// For PredicatesOf::InSpace.
inline constexpr int infinitely_many = 1000;

// ---- power -------------------------------------------------------------------------------------

/// S: power::Site3 or Site3. A sphere touches sites that turn positively.
template <power::PowerSite3 S>
struct PowerInSpace {
    using SiteType = S;
    static constexpr bool are_numbered = false;
    [[nodiscard]] static int spheres(const S& i, const S& j, const S& k, const S& l) noexcept {
        return static_cast<int>(ccw(i, j, k, l) > 0);
    }
    [[nodiscard]] static Decision in_sphere_decision(const S& i, const S& j, const S& k, const S& l,
                                                     const S& q, std::uint8_t /*n*/) noexcept {
        return power::in_sphere_decision(i, j, k, l, q);
    }
    /// Only where the centres agree and i weighs no less.
    [[nodiscard]] static bool hidden(const S& q, const S& i) noexcept {
        return filters::same_number(q.x, i.x) && filters::same_number(q.y, i.y) &&
               filters::same_number(q.z, i.z) &&
               power::nearer_decision(Point3{q.x, q.y, q.z}, q, i).sign <= 0;
    }
};

/// S and S3: power::Site and power::Site3, or Site and Site3.
template <power::PowerSite S, power::PowerSite3 S3>
struct PowerPredicates {
    using SiteType = S;
    using InSpace = PowerInSpace<S3>;
    static constexpr auto& exists = power::exists<S>;
    static constexpr auto& in_circle = power::in_circle<S>;
    static constexpr auto& in_circle_infinite = power::in_circle_infinite<S>;
    static constexpr auto& hidden = power::hidden<S>;
    static constexpr auto& nearer = power::nearer<S>;
    static constexpr auto& in_circle_perturbed = power::in_circle_perturbed<S>;
    static constexpr auto& in_circle_infinite_perturbed = power::in_circle_infinite_perturbed<S>;

    [[nodiscard]] static S site(const Site& given) noexcept { return {given.x, given.y, given.r}; }
    [[nodiscard]] static Decision in_circle_decision(
        const Site& i, const Site& j, const Site& k, const Site& q,
        const std::array<Index, 4>& /*ranks*/) noexcept {
        return power::in_circle_decision(site(i), site(j), site(k), site(q));
    }
    [[nodiscard]] static bool is_nearer(Point point, const Site& a, Index a_index, const Site& b,
                                        Index b_index) noexcept {
        const Sign sign = power::nearer(point, site(a), site(b));
        return sign != 0 ? sign > 0 : power::precedes(site(a), a_index, site(b), b_index);
    }
};
template <>
struct PredicatesOf<Power, WeightIs::radius> : PowerPredicates<Site, Site3> {};
template <>
struct PredicatesOf<Power, WeightIs::weight> : PowerPredicates<power::Site, power::Site3> {};

// ---- additive weights --------------------------------------------------------------------------

/// Rule: the predicates of a metric under the tie rule; decision: its in_circle_decision.
template <template <Arithmetic> class Rule, auto decision>
struct AdditivePredicates {
    using SiteType = Site;
    template <Arithmetic arithmetic = Arithmetic::exact>
    using Perturbed = Rule<arithmetic>;
    static constexpr auto& exists = additive::exists<Perturbed<>>;
    static constexpr auto& in_circle = additive::in_circle<decision>;
    static constexpr auto& hidden = additive::hidden<Perturbed<>>;
    static constexpr auto& nearer = additive::nearer_site<Perturbed<>>;
    static constexpr auto& in_circle_perturbed = additive::in_circle_perturbed<Perturbed<>>;
    static constexpr auto& in_circle_infinite_perturbed =
        additive::in_circle_infinite_perturbed<Perturbed<>>;

    static constexpr auto in_circle_decision = decision;
    [[nodiscard]] static bool is_nearer(Point point, const Site& a, Index a_index, const Site& b,
                                        Index b_index) noexcept {
        const auto ranks = additive::ranks_of<2>({&a, &b}, {a_index, b_index});
        return Perturbed<>::nearer(point, a, b, ranks).sign > 0;
    }
};

/// The order of the sites tells their spheres apart.
struct EuclideanInSpace {
    using SiteType = Site3;
    static constexpr bool are_numbered = false;
    [[nodiscard]] static int spheres(const Site3& i, const Site3& j, const Site3& k,
                                     const Site3& l) noexcept {
        return static_cast<int>(euclidean::exists(i, j, k, l));
    }
    [[nodiscard]] static Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k,
                                                     const Site3& l, const Site3& q,
                                                     std::uint8_t /*n*/) noexcept {
        return euclidean::in_sphere_decision(i, j, k, l, q);
    }
    static constexpr auto& hidden = euclidean::hidden<Site3>;
    static constexpr auto& hides_decision = euclidean::hides_decision;
};

template <>
struct PredicatesOf<Euclidean>
    : AdditivePredicates<euclidean::Perturbed, euclidean::in_circle_decision> {
    static constexpr auto& in_circle_infinite = euclidean::in_circle_infinite;
    using InSpace = EuclideanInSpace;
    /// A q that i, j or k hides conflicts nowhere.
    [[nodiscard]] static Decision in_circle_of_any(const Site& i, const Site& j, const Site& k,
                                                   const Site& q,
                                                   const std::array<Index, 4>& ranks) noexcept {
        using Rule = Perturbed<>;
        const bool is_hidden = Rule::hides(i, q, {ranks[0], ranks[3]}).sign > 0 ||
                               Rule::hides(j, q, {ranks[1], ranks[3]}).sign > 0 ||
                               Rule::hides(k, q, {ranks[2], ranks[3]}).sign > 0;
        return is_hidden ? Rule::in_circle(i, j, k, q, ranks)
                         : in_circle_decision(i, j, k, q, ranks);
    }
    [[nodiscard]] static Interval norm(const Interval& x, const Interval& y) noexcept {
        // The machine's square roots are off by half a unit at most; squares may underflow.
        const Interval square = x * x + y * y;
        return {std::max({std::sqrt(std::max(square.low, 0.0)) * (1.0 - 2.0 * filters::epsilon),
                          x.low, y.low}),
                std::min(std::sqrt(square.high) * (1.0 + 2.0 * filters::epsilon), (x + y).high)};
    }
};

/// Shape: what the spheres are, of which there may be several.
template <class ShapeOfSpheres>
struct RectangularInSpace {
    using SiteType = Site3;
    static constexpr bool are_numbered = true;
    using Shape = ShapeOfSpheres;
    [[nodiscard]] static int spheres(const Site3& i, const Site3& j, const Site3& k,
                                     const Site3& l) noexcept {
        const rectangular::Spheres all = rectangular::spheres<Shape>(i, j, k, l);
        return all.infinitely_many ? infinitely_many : all.count;
    }
    [[nodiscard]] static Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k,
                                                     const Site3& l, const Site3& q,
                                                     std::uint8_t n) noexcept {
        const rectangular::Spheres all = rectangular::spheres<Shape>(i, j, k, l);
        return rectangular::in_sphere_decision<Shape>(i, j, k, l, all.spheres[n], q);
    }
    static constexpr auto& hides_decision = rectangular::hides_decision<Shape>;
    [[nodiscard]] static bool hidden(const Site3& q, const Site3& i) noexcept {
        return hides_decision(i, q).sign > 0;
    }
};

template <template <Arithmetic> class Rule, class DirectionsOfSides, class ShapeOfSpheres>
struct RectangularPredicates
    : AdditivePredicates<Rule, rectangular::in_circle_decision<DirectionsOfSides>> {
    using Directions = DirectionsOfSides;
    static constexpr auto& in_circle_infinite =
        additive::in_circle_infinite<rectangular::in_circle_infinite_decision<Directions>>;
    using InSpace = RectangularInSpace<ShapeOfSpheres>;
    static constexpr auto in_circle_of_any = RectangularPredicates::in_circle_decision;
};
template <>
struct PredicatesOf<Manhattan>
    : RectangularPredicates<manhattan::Perturbed, rectangular::Manhattan, rectangular::Octahedron> {
    [[nodiscard]] static Interval norm(const Interval& x, const Interval& y) noexcept {
        return x + y;
    }
};
template <>
struct PredicatesOf<Supremum>
    : RectangularPredicates<supremum::Perturbed, rectangular::Supremum, rectangular::Cube> {
    [[nodiscard]] static Interval norm(const Interval& x, const Interval& y) noexcept {
        return filters::max(x, y);
    }
};

// ---- who asks ----------------------------------------------------------------------------------

/// Predicates of a metric with additive weights.
template <class Predicates>
concept Additive = requires {
    typename Predicates::template Perturbed<>;
};
/// A metric whose circles have four sides.
template <class Metric>
concept Rectangular = requires {
    typename PredicatesOf<Metric>::Directions;
};

/// Calls visit with the predicates of a tessellation.
template <class Visit>
decltype(auto) with_predicates(Metric metric, WeightIs weight_is, const Visit& visit) {
    return with_metric(metric, [&]<class M>(M) -> decltype(auto) {
        if constexpr (M::traits.has_weights)
            if (weight_is == WeightIs::weight) return visit(PredicatesOf<M, WeightIs::weight>{});
        return visit(PredicatesOf<M>{});
    });
}

/// Whether the last of four sites touches the circle of the others, the tie rule aside; `numbers`
/// are their places in the tessellation. Precondition: that of in_circle.
[[nodiscard]] inline bool touches(Metric metric, WeightIs weight_is,
                                  const std::array<const Site*, 4>& sites,
                                  const std::array<Index, 4>& numbers) {
    const auto ranks = additive::ranks_of<4>(sites, numbers);
    return with_predicates(metric, weight_is, [&]<class Predicates>(Predicates) {
        const auto& [i, j, k, q] = sites;
        return Predicates::in_circle_decision(*i, *j, *k, *q, ranks).sign == 0;
    });
}

}  // namespace signum::triangulation
