#include "own_points.hpp"

#include <algorithm>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum::torture {
namespace {

template <class Faces>
void put_beside(const Faces& faces, const Faces& neighbours, OwnPoints& own) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& face = faces[f];
        for (const Index beyond : neighbours[f]) {
            if (beyond < static_cast<Index>(f)) continue;
            const auto& other = faces[static_cast<std::size_t>(beyond)];
            const auto apex = std::ranges::find_if(
                other, [&](Index site) { return std::ranges::find(face, site) == face.end(); });
            if (apex == other.end() || *apex < 0 || std::ranges::min(face) < 0) continue;
            auto& five = own.beside.emplace_back();
            *std::ranges::copy(face, five.begin()).out = *apex;
        }
    }
}

}  // namespace

OwnPoints own_points(std::span<const Site> sites) {
    OwnPoints own{2, {}, {}};
    std::vector<Site> points;
    for (const auto& [x, y, r] : sites) {
        points.push_back({x, y, 0.0});
        own.points.push_back({x, y, 0.0});
    }
    const Tessellation made = triangulate(points, Metric::power);
    put_beside(made.faces(), made.neighbours(), own);
    return own;
}

OwnPoints own_points(std::span<const Site3> sites) {
    OwnPoints own{3, {}, {}};
    std::vector<Point3> points;
    for (const auto& [x, y, z, r] : sites) {
        points.push_back({x, y, z});
        own.points.push_back({x, y, z});
    }
    const SpaceTessellation made = triangulate(points);
    if (made.dimension == 3) put_beside(made.cells, made.neighbours, own);
    return own;
}

}  // namespace signum::torture
