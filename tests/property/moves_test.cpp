// Sites move, one or all, by an ulp or across everything, among others that come and go: at every
// moment the tessellation is the one that the sites make when they are built anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/triangulate.hpp"

#include "../thoroughness.hpp"
#include "degenerate_sites.hpp"

namespace signum {
namespace {

/// A dynamic tessellation, and its sites by handle.
class Pair {
 public:
    explicit Pair(Metric metric, WeightIs weight_is = WeightIs::radius)
        : metric_(metric), weight_is_(weight_is), dynamic(metric, weight_is) {}

    Index insert(const Site& site) {
        const Index handle = dynamic.insert(site);
        EXPECT_TRUE(sites.emplace(handle, site).second);
        return handle;
    }
    void erase(Index handle) {
        dynamic.erase(handle);
        sites.erase(handle);
    }
    void move(Index handle, Point centre) {
        dynamic.move(handle, centre);
        sites.at(handle).x = centre.x;
        sites.at(handle).y = centre.y;
    }
    /// Every site to where `moved` takes its centre.
    template <class Moved>
    void move_all(const Moved& moved) {
        std::vector<Point> centres;
        for (auto& [handle, site] : sites) {
            const Point centre = moved(Point{site.x, site.y});
            site.x = centre.x;
            site.y = centre.y;
            centres.push_back(centre);
        }
        dynamic.move_all(centres);
    }
    void expect_canonical() const {
        std::vector<Site> expected;
        for (const auto& [handle, site] : sites) {
            ASSERT_EQ(dynamic.site(handle), site);
            expected.push_back(site);
        }
        const Tessellation now = dynamic.tessellation();
        const Tessellation fresh = triangulate({expected, weight_is_ == WeightIs::weight}, metric_);
        ASSERT_TRUE(now.arrays() == fresh.arrays()) << text(expected);
        ASSERT_TRUE(std::ranges::equal(now.sites(), expected));
    }

 private:
    static std::string text(const std::vector<Site>& sites) {
        if (sites.size() > 50) return "many sites";
        std::string result;
        for (const Site& s : sites)
            result += "{" + std::to_string(s.x) + ", " + std::to_string(s.y) + ", " +
                      std::to_string(s.r) + "}, ";
        return result;
    }
    Metric metric_;
    WeightIs weight_is_;

 public:
    DynamicTessellation dynamic;
    std::map<Index, Site> sites;
};

class MovesOf : public testing::TestWithParam<Metric> {
 protected:
    std::mt19937_64 random_{53};
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    Index any(const Pair& pair) {
        return std::next(pair.sites.begin(), below(static_cast<int>(pair.sites.size())))->first;
    }
    /// By an ulp, or by up to a power of ten.
    Point displaced(Point p, int power) {
        const double up = std::numeric_limits<double>::infinity();
        if (power < -8) return {std::nextafter(p.x, below(2) == 0 ? up : -up), p.y};
        const double most = std::pow(10.0, power);
        return {p.x + most * (2 * real() - 1), p.y + most * (2 * real() - 1)};
    }

