#pragma once
/// Polynomials made to hurt, for the tests of roots/: each as a form of the library, and once more
/// in GMP's integers for the oracle.

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "../../roots/polynomial.hpp"
#include "../first_change.hpp"
#include "../oracle/real_roots.hpp"
#include "../unit/exact_reference.hpp"

namespace signum::root_forms {

using oracle::IntegerPolynomial;
using oracle::operator+;
using oracle::operator*;
using reference::Random;

/// A sum of products of lines: sum_k s_k prod_j (x_kj + v_kj t), each product of `Degree` lines.
template <int Degree>
struct SumOfProducts {
    struct Line {
        double x;
        double v;
    };
    struct Term {
        double sign;
        std::array<Line, Degree> lines;
    };
    std::array<Term, 3> terms{};

    template <class Number, std::size_t Count>
    static auto product(const std::array<Line, Degree>& lines, double origin) {
        auto last = roots::line<Number>(lines[Count - 1].x, lines[Count - 1].v);
        if (origin != 0.0) last.c[0] = last.c[0] + roots::constant<Number>(origin).c[0] * last.c[1];
        if constexpr (Count == 1) {
            return last;
        } else {
            return product<Number, Count - 1>(lines, origin) * last;
        }
    }
    template <class Number>
    [[nodiscard]] roots::PolynomialIn<Number, Degree> in(double origin = 0.0) const {
        const auto term = [&](const Term& t) {
            return roots::constant<Number>(t.sign) * product<Number, Degree>(t.lines, origin);
        };
        return term(terms[0]) + term(terms[1]) + term(terms[2]);
    }
    /// Times 2^(scale · degree) at least; every double is an integer times 2^-scale.
    [[nodiscard]] IntegerPolynomial exactly(int scale) const {
        IntegerPolynomial sum;
        for (const Term& term : terms) {
            IntegerPolynomial product{reference::scaled(term.sign, scale)};
            for (const Line& line : term.lines)
                product = product * IntegerPolynomial{reference::scaled(line.x, scale),
                                                      reference::scaled(line.v, scale)};
            sum = sum + product;
        }
        while (!sum.empty() && sum.back() == 0) sum.pop_back();
        return sum;
    }
};

enum class Kind {
    random,    ///< points of random places and velocities
    grid,      ///< small integers: ties, multiple roots, degrees that are not full
    factors,   ///< known roots, some of them equal
    clusters,  ///< known roots, an ulp apart or a little more
    nearly,    ///< known roots, and a term that is small beside it
    ranges,    ///< everything from 2^-60 to 2^60
    extremes   ///< everything from 2^-150 to 2^150
};
inline constexpr int kinds = 7;

template <int Degree>
[[nodiscard]] SumOfProducts<Degree> form_of(Kind kind, Random& random) {
    using Form = SumOfProducts<Degree>;
    Form form;
    const auto unit = [&] {
        return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random.engine()() >> 10)),
                          -53) -
               1.0 / 2;
    };
    const auto fill = [&](int terms, auto number) {
        for (int k = 0; k < terms; ++k) {
            auto& term = form.terms[static_cast<std::size_t>(k)];
            term.sign = random.coin() ? 1.0 : -1.0;
            for (auto& line : term.lines) line = {number(), number()};
        }
    };
    const auto from_roots = [&](auto root) {
        form.terms[0].sign = random.coin() ? 1.0 : -1.0;
        for (auto& line : form.terms[0].lines) line = {-root(), 1.0};
    };
    switch (kind) {
        case Kind::random:
            fill(3, unit);
            break;
        case Kind::grid:
            fill(random.between(1, 3), [&] { return static_cast<double>(random.between(-2, 2)); });
            break;
        case Kind::factors:
            from_roots([&] { return 0.25 * random.between(-6, 6); });
            break;
        case Kind::clusters: {
            const double centre = random.coin() ? 1.0 : unit();
            const int spread = random.coin() ? 2 : 1 << random.between(0, 20);
            from_roots([&] { return centre + random.between(-spread, spread) * 0x1p-52; });
            break;
        }
        case Kind::nearly: {
            from_roots([&] { return 0.5 * random.between(-3, 3); });
            auto& term = form.terms[1];
            term.sign = std::ldexp(random.coin() ? 1.0 : -1.0, -random.between(20, 140));
            for (auto& line : term.lines) line = {random.coin() ? 1.0 : unit(), 0.0};
            break;
        }
        case Kind::ranges:
            fill(3, [&] { return random.in_binades(-60, 60); });
            break;
        case Kind::extremes:
            fill(random.between(1, 3),
                 [&] { return random.below(8) == 0 ? 0.0 : random.in_binades(-150, 149); });
            break;
    }
    return form;
}

