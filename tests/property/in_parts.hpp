#pragma once
/// A tessellation from parts that are settled one after the other, in memory, and put together.

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "../../triangulation/arrays.hpp"
#include "../../triangulation/distributed/common.hpp"
#include "../../triangulation/distributed/cuts.hpp"
#include "../../triangulation/distributed/exchange.hpp"
#include "../../triangulation/distributed/part.hpp"
#include "../../triangulation/distributed/site_store.hpp"
#include "../../triangulation/distributed/whole.hpp"
#include "../../triangulation/space/triangulate.hpp"

namespace signum::distributed {

/// A part's questions, and the processor time that the answers of each part take, in all.
class ChargedExchange final : public Exchange {
 public:
    ChargedExchange(std::span<const SiteStore> stores, std::span<double> seconds)
        : stores_(stores), seconds_(seconds) {}
    [[nodiscard]] std::vector<Answers> ask(std::vector<Questions> questions) override {
        std::vector<Answers> answers(questions.size());
        for (std::size_t q = 0; q < questions.size(); ++q) {
            const std::clock_t start = std::clock();
            if (!questions[q].are_none()) answers[q] = stores_[q].answer(questions[q]);
            seconds_[q] += seconds_since(start);
        }
        return answers;
    }
    [[nodiscard]] bool is_for_any(bool own) override { return own; }
    static double seconds_since(std::clock_t start) {
        return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    }

 private:
    std::span<const SiteStore> stores_;
    std::span<double> seconds_;
};

/// What the whole is put together from (Part), in no order, each face or cell once.
struct WholeParts {
    std::vector<WholeFace> faces;
    std::vector<WholeCell<4>> cells;
    std::vector<Adjacency> adjacencies;
    std::vector<WholeHidden> hidden;
    Part::Told told;
    std::vector<double> seconds;  ///< of each part, its answers to others included
};

/// In so many parts. Throws NoStructure, as triangulate() would have none that parts share.
inline WholeParts settle_in_parts(std::span<const Placed> sites, const Kind& kind,
                                  std::size_t parts) {
    std::vector<Point3> sample;
    for (const Placed& each : sites) sample.push_back(place_of(each));
    const Cuts cuts(std::move(sample), parts);
    std::vector<std::vector<Placed>> own(parts);
    for (const Placed& each : sites) own[cuts.part_of(place_of(each))].push_back(each);

    WholeParts whole;
    whole.seconds.assign(parts, 0.0);
    std::vector<SiteStore> stores;
    Extent extent = no_extent();
    for (std::size_t number = 0; number < parts; ++number) {
        const std::clock_t start = std::clock();
        order_along_curve(own[number], kind);
        stores.emplace_back(own[number], kind);
        extent.include(stores.back().extent());
        whole.seconds[number] += ChargedExchange::seconds_since(start);
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
    for (std::size_t number = 0; number < parts; ++number) {
        std::vector<Placed> others;
        std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
            return cuts.part_of(place_of(each)) != number;
        });
        std::vector<double> answering(parts);
        ChargedExchange exchange(stores, answering);
        const std::unique_ptr<Part> part = make_part(kind);
        const std::clock_t start = std::clock();
        part->settle(stores[number], others, bounds, number, exchange, {});
        whole.seconds[number] += ChargedExchange::seconds_since(start);
        for (std::size_t other = 0; other < parts; ++other) {
            whole.seconds[other] += answering[other];
            whole.seconds[number] -= answering[other];
        }
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
