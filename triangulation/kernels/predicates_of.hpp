#pragma once
/// The predicates of a metric, by its type: what lets one text ask all of them.

#include <array>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/additive.hpp"
#include "../../predicates/arithmetic.hpp"
#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/supremum.hpp"
#include "../metric.hpp"

namespace signum::triangulation {

/// For sites as a tessellation keeps them, whose third numbers are what `weight_is` says:
///   in_circle  a decision without the tie rule, 0 where q touches; `ranks` of i, j, k and q
///   nearer     whether a point is nearer to a than to b, ties going to the first in the tie rule's
///              order
/// and with additive weights `Perturbed`, all of them under the tie rule. A metric without its own
/// does not compile.
template <class Metric, WeightIs weight_is = WeightIs::radius>
struct PredicatesOf;

/// S: power::Site or Site.
template <power::PowerSite S>
struct PowerPredicates {
    using SiteType = S;
    [[nodiscard]] static S site(const Site& given) noexcept { return {given.x, given.y, given.r}; }
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& /*ranks*/) noexcept {
        return power::in_circle_decision(site(i), site(j), site(k), site(q));
    }
    [[nodiscard]] static bool nearer(Point point, const Site& a, Index a_index, const Site& b,
                                     Index b_index) noexcept {
        const Sign sign = power::nearer(point, site(a), site(b));
        return sign != 0 ? sign > 0 : power::precedes(site(a), a_index, site(b), b_index);
    }
};
template <>
struct PredicatesOf<Power, WeightIs::radius> : PowerPredicates<Site> {};
template <>
struct PredicatesOf<Power, WeightIs::weight> : PowerPredicates<power::Site> {};

/// Rule: the predicates of a metric under the tie rule.
template <class Rule>
struct NearerUnder {
    [[nodiscard]] static bool nearer(Point point, const Site& a, Index a_index, const Site& b,
                                     Index b_index) noexcept {
        const auto ranks = additive::ranks_of<2>({&a, &b}, {a_index, b_index});
        return Rule::nearer(point, a, b, ranks).sign > 0;
    }
};

template <>
struct PredicatesOf<Euclidean> : NearerUnder<euclidean::Perturbed<>> {
    template <Arithmetic arithmetic = Arithmetic::exact>
    using Perturbed = euclidean::Perturbed<arithmetic>;
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        return euclidean::in_circle_decision(i, j, k, q, ranks);
    }
};

template <class DirectionsOfSides>
struct RectangularPredicates : NearerUnder<rectangular::Perturbed<DirectionsOfSides>> {
    using Directions = DirectionsOfSides;
    template <Arithmetic arithmetic = Arithmetic::exact>
    using Perturbed = rectangular::Perturbed<Directions, arithmetic>;
    [[nodiscard]] static Decision in_circle(const Site& i, const Site& j, const Site& k,
                                            const Site& q,
                                            const std::array<Index, 4>& ranks) noexcept {
        return rectangular::in_circle_decision<Directions>(i, j, k, q, ranks);
    }
};
template <>
struct PredicatesOf<Manhattan> : RectangularPredicates<rectangular::Manhattan> {};
template <>
struct PredicatesOf<Supremum> : RectangularPredicates<rectangular::Supremum> {};

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
        return Predicates::in_circle(*i, *j, *k, *q, ranks).sign == 0;
    });
}

}  // namespace signum::triangulation
