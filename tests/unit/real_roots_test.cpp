// Real roots of small known polynomials, and which stage found them.

#include "../../roots/polynomial.hpp"

#include <array>
#include <cfenv>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "../../roots/filter.hpp"
#include "../../roots/rounded.hpp"
#include "../first_change.hpp"
#include "exact_reference.hpp"

namespace {

using namespace signum::roots;
using signum::Sign;
using signum::reference::Hostile;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most = std::numeric_limits<double>::max();

/// By its coefficients.
template <int Degree>
struct Coefficients {
    std::array<double, Degree + 1> c;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, Degree> in() const {
        PolynomialIn<Number, Degree> p;
        for (std::size_t i = 0; i <= Degree; ++i) p.c[i] = constant<Number>(c[i]).c[0];
        return p;
    }
};
template <class... Doubles>
Coefficients<sizeof...(Doubles) - 1> coefficients(Doubles... c) {
    return {{c...}};
}

/// The product of all t - root, and a constant.
template <int Degree>
struct Factors {
    std::array<double, Degree> roots;
    double more = 0.0;

    template <class Number, std::size_t Count>
    [[nodiscard]] auto product() const {
        if constexpr (Count == 1) {
            return line<Number>(-roots[0], 1.0);
        } else {
            return product<Number, Count - 1>() * line<Number>(-roots[Count - 1], 1.0);
        }
    }
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, Degree> in() const {
        return product<Number, Degree>() + constant<Number>(more);
    }
};
template <class... Doubles>
Factors<sizeof...(Doubles)> with_roots(Doubles... roots) {
    return {{roots...}};
}

/// (t - 1 - 2^-59)² - 2^-140
struct Shifted {
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 2> in() const {
        const auto s = line<Number>(-1.0, 1.0) - constant<Number>(0x1p-59);
        return s * s - constant<Number>(0x1p-140);
    }
};

/// 2^-1200 t² - sign, by products
struct Far {
    double sign;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 2> in() const {
        auto small = constant<Number>(1.0);
        for (int i = 0; i < 16; ++i) small = small * constant<Number>(0x1p-150);
        return small * (line<Number>(0.0, 1.0) * line<Number>(0.0, 1.0)) - constant<Number>(sign);
    }
};

/// 0 by cancellation.
struct Cancelled {
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 2> in() const {
        const auto a = line<Number>(0.1, 0.3);
        const auto b = line<Number>(0.7, -0.2);
        return (a + b) * (a - b) - (a * a - b * b);
    }
};

/// Leading coefficients that are exactly 0 are no uncertain ones.
struct Rest {
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 4> in() const {
        const auto a = line<Number>(0.1, 0.0) - line<Number>(0.3, 0.0);
        const auto b = line<Number>(0.7, 0.2) - line<Number>(1.1, 0.2);
        return a * b * line<Number>(0.7, -0.2) * a;
    }
};

struct Huge {
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 8> in() const {
        const auto a = line<Number>(-0x1p150, 0x1p150);
        const auto b = a * a * a * a;
        return b * b;
    }
};

void expect_filtered(const Tally& tally) {
    EXPECT_GT(tally.filtered, 0U);
    EXPECT_EQ(tally.exact, 0U);
}
void expect_exact(const Tally& tally) {
    EXPECT_EQ(tally.filtered, 0U);
    EXPECT_GT(tally.exact, 0U);
}

TEST(RealRoots, OfChebyshevsPolynomialByTheFilter) {
    const auto form = coefficients(1.0, 0.0, -32.0, 0.0, 160.0, 0.0, -256.0, 0.0, 128.0);
    const Polynomial p(form);
    Tally tally;
    const RealRoots roots = p.real_roots(&tally);
    expect_filtered(tally);
    ASSERT_EQ(roots.count, 8);
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(roots[i].multiplicity, 1);
        EXPECT_EQ(roots[i].after, i % 2 == 0 ? -1 : 1);
        EXPECT_NEAR(p.nearest_double(roots[i]), -std::cos((2 * i + 1) * std::acos(-1.0) / 16),
                    0x1p-51);
    }
}

