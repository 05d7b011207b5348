/// The first lines that a user writes.

#include <cstdio>
#include <vector>

#include <signum/predicates/power.hpp>
#include <signum/triangulation/triangulate.hpp>

int main() {
    const std::vector<signum::Site> sites = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}, {0, 0, 0.5}};

    const signum::Sign s = signum::ccw({0, 0}, {1, 0}, {0, 1});
    const signum::Sign c = signum::power::in_circle(sites[0], sites[1], sites[2], {1, 1, 0});
    std::printf("ccw %d\nin_circle %d\n", s, c);

    const auto t = signum::triangulate(sites, signum::Power{});
    for (const auto& [a, b, c] : t.faces()) std::printf("face %d %d %d\n", a, b, c);
    for (const auto& [site, by] : t.hidden()) std::printf("hidden %d by %d\n", site, by);
}
