/// The bounds on the errors of approximate numbers and of the determinants of moving sites, beside
/// the roundings that they are derived from: none is less, whatever few of the errors a test would
/// meet.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../roots/approximation.hpp"
#include "../../triangulation/moving/bounded_forms.hpp"

#include "threshold.hpp"

namespace signum::kinetic {
namespace {

using filters::epsilon;
using threshold::expect_first_certain;

// ---- numbers with a bound ----------------------------------------------------------------------

constexpr double half_epsilon = 0x1p-53;

TEST(ApproximationBounds, OfSums) {
    const Approximation sum = Approximation(1.0) + Approximation(half_epsilon);
    EXPECT_EQ(sum.value, 1.0);
    EXPECT_GE(Approximation::slack * sum.error, half_epsilon);
    const Approximation known{1.0, 0x1p-20};
    const Approximation other{4.0, 0x1p-30};
    EXPECT_GE((known + other).error, 0x1p-20 + 0x1p-30);
    EXPECT_GE((known - other).error, 0x1p-20 + 0x1p-30);
}

TEST(ApproximationBounds, OfProducts) {
    const Approximation next(1.0 + epsilon);
    // Off by epsilon², and by as much as half an epsilon elsewhere.
    EXPECT_GE(Approximation::slack * (next * Approximation(1.5)).error, 1.5 * half_epsilon);
    const Approximation a{2.0, 0x1p-20};
    const Approximation b{8.0, 0x1p-10};
    EXPECT_GE((a * b).error, 2.0 * 0x1p-10 + 8.0 * 0x1p-20 + 0x1p-30);
    EXPECT_GE((b * a).error, 2.0 * 0x1p-10 + 8.0 * 0x1p-20 + 0x1p-30);
    const Approximation around_zero{0.0, 0x1p-10};
    EXPECT_GE((around_zero * around_zero).error, 0x1p-20);
}

TEST(ApproximationBounds, OfWhatUnderflows) {
    const Approximation tiny(0x1p-600);
    EXPECT_GE((tiny * tiny).error, 0x1p-1074);
    EXPECT_FALSE((tiny * tiny).has_sign());
    EXPECT_TRUE((tiny * Approximation(0.0)).is_zero());
    EXPECT_TRUE((Approximation(0.0) * tiny).is_zero());
}

TEST(ApproximationBounds, AreNotReachedByASign) {
    EXPECT_FALSE((Approximation{1.0, 1.0}.has_sign()));
    EXPECT_FALSE((Approximation{-1.0 - 0x1p-31, 1.0}.has_sign()));
    EXPECT_TRUE((Approximation{-1.0 - 0x1p-29, 1.0}.has_sign()));
    EXPECT_FALSE((Approximation{0.0, 0.0}.has_sign()));
}

// ---- moving sites ------------------------------------------------------------------------------

using Powers = std::array<double, 5>;
Powers product(const Powers& a, const Powers& b) {
    Powers result{};
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; i + j < 5; ++j) result[i + j] += a[i] * b[j];
    return result;
}

/// Sites about the last one, which rests in the origin: X and V are x and v, W is w. Differences to
/// it are exact, but are taken for rounded: h is an epsilon.
struct About {
    double x;
    double v;
    double w;

    [[nodiscard]] MovingSite site(double cosine, double sine) const {
        return {x * cosine, x * sine, v * sine, v * cosine, std::sqrt(w), 0.0};
    }
    [[nodiscard]] std::array<MovingSite, 4> sites() const {
        return {site(1, 0.5), site(-0.5, 1), site(-1, -0.75), MovingSite{}};
    }
    /// 2 P².
    [[nodiscard]] Powers of_turn() const { return {2 * x * x, 4 * x * v, 2 * v * v, 0, 0}; }
    /// 3 (2 P² + W) 2 P².
    [[nodiscard]] Powers of_circle() const {
        Powers height = of_turn();
        height[0] += w;
        Powers result = product(height, of_turn());
        for (double& c : result) c *= 3;
        return result;
    }
};

/// (1 + e)^(k + 4) (1 + h)^4 - 1.
void expect_errors(const PolynomialIn<Approximation, 4>& p, const Powers& size, int roundings) {
    const double least = (4 + (roundings + 4)) * epsilon;
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_GE(p.c[i].error, least * size[i]) << "coefficient " << i;
        EXPECT_LE(p.c[i].error, 1.1 * least * size[i]) << "coefficient " << i;
    }
}

