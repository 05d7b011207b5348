#include "cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>

#include "../../triangulation/distributed/whole.hpp"
#include "../../triangulation/tessellation.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/space/cells.hpp"
#include "../../voronoi/space/polyhedra.hpp"
#include "../io/write_space_cells.hpp"
#include "../io/write_voronoi.hpp"
#include "shared_file.hpp"

namespace signum::mpi {
namespace {

using distributed::Kind;
using distributed::Known;
using distributed::Placed;

/// The corners of the smallest box around all centres.
std::array<Site3, 2> corners_of(Communicator& ranks, std::span<const Placed> own) {
    std::vector<Site3> all;
    const auto include = [](std::vector<Site3>& box, const Site3& site) {
        if (box.empty()) box.assign(2, {site.x, site.y, site.z, 0.0});
        for (double Site3::*const axis : {&Site3::x, &Site3::y, &Site3::z}) {
            box[0].*axis = std::min(box[0].*axis, site.*axis);
            box[1].*axis = std::max(box[1].*axis, site.*axis);
        }
    };
    for (const Placed& each : own) include(all, each.site);
    std::vector<Site3> whole;
    for (const Site3& corner : ranks.all_of<Site3>(all)) include(whole, corner);
    return {whole[0], whole[1]};
}

std::vector<Site> planar(std::span<const Site3> sites) {
    std::vector<Site> result;
    for (const auto& [x, y, z, r] : sites) result.push_back({x, y, r});
    return result;
}

/// Calls work(sites) with those of space as they are meant.
template <class Work>
auto with_sites(const Known& known, WeightIs weight_is, const Work& work) {
    if (weight_is == WeightIs::radius) return work(std::span<const Site3>(known.sites));
    std::vector<power::Site3> weighted;
    for (const auto& [x, y, z, w] : known.sites) weighted.push_back({x, y, z, w});
    return work(std::span<const power::Site3>(weighted));
}

/// A row, by the number that it begins with.
struct Row {
    std::int64_t site;
    std::int64_t length;
};
template <class Take>
void each_row(std::string_view rows, const Take& take) {
    while (!rows.empty()) {
        const std::string_view row = rows.substr(0, rows.find('\n') + 1);
        std::int64_t site = 0;
        std::from_chars(row.data(), row.data() + row.size(), site);
        take(site, row);
        rows.remove_prefix(row.size());
    }
}

std::string name_of_piece(const std::string& name, std::size_t rank) {
    return fmt::format("{}_{}.vtu", std::filesystem::path(name).replace_extension().string(), rank);
}

}  // namespace

VtkGrid grid_of_faces(const Known& known, const Kind& kind) {
    VtkGrid grid;
    grid.title = fmt::format("signum: {} tessellation", name_of(kind.metric));
    grid.of_points = {
        {"site",
         known.ids.empty() || known.ids.back() <= std::numeric_limits<std::int32_t>::max(),
         {}},
        {std::string(name_of(kind.weight_is)), false, {}}};
    std::vector<std::int64_t> point(known.ids.size(), -1);
    const auto add = [&](VtkCell shape, const auto& cell) {
        // The least comes first.
        if (cell[0] < 0 || known.are_own[static_cast<std::size_t>(cell[0])] == 0) return;
        std::array<std::int64_t, std::tuple_size_v<std::decay_t<decltype(cell)>>> corners;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto site = static_cast<std::size_t>(cell[k]);
            if (point[site] < 0) {
                point[site] = static_cast<std::int64_t>(grid.points.size());
                const auto& [x, y, z, r] = known.sites[site];
                grid.points.push_back({x, y, z});
                grid.of_points[0].values.push_back(static_cast<double>(known.ids[site]));
                grid.of_points[1].values.push_back(r);
            }
            corners[k] = point[site];
        }
        grid.add_cell(shape, corners);
    };
    for (const Face& face : known.plane.faces) add(VtkCell::triangle, face);
    for (const SpaceCell& cell : known.space.cells) add(VtkCell::tetrahedron, cell);
    return grid;
}

