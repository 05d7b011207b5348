#pragma once
/// Hidden sites: the Euclidean cell of q is empty where the disc of one site covers that of q.
///
/// Law: i hides q where |c_i - c_q| <= r_i - r_q. In this metric several sites together hide
/// nothing that one of them does not hide.

#include <signum/core/sign.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>

namespace signum::euclidean {

/// +1 where i hides q or both are equal, -1 otherwise. Precondition: finite numbers.
[[nodiscard]] Decision hides_decision(const Site& i, const Site& q) noexcept;

/// The same under the tie rule: of equal sites the earlier one hides the later.
[[nodiscard]] Decision hides_perturbed_decision(const Site& i, const Site& q,
                                                bool i_precedes_q) noexcept;

}  // namespace signum::euclidean