TEST(RealRoots, OfWilkinsonsPolynomial) {
    const auto form = with_roots(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0);
    const Polynomial p(form);
    Tally tally;
    const RealRoots roots = p.real_roots(&tally);
    expect_filtered(tally);
    ASSERT_EQ(roots.count, 8);
    for (int i = 0; i < 8; ++i) {
        EXPECT_EQ(p.nearest_double(roots[i]), i + 1);
        EXPECT_EQ(compare(RootOf{p, roots[i]}, i + 1.0), 0);
        const Root narrow = p.narrowed(roots[i]);
        EXPECT_TRUE(narrow.is_double());
        EXPECT_EQ(narrow.low, i + 1);
    }
    double t = -5;
    for (int i = 0; i < 8; ++i) {
        const auto change = first_change(p, t);
        ASSERT_TRUE(change);
        EXPECT_EQ(p.nearest_double(*change), i + 1);
        t = i + 1;
    }
    EXPECT_FALSE(first_change(p, 8.0));
}

/// The doubles around a root are too near to it for the filter, and not for double-doubles.
TEST(RealRoots, AreNarrowedWithoutIntegers) {
    const auto form = coefficients(-2.0, 0.0, 1.0);
    const auto steep = coefficients(-0x1.6p-400, 0.0, 0.0, 0.3, 0x1.1p-500);
    const Polynomial of_two(form);
    const Polynomial of_steep(steep);
    for (const Polynomial* const one : {&of_two, &of_steep}) {
        const Polynomial& p = *one;
        const auto root = p.first_root(0.0);
        ASSERT_TRUE(root && root->alone);
        Tally tally;
        const Root narrow = p.narrowed(*root, &tally);
        expect_filtered(tally);
        EXPECT_EQ(narrow.high, std::nextafter(narrow.low, infinity));
        EXPECT_EQ(p.sign_at(narrow.low, &tally), -1);
        EXPECT_EQ(p.sign_at(narrow.high, &tally), 1);
        EXPECT_EQ(compare(RootOf{p, *root}, narrow.low, &tally), 1);
        expect_filtered(tally);
    }
    EXPECT_EQ(of_two.narrowed(*of_two.first_root(0.0)).high, std::sqrt(2.0));
    // Where even these do not tell, integers do.
    const Factors<2> apart{{1.0, 1.0}, -0x1p-150};
    const Polynomial p(apart);
    Tally tally;
    EXPECT_EQ(p.sign_at(1.0, &tally), -1);
    EXPECT_EQ(p.sign_at(1.0 + 0x1p-52, &tally), 1);
}

TEST(RealRoots, WithMultiplicitiesByTheExactStage) {
    const auto form = with_roots(-1.0, -1.0, 0.5, 0.5, 0.5, 3.0, 3.0, 7.0);
    const Polynomial p(form);
    Tally tally;
    const RealRoots roots = p.real_roots(&tally);
    expect_exact(tally);
    ASSERT_EQ(roots.count, 4);
    const double expected[] = {-1.0, 0.5, 3.0, 7.0};
    const int multiplicity[] = {2, 3, 2, 1};
    const int after[] = {1, -1, -1, 1};
    for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(roots[i].is_double());
        EXPECT_EQ(roots[i].low, expected[i]);
        EXPECT_EQ(roots[i].multiplicity, multiplicity[i]);
        EXPECT_EQ(roots[i].after, after[i]);
    }
    EXPECT_EQ(p.nearest_double(*first_change(p, -9.0)), 0.5);
    EXPECT_EQ(p.nearest_double(*first_change(p, 0.5)), 7.0);
    EXPECT_EQ(p.nearest_double(*first_change(p, RootOf{p, roots[1]})), 7.0);
}

