// The result of a triangulation and the questions about it, against brute force in rationals; the
// options of triangulate().

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>
#include "../oracle/power.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

const int share = is_fast ? 1 : 5;  // of the trials one in so many

std::size_t at(Index i) {
    return static_cast<std::size_t>(i);
}

class Random {
 public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    int below(int count) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(count)); }
    int between(int low, int high) { return low + below(high - low + 1); }
    double real() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
    std::mt19937_64 bits_;
};

// ---- brute force -------------------------------------------------------------------------------

mpq_class weight(const Tessellation& t, const Site& s) {
    const mpq_class third(s.r);
    return t.weight_is() == WeightIs::weight ? third : mpq_class(third * third);
}

int orientation(Point a, Point b, Point c) {
    const mpq_class ux = mpq_class(b.x) - mpq_class(a.x);
    const mpq_class uy = mpq_class(b.y) - mpq_class(a.y);
    const mpq_class vx = mpq_class(c.x) - mpq_class(a.x);
    const mpq_class vy = mpq_class(c.y) - mpq_class(a.y);
    return sgn(mpq_class(ux * vy - uy * vx));
}

/// Of all sites the nearest; of several the first by falling weight, rising x, y, index.
Index nearest_by_force(const Tessellation& t, Point p) {
    Index best = -1;
    mpq_class best_distance;
    mpq_class best_weight;
    for (std::size_t i = 0; i < t.sites().size(); ++i) {
        const Site& s = t.sites()[i];
        const mpq_class dx = mpq_class(p.x) - mpq_class(s.x);
        const mpq_class dy = mpq_class(p.y) - mpq_class(s.y);
        const mpq_class w = weight(t, s);
        const mpq_class distance = dx * dx + dy * dy - w;
        bool first = best < 0 || distance < best_distance;
        if (!first && distance == best_distance) {
            const Site& b = t.sites()[at(best)];
            first = w != best_weight ? w > best_weight : s.x != b.x ? s.x < b.x : s.y < b.y;
        }
        if (!first) continue;
        best = static_cast<Index>(i);
        best_distance = distance;
        best_weight = w;
    }
    return best;
}

Point centre(const Tessellation& t, Index i) {
    return {t.sites()[at(i)].x, t.sites()[at(i)].y};
}

/// locate() answers what its comment promises.
[[nodiscard]] testing::AssertionResult located(const Tessellation& t, Point p) {
    const Index f = t.locate(p);
    const auto failure = [&](const char* why) {
        return testing::AssertionFailure()
               << why << ": face " << f << " for " << p.x << ", " << p.y;
    };
    if (t.faces().empty())
        return f == -1 ? testing::AssertionSuccess() : failure("there is no face");
    if (f < 0 || at(f) >= t.faces().size()) return failure("no such face");
    const auto holds = [&](const Face& v) {
        for (std::size_t k = 0; k < 3; ++k)
            if (orientation(centre(t, v[k]), centre(t, v[(k + 1) % 3]), p) < 0) return false;
        return true;
    };
    const bool is_line = std::all_of(t.faces().begin(), t.faces().end(),
                                     [](const Face& v) { return v[0] == infinite; });
    const Face& face = t.faces()[at(f)];
    if (!is_line) {
        const bool inside = std::any_of(t.faces().begin(), t.faces().end(), [&](const Face& v) {
            return v[0] != infinite && holds(v);
        });
        if (inside != (face[0] != infinite)) return failure("inside taken for outside");
        if (inside && !holds(face)) return failure("not in the face");
        // (infinity, b, a) of the hull edge a -> b.
        if (!inside && orientation(centre(t, face[2]), centre(t, face[1]), p) >= 0)
            return failure("the hull edge does not see the point");
        return testing::AssertionSuccess();
    }
    const Point a = centre(t, face[2]);
    const Point b = centre(t, face[1]);
    const int side = orientation(a, b, p);
    if (side > 0) return failure("on the other side of the line");
    const auto encloses = [&](const Face& v) {
        const Point from = centre(t, v[2]);
        const Point to = centre(t, v[1]);
        return std::min(from.x, to.x) <= p.x && p.x <= std::max(from.x, to.x) &&
               std::min(from.y, to.y) <= p.y && p.y <= std::max(from.y, to.y);
    };
    if (side == 0 && std::any_of(t.faces().begin(), t.faces().end(), encloses) && !encloses(face))
        return failure("another edge contains the point");
    return testing::AssertionSuccess();
}

