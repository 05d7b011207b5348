#include "margin.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../predicates/additive.hpp"
#include "../../predicates/formulas/apollonius.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/rectangular/squares.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "../../triangulation/structure/corners.hpp"

namespace signum::study {
namespace {

using exact::Rational;

/// A determinant's absolute value and what its terms add up to.
template <class Number>
struct Sum {
    Number value;
    Number magnitude;
};

// Doubles are trusted where they leave two digits: rounding errors stay below a hundred times 2^-53
// of the magnitude, underflow far below 2^-900.
bool is_certain(const Sum<double>& sum) {
    return sum.magnitude > 0x1p-800 && sum.magnitude < 0x1p1000 &&
           sum.value > 0x1p-40 * sum.magnitude;
}

double margin(const Sum<double>& sum) {
    return sum.value / sum.magnitude;
}
double margin(const Sum<Rational>& sum) {
    return exact::round_to_double(Rational(sum.value / sum.magnitude));
}

template <class Number>
Number number(double value) {
    if constexpr (std::is_same_v<Number, Rational>) {
        return exact::to_rational(value);
    } else {
        return value;
    }
}

template <class Number>
Number difference(double a, double b) {
    return number<Number>(a) - number<Number>(b);
}

template <class Number>
Number absolute(const Number& value) {
    return value < 0 ? Number(-value) : value;
}

// ---- power -------------------------------------------------------------------------------------

template <class Number>
Number weight_difference(const Site& m, const Site& q, WeightIs weight_is) {
    if (weight_is == WeightIs::weight) return difference<Number>(m.r, q.r);
    return difference<Number>(m.r, q.r) * (number<Number>(m.r) + number<Number>(q.r));
}

template <class Number>
Sum<Number> power_sum(const std::array<const Site*, 4>& sites, WeightIs weight_is) {
    power::Row<Number> row[3];
    for (std::size_t m = 0; m < 3; ++m)
        row[m] = {difference<Number>(sites[m]->x, sites[3]->x),
                  difference<Number>(sites[m]->y, sites[3]->y),
                  weight_difference<Number>(*sites[m], *sites[3], weight_is)};
    Number magnitude = 0;
    for (std::size_t m = 0; m < 3; ++m) {
        const auto& a = row[m];
        const auto& b = row[(m + 1) % 3];
        const auto& c = row[(m + 2) % 3];
        const Number height = a.x * a.x + a.y * a.y + absolute(a.weight);
        magnitude += height * (absolute(Number(b.x * c.y)) + absolute(Number(c.x * b.y)));
    }
    return {absolute(Number(power::in_circle_determinant(row[0], row[1], row[2]))), magnitude};
}

// ---- Euclidean ---------------------------------------------------------------------------------

/// A product, or a sum of them, and the same of absolute values.
template <class Number>
struct Term {
    Number value;
    Number magnitude;

    explicit Term(Number v) : value(v), magnitude(absolute(v)) {}
    Term(Number v, Number m) : value(std::move(v)), magnitude(std::move(m)) {}

