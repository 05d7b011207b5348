#pragma once
/// A tessellation from parts that are settled one after the other, in memory, and put together.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "../../triangulation/arrays.hpp"
#include "../../triangulation/distributed/common.hpp"
#include "../../triangulation/distributed/cuts.hpp"
#include "../../triangulation/distributed/part.hpp"
#include "../../triangulation/distributed/shared_exchange.hpp"
#include "../../triangulation/distributed/site_store.hpp"
#include "../../triangulation/distributed/whole.hpp"
#include "../../triangulation/space/triangulate.hpp"

namespace signum::distributed {

/// What the whole is put together from (Part), in no order, each face or cell once.
struct WholeParts {
    std::vector<WholeFace> faces;
    std::vector<WholeCell<4>> cells;
    std::vector<Adjacency> adjacencies;
    std::vector<WholeHidden> hidden;
    Part::Told told;
};

/// In so many parts. Throws NoStructure, as triangulate() would have none that parts share.
inline WholeParts settle_in_parts(std::span<const Placed> sites, const Kind& kind,
                                  std::size_t parts) {
    std::vector<Point3> sample;
    for (const Placed& each : sites) sample.push_back(place_of(each));
    const Cuts cuts(std::move(sample), parts);
    std::vector<std::vector<Placed>> own(parts);
    for (const Placed& each : sites) own[cuts.part_of(place_of(each))].push_back(each);

    std::vector<SiteStore> stores;
    Extent extent = no_extent();
    for (auto& of_part : own) {
        order_along_curve(of_part, kind);
        stores.emplace_back(of_part, kind);
        extent.include(stores.back().extent());
    }
    Farthest farthest(kind, extent);
    for (const auto& of_part : own) farthest.include(of_part);
    std::vector<Placed> candidates;
    for (const SiteStore& store : stores) {
        const std::vector<Placed> more = endless_among(store, farthest);
        candidates.insert(candidates.end(), more.begin(), more.end());
    }
    const std::vector<Placed> common = common_of(std::move(candidates), sites, kind);

    std::vector<PartBounds> bounds;
    for (const SiteStore& store : stores)
        bounds.push_back({store.extent_but(common), store.spacing()});
    WholeParts whole;
    for (std::size_t number = 0; number < parts; ++number) {
        std::vector<Placed> others;
        std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
            return cuts.part_of(place_of(each)) != number;
        });
        SharedExchange exchange(stores);
        const std::unique_ptr<Part> part = make_part(kind);
        part->settle(stores[number], others, bounds, number, exchange, {});
        part->each_face([&](std::span<const std::int64_t> of_face) {
            if (kind.dimension == 3)
                std::ranges::copy(of_face, whole.cells.emplace_back().begin());
            else
                std::ranges::copy(of_face, whole.faces.emplace_back().begin());
        });
        part->each_adjacency([&](const Adjacency& each) { whole.adjacencies.push_back(each); });
        for (const WholeHidden& each : part->hidden()) whole.hidden.push_back(each);
        const Part::Told told = part->told();
        whole.told.sites += told.sites;
        whole.told.rounds = std::max(whole.told.rounds, told.rounds);
        whole.told.faces += told.faces;
        whole.told.edges += told.edges;
    }
    return whole;
}

/// The arrays of sites that are numbered from 0.
inline TessellationArrays arrays_of(const WholeParts& whole, std::int64_t sites, Metric metric,
                                    WeightIs weight_is) {
    SortedCells<3> sorted(whole.faces, -1, sites);
    const std::vector<WholeFace>& faces = sorted.cells();
    std::vector<Half<3>> halves;
    std::int64_t number = 0;
    for (const WholeFace& face : faces) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            halves.push_back(half_of(face, number, corner));
        ++number;
    }

    TessellationArrays arrays;
    arrays.metric = metric;
    arrays.weight_is = weight_is;
    arrays.sites = sites;
    for (const WholeFace& face : faces)
        arrays.faces.push_back({static_cast<Index>(face[0]), static_cast<Index>(face[1]),
                                static_cast<Index>(face[2])});
    arrays.neighbours.assign(faces.size(), {-1, -1, -1});
    for (const auto& [place, neighbour] : joined<3>(halves, 0, sites))
        arrays
            .neighbours[static_cast<std::size_t>(place / 4)][static_cast<std::size_t>(place % 4)] =
            static_cast<Index>(neighbour);
    for (const auto& [face, corner, neighbour] : whole.adjacencies)
        arrays.neighbours[sorted.place_of(face)][static_cast<std::size_t>(corner)] =
            static_cast<Index>(sorted.place_of(neighbour));
    for (const auto& [site, by] : whole.hidden)
        arrays.hidden.push_back({static_cast<Index>(site), static_cast<Index>(by)});
    std::ranges::sort(arrays.hidden, {}, &Hidden::site);
    return arrays;
}

/// The same of space.
inline SpaceTessellation space_of(const WholeParts& whole, std::int64_t sites) {
    SpaceTessellation space = space_of(SortedCells<4>(whole.cells, -1, sites), sites);
    for (const auto& [site, by] : whole.hidden)
        space.hidden.push_back({static_cast<Index>(site), static_cast<Index>(by)});
    std::ranges::sort(space.hidden, {}, &Hidden::site);
    return space;
}

}  // namespace signum::distributed
