#include "nearer.hpp"

#include "../ladder/ladder.hpp"

namespace signum::power {

template <Arithmetic arithmetic, PowerSite3 S>
Decision Nearer3::behind(const Point3& p, const S& a, const S& b) noexcept {
    namespace ladder = predicates::ladder;
    using Beyond = ladder::Beyond<Nearer3>;
    return ladder::climb<arithmetic, Nearer3, Beyond, Beyond>(p, a, b);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision Nearer3::behind<arithmetic>(const Point3&, const S&, const S&) noexcept;
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Point3)
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Site3)
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, signum::Site3)

}  // namespace signum::power
