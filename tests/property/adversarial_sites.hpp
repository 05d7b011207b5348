#pragma once
/// Families of sites that make a construction slow which is careless: giants among small sites,
/// chains of sites that hide one another, sites on few lines and curves. Ordinary input has them: a
/// city among villages, a planet and its moons, a molecule in its solvent.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <vector>

#include "../../core/site.hpp"
#include "../../tool/generate/uniform.hpp"

namespace signum::adversarial {

using Sites = std::vector<Site>;

inline constexpr double giant = 1e6;

/// Small sites around the rim of a disc.
inline void add_rim(Sites& sites, int count, double radius, Point centre = {0, 0}) {
    Uniform uniform(static_cast<std::uint64_t>(sites.size()));
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * uniform();
        sites.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle),
                         1 + uniform()});
    }
}

/// Small sites along the sides of a square.
inline void add_sides(Sites& sites, int count, double half) {
    Uniform uniform(1);
    for (int i = 0; i < count; ++i) {
        const double along = half * (2 * uniform() - 1);
        const double r = 1 + uniform();
        const double side = i % 2 == 0 ? half : -half;
        sites.push_back(i % 4 < 2 ? Site{along, side, r} : Site{side, along, r});
    }
}

/// The same, turned by 45 degrees.
inline void turn(Sites& sites) {
    for (Site& s : sites) s = {(s.x - s.y) / 2, (s.x + s.y) / 2, s.r};
}

struct Family {
    std::string_view name;
    Sites (*make)(int n);
};

inline constexpr Family families[] = {
    {"GiantDisc",
     [](int n) {
         Sites s;
         add_rim(s, n - 1, giant);
         s.push_back({0, 0, giant});
         return s;
     }},
    {"GiantSquare",
     [](int n) {
         Sites s;
         add_sides(s, n - 1, giant);
         s.push_back({0, 0, giant});
         return s;
     }},
    {"GiantDiamond",
     [](int n) {
         Sites s;
         add_sides(s, n - 1, giant);
         turn(s);
         s.push_back({0, 0, giant});
         return s;
     }},
    // The site in the middle comes last, or halfway, in the order of the tie rule.
    {"LeastInTheMiddle",
     [](int n) {
         Sites s;
         add_rim(s, n - 1, giant);
         s.push_back({0, 0, 0});
         return s;
     }},
    {"MedianInTheMiddle",
     [](int n) {
         Sites s;
         add_sides(s, n - 1, giant);
         s.push_back({0, 0, 1.5});
         return s;
     }},
    {"HalfHiddenInGiantDisc",
     [](int n) {
         Sites s;
         add_rim(s, n / 2, giant);
         Uniform uniform(7);
         for (int i = n / 2; i < n - 1; ++i) {
             const double angle = 2 * std::numbers::pi * uniform();
             const double t = (giant - 10) * std::sqrt(uniform());
             s.push_back({t * std::cos(angle), t * std::sin(angle), 1});
         }
         s.push_back({0, 0, giant});
         return s;
     }},
    {"HalfHiddenInGiantSquare",
     [](int n) {
         Sites s;
         add_sides(s, n / 2, giant);
         Uniform uniform(7);
         for (int i = n / 2; i < n - 1; ++i) {
             const double x = (giant - 10) * (2 * uniform() - 1);
             s.push_back({x, (giant - 10) * (2 * uniform() - 1), 1});
         }
         s.push_back({0, 0, giant});
         return s;
     }},
    {"RimsAroundOne",
     [](int n) {
         Sites s;
         for (int k = 0; k < 5; ++k) add_rim(s, n / 5, giant * (1 + 0.1 * k));
         s.push_back({0, 0, giant});
         return s;
     }},
    {"TwoGiants",
     [](int n) {
         Sites s;
         for (const double x : {-0.5 * giant, 0.5 * giant}) {
             add_rim(s, n / 2 - 1, giant, {x, 0});
             s.push_back({x, 0, giant});
         }
         return s;
     }},
    {"AllButFewHidden",
     [](int n) {
         Sites s;
         Uniform uniform(3);
         for (int i = 0; i < n; ++i) {
             const double x = giant * uniform();
             s.push_back({x, giant * uniform(), i < 10 ? giant : 1.0});
         }
         return s;
     }},
    {"PowerChain",
     [](int n) {
         Sites s;
         for (int i = 0; i < n; ++i) s.push_back({3.0 * i, 4.0 * i, 5.0 * i - (i % 97 ? 1e-3 : 0)});
         return s;
     }},
    {"Concentric",
     [](int n) {
         Sites s;
         for (int i = 0; i < n; ++i) s.push_back({1, 2, static_cast<double>(i)});
         return s;
     }},
    {"Eccentric",
     [](int n) {
         Sites s;
         for (int i = 0; i < n; ++i) s.push_back({1.0 * i, 0, 1.5 * i});
         return s;
     }},
    {"Identical",
     [](int n) {
         return Sites(static_cast<std::size_t>(n), {1, 2, 3});
     }},
    {"StarOfRays",
     [](int n) {
         Sites s = {{0, 0, 1}};
         for (int i = 1; i < n; ++i) {
             const double angle = 2 * std::numbers::pi * (i % 100) / 100;
             const double t = 1.0 + i / 100;
             s.push_back({t * std::cos(angle), t * std::sin(angle), 0});
         }
         return s;
     }},
    {"Parabola",
     [](int n) {
         Sites s;
         Uniform uniform(5);
         for (int i = 1; i < n; ++i) {
             const double t = i - 0.5 * n;
             s.push_back({t, t * t / n, uniform()});
         }
         s.push_back({0, 0.25 * n, 1});
         return s;
     }},
    {"Collinear",
     [](int n) {
         Sites s;
         Uniform uniform(5);
         for (int i = 0; i < n; ++i) s.push_back({1.0 * i, 2.0 * i, 3 * uniform()});
         return s;
     }},
    // A chain that a second giant, inserted later, cuts from both sides: an edge's middle survives
    // between any two.
    {"ChainOfMiddles",
     [](int n) {
         Sites s;
         for (int i = 1; i < n - 1; ++i) s.push_back({1.0 * i, 0, 0});
         s.push_back({-1e9, 0, 1e9 - 0.5});
         s.push_back({-4e9, 0, 1.5e9});
         return s;
     }},
};

}  // namespace signum::adversarial
