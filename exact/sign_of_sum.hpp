#pragma once
/// ESSA, the exact sign of a sum (Ratschek and Rokne): no rounding, no overflow, no underflow.
///
/// The positive terms are a, the magnitudes of the negative ones b; a1 and b1 are a term of the
/// highest binade of each list, E and F their exponents (2^(E-1) <= a1 < 2^E), n the number of b.
///
///   stop  one list is empty: the sign is that of the other, or 0
///   stop  a1 >= n·2^F: +1, for every b is below 2^F; likewise with the lists exchanged
///   step  E = F ("cancel"): a1 and b1 give way to |a1 - b1|, on the side of the larger
///   step  E > F ("reduce"): u is the least power of two that is at least b1; a1 and b1 give way to
///         a1 - u and u - b1, both among the a; likewise with the lists exchanged
///
/// A step keeps the value of the sum. Zeros are dropped, so the number of terms never grows.
///
/// Every step is exact in doubles. a1 - b1 with E = F and u - b1: one number is at most twice the
/// other (Sterbenz). a1 - u: as the stop did not apply, 2^(E-1) <= a1 < n·2^F, so with n < 2^32
/// E - F <= 32, and u >= 2^(F-1) is a multiple of the last place 2^(E-53) of a1; so a1 - u is one
/// too, and 0 <= a1 - u < 2^E. As F < E, u <= 2^1023. The stop compares integers, not n·2^F.
///
/// The bound: a sum takes at most as many steps as its terms have significant bits together, from
/// the first set bit of each to its last: 53 a term, whatever the range of exponents.
/// Proof. Let a term keep its name through the steps: a1 becomes a1 - u, b1 becomes u - b1, and a
/// difference takes the name of a1 or b1; the other name ends, as does one whose term vanishes.
/// Let L be the exponent of the last set bit of the input term of a name; a difference takes the
/// name of lesser L.
///   (i)   E and F never grow: every new term is less than the old ones on its side.
///   (ii)  A term is a multiple of 2^min(L, G-1), G the highest exponent on the other side: so it is
///         at the start, so it remains while G falls, and so is a1 - u (there G = F), since u is a
///         multiple of 2^(F-1).
///   (iii) In a reduction, b1 < 2^F <= 2^(G-1) with G = E: so the minimum in (ii) is L, b1 is a
///         multiple of 2^L, so is u >= b1, and so is u - b1, which has changed sides: (ii) holds.
///         Since u - b1 < 2^(F-1), the exponent of this name has fallen.
///   (iv)  A difference is below 2^(E-1) and by (ii) a multiple of 2^min(L, E-1); unless it is 0 the
///         minimum is L, and (ii) holds whatever its side.
/// Count for each name the reductions in which it was b1 and the cancellation that ends it; every
/// step is counted. After a reduction in which b1 did not vanish the exponent of its name is in
/// [L+1, L+w-1], w the bits of the input term, and less than after all earlier ones, since exponents
/// never rise. So there are at most w - 1 of these, and at most one further step, which ends it.

#include <cstddef>
#include <span>

#include <signum/core/sign.hpp>

namespace signum {

/// The exact sign of terms[0] + terms[1] + ... for any finite doubles, fewer than 2^32 of them. Any
/// rounding mode, denormals flushed or not. Does not allocate up to 512 terms; above, allocates once
/// 16 bytes a term and, being noexcept, ends the program if they are not to be had.
[[nodiscard]] Sign sign_of_sum(std::span<const double> terms) noexcept;

namespace exact {

/// A sign and the number of steps that it took.
struct SumTrace {
    Sign sign;
    std::size_t steps;
};

/// sign_of_sum, and how long its way was.
[[nodiscard]] SumTrace trace_sign_of_sum(std::span<const double> terms) noexcept;

}  // namespace exact
}  // namespace signum
