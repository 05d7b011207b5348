#pragma once
/// Counts roundings: the machine's part in every forward error bound.
///
/// Evaluating a formula on RoundingCount instead of double gives the k of the standard lemma: if
/// every operation commits a relative error of at most e, a formula of sums and products satisfies
///     |computed - exact| <= ((1+e)^k - 1) · magnitude,
/// where the magnitude is the same formula with every operand replaced by its absolute value and
/// every subtraction by an addition. A product adds the counts of its factors and one of its own; a
/// sum takes the larger count and one more (Higham, Accuracy and Stability, ch. 3).

namespace signum::filters {

struct RoundingCount {
    int roundings = 0;

    friend constexpr RoundingCount operator*(RoundingCount a, RoundingCount b) noexcept {
        return {a.roundings + b.roundings + 1};
    }
    friend constexpr RoundingCount operator+(RoundingCount a, RoundingCount b) noexcept {
        return {(a.roundings > b.roundings ? a.roundings : b.roundings) + 1};
    }
    friend constexpr RoundingCount operator-(RoundingCount a, RoundingCount b) noexcept {
        return a + b;
    }
};

/// An operand that is itself a rounded difference of two input numbers.
inline constexpr RoundingCount rounded_difference{1};

}  // namespace signum::filters
