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

    constexpr RoundingCount() = default;
    /// An input number is exact, whatever it is.
    explicit constexpr RoundingCount(double) noexcept {}
    [[nodiscard]] static constexpr RoundingCount of(int roundings) noexcept {
        RoundingCount result;
        result.roundings = roundings;
        return result;
    }

    friend constexpr RoundingCount operator*(RoundingCount a, RoundingCount b) noexcept {
        return of(a.roundings + b.roundings + 1);
    }
    friend constexpr RoundingCount operator+(RoundingCount a, RoundingCount b) noexcept {
        return of(max(a, b).roundings + 1);
    }
    friend constexpr RoundingCount operator-(RoundingCount a, RoundingCount b) noexcept {
        return a + b;
    }
    /// Exact.
    friend constexpr RoundingCount operator-(RoundingCount a) noexcept { return a; }
    friend constexpr RoundingCount max(RoundingCount a, RoundingCount b) noexcept {
        return a.roundings > b.roundings ? a : b;
    }
    friend constexpr RoundingCount magnitude(RoundingCount a) noexcept { return a; }
};

/// An operand that is itself a rounded difference of two input numbers.
inline constexpr RoundingCount rounded_difference = RoundingCount(0.0) - RoundingCount(0.0);

}  // namespace signum::filters
