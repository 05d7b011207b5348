#pragma once
/// What the library builds, as jobs of one kind that any number of threads can do: each is a
/// function of its sites and tells its result by one number. For tests of what goes on around a
/// construction: threads, memory, the stack.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../motion/simulation.hpp"
#include "../../triangulation/any_dimension/triangulate.hpp"
#include "../../triangulation/any_dimension/validate.hpp"
#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/edge_list.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/space/compare.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/compare.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/voronoi.hpp"

namespace signum::constructions {

/// Numbers in their order, made into one.
class Digest {
 public:
    void add(std::int64_t number) noexcept {
        value_ = (std::rotl(value_, 5) ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15;
    }
    void add(double number) noexcept { add(std::bit_cast<std::int64_t>(number)); }
    template <std::size_t n>
    void add(const std::array<Index, n>& numbers) noexcept {
        for (const Index number : numbers) add(std::int64_t{number});
    }
    void add(const Hidden& hidden) noexcept {
        add(std::int64_t{hidden.site});
        add(std::int64_t{hidden.by});
    }
    template <class T>
    void add_all(const T& things) noexcept {
        for (const auto& thing : things) add(thing);
    }
    [[nodiscard]] std::uint64_t value() const noexcept { return value_; }

 private:
    std::uint64_t value_ = 20;
};

inline void require(const Validation& validation) {
    if (!validation.canonical) throw std::logic_error(validation.message);
}

/// Sites full of ties, of which every eighth is moved by an ulp or by a power of two so small that
/// the last stages are asked.
inline std::vector<Site> sites_near_ties(std::size_t number) {
    std::mt19937 bits(20);
    const auto below = [&](unsigned count) { return static_cast<int>(bits() % count); };
    const auto side = static_cast<unsigned>(std::sqrt(static_cast<double>(number))) + 1;
    std::vector<Site> sites(number);
    for (Site& s : sites) {
        s = {1.0 * below(side), 1.0 * below(side), 0.25 * below(4)};
        if (below(8) == 0)
            s.x = s.x != 0.0 ? std::nextafter(s.x, 0.0) : std::ldexp(1.0, -below(900));
    }
    return sites;
}
/// The same in space: the third coordinate is told by the first two.
inline std::vector<Site3> sites_in_space(std::span<const Site> sites) {
    std::vector<Site3> result;
    for (std::size_t i = 0; i < sites.size(); ++i)
        result.push_back({sites[i].x, sites[i].y, static_cast<double>(i % 5), sites[i].r});
    return result;
}

template <Metric metric>
std::uint64_t tessellation(std::span<const Site> sites) {
    Digest digest;
    const Tessellation built = triangulate(sites, metric);
    require(validate(built));
    digest.add_all(built.faces());
    digest.add_all(built.hidden());
    return digest.value();
}
template <Metric metric, Method method>
std::uint64_t tessellation_by(std::span<const Site> sites) {
    Digest digest;
    Options options;
    options.method = method;
    const Tessellation built = triangulate(sites, metric, options);
    digest.add_all(built.faces());
    digest.add_all(built.hidden());
    return digest.value();
}
template <Metric metric>
std::uint64_t diagram(std::span<const Site> sites) {
    Digest digest;
    const Voronoi diagram = voronoi(triangulate(sites, metric));
    const ClippedVoronoi clipped(diagram, default_box(sites));
    for (std::size_t i = 0; i < sites.size(); ++i)
        digest.add(measure(clipped.cell(static_cast<Index>(i))).area);
    return digest.value();
}
template <Metric metric>
std::uint64_t dynamic_tessellation(std::span<const Site> sites) {
    Digest digest;
    DynamicTessellation dynamic(metric);
    for (const Site& s : sites) dynamic.insert(s);
    for (std::size_t i = 0; i < sites.size(); i += 3) dynamic.erase(static_cast<Index>(i));
    for (std::size_t i = 1; i < sites.size(); i += 3) {
        dynamic.change(static_cast<Index>(i), 1.5 * sites[i].r);
        dynamic.move(static_cast<Index>(i), {sites[i].x + 0.125, sites[i].y});
    }
    std::vector<Point> centres;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (i % 3 != 0) centres.push_back({sites[i].x, sites[i].y + 0x1p-10});
    dynamic.move_all(centres);
    const Tessellation built = dynamic.tessellation();
    digest.add_all(built.faces());
    digest.add_all(built.hidden());
    return digest.value();
}

inline std::uint64_t tessellation_of_space(std::span<const Site> sites) {
    Digest digest;
    const std::vector<Site3> balls = sites_in_space(sites);
    const SpaceTessellation built = triangulate(std::span<const Site3>(balls));
    require(validate(built, std::span<const Site3>(balls)));
    digest.add_all(built.cells);
    digest.add_all(built.hidden);
    return digest.value();
}
inline std::uint64_t cells_of_space(std::span<const Site> sites) {
    Digest digest;
    std::vector<Site3> balls = sites_in_space(sites);
    const SpaceTessellation built = triangulate(std::span<const Site3>(balls));
    const SpaceCells cells = space_cells(built, balls, default_box(std::span<const Site3>(balls)));
    for (const SpaceMeasure& each : cells.measures) digest.add(each.volume);
    return digest.value();
}
inline std::uint64_t tessellation_in_four_dimensions(std::span<const Site> sites) {
    Digest digest;
    std::vector<power::SiteOf<4>> lifted;
    for (std::size_t i = 0; i < sites.size(); ++i)
        lifted.push_back(
            {{sites[i].x, sites[i].y, static_cast<double>(i % 3), static_cast<double>(i % 2)},
             sites[i].r});
    const auto built = triangulate<4>(lifted);
    require(validate<4>(built, lifted));
    digest.add_all(built.cells);
    return digest.value();
}
inline std::uint64_t diagram_of_balls(std::span<const Site> sites) {
    Digest digest;
    const BallDiagram built = ball_diagram(sites_in_space(sites));
    digest.add_all(built.ends);
    for (const Site3& sphere : built.spheres) digest.add(sphere.r);
    digest.add_all(built.hidden);
    return digest.value();
}

inline std::uint64_t kinetic_tessellation(std::span<const Site> sites) {
    Digest digest;
    std::vector<MovingSite> moving;
    for (std::size_t i = 0; i < sites.size(); ++i)
        moving.push_back({sites[i].x, sites[i].y, static_cast<double>(i % 7) - 3.0,
                          static_cast<double>(i % 5) - 2.0, sites[i].r});
    KineticTessellation kinetic(moving, 0.0, {0.0, -1.0});
    kinetic.advance(0x1p-6);
    kinetic.erase(0);
    kinetic.insert({0.5, 0.5, 1.0, 0.0, 0.5, 0.0});
    kinetic.change(1, {0.25, 0.5, 1.0, 0.0, 0.5, 0.0});
    kinetic.advance(0x1p-5);
    digest.add_all(kinetic.faces());
    digest.add_all(kinetic.tessellation().faces());
    return digest.value();
}

/// Balls that lose energy, spin, grow and are shaken.
template <int D>
void add_effects(motion::Effects<D>& effects) {
    effects.restitution = 0.75;
    effects.wall_restitution = 0.5;
    effects.speed_law = motion::SpeedLaw{};
    effects.contact_duration = 0x1p-10;
    effects.friction = motion::Friction{0.5, 0.25, 0.5};
    effects.shake.emplace();
    effects.shake->amplitude[1] = 0x1p-6;
    effects.shake->frequency = 8.0;
    effects.growth = motion::Growth{0x1p-6, 1.0};
}

/// One ball a site, on a lattice.
template <int D, motion::Structure structure, bool has_effects = false>
std::uint64_t moving_balls(std::span<const Site> sites) {
    Digest digest;
    const auto side =
        static_cast<std::size_t>(std::ceil(std::pow(static_cast<double>(sites.size()), 1.0 / D)));
    std::vector<motion::Body<D>> bodies(sites.size());
    motion::Effects<D> effects;
    effects.box.emplace();
    effects.box->high.fill(static_cast<double>(side));
    effects.gravity[1] = -1.0;
    if constexpr (has_effects) add_effects(effects);
    for (std::size_t i = 0; i < sites.size(); ++i) {
        std::size_t rest = i;
        for (double& x : bodies[i].x) {
            x = static_cast<double>(rest % side) + 0.5;
            rest /= side;
        }
        bodies[i].v[0] = static_cast<double>(i % 5) - 2.0;
        bodies[i].v[D - 1] = static_cast<double>(i % 3) - 1.0;
        bodies[i].radius = 0.375;
    }
    motion::Simulation<D> simulation(motion::start<D>(bodies, effects), effects, {structure});
    motion::Limits limits;
    limits.strikes = 4 * sites.size();
    simulation.run(limits, [&](const motion::Strike& strike) { digest.add(strike.time); });
    for (const motion::Ball<D>& ball : simulation.state().balls) digest.add(ball.x[0]);
    static_cast<void>(simulation.sketch());
    return digest.value();
}

/// What is asked of results.
inline std::uint64_t questions(std::span<const Site> sites) {
    Digest digest;
    for (const Metric metric : all_metrics) {
        const Tessellation built = triangulate(sites, metric);
        digest.add_all(EdgeList(built.arrays()).arrays().faces);
        digest.add(compare_edges(built, built).edges);
        for (const DiagramVertex& vertex : vertices(built)) digest.add(vertex.rho);
    }
    const std::vector<Site3> balls = sites_in_space(sites);
    const std::span<const Site3> all(balls);
    const SpaceTessellation built = triangulate(all);
    digest.add(compare_cells(built, built, all).cells);
    digest.add(ties_of(built, all).ties);
    for (const SpaceVertex& vertex : vertices(built, all)) digest.add(vertex.rho);
    return digest.value();
}

/// A job, and how many sites make it one of a few milliseconds.
struct Construction {
    const char* name;
    std::uint64_t (*run)(std::span<const Site> sites);
    std::size_t few;
};
inline constexpr std::array all = {
    Construction{"power", tessellation<Metric::power>, 200},
    Construction{"Euclidean", tessellation<Metric::euclidean>, 200},
    Construction{"Manhattan", tessellation<Metric::manhattan>, 200},
    Construction{"supremum", tessellation<Metric::supremum>, 200},
    Construction{"flips", tessellation_by<Metric::power, Method::flips>, 200},
    Construction{"sweep", tessellation_by<Metric::supremum, Method::sweep>, 200},
    Construction{"power diagram", diagram<Metric::power>, 100},
    Construction{"Euclidean diagram", diagram<Metric::euclidean>, 100},
    Construction{"Manhattan diagram", diagram<Metric::manhattan>, 100},
    Construction{"supremum diagram", diagram<Metric::supremum>, 100},
    Construction{"dynamic, power", dynamic_tessellation<Metric::power>, 100},
    Construction{"dynamic, Euclidean", dynamic_tessellation<Metric::euclidean>, 100},
    Construction{"dynamic, Manhattan", dynamic_tessellation<Metric::manhattan>, 100},
    Construction{"dynamic, supremum", dynamic_tessellation<Metric::supremum>, 100},
    Construction{"space", tessellation_of_space, 100},
    Construction{"cells of space", cells_of_space, 50},
    Construction{"four dimensions", tessellation_in_four_dimensions, 20},
    Construction{"balls", diagram_of_balls, 12},
    Construction{"questions", questions, 20},
    Construction{"kinetic", kinetic_tessellation, 50},
    Construction{"motion by cells", moving_balls<2, motion::Structure::cells>, 50},
    Construction{"motion by levels", moving_balls<3, motion::Structure::levels>, 50},
    Construction{"motion by lists, with effects", moving_balls<2, motion::Structure::lists, true>,
                 50},
    Construction{"motion by Delaunay", moving_balls<2, motion::Structure::delaunay>, 50},
};

}  // namespace signum::constructions
