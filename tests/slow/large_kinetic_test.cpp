/// A thousand systems of moving sites, each looked at ten thousand times: whenever that is, the
/// faces kept up are a power triangulation of where the sites are then, judged exactly.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/ccw.hpp"
#include "../../predicates/power.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../property/moving_systems.hpp"

namespace signum {
namespace {

// A hundred systems of each kind, of 3 to 200 sites.
#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr int systems_of_a_kind = 10;
constexpr int most_sites = 40;
constexpr int times = 500;
#else
constexpr int systems_of_a_kind = 100;
constexpr int most_sites = 200;
constexpr int times = 10'000;
#endif
constexpr double step = 0x1p-11;
constexpr double moment = 0x1p-30;
constexpr int times_between_validations = 100;
constexpr int times_between_new_builds = 1000;

const Site& at(std::span<const Site> sites, Index i) {
    return sites[static_cast<std::size_t>(i)];
}

/// Whether the faces are a power triangulation of the sites, and how nearly they are not one.
struct Verdict {
    const char* wrong = nullptr;  ///< what is, if anything
    int flat = 0;                 ///< faces with three corners on one line
    bool tied = false;            ///< another set of faces would be as right
};

/// Faces as a surface: what does not change while the sites move and the faces stay.
///
/// Why it suffices to look at every face and every edge once. Each edge has a face on both sides,
/// but for those of one closed rim. So a point of the plane that lies on no edge is covered by as
/// many faces as the rim goes round it, if all faces turn counterclockwise: where the rim is convex
/// and goes round once, the faces tile the inside of the rim, and no place twice. Lift the sites to
/// x² + y² - w; over this tiling the lifted faces are the graph of a function. Where at every edge
/// the vertex beyond is not in conflict, this function is convex near each point of a convex
/// region, so it is convex, and where also each site that is no vertex lies in a face, not in
/// conflict with it, the graph is the lower hull of all lifted sites, and no circle of a face is in
/// conflict with any site. Where none of these signs is 0 no other set of faces is right.
///
/// Of faces that are flat circles are not asked: then all sites are asked about all circles.
class Surface {
 public:
    Surface(std::vector<Face> faces, std::size_t number) : faces_(std::move(faces)) {
        std::vector<Side> sides;
        std::vector<bool> seen(number);
        for (const Face& face : faces_)
            for (std::size_t k = 0; k < 3; ++k) {
                sides.push_back({{face[k], face[(k + 1) % 3]}, face[(k + 2) % 3]});
                seen[static_cast<std::size_t>(face[k])] = true;
            }
        for (std::size_t i = 0; i < number; ++i)
            if (!seen[i]) hidden_.push_back(static_cast<Index>(i));
        std::ranges::sort(sides, {}, &Side::edge);
        if (std::ranges::adjacent_find(sides, {}, &Side::edge) != sides.end()) return;

        std::vector<Index> next_on_rim(number, infinite);
        std::size_t on_rim = 0;
        Index first = infinite;
        for (const Side& side : sides) {
            const auto [a, b] = side.edge;
            const auto twin = std::ranges::lower_bound(sides, std::array{b, a}, {}, &Side::edge);
            if (twin != sides.end() && twin->edge == std::array{b, a}) {
                if (a < b) hinges_.push_back({a, b, side.apex, twin->apex});
                continue;
            }
            Index& next = next_on_rim[static_cast<std::size_t>(a)];
            if (next != infinite) return;
            next = b;
            first = a;
            ++on_rim;
        }
        for (Index i = first; i != infinite;) {
            rim_.push_back(i);
            i = next_on_rim[static_cast<std::size_t>(i)];
            if (i == first) break;
        }
        // Every corner has as many edges in as out: a walk along the rim ends where it began.
        is_closed_ = !rim_.empty() && rim_.size() == on_rim;
    }

    [[nodiscard]] const std::vector<Face>& faces() const noexcept { return faces_; }

