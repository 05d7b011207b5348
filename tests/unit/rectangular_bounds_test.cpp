/// The filters of the supremum and Manhattan metrics are uncertain wherever the errors that their
/// sums may commit could have turned the sign, and of hardly more.

#include <array>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../predicates/additive.hpp"
#include "../../predicates/ladder/forms.hpp"
#include "../../predicates/rectangular/front.hpp"

#include "threshold.hpp"

namespace signum {
namespace {

using filters::epsilon;
using threshold::expect_first_certain;

/// Distances of 1 + r and 1, and radii that make up for r but for k epsilon of the larger.
TEST(RectangularBounds, OfNearer) {
    for (const double r : {0.0, 0x1p20}) {
        const double unit = r > 1.0 ? r : 1.0;
        const double size = ((1.0 + r) + 1.0 + r) / unit;
        expect_first_certain("nearer", 5 * size, 9 * size, [&](std::int64_t steps) {
            const double radius = r + static_cast<double>(steps) * epsilon * unit;
            return additive::nearer({1.0 + r, 1.0 + r, radius}, {1.0, 1.0, 0.0}).is_certain();
        });
    }
    for (const double of_a : {0.0, 1.0})
        expect_first_certain("one distance", 5, 9, [&](std::int64_t steps) {
            const double to_b = 1.0 + static_cast<double>(steps) * epsilon;
            return additive::nearer({1.0, of_a, 0.0}, {to_b, 1.0 - of_a, 0.0}).is_certain();
        });
}

/// A site, and one whose radius is k epsilon less: their forms differ by that.
template <class Directions>
struct Pair {
    using Forms = rectangular::Forms<Directions, Arithmetic::exact, 2>;
    Site one;
    Site other;
    Forms forms;

    Pair(const Site& site, std::int64_t steps)
        : one(site),
          other{site.x, site.y, site.r - static_cast<double>(steps) * epsilon},
          forms({&one, &other}, {0, 1}) {}
    bool is_filtered(Sign sign) const { return forms.decide(sign).stage == Stage::filter; }
};

template <class Directions>
void expect_bounds_of_forms() {
    using Asked = Pair<Directions>;
    // Each of the three terms of the size counts.
    for (const Site& site : {Site{1, 0, 1}, Site{0, 1, 1}, Site{1, 1, 1}}) {
        const double size = site.x + site.y + site.r;
        // Four roundings of a sum of four forms, each of the size.
        expect_first_certain("compare", 16 * size, 20 * size + 1, [&](std::int64_t steps) {
            Asked pair(site, steps);
            return pair.is_filtered(pair.forms.compare(0, 0, 1));
        });
        expect_first_certain("compare_widths", 16 * size, 20 * size + 2, [&](std::int64_t steps) {
            Asked pair(site, steps);
            return pair.is_filtered(pair.forms.compare_widths(0, 0, 0, 1, 0));
        });
        // Eleven of a sum of eight, four times the difference.
        expect_first_certain("compare_sum", 22 * size, 25 * size + 1, [&](std::int64_t steps) {
            Asked pair(site, steps);
            std::array<typename Asked::Forms::Term, 8> terms;
            for (std::size_t t = 0; t < 8; ++t) terms[t] = {0, t % 2, t % 2 == 0 ? -1 : 1};
            return pair.is_filtered(pair.forms.compare_sum(terms));
        });
    }
}
TEST(RectangularBounds, OfFormsOfSquares) {
    expect_bounds_of_forms<rectangular::Supremum>();
}
TEST(RectangularBounds, OfFormsOfDiamonds) {
    expect_bounds_of_forms<rectangular::Manhattan>();
}

TEST(RectangularBounds, OfTheSweepsForms) {
    for (const Site& site : {Site{1, 0, 0}, Site{0, 1, 0}, Site{0, 0, 1}}) {
        const rectangular::RoundedForms<rectangular::Manhattan, Arithmetic::exact> forms(site,
                                                                                         false);
        // Two roundings of a form taken twice, and three of the partial sums.
        EXPECT_GE(forms.error, 7 * epsilon);
        EXPECT_LE(forms.error, 9 * epsilon);
    }
}

/// Of numbers of so many bits sums of eight forms are doubles, and of no more.
TEST(RectangularBounds, OfSumsThatAreExact) {
    const auto are_exact = [](double greatest) {
        const Site sites[] = {{1, 0, 0}, {0, greatest, 0}};
        return rectangular::sums_are_exact(StridedSites(sites));
    };
    EXPECT_TRUE(are_exact(0x1p47));
    EXPECT_FALSE(are_exact(0x1p49));
}

}  // namespace
}  // namespace signum
