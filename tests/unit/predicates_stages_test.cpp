// Every predicate of the power metric in every stage: inputs that only the stage named can decide,
// with signs worked out by hand; and the tie rule.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <type_traits>

#include "../../predicates/power.hpp"
#include "../../triangulation/kernels/power_kernel.hpp"

namespace signum {

bool operator==(const Decision& a, const Decision& b) {
    return a.sign == b.sign && a.stage == b.stage;
}
void PrintTo(const Decision& d, std::ostream* out) {
    *out << d.sign << " by " << name_of(d.stage);
}

namespace {

constexpr Decision filter(Sign sign) {
    return {sign, Stage::filter};
}
constexpr Decision refine(Sign sign) {
    return {sign, Stage::refine};
}
constexpr Decision exact(Sign sign) {
    return {sign, Stage::exact};
}
constexpr Decision multiprecision(Sign sign) {
    return {sign, Stage::multiprecision};
}

constexpr double largest = std::numeric_limits<double>::max();
constexpr double denormal = 0x1p-1074;
constexpr double ulp = 0x1p-52;  // of 1

// ---- ccw ---------------------------------------------------------------------------------------

Decision decide_ccw(Point a, Point b, Point c) {
    return ccw_decision(a, b, c);
}

TEST(CcwStages, Filter) {
    EXPECT_EQ(decide_ccw({0, 0}, {1, 0}, {0, 1}), filter(+1));
    EXPECT_EQ(decide_ccw({0, 0}, {0, 1}, {1, 0}), filter(-1));
    EXPECT_EQ(decide_ccw({1e150, 0}, {0, 1e150}, {-1e150, -1e150}), filter(+1));
    EXPECT_EQ(decide_ccw({1, 1}, {2, 2}, {3, 3 + 64 * ulp}), filter(+1));
}

TEST(CcwStages, ExactTies) {
    EXPECT_EQ(decide_ccw({0, 0}, {1, 1}, {2, 2}), exact(0));
    EXPECT_EQ(decide_ccw({1, 1}, {1, 1}, {2, 3}), exact(0));
    EXPECT_EQ(decide_ccw({2, 3}, {1, 1}, {2, 3}), exact(0));
    EXPECT_EQ(decide_ccw({0.1, 0.1}, {0.7, 0.7}, {123.4, 123.4}), exact(0));
    EXPECT_EQ(decide_ccw({0x1p-200, 0x1p-200}, {0x1p200, 0x1p200}, {1, 1}), exact(0));
}

TEST(CcwStages, ExactNearTies) {
    // Kettner et al.: points near (1/2, 1/2) against a line through (12, 12) and (24, 24).
    EXPECT_EQ(decide_ccw({0.5, 0.5}, {12, 12}, {24, 24}), exact(0));
    EXPECT_EQ(decide_ccw({0.5 + ulp / 2, 0.5}, {12, 12}, {24, 24}), exact(-1));
    EXPECT_EQ(decide_ccw({0.5, 0.5 + ulp / 2}, {12, 12}, {24, 24}), exact(+1));
    // (1+u)(1-u) - 1·1 = -u²: the difference of the products is far below their last places.
    EXPECT_EQ(decide_ccw({1 + ulp, 1}, {1, 1 - ulp}, {0, 0}), exact(-1));
    // The differences themselves are not doubles: 1 + 2^-60 and 1 against 1 and 1.
    EXPECT_EQ(decide_ccw({1, 1}, {1, 1}, {-0x1p-60, 0}), exact(0));
    EXPECT_EQ(decide_ccw({1, 1}, {2, 2}, {-0x1p-60, 0}), exact(+1));
    EXPECT_EQ(decide_ccw({2, 2}, {1, 1}, {-0x1p-60, 0}), exact(-1));
}

TEST(CcwStages, BeyondTheWindow) {
    EXPECT_EQ(decide_ccw({0, 0}, {denormal, 0}, {0, denormal}), filter(+1));
    EXPECT_EQ(decide_ccw({0, 0}, {denormal, denormal}, {3 * denormal, 3 * denormal}),
              multiprecision(0));
    EXPECT_EQ(decide_ccw({0, 0}, {1e-308, 0}, {0, -1e-308}), filter(-1));
    EXPECT_EQ(decide_ccw({-largest, -largest}, {largest, -largest}, {0, largest}), filter(+1));
    EXPECT_EQ(decide_ccw({-largest, -largest}, {largest, largest}, {0, 0}), multiprecision(0));
    EXPECT_EQ(decide_ccw({-largest, -largest}, {largest, largest}, {0, denormal}),
              multiprecision(+1));
    EXPECT_EQ(decide_ccw({1e308, 0}, {-1e308, 0}, {-1e308, 1e-308}), filter(-1));
    EXPECT_EQ(decide_ccw({0, 0}, {0x1p201, 0x1p201}, {1, 1}), multiprecision(0));
    EXPECT_EQ(decide_ccw({0, 0}, {0x1p-201, 0x1p-201}, {1, 1}), multiprecision(0));
}

/// ESSA decides what its products hold, whether or not a filter could.
TEST(EssaStages, AnswerInTheWindow) {
    using OfPoints = triangulation::PowerSigns<Point, Arithmetic::sum>;
    using OfSites = triangulation::PowerSigns<Site, Arithmetic::sum>;
    const auto by_essa = [](Sign sign) -> Decision { return {sign, Stage::essa}; };
    EXPECT_EQ(OfPoints::ccw({0, 0}, {1, 0}, {0, 1}), by_essa(+1));
    EXPECT_EQ(OfPoints::ccw({0.1, 0.1}, {0.7, 0.7}, {123.4, 123.4}), by_essa(0));
    EXPECT_EQ(OfPoints::ccw({0x1p-200, 0x1p-200}, {0x1p200, 0x1p200}, {1, 1}), by_essa(0));
    EXPECT_EQ(OfPoints::ccw({0, 0}, {0x1p201, 0x1p201}, {1, 1}), multiprecision(0));
    const Site i{1, 0, 2};
    const Site j{0, 1, 2};
    const Site k{-1, 0, 2};
    EXPECT_EQ(OfSites::in_circle(i, j, k, {0, 0, 2}), by_essa(+1));
    EXPECT_EQ(OfSites::in_circle(i, j, k, {0, -1, 2}), by_essa(0));
    EXPECT_EQ(OfSites::in_circle(i, j, k, {0x1p-150, -1, 2}), by_essa(-1));
    EXPECT_EQ(OfSites::in_circle(i, j, k, {0x1p-201, -1, 2}), multiprecision(-1));
    EXPECT_EQ(OfSites::in_segment(k, i, {0, 0, 2}), by_essa(+1));
    EXPECT_EQ(OfSites::in_segment(k, i, {0x1p201, 0, 2}), multiprecision(-1));
    EXPECT_EQ(OfSites::nearer({0, 0}, i, k), by_essa(0));
    EXPECT_EQ(OfSites::nearer({0x1p-201, 0}, i, k), multiprecision(+1));
}

// ---- in_circle ---------------------------------------------------------------------------------

/// The same four centres as any kind of site, all weights equal.
template <class S>
class InCircleStages : public testing::Test {
 protected:
    static S at(double x, double y) {
        if constexpr (std::is_same_v<S, Point>) {
            return {x, y};
        } else {
            return {x, y, 2.0};
        }
    }
    static Decision decide(Point i, Point j, Point k, Point q) {
        return power::in_circle_decision(at(i.x, i.y), at(j.x, j.y), at(k.x, k.y), at(q.x, q.y));
    }
};
using Kinds = testing::Types<Point, power::Site, Site>;
TYPED_TEST_SUITE(InCircleStages, Kinds);

TYPED_TEST(InCircleStages, Filter) {
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {0, 0}), filter(+1));
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {0, -2}), filter(-1));
    EXPECT_EQ(this->decide({1e50, 0}, {0, 1e50}, {-1e50, 0}, {0, -0.99e50}), filter(+1));
    EXPECT_EQ(this->decide({1e-50, 0}, {0, 1e-50}, {-1e-50, 0}, {0, -1.01e-50}), filter(-1));
    // Too near for the first bound, not for the second.
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {0, -1 + 256 * ulp}), filter(+1));
}

