// The judge's filters and dyadic numbers never change a judgement: with them and in rationals alone
// the same is said, of right results and wrong ones, of sites in degenerate position and of any
// doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "../../exact/floating_environment.hpp"
#include "../../triangulation/check/additive_check.hpp"
#include "../../triangulation/check/power_check.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

using brute_force::Degenerate;
using reference::Random;
using Sites = std::vector<Site>;

const int rounds = is_fast ? 500 : 100;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

template <class S>
Validation in_rationals(const TessellationArrays& arrays, const Sites& sites) {
    using Rationals = any_dimension::Questions<S, exact::Rational, false>;
    return triangulation::PowerCheck<S, Rationals>(arrays, sites, {}).run();
}

/// Passes over nothing.
struct Anywhere {
    triangulation::Interval operator()(const triangulation::Reach&) const {
        return triangulation::Interval::everything();
    }
};

/// The judgement without a filter.
Validation in_rationals(const TessellationArrays& arrays, const Sites& sites) {
    using namespace triangulation;
    constexpr auto rationals = Arithmetic::multiprecision;
    const exact::IeeeEnvironment environment;
    return with_metric(arrays.metric, [&]<class M>(M) {
        if constexpr (M::traits.edges_are_straight) {
            return in_rationals<Site>(arrays, sites);
        } else {
            if (M::traits.is_delaunay_for_equal_radii &&
                std::all_of(sites.begin(), sites.end(),
                            [&](const Site& site) { return site.r == sites[0].r; }))
                return in_rationals<power::Site>(arrays, sites);
            using Predicates = typename PredicatesOf<M>::template Perturbed<rationals>;
            return AdditiveCheck<Predicates, Anywhere>(arrays, sites, {}).run();
        }
    });
}

double real(Random& random) {
    return static_cast<double>(random.engine()() >> 11) * 0x1p-53;
}

/// Any finite double: its bits are drawn.
double any_double(Random& random) {
    for (;;) {
        const auto number = std::bit_cast<double>(random.engine()());
        if (std::isfinite(number)) return number;
    }
}

struct Kind {
    const char* name;
    void (*draw)(Degenerate&, Sites&);
};
void scale(Sites& sites, double factor) {
    for (Site& site : sites) site = {site.x * factor, site.y * factor, site.r * factor};
}
void draw_degenerate(Degenerate& from, Sites& sites) {
    from.fill(from.random().below(Degenerate::families), sites.data(), sites.size());
}
const std::array kinds = {
    Kind{"random",
         [](Degenerate& from, Sites& sites) {
             for (Site& site : sites)
                 site = {real(from.random()), real(from.random()), 0.2 * real(from.random())};
         }},
    Kind{"degenerate", draw_degenerate},
    Kind{"nearly_degenerate",
         [](Degenerate& from, Sites& sites) {
             draw_degenerate(from, sites);
             for (Site& site : sites)
                 if (from.random().coin()) site.x = std::nextafter(site.x, 100.0);
         }},
    Kind{"huge",
         [](Degenerate& from, Sites& sites) {
             draw_degenerate(from, sites);
             scale(sites, 0x1p1015);
         }},
    Kind{"tiny",
         [](Degenerate& from, Sites& sites) {
             draw_degenerate(from, sites);
             scale(sites, 0x1p-1074);
         }},
    Kind{"any_bits", [](Degenerate& from, Sites& sites) {
             for (Site& site : sites)
                 site = {any_double(from.random()), any_double(from.random()),
                         any_double(from.random())};
         }}};

/// Changes a number or an order.
void corrupt(TessellationArrays& arrays, Random& random) {
    const auto any_of = [&](auto& list) -> auto& {
        return list[at(random.below(static_cast<int>(list.size())))];
    };
    const auto site = [&] { return random.between(-1, static_cast<int>(arrays.sites) - 1); };
    switch (random.below(5)) {
        case 0:
            if (!arrays.faces.empty()) any_of(arrays.faces)[at(random.below(3))] = site();
            break;
        case 1:
            if (!arrays.faces.empty()) std::swap(any_of(arrays.faces), any_of(arrays.faces));
            break;
        case 2:
            if (!arrays.hidden.empty()) any_of(arrays.hidden).by = site();
            break;
        case 3:
            arrays.neighbours.clear();
            break;
        default:  // no error, but not the order of the library's own arrays
            if (arrays.faces.empty()) break;
            const std::size_t f = at(random.below(static_cast<int>(arrays.faces.size())));
            for (Face* face : {&arrays.faces[f], &arrays.neighbours[f]})
                std::rotate(face->begin(), face->begin() + 1, face->end());
    }
}

class ValidateFilters : public testing::TestWithParam<std::tuple<Metric, Kind>> {};

TEST_P(ValidateFilters, SayWhatRationalsSay) {
    const auto& [metric, kind] = GetParam();
    Degenerate from(17);
    Random& random = from.random();
    std::array<int, 3> judged = {};  // invalid, valid alone, canonical
    std::uint64_t filtered = 0;
    std::uint64_t left_open = 0;
    for (int round = 0; round < rounds; ++round) {
        Sites sites(at(random.between(2, 12)));
        kind.draw(from, sites);
        // The result of other sites, where some are moved afterwards.
        Sites built_of = sites;
        if (random.below(3) == 0) {
            Sites others(1);
            kind.draw(from, others);
            built_of[at(random.below(static_cast<int>(sites.size())))] = others[0];
        }
        TessellationArrays arrays = triangulate(built_of, metric).arrays();
        if (random.below(3) == 0) corrupt(arrays, random);
        const Validation with_filters = validate(arrays, sites);
        const Validation without = in_rationals(arrays, sites);
        ASSERT_EQ(with_filters.valid, without.valid)
            << "round " << round << ": " << with_filters.message << " | " << without.message;
        ASSERT_EQ(with_filters.canonical, without.canonical) << "round " << round;
        ASSERT_EQ(with_filters.message, without.message) << "round " << round;
        ASSERT_EQ(without.filtered, 0U);
        ++judged[at(with_filters.valid + with_filters.canonical)];
        filtered += with_filters.filtered;
        left_open += with_filters.multiprecision;
    }
    EXPECT_GT(judged[0], rounds / 10);
    EXPECT_GT(judged[1], 0);
    EXPECT_GT(judged[2], rounds / 10);
    // Random numbers leave nothing open, very large and very small ones everything.
    if (std::string(kind.name) == "nearly_degenerate") {
        EXPECT_GT(filtered, 0U);
        EXPECT_GT(left_open, 0U);
    }
}

INSTANTIATE_TEST_SUITE_P(, ValidateFilters,
                         testing::Combine(testing::ValuesIn(all_metrics), testing::ValuesIn(kinds)),
                         [](const testing::TestParamInfo<std::tuple<Metric, Kind>>& info) {
                             return std::string(name_of(std::get<0>(info.param))) + "_" +
                                    std::get<1>(info.param).name;
                         });

}  // namespace
}  // namespace signum