/// Every double of the kind is an integer times 2^-scale.
[[nodiscard]] inline int scale_of(Kind kind) {
    return kind == Kind::extremes ? 210 : kind == Kind::nearly ? 200 : 120;
}

/// What differs between the library and the oracle; empty where nothing does.
struct Judge {
    Random& random;
    roots::Tally tally;
    std::uint64_t questions = 0;

    template <class Form>
    [[nodiscard]] const char* judge(Kind kind, const Form& f, const Form& g, double t) {
        const int scale = scale_of(kind);
        const std::vector<IntegerPolynomial> both = {f.exactly(scale), g.exactly(scale)};
        const auto origin = [&] {
            const int kind_of = random.below(4);
            return kind_of < 2 ? 0.0 : kind_of == 2 ? t : random.in_binades(-20, 3);
        };
        const roots::Polynomial p(f, origin());
        const roots::Polynomial q(g, origin());
        if (p.is_zero(&tally) != both[0].empty()) return "is_zero";
        if (both[0].empty()) {
            if (!p.real_roots(&tally).everywhere || first_change(p, t, &tally)) return "zero";
            if (p.sign_at(t, &tally) != 0 || p.sign_after(t, &tally) != 0) return "signs of 0";
            return "";
        }
        if (both[1].empty()) return "";
        const oracle::RealRoots table(both);
        const auto mine = [&](int polynomial) {
            std::vector<int> result;
            for (int i = 0; i < table.count(); ++i)
                if (table.multiplicity(i, polynomial) > 0) result.push_back(i);
            return result;
        };
        const std::vector<int> of_p = mine(0);
        const std::vector<int> of_q = mine(1);
        // The index of the first change of p after the i-th root; -1 where there is none.
        const auto change_after = [&](int i) {
            for (const int k : of_p)
                if (k > i && table.multiplicity(k, 0) % 2 == 1) return k;
            return -1;
        };
        const auto root_after = [&](int i) {
            for (const int k : of_p)
                if (k > i) return k;
            return -1;
        };
        const mpq_class at(t);
        int before_t = -1;
        bool at_root = false;
        for (int i = 0; i < table.count(); ++i) {
            const int order = table.compare(i, at);
            if (order <= 0) before_t = i;
            at_root = at_root || (order == 0 && table.multiplicity(i, 0) > 0);
        }

        const roots::RealRoots found = p.real_roots(&tally);
        if (found.count != static_cast<int>(of_p.size()) || found.everywhere) return "count";
        const roots::RealRoots others = q.real_roots(&tally);
        if (others.count != static_cast<int>(of_q.size())) return "count of the other";
        for (int i = 0; i < found.count; ++i) {
            const int k = of_p[static_cast<std::size_t>(i)];
            const char* wrong = judge_root(table, k, p, found[i], change_after(k));
            if (*wrong != 0) return wrong;
        }

        // At a double.
        const int sign = oracle::sign_at(both[0], at);
        questions += 3;
        if ((sign == 0) != at_root) return "the oracle";
        if (p.sign_at(t, &tally) != sign) return "sign_at";
        const int after = before_t >= 0 && at_root ? table.sign_after(before_t, 0) : sign;
        if (p.sign_after(t, &tally) != after) return "sign_after";
        const std::optional<roots::Root> change = first_change(p, t, &tally);
        const int expected = change_after(before_t);
        if (change.has_value() != (expected >= 0)) return "first_change";
        if (change) {
            const char* wrong = judge_root(table, expected, p, *change, change_after(expected));
            if (*wrong != 0) return wrong;
        }

        const std::optional<roots::Root> root = p.first_root(t, &tally);
        const int first = root_after(before_t);
        if (root.has_value() != (first >= 0)) return "first_root";
        if (root) {
            const char* wrong = judge_root(table, first, p, *root, change_after(first));
            if (*wrong != 0) return wrong;
        }

        // At a root of the other one.
        for (int j = 0; j < others.count; ++j) {
            const int k = of_q[static_cast<std::size_t>(j)];
            const roots::RootOf there{q, others[j]};
            questions += 3;
            if (p.sign_at(there, &tally) != table.sign_at(k, 0)) return "sign_at a root";
            if (p.sign_after(there, &tally) != table.sign_after(k, 0)) return "sign_after a root";
            const std::optional<roots::Root> next = first_change(p, there, &tally);
            if (next.has_value() != (change_after(k) >= 0)) return "first_change after a root";
            if (next && p.nearest_double(*next) != table.nearest_double(change_after(k)))
                return "first_change after a root: which";
            const std::optional<roots::Root> first_after = p.first_root(there, &tally);
            if (first_after.has_value() != (root_after(k) >= 0)) return "first_root after a root";
            if (first_after &&
                p.nearest_double(*first_after) != table.nearest_double(root_after(k)))
                return "first_root after a root: which";
            for (int i = 0; i < found.count; ++i) {
                ++questions;
                const int order = of_p[static_cast<std::size_t>(i)] - k;
                if (compare(roots::RootOf{p, found[i]}, there, &tally) != (order > 0) - (order < 0))
                    return "compare";
            }
        }
        return "";
    }