    friend Term operator*(const Term& a, const Term& b) {
        return {Number(a.value * b.value), Number(a.magnitude * b.magnitude)};
    }
    friend Term operator+(const Term& a, const Term& b) {
        return {Number(a.value + b.value), Number(a.magnitude + b.magnitude)};
    }
    friend Term operator-(const Term& a, const Term& b) {
        return {Number(a.value - b.value), Number(a.magnitude + b.magnitude)};
    }
};

/// The terms A, L and Γ of predicates/formulas/apollonius.hpp.
template <class Number>
struct Apollonius {
    Term<Number> a;
    Term<Number> l;
    Term<Number> gamma;
};

template <class Number>
Apollonius<Number> apollonius(const std::array<const Site*, 4>& sites) {
    using T = Term<Number>;
    using Degrees = euclidean::Uniform<T>;
    const auto row = [](const Site& m, const Site& from) -> euclidean::polynomials::Row<Degrees> {
        return {T(difference<Number>(m.x, from.x)), T(difference<Number>(m.y, from.y)),
                T(difference<Number>(m.r, from.r))};
    };
    const auto& [i, j, k, q] = sites;
    const euclidean::polynomials::Minors<Degrees> minors(row(*j, *i), row(*k, *i));
    const auto row_q = row(*q, *i);
    return {minors.a(row_q), minors.l(row_q), minors.j.p * minors.k.p * row(*k, *j).p};
}

Sum<double> rounded_euclidean_sum(const std::array<const Site*, 4>& sites) {
    const Apollonius<double> t = apollonius<double>(sites);
    const double root = std::sqrt(std::max(t.gamma.value, 0.0));
    return {std::abs(t.a.value - t.l.value * root), t.a.magnitude + t.l.magnitude * root};
}

/// Where A and L √Γ nearly cancel, their difference is (A² - L² Γ) / (A + L √Γ). In units of A's
/// magnitude M, so that no double overflows.
double euclidean_margin(const std::array<const Site*, 4>& sites) {
    const Apollonius<Rational> t = apollonius<Rational>(sites);
    const Rational& m = t.a.magnitude;
    if (m.is_zero()) return 0.0;
    const double a = exact::round_to_double(Rational(t.a.value / m));
    const auto root_of = [&](const Rational& l) {
        return std::sqrt(exact::round_to_double(Rational(l * l * t.gamma.value / (m * m))));
    };
    const double root = root_of(t.l.value);
    const double whole = 1.0 + root_of(t.l.magnitude);
    if ((t.a.value.sign() < 0) != (t.l.value.sign() < 0)) return (std::abs(a) + root) / whole;
    const Rational resultant = t.a.value * t.a.value - t.l.value * t.l.value * t.gamma.value;
    return exact::round_to_double(Rational(absolute(resultant) / (m * m))) /
           ((std::abs(a) + root) * whole);
}

// ---- supremum and Manhattan --------------------------------------------------------------------

/// How far q, the last of the four, stays outside the square of the others, at the side where it
/// does so most; the magnitude is the size of all numbers that the side and q bring in.
template <class Directions, class Number>
Sum<Number> rectangular_sum(const std::array<const Site*, 4>& sites,
                            const rectangular::Touching& square) {
    const auto form = [&](int side, std::size_t m) -> Number {
        const auto d = static_cast<std::size_t>(side);
        const Site& s = *sites[m];
        return number<Number>(Directions::x[d]) * number<Number>(s.x) +
               number<Number>(Directions::y[d]) * number<Number>(s.y) - number<Number>(s.r);
    };
    const auto side = [&](int turn) { return (square.open + turn) & 3; };
    const auto at = [&](int turn) { return square.site[static_cast<std::size_t>(side(turn))]; };
    const Number pinned[4] = {form(side(1), at(1)) + form(side(3), at(3)) - form(side(2), at(2)),
                              form(side(1), at(1)), form(side(2), at(2)), form(side(3), at(3))};
    Number gap = pinned[0] - form(side(0), 3);
    for (int turn = 1; turn < 4; ++turn)
        gap = std::min(gap, Number(pinned[turn] - form(side(turn), 3)));
    Number magnitude = 0;
    for (const Site* s : sites)
        magnitude += absolute(number<Number>(s->x)) + absolute(number<Number>(s->y)) +
                     absolute(number<Number>(s->r));
    return {absolute(gap), magnitude};
}

// ---- all ---------------------------------------------------------------------------------------

/// A call of in_circle: the sites of a face and the one across an edge.
struct CallInCircle {
    const Tessellation& tessellation;
    std::array<Index, 4> numbers;
    std::array<const Site*, 4> sites;
};

bool is_tie(const CallInCircle& call) {
    return triangulation::touches(call.tessellation.metric(), call.tessellation.weight_is(),
                                  call.sites, call.numbers);
}

double margin_in(Power /*metric*/, const CallInCircle& call) {
    const WeightIs weight_is = call.tessellation.weight_is();
    const auto fast = power_sum<double>(call.sites, weight_is);
    if (is_certain(fast)) return margin(fast);
    return is_tie(call) ? 0.0 : margin(power_sum<Rational>(call.sites, weight_is));
}

double margin_in(Euclidean /*metric*/, const CallInCircle& call) {
    const auto fast = rounded_euclidean_sum(call.sites);
    if (is_certain(fast)) return margin(fast);
    return is_tie(call) ? 0.0 : euclidean_margin(call.sites);
}

template <triangulation::Rectangular M>
double margin_in(M /*metric*/, const CallInCircle& call) {
    using Directions = typename triangulation::PredicatesOf<M>::Directions;
    if (is_tie(call)) return 0.0;
    rectangular::Forms<Directions, Arithmetic::exact, 4> forms(
        call.sites, additive::ranks_of<4>(call.sites, call.numbers));
    const rectangular::Touching square = rectangular::touching(forms);
    const auto fast = rectangular_sum<Directions, double>(call.sites, square);
    return is_certain(fast) ? margin(fast)
                            : margin(rectangular_sum<Directions, Rational>(call.sites, square));
}

/// The margin of the last of the four against the face of the others.
double margin_of(const Tessellation& t, const std::array<Index, 4>& numbers) {
    CallInCircle call = {t, numbers, {}};
    for (std::size_t m = 0; m < 4; ++m)
        call.sites[m] = &t.sites()[static_cast<std::size_t>(numbers[m])];
    return with_metric(t.metric(), [&]<class M>(M metric) {
        // Of equal radii such a metric asks what the power metric does.
        if constexpr (M::traits.is_delaunay_for_equal_radii)
            if (std::ranges::all_of(call.sites, [&](auto* s) { return s->r == call.sites[0]->r; }))
                return margin_in(Power{}, call);
        return margin_in(metric, call);
    });
}

void add(Margins& margins, double margin) {
    ++margins.edges;
    if (margin == 0.0) {
        ++margins.ties;
        return;
    }
    if (!margins.least || margin < *margins.least) margins.least = margin;
    const auto last = static_cast<double>(margins.powers.size() - 1);
    const double power = std::clamp(std::floor(-std::log10(margin)), 0.0, last);
    ++margins.powers[static_cast<std::size_t>(power)];
}

}  // namespace

std::vector<std::array<Index, 4>> inner_edges(const Tessellation& tessellation) {
    std::vector<std::array<Index, 4>> result;
    const auto faces = tessellation.faces();
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (faces[f][0] == infinite) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto g = static_cast<std::size_t>(tessellation.neighbours()[f][k]);
            if (g < f || faces[g][0] == infinite) continue;
            const auto corner =
                triangulation::across(tessellation.arrays(), {static_cast<Index>(f), k});
            const Index q = faces[g][corner.place];
            // Two sites with two edges and one site between them: nothing is asked.
            if (std::ranges::find(faces[f], q) == faces[f].end())
                result.push_back({faces[f][0], faces[f][1], faces[f][2], q});
        }
    }
    return result;
}

