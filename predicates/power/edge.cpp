#include "edge.hpp"

#include "../ladder/ladder.hpp"

namespace signum::power {

template <Arithmetic arithmetic, PowerSite S>
Decision Nearer::behind(const Point& p, const S& a, const S& b) noexcept {
    namespace ladder = predicates::ladder;
    using Within = ladder::Steps<ladder::Bounded<Nearer>, ladder::InExpansions<Nearer>>;
    return ladder::climb<arithmetic, Nearer, Within, ladder::Beyond<Nearer>>(p, a, b);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision Nearer::behind<arithmetic>(const Point&, const S&, const S&) noexcept;
SIGNUM_FOR_POWER_SITES(SIGNUM_INSTANTIATE)

}  // namespace signum::power
