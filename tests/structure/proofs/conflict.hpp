#pragma once
/// The filters that compare A with L √Γ.

#include "../../../predicates/euclidean/filter.hpp"
#include "filter.hpp"

namespace signum::proofs {

/// A - L √Γ, in doubles a - l s, is compared times s with e (of_a m s + of_root |l| g²).
///
/// With |A| <= m, |L| <= t, 0 <= Γ <= g², t g <= m and the relative errors of what is computed:
///     |s - √Γ| <= R g² / s      as |√a - √b| <= |a - b| / √a, and √Γ <= (1 + e) s + 2^-23 g
///     |l s - L √Γ| <= |l| |s - √Γ| + |l - L| √Γ
/// and the roundings of product and difference. Divided by m and multiplied by s/g, with
/// S = s/g, T = t g / m and P = |l|/t, the error has one part with the factor S and one with the
/// factor P T, of which each is to be less than its part of the bound.
struct RootedConflict {
    const char* name;
    Expression a;
    Expression l;
    Expression gamma;
    /// m, t and g.
    Expression size_of_a;
    Expression size_of_l;
    Expression root_of_gamma_size;
    int of_a;
    int of_root;
    /// As it is computed from exact l and s.
    Expression bound;
};

inline Margin prove(Scripts& scripts, const RootedConflict& conflict) {
    const std::string name = conflict.name;
    const Polynomial& g = conflict.root_of_gamma_size.magnitude();
    const auto covers = [](const Polynomial& value, const Polynomial& size) {
        const long double times = share(value, size);
        return times >= 0 && times <= 1;
    };
    if (!covers(conflict.a.magnitude(), conflict.size_of_a.magnitude()) ||
        !covers(conflict.l.magnitude(), conflict.size_of_l.magnitude()) ||
        !covers(conflict.gamma.magnitude(), g * g))
        throw std::logic_error(name + ": a size is less than the magnitude");

    const std::string e = written(rounding);
    const std::string of_gamma = written(conflict.gamma.error());
    const Units root_error = conflict.gamma.error() + rounding + 4096;
    scripts.write(name + "-root", "The error of the root, times s and divided by g squared.",
                  {of_gamma + " * (1 + " + e + ") + " + e + " * (1 + 2 * " + e + ") * (1 + " +
                   of_gamma + ") * (1 + 4 * " + e + ") - " + written(root_error) + " <= 0"});
    scripts.write(name + "-small-root", "The root of the error of what is under the root.",
                  {of_gamma + " - 1b-46 <= 0"});
    const std::string bound = " * (1 - " + written(conflict.bound.error()) + ") * (1 - " + e + ")";
    const std::string of_a = written(conflict.a.error());
    const std::string in_range = "S in [0, 1025b-10] /\\ T in [0, 1] /\\ P in [0, 1025b-10] -> ";
    scripts.write(name + "-with-root", "The part with the factor S.",
                  {in_range + of_a + " + " + written(conflict.l.error()) + " * T * ((1 + " + e +
                   ") * S + 1b-23) + " + e + " * P * T * S + " + e + " * (1 + " + of_a +
                   " + P * T * S * (1 + " + e + ")) - " + std::to_string(conflict.of_a) + " * " +
                   e + bound + " <= 0"});
    scripts.write(name + "-of-root", "The part with the factor P T.",
                  {written(root_error) + " - " + std::to_string(conflict.of_root) + " * " + e +
                   bound + " <= 0"});
    const auto roundings = [](Units error) {
        return static_cast<double>(error) / static_cast<double>(rounding);
    };
    const double proved = roundings(conflict.a.error()) + roundings(conflict.l.error()) + 3;
    return {roundings(conflict.a.error()),
            std::min(conflict.of_a / proved, conflict.of_root / roundings(root_error))};
}

/// Exact in the bound: what the filter computed before.
inline Expression given() {
    return Expression(9001.0);
}

inline RootedConflict euclidean_in_circle() {
    using namespace euclidean::filter;
    const TripleOf<Expression> t(input<Site>(1), input<Site>(2), input<Site>(3));
    const DifferenceOf<Expression> c(input<Site>(4), input<Site>(1));
    const ConflictOf<Expression> conflict(t, c);
    const Expression m = ConflictOf<Expression>::size_of_a(t, c);
    const Expression g = ConflictOf<Expression>::root_of_gamma_size(t);
    return {"euclidean_in_circle",
            conflict.a,
            conflict.l,
            conflict.gamma,
            m,
            t.l_jk * c.l,
            g,
            conflict_error_of_a,
            conflict_error_of_root,
            bound_of_conflict(m, given(), g, given())};
}

inline RootedConflict euclidean_in_circle_infinite() {
    using namespace euclidean::filter;
    const DifferenceOf<Expression> u(input<Site>(2), input<Site>(1));
    const DifferenceOf<Expression> w(input<Site>(3), input<Site>(1));
    const InfiniteConflictOf<Expression> conflict(u, w);
    return {"euclidean_in_circle_infinite",
            conflict.t,
            conflict.cross,
            u.p,
            u.l * u.l * w.l,
            u.l * w.l,
            u.l,
            infinite_error_of_t,
            infinite_error_of_root,
            bound_of_infinite_conflict(u.l, w.l, given(), given())};
}

}  // namespace signum::proofs
