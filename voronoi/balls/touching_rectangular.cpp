#include "touching_rectangular.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/formulas/facets.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"

namespace signum {
namespace {

using exact::Rational;
using filters::Bounded;
using rectangular::Basis;
using rectangular::Contacts;

using Four = std::array<Site3, 4>;

/// Number k of the sphere, the radius last: times the divisor, in any numbers.
template <class Shape, class Number, class ToNumber>
[[nodiscard]] Number multiple(const Basis& basis, std::size_t k, const Four& sites,
                              const Contacts& contacts, const ToNumber& number) {
    Number sum = number(0.0);
    for (std::size_t t = 0; t < 4; ++t) {
        const int weight = basis.solution[k][t];
        if (weight == 0) continue;
        const Site3& site = sites[contacts.sites[t]];
        const auto& n = Shape::normals[contacts.facets[t]];
        Number form = -number(site.r);
        const double coordinates[] = {site.x, site.y, site.z};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (n[axis] != 0)
                form = form + (n[axis] > 0 ? number(coordinates[axis])
                                           : Number(-number(coordinates[axis])));
        sum = sum + number(weight) * form;
    }
    return sum;
}

template <class Shape>
[[nodiscard]] double rounded(const Basis& basis, std::size_t k, const Four& sites,
                             const Contacts& contacts) {
    const double divisor = basis.divisor[k];
    const auto fast =
        multiple<Shape, Bounded>(basis, k, sites, contacts,
                                 [](double number) { return Bounded::exactly(number); }) *
        Bounded::exactly(1.0 / divisor);
    if (const auto value = fast.rounded()) return *value;
    const auto exact = multiple<Shape, Rational>(basis, k, sites, contacts, exact::to_rational);
    const double value = exact::round_to_double(Rational(exact / basis.divisor[k]));
    if (!std::isnan(value)) return value;
    return exact.sign() * std::numeric_limits<double>::infinity();
}

template <class Shape>
[[nodiscard]] Site3 rounded_sphere(const Four& sites, const Contacts& contacts) {
    rectangular::FacetSet set = 0;
    for (const std::size_t facet : contacts.facets)
        set = static_cast<rectangular::FacetSet>(set | rectangular::facet_bit(facet));
    const Basis& basis = rectangular::basis_of<Shape>(set);
    const auto number = [&](std::size_t k) { return rounded<Shape>(basis, k, sites, contacts); };
    return {number(0), number(1), number(2), number(3)};
}

template <class Shape>
[[nodiscard]] RectangularSpheres touching(std::span<const Site3> sites) {
    if (sites.size() != 4) throw std::invalid_argument("touching_spheres: four sites");
    Four four;
    for (std::size_t m = 0; m < 4; ++m) {
        if (!are_finite(sites[m]))
            throw std::invalid_argument("touching_spheres: site " + std::to_string(m) +
                                        " is not finite");
        four[m] = sites[m];
    }
    const rectangular::Spheres all =
        rectangular::spheres<Shape>(four[0], four[1], four[2], four[3]);
    RectangularSpheres result{all.infinitely_many, {}};
    for (std::size_t n = 0; n < all.count; ++n)
        result.spheres.push_back(
            exact::in_ieee_environment(rounded_sphere<Shape>, four, all.spheres[n]));
    return result;
}

}  // namespace

RectangularSpheres touching_spheres(std::span<const Site3> four, Metric metric) {
    return with_metric(metric, [&]<class M>(M) -> RectangularSpheres {
        using InSpace = typename triangulation::PredicatesOf<M>::InSpace;
        if constexpr (InSpace::are_numbered) return touching<typename InSpace::Shape>(four);
        throw std::invalid_argument("touching_spheres: in the " + std::string(M::traits.title) +
                                    " metric they are balls");
    });
}

}  // namespace signum
