#include <type_traits>

#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/ladder/ladder.hpp"
#include "../../predicates/power.hpp"
#include "vertex_of_face.hpp"

namespace signum::triangulation {
namespace {

using exact::Rational;
using exact::to_rational;
using filters::magnitude;

/// The point at equal power distance from i, j and k, for any type of number. b and c are the rows
/// of j and k relative to i: the point minus the centre of i solves b·p = h_b/2, c·p = h_c/2.
template <class Number>
struct Centre {
    Number x;
    Number y;
    Number square;  // |p|²

    Centre(const power::Row<Number>& b, const power::Row<Number>& c) {
        const Number h_b = b.x * b.x + b.y * b.y - b.weight;
        const Number h_c = c.x * c.x + c.y * c.y - c.weight;
        const Number area = b.x * c.y - c.x * b.y;
        const Number twice = area + area;
        x = Number((h_b * c.y - h_c * b.y) / twice);
        y = Number((h_c * b.x - h_b * c.x) / twice);
        square = x * x + y * y;
    }
};

template <power::PowerSite S>
power::Row<filters::Bounded> bounded_row(const S& m, const S& origin) {
    const auto row = power::row<predicates::ladder::Refined>(m, origin);
    // The product of a radius row commits one rounding.
    return {filters::Bounded::exactly(row.x),
            filters::Bounded::exactly(row.y),
            {row.weight, 0x1p-101 * magnitude(row.weight.high)}};
}

filters::Bounded weight_of(const power::Site& s) {
    return filters::Bounded::exactly(s.w);
}
filters::Bounded weight_of(const Site& s) {
    return filters::Bounded::exactly(s.r) * filters::Bounded::exactly(s.r);
}
Rational rational_weight(const power::Site& s) {
    return to_rational(s.w);
}
Rational rational_weight(const Site& s) {
    return Rational(to_rational(s.r) * to_rational(s.r));
}

template <power::PowerSite S>
DiagramVertex exact_vertex(const S& i, const S& j, const S& k) {
    using Exactly = predicates::ladder::Exactly<Arithmetic::multiprecision>;
    const auto b = power::row<Exactly>(j, i);
    const auto c = power::row<Exactly>(k, i);
    if (b.x * c.y == c.x * b.y) return no_vertex();  // a flat face that inexact arithmetic made
    const Centre<Rational> centre(b, c);
    return {exact::round_to_double(Rational(centre.x + to_rational(i.x))),
            exact::round_to_double(Rational(centre.y + to_rational(i.y))),
            exact::round_to_double(Rational(centre.square - rational_weight(i)))};
}

/// The point of equal power distance.
template <power::PowerSite S>
DiagramVertex vertex(const S& i, const S& j, const S& k) {
    constexpr int window = power::InCircle::window;
    const auto holds = [](const auto&... sites) {
        return (predicates::ladder::in_window<window>(sites) && ...);
    };
    if (holds(i, j, k)) {
        const Centre<filters::Bounded> centre(bounded_row(j, i), bounded_row(k, i));
        const auto x = (centre.x + filters::Bounded::exactly(i.x)).rounded();
        const auto y = (centre.y + filters::Bounded::exactly(i.y)).rounded();
        const auto rho = (centre.square - weight_of(i)).rounded();
        if (x && y && rho) return {*x, *y, *rho};
    }
    return exact_vertex(i, j, k);
}

}  // namespace

template <>
DiagramVertex vertex_of_face<Power>(const std::array<const Site*, 3>& sites, const Face& /*face*/,
                                    WeightIs weight_is) {
    const auto of = [&]<class S>(std::type_identity<S>) {
        const auto site = [](const Site* s) -> S { return {s->x, s->y, s->r}; };
        return vertex(site(sites[0]), site(sites[1]), site(sites[2]));
    };
    return weight_is == WeightIs::weight ? of(std::type_identity<power::Site>{})
                                         : of(std::type_identity<Site>{});
}

}  // namespace signum::triangulation