/// All laws of a result that do not need the predicates.
void check_laws(const Tessellation& t) {
    const std::size_t n = t.sites().size();
    ASSERT_EQ(t.arrays().sites, static_cast<std::int64_t>(n));
    ASSERT_LE(t.hidden().size(), n);
    const std::size_t visible = n - t.hidden().size();
    ASSERT_EQ(t.faces().size(), visible < 2 ? 0 : 2 * visible - 2);
    ASSERT_EQ(t.neighbours().size(), t.faces().size());
    ASSERT_TRUE(std::is_sorted(t.faces().begin(), t.faces().end()));
    if (n > 0) {
        ASSERT_GE(visible, 1U);
    }

    std::set<Index> hidden;
    for (std::size_t i = 0; i < t.hidden().size(); ++i) {
        if (i > 0) {
            ASSERT_LT(t.hidden()[i - 1].site, t.hidden()[i].site);
        }
        hidden.insert(t.hidden()[i].site);
    }
    for (const Hidden& h : t.hidden()) {
        ASSERT_FALSE(hidden.contains(h.by));
        ASSERT_EQ(h.by, nearest_by_force(t, centre(t, h.site)));
    }

    // Edges: once for every face, half of them, ends by faces; cyclic order by neighbours.
    std::multiset<Edge> directed;
    std::map<Index, std::multiset<Index>> joined;
    for (std::size_t f = 0; f < t.faces().size(); ++f) {
        const Face& v = t.faces()[f];
        ASSERT_LT(v[0], v[1]);
        ASSERT_LT(v[0], v[2]);
        ASSERT_NE(v[1], v[2]);
        for (std::size_t k = 0; k < 3; ++k) {
            directed.insert({v[k], v[(k + 1) % 3]});
            joined[v[k]].insert(v[(k + 1) % 3]);
            ASSERT_FALSE(hidden.contains(v[k]));
            // The face across shares the edge, backwards, and knows this one.
            const Index g = t.neighbours()[f][k];
            ASSERT_GE(g, 0);
            ASSERT_LT(at(g), t.faces().size());
            const Face& w = t.faces()[at(g)];
            bool shared = false;
            for (std::size_t l = 0; l < 3; ++l)
                shared = shared ||
                         (t.neighbours()[at(g)][l] == static_cast<Index>(f) &&
                          w[(l + 1) % 3] == v[(k + 2) % 3] && w[(l + 2) % 3] == v[(k + 1) % 3]);
            ASSERT_TRUE(shared);
        }
    }
    const std::vector<Edge> edges = t.edges();
    ASSERT_EQ(edges.size(), visible < 2 ? 0 : 3 * visible - 3);
    ASSERT_TRUE(std::is_sorted(edges.begin(), edges.end()));
    std::multiset<Edge> both_ways;
    for (const Edge& e : edges) {
        ASSERT_LT(e[0], e[1]);
        both_ways.insert({e[0], e[1]});
        both_ways.insert({e[1], e[0]});
    }
    ASSERT_EQ(both_ways, directed);

    for (Index i = 0; i < static_cast<Index>(n); ++i) {
        const std::vector<Index> around = t.neighbours(i);
        ASSERT_EQ(std::multiset<Index>(around.begin(), around.end()), joined[i]);
        ASSERT_EQ(around.empty(), visible < 2 || hidden.contains(i));
        if (around.empty()) continue;
        ASSERT_EQ(around.front(), *std::min_element(around.begin(), around.end()));
        // Counterclockwise: each and the next form a face with the site.
        for (std::size_t k = 0; k < around.size(); ++k) {
            Face v = {i, around[k], around[(k + 1) % around.size()]};
            if (around.size() == 2 && v[1] != infinite && v[2] != infinite) continue;
            std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
            ASSERT_TRUE(around.size() == 1 ||
                        std::binary_search(t.faces().begin(), t.faces().end(), v));
        }
    }
}

struct Family {
    const char* name;
    Site (*draw)(Random&);
};
void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