TEST(RealRoots, ThatTouchAreNoChange) {
    const auto form = with_roots(1.0, 1.0);
    const Polynomial p(form);
    Tally tally;
    EXPECT_FALSE(first_change(p, 0.0, &tally));
    expect_exact(tally);
    EXPECT_EQ(p.sign_at(1.0), 0);
    EXPECT_EQ(p.sign_after(1.0), 1);
    // Pulled below 0 by the least that it may be.
    const Factors<2> apart{{1.0, 1.0}, -0x1p-150};
    const Polynomial q(apart);
    const RealRoots roots = q.real_roots();
    ASSERT_EQ(roots.count, 2);
    EXPECT_EQ(roots[0].low, std::nextafter(1.0, 0.0));
    EXPECT_EQ(roots[0].high, 1.0);
    EXPECT_EQ(roots[1].low, 1.0);
    EXPECT_EQ(compare(RootOf{q, roots[0]}, RootOf{q, roots[1]}), -1);
    EXPECT_EQ(q.sign_at(1.0), -1);
    // And lifted.
    const Factors<2> none{{1.0, 1.0}, 0x1p-150};
    EXPECT_EQ(Polynomial(none).real_roots().count, 0);
}

TEST(RealRoots, AnUlpApart) {
    const double next = std::nextafter(1.0, 2.0);
    const auto form = with_roots(1.0, next);
    const Polynomial p(form);
    const RealRoots roots = p.real_roots();
    ASSERT_EQ(roots.count, 2);
    EXPECT_EQ(p.nearest_double(roots[0]), 1.0);
    EXPECT_EQ(p.nearest_double(roots[1]), next);
    EXPECT_EQ(p.sign_after(1.0), -1);
    EXPECT_EQ(p.sign_after(next), 1);
}

TEST(RealRoots, SeveralBetweenTwoDoubles) {
    const auto form = coefficients(0x1p-118 - 0x1p-140, -0x1p-58, 1.0);  // (t - 2^-59)² - 2^-140
    const Shifted shifted;
    const Polynomial p(shifted);
    const RealRoots roots = p.real_roots();
    ASSERT_EQ(roots.count, 2);
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(roots[i].low, 1.0);
        EXPECT_EQ(roots[i].high, std::nextafter(1.0, 2.0));
        EXPECT_EQ(roots[i].place, i + 1);
        EXPECT_EQ(p.nearest_double(roots[i]), 1.0);
        EXPECT_EQ(compare(RootOf{p, roots[i]}, 1.0), 1);
    }
    EXPECT_EQ(compare(RootOf{p, roots[0]}, RootOf{p, roots[1]}), -1);
    EXPECT_EQ(compare(RootOf{p, roots[1]}, RootOf{p, roots[1]}), 0);
    const auto second = first_change(p, RootOf{p, roots[0]});
    ASSERT_TRUE(second);
    EXPECT_EQ(second->place, 2);
    EXPECT_FALSE(first_change(p, RootOf{p, roots[1]}));
    EXPECT_EQ(Polynomial(form).real_roots().count, 2);
}

TEST(RealRoots, BeyondTheDoubles) {
    const Far far{1.0};
    const Polynomial p(far);
    Tally tally;
    const RealRoots roots = p.real_roots(&tally);
    expect_exact(tally);
    ASSERT_EQ(roots.count, 2);
    EXPECT_EQ(roots[0].low, -infinity);
    EXPECT_EQ(roots[0].high, -most);
    EXPECT_EQ(roots[1].low, most);
    EXPECT_EQ(roots[1].high, infinity);
    EXPECT_EQ(p.nearest_double(roots[0]), -infinity);
    EXPECT_EQ(p.nearest_double(roots[1]), infinity);
    EXPECT_EQ(p.sign_at(most), -1);
    EXPECT_EQ(compare(RootOf{p, roots[0]}, -most), -1);
    EXPECT_EQ(compare(RootOf{p, roots[0]}, RootOf{p, roots[1]}), -1);
    EXPECT_FALSE(first_change(p, RootOf{p, roots[1]}));
    const auto line_form = with_roots(5.0, 6.0);
    const Polynomial q(line_form);
    EXPECT_EQ(q.sign_at(RootOf{p, roots[0]}), 1);
    EXPECT_EQ(q.sign_after(RootOf{p, roots[1]}), 1);
    EXPECT_EQ(q.nearest_double(*first_change(q, RootOf{p, roots[0]})), 5.0);
    EXPECT_FALSE(first_change(q, RootOf{p, roots[1]}));
    EXPECT_EQ(first_change(p, RootOf{q, q.real_roots()[0]})->low, most);
}

