// A triangulation of CGAL's on signum's predicates, and from CGAL to signum and back.

#include <signum/interop/cgal.hpp>

#include <cstdio>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>

#include <signum/triangulation/triangulate.hpp>

using Traits = signum::cgal::Traits<>;
using Delaunay = CGAL::Delaunay_triangulation_2<Traits>;

int main() {
    // Nine points of a grid, all of whose squares are tied.
    std::vector<signum::Point> sites;
    std::vector<Delaunay::Point> points;
    for (int i = 0; i < 9; ++i) {
        sites.push_back({0.1 * (i % 3), 0.1 * (i / 3)});
        points.emplace_back(sites.back().x, sites.back().y);
    }
    const Delaunay cgals(points.begin(), points.end());
    const signum::TessellationArrays arrays = signum::cgal::arrays(cgals, sites);
    const signum::Tessellation ours = signum::triangulate(sites, signum::Power{});
    std::printf("%d faces, signum's: %s\n", static_cast<int>(arrays.faces.size()),
                arrays == ours.arrays() ? "yes" : "no");

    Delaunay back;
    const auto vertices = signum::cgal::assign(back, ours.arrays(), sites);
    std::printf("valid: %d, neighbours of the middle: %d\n", back.is_valid(),
                static_cast<int>(back.degree(vertices[4])));
}
