// Polynomials and their roots: multiplicities, roots that are near one another, rounding.

#include "../../exact/polynomial.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "../../exact/nearest_double.hpp"

namespace {

using signum::exact::Dyadic;
using signum::exact::Integer;
using signum::exact::nearest_double;
using signum::exact::odd_part;
using signum::exact::Polynomial;
using signum::exact::Roots;

constexpr double infinity = std::numeric_limits<double>::infinity();

Dyadic dyadic(double x) {
    return Dyadic(x);
}

/// The product of all t - root.
Polynomial with_roots(const std::vector<double>& roots) {
    Polynomial product{dyadic(1)};
    for (const double root : roots) product = product * Polynomial{dyadic(-root), dyadic(1)};
    return product;
}

TEST(Polynomial, Arithmetic) {
    const Polynomial p{dyadic(0.25), dyadic(0), dyadic(-3)};
    const Polynomial q{dyadic(0x1p70), dyadic(1)};
    EXPECT_EQ(p.degree(), 2);
    EXPECT_EQ((p - p).degree(), -1);
    EXPECT_EQ((p - p).sign_at(dyadic(1)), 0);
    EXPECT_EQ((p + q).degree(), 2);
    EXPECT_EQ((p * q).degree(), 3);
    EXPECT_EQ((p * q - q * p).degree(), -1);
    EXPECT_EQ(((p + q) * p - p * p - q * p).degree(), -1);
    EXPECT_EQ((p * (p - p)).degree(), -1);
    EXPECT_EQ((p.value_at(dyadic(0.5)) - dyadic(-0.5)).sign(), 0);
    EXPECT_EQ(p.sign_at(dyadic(0.25)), 1);
    EXPECT_EQ(p.sign_at(dyadic(-8)), -1);
    EXPECT_EQ(q.sign_at(dyadic(-0x1p70)), 0);
    EXPECT_EQ((p.derivative() - Polynomial{dyadic(0), dyadic(-6)}).degree(), -1);
    EXPECT_EQ(p.sign_at_infinity(), -1);
    EXPECT_EQ((Polynomial{dyadic(0), dyadic(0)}).degree(), -1);
}

TEST(Polynomial, OddPartHasTheChangesOfSign) {
    // Multiplicities 1 to 5, and 7.
    std::vector<double> roots;
    const std::vector<int> multiplicity = {1, 2, 3, 4, 5, 7};
    for (std::size_t i = 0; i < multiplicity.size(); ++i)
        roots.insert(roots.end(), static_cast<std::size_t>(multiplicity[i]),
                     0.5 * static_cast<double>(i));
    for (const Polynomial& p : {with_roots(roots), Polynomial{} - with_roots(roots)}) {
        const Polynomial odd = odd_part(p);
        EXPECT_EQ(odd.degree(), 4);
        for (const double root : {0.0, 1.0, 2.0, 2.5}) EXPECT_EQ(odd.sign_at(dyadic(root)), 0);
        for (const double root : {0.5, 1.5}) EXPECT_NE(odd.sign_at(dyadic(root)), 0);
    }
    EXPECT_EQ(odd_part(with_roots({3, 3})).degree(), 0);
    EXPECT_EQ(odd_part(Polynomial{dyadic(-7)}).degree(), 0);
    // (t² - 2)² (t² - 3)
    const Polynomial two{dyadic(-2), dyadic(0), dyadic(1)};
    const Polynomial three{dyadic(-3), dyadic(0), dyadic(1)};
    const Roots roots_of_three(odd_part(two * two * three));
    EXPECT_EQ(roots_of_three.after(dyadic(-5)), 2);
    EXPECT_EQ(roots_of_three.nearest_double(dyadic(0), 1), std::sqrt(3.0));
}

TEST(Roots, AreCountedAndRounded) {
    const Roots roots(with_roots({-1, 0, 0.5, 3}));
    EXPECT_EQ(roots.after(dyadic(-2)), 4);
    EXPECT_EQ(roots.after(dyadic(-1)), 3);
    EXPECT_EQ(roots.after(dyadic(3)), 0);
    EXPECT_EQ(roots.between(dyadic(-1), dyadic(0)), 1);
    EXPECT_EQ(roots.between(dyadic(0), dyadic(0.5)), 1);
    EXPECT_EQ(roots.between(dyadic(0), dyadic(0.25)), 0);
    EXPECT_EQ(roots.nearest_double(dyadic(-2), 1), -1);
    EXPECT_EQ(roots.nearest_double(dyadic(-1), 1), 0);
    EXPECT_EQ(roots.nearest_double(dyadic(-1), 3), 3);
    EXPECT_EQ(roots.nearest_double(dyadic(-1), 4), infinity);
    EXPECT_EQ(Roots(Polynomial{dyadic(5)}).after(dyadic(0)), 0);
}

TEST(Roots, ThatAreNeighbours) {
    const double next = std::nextafter(1.0, 2.0);
    const Roots roots(with_roots({1, next}));
    EXPECT_EQ(roots.nearest_double(dyadic(0), 1), 1);
    EXPECT_EQ(roots.nearest_double(dyadic(0), 2), next);
    const auto isolated = roots.isolate(dyadic(0), 2);
    ASSERT_TRUE(isolated);
    EXPECT_GE(isolated->low, dyadic(1));
    // Two in the gap between two doubles: (t - 1)(t - 1 - 2^-53 (1 ± 2^-20)).
    const Dyadic half = dyadic(1) + dyadic(0x1p-53);
    const Dyadic bit(Integer(1), -73);
    const Roots halves(Polynomial{-(half - bit), dyadic(1)} * Polynomial{-half, dyadic(1)} *
                       Polynomial{-(half + bit), dyadic(1)});
    EXPECT_EQ(halves.nearest_double(dyadic(0), 1), 1);
    EXPECT_EQ(halves.nearest_double(dyadic(0), 2), 1);  // half way, to the even one
    EXPECT_EQ(halves.nearest_double(dyadic(0), 3), next);
}

TEST(Roots, AreHalvedTowards) {
    const Roots roots(Polynomial{dyadic(-2), dyadic(0), dyadic(1)});
    auto root = roots.isolate(dyadic(-8), 2);
    ASSERT_TRUE(root);
    for (int i = 0; i < 100; ++i) roots.halve(*root);
    EXPECT_LT(root->high - root->low, Dyadic(Integer(1), -95));
    EXPECT_EQ(roots.between(root->low, root->high), 1);
    EXPECT_EQ(roots.nearest_double(*root), std::sqrt(2.0));
}

TEST(NearestDouble, OfNumbersOfEverySize) {
    const auto nearest = [](const Dyadic& number) {
        return nearest_double([&](const Dyadic& x) { return (number - x).sign(); });
    };
    constexpr double tiny = std::numeric_limits<double>::denorm_min();
    constexpr double huge = std::numeric_limits<double>::max();
    for (const double x : {0.0, 1.0, -1.0, tiny, -tiny, 3 * tiny, huge, -huge, 0.1, -1e300})
        EXPECT_EQ(nearest(dyadic(x)), x);
    const auto times_half = [](int k, double x) { return dyadic(0.5) * (k * dyadic(x)); };
    EXPECT_EQ(nearest(times_half(1, tiny)), 0);
    EXPECT_EQ(nearest(times_half(3, tiny)), 2 * tiny);
    EXPECT_EQ(nearest(times_half(-1, tiny)), 0);
    EXPECT_EQ(nearest(times_half(-3, tiny)), -2 * tiny);
    const Dyadic end(Integer(1), 1024);
    const Dyadic half_unit(Integer(1), 970);
    EXPECT_EQ(nearest(end), infinity);
    EXPECT_EQ(nearest(-end - end), -infinity);
    EXPECT_EQ(nearest(end - half_unit), infinity);
    EXPECT_EQ(nearest(half_unit - end), -infinity);
    EXPECT_EQ(nearest(end - half_unit - dyadic(tiny)), huge);
    EXPECT_EQ(nearest(dyadic(tiny) + half_unit - end), -huge);
}

}  // namespace