TYPED_TEST(InCircleStages, ExactDecidesTiesOfIntegers) {
    EXPECT_EQ(this->decide({0, 0}, {1, 0}, {1, 1}, {0, 1}), exact(0));
    EXPECT_EQ(this->decide({5, 0}, {3, 4}, {-4, 3}, {-3, -4}), exact(0));
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {1, 0}), exact(0));  // q is i
    EXPECT_EQ(this->decide({0x1p100, 0}, {0, 0x1p100}, {-0x1p100, 0}, {0, -0x1p100}), exact(0));
    EXPECT_EQ(this->decide({0x1p-150, 0}, {0, 0x1p-150}, {-0x1p-150, 0}, {0, -0x1p-150}), exact(0));
    // Far from the origin, but all differences are small integers.
    const double x = 0x1p52;
    EXPECT_EQ(this->decide({x, x}, {x + 1, x}, {x + 1, x + 1}, {x, x + 1}), exact(0));
}

TYPED_TEST(InCircleStages, RefineDecidesNearTies) {
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {0, -1 + ulp / 2}), refine(+1));
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {0, -1 - ulp}), refine(-1));
    EXPECT_EQ(this->decide({0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, std::nextafter(-0.1, 0)}),
              refine(+1));
}

TYPED_TEST(InCircleStages, ExactDecidesTiesWithManyBits) {
    // A tie whose numbers are too long for a plain evaluation.
    EXPECT_EQ(this->decide({0.1, 0}, {0, 0.1}, {-0.1, 0}, {0, -0.1}), exact(0));
    // The differences to q are no doubles: the rectangle [2^-60, 1] x [2^-60, 1].
    const double e = 0x1p-60;
    EXPECT_EQ(this->decide({e, e}, {1, e}, {1, 1}, {e, 1}), exact(0));
    EXPECT_EQ(this->decide({-e, -e}, {1, -e}, {1, 1}, {-e, 1}), exact(0));
}

