#pragma once
/// What the library says of sites in space.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../predicates/space.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../voronoi/balls/diagram.hpp"
#include "../property/environments.hpp"
#include "library_of_plane.hpp"
#include "space_case.hpp"

namespace signum::hard {

class LibraryOfSpace : public SpaceAnswers {
    static bool euclidean_exists(const Site3& i, const Site3& j, const Site3& k, const Site3& l) {
        return euclidean::exists(i, j, k, l);
    }
    template <class Sites, class Function>
    static auto with(const Sites& sites, const Four& four, const Function& function) {
        return function(sites[four[0]], sites[four[1]], sites[four[2]], sites[four[3]]);
    }
    template <class Question>
    auto ask(const Question& question) const {
        return within(way_.environment, question);
    }

 public:
    LibraryOfSpace(std::vector<Site3> sites, const Way& way) : sites_(std::move(sites)), way_(way) {
        for (const Site3& s : sites_) weighted_.push_back({s.x, s.y, s.z, s.r});
    }

    int turn(const Four& four) const override {
        return ask([&]() -> int { return with(sites_, four, ccw<Site3>); });
    }
    int in_power_sphere(const Four& four, Number q, bool is_weight) const override {
        const auto question = [&](const auto& sites) -> int {
            return with(sites, four, [&](const auto&... s) {
                return power::in_sphere_decision(s..., sites[q]).sign;
            });
        };
        return ask([&] { return is_weight ? question(weighted_) : question(sites_); });
    }
    bool exists(const Four& four) const override {
        return ask([&] { return with(sites_, four, euclidean_exists); });
    }
    int in_sphere(const Four& four, Number q) const override {
        return ask([&]() -> int {
            return with(sites_, four,
                        [&](const auto&... s) { return euclidean::in_sphere(s..., sites_[q]); });
        });
    }
    std::pair<std::vector<int>, bool> in_spheres(const Four& four, Number q,
                                                 bool is_octahedron) const override {
        const auto question = [&](const auto& spheres, const auto& in_sphere) {
            return with(sites_, four, [&](const auto&... s) {
                const rectangular::Spheres all = spheres(s...);
                std::pair<std::vector<int>, bool> result{{}, all.infinitely_many};
                if (all.infinitely_many) return result;
                for (std::uint8_t n = 0; n < all.count; ++n)
                    result.first.push_back(in_sphere(s..., sites_[q], n));
                return result;
            });
        };
        return ask([&] {
            return is_octahedron ? question(manhattan::spheres, manhattan::in_sphere)
                                 : question(supremum::spheres, supremum::in_sphere);
        });
    }
    bool hides(const std::string& metric, Number i, Number q) const override {
        return ask([&] {
            if (metric == "euclidean") return euclidean::hidden(sites_[q], sites_[i]);
            return metric == "manhattan" ? manhattan::hidden(sites_[q], sites_[i])
                                         : supremum::hidden(sites_[q], sites_[i]);
        });
    }
    SpaceCells cells() const override {
        Options options;
        options.seed = way_.options.seed;
        const SpaceTessellation found = ask([&] {
            return triangulate(std::span<const power::Site3>(weighted_), Power{}, options);
        });
        SpaceCells result{found.dimension, {}, {}, {}};
        for (const SpaceCell& cell : found.cells) {
            std::vector<std::int32_t> numbers(cell.begin(), cell.begin() + found.dimension + 1);
            std::ranges::sort(numbers);
            if (numbers[0] >= 0)
                result.cells.push_back(numbers);
            else if (found.dimension > 0)
                result.hull.emplace_back(numbers.begin() + 1, numbers.end());
        }
        std::ranges::sort(result.cells);
        std::ranges::sort(result.hull);
        for (const Hidden& h : found.hidden) result.hidden.push_back({h.site, h.by});
        return result;
    }
    std::vector<BallsOfVertex> vertices() const override {
        const BallDiagram diagram = ask([&] { return ball_diagram(sites_); });
        std::vector<BallsOfVertex> result;
        for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
            const auto balls = diagram.vertices[v];
            result.push_back({{balls.begin(), balls.end()}, diagram.turns[v]});
        }
        return result;
    }

 private:
    std::vector<Site3> sites_;
    std::vector<power::Site3> weighted_;
    Way way_;
};

}  // namespace signum::hard