RankCells::RankCells(Communicator& ranks, const RankTessellation& tessellation, const Kind& kind,
                     bool wants_table, bool wants_grid)
    : sites_(tessellation.whole) {
    const std::array<Site3, 2> corners = corners_of(ranks, tessellation.sites);
    ranks.together([&] {
        if (tessellation.sites.empty()) return;
        Known known = tessellation.part->known();
        const SiteNames names = {known.ids, known.are_own};
        std::ostringstream out;
        if (kind.dimension == 3) {
            const Box3 box = default_box(std::span<const Site3>(corners));
            with_sites(known, kind.weight_is, [&](auto sites) {
                const SpaceCells cells = space_cells(known.space, sites, box, 1);
                if (wants_table) write_space_cells_csv(out, cells, names);
                if (!wants_grid) return;
                std::vector<Index> own;
                for (std::size_t i = 0; i < known.ids.size(); ++i)
                    if (known.are_own[i] != 0) own.push_back(static_cast<Index>(i));
                grid_ = vtk_grid(cells, space_polyhedra(known.space, sites, box, own), names);
            });
        } else {
            const Voronoi diagram(
                triangulation::constructed(std::move(known.plane), planar(known.sites), {}),
                {.threads = 1});
            const Box box = default_box(planar(corners), diagram.exponent());
            if (!fits(box, diagram))
                throw std::invalid_argument("doubles cannot compute with a box around all sites");
            const ClippedVoronoi cells(diagram, box, Lengths::of_the_plane, 1);
            const double tolerance = default_tolerance(box);
            if (wants_table) write_voronoi_csv(out, cells, tolerance, {}, names);
            if (wants_grid) grid_ = vtk_grid(cells, tolerance, names);
        }
        if (sites_ > std::numeric_limits<std::int32_t>::max())
            for (VtkColumn& column : grid_.of_cells) column.is_whole = false;
        table_ = std::move(out).str();
    });
}

void RankCells::write_table(Communicator& ranks, const std::string& name) const {
    complete(ranks, name, [&] {
        // Rows go to ranks by their sites, and are written one after the other.
        const std::size_t head = std::min(table_.find('\n') + 1, table_.size());
        const distributed::Stretches stretches(sites_, ranks.size());
        std::vector<std::vector<Row>> rows(ranks.size());
        std::vector<std::vector<char>> texts(ranks.size());
        each_row(std::string_view(table_).substr(head),
                 [&](std::int64_t site, std::string_view row) {
                     const std::size_t to = stretches.of(site);
                     rows[to].push_back({site, static_cast<std::int64_t>(row.size())});
                     texts[to].insert(texts[to].end(), row.begin(), row.end());
                 });
        rows = ranks.exchanged(rows);
        texts = ranks.exchanged(texts);
        std::vector<std::pair<std::int64_t, std::string_view>> order;
        for (std::size_t r = 0; r < ranks.size(); ++r) {
            const char* at = texts[r].data();
            for (const auto& [site, length] : rows[r]) {
                order.push_back({site, {at, static_cast<std::size_t>(length)}});
                at += length;
            }
        }
        std::ranges::sort(order);
        std::string text;
        for (const auto& [site, row] : order) text += row;

        // Some rank has a head.
        const std::int64_t longest = ranks.most(static_cast<std::int64_t>(head));
        const std::int64_t writer =
            ranks.most(head > 0 ? static_cast<std::int64_t>(ranks.rank()) : std::int64_t{-1});
        const std::int64_t place =
            longest + ranks.sum_before(static_cast<std::int64_t>(text.size()));
        SharedFile file(ranks, name);
        ranks.together([&] {
            if (writer == static_cast<std::int64_t>(ranks.rank()))
                file.write(0, table_.data(), head);
            file.write(static_cast<std::uint64_t>(place), text.data(), text.size());
            file.finish();
        });
    });
}

void write_pieces(Communicator& ranks, const std::string& name, const VtkGrid& own) {
    // Ranks without a site know no columns, and have no piece.
    const std::int64_t has_own = own.of_cells.empty() && own.of_points.empty() ? 0 : 1;
    const std::vector<std::int64_t> have = ranks.all_of<std::int64_t>(std::array{has_own});
    const std::string piece = name_of_piece(name, ranks.rank());
    const auto put = [&](const std::string& to, const auto& write) {
        errno = 0;
        std::ofstream out(unfinished(to));
        write(out);
        out.flush();
        if (!out) fail(to, errno != 0 ? errno : EIO);
    };
    std::vector<std::string> pieces;
    std::size_t first = ranks.size();
    for (std::size_t r = 0; r < ranks.size(); ++r)
        if (have[r] != 0) {
            pieces.push_back(std::filesystem::path(name_of_piece(name, r)).filename().string());
            first = std::min(first, r);
        }
    try {
        ranks.together([&] {
            if (has_own != 0) put(piece, [&](std::ostream& out) { write_vtu(out, own); });
            if (ranks.rank() == first)
                put(name, [&](std::ostream& out) { write_pvtu(out, own, pieces); });
        });
        ranks.together([&] {
            if (has_own != 0 && std::rename(unfinished(piece).c_str(), piece.c_str()) != 0)
                fail(piece, errno);
        });
    } catch (...) {
        ::unlink(unfinished(piece).c_str());
        ::unlink(piece.c_str());
        throw;
    }
}

}  // namespace signum::mpi