TYPED_TEST(InCircleStages, ExactDecidesWhatDoubleDoublesCannot) {
    const double e = 0x1p-150;
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, 0}, {e, -1}), exact(-1));
    // k moved out of the unit circle: the circle grows by e²/4 about, towards q.
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, e}, {0, -1}), exact(+1));
    EXPECT_EQ(this->decide({1, 0}, {0, 1}, {-1, -e}, {0, -1}), exact(+1));
}

TYPED_TEST(InCircleStages, BeyondTheWindow) {
    const double d = denormal;
    EXPECT_EQ(this->decide({d, 0}, {0, d}, {-d, 0}, {0, 0}), filter(+1));
    EXPECT_EQ(this->decide({d, 0}, {0, d}, {-d, 0}, {0, -d}), multiprecision(0));
    EXPECT_EQ(this->decide({d, 0}, {0, d}, {-d, 0}, {0, -2 * d}), filter(-1));
    const double m = largest;
    EXPECT_EQ(this->decide({m, 0}, {0, m}, {-m, 0}, {0, -m}), multiprecision(0));
    EXPECT_EQ(this->decide({m, 0}, {0, m}, {-m, 0}, {d, -m}), multiprecision(-1));
    EXPECT_EQ(this->decide({m, 0}, {0, m}, {-m, 0}, {d, 0}), filter(+1));
    EXPECT_EQ(this->decide({1e308, 0}, {0, 1e308}, {-1e308, 0}, {0, -1.01e308}), filter(-1));
    EXPECT_EQ(this->decide({1e-308, 0}, {0, 1e-308}, {-1e-308, 0}, {0, 0}), filter(+1));
    const double out = 0x1p201;
    EXPECT_EQ(this->decide({out, 0}, {0, out}, {-out, 0}, {0, -out}), multiprecision(0));
    EXPECT_EQ(this->decide({1 / out, 0}, {0, 1 / out}, {-1 / out, 0}, {0, -1 / out}),
              multiprecision(0));
}

