#include <cstddef>
#include <type_traits>

#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/rectangular/squares.hpp"
#include "vertex_of_face.hpp"

namespace signum::triangulation {
namespace {

using exact::Rational;

template <class Number>
Number number(double value) {
    if constexpr (std::is_same_v<Number, Rational>) {
        return exact::to_rational(value);
    } else {
        return filters::Bounded::exactly(value);
    }
}

/// The square that three sites touch, for any type of number.
template <class Directions, class Number>
struct Square {
    Number x;
    Number y;
    Number rho;

    Square(const rectangular::Touching& touching, const std::array<const Site*, 3>& sites) {
        Number g[4];
        const auto at = [](int side) { return static_cast<std::size_t>(side & 3); };
        for (int turn = 1; turn < 4; ++turn) {
            const std::size_t side = at(touching.open + turn);
            const Site& site = *sites[touching.site[side]];
            g[side] = number<Number>(Directions::x[side] * site.x) +
                      number<Number>(Directions::y[side] * site.y) - number<Number>(site.r);
        }
        const int open = touching.open;
        g[at(open)] = g[at(open + 1)] + g[at(open + 3)] - g[at(open + 2)];

        const Number half = number<Number>(0.5);
        const Number first = (g[0] - g[2]) * half;   // along direction 0
        const Number second = (g[1] - g[3]) * half;  // along direction 1
        constexpr bool is_upright = Directions::x[1] == 0;
        if constexpr (is_upright) {
            x = first;
            y = second;
        } else {  // u = x + y and v = y - x
            x = (first - second) * half;
            y = (first + second) * half;
        }
        rho = (g[at(open + 1)] + g[at(open + 3)]) * half;
    }
};

/// Directions: those of predicates/ladder/forms.hpp.
template <class Directions>
DiagramVertex vertex_along(const std::array<const Site*, 3>& sites, const Face& face) {
    rectangular::Forms<Directions, Arithmetic::exact, 3> forms(sites,
                                                               additive::ranks_of<3>(sites, face));
    const rectangular::Touching touching = rectangular::touching(forms);
    if (touching.open < 0) return no_vertex();

    const Square<Directions, filters::Bounded> fast(touching, sites);
    const auto x = fast.x.rounded();
    const auto y = fast.y.rounded();
    const auto rho = fast.rho.rounded();
    if (x && y && rho) return {*x, *y, *rho};
    const Square<Directions, Rational> exact(touching, sites);
    return {exact::round_to_double(exact.x), exact::round_to_double(exact.y),
            exact::round_to_double(exact.rho)};
}

}  // namespace

template <>
DiagramVertex vertex_of_face<Manhattan>(const std::array<const Site*, 3>& sites, const Face& face,
                                        WeightIs /*weight_is*/) {
    return vertex_along<rectangular::Manhattan>(sites, face);
}
template <>
DiagramVertex vertex_of_face<Supremum>(const std::array<const Site*, 3>& sites, const Face& face,
                                       WeightIs /*weight_is*/) {
    return vertex_along<rectangular::Supremum>(sites, face);
}

}  // namespace signum::triangulation