    /// Moves of all sizes, of all sites, of some and of one, with insertions and deletions between.
    /// `step` displaces a centre within a family.
    template <class MakeSite, class Step>
    void run(WeightIs weight_is, int size, int steps, const MakeSite& make_site, const Step& step) {
        Pair pair(GetParam(), weight_is);
        for (int i = 0; i < size; ++i) pair.insert(make_site());
        for (int i = 0; i < steps; ++i) {
            const int kind = below(8);
            if (kind == 0 || pair.sites.empty()) {
                pair.insert(make_site());
            } else if (kind == 1 || static_cast<int>(pair.sites.size()) > 2 * size) {
                pair.erase(any(pair));
            } else if (kind == 2) {
                const Index handle = any(pair);
                const Site& site = pair.sites.at(handle);
                pair.move(handle, step(Point{site.x, site.y}));
            } else if (kind == 3) {
                pair.move_all([&](Point p) { return below(4) == 0 ? step(p) : p; });
            } else if (kind == 4) {
                const Point by = step({0, 0});
                pair.move_all([&](Point p) { return Point{p.x + by.x, p.y + by.y}; });
            } else {
                pair.move_all(step);
            }
            ASSERT_NO_FATAL_FAILURE(pair.expect_canonical()) << "step " << i;
        }
    }
    template <class MakeSite>
    void run_in_all_sizes(int size, int steps, const MakeSite& make_site) {
        for (int power = -9; power <= 1; ++power)
            ASSERT_NO_FATAL_FAILURE(run(WeightIs::radius, size, steps, make_site,
                                        [&](Point p) { return displaced(p, power); }))
                << "10^" << power;
    }
};

TEST_P(MovesOf, FewSites) {
    for (const double radius : {0.0, 0.2, 1.0})
        ASSERT_NO_FATAL_FAILURE(run_in_all_sizes(9, 20 * thoroughness, [&] {
            return Site{real(), real(), radius * real()};
        }));
}

/// Ties of all kinds before and after, equal sites, all on one line and not any more.
TEST_P(MovesOf, Integers) {
    for (const int extent : {2, 4, 8})
        for (const int radii : {1, 4}) {
            const auto make = [&] {
                return Site{1.0 * below(extent), 1.0 * below(extent), 1.0 * below(radii)};
            };
            ASSERT_NO_FATAL_FAILURE(
                run(WeightIs::radius, 14, 40 * thoroughness, make, [&](Point p) {
                    return Point{p.x + below(3) - 1, p.y + below(3) - 1};
                }));
            ASSERT_NO_FATAL_FAILURE(run_in_all_sizes(14, 8 * thoroughness, make));
        }
}

TEST_P(MovesOf, SitesOnLines) {
    const auto make = [&] {
        const double t = below(12);
        return Site{t, 2 * t, below(3) / 2.0};
    };
    ASSERT_NO_FATAL_FAILURE(run(WeightIs::radius, 10, 60 * thoroughness, make, [&](Point p) {
        const double t = below(3) - 1;
        return Point{p.x + t, p.y + 2 * t};
    }));
    ASSERT_NO_FATAL_FAILURE(run(WeightIs::radius, 10, 60 * thoroughness, make, [&](Point p) {
        return Point{p.x, p.y + (below(10) == 0 ? below(3) - 1 : 0)};
    }));
    ASSERT_NO_FATAL_FAILURE(run_in_all_sizes(10, 8 * thoroughness, make));
}

TEST_P(MovesOf, DegenerateFamilies) {
    for (int family = 0; family < brute_force::Degenerate::families; ++family) {
        std::vector<Site> sites(40);
        brute_force::Degenerate(random_()).fill(family, sites.data(), sites.size());
        const auto make = [&] { return sites[random_() % sites.size()]; };
        ASSERT_NO_FATAL_FAILURE(run_in_all_sizes(12, 4 * thoroughness, make)) << family;
        // From one exact place to another.
        ASSERT_NO_FATAL_FAILURE(run(WeightIs::radius, 12, 16 * thoroughness, make, [&](Point p) {
            const Site site = make();
            return below(3) == 0 ? Point{site.x, site.y} : p;
        })) << family;
    }
}

/// Hidden ones appear and vanish: discs within discs, heavy sites above light ones.
TEST_P(MovesOf, NestedSites) {
    for (const double largest : {0.3, 3.0})
        ASSERT_NO_FATAL_FAILURE(run_in_all_sizes(25, 10 * thoroughness, [&] {
            return Site{real(), real(), largest * std::pow(real(), 3)};
        }));
}

TEST_P(MovesOf, ManySites) {
    const int count = 120 * thoroughness;
    for (const double radius : {0.0, 0.4, 4.0}) {
        Pair pair(GetParam());
        const double spacing = 1 / std::sqrt(1.0 * count);
        for (int i = 0; i < count; ++i) pair.insert({real(), real(), radius * spacing * real()});
        for (int power = -9; power <= 0; ++power)
            for (int round = 0; round < 3; ++round) {
                pair.move_all([&](Point p) { return displaced(p, power); });
                for (int i = 0; i < 5; ++i) {
                    pair.erase(any(pair));
                    pair.insert({real(), real(), radius * spacing * real()});
                    const Index handle = any(pair);
                    const Site& site = pair.sites.at(handle);
                    pair.move(handle, displaced({site.x, site.y}, power));
                }
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical()) << radius << ", 10^" << power;
            }
    }
}

/// On a circle, which is the hull, every site turns on its own; on a lattice every edge is a tie.
TEST_P(MovesOf, CirclesAndLattices) {
    const int count = 16 * thoroughness;
    for (const bool on_circle : {true, false}) {
        Pair pair(GetParam());
        for (int i = 0; i < count; ++i) {
            const double angle = 6.28 * real();
            pair.insert(on_circle ? Site{std::cos(angle), std::sin(angle), 0.25 * below(2) / count}
                                  : Site{1.0 * (i % 8), std::floor(i / 8.0), 0.25 * below(3)});
        }
        for (int power = -9; power <= 0; ++power) {
            pair.move_all([&](Point p) { return displaced(p, power); });
            ASSERT_NO_FATAL_FAILURE(pair.expect_canonical()) << "10^" << power;
            pair.move_all([&](Point p) {
                if (!on_circle) return Point{std::round(p.x), std::round(p.y)};
                const double length = std::hypot(p.x, p.y);
                return Point{p.x / length, p.y / length};
            });
            ASSERT_NO_FATAL_FAILURE(pair.expect_canonical()) << "10^" << power;
        }
    }
}

/// Changes that are not small, and leave many signs as they were.
TEST_P(MovesOf, WholeMotions) {
    Pair pair(GetParam());
    for (int i = 0; i < 40 * thoroughness; ++i) pair.insert({real(), real(), 0.01 * real()});
    const std::vector<std::function<Point(Point)>> motions = {
        [](Point p) {
            return Point{-p.x, -p.y};
        },
        [](Point p) {
            return Point{p.y, p.x};
        },
        [](Point p) {
            return Point{-p.x, p.y};
        },
        [](Point p) {
            return Point{p.x * p.x, 2 * p.x * p.y};
        },  // the plane twice around
        [](Point p) {
            return Point{p.x, 0};
        },
        [this](Point p) {
            return Point{p.x, real()};
        },
        [](Point p) {
            return Point{0x1p60 * p.x, 0x1p60 * p.y};
        },
        [](Point p) {
            return Point{0x1p-160 * p.x, 0x1p-160 * p.y};
        },
        [](Point p) {
            return Point{0x1p1000 * p.x, 0x1p1000 * p.y};
        },
        [](Point) {
            return Point{1, 2};
        },
        [this](Point) {
            return Point{real(), real()};
        },
        [](Point p) {
            return Point{p.x > 0.5 ? 1 - p.x : p.x, p.y};
        },
    };
    for (std::size_t i = 0; i < motions.size(); ++i) {
        pair.move_all(motions[i]);
        ASSERT_NO_FATAL_FAILURE(pair.expect_canonical()) << i;
    }
}

/// Of so few sites no move is too much to be mended: where all is built anew the mend has failed,
/// nearly always when sites had been taken out, and often when no structure was left.
TEST_P(MovesOf, AMendThatFailsLeavesNoTrace) {
    constexpr int size = 12;
    using Motion = std::function<Point(Point)>;
    const std::vector<Motion> motions = {
        // Everything on one place, on two, on a line, on a line but for a few, on two lines.
        [](Point) {
            return Point{0.5, 0.25};
        },
        [](Point p) {
            return p.x < 0.5 ? Point{0, 0} : Point{1, 0.5};
        },
        [](Point p) {
            return Point{p.x, 3 * p.x};
        },
        [](Point p) {
            return Point{p.x, p.x < 0.8 ? 0 : p.y};
        },
        [](Point p) {
            return Point{p.x, std::round(p.y)};
        },
        // Ties of all kinds.
        [](Point p) {
            return Point{std::round(2 * p.x), std::round(2 * p.y)};
        },
        [](Point p) {
            const int k = static_cast<int>(8 * p.x);
            constexpr double on_circle[] = {3, 4, 5, 4, -3, -4, 0, 4};
            return Point{on_circle[k % 8], on_circle[(k + 1) % 8]};
        },
        // The hull inside out, turned over, and twice around.
        [](Point p) {
            return Point{-p.x, p.y};
        },
        [](Point p) {
            const double r = std::hypot(p.x - 0.5, p.y - 0.5) + 0.01;
            return Point{0.5 + (p.x - 0.5) / (r * r), 0.5 + (p.y - 0.5) / (r * r)};
        },
        [](Point p) {
            return Point{(p.x - 0.5) * (p.x - 0.5) - (p.y - 0.5) * (p.y - 0.5),
                         2 * (p.x - 0.5) * (p.y - 0.5)};
        },
        // Outer sites to the middle, inner ones out.
        [](Point p) {
            return Point{p.x < 0.5 ? p.x + 0.5 : p.x - 0.5, p.y < 0.5 ? p.y + 0.5 : p.y - 0.5};
        }};
    std::uint64_t built = 0;
    for (int round = 0; round < 4 * thoroughness; ++round) {
        const double radius = round % 4 == 0 ? 0.0 : 0.05 * (1 << round % 4 * 2);
        for (std::size_t i = 0; i < motions.size(); ++i) {
            const Motion& motion = motions[i];
            SCOPED_TRACE(testing::Message() << "motion " << i << ", radius " << radius);
            Pair pair(GetParam());
            // Of one weight in half of the rounds, and some of them hidden from the start on.
            for (int k = 0; k < size; ++k)
                pair.insert({real(), real(), radius * (round % 8 < 4 ? 1.0 : real())});
            for (int step = 0; step < 3; ++step) {
                pair.move_all(motion);
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
                // What is there goes on as a fresh one would.
                const Index handle = any(pair);
                const Site site = pair.sites.at(handle);
                pair.erase(handle);
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
                pair.insert(site);
                pair.move(any(pair), {site.x, site.y});
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
                pair.move_all([&](Point) { return Point{real(), real()}; });
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
            }
            // One onto another, then another onto the hull's far side.
            for (const Point there :
                 {Point{pair.sites.begin()->second.x, pair.sites.begin()->second.y}, Point{9, -7},
                  Point{-9, 7}}) {
                int left = below(size);
                pair.move_all([&](Point p) { return left-- == 0 ? there : p; });
                ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
            }
            built += pair.dynamic.moves().built;
        }
    }
    EXPECT_GT(built, motions.size());
}

/// A turn that leaves no site where it was, on faces all of which stay counterclockwise, is kept.
TEST_P(MovesOf, WhatStaysRightIsKept) {
    Pair pair(GetParam());
    for (int i = 0; i < 500; ++i) pair.insert({real(), real(), 0.01 * real()});
    const std::uint64_t insertions = pair.dynamic.insertions();
    pair.move_all([](Point p) { return p; });
    pair.move_all([](Point p) { return Point{2 + p.x, p.y - 3}; });
    // The square turned by a right angle is the same one in all metrics.
    pair.move_all([](Point p) { return Point{-p.y, p.x}; });
    EXPECT_EQ(pair.dynamic.moves(), (Moves{.kept = 3}));
    EXPECT_LE(pair.dynamic.insertions() - insertions,
              3 * pair.dynamic.tessellation().hidden().size());
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
    for (int i = 0; i < 50; ++i) {
        const Index handle = any(pair);
        const Site& site = pair.sites.at(handle);
        pair.move(handle, displaced({site.x, site.y}, -8));
    }
    EXPECT_GE(pair.dynamic.moves().kept, 40U);
    EXPECT_EQ(pair.dynamic.moves().built, 0U);
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
}

TEST_P(MovesOf, LittleIsMended) {
    Pair pair(GetParam());
    for (int i = 0; i < 2000; ++i) pair.insert({real(), real(), 0.01 * real()});
    const std::uint64_t insertions = pair.dynamic.insertions();
    for (int round = 0; round < 20; ++round) {
        pair.move_all([&](Point p) { return Point{p.x + 1e-4 * real(), p.y + 1e-4 * real()}; });
        ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
    }
    const Moves moves = pair.dynamic.moves();
    EXPECT_GE(moves.mended, 15U);
    EXPECT_EQ(moves.built, 0U);
    // Nearly all sites stay where they are in the structure; the hidden ones are looked at.
    const std::size_t hidden = pair.dynamic.tessellation().hidden().size();
    EXPECT_LE(pair.dynamic.insertions() - insertions, 20 * (2 * hidden + 100));
}

TEST_P(MovesOf, MuchIsBuiltAnew) {
    Pair pair(GetParam());
    for (int i = 0; i < 2000; ++i) pair.insert({real(), real(), 0.001 * real()});
    pair.move_all([&](Point) { return Point{real(), real()}; });
    EXPECT_EQ(pair.dynamic.moves(), (Moves{.built = 1}));
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
}

/// Sites and handles keep apart where memory is put in order: the set is large and came in none.
TEST_P(MovesOf, LargeSetsAreSortedOnce) {
    constexpr int count = 20'000;
    Pair pair(GetParam());
    const auto insert_up_to = [&](std::size_t size) {
        while (pair.sites.size() < size) pair.insert({real(), real(), 0.003 * real()});
    };
    insert_up_to(16'384);
    pair.move_all([](Point p) { return p; });
    EXPECT_EQ(pair.dynamic.moves(), (Moves{.kept = 1}));
    insert_up_to(count);
    for (int i = 0; i < 50; ++i) pair.erase(any(pair));
    pair.move_all([](Point p) { return p; });
    EXPECT_EQ(pair.dynamic.moves(), (Moves{.kept = 1, .built = 1}));
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
    pair.move_all([](Point p) { return p; });
    EXPECT_EQ(pair.dynamic.moves(), (Moves{.kept = 2, .built = 1}));
    for (int round = 0; round < 3; ++round) {
        for (int i = 0; i < 40; ++i) {
            pair.erase(any(pair));
            for (int k = 0; k < 2; ++k) pair.insert({real(), real(), 0.003 * real()});
            const Index handle = any(pair);
            pair.sites.at(handle).r = 0.01 * real();
            pair.dynamic.change(handle, pair.sites.at(handle).r);
            pair.move(any(pair), {real(), real()});
        }
        ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
        pair.move_all([&](Point p) { return Point{p.x + 1e-5 * real(), p.y + 1e-5 * real()}; });
        ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
    }
    EXPECT_EQ(pair.dynamic.moves().built, 1U);
}

TEST_P(MovesOf, RefusesWhatIsWrongAndLeavesAllAsItWas) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Pair pair(GetParam());
    EXPECT_NO_THROW(pair.dynamic.move_all({}));
    EXPECT_THROW(pair.dynamic.move_all(std::vector<Point>(1)), std::invalid_argument);
    EXPECT_THROW(pair.dynamic.move(0, {0, 0}), std::out_of_range);
    for (int i = 0; i < 10; ++i) pair.insert({real(), real(), 0.1});
    const Index gone = 4;
    pair.erase(gone);
    EXPECT_THROW(pair.dynamic.move(gone, {0, 0}), std::out_of_range);
    EXPECT_THROW(pair.dynamic.move(-1, {0, 0}), std::out_of_range);
    EXPECT_THROW(pair.dynamic.move(1000, {0, 0}), std::out_of_range);
    EXPECT_THROW(pair.dynamic.move(1, {nan, 0}), std::invalid_argument);
    EXPECT_THROW(pair.dynamic.move(1, {0, infinity}), std::invalid_argument);
    for (const std::size_t count : {0U, 8U, 10U})
        EXPECT_THROW(pair.dynamic.move_all(std::vector<Point>(count)), std::invalid_argument);
    for (const Point wrong : {Point{nan, 0}, Point{0, nan}, Point{-infinity, 0}}) {
        std::vector<Point> centres(9);
        centres.back() = wrong;
        EXPECT_THROW(pair.dynamic.move_all(centres), std::invalid_argument);
    }
    EXPECT_EQ(pair.dynamic.moves(), Moves());
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
    while (!pair.sites.empty()) pair.erase(pair.sites.begin()->first);
    EXPECT_NO_THROW(pair.dynamic.move_all({}));
    ASSERT_NO_FATAL_FAILURE(pair.expect_canonical());
}

INSTANTIATE_TEST_SUITE_P(Metrics, MovesOf, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

/// Weights of either sign, centres that meet: of sites with one centre the heaviest is visible.
class MovesOfWeights : public MovesOf {};
TEST_P(MovesOfWeights, OfAllSizes) {
    for (const int extent : {3, 20})
        for (int power = -9; power <= 1; ++power)
            ASSERT_NO_FATAL_FAILURE(run(
                WeightIs::weight, 15, 20 * thoroughness,
                [&] {
                    return Site{1.0 * below(extent), 1.0 * below(extent), below(20) - 6.0};
                },
                [&](Point p) {
                    return power < 1 ? displaced(p, power)
                                     : Point{1.0 * below(extent), 1.0 * below(extent)};
                }))
                << extent << ", 10^" << power;
}
INSTANTIATE_TEST_SUITE_P(Power, MovesOfWeights, testing::Values(Metric::power));

}  // namespace
}  // namespace signum