/// Terms of the determinant overflow while bound and sum of squares stay far from it.
TYPED_TEST(InCircleStages, OverflowOfOneTermIsNoSign) {
    for (double l = 0x1p250; l < 0x1p260; l *= 1.25) {
        EXPECT_EQ(this->decide({l, 0}, {l, l}, {0, l}, {0, 0}), multiprecision(0)) << l;
        const double near = l * 0x1p-40;
        EXPECT_EQ(this->decide({l, 0}, {l, l}, {0, l}, {near, near}).sign, +1) << l;
        EXPECT_EQ(this->decide({l, 0}, {l, l}, {0, l}, {-near, -near}).sign, -1) << l;
    }
}

TEST(InCircleWeightStages, Weights) {
    using S = power::Site;
    const auto decide = [](double wi, double wj, double wk, double wq) {
        return power::in_circle_decision(S{1, 0, wi}, S{0, 1, wj}, S{-1, 0, wk}, S{0, 0, wq});
    };
    EXPECT_EQ(decide(0, 0, 0, 0), filter(+1));
    EXPECT_EQ(decide(0, 0, 0, -2), filter(-1));
    EXPECT_EQ(decide(0, 0, 0, -1), exact(0));
    EXPECT_EQ(decide(1, 1, 1, 0), exact(0));
    EXPECT_EQ(decide(1, 1, 1, ulp), exact(+1));
    EXPECT_EQ(decide(1, 1, 1, -ulp), exact(-1));
    EXPECT_EQ(decide(1, 1, 1, 0x1p-60), refine(+1));
    EXPECT_EQ(decide(1, 1, 1, -0x1p-60), refine(-1));
    // 1 - 2^-300 is no double: the weights' difference has two terms far apart.
    EXPECT_EQ(decide(1, 1, 1, 0x1p-300), exact(+1));
    EXPECT_EQ(decide(1, 1, 1, -0x1p-300), exact(-1));
    EXPECT_EQ(decide(1, 1, 1, 0x1p-400), exact(+1));
    EXPECT_EQ(decide(1, 1, 1, 0x1p-401), multiprecision(+1));
    EXPECT_EQ(decide(1, 1, 1, -denormal), multiprecision(-1));
    EXPECT_EQ(decide(1, 1, 1 + denormal, 0), exact(0));
    EXPECT_EQ(decide(0x1p400, 0x1p400, 0x1p400, 0x1p400), filter(+1));
    EXPECT_EQ(decide(1e308, 1e308, 1e308, -1e308), filter(-1));
}

/// The difference of two squares is not the rounded one, though its last terms cancel.
TEST(InCircleRadiusStages, RadiiFarApart) {
    const auto decide = [](double r, double q) {
        return power::in_circle_decision(Site{1, 0, r}, Site{0, 1, r}, Site{-1, 0, r},
                                         Site{0, 0, q});
    };
    EXPECT_EQ(decide(1, 0), exact(0));
    EXPECT_EQ(decide(-1, 0), exact(0));
    EXPECT_EQ(decide(1, 0x1p-20), filter(+1));
    EXPECT_EQ(decide(1, 0x1p-26), exact(+1));
    EXPECT_EQ(decide(1, 0x1.0000001p-45), refine(+1));
    EXPECT_EQ(decide(1, 0x1p-54), exact(+1));
    EXPECT_EQ(decide(1, 0x1p-60), exact(+1));
    EXPECT_EQ(decide(-1, 0x1p-60), exact(+1));
    EXPECT_EQ(decide(1, -0x1p-60), exact(+1));
    EXPECT_EQ(decide(1, 0x1p-200), exact(+1));
    EXPECT_EQ(decide(1, 0x1p-201), multiprecision(+1));
    EXPECT_EQ(decide(1, denormal), multiprecision(+1));
}

