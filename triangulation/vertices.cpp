#include <signum/triangulation/vertices.hpp>

#include <limits>
#include <optional>

#include <signum/exact/floating_environment.hpp>
#include <signum/exact/multiprecision.hpp>
#include <signum/filters/double_double.hpp>
#include <signum/predicates/power/cold_rows.hpp>

namespace signum {
namespace triangulation {
namespace {

using exact::Rational;
using exact::to_rational;
using filters::DoubleDouble;
using filters::magnitude;

/// A number in double-double and a bound on its error.
///
/// Laws: the bound covers the errors of the operands and those of the operation, 2^-102 relative
/// (double_double.hpp) and 2^-100 for a quotient; its own roundings, far fewer than 100 along any
/// path, are paid by the last factor of `slack`.
struct Bounded {
    DoubleDouble value;
    double error;

    static constexpr double slack = 0x1.01p0;
    [[nodiscard]] double size() const noexcept { return magnitude(value.high); }

    friend Bounded operator+(const Bounded& a, const Bounded& b) noexcept {
        return {a.value + b.value, slack * (a.error + b.error + 0x1p-102 * (a.size() + b.size()))};
    }
    friend Bounded operator-(const Bounded& a, const Bounded& b) noexcept {
        return a + Bounded{{-b.value.high, -b.value.low}, b.error};
    }
    friend Bounded operator*(const Bounded& a, const Bounded& b) noexcept {
        return {a.value * b.value, slack * (a.error * (b.size() + b.error) + a.size() * b.error +
                                            0x1p-102 * a.size() * b.size())};
    }
    /// Infinite error where the divisor may be 0.
    friend Bounded operator/(const Bounded& a, const Bounded& b) noexcept {
        const double least = b.size() * (1.0 - 0x1p-50) - b.error;
        if (!(least > 0.0)) return {{0.0, 0.0}, std::numeric_limits<double>::infinity()};
        const double first = a.value.high / b.value.high;
        const DoubleDouble rest = a.value - DoubleDouble{first, 0.0} * b.value;
        const TwoTerms sum = two_sum(first, rest.high / b.value.high);
        const double quotient = magnitude(sum.high);
        return {{sum.high, sum.low},
                slack * ((a.error + quotient * b.error) / least + 0x1p-100 * quotient)};
    }

    /// The double nearest to the number, if all that the bound allows rounds to the same.
    [[nodiscard]] std::optional<double> rounded() const noexcept {
        const double below = value.high + (value.low - 2.0 * error);
        const double above = value.high + (value.low + 2.0 * error);
        // The inner sums may err by an ulp of the tail, less than the error again unless that is 0.
        if (below != above || !(magnitude(below) > 0x1p-900 || (below == 0.0 && error == 0.0)))
            return std::nullopt;
        return below;
    }
};

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

Bounded exactly(const DoubleDouble& value) {
    return {value, 0.0};
}

template <power::PowerSite S>
power::Row<Bounded> bounded_row(const S& m, const S& origin) {
    const auto row = power::cold::double_double_row(m, origin);
    // The product of a radius row commits one rounding.
    return {exactly(row.x), exactly(row.y), {row.weight, 0x1p-101 * magnitude(row.weight.high)}};
}

Bounded weight_of(const power::Site& s) {
    return exactly({s.w, 0.0});
}
Bounded weight_of(const Site& s) {
    return exactly({s.r, 0.0}) * exactly({s.r, 0.0});
}
Rational rational_weight(const power::Site& s) {
    return to_rational(s.w);
}
Rational rational_weight(const Site& s) {
    return Rational(to_rational(s.r) * to_rational(s.r));
}

template <power::PowerSite S>
DiagramVertex exact_vertex(const S& i, const S& j, const S& k) {
    const auto row = [&i](const S& m) -> power::Row<Rational> {
        return {to_rational(m.x) - to_rational(i.x), to_rational(m.y) - to_rational(i.y),
                rational_weight(m) - rational_weight(i)};
    };
    const Centre<Rational> centre(row(j), row(k));
    return {exact::round_to_double(Rational(centre.x + to_rational(i.x))),
            exact::round_to_double(Rational(centre.y + to_rational(i.y))),
            exact::round_to_double(Rational(centre.square - rational_weight(i)))};
}

template <power::PowerSite S>
DiagramVertex vertex(const S& i, const S& j, const S& k) {
    if (power::cold::in_window(i, j, k)) {
        const Centre<Bounded> centre(bounded_row(j, i), bounded_row(k, i));
        const auto x = (centre.x + exactly({i.x, 0.0})).rounded();
        const auto y = (centre.y + exactly({i.y, 0.0})).rounded();
        const auto rho = (centre.square - weight_of(i)).rounded();
        if (x && y && rho) return {*x, *y, *rho};
    }
    return exact_vertex(i, j, k);
}

template <power::PowerSite S>
DiagramVertex vertex_of(const Tessellation& t, const Face& face) {
    const auto site = [&](int k) {
        const Site& s = t.sites()[static_cast<std::size_t>(face[static_cast<std::size_t>(k)])];
        return S{s.x, s.y, s.r};
    };
    return vertex(site(0), site(1), site(2));
}

}  // namespace
}  // namespace triangulation

std::vector<DiagramVertex> vertices(const Tessellation& tessellation) {
    using namespace triangulation;
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const exact::IeeeEnvironment environment;
    std::vector<DiagramVertex> result;
    result.reserve(tessellation.faces().size());
    for (const Face& face : tessellation.faces()) {
        if (face[0] == infinite) {
            result.push_back({nan, nan, nan});
        } else if (tessellation.weight_is() == WeightIs::weight) {
            result.push_back(vertex_of<power::Site>(tessellation, face));
        } else {
            result.push_back(vertex_of<Site>(tessellation, face));
        }
    }
    return result;
}

}  // namespace signum