TEST(RealRoots, OfConstantsAndOfZero) {
    const auto five = coefficients(-5.0);
    const Polynomial p(five);
    Tally tally;
    EXPECT_EQ(p.real_roots(&tally).count, 0);
    EXPECT_FALSE(p.real_roots(&tally).everywhere);
    EXPECT_FALSE(first_change(p, 1.0, &tally));
    EXPECT_EQ(p.sign_after(1.0, &tally), -1);
    EXPECT_FALSE(p.is_zero(&tally));
    const auto nothing = coefficients(0.0, 0.0, 0.0);
    const Polynomial zero(nothing);
    EXPECT_TRUE(zero.is_zero(&tally));
    EXPECT_TRUE(zero.real_roots(&tally).everywhere);
    EXPECT_FALSE(first_change(zero, 1.0, &tally));
    EXPECT_EQ(zero.sign_after(1.0, &tally), 0);
    expect_filtered(tally);

    const Cancelled form;
    const Polynomial cancelled(form);
    Tally exact;
    EXPECT_TRUE(cancelled.is_zero(&exact));
    EXPECT_TRUE(cancelled.real_roots(&exact).everywhere);
    EXPECT_FALSE(first_change(cancelled, 0.0, &exact));
    EXPECT_EQ(cancelled.sign_after(1.0, &exact), 0);
    expect_exact(exact);
}

TEST(RealRoots, OfPointsAtRestByTheFilter) {
    const Rest form;
    const Polynomial p(form);
    EXPECT_EQ(p.approximate().degree, 1);
    Tally tally;
    ASSERT_TRUE(first_change(p, 0.0, &tally));
    EXPECT_FALSE(first_change(p, 4.0, &tally));
    expect_filtered(tally);
}

TEST(RealRoots, OfDifferentPolynomialsAreComparedExactly) {
    const auto two = coefficients(-2.0, 0.0, 1.0);             // √2
    const auto four = coefficients(-4.0, 0.0, 0.0, 0.0, 1.0);  // √2 once more
    const auto near = coefficients(-2.0 - 0x1p-51, 0.0, 1.0);
    const auto square = coefficients(4.0, 0.0, -4.0, 0.0, 1.0);  // (t² - 2)²
    const Polynomial p(two), q(four), r(near), s(square);
    const auto change = [](const Polynomial& polynomial) { return *first_change(polynomial, 0.0); };
    const RootOf of_p{p, change(p)};
    const RootOf of_q{q, change(q)};
    const RootOf of_r{r, change(r)};
    Tally tally;
    EXPECT_EQ(compare(of_p, of_q, &tally), 0);
    EXPECT_EQ(compare(of_p, of_r, &tally), -1);
    EXPECT_EQ(compare(of_r, of_q, &tally), 1);
    EXPECT_EQ(q.sign_at(of_p, &tally), 0);
    EXPECT_EQ(q.sign_after(of_p, &tally), 1);
    EXPECT_EQ(s.sign_at(of_p, &tally), 0);
    EXPECT_EQ(s.sign_after(of_p, &tally), 1);
    expect_exact(tally);
    EXPECT_EQ(r.sign_at(of_p), -1);
    EXPECT_FALSE(first_change(q, of_p));
    EXPECT_TRUE(first_change(r, of_p));
    const RealRoots touching = s.real_roots();
    ASSERT_EQ(touching.count, 2);
    EXPECT_EQ(touching[1].multiplicity, 2);
    EXPECT_EQ(compare(RootOf{s, touching[1]}, of_q), 0);
    EXPECT_EQ(compare(RootOf{s, touching[0]}, of_q), -1);
    EXPECT_EQ(s.nearest_double(touching[1]), std::sqrt(2.0));
    // Of the same root the polynomial times -1 knows the opposite signs.
    const auto minus = coefficients(2.0, 0.0, -1.0);
    const Polynomial negative(minus);
    const RootOf mirrored{negative, of_p.root.of_negative()};
    EXPECT_EQ(compare(mirrored, 1.0), 1);
    EXPECT_EQ(compare(mirrored, 1.5), -1);
    EXPECT_EQ(negative.sign_after(mirrored), -1);
}