 private:
    /// The root is the k-th of the table.
    [[nodiscard]] const char* judge_root(const oracle::RealRoots& table, int k,
                                         const roots::Polynomial& p, const roots::Root& root,
                                         int next) {
        questions += 5;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const double nearest = table.nearest_double(k);
        if (root.multiplicity != table.multiplicity(k, 0)) return "multiplicity";
        if (root.after != table.sign_after(k, 0)) return "after";
        const auto inside = [&](const roots::Root& r) {
            if (r.is_double()) return table.compare(k, mpq_class(r.low)) == 0;
            return r.low < r.high &&
                   (r.low == -infinity || table.compare(k, mpq_class(r.low)) > 0) &&
                   (r.high == infinity || table.compare(k, mpq_class(r.high)) < 0);
        };
        if (!inside(root)) return "interval";
        const roots::Root narrow = p.narrowed(root, &tally);
        if (!inside(narrow)) return "narrowed";
        if (!narrow.is_double() && std::nextafter(narrow.low, infinity) != narrow.high)
            return "not narrow";
        if (p.nearest_double(root, &tally) != nearest) return "nearest_double";
        const std::optional<roots::Root> change = first_change(p, roots::RootOf{p, root}, &tally);
        if (change.has_value() != (next >= 0)) return "first_change after its own root";
        if (change && !(table.nearest_double(next) == p.nearest_double(*change)))
            return "first_change after its own root: which";
        if (std::isfinite(nearest)) {
            const double beside = std::nextafter(nearest, random.coin() ? infinity : -infinity);
            for (const double x : {nearest, beside})
                if (std::isfinite(x) &&
                    compare(roots::RootOf{p, root}, x, &tally) != table.compare(k, mpq_class(x)))
                    return "compare with a double";
        }
        return "";
    }
};

/// Pairs of polynomials: of the same kind, equal, with one factor in common, or one an ulp beside
/// the other.
template <int Degree>
[[nodiscard]] const char* judge_pair(Judge& judge, Kind kind) {
    Random& random = judge.random;
    auto f = form_of<Degree>(kind, random);
    auto g = form_of<Degree>(kind, random);
    switch (random.below(4)) {
        case 0:
            g = f;
            break;
        case 1: {
            g = f;
            double& x = g.terms[0].lines[0].x;
            x = std::nextafter(x, random.coin() ? 4.0 : -4.0);
            if (std::fabs(x) < 0x1p-150) x = 0.0;
            break;
        }
        case 2:
            for (std::size_t i = 0; i < f.terms.size(); ++i)
                g.terms[i].lines[0] = f.terms[0].lines[0];
            for (std::size_t i = 0; i < f.terms.size(); ++i)
                f.terms[i].lines[0] = g.terms[0].lines[0];
            break;
        default:
            break;
    }
    double t = 0.0;
    switch (random.below(4)) {
        case 0:
            t = 0.0;
            break;
        case 1:
            t = 0.25 * random.between(-6, 6);
            break;
        case 2:
            t = 1.0 + 0x1p-52 * random.between(-2, 2);
            break;
        default:
            t = random.in_binades(-20, 3);
    }
    return judge.judge(kind, f, g, t);
}

}  // namespace signum::root_forms
