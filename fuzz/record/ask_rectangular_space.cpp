/// The supremum and the Manhattan metric of space.

#include <array>
#include <cstddef>
#include <cstdint>

#include "../../predicates/space/rectangular.hpp"
#include "narrow.hpp"
#include "rectangular_space_oracle.hpp"
#include "sites.hpp"

namespace signum::fuzz {
namespace {

using rectangular_oracle::Ball3;
using rectangular_oracle::SpaceSpheres;

template <class Shape, class Number>
void ask_in(const Configuration<3>& given, int unit, Ledger& ledger) {
    using Oracle = SpaceSpheres<Number, std::is_same_v<Shape, rectangular::Octahedron>>;
    std::array<Ball3<Number>, 4> four;
    Ball3<Number> query;
    for (std::size_t m = 0; m < 5; ++m) {
        Ball3<Number>& ball = m < 4 ? four[m] : query;
        for (std::size_t k = 0; k < 3; ++k)
            ball.c[k] = number_of<Number>(digits_of(given.balls[m].centre[k]), unit, 0);
        ball.r = number_of<Number>(digits_of(given.balls[m].size), unit, 0);
    }
    const auto site = [&](std::size_t m) { return site_of<Site3>(given.balls[m]); };
    if (ledger.calls() % 4 == 0)
        ledger.note(Predicate::hides, rectangular::hides_decision<Shape>(site(0), site(4)),
                    Oracle::covers(four[0], query) ? 1 : -1);

    const Oracle oracle(four);
    const rectangular::Spheres said =
        rectangular::spheres<Shape>(site(0), site(1), site(2), site(3));
    const bool endless = oracle.infinitely_many();
    // As a sign: one more than there are, or -1.
    ledger.note(Predicate::exists, {said.infinitely_many ? -1 : said.count + 1, said.stage},
                endless ? -1 : static_cast<int>(oracle.spheres().size()) + 1, endless);
    if (endless || said.infinitely_many || said.count != oracle.spheres().size()) return;
    for (std::size_t n = 0; n < said.count; ++n)
        ledger.note(Predicate::in_circle,
                    rectangular::in_sphere_decision<Shape>(site(0), site(1), site(2), site(3),
                                                           said.spheres[n], site(4)),
                    -rectangular_oracle::sign_of<Number>(Oracle::gap(oracle.spheres()[n], query)));
}

template <class Shape>
void ask_space_of(const Configuration<3>& given, Ledger& ledger) {
    const Units units = units_of(given.balls);
    if (units.span <= narrow_bits - 6)
        ask_in<Shape, Narrow>(given, units.lowest, ledger);
    else
        ask_in<Shape, Integer>(given, units.lowest, ledger);
}

}  // namespace

void ask_supremum(const Configuration<3>& configuration, Ledger& ledger) {
    ask_space_of<rectangular::Cube>(configuration, ledger);
}
void ask_manhattan(const Configuration<3>& configuration, Ledger& ledger) {
    ask_space_of<rectangular::Octahedron>(configuration, ledger);
}

}  // namespace signum::fuzz
