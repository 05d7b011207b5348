#include "ccw.hpp"

#include "ladder/ladder.hpp"

namespace signum::predicates {

template <Arithmetic arithmetic>
Decision Ccw::of_points(Point a, Point b, Point c) noexcept {
    using Within = ladder::Steps<ladder::FilterAgain<Ccw>, ladder::InExpansions<Ccw>>;
    return ladder::climb<arithmetic, Ccw, Within, ladder::Beyond<Ccw>>(a, b, c);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision Ccw::of_points<arithmetic>(S, S, S) noexcept;
SIGNUM_INSTANTIATE(Arithmetic::sum, Point)
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Point)

}  // namespace signum::predicates
