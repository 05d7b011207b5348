#pragma once
/// What the cold stages of the power predicates share: the window check and the rows of the
/// determinants as double-doubles and expansions. Included by sources only.

#include "../../exact/expansion.hpp"
#include "../../filters/double_double.hpp"
#include "in_circle.hpp"

namespace signum::power::cold {

using exact::Expansion;
using filters::DoubleDouble;

[[nodiscard]] inline bool weight_in_window(const Point&) noexcept {
    return true;
}
[[nodiscard]] inline bool weight_in_window(const Site& s) noexcept {
    return exact::weight_in_expansion_window(s.w);
}
[[nodiscard]] inline bool weight_in_window(const signum::Site& s) noexcept {
    return exact::in_expansion_window(s.r);
}

/// Whether double-doubles and expansions hold all terms of degree up to 4 in these sites.
template <PowerSite... S>
[[nodiscard]] inline bool in_window(const S&... sites) noexcept {
    return ((exact::in_expansion_window(sites.x) && exact::in_expansion_window(sites.y) &&
             weight_in_window(sites)) &&
            ...);
}

[[nodiscard]] inline DoubleDouble double_double_weight(const Point&, const Point&) noexcept {
    return {0.0, 0.0};
}
[[nodiscard]] inline DoubleDouble double_double_weight(const Site& m, const Site& q) noexcept {
    return filters::exact_difference(m.w, q.w);
}
[[nodiscard]] inline DoubleDouble double_double_weight(const signum::Site& m,
                                                       const signum::Site& q) noexcept {
    return filters::exact_difference(m.r, q.r) * filters::exact_sum(m.r, q.r);
}

template <PowerSite S>
[[nodiscard]] inline Row<DoubleDouble> double_double_row(const S& m, const S& q) noexcept {
    return {filters::exact_difference(m.x, q.x), filters::exact_difference(m.y, q.y),
            double_double_weight(m, q)};
}

/// No weight at all is an expansion that never has a term.
[[nodiscard]] inline Expansion<1> expansion_weight(const Point&, const Point&) noexcept {
    return {};
}
[[nodiscard]] inline Expansion<2> expansion_weight(const Site& m, const Site& q) noexcept {
    return exact::difference(m.w, q.w);
}
[[nodiscard]] inline Expansion<4> expansion_weight(const signum::Site& m,
                                                   const signum::Site& q) noexcept {
    return exact::product(m.r, m.r) - exact::product(q.r, q.r);
}

/// A row of the determinant: position relative to q, and lifted height |m-q|² - w_m + w_q.
template <PowerSite S>
struct ExpansionRow {
    Expansion<2> x;
    Expansion<2> y;
    decltype(exact::square(Expansion<2>()) + exact::square(Expansion<2>()) -
             expansion_weight(std::declval<S>(), std::declval<S>())) height;

    ExpansionRow(const S& m, const S& q) noexcept
        : x(exact::difference(m.x, q.x)),
          y(exact::difference(m.y, q.y)),
          height(exact::square(x) + exact::square(y) - expansion_weight(m, q)) {}
};

}  // namespace signum::power::cold