// ---- in_segment, in_circle_infinite ------------------------------------------------------------

TYPED_TEST(InCircleStages, SegmentFilter) {
    const auto s = [](double x, double y) { return TestFixture::at(x, y); };
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(2, 0), s(1, 0)), filter(+1));
    EXPECT_EQ(power::in_segment_decision(s(2, 0), s(0, 0), s(1, 0)), filter(+1));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(2, 0), s(3, 0)), filter(-1));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(2, 2), s(-1, -1)), filter(-1));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(0, 2), s(0, 1)), filter(+1));
}

TYPED_TEST(InCircleStages, SegmentExact) {
    const auto s = [](double x, double y) { return TestFixture::at(x, y); };
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(2, 0), s(0, 0)), exact(0));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(2, 0), s(2, 0)), exact(0));
    EXPECT_EQ(power::in_segment_decision(s(0.1, 0.1), s(0.1, 7), s(0.1, 7)), exact(0));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(1, 0), s(0x1p-180, 0)).sign, +1);
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(1, 0), s(-0x1p-180, 0)).sign, -1);
}

TYPED_TEST(InCircleStages, SegmentMultiprecision) {
    const auto s = [](double x, double y) { return TestFixture::at(x, y); };
    const double m = largest;
    EXPECT_EQ(power::in_segment_decision(s(-m, 0), s(m, 0), s(0, 0)), multiprecision(+1));
    EXPECT_EQ(power::in_segment_decision(s(-m, -m), s(m, m), s(-m, -m)), multiprecision(0));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(denormal, 0), s(-denormal, 0)),
              multiprecision(-1));
    EXPECT_EQ(power::in_segment_decision(s(0, 0), s(0, 2e-308), s(0, 1e-308)), multiprecision(+1));
}

TEST(SegmentWeightStages, Weights) {
    using S = power::Site;
    const auto decide = [](double w, double q) {
        return power::in_segment_decision(S{-1, 0, w}, S{1, 0, w}, S{0, 0, q});
    };
    EXPECT_EQ(decide(0, -0.5), filter(+1));
    EXPECT_EQ(decide(0, -1.5), filter(-1));
    EXPECT_EQ(decide(0, -1), exact(0));
    EXPECT_EQ(decide(1, 0x1p-300), exact(+1));
    EXPECT_EQ(decide(1, -0x1p-300), exact(-1));
    EXPECT_EQ(decide(1, denormal), multiprecision(+1));
    // Radii: the squares differ by 1 - 2^-120.
    EXPECT_EQ(power::in_segment_decision(Site{-1, 0, 1}, Site{1, 0, 1}, Site{0, 0, 0x1p-60}),
              exact(+1));
}

TYPED_TEST(InCircleStages, InfiniteVertex) {
    const auto s = [](double x, double y) { return TestFixture::at(x, y); };
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(1, 1)), -1);
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(1, -1)), +1);
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(1, -denormal)), +1);
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(1, 0)), +1);
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(3, 0)), -1);
    EXPECT_EQ(power::in_circle_infinite(s(0, 0), s(2, 0), s(2, 0)), 0);
}

// ---- nearer ------------------------------------------------------------------------------------