const Family families[] = {
    {"random",
     [](Random& g) {
         return Site{g.real(), g.real(), 0.3 * g.real()};
     }},
    {"grid",
     [](Random& g) {
         return Site{1.0 * g.below(4), 1.0 * g.below(4), 0.0};
     }},
    {"grid_with_radii",
     [](Random& g) {
         return Site{1.0 * g.below(4), 1.0 * g.below(4), 1.0 * g.below(3)};
     }},
    {"collinear",
     [](Random& g) {
         const double t = g.below(9);
         return Site{2 * t, t, 1.0 * g.below(3)};
     }},
    {"vertical",
     [](Random& g) {
         return Site{3.0, 1.0 * g.below(9), 0.0};
     }},
    {"nearly_collinear",
     [](Random& g) {
         const double t = g.below(9);
         return Site{0.1 * t, 0.3 * t, 0.0};
     }},
    {"one_place",
     [](Random& g) {
         return Site{1.0, 2.0, 1.0 * g.below(2)};
     }},
    {"extremes",
     [](Random& g) {
         static constexpr double values[] = {0, 0x1p-1074, 1, -1.7e308, 1.7e308};
         return Site{values[g.below(5)], values[g.below(5)], values[g.below(3)]};
     }},
};

class TessellationQuestions : public testing::TestWithParam<Family> {
 protected:
    Random random_{12};
    std::vector<Site> draw(int n) {
        std::vector<Site> sites;
        for (int i = 0; i < n; ++i) sites.push_back(GetParam().draw(random_));
        return sites;
    }
};

TEST_P(TessellationQuestions, Laws) {
    for (int n = 0; n < 30; ++n) check_laws(triangulate(draw(n), Power{}));
}