    [[nodiscard]] Verdict judge(std::span<const Site> sites) const {
        Verdict verdict;
        if (faces_.empty()) {
            if (!are_on_one_line(sites)) verdict.wrong = "no faces";
            return verdict;
        }
        if (!is_closed_) return {"edges without a twin are no single rim", 0, false};
        for (const Face& face : faces_) {
            const int side = ccw(at(sites, face[0]), at(sites, face[1]), at(sites, face[2]));
            if (side < 0) return {"a face turns clockwise", 0, false};
            verdict.flat += static_cast<int>(side == 0);
        }
        if (!goes_round_once(sites)) return {"the rim is not convex", 0, false};
        verdict.tied = verdict.flat > 0;
        if (verdict.flat > 0) {
            for (const Face& face : faces_)
                for (std::size_t i = 0; i < sites.size(); ++i)
                    ask(sites, face, static_cast<Index>(i), verdict);
            return verdict;
        }
        for (const auto& [a, b, apex, beyond] : hinges_) ask(sites, {a, b, apex}, beyond, verdict);
        for (const Index site : hidden_) {
            const auto face = std::ranges::find_if(faces_, [&](const Face& each) {
                return ccw(at(sites, each[0]), at(sites, each[1]), at(sites, site)) >= 0 &&
                       ccw(at(sites, each[1]), at(sites, each[2]), at(sites, site)) >= 0 &&
                       ccw(at(sites, each[2]), at(sites, each[0]), at(sites, site)) >= 0;
            });
            if (face == faces_.end()) return {"a site lies beyond all faces", 0, false};
            ask(sites, *face, site, verdict);
        }
        return verdict;
    }

 private:
    struct Side {
        std::array<Index, 2> edge;
        Index apex;
    };

    /// Whether a site is in conflict with a face; not of its corners, nor of flat faces.
    static void ask(std::span<const Site> sites, const Face& face, Index site, Verdict& verdict) {
        if (std::ranges::find(face, site) != face.end()) return;
        const auto& [a, b, c] = face;
        if (!power::exists(at(sites, a), at(sites, b), at(sites, c))) return;
        const int sign =
            power::in_circle(at(sites, a), at(sites, b), at(sites, c), at(sites, site));
        if (sign > 0) verdict.wrong = "a site is in conflict with a face";
        verdict.tied |= sign == 0;
    }

    /// Whether the rim never turns right, and is a way up and a way down in the order by x and y.
    /// Corners at one place, as there are where sites meet, count once.
    [[nodiscard]] bool goes_round_once(std::span<const Site> sites) const {
        std::vector<Point> corners;
        for (const Index i : rim_) {
            const Point p{at(sites, i).x, at(sites, i).y};
            if (corners.empty() || p != corners.back()) corners.push_back(p);
        }
        while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
        const std::size_t n = corners.size();
        const auto rises = [](const Point& p, const Point& q) {
            return std::tuple(p.x, p.y) < std::tuple(q.x, q.y);
        };
        int tops = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const Point& before = corners[(k + n - 1) % n];
            const Point& here = corners[k];
            const Point& after = corners[(k + 1) % n];
            if (n > 2 && ccw(before, here, after) < 0) return false;
            tops += static_cast<int>(rises(before, here) && rises(after, here));
        }
        return n == 1 || tops == 1;
    }

    static bool are_on_one_line(std::span<const Site> sites) {
        const auto other = std::ranges::find_if(
            sites, [&](const Site& each) { return each.x != sites[0].x || each.y != sites[0].y; });
        return other == sites.end() || std::ranges::all_of(sites, [&](const Site& each) {
                   return ccw(sites[0], *other, each) == 0;
               });
    }

    std::vector<Face> faces_;
    std::vector<std::array<Index, 4>> hinges_;  ///< an edge, and the corners on its left and right
    std::vector<Index> rim_;                    ///< counterclockwise
    std::vector<Index> hidden_;
    bool is_closed_ = false;
};

/// How often what was to be seen.
struct Tally {
    int looks = 0;
    int changed = 0;      ///< looks at which the faces were other ones than before
    int tied = 0;         ///< looks at which something was tied
    int flat = 0;         ///< ... and faces were flat
    int right_after = 0;  ///< looks a moment later
    int compared = 0;     ///< with a new triangulation
};

class LargeKinetic : public testing::TestWithParam<int> {
 protected:
    void TearDown() override {
        RecordProperty("looks", tally_.looks);
        RecordProperty("changed", tally_.changed);
        RecordProperty("tied", tally_.tied);
        RecordProperty("flat", tally_.flat);
        RecordProperty("right_after", tally_.right_after);
        RecordProperty("compared", tally_.compared);
    }

