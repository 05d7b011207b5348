#include "structures.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../triangulation/dynamic.hpp"
#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"

#include "bytes.hpp"

namespace signum::fuzz {
namespace {

constexpr std::size_t most_bytes = 600;

Choices choices_of(Bytes bytes) {
    return Choices(bytes.first(std::min(bytes.size(), most_bytes)));
}

Site next_site(Choices& choices) {
    const double x = choices.coordinate();
    const double y = choices.coordinate();
    return {x, y, choices.radius()};
}

/// The n-th of those that there are, n modulo their number. Precondition: there is one.
template <class Map>
auto any_of(Map& sites, Choices& choices) {
    return std::next(sites.begin(), choices.below(static_cast<int>(sites.size())));
}

void judge_dynamic(const DynamicTessellation& dynamic, const std::map<Index, Site>& sites,
                   Metric metric) {
    std::vector<Site> list;
    for (const auto& [handle, site] : sites) {
        must(dynamic.contains(handle) && dynamic.site(handle) == site, "another site");
        list.push_back(site);
    }
    must(dynamic.size() == sites.size(), "another number of sites");
    must(dynamic.tessellation().arrays() == triangulate(list, metric).arrays(),
         "a tessellation that is not that of its sites");
}

/// As the kinetic structure at a time would be, had it been built there.
void judge_kinetic(const KineticTessellation& moving, const std::map<Index, MovingSite>& sites,
                   Fall fall) {
    std::vector<MovingSite> list;
    std::map<Index, Index> number_of;
    for (const auto& [handle, site] : sites) {
        must(moving.contains(handle) && moving.site(handle) == site, "another moving site");
        number_of[handle] = static_cast<Index>(list.size());
        list.push_back(site);
    }
    std::vector<Face> faces = moving.faces();
    for (Face& face : faces)
        for (Index& corner : face) corner = number_of.at(corner);
    must(faces == KineticTessellation(list, moving.time(), fall).faces(),
         "faces that depend on the way there");
    must(validate(moving.tessellation()).valid, "a moment that is no tessellation");
}

}  // namespace

void triangulate_target(Bytes bytes) {
    Choices choices = choices_of(bytes);
    const Metric metric = all_metrics[static_cast<std::size_t>(choices.below(4))];
    const auto seed = static_cast<std::uint64_t>(choices.byte());
    std::vector<Site> sites;
    while (choices.are_left()) sites.push_back(next_site(choices));
    const Tessellation result = triangulate(sites, metric, {.seed = seed});
    const Validation verdict = validate(result);
    must(verdict.valid && verdict.canonical, "a tessellation that is not the canonical one");
    for (const Method method : all_methods)
        if (builds(method, metric))
            must(triangulate(sites, metric, {.method = method}).arrays() == result.arrays(),
                 "two methods that differ");
    static_cast<void>(vertices(result));
}

void dynamic_target(Bytes bytes) {
    Choices choices = choices_of(bytes);
    const Metric metric = all_metrics[static_cast<std::size_t>(choices.below(4))];
    DynamicTessellation dynamic(metric);
    std::map<Index, Site> sites;
    for (int step = 0; choices.are_left(); ++step) {
        const int kind = sites.empty() ? 0 : choices.below(8);
        if (kind < 4) {
            const Site site = next_site(choices);
            must(sites.emplace(dynamic.insert(site), site).second, "a handle given twice");
        } else if (kind == 4) {
            const auto site = any_of(sites, choices);
            dynamic.erase(site->first);
            sites.erase(site);
        } else if (kind == 5) {
            const auto site = any_of(sites, choices);
            site->second.r = choices.radius();
            dynamic.change(site->first, site->second.r);
        } else if (kind == 6) {
            auto& [handle, site] = *any_of(sites, choices);
            site.x = choices.coordinate();
            site.y = choices.coordinate();
            dynamic.move(handle, {site.x, site.y});
        } else {
            std::vector<Point> centres;
            for (auto& [handle, site] : sites) {
                if (choices.below(4) == 0) site.x = choices.coordinate();
                centres.push_back({site.x, site.y});
            }
            dynamic.move_all(centres);
        }
        if (step % 8 == 7) judge_dynamic(dynamic, sites, metric);
    }
    judge_dynamic(dynamic, sites, metric);
}

void kinetic_target(Bytes bytes) {
    Choices choices = choices_of(bytes);
    const Fall fall = choices.below(2) == 0 ? Fall{} : Fall{0.0, -1.0};
    KineticTessellation moving(0.0, fall);
    std::map<Index, MovingSite> sites;
    const auto next_moving_site = [&] {
        MovingSite site;
        site.x = choices.coordinate();
        site.y = choices.coordinate();
        site.vx = choices.below(5) - 2;
        site.vy = choices.below(5) - 2;
        site.r = choices.radius();
        site.time = choices.below(3);
        return site;
    };
    constexpr std::size_t most_sites = 24;
    while (choices.are_left()) {
        const int kind = sites.empty() ? 0 : choices.below(8);
        if (kind < 3 && sites.size() < most_sites) {
            const MovingSite site = next_moving_site();
            must(sites.emplace(moving.insert(site), site).second, "a handle given twice");
        } else if (kind < 4) {
            const auto site = any_of(sites, choices);
            moving.erase(site->first);
            sites.erase(site);
        } else if (kind == 4) {
            auto& [handle, site] = *any_of(sites, choices);
            site = next_moving_site();
            moving.change(handle, site);
        } else if (kind == 5) {
            if (const auto next = moving.next_event()) moving.advance(*next);
        } else {
            moving.advance(moving.time() + choices.below(16) / 8.0);
            if (kind == 7) judge_kinetic(moving, sites, fall);
        }
    }
    judge_kinetic(moving, sites, fall);
}

void space_target(Bytes bytes) {
    Choices choices = choices_of(bytes);
    const auto seed = static_cast<std::uint64_t>(choices.byte());
    const bool are_equal = choices.below(2) == 0;
    std::vector<Site3> sites;
    while (choices.are_left()) {
        const double x = choices.coordinate();
        const double y = choices.coordinate();
        const double z = choices.coordinate();
        sites.push_back({x, y, z, are_equal ? 1.0 : choices.radius()});
    }
    const SpaceTessellation result = triangulate(sites, Power{}, {.seed = seed});
    const Validation verdict = validate(result, sites);
    must(verdict.valid && verdict.canonical,
         "a tessellation of space that is not the canonical one");
    must(triangulate(sites, Power{}, {.seed = seed + 1}) == result,
         "a result that depends on the seed");
    if (!are_equal) return;
    std::vector<Point3> points;
    for (const Site3& site : sites) points.push_back({site.x, site.y, site.z});
    must(triangulate(points).cells == result.cells, "points and equal balls that differ");
}

}  // namespace signum::fuzz
