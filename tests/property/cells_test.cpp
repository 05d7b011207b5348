// The cells as they are drawn, against their definition: along an edge two sites are equally near
// and none is nearer, and wherever the nearest site changes an edge is drawn.

#include "../../predicates/additive.hpp"
#include "../../tool/draw/frame.hpp"
#include "../../tool/draw/lines.hpp"
#include "../../tool/draw/shapes.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../thoroughness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace signum {
namespace {

/// Pixels: what an arc may be off, and its chord between two sites on both sides.
constexpr double tolerance = 0.12;

struct Near {
    double distance;
    Index site;
};

const int share = is_fast ? 1 : 10;  // of the trials one in so many

class Cells : public testing::TestWithParam<Metric> {
 protected:
    std::mt19937_64 random_{17};
    int segments_ = 0;
    int changes_ = 0;

    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    static Tessellation build(const std::vector<Site>& sites) {
        return triangulate(sites, GetParam());
    }

    /// In pixels; in the power metric the distance of the lines of equal power from the point, if
    /// the other site were as far as the picture is wide.
    static double distance(const Frame& frame, Point pixel, const Site& site) {
        const Point at = frame.at({site.x, site.y});
        const double length = shapes_of(GetParam()).outline.norm({pixel.x - at.x, pixel.y - at.y});
        const double r = frame.length(site.r);
        return GetParam() == Metric::power ? (length * length - r * r) / frame.width() : length - r;
    }

    /// Two rising distances; of equal ones the first in the tie rule's order.
    static std::array<Near, 2> nearest(const Frame& frame, Point pixel,
                                       const std::vector<Site>& sites) {
        std::vector<double> distances(sites.size());
        for (std::size_t i = 0; i < sites.size(); ++i)
            distances[i] = distance(frame, pixel, sites[i]);
        const double least = *std::min_element(distances.begin(), distances.end());
        const auto precedes = [&](const Near& a, const Near& b) {
            if (b.site < 0 || a.distance != b.distance) return a.distance < b.distance;
            return additive::precedes(sites[static_cast<std::size_t>(a.site)], a.site,
                                      sites[static_cast<std::size_t>(b.site)], b.site);
        };
        Near first = {HUGE_VAL, -1};
        Near second = first;
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const bool is_least = distances[i] < least + 1e-7;
            const Near near = {is_least ? least : distances[i], static_cast<Index>(i)};
            if (precedes(near, first)) {
                second = std::exchange(first, near);
            } else if (precedes(near, second)) {
                second = near;
            }
        }
        return {first, second};
    }

    static double distance_to(Point p, const Conic& s) {
        const Point along = {s.to.x - s.from.x, s.to.y - s.from.y};
        const double square = along.x * along.x + along.y * along.y;
        const double t = std::clamp(
            ((p.x - s.from.x) * along.x + (p.y - s.from.y) * along.y) / square, 0.0, 1.0);
        return std::hypot(s.from.x + t * along.x - p.x, s.from.y + t * along.y - p.y);
    }

    /// The parabolas that are drawn, as straight lines.
    static std::vector<Conic> chords(const std::vector<Conic>& drawn) {
        std::vector<Conic> result;
        for (const Conic& conic : drawn)
            for (const Conic& parabola : parabolas(conic, 0.05)) {
                Point start = parabola.from;
                for (int i = 1; i <= 32; ++i) {
                    const double s = i / 32.0;
                    const Point end = {
                        (1 - s) * (1 - s) * parabola.from.x + 2 * s * (1 - s) * parabola.control.x +
                            s * s * parabola.to.x,
                        (1 - s) * (1 - s) * parabola.from.y + 2 * s * (1 - s) * parabola.control.y +
                            s * s * parabola.to.y};
                    if (start != end) result.push_back(Conic::straight(start, end));
                    start = end;
                }
            }
        return result;
    }

