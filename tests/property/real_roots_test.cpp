/// Real roots against the oracle: counts, order, signs, multiplicities, nearest doubles, of
/// polynomials of degree 2, 4 and 8 made to hurt.

#include <gtest/gtest.h>

#include "root_forms.hpp"

namespace {

using namespace signum::root_forms;

#if defined(__SANITIZE_ADDRESS__)
constexpr int trials = 20;
#else
constexpr int trials = 200;
#endif

template <int Degree>
void judge_all() {
    Random random(20 + Degree);
    for (int kind = 0; kind < kinds; ++kind) {
        Judge judge{random, {}};
        const int count = kind == static_cast<int>(Kind::extremes) ? trials / 10 : trials;
        for (int trial = 0; trial < count; ++trial)
            ASSERT_STREQ(judge_pair<Degree>(judge, static_cast<Kind>(kind)), "")
                << "kind " << kind << ", trial " << trial;
        if (static_cast<Kind>(kind) == Kind::random) {
            EXPECT_GT(judge.tally.filtered, judge.tally.exact);
        }
        std::printf("degree %d kind %d: %llu questions, %llu filtered, %llu exact\n", Degree, kind, (unsigned long long)judge.questions, (unsigned long long)judge.tally.filtered, (unsigned long long)judge.tally.exact);
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
