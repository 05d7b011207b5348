#pragma once
/// What the oracles say of sites in the plane.

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../oracle/balls_space.hpp"
#include "../oracle/euclidean.hpp"
#include "../oracle/power.hpp"
#include "../oracle/rectangular.hpp"
#include "../oracle/rectangular_space.hpp"
#include "plane_case.hpp"

namespace signum::hard {

using oracle::exactly;
using oracle::Rational;

inline int exact_turn(const Site& a, const Site& b, const Site& c) {
    const Rational x = exactly(a.x);
    const Rational y = exactly(a.y);
    return Rational((exactly(b.x) - x) * (exactly(c.y) - y) -
                    (exactly(b.y) - y) * (exactly(c.x) - x))
        .sign();
}

inline oracle::Tessellation tessellation_of(const std::string& metric,
                                            const std::vector<Site>& sites) {
    if (metric == "power") return oracle::power(sites);
    if (metric == "euclidean") return oracle::euclidean(sites);
    if (metric == "manhattan") return oracle::manhattan(sites);
    if (metric == "supremum") return oracle::supremum(sites);
    std::vector<power::Site> weighted;
    for (const Site& site : sites) weighted.push_back({site.x, site.y, site.r});
    return oracle::power_weights(weighted);
}

/// The determinant of the sites relative to q, each lifted to |x|² less its weight.
inline int in_power_circle(const std::array<Site, 3>& circle, const Site& q, bool is_weight) {
    const auto weight = [&](const Site& site) {
        return is_weight ? exactly(site.r) : Rational(exactly(site.r) * exactly(site.r));
    };
    std::array<std::array<Rational, 3>, 3> m;
    for (std::size_t i = 0; i < 3; ++i) {
        const Rational x = exactly(circle[i].x) - exactly(q.x);
        const Rational y = exactly(circle[i].y) - exactly(q.y);
        m[i] = {x, y, x * x + y * y - weight(circle[i]) + weight(q)};
    }
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& [a, b] = std::pair(m[(i + 1) % 3], m[(i + 2) % 3]);
        sum += m[i][2] * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum.sign();
}

/// Under the tie rule every answer is that of the tessellation of the few sites that are named.
class OracleOfPlane : public PlaneAnswers {
 public:
    OracleOfPlane(std::string metric, const std::vector<Site>& sites)
        : metric_(std::move(metric)), sites_(sites) {}

    bool hides(Number i, Number q) const override {
        for (const auto& [site, by] : of({i, q}).hidden)
            if (site == 1) return true;
        return false;
    }
    bool exists(Number i, Number j, Number k) const override {
        return has_face(of({i, j, k}), {0, 1, 2});
    }
    std::string in_circle(Number i, Number j, Number k, Number q) const override {
        const std::array circle = {sites_[i], sites_[j], sites_[k]};
        if (metric_ == "power" || metric_ == "weights")
            return letter(in_power_circle(circle, sites_[q], metric_ == "weights"));
        const oracle::BallTuple<2> balls = {oracle::exact_ball(circle[0]),
                                            oracle::exact_ball(circle[1]),
                                            oracle::exact_ball(circle[2])};
        const auto ball = oracle::exact_ball(sites_[q]);
        if (metric_ == "euclidean") {
            for (const auto& sphere : oracle::touching_spheres<2>(balls).spheres)
                if (sphere.orientation > 0) return letter(-oracle::side<2>(sphere, ball));
            return open;
        }
        const auto metric = metric_ == "manhattan" ? oracle::RectangularMetric::manhattan
                                                   : oracle::RectangularMetric::supremum;
        // Where there is one alone it is the one that the tie rule comes near to.
        const auto spheres = oracle::touching_spheres<2>(metric, balls);
        if (spheres.infinitely_many || spheres.spheres.size() != 1) return open;
        return letter(-oracle::side<2>(metric, spheres.spheres[0], ball));
    }
    bool conflicts(Number i, Number j, Number k, Number q) const override {
        return !has_face(of({i, j, k, q}), {0, 1, 2});
    }
    bool conflicts_at_infinity(Number a, Number b, Number q) const override {
        return !has_face(of({a, b, q}), {-1, 1, 0});
    }
    std::vector<std::array<std::int32_t, 3>> faces() const override { return whole().faces; }
    std::vector<std::array<std::int32_t, 2>> hidden() const override { return whole().hidden; }

 private:
    oracle::Tessellation of(std::initializer_list<Number> numbers) const {
        std::vector<Site> sites;
        for (const Number number : numbers) sites.push_back(sites_[number]);
        return tessellation_of(metric_, sites);
    }
    static bool has_face(const oracle::Tessellation& t, const std::array<std::int32_t, 3>& face) {
        return std::find(t.faces.begin(), t.faces.end(), face) != t.faces.end();
    }
    const oracle::Tessellation& whole() const {
        if (!whole_) whole_ = tessellation_of(metric_, sites_);
        return *whole_;
    }

    std::string metric_;
    const std::vector<Site>& sites_;
    mutable std::optional<oracle::Tessellation> whole_;
};

}  // namespace signum::hard