TEST(RealRoots, ATieAtTheStart) {
    // 0 at 0.1 by cancellation: which root is next is told all the same.
    const auto form = with_roots(0.1, 0.3, 0.7, 5.0);
    const Polynomial p(form);
    Tally tally;
    const auto change = first_change(p, 0.1, &tally);
    expect_exact(tally);
    ASSERT_TRUE(change);
    EXPECT_EQ(p.nearest_double(*change), 0.3);
    EXPECT_EQ(p.sign_after(0.1), -1);
}

TEST(RealRoots, SayNothingBeyondTheRangeOfDoubles) {
    const Huge form;
    const Polynomial p(form);
    Tally tally;
    EXPECT_EQ(p.sign_at(3.0, &tally), 1);
    EXPECT_EQ(p.sign_at(1.0, &tally), 0);
    EXPECT_FALSE(first_change(p, 0.0, &tally));
    expect_exact(tally);
}

TEST(RealRoots, InOtherRoundingModesAreExact) {
    const auto form = with_roots(1.0, 2.0, 3.0, 4.0);
    const Polynomial before(form);
    Tally tally;
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    const Polynomial p(form);
    const auto change = first_change(p, 0.0, &tally);
    const auto other = first_change(before, 0.0, &tally);
    const int sign = p.sign_at(2.5, &tally);
    const double nearest = change ? p.nearest_double(*change) : 0.0;
    ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
    expect_exact(tally);
    ASSERT_TRUE(change && other);
    EXPECT_EQ(nearest, 1.0);
    EXPECT_EQ(sign, 1);
    EXPECT_EQ(p.sign_at(2.5, &tally), 1);
}

/// (2x - 2d)(4x - 4d) + x with the denormal d: the last root, near -8d², lies between -d and 0.
struct AtADenormal {
    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 2> in() const {
        constexpr double d = std::numeric_limits<double>::denorm_min();
        const auto x = line<Number>(0.0, 1.0);
        const auto twice = line<Number>(-2.0 * d, 2.0);
        const auto four_times = line<Number>(-4.0 * d, 4.0);
        return twice * four_times + x;
    }
};
TEST(RealRoots, WhereDenormalsAreFlushedAreExact) {
    const AtADenormal form;
    for (int mode = 0; mode < Hostile::modes; ++mode) {
        double nearest = 1.0;
        Sign order = 0;
        {
            const Hostile environment(mode);
            const Polynomial p(form);
            const RealRoots roots = p.real_roots();
            const Root& last = roots[roots.size() - 1];
            nearest = p.nearest_double(last);
            order = compare({p, last}, -std::numeric_limits<double>::denorm_min());
        }
        EXPECT_EQ(nearest, 0.0) << "mode " << mode;
        EXPECT_EQ(order, 1) << "mode " << mode;
    }
}

/// t - 1 - n 2^-53
struct Halfway {
    double n;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 1> in() const {
        return line<Number>(-1.0, 1.0) - constant<Number>(n * 0x1p-53);
    }
};
TEST(RealRoots, OfTwoDoublesThatAreAsNearTheEvenOneIsTheNearest) {
    for (const double n : {1.0, 3.0, 5.0, 7.0}) {
        const Halfway form{n};
        const Polynomial p(form);
        EXPECT_EQ(p.nearest_double(*first_change(p, 0.0)), 1.0 + n * 0x1p-53) << n;
    }
}