TEST(KineticBounds, OfDeterminants) {
    for (const About& about : {About{1, 1, 0}, About{1, 0x1p-9, 64}, About{0x1p-9, 1, 0x1p-4}}) {
        const auto [a, b, c, q] = about.sites();
        const auto circle = bounded_in_circle(a, b, c, q, {{}, 0.0});
        const auto turn = bounded_orientation(a, b, q, {{}, 0.0});
        ASSERT_TRUE(circle && turn);
        expect_errors(*circle, about.of_circle(), bounded::roundings_of_determinant);
        expect_errors(*turn, about.of_turn(), bounded::roundings_of_cross);
    }
}

/// Where a site has come to by another origin is off by the roundings on the way there.
TEST(KineticBounds, OfPlacesFlownTo) {
    const MovingSite site{1, 0.5, 0x1p20, 0x1p10, 0, 0};
    const bounded::Here here(site, {{}, 2.0});
    EXPECT_GE(here.place_error, 3 * half_epsilon * 0x1p21);
    EXPECT_EQ(here.speed_error, 0.0);
    const bounded::Here fallen(site, {{0, 0x1p15}, 2.0});
    // Of what is added, five; of what it is added to, one.
    EXPECT_GE(fallen.place_error, 5 * half_epsilon * 0x1p21);
    EXPECT_GE(fallen.speed_error, 2 * half_epsilon * 0x1p16);
    // What is added takes it to the origin, so that only the five of it count.
    const bounded::Here arrived({-0x1.8p20, 0, 0x1p19, 0, 0, 0}, {{0x1p18, 0}, 2.0});
    EXPECT_EQ(arrived.x.c[0], 0.0);
    EXPECT_GE(arrived.place_error, 5 * half_epsilon * 0x1.8p20);
    const bounded::Here falling({1, 0.5, 1, 1, 0, 0}, {{0, 0x1p40}, 2.0});
    EXPECT_GE(falling.place_error, 5 * half_epsilon * 0x1p41);
    EXPECT_GE(falling.speed_error, 2 * half_epsilon * 0x1p41);
}

/// (1, 1) and (1, 1 + d) turn by d.
TEST(KineticBounds, OfTurns) {
    const auto is_certain = [](double d, double v, double radius) {
        return bounded_turn({1, 1, v, -v, 0, 0}, {1, 1 + d, v, v, 0, 0}, {}, {{}, 0.0}, radius)
            .is_certain();
    };
    // At rest each coordinate is off by an epsilon, of which the turn has four, and four of its
    // own.
    expect_first_certain("at rest", 7.9, 9.0, [&](std::int64_t steps) {
        return is_certain(static_cast<double>(steps) * epsilon, 0.0, 0.0);
    });
    // The turn changes by four times what the coordinates do.
    expect_first_certain("in motion", 4 * 0x1p10, 4.2 * 0x1p10, [&](std::int64_t steps) {
        return is_certain(static_cast<double>(steps) * 0x1p-30, 0x1p-10, 0x1p-10);
    });
    // And by twice their square: x² has to be above 4 x + 2.
    expect_first_certain(
        "in much motion", (2 + std::sqrt(6)) * 0x1p10, 4.6 * 0x1p10, [&](std::int64_t steps) {
            const double x = static_cast<double>(steps) * 0x1p-10;
            return bounded_turn({x, 0, 1, 1, 0, 0}, {0, x, 1, 1, 0, 0}, {}, {{}, 0.0}, 1.0)
                .is_certain();
        });
}

}  // namespace
}  // namespace signum::kinetic
