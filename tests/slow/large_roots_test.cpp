// Ten million questions about real roots, each against the oracle.

#include <gtest/gtest.h>

#include "../property/root_forms.hpp"

namespace {

using namespace signum::root_forms;

template <int Degree>
void judge_until(std::uint64_t questions) {
    Random random(1000 + Degree);
    Judge judge{random, {}};
    for (int trial = 0; judge.questions < questions; ++trial) {
        const auto kind = static_cast<Kind>(trial % kinds);
        // With numbers so long the oracle takes its time.
        if (kind == Kind::extremes && trial / kinds % 8 != 0) continue;
        ASSERT_STREQ(judge_pair<Degree>(judge, kind), "") << "trial " << trial;
    }
}

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr std::uint64_t million = 10'000;
#else
constexpr std::uint64_t million = 1'000'000;
#endif

TEST(LargeRoots, OfDegreeTwo) {
    judge_until<2>(6 * million);
}
TEST(LargeRoots, OfDegreeFour) {
    judge_until<4>(7 * million / 2);
}
TEST(LargeRoots, OfDegreeEight) {
    judge_until<8>(million / 2);
}

}  // namespace