    void look_at(const std::vector<MovingSite>& sites) {
        KineticTessellation moving(sites, 0.0);
        std::optional<Surface> surface;
        for (int i = 0; i < times; ++i) {
            moving.advance(i * step);
            std::vector<Face> faces = moving.faces();
            if (!surface || surface->faces() != faces) {
                surface.emplace(std::move(faces), sites.size());
                ++tally_.changed;
            }
            const std::vector<Site> now = places(sites, moving.time());
            const Verdict verdict = surface->judge(now);
            ASSERT_EQ(verdict.wrong, nullptr) << verdict.wrong << " at " << moving.time();
            ++tally_.looks;
            tally_.tied += static_cast<int>(verdict.tied);
            tally_.flat += static_cast<int>(verdict.flat > 0);

            // What is right after an event is not yet to be seen at its very time.
            const bool is_validated = i % times_between_validations == 0;
            if (verdict.flat > 0 || is_validated) look_right_after(moving, sites, *surface);
            if (is_validated) validate_result(moving, now, *surface, verdict.tied);
            if (i % times_between_new_builds == 0) {
                ASSERT_EQ(KineticTessellation(sites, moving.time()).faces(), surface->faces())
                    << "at " << moving.time();
            }
            if (HasFailure()) return;
        }
    }

    Tally tally_;

 private:
    /// Until the next event the faces stay, and none of them is flat.
    void look_right_after(const KineticTessellation& moving, const std::vector<MovingSite>& sites,
                          const Surface& surface) {
        const double soon = moving.time() + moment;
        const std::optional<double> event = moving.next_event();
        if (event && *event <= soon) return;
        const Verdict verdict = surface.judge(places(sites, soon));
        ASSERT_EQ(verdict.wrong, nullptr) << verdict.wrong << " right after " << moving.time();
        ASSERT_EQ(verdict.flat, 0) << "right after " << moving.time();
        ++tally_.right_after;
    }

    void validate_result(const KineticTessellation& moving, const std::vector<Site>& now,
                         const Surface& surface, bool is_tied) {
        const Tessellation result = moving.tessellation();
        ASSERT_TRUE(std::ranges::equal(result.sites(), now));
        const Validation validation = validate(result);
        ASSERT_TRUE(validation.valid) << validation.message << " at " << moving.time();
        if (is_tied) return;
        const Tessellation fresh = triangulate(now, Metric::power);
        ASSERT_EQ(surface.faces(), finite_faces(fresh)) << "at " << moving.time();
        ASSERT_TRUE(std::ranges::equal(result.faces(), fresh.faces())) << "at " << moving.time();
        ++tally_.compared;
    }
};

TEST_P(LargeKinetic, IsAPowerTriangulationAtAnyTime) {
    const int kind = GetParam();
    for (int i = 0; i < systems_of_a_kind; ++i) {
        const int number = 3 + i * (most_sites - 3) / (systems_of_a_kind - 1);
        Systems systems(static_cast<std::uint64_t>(40'000 + 1000 * kind + i));
        const std::vector<MovingSite> sites = systems.make(kind, number);
        SCOPED_TRACE("system " + std::to_string(i) + ": " + text(sites));
        look_at(sites);
        if (HasFailure()) return;
    }
    EXPECT_EQ(tally_.looks, systems_of_a_kind * times);
    EXPECT_GT(tally_.compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LargeKinetic, testing::Range(0, Systems::kinds),
                         [](const testing::TestParamInfo<int>& of) {
                             return Systems::names[static_cast<std::size_t>(of.param)];
                         });

}  // namespace
}  // namespace signum
