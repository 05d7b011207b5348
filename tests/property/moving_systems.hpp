#pragma once
/// Systems of moving sites that are meant to break a tessellation, and what is said of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../triangulation/moving/moving_site.hpp"
#include "../../triangulation/tessellation.hpp"
#include "../oracle/oracle_test_support.hpp"

namespace signum {

/// Systems by kind. Numbers are dyadic and short: at times below 8 that are multiples of 2^-30 the
/// places are doubles, and so are all steps on the way there.
struct Systems {
    oracle_test::Random random;
    explicit Systems(std::uint64_t seed) : random(seed) {}
    double pick(double size, int parts) {
        return size * (random.below(2 * parts + 1) - parts) / parts;
    }
    std::vector<MovingSite> make(int kind, int number) {
        std::vector<MovingSite> sites;
        for (int i = 0; i < number; ++i) {
            switch (kind) {
                case anywhere:
                    sites.push_back(
                        {pick(8, 1024), pick(8, 1024), pick(1, 256), pick(1, 256), 0, 0});
                    break;
                case 1:  // anywhere, weighted, from their own times
                    sites.push_back({pick(8, 1024), pick(8, 1024), pick(1, 256), pick(1, 256),
                                     random.below(2) * std::fabs(pick(2, 64)), pick(1, 4)});
                    break;
                case 2:  // small integers: ties everywhere
                    sites.push_back({pick(4, 4), pick(4, 4), pick(2, 2), pick(2, 2),
                                     static_cast<double>(random.below(2)), 0});
                    break;
                case 3:  // two streams that cross
                    if (i % 2 == 0)
                        sites.push_back({pick(8, 1024), pick(1, 1024), 1, 0, 0, 0});
                    else
                        sites.push_back({pick(1, 1024), pick(8, 1024), 0, -1, 0, 0});
                    break;
                case 4:  // parallel lines, each at its speed
                    sites.push_back({pick(8, 16), static_cast<double>(i % 4), pick(1, 2), 0,
                                     0.25 * random.below(2), 0});
                    break;
                case 5:  // a lattice whose rows slide
                    sites.push_back({static_cast<double>(i % 4), static_cast<double>(i / 4),
                                     0.5 * static_cast<double>(i / 4 % 3), 0, 0.5, 0});
                    break;
                case 6:  // on one line for ever
                    sites.push_back({pick(8, 32), 0, pick(1, 8), 0, 0.5 * random.below(3), 0});
                    sites.back().y = 0.5 * sites.back().x;
                    sites.back().vy = 0.5 * sites.back().vx;
                    break;
                case 7:  // all through one place at time 2: a star
                    sites.push_back({-2 * pick(2, 8), -2 * pick(2, 8), 0, 0, 0, 0});
                    sites.back().vx = -0.5 * sites.back().x;
                    sites.back().vy = -0.5 * sites.back().y;
                    break;
                case 8:  // all on one line at time 2: the hull turns over
                    sites.push_back({pick(8, 64), 0, 0, pick(1, 16), 0.25 * random.below(3), 2});
                    break;
                case tied_for_ever: {  // all orthogonal to one circle, at every time: tied for ever
                    const double p = pick(4, 8);
                    // Its centre is (0, t - 3).
                    if (i % 3 == 0) {
                        sites.push_back({p, 0, 0, 0, std::fabs(p), 0});
                    } else if (i % 3 == 1) {
                        const double side = random.below(2) == 0 ? 1.0 : -1.0;
                        sites.push_back({3 * side, p - 2, -side, 1, std::fabs(1 + p), 0});
                    } else {
                        sites.push_back({p, -6, 0, 2, std::fabs(p), 0});
                    }
                    break;
                }
                default:  // a lattice that spins as a top does, seen as a shear and back
                    sites.push_back({static_cast<double>(i % 5) - 2, static_cast<double>(i / 5) - 2,
                                     -0.5 * (static_cast<double>(i / 5) - 2),
                                     0.5 * (static_cast<double>(i % 5) - 2), 0.5 * (i % 3 == 0),
                                     0});
            }
        }
        return sites;
    }
    static constexpr int anywhere = 0;
    static constexpr int tied_for_ever = 9;
    static constexpr std::array names = {"anywhere", "weighted", "integers", "streams",
                                         "parallel", "sliding",  "one_line", "star",
                                         "turning",  "tied",     "spinning"};
    static constexpr int kinds = static_cast<int>(names.size());
};

inline std::string text(const std::vector<MovingSite>& sites) {
    std::string result;
    for (const MovingSite& m : sites)
        result += "{" + std::to_string(m.x) + "," + std::to_string(m.y) + "," +
                  std::to_string(m.vx) + "," + std::to_string(m.vy) + "," + std::to_string(m.r) +
                  "," + std::to_string(m.time) + "}, ";
    return result;
}

/// Where the sites are at a time, if these are doubles.
inline std::vector<Site> places(const std::vector<MovingSite>& sites, double t) {
    std::vector<Site> result;
    for (const MovingSite& m : sites)
        result.push_back({m.x + m.vx * (t - m.time), m.y + m.vy * (t - m.time), m.r});
    return result;
}

inline std::vector<Face> finite_faces(const Tessellation& tessellation) {
    std::vector<Face> result;
    for (const Face& face : tessellation.faces())
        if (std::ranges::find(face, infinite) == face.end()) result.push_back(face);
    std::ranges::sort(result);
    return result;
}

}  // namespace signum