TEST_P(TessellationQuestions, LocateAndNearest) {
    for (int round = 0; round < 60; ++round) {
        const auto sites = draw(round % 20);
        std::vector<power::Site> weights;
        for (const Site& s : sites) weights.push_back({s.x, s.y, s.r - 1});
        for (const bool as_weights : {false, true}) {
            const Tessellation t =
                as_weights ? triangulate(weights, Power{}) : triangulate(sites, Power{});
            for (int question = 0; question < 30 / share; ++question) {
                const Site a = GetParam().draw(random_);
                const Site b = GetParam().draw(random_);
                const Point p = random_.below(3) == 0
                                    ? Point{a.x, a.y}
                                    : Point{0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y};
                ASSERT_TRUE(located(t, p));
                ASSERT_EQ(t.nearest(p), nearest_by_force(t, p)) << p.x << " " << p.y;
            }
            for (const Point p : {Point{0, 0}, Point{-1e300, 1e300}, Point{0x1p-1074, -0x1p-1074},
                                  Point{1.7e308, -1.7e308}, Point{0.5, 1e10}}) {
                ASSERT_TRUE(located(t, p));
                ASSERT_EQ(t.nearest(p), nearest_by_force(t, p)) << p.x << " " << p.y;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, TessellationQuestions, testing::ValuesIn(families),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(TessellationQuestionsMore, LargerSets) {
    Random random(5);
    std::vector<Site> sites(3000);
    for (Site& s : sites) s = {random.real(), random.real(), 0.02 * random.real()};
    const Tessellation t = triangulate(sites, Power{});
    for (int question = 0; question < 60 / share; ++question) {
        const Point p{1.4 * random.real() - 0.2, 1.4 * random.real() - 0.2};
        ASSERT_TRUE(located(t, p));
        ASSERT_EQ(t.nearest(p), nearest_by_force(t, p));
    }
}

TEST(TessellationQuestionsMore, PointsMustBeFinite) {
    for (const auto& sites : {std::vector<Site>{}, std::vector<Site>{{0, 0, 0}, {1, 0, 0}}}) {
        const Tessellation t = triangulate(sites, Power{});
        EXPECT_THROW((void)t.locate({NAN, 0}), std::invalid_argument);
        EXPECT_THROW((void)t.nearest({0, HUGE_VAL}), std::invalid_argument);
    }
}

TEST(TessellationQuestionsMore, Empty) {
    const Tessellation t;
    EXPECT_TRUE(t.faces().empty());
    EXPECT_TRUE(t.edges().empty());
    EXPECT_EQ(t.locate({0, 0}), -1);
    EXPECT_EQ(t.nearest({0, 0}), -1);
    EXPECT_TRUE(vertices(t).empty());
    check_laws(triangulate(std::vector<Site>{}, Power{}));
}

TEST(TessellationQuestionsMore, OneVisibleSite) {
    // The last, the first, the middle one of three at one place.
    for (std::size_t heaviest = 0; heaviest < 3; ++heaviest) {
        std::vector<Site> sites(3, Site{1, 1, 0});
        sites[heaviest].r = 2;
        const Tessellation t = triangulate(sites, Power{});
        EXPECT_EQ(t.nearest({5, 5}), static_cast<Index>(heaviest));
        EXPECT_EQ(t.locate({5, 5}), -1);
        EXPECT_EQ(t.hidden().size(), 2U);
        EXPECT_TRUE(t.neighbours(static_cast<Index>(heaviest)).empty());
    }
}

TEST(TessellationQuestionsMore, Names) {
    EXPECT_EQ(name_of(Metric::power), "power");
    EXPECT_EQ(name_of(WeightIs::weight), "weight");
    EXPECT_EQ(name_of(Arithmetic::multiprecision), "multiprecision");
}

/// The answers do not depend on the caller's floating-point environment.
TEST(TessellationQuestionsMore, AnyEnvironment) {
    Random random(6);
    for (const Family& family : families) {
        std::vector<Site> sites;
        for (int i = 0; i < 40; ++i) sites.push_back(family.draw(random));
        const Tessellation expected = triangulate(sites, Power{});
        const Point p{sites[3].x, sites[7].y};
        const Index face = expected.locate(p);
        const Index nearest = expected.nearest(p);
        for (int e = 0; e < 8; ++e) {
            constexpr int modes[] = {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
            std::fesetround(modes[e % 4]);
#if defined(__SSE2__)
            if (e >= 4) _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
            const Tessellation t = triangulate(sites, Power{});
            const Index f = t.locate(p);
            const Index v = t.nearest(p);
            const int after = std::fegetround();
#if defined(__SSE2__)
            _mm_setcsr(0x1F80);
#endif
            std::fesetround(FE_TONEAREST);
            ASSERT_EQ(after, modes[e % 4]);
            ASSERT_EQ(t.arrays(), expected.arrays()) << family.name << " " << e;
            ASSERT_EQ(f, face);
            ASSERT_EQ(v, nearest);
        }
    }
}

// ---- layouts of the input ----------------------------------------------------------------------

TEST(TriangulateInput, LayoutsAgree) {
    Random random(7);
    const std::size_t n = 200;
    std::vector<Site> sites(n);
    for (Site& s : sites) s = {random.real(), random.real(), 0.1 * random.real()};
    const TessellationArrays expected = triangulate(sites, Power{}).arrays();

    std::vector<double> rows;  // a matrix of five columns, row by row
    std::vector<double> columns(3 * n);
    struct Body {
        int name;
        double radius;
        char kind;
        double y;
        double x;
    };
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < n; ++i) {
        const Site& s = sites[i];
        rows.insert(rows.end(), {-1.0, s.x, s.y, -2.0, s.r});
        columns[i] = s.x;
        columns[n + i] = s.y;
        columns[2 * n + i] = s.r;
        bodies.push_back({static_cast<int>(i), s.r, 'b', s.y, s.x});
    }
    const auto arrays = [](const StridedSites& view) {
        return triangulate(view, Power{}).arrays();
    };
    EXPECT_EQ(arrays({n, 5 * sizeof(double), rows.data() + 1, rows.data() + 2, rows.data() + 4}),
              expected);
    EXPECT_EQ(
        arrays({n, sizeof(double), columns.data(), columns.data() + n, columns.data() + 2 * n}),
        expected);
    EXPECT_EQ(arrays({n, sizeof(Body), &bodies[0].x, &bodies[0].y, &bodies[0].radius}), expected);
    // Backwards.
    std::vector<Site> reversed(sites.rbegin(), sites.rend());
    const Site& last = reversed.back();
    EXPECT_EQ(arrays({n, -static_cast<std::ptrdiff_t>(sizeof(Site)), &last.x, &last.y, &last.r}),
              expected);
}

TEST(TriangulateInput, KindsOfSites) {
    Random random(8);
    std::vector<Point> points(100);
    std::vector<Site> radii;
    std::vector<Site> negative;
    std::vector<power::Site> weights;
    std::vector<power::Site> squares;
    for (Point& p : points) {
        p = {1.0 * random.below(9), 1.0 * random.below(9)};
        const double r = random.below(4);
        radii.push_back({p.x, p.y, r});
        negative.push_back({p.x, p.y, random.below(2) == 0 ? r : -r});
        squares.push_back({p.x, p.y, r * r});
        weights.push_back({p.x, p.y, 7.0});
    }
    const Tessellation t = triangulate(points, Power{});
    EXPECT_EQ(t.weight_is(), WeightIs::radius);
    const Tessellation w = triangulate(weights, Power{});
    EXPECT_EQ(w.weight_is(), WeightIs::weight);
    EXPECT_EQ(triangulate(std::vector<power::Site>{}, Power{}).weight_is(), WeightIs::weight);
    EXPECT_EQ(w.arrays().faces, t.arrays().faces);
    EXPECT_EQ(w.arrays().hidden, t.arrays().hidden);
    const Tessellation r = triangulate(radii, Power{});
    EXPECT_EQ(triangulate(negative, Power{}).arrays(), r.arrays());
    const Tessellation s = triangulate(squares, Power{});
    EXPECT_EQ(s.arrays().faces, r.arrays().faces);
    EXPECT_EQ(s.arrays().hidden, r.arrays().hidden);
    EXPECT_EQ(std::vector<Site>(r.sites().begin(), r.sites().end()), radii);
}

TEST(TriangulateInput, NumbersMustBeFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, -nan, infinity, -infinity})
        for (std::size_t where : {0U, 1U, 57U, 99U})
            for (int what = 0; what < 3; ++what) {
                std::vector<Site> sites(100);
                for (std::size_t i = 0; i < 100; ++i)
                    sites[i] = {1.0 * static_cast<double>(i), 2, 3};
                (what == 0 ? sites[where].x : what == 1 ? sites[where].y : sites[where].r) = bad;
                try {
                    (void)triangulate(sites, Power{});
                    FAIL() << where;
                } catch (const std::invalid_argument& e) {
                    const std::string word = "site " + std::to_string(where) + " ";
                    EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
                }
            }
}

// ---- options -----------------------------------------------------------------------------------

std::vector<Site> many(std::size_t n) {
    Random random(9);
    std::vector<Site> sites(n);
    for (Site& s : sites) s = {random.real(), random.real(), 0.0};
    return sites;
}

TEST(TriangulateOptions, StopsWhenAskedTo) {
    std::stop_source source;
    Options options;
    options.stop = source.get_token();
    EXPECT_NO_THROW((void)triangulate(many(20000), Power{}, options));
    source.request_stop();
    EXPECT_THROW((void)triangulate(many(20000), Power{}, options), Stopped);
    // In the middle, from the callback.
    std::stop_source later;
    options.stop = later.get_token();
    int calls = 0;
    options.progress = [&](double) {
        if (++calls == 2) later.request_stop();
    };
    EXPECT_THROW((void)triangulate(many(30000), Power{}, options), Stopped);
    EXPECT_EQ(calls, 2);
}

TEST(TriangulateOptions, ProgressGrowsFromZeroToOne) {
    std::vector<double> shares;
    Options options;
    options.progress = [&](double share) { shares.push_back(share); };
    (void)triangulate(many(50000), Power{}, options);
    ASSERT_GE(shares.size(), 5U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GE(shares.front(), 0.0);
    EXPECT_LE(shares.back(), 1.0);
    EXPECT_GT(shares.back(), 0.8);
    // What the callback throws comes out.
    options.progress = [](double) { throw std::domain_error("enough"); };
    EXPECT_THROW((void)triangulate(many(50000), Power{}, options), std::domain_error);
}

TEST(TriangulateOptions, SeedChangesNothing) {
    Random random(10);
    for (const Family& family : families) {
        std::vector<Site> sites;
        for (int i = 0; i < 150; ++i) sites.push_back(family.draw(random));
        const Tessellation expected = triangulate(sites, Power{});
        for (std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{2}, ~std::uint64_t{0}}) {
            Options options;
            options.seed = seed;
            ASSERT_EQ(triangulate(sites, Power{}, options).arrays(), expected.arrays())
                << family.name;
        }
    }
}

TEST(TriangulateOptions, StatisticsAreZeroUnlessCounted) {
    for (const Arithmetic arithmetic : all_arithmetics) {
        Options options;
        options.arithmetic = arithmetic;
        const Statistics s = triangulate(many(500), Power{}, options).statistics();
        EXPECT_FALSE(s.counted);
        for (const Counter& counter : counters) EXPECT_EQ(s.*counter.count, 0U) << counter.name;
        EXPECT_GE(s.seconds, 0.0);
    }
}

std::uint64_t calls(const Statistics& s) {
    return s.ccw + s.in_circle + s.nearer + s.others;
}

TEST(TriangulateOptions, StatisticsAddUp) {
    Random random(11);
    for (const Family& family : families) {
        std::vector<Site> sites;
        for (int i = 0; i < 150 / share; ++i) sites.push_back(family.draw(random));
        for (const Metric metric : all_metrics)
            for (const Arithmetic arithmetic : all_arithmetics) {
                if (!is_exact(arithmetic)) continue;
                Options options;
                options.count = true;
                options.arithmetic = arithmetic;
                const Tessellation t = triangulate(sites, metric, options);
                const Statistics& s = t.statistics();
                EXPECT_TRUE(s.counted);
                EXPECT_EQ(s.filtered + s.refined + s.exact + s.essa + s.multiprecision, calls(s))
                    << family.name;
                EXPECT_LE(s.others, calls(s));  // not below 0
                if (arithmetic == Arithmetic::multiprecision) {
                    EXPECT_EQ(s.multiprecision, calls(s));
                }
                if (metric == Metric::power) {
                    EXPECT_EQ(s.others, 0U);
                    EXPECT_LE(s.ties, s.in_circle);
                }
                if (t.faces().size() > 2) {
                    EXPECT_GT(s.in_circle, 0U) << family.name;
                }
                options.count = false;
                EXPECT_EQ(triangulate(sites, metric, options).arrays(), t.arrays());
            }
    }
    // Random sites are decided by the filter, a grid meets ties, far away only rationals help.
    Options options;
    options.count = true;
    const Statistics plain = triangulate(many(2000), Power{}, options).statistics();
    EXPECT_GT(plain.filtered, 9 * (plain.refined + plain.exact + plain.multiprecision));
    std::vector<Point> grid;
    for (int i = 0; i < 400; ++i) grid.push_back({1.0 * (i % 20), 1.0 * (i / 20)});
    EXPECT_GT(triangulate(grid, Power{}, options).statistics().ties, 100U);
    for (Point& p : grid) p = {p.x * 0x1p-1074, p.y * 0x1p-1074};
    EXPECT_GT(triangulate(grid, Power{}, options).statistics().multiprecision, 1000U);
}

TEST(TriangulateOptions, NaiveArithmeticAgreesWhereNothingIsClose) {
    Options options;
    options.arithmetic = Arithmetic::naive;
    const auto sites = many(300);
    EXPECT_EQ(triangulate(sites, Power{}, options).arrays(), triangulate(sites, Power{}).arrays());
}

// ---- against the oracle ------------------------------------------------------------------------

/// Discs whose radii have nothing in common: the difference of two squares in more than two
/// doubles.
TEST(TessellationRegression, RadiiFarApart) {
    Random random(13);
    static constexpr double radii[] = {0, 1, 0x1p-60, 0x1p-70, 2, 0x1p-30, -1, 1 + 0x1p-52};
    for (int round = 0; round < 400 / share; ++round) {
        std::vector<Site> sites(static_cast<std::size_t>(random.between(4, 9)));
        for (Site& s : sites)
            s = {1.0 * random.between(-2, 2), 1.0 * random.between(-2, 2), radii[random.below(8)]};
        const Tessellation t = triangulate(sites, Power{});
        const oracle::Tessellation expected = oracle::power(sites);
        ASSERT_TRUE(std::equal(t.faces().begin(), t.faces().end(), expected.faces.begin(),
                               expected.faces.end()));
        ASSERT_EQ(t.hidden().size(), expected.hidden.size());
        for (std::size_t i = 0; i < expected.hidden.size(); ++i)
            ASSERT_EQ((std::array{t.hidden()[i].site, t.hidden()[i].by}), expected.hidden[i]);
    }
    // (0,0) stands out of the plane of its neighbours by 2^-120.
    const std::vector<Site> four = {{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}, {0, 0, 0x1p-60}};
    EXPECT_TRUE(triangulate(four, Power{}).hidden().empty());
}

/// Squares of coordinates near the fourth root of the largest double.
TEST(TessellationRegression, WhereOneTermOverflows) {
    for (double l = 0x1p250; l < 0x1p260; l *= 1.5) {
        std::vector<Site> sites;
        for (int x = 0; x < 4; ++x)
            for (int y = 0; y < 4; ++y) sites.push_back({x * l, y * l, 0});
        std::vector<Site> small;
        for (const Site& s : sites) small.push_back({s.x / l, s.y / l, 0});
        EXPECT_EQ(triangulate(sites, Power{}).arrays(), triangulate(small, Power{}).arrays()) << l;
    }
}

}  // namespace
}  // namespace signum
