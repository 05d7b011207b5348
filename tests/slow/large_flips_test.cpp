// Two roads to the power tessellation on up to a hundred thousand sites of every distribution:
// flips arrive at the arrays of insertion, and their number is linear in the sites.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "../../tool/generate/generate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr std::int64_t most_sites = 10'000;
#else
constexpr std::int64_t most_sites = 100'000;
#endif

struct Place {
    const char* name;
    Distribution distribution;
};
void PrintTo(const Place& place, std::ostream* out) {
    *out << place.name;
}
const Place places[] = {{"random", Distribution::random},
                        {"grid", Distribution::grid},
                        {"circle", Distribution::circle},
                        {"square", Distribution::square}};

/// Sites grow denser with their number: radii in millimetres then intersect more and more, radii in
/// mean distances of neighbours always as much.
struct Radii {
    const char* name;
    double from;
    double to;
    bool in_spacings;
};
void PrintTo(const Radii& radii, std::ostream* out) {
    *out << radii.name;
}
const Radii all_radii[] = {{"from_a_hundredth_to_ten_millimetres", 0.01, 10, false},
                           {"to_most_of_the_side", 0, 600, false},
                           {"apart", 0, 0.5, true},
                           {"touching", 0, 1, true},
                           {"intersecting", 0, 3, true},
                           {"intersecting_heavily", 0, 10, true}};

class LargeFlips : public testing::TestWithParam<std::tuple<Place, Radii>> {};

TEST_P(LargeFlips, ArriveWhereInsertionDoesAndAreLinear) {
    const auto& [place, radii] = GetParam();
    const bool is_curve =
        place.distribution == Distribution::circle || place.distribution == Distribution::square;
    double before = 0;  // flips of a tenth of the sites
    for (std::int64_t count = 100; count <= most_sites; count *= 10) {
        const auto n = static_cast<double>(count);
        const double unit = !radii.in_spacings ? 1 : is_curve ? 2100 / n : 700 / std::sqrt(n);
        GenerateOptions options;
        options.count = count;
        options.radius_from = unit * radii.from;
        options.radius_to = unit * radii.to;
        options.seed = 5;
        const std::vector<Site> sites = generate(place.distribution, options);
        Options by_flips;
        by_flips.method = Method::flips;
        const Tessellation inserted = triangulate(sites, Power{});
        const Tessellation flipped = triangulate(sites, Power{}, by_flips);
        ASSERT_TRUE(flipped.arrays() == inserted.arrays()) << count << " sites";

        // A site is hidden once, and an edge hardly ever comes back.
        const auto flips = static_cast<double>(flipped.statistics().flips);
        EXPECT_LT(flips, 4 * n) << count << " sites";
        if (radii.in_spacings && before >= 300) {
            EXPECT_NEAR(flips / before, 10, 1.5) << count << " sites";
        }
        before = flips;
    }
    EXPECT_GT(before, 0.05 * static_cast<double>(most_sites));
}

INSTANTIATE_TEST_SUITE_P(All, LargeFlips,
                         testing::Combine(testing::ValuesIn(places), testing::ValuesIn(all_radii)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) + "_" +
                                    std::get<1>(info.param).name;
                         });

}  // namespace
}  // namespace signum