TYPED_TEST(InCircleStages, Nearer) {
    const auto s = [](double x, double y) { return TestFixture::at(x, y); };
    const auto decide = [](Point p, TypeParam a, TypeParam b) {
        return power::nearer_decision(p, a, b);
    };
    EXPECT_EQ(decide({0, 0}, s(1, 0), s(0, 2)), filter(+1));
    EXPECT_EQ(decide({0, 0}, s(0, 2), s(1, 0)), filter(-1));
    EXPECT_EQ(decide({0, 0}, s(1, 0), s(0, 1)), exact(0));
    EXPECT_EQ(decide({0, 0}, s(3, 4), s(5, 0)), exact(0));
    EXPECT_EQ(decide({0, 0}, s(0x1p-150, 1), s(0, 1)), exact(-1));
    EXPECT_EQ(decide({0x1p-150, 0}, s(1, 0), s(-1, 0)), exact(+1));
    EXPECT_EQ(decide({denormal, 0}, s(1, 0), s(-1, 0)), multiprecision(+1));
    EXPECT_EQ(decide({-denormal, 0}, s(largest, 0), s(-largest, 0)), multiprecision(-1));
    EXPECT_EQ(decide({0, 0}, s(1e-308, 0), s(0, 2e-308)), filter(+1));
    EXPECT_EQ(decide({1, 1}, s(1, 1), s(1, 1)), exact(0));
}

TEST(NearerWeightStages, Weights) {
    using S = power::Site;
    EXPECT_EQ(power::nearer_decision({0, 0}, S{3, 0, 9}, S{0, 0, 0}), exact(0));
    EXPECT_EQ(power::nearer_decision({0, 0}, S{3, 0, 10}, S{0, 0, 0}), filter(+1));
    EXPECT_EQ(power::nearer_decision({0, 0}, S{3, 0, 9}, S{0, 0, 0x1p-300}), exact(-1));
    EXPECT_EQ(power::nearer_decision({0, 0}, S{3, 0, 9}, S{0, 0, denormal}), multiprecision(-1));
    EXPECT_EQ(power::nearer_decision({0, 0}, Site{3, 0, -3}, Site{0, 0, 0x1p-70}), exact(-1));
    EXPECT_EQ(power::nearer_decision({0, 0}, Site{3, 0, 3}, Site{0, 0, 1e-300}),
              multiprecision(-1));
}

// ---- exists, hidden ----------------------------------------------------------------------------

TEST(PowerExists, IsCounterclockwise) {
    EXPECT_TRUE(power::exists(Point{0, 0}, Point{1, 0}, Point{0, 1}));
    EXPECT_FALSE(power::exists(Point{0, 0}, Point{0, 1}, Point{1, 0}));
    EXPECT_FALSE(power::exists(Site{0, 0, 1}, Site{1, 1, 2}, Site{2, 2, 3}));
    EXPECT_TRUE(power::exists(Point{0, 0}, Point{denormal, 0}, Point{0, denormal}));
}

TEST(PowerHidden, OnlyByAHeavierSiteAtTheSameCentre) {
    using S = power::Site;
    EXPECT_TRUE(power::hidden(S{1, 2, 3}, S{1, 2, 4}));
    EXPECT_TRUE(power::hidden(S{1, 2, 3}, S{1, 2, 3}));
    EXPECT_FALSE(power::hidden(S{1, 2, 3}, S{1, 2, 2}));
    EXPECT_FALSE(power::hidden(S{1, 2, 3}, S{1, 2 + 2 * ulp, 1e10}));
    EXPECT_FALSE(power::hidden(S{0, 0, 3}, S{denormal, 0, 1e10}));
    EXPECT_TRUE(power::hidden(S{0, 0.0, 3}, S{-0.0, -0.0, 3}));
    EXPECT_TRUE(power::hidden(S{0, 0, 0}, S{0, 0, denormal}));
    EXPECT_FALSE(power::hidden(S{0, 0, denormal}, S{0, 0, 0}));
    EXPECT_TRUE(power::hidden(Site{0, 0, 3}, Site{0, 0, -3}));
    EXPECT_TRUE(power::hidden(Site{0, 0, denormal}, Site{0, 0, -2 * denormal}));
    EXPECT_FALSE(power::hidden(Site{0, 0, 2 * denormal}, Site{0, 0, denormal}));
    EXPECT_TRUE(power::hidden(Point{5, 5}, Point{5, 5}));
    EXPECT_FALSE(power::hidden(Point{5, 5}, Point{5, 6}));
}

