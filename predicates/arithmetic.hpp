#pragma once
/// What the predicates compute with: the one parameter of all kernels.

#include <cstdint>
#include <type_traits>

#include "../core/site.hpp"
#include "../filters/interval.hpp"

namespace signum {

/// The exact ones agree on every sign, so that all give the same tessellation.
enum class Arithmetic : std::uint8_t {
    exact,           ///< a filter, then ever dearer stages; see ARCHITECTURE.md
    naive,           ///< doubles, whose word is taken for the truth
    single,          ///< the same in floats, to which the sites are rounded first
    interval,        ///< intervals, and where 0 is inside ESSA at once (thesis, 4.7)
    sum,             ///< ESSA alone: the exact sign of a sum
    multiprecision,  ///< rationals alone
    /// What a check decides by: the filters of `exact`, and where they leave a sign open exact
    /// numbers of its own (exact/dyadic.hpp), never those that `exact` has behind its filters, so
    /// that an error there cannot confirm itself. No construction takes it.
    judging
};

/// Whether no sign is ever wrong.
[[nodiscard]] constexpr bool is_exact(Arithmetic arithmetic) noexcept {
    return arithmetic != Arithmetic::naive && arithmetic != Arithmetic::single;
}

namespace predicates {

/// Whether filters are asked whose verdicts stand on a counted bound.
[[nodiscard]] constexpr bool is_filtered(Arithmetic arithmetic) noexcept {
    return arithmetic == Arithmetic::exact || arithmetic == Arithmetic::judging;
}

/// What a formula is evaluated in before, or instead of, the exact stage.
template <Arithmetic arithmetic>
using NumberOf = std::conditional_t<
    arithmetic == Arithmetic::single, float,
    std::conditional_t<arithmetic == Arithmetic::interval, filters::Interval, double>>;

/// The site as the arithmetic takes it. Precondition of the single one: the numbers fit in floats.
[[nodiscard]] constexpr Site rounded(Arithmetic arithmetic, const Site& site) noexcept {
    if (arithmetic != Arithmetic::single) return site;
    return {static_cast<float>(site.x), static_cast<float>(site.y), static_cast<float>(site.r)};
}

}  // namespace predicates
}  // namespace signum
