/// Real roots against the oracle: counts, order, signs, multiplicities, nearest doubles, of
/// polynomials of degree 2, 4 and 8 made to hurt.

#include <algorithm>

#include <gtest/gtest.h>

#include "../thoroughness.hpp"
#include "root_forms.hpp"

namespace {

using namespace signum::root_forms;

const int trials = signum::is_sanitized ? 40 : 320;

/// The oracle takes longer and longer.
template <int Degree>
void judge_all() {
    Random random(20 + Degree);
    for (int kind = 0; kind < kinds; ++kind) {
        Judge judge{random, {}};
        const bool extreme = static_cast<Kind>(kind) == Kind::extremes;
        const int count = std::max(8, 4 * trials / (Degree * Degree) / (extreme ? 4 : 1));
        for (int trial = 0; trial < count; ++trial)
            ASSERT_STREQ(judge_pair<Degree>(judge, static_cast<Kind>(kind)), "")
                << "kind " << kind << ", trial " << trial;
        // Both stages are at work. To round to a double takes the second one.
        EXPECT_GT(judge.tally.filtered, judge.questions / 8) << "kind " << kind;
        EXPECT_GT(judge.tally.exact, 0U) << "kind " << kind;
    }
}

TEST(RealRoots, OfDegreeTwoAreThoseOfTheOracle) {
    judge_all<2>();
}
TEST(RealRoots, OfDegreeFourAreThoseOfTheOracle) {
    judge_all<4>();
}
TEST(RealRoots, OfDegreeEightAreThoseOfTheOracle) {
    judge_all<8>();
}

}  // namespace
