#pragma once
/// ESSA, the exact sign of a sum (Ratschek and Rokne): no rounding, no overflow, no underflow.
///
/// The positive terms are a, the magnitudes of the negative ones b; a1 and b1 are a term of the
/// highest binade of each list, E and F their exponents (2^(E-1) <= a1 < 2^E), n the number of b.
///
///   stop    one list is empty: the sign is that of the other, or 0
///   stop    a1 >= n·2^F: +1, for every b is below 2^F; likewise with the lists exchanged
///   cancel  if a1 - b1 is a double: its magnitude replaces both, on the side of the larger
///   reduce  otherwise, say with E > F: u is the least power of two that is at least b1; a1 and b1
///           give way to a1 - u and u - b1, both among the a; likewise with the lists exchanged
///
/// A step keeps the value of the sum. Zeros are dropped, so the number of terms never grows. (The
/// original cancels only where E = F; to cancel whatever is exact takes far fewer steps and gives
/// the bound below.)
///
/// Every step is exact in doubles. Cancel: the rounding error of a1 - b1 is itself a double, which
/// is computed (Fast2Sum) and must be 0; with E = F it always is (Sterbenz). Reduce: u - b1 is
/// exact because u <= 2·b1 (Sterbenz). As the stop did not apply, 2^(E-1) <= a1 < n·2^F. So E - F
/// is at most 32 for n < 2^32, and u >= 2^(F-1) is a multiple of the last place 2^(E-53) of a1; a1
/// - u is one too, and 0 <= a1 - u < 2^E. As F < E, u <= 2^1023. The stop compares integers, not
/// n·2^F.
///
/// The bound: N terms take at most (N-1) + (2N-1)·k steps, where 2^k is the least power of two that
/// is at least N; whatever the range of exponents.
/// Proof. Let a term keep its name when it is reduced: a1 becomes a1 - u, b1 becomes u - b1. A
/// difference gets a new name. Let L be the exponent of the last set bit of the first term of a
/// name; the exponent of that first term is at most L + 53.
///   (i)   E and F never grow: no new term has a higher exponent than the old one on its side. The
///         exponent of a name never grows.
///   (ii)  A term is a multiple of 2^min(L, G-1), G the highest exponent on the other side: so when
///         its name begins, so while G falls; and so is a1 - u (there G = F), since u is a multiple
///         of 2^(F-1).
///   (iii) In a reduction b1 < 2^F <= 2^(G-1) with G = E: so the minimum in (ii) is L, b1 is a
///         multiple of 2^L, so is u >= b1, and so is u - b1, which has changed sides: (ii) holds.
///         Since u - b1 < 2^(F-1), the exponent of this name has fallen.
///   (iv)  Had b1 been a multiple of 2^(E-53), as a1 is, a1 - b1 < 2^E would have been a double. So
///         L <= E - 54. The stop did not apply, so E - F <= k. Hence F >= L + 54 - k.
/// By (i), (iii) and (iv) no name is that of b1 in more than k reductions: F falls from at most
/// L + 53 each time. A cancellation ends two terms and begins at most one, so there are at most
/// N - 1 of them, and at most 2N - 1 names.

#include <cstddef>
#include <span>

#include "../core/sign.hpp"

namespace signum {

/// The exact sign of terms[0] + terms[1] + ... for any finite doubles, fewer than 2^32 of them. Any
/// rounding mode, denormals flushed or not. Does not allocate up to 512 terms; above, allocates
/// once 16 bytes a term and, being noexcept, ends the program if they are not to be had.
[[nodiscard]] Sign sign_of_sum(std::span<const double> terms) noexcept;

namespace exact {

/// A sign and the number of steps that it took.
struct SumTrace {
    Sign sign;          ///< of the sum
    std::size_t steps;  ///< cancellations and reductions, as above
};

/// sign_of_sum, and how long its way was.
[[nodiscard]] SumTrace trace_sign_of_sum(std::span<const double> terms) noexcept;

}  // namespace exact
}  // namespace signum
