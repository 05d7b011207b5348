#include "ccw.hpp"

#include "../ladder/ladder.hpp"

namespace signum::predicates {

template <Arithmetic arithmetic>
Decision Ccw3::of_points(const Point3& a, const Point3& b, const Point3& c,
                         const Point3& d) noexcept {
    using Within = ladder::Steps<ladder::Bounded<Ccw3>, ladder::InExpansions<Ccw3>>;
    return ladder::climb<arithmetic, Ccw3, Within, ladder::Beyond<Ccw3>>(a, b, c, d);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision Ccw3::of_points<arithmetic>(const S&, const S&, const S&, const S&) noexcept;
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Point3)

}  // namespace signum::predicates