    static std::string text(const std::vector<Site>& sites) {
        std::string result;
        for (const Site& s : sites)
            result += std::to_string(s.x) + ", " + std::to_string(s.y) + ", " +
                      std::to_string(s.r) + "\n";
        return result;
    }

    void check(const std::vector<Site>& sites) {
        const Frame frame(sites, 900);
        const auto drawn = chords(cell_edges(voronoi(build(sites)), frame));
        for (const Conic& chord : drawn) {
            ++segments_;
            for (const double t : {0.0, 0.3, 0.5, 1.0}) {
                const Point p = chord.at(t);
                ASSERT_TRUE(-1e-6 <= p.x && p.x <= frame.width() + 1e-6 && -1e-6 <= p.y &&
                            p.y <= frame.height() + 1e-6);
                const auto [one, other] = nearest(frame, p, sites);
                ASSERT_NEAR(one.distance, other.distance, tolerance)
                    << "at " << p.x << ", " << p.y << "\n"
                    << text(sites);
            }
        }
        for (int sample = 0; sample < 1500; ++sample) {
            const Point p = {frame.width() * real(), frame.height() * real()};
            const double angle = 7 * real();
            const double step = 4 * real();
            const Point q = {p.x + step * std::cos(angle), p.y + step * std::sin(angle)};
            if (nearest(frame, p, sites)[0].site == nearest(frame, q, sites)[0].site) continue;
            ++changes_;
            double least = frame.width();
            for (const Conic& chord : drawn) least = std::min(least, distance_to(p, chord));
            // An edge may leave the picture between the two.
            const double border = std::min({p.x, p.y, frame.width() - p.x, frame.height() - p.y,
                                            q.x, q.y, frame.width() - q.x, frame.height() - q.y});
            if (border < 0) continue;
            ASSERT_LE(least, step + tolerance) << "at " << p.x << ", " << p.y << "\n"
                                               << text(sites);
        }
    }
};

TEST_P(Cells, OfRandomSites) {
    for (int round = 0; round < 60 / share; ++round) {
        std::vector<Site> sites(2 + static_cast<std::size_t>(below(60)));
        const double largest = std::ldexp(64.0, -below(6));
        for (Site& s : sites) s = {100 * real(), 100 * real(), largest * real()};
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(segments_, 400 / share);
    EXPECT_GT(changes_, 100 / share);
}

TEST_P(Cells, OfIntegers) {
    for (int round = 0; round < 120; ++round) {
        std::vector<Site> sites(2 + static_cast<std::size_t>(below(12)));
        const int extent = 3 + below(8);
        const int largest = 1 + below(4);
        for (Site& s : sites) s = {1.0 * below(extent), 1.0 * below(extent), 1.0 * below(largest)};
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(segments_, 200);
    EXPECT_GT(changes_, 100);
}

/// One size of radii many times the others: most cells are slivers around its border.
TEST_P(Cells, OfTinySitesAroundALargeOne) {
    for (int round = 0; round < 40; ++round) {
        std::vector<Site> sites = {{0, 0, 30}};
        for (int i = 0; i < 7; ++i) {
            const double angle = 6.3 * real();
            const double away = 30 + 10 * real();
            sites.push_back({away * std::cos(angle), away * std::sin(angle), 4 * real()});
        }
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(segments_, 100);
}

TEST_P(Cells, OfCollinearSites) {
    for (int round = 0; round < 40; ++round) {
        std::vector<Site> sites(2 + static_cast<std::size_t>(below(6)));
        const int dx = below(3) - 1;
        const int dy = dx == 0 ? 1 : below(3) - 1;
        const int largest = 1 + below(3);
        for (Site& s : sites) {
            const int t = below(12);
            s = {1.0 * dx * t, 1.0 * dy * t, 0.5 * below(largest)};
        }
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(segments_, 20);
}

INSTANTIATE_TEST_SUITE_P(Metrics, Cells, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

}  // namespace
}  // namespace signum
