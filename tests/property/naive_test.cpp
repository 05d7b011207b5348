// Naive and single arithmetic on hostile sites: they end, with a tessellation or with
// BrokenStructure, by insertion and by the sweep. What they
// give may be wrong, but it is a triangulation of the sphere, so that all that reads it ends too.
// A construction that hangs runs into the time limit of the test.

#include "../../triangulation/triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace {

using namespace signum;
using brute_force::Degenerate;
using Sites = std::vector<Site>;

const int effort = signum::is_fast ? 2 : 1;

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

/// The same number of floats' range: of an eighth of the exponent, and as near to others as floats
/// are near to one another.
double squeezed(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    constexpr double most = std::numeric_limits<float>::max();
    return std::clamp(std::ldexp(mantissa, exponent / 8), -most, most);
}
Sites squeezed(Sites sites) {
    for (Site& s : sites) s = {squeezed(s.x), squeezed(s.y), squeezed(s.r)};
    return sites;
}

class Hostile {
 public:
    static constexpr int families = 14;

    /// Of a family whose numbers are next to one another as doubles are, or floats.
    Hostile(std::uint64_t seed, Arithmetic arithmetic)
        : degenerate_(seed), single_(arithmetic == Arithmetic::single) {}

    Sites sites(int family, std::size_t count) {
        Sites result(count);
        switch (family) {
            case 0:  // any finite numbers
                for (Site& s : result)
                    s = {random().finite(), random().finite(), random().finite()};
                break;
            case 1:  // sums and differences overflow
                for (Site& s : result) s = {huge(), huge(), huge()};
                break;
            case 2:  // products of huge coordinates overflow, and small radii drown
                for (Site& s : result)
                    s = {random().in_binades(500, 1000), random().in_binades(500, 1000), tiny()};
                break;
            case 3:  // denormals
                for (Site& s : result) s = {tiny(), tiny(), tiny()};
                break;
            case 4:  // huge beside tiny
                for (Site& s : result)
                    s = random().coin() ? Site{huge(), tiny(), tiny()}
                                        : Site{tiny(), huge(), random().finite()};
                break;
            case 5:  // a grid with a jitter of one ulp
                grid(result, 1.0 / 3, 0.1);
                break;
            case 6:  // the same of touching discs, where products underflow
                grid(result, 0x1.5555p-530, 0x1.5555p-531);
                break;
            case 7:  // degenerate integers, scaled and moved by ulps
            case 8:
                degenerate_.fill(random().below(Degenerate::families), result.data(), count);
                scale(result, family == 7 ? 1.0 / 3 : random().finite() / 1000);
                break;
            case 9:  // radii that nearly nest
                nest(result);
                break;
            case 10:  // few sites, many times
                for (Site& s : result) s = {small(3) / 3, small(3) / 3, small(2) / 3};
                break;
            case 11:  // nearly on a circle
                for (Site& s : result) {
                    const double angle = small(1000) * std::numbers::pi / 500;
                    s = {near(10 * std::cos(angle)), near(10 * std::sin(angle)), near(1.0 / 3)};
                }
                break;
            case 12:  // nearly on a line, far away
                for (Site& s : result) {
                    const double along = small(1000) / 7;
                    s = {near(1e6 + along), near(1e6 + 3 * along), near(small(5) / 9)};
                }
                break;
            default:  // one number, or next to it, everywhere
                for (Site& s : result) s = {near(0.1), near(0.1), near(0.1)};
        }
        for (Site& s : result) s = {finite(s.x), finite(s.y), finite(s.r)};
        const bool fills_range = family <= 4 || family == 6 || family == 8;
        return single_ && fills_range ? squeezed(std::move(result)) : result;
    }

    brute_force::Random& random() { return degenerate_.random(); }

 private:
    double small(int most) { return random().between(0, most); }
    double huge() { return random().coin() ? random().in_binades(1020, 1023) : near(largest / 2); }
    double tiny() { return random().in_binades(-1074, -1060); }
    /// The number or one of its neighbours.
    double near(double x) {
        const int where = random().below(3);
        if (single_ && std::fabs(x) <= std::numeric_limits<float>::max()) {
            const auto rounded = static_cast<float>(x);
            const auto toward = static_cast<float>(where == 1 ? infinity : -infinity);
            return where == 0 ? rounded : std::nextafter(rounded, toward);
        }
        return where == 0 ? x : std::nextafter(x, where == 1 ? infinity : -infinity);
    }
    static double finite(double x) { return std::isfinite(x) ? x : std::copysign(largest, x); }

    void grid(Sites& sites, double step, double radius) {
        const auto side = static_cast<std::size_t>(std::sqrt(sites.size())) + 1;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const std::size_t row = i / side;
            sites[i] = {near(static_cast<double>(i % side) * step),
                        near(static_cast<double>(row) * step), near(radius)};
        }
    }
    void scale(Sites& sites, double factor) {
        for (Site& s : sites) s = {near(s.x * factor), near(s.y * factor), near(s.r * factor)};
    }
    /// Each touches an earlier one from inside or outside, but for a rounding.
    void nest(Sites& sites) {
        sites.front() = {0, 0, 1};
        for (std::size_t i = 1; i < sites.size(); ++i) {
            const Site& m = sites[at(random().below(static_cast<int>(i)))];
            const double x = random().in_binades(-4, 0);
            const double y = random().in_binades(-4, 0);
            const double distance = std::hypot(x, y);
            sites[i] = {m.x + x, m.y + y, near(random().coin() ? m.r - distance : m.r + distance)};
        }
    }

    Degenerate degenerate_;
    bool single_;
};