// ---- the tie rule ------------------------------------------------------------------------------

TEST(TieRule, OrderIsFallingWeightRisingPlaceIndex) {
    using S = power::Site;
    EXPECT_TRUE(power::precedes(S{9, 9, 2}, 9, S{0, 0, 1}, 0));
    EXPECT_TRUE(power::precedes(S{0, 9, 1}, 9, S{1, 0, 1}, 0));
    EXPECT_TRUE(power::precedes(S{1, 0, 1}, 9, S{1, 1, 1}, 0));
    EXPECT_TRUE(power::precedes(S{1, 1, 1}, 0, S{1, 1, 1}, 9));
    EXPECT_FALSE(power::precedes(S{1, 1, 1}, 9, S{1, 1, 1}, 0));
    EXPECT_TRUE(power::precedes(S{0.0, 1, 1}, 0, S{-0.0, 1, 1}, 1));
    EXPECT_TRUE(power::precedes(S{-0.0, 1, 1}, 0, S{0.0, 1, 1}, 1));
    // Radii count by their magnitude.
    EXPECT_TRUE(power::precedes(Site{9, 9, -2}, 9, Site{0, 0, 1}, 0));
    EXPECT_TRUE(power::precedes(Site{0, 0, -2}, 9, Site{1, 0, 2}, 0));
    EXPECT_TRUE(power::precedes(Point{0, 9}, 9, Point{1, 0}, 0));
    EXPECT_TRUE(power::precedes(S{9, 9, denormal}, 9, S{0, 0, 0}, 0));
}

/// The unit square: i, j, k counterclockwise, q the fourth corner. Lifting i, j or k lets q
/// conflict if q lies beyond the edge opposite; j lies across from q.
TEST(TieRule, UnitSquare) {
    const Point i{0, 0};
    const Point j{1, 0};
    const Point k{1, 1};
    const Point q{0, 1};
    // The last site of the order decides. q last: it is lifted, no conflict.
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {0, 1, 2, 3}), -1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {2, 0, 1, 3}), -1);
    // j last: the diagonal from i to k is its own enemy; lifted j leaves the diagonal.
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {0, 3, 1, 2}), -1);
    // i or k last: lifted above the plane of the others, so that the diagonal at it is flipped.
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {3, 1, 0, 2}), +1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {0, 1, 3, 2}), +1);
    // Only the order of the ranks counts.
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {-7, 900, 1 << 30, 5}), +1);
}

TEST(TieRule, CollinearTriplesArePassedOver) {
    // q on the edge from j to k, all lifted heights on one plane (weights |c|²). i last: moving it
    // changes nothing on the line j, k. Then k or j, whichever is last.
    const Point i{0, 0};
    const Point j{2, 0};
    const Point k{0, 2};
    const Point q{1, 1};
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {3, 0, 2, 1}), +1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {3, 2, 0, 1}), +1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, q, {3, 0, 1, 2}), -1);
    // q beyond k on that line: lifting j presses the line down at q.
    const Point beyond{-1, 3};
    EXPECT_EQ(power::in_circle_tie(i, j, k, beyond, {3, 2, 1, 0}), -1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, beyond, {3, 1, 2, 0}), +1);
    // q at the place of j: only j and q itself matter.
    EXPECT_EQ(power::in_circle_tie(i, j, k, j, {3, 1, 2, 0}), +1);
    EXPECT_EQ(power::in_circle_tie(i, j, k, j, {3, 0, 2, 1}), -1);
}

