#include "infinite.hpp"

#include "../ladder/ladder.hpp"

namespace signum::power {

template <Arithmetic arithmetic, PowerSite S>
Decision InSegment::behind(const S& a, const S& b, const S& q) noexcept {
    namespace ladder = predicates::ladder;
    using Within = ladder::Steps<ladder::Bounded<InSegment>, ladder::InExpansions<InSegment>>;
    return ladder::climb<arithmetic, InSegment, Within,
                         ladder::Steps<ladder::InExactNumbers<InSegment>>>(a, b, q);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision InSegment::behind<arithmetic>(const S&, const S&, const S&) noexcept;
SIGNUM_FOR_POWER_SITES(SIGNUM_INSTANTIATE)

}  // namespace signum::power