std::string text(const Sites& sites) {
    std::string result;
    char line[96];
    for (const Site& s : sites) {
        std::snprintf(line, sizeof line, "{%a, %a, %a},\n", s.x, s.y, s.r);
        result += line;
    }
    return result;
}

/// A triangulation of the sphere whose vertices are infinity and the sites that are not hidden.
void expect_sphere(const Tessellation& t) {
    std::vector<char> met(t.sites().size(), 0);
    for (std::size_t f = 0; f < t.faces().size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Face& face = t.faces()[f];
            if (face[k] != infinite) met[at(face[k])] = 1;
            const auto g = at(t.neighbours()[f][k]);
            bool shared = false;
            for (std::size_t m = 0; m < 3; ++m)
                shared |= t.faces()[g][(m + 1) % 3] == face[(k + 2) % 3] &&
                          t.faces()[g][(m + 2) % 3] == face[(k + 1) % 3] &&
                          t.neighbours()[g][m] == static_cast<Index>(f);
            ASSERT_TRUE(shared) << "face " << f << " edge " << k;
        }
    const std::size_t visible = t.sites().size() - t.hidden().size();
    ASSERT_EQ(t.faces().size(), 2 * visible - 2);
    if (visible < 2) return;
    for (const Hidden& h : t.hidden()) {
        ASSERT_FALSE(met[at(h.site)]) << h.site;
        ASSERT_TRUE(met[at(h.by)]) << h.by;
    }
    ASSERT_EQ(static_cast<std::size_t>(std::count(met.begin(), met.end(), 1)), visible);
}

/// All that reads a tessellation ends.
void read(const Tessellation& t, Point point) {
    const std::vector<Edge> edges = t.edges();
    auto ends = static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [](const Edge& edge) { return edge[0] == infinite; }));
    for (Index i = 0; i < static_cast<Index>(t.sites().size()); ++i) ends += t.neighbours(i).size();
    ASSERT_EQ(ends, 2 * edges.size());
    ASSERT_GE(t.nearest(point), 0);
    (void)t.locate(point);
    if (t.sites().size() > 60) return;  // rationals take long
    ASSERT_EQ(vertices(t).size(), t.faces().size());
    if (t.sites().size() <= 5) (void)validate(t.arrays(), t.sites());
}

struct Build {
    Metric metric;
    Arithmetic arithmetic;
    Method method = Method::incremental;
};

class Rounded : public testing::TestWithParam<Build> {
 public:
    /// True where there is a result.
    static bool expect_end(const Sites& sites) {
        Options options;
        options.arithmetic = GetParam().arithmetic;
        options.method = GetParam().method;
        try {
            const Tessellation t = triangulate(sites, GetParam().metric, options);
            expect_sphere(t);
            if (!HasFatalFailure()) read(t, {sites.front().x, sites.back().y});
            return true;
        } catch (const BrokenStructure& broken) {
            EXPECT_NE(std::string(broken.what()), "");
            return false;
        }
    }
};

TEST_P(Rounded, EndsOnSmallSets) {
    Hostile hostile(1, GetParam().arithmetic);
    int results = 0;
    for (int trial = 0; trial < 2000 * effort; ++trial) {
        const int family = trial % Hostile::families;
        const Sites sites =
            hostile.sites(family, at(hostile.random().between(1, trial % 5 == 0 ? 60 : 12)));
        results += static_cast<int>(expect_end(sites));
        ASSERT_FALSE(HasFailure()) << "family " << family << "\n" << text(sites);
    }
    EXPECT_GT(results, 1000 * effort);
}

TEST_P(Rounded, EndsOnLargeSets) {
    Hostile hostile(2, GetParam().arithmetic);
    for (int trial = 0; trial < effort; ++trial)
        for (int family = 0; family < Hostile::families; ++family) {
            const Sites sites = hostile.sites(family, at(hostile.random().between(1000, 5000)));
            (void)expect_end(sites);
            ASSERT_FALSE(HasFailure()) << "family " << family << " trial " << trial;
        }
}

std::vector<Build> builds() {
    std::vector<Build> result;
    for (const Arithmetic arithmetic : {Arithmetic::naive, Arithmetic::single}) {
        for (const Metric metric :
             {Metric::power, Metric::euclidean, Metric::manhattan, Metric::supremum})
            result.push_back({metric, arithmetic});
        for (const Metric metric : {Metric::manhattan, Metric::supremum})
            result.push_back({metric, arithmetic, Method::sweep});
    }
    return result;
}

INSTANTIATE_TEST_SUITE_P(Builds, Rounded, testing::ValuesIn(builds()), [](const auto& info) {
    return std::string(name_of(info.param.arithmetic)) + "_" +
           std::string(name_of(info.param.metric)) + "_" + std::string(name_of(info.param.method));
});

}  // namespace
