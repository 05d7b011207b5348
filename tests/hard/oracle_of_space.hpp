#pragma once
/// What the oracles say of sites in space.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../oracle/balls_space.hpp"
#include "../oracle/power_space.hpp"
#include "../oracle/rectangular_space.hpp"
#include "space_case.hpp"

namespace signum::hard {

class OracleOfSpace : public SpaceAnswers {
 public:
    explicit OracleOfSpace(const std::vector<Site3>& sites) {
        for (const Site3& site : sites) {
            weighted_.push_back({{site.x, site.y, site.z}, site.r});
            balls_.push_back(oracle::exact_ball(site));
        }
    }

    int turn(const Four& four) const override {
        std::array<std::array<Rational, 4>, 4> m;
        for (std::size_t row = 0; row < 4; ++row) {
            const auto& c = balls_[four[row]].c;
            m[row] = {c[0], c[1], c[2], 1};
        }
        // Of det[c, 1] the sign is the opposite of det[c_i - c_0].
        return -determinant(m);
    }
    int in_power_sphere(const Four& four, Number q, bool is_weight) const override {
        const auto weight = [&](Number site) {
            const Rational& r = balls_[site].r;
            return is_weight ? r : Rational(r * r);
        };
        std::array<std::array<Rational, 4>, 4> m;
        for (std::size_t row = 0; row < 4; ++row) {
            Rational square = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                m[row][k] = balls_[four[row]].c[k] - balls_[q].c[k];
                square += m[row][k] * m[row][k];
            }
            m[row][3] = square - weight(four[row]) + weight(q);
        }
        return -determinant(m);
    }
    bool exists(const Four& four) const override { return !positive(four).empty(); }
    int in_sphere(const Four& four, Number q) const override {
        return -oracle::side<3>(positive(four).at(0), balls_[q]);
    }
    std::pair<std::vector<int>, bool> in_spheres(const Four& four, Number q,
                                                 bool is_octahedron) const override {
        const auto metric = is_octahedron ? oracle::RectangularMetric::manhattan
                                          : oracle::RectangularMetric::supremum;
        const auto spheres = oracle::touching_spheres<3>(metric, tuple(four));
        std::vector<int> signs;
        for (const auto& sphere : spheres.spheres)
            signs.push_back(-oracle::side<3>(metric, sphere, balls_[q]));
        return {signs, spheres.infinitely_many};
    }
    bool hides(const std::string& metric, Number i, Number q) const override {
        if (metric == "euclidean") return oracle::contains<3>(balls_[i], balls_[q]);
        const std::array two = {balls_[i], balls_[q]};
        return oracle::hidden_sites<3>(metric == "manhattan" ? oracle::RectangularMetric::manhattan
                                                             : oracle::RectangularMetric::supremum,
                                       two)[1];
    }
    SpaceCells cells() const override {
        const auto found = oracle::power_space<3>(weighted_);
        SpaceCells result{found.dimension, {}, {}, found.hidden};
        const auto numbers = [](const auto& tuple) {
            std::vector<std::int32_t> sites;
            for (const std::int32_t site : tuple)
                if (site != oracle::no_site) sites.push_back(site);
            return sites;
        };
        for (const auto& cell : found.cells) result.cells.push_back(numbers(cell));
        for (const auto& facet : found.facets) result.hull.push_back(numbers(facet));
        return result;
    }
    std::vector<BallsOfVertex> vertices() const override {
        std::vector<BallsOfVertex> result;
        // The oracle turns the other way in space.
        for (const auto& vertex : oracle::ball_vertices<3>(balls_))
            result.push_back({vertex.balls, -vertex.sphere.orientation});
        return result;
    }

 private:
    using Rational = oracle::Rational;

    /// Its sign, by elimination.
    static int determinant(std::array<std::array<Rational, 4>, 4> m) {
        int sign = 1;
        for (std::size_t column = 0; column < 4; ++column) {
            std::size_t pivot = column;
            while (pivot < 4 && m[pivot][column].is_zero()) ++pivot;
            if (pivot == 4) return 0;
            if (pivot != column) sign = -sign;
            std::swap(m[pivot], m[column]);
            sign *= m[column][column].sign();
            for (std::size_t row = column + 1; row < 4; ++row) {
                const Rational factor = m[row][column] / m[column][column];
                for (std::size_t k = column; k < 4; ++k) m[row][k] -= factor * m[column][k];
            }
        }
        return sign;
    }
    oracle::BallTuple<3> tuple(const Four& four) const {
        return {balls_[four[0]], balls_[four[1]], balls_[four[2]], balls_[four[3]]};
    }
    /// The sphere whose points of contact turn positively, or none; the oracle turns the other way.
    std::vector<oracle::TouchingSphere<3>> positive(const Four& four) const {
        std::vector<oracle::TouchingSphere<3>> result;
        for (const auto& sphere : oracle::touching_spheres<3>(tuple(four)).spheres)
            if (sphere.orientation < 0) result.push_back(sphere);
        return result;
    }

    std::vector<oracle::SpaceSite<3>> weighted_;
    std::vector<oracle::SpaceBall<3>> balls_;
};

}  // namespace signum::hard