TEST(TieRule, OnALine) {
    const Point a{0, 0};
    const Point b{2, 0};
    for (const bool reversed : {false, true}) {
        const auto tie = [&](Point q, Index rank_a, Index rank_b, Index rank_q) {
            return reversed ? power::in_segment_tie(b, a, q, {rank_b, rank_a, rank_q})
                            : power::in_segment_tie(a, b, q, {rank_a, rank_b, rank_q});
        };
        // Between: a or b lifted, q conflicts; q lifted, it does not.
        EXPECT_EQ(tie({1, 0}, 2, 0, 1), +1);
        EXPECT_EQ(tie({1, 0}, 0, 2, 1), +1);
        EXPECT_EQ(tie({1, 0}, 1, 0, 2), -1);
        // Beyond b: a lifted lowers the line there, b lifted raises it.
        EXPECT_EQ(tie({3, 0}, 2, 1, 0), -1);
        EXPECT_EQ(tie({3, 0}, 1, 2, 0), +1);
        EXPECT_EQ(tie({-3, 0}, 2, 1, 0), +1);
        EXPECT_EQ(tie({-3, 0}, 1, 2, 0), -1);
        // At b: a is of no account.
        EXPECT_EQ(tie({2, 0}, 2, 1, 0), +1);
        EXPECT_EQ(tie({2, 0}, 2, 0, 1), -1);
    }
    EXPECT_EQ(power::in_segment_tie({0, 0}, {0, denormal}, {0, denormal}, {2, 1, 0}), +1);
}

/// Where two kinds of answers meet: the perturbed predicates are the exact ones, except at ties,
/// where they are never 0.
TEST(TieRule, PerturbedIsNeverZero) {
    int ties = 0;
    std::array<Point, 9> grid;
    for (int i = 0; i < 9; ++i) grid[static_cast<std::size_t>(i)] = {1.0 * (i / 3), 1.0 * (i % 3)};
    std::array<Index, 4> ranks{0, 1, 2, 3};
    for (const Point& i : grid)
        for (const Point& j : grid)
            for (const Point& k : grid)
                for (const Point& q : grid) {
                    if (!power::exists(i, j, k)) continue;
                    const Sign sign = power::in_circle(i, j, k, q);
                    ties += static_cast<int>(sign == 0);
                    do {
                        const Sign perturbed = power::in_circle_perturbed(i, j, k, q, ranks);
                        ASSERT_NE(perturbed, 0);
                        if (sign != 0) {
                            ASSERT_EQ(perturbed, sign);
                        }
                        // The vertex is the same from whichever site one starts.
                        ASSERT_EQ(perturbed,
                                  power::in_circle_perturbed(
                                      j, k, i, q, {ranks[1], ranks[2], ranks[0], ranks[3]}));
                        // Exchanging the roles of q and i, with q, j, k counterclockwise, negates.
                        if (power::exists(q, j, k)) {
                            ASSERT_EQ(-perturbed,
                                      power::in_circle_perturbed(
                                          q, j, k, i, {ranks[3], ranks[1], ranks[2], ranks[0]}));
                        }
                    } while (std::next_permutation(ranks.begin(), ranks.end()));
                }
    EXPECT_GT(ties, 500);
    std::array<Index, 3> line_ranks{0, 1, 2};
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
            for (int q = 0; q < 4; ++q) {
                if (a == b) continue;
                const auto s = [](int i) { return power::Site{1.0 * i, 2.0 * i, 5.0 * i * i}; };
                ASSERT_EQ(power::in_circle_infinite(s(a), s(b), s(q)), 0);
                do {
                    const Sign perturbed =
                        power::in_circle_infinite_perturbed(s(a), s(b), s(q), line_ranks);
                    ASSERT_NE(perturbed, 0);
                    ASSERT_EQ(perturbed,
                              power::in_circle_infinite_perturbed(
                                  s(b), s(a), s(q), {line_ranks[1], line_ranks[0], line_ranks[2]}));
                } while (std::next_permutation(line_ranks.begin(), line_ranks.end()));
            }
}

}  // namespace
}  // namespace signum