/// t² - 2(1 + 2^-30) t + 1 + 2^-29 + more: of 2^-60 more it touches 0.
struct AboutToTouch {
    double more;

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 2> in() const {
        constexpr double a = 1.0 + 0x1p-30;
        const auto t = line<Number>(0.0, 1.0);
        return t * t - constant<Number>(2.0 * a) * t + constant<Number>(1.0 + 0x1p-29) +
               constant<Number>(more);
    }
};
/// Digits that a double has no room for decide whether there are roots.
TEST(RealRoots, ThatDependOnDigitsThatAreCutOff) {
    const auto count = [](double more) {
        const AboutToTouch form{more};
        return Polynomial(form).real_roots().count;
    };
    EXPECT_EQ(count(0.0), 2);
    EXPECT_EQ(count(0x1p-61), 2);
    EXPECT_EQ(count(0x1p-60), 1);
    EXPECT_EQ(count(0x1p-59), 0);
    EXPECT_EQ(count(0x1p-54), 0);
}

/// What is cut off of 2^60 - 1 lies within the error, and 2^60 is told as it is but for the scale.
TEST(RealRoots, OfRoundedCoefficientsErrorsCoverWhatIsCutOff) {
    const signum::exact::Integer power = signum::exact::Integer(1) << 60;
    const Approximations told = rounded({power - 1, power, -power - 1}, 0);
    const double one = told.c[1].value;
    EXPECT_EQ(told.degree, 2);
    EXPECT_LT(told.c[0].value, one);
    EXPECT_GE(told.c[0].error, 0.99 * (one - told.c[0].value));
    EXPECT_EQ(told.c[2].value, -one);
    EXPECT_GE(told.c[2].error, 0x1p-60 * one);
}

/// 1 + c t + t² has no root for c = 1, and two for c = -3.
TEST(RealRoots, OfACoefficientThatMayBeAnythingAreNotTold) {
    Approximations p{};
    p.degree = 2;
    p.c[0] = p.c[2] = Approximation(1.0);
    p.c[1] = {0.5, 0.25};
    EXPECT_TRUE(filter::first_root(p, 0.0, 0).certain);
    p.c[1] = {0.1, 4.0};
    EXPECT_FALSE(filter::first_root(p, 0.0, 0).certain);
}

/// (t - 1)^n, the coefficients of which are moved by a few of their last digits: about 1 the sums
/// that tell the roots cancel to what they round.
template <int Degree>
void expect_exact_near_a_multiple_root(Coefficients<Degree> form, Tally& tally) {
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<int>(state >> 59) - 16;
    };
    const Coefficients<Degree> multiple = form;
    for (int trial = 0; trial < 600; ++trial) {
        for (std::size_t i = 0; i <= Degree; ++i)
            form.c[i] = multiple.c[i] *
                        (1.0 + std::ldexp(random(), (trial % 2 == 0 ? -20 : -49) - trial % 6));
        const RealRoots told = Polynomial(form).real_roots(&tally);
        ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
        const RealRoots exact = Polynomial(form).real_roots();
        ASSERT_EQ(std::fesetround(FE_TONEAREST), 0);
        ASSERT_EQ(told.count, exact.count) << trial;
    }
}
TEST(RealRoots, NearAMultipleOneAreThoseOfTheExactStage) {
    Tally tally;
    expect_exact_near_a_multiple_root(coefficients(1.0, -4.0, 6.0, -4.0, 1.0), tally);
    expect_exact_near_a_multiple_root(
        coefficients(1.0, -8.0, 28.0, -56.0, 70.0, -56.0, 28.0, -8.0, 1.0), tally);
    EXPECT_GT(tally.filtered, 10U);
    EXPECT_GT(tally.exact, 10U);
}

}  // namespace
