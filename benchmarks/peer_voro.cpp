#include "peer_voro.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <voro++.hh>

namespace signum::benchmarks {

SpaceCells cells_of_voro(const std::vector<Site3>& sites) {
    // The library's own advice: five particles or so in a block.
    const int blocks =
        std::max(1, static_cast<int>(std::cbrt(static_cast<double>(sites.size()) / 5.6)));
    voro::container_poly container(0, 1, 0, 1, 0, 1, blocks, blocks, blocks, false, false, false,
                                   8);
    for (std::size_t s = 0; s < sites.size(); ++s)
        container.put(static_cast<int>(s), sites[s].x, sites[s].y, sites[s].z, sites[s].r);
    SpaceCells result;
    result.box = {{0, 0, 0}, {1, 1, 1}};
    result.measures.resize(sites.size());
    std::vector<std::vector<SpaceFace>> faces(sites.size());
    std::vector<int> neighbours;
    std::vector<double> areas;
    voro::voronoicell_neighbor cell;
    voro::c_loop_all loop(container);
    if (loop.start()) do {
            if (!container.compute_cell(cell, loop)) continue;
            const auto s = static_cast<std::size_t>(loop.pid());
            SpaceMeasure& measure = result.measures[s];
            measure.volume = cell.volume();
            measure.area = cell.surface_area();
            Point3& at = measure.centroid;
            cell.centroid(at.x, at.y, at.z);
            at = {at.x + sites[s].x, at.y + sites[s].y, at.z + sites[s].z};
            cell.neighbors(neighbours);
            cell.face_areas(areas);
            for (std::size_t f = 0; f < areas.size(); ++f)
                faces[s].push_back({neighbours[f], areas[f]});
        } while (loop.inc());
    result.first_face.push_back(0);
    for (auto& each : faces) {
        std::ranges::sort(each, {}, [](const SpaceFace& face) {
            return std::pair(face.beyond < 0, std::abs(face.beyond));
        });
        result.faces.insert(result.faces.end(), each.begin(), each.end());
        result.first_face.push_back(static_cast<std::int64_t>(result.faces.size()));
    }
    return result;
}

}  // namespace signum::benchmarks
