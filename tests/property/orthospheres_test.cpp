/// What the rounded spheres of cells tell is what in_sphere says, for well and badly shaped cells,
/// near sites and far ones, with weights and without; and for ordinary ones they do tell.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/space/in_sphere.hpp"
#include "../../triangulation/space/orthospheres.hpp"
#include "../oracle/oracle_test_support.hpp"
#include "../thoroughness.hpp"

namespace signum::spatial {
namespace {

using oracle_test::Random;

struct Count {
    std::int64_t told = 0;
    std::int64_t all = 0;
};

/// Cells of the first four of `sites` at a time, made as an insertion makes them, and all the other
/// sites asked.
template <class S>
void judge(const std::vector<S>& sites, Count& count) {
    const Frame frame = frame_of(std::span<const S>(sites));
    const auto last = static_cast<Index>(sites.size());
    View<S> view(sites.data());
    for (Index q = 0; q + 3 < last; q += 4) {
        view.look_from(q);
        for (Index v = q + 1; v <= q + 3; ++v) view.see(v);
        view.set_bound();
        Facet facet{.vertex = {1, 2, 3}};
        const auto at = [&](Index v) { return sites[static_cast<std::size_t>(v)]; };
        const Sign turn = ccw(at(q), at(q + 1), at(q + 2), at(q + 3));
        if (turn == 0) continue;
        if (turn < 0) std::swap(facet.vertex[1], facet.vertex[2]);
        const Facet beyond{.vertex = {seen_infinity, facet.vertex[1], facet.vertex[2]}};
        const SphereMaker maker(view.rows(), in_frame(at(q), frame), frame, view.reach(),
                                view.height());
        // One more than are made at once.
        std::array<Orthosphere, 5> spheres;
        constexpr std::array<Index, 5> cells = {4, 2, 0, 3, 1};
        maker.make(std::array{facet, beyond, facet, facet, facet}, cells.data(), spheres.data());
        for (Index p = 0; p < last; ++p) {
            if (p >= q && p <= q + 3) continue;
            std::array<Told, 4> told;
            const SphereTest test(in_frame(at(p), frame), frame);
            ASSERT_FALSE(test(spheres[0], spheres[2], taken_sphere, unknown_sphere, told));
            ASSERT_EQ(told[1], Told::nothing);
            ASSERT_EQ(told[2], Told::taken);
            ASSERT_EQ(told[3], Told::nothing);
            std::array<Told, 4> again;
            ASSERT_EQ(test(spheres[1], spheres[3], taken_sphere, spheres[4], again),
                      told[0] != Told::nothing);
            ASSERT_EQ(again, (std::array{told[0], told[0], Told::taken, told[0]}));
            std::array<std::int32_t, 4> distances;
            test.distances(spheres[0], spheres[1], spheres[2], unknown_sphere, distances);
            for (std::int32_t k = 0; k < 4; ++k)
                ASSERT_EQ(distances[static_cast<std::size_t>(k)] & 3, k);
            ASSERT_EQ(distances[0] < 0, told[0] == Told::conflict);
            ASSERT_EQ(distances[1] >> 2, distances[0] >> 2);
            ASSERT_GE(distances[2], 0);
            ASSERT_GE(distances[3], std::max(distances[0] & ~3, distances[2] & ~3));
            ++count.all;
            if (told[0] == Told::nothing) continue;
            ++count.told;
            const auto& [b, c, d] = facet.vertex;
            const Sign sign = power::in_sphere(at(q), at(q + b), at(q + c), at(q + d), at(p));
            ASSERT_EQ(told[0], sign > 0 ? Told::conflict : Told::none) << q << ' ' << p;
        }
    }
}

template <class S>
std::vector<S> draw(Random& random, int kind) {
    std::vector<S> sites;
    const double scale = std::ldexp(1.0, kind == 5 ? 120 : kind == 6 ? -120 : 0);
    const double flat = std::ldexp(1.0, -random.below(40));
    const double far = kind == 4 ? std::ldexp(1.0, random.below(45)) : 0.0;
    for (int i = 0; i < 40; ++i) {
        double x = random.unit();
        double y = random.unit();
        double z = random.unit();
        if (kind == 1) z *= flat;
        if (kind == 2) y *= flat, z *= flat;
        if (kind == 3) {
            // Nearly on a sphere.
            const double length = std::sqrt(x * x + y * y + z * z) * (1.0 + flat * random.unit());
            x /= length, y /= length, z /= length;
        }
        if (kind == 8) {
            // Nearly on a circle: four of them have nearly any sphere through it.
            const double turn = 7.0 * x;
            const double off = std::ldexp(flat, -12);
            x = std::cos(turn) + off * y;
            y = std::sin(turn) + off * z;
            z = i % 8 < 4 ? off * random.unit() : z;
        }
        if (kind == 7 && i % 8 != 0) {
            // Seven close to an eighth, and to one another.
            const std::size_t first = sites.size() / 8 * 8;
            x = sites[first].x + flat * x;
            y = sites[first].y + flat * y;
            z = sites[first].z + flat * z;
        }
        S site{};
        site.x = scale * (x + far);
        site.y = scale * (y - far);
        site.z = scale * z;
        if constexpr (requires { site.r; })
            site.r = scale * random.unit() * (i % 3 == 0 ? 4.0 : 0.1);
        if constexpr (requires { site.w; })
            site.w = scale * scale * (random.unit() - 0.5) * (i % 3 == 0 ? 4.0 : 0.1);
        sites.push_back(site);
    }
    return sites;
}

template <class S>
void judge_all(std::uint64_t seed) {
    Random random(seed);
    std::array<Count, 9> counts;
    for (int trial = 0; trial < 200 * thoroughness; ++trial)
        for (int kind = 0; kind < 9; ++kind)
            ASSERT_NO_FATAL_FAILURE(
                judge(draw<S>(random, kind), counts[static_cast<std::size_t>(kind)]));
    for (const std::size_t ordinary : {0, 5, 6})
        EXPECT_GT(counts[ordinary].told, 0.85 * static_cast<double>(counts[ordinary].all));
    for (std::size_t kind = 0; kind < 8; ++kind) EXPECT_GT(counts[kind].told, 0);
}

TEST(Orthospheres, OfPointsTellTheTruth) {
    judge_all<Point3>(51);
}
TEST(Orthospheres, OfBallsTellTheTruth) {
    judge_all<Site3>(52);
}
TEST(Orthospheres, OfWeightsTellTheTruth) {
    judge_all<power::Site3>(53);
}

/// Points near a sphere of floats: within the bound nothing is told, beyond it the truth.
TEST(Orthospheres, TellNothingWhereTheyAreTooClose) {
    Random random(54);
    std::vector<Point3> sites = {
        {1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    for (int i = 0; i < 4000; ++i) {
        Point3 p = {random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
        const double off = (1.0 + std::ldexp(random.unit() - 0.5, -random.below(20))) /
                           std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        sites.push_back({p.x * off, p.y * off, p.z * off});
    }
    Count count;
    ASSERT_NO_FATAL_FAILURE(judge(sites, count));
    EXPECT_GT(count.told, count.all / 4);
    EXPECT_LT(count.told, count.all);
}

TEST(Orthospheres, HaveNoFrameBeyondTheWindow) {
    for (const double far : {0x1p160, 0x1p1023, 0x1p-160}) {
        const std::vector<Point3> sites = {{far, 0.0, 0.0}, {-far, 0.0, 0.0}, {0.0, far, far}};
        EXPECT_EQ(frame_of(std::span<const Point3>(sites)).scale, 0.0);
    }
}

}  // namespace
}  // namespace signum::spatial