std::vector<std::array<Index, 5>> inner_facets(const SpaceTessellation& tessellation) {
    std::vector<std::array<Index, 5>> result;
    if (tessellation.dimension < 3) return result;
    for (std::size_t c = 0; c < tessellation.cells.size(); ++c) {
        const SpaceCell& cell = tessellation.cells[c];
        if (cell[0] == infinite) continue;
        for (const Index n : tessellation.neighbours[c]) {
            const SpaceCell& other = tessellation.cells[static_cast<std::size_t>(n)];
            if (static_cast<std::size_t>(n) < c || other[0] == infinite) continue;
            const auto across = std::ranges::find_if(
                other, [&](Index v) { return std::ranges::find(cell, v) == cell.end(); });
            if (across != other.end())
                result.push_back({cell[0], cell[1], cell[2], cell[3], *across});
        }
    }
    return result;
}

Margins margins_of(const Tessellation& canonical, int threads) {
    const std::vector<std::array<Index, 4>> calls = inner_edges(canonical);
    const Workers workers(threads, calls.size());
    std::vector<double> each;
    make_room(workers, calls.size(), each);
    workers.each_range(calls.size(), [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        for (std::size_t i = begin; i < end; ++i) each[i] = margin_of(canonical, calls[i]);
    });
    Margins margins;
    for (const double margin : each) add(margins, margin);
    return margins;
}

}  // namespace signum::study
