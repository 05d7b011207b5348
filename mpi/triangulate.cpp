#include "triangulate.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "../triangulation/distributed/common.hpp"
#include "../triangulation/distributed/site_store.hpp"
#include "../triangulation/distributed/whole.hpp"
#include "by_number.hpp"
#include "owned_sites.hpp"

namespace signum::mpi {
namespace {

using namespace distributed;

std::vector<Placed> common_sites(Communicator& ranks, const SiteStore& store,
                                 std::span<const Placed> sample, const Kind& kind) {
    Extent whole = no_extent();
    const std::vector<Extent> extents = ranks.all_of<Extent>(std::array{store.extent()});
    for (const Extent& each : extents)
        if (!is_empty(each)) whole.include(each);
    std::vector<Placed> own;
    ranks.together([&] {
        Farthest farthest(kind, whole);
        farthest.include(sample);
        own = endless_among(store, farthest);
    });
    std::vector<Placed> candidates = ranks.all_of<Placed>(own);
    ranks.together([&] { own = greatest_of(store.sites(), kind); });
    const std::vector<Placed> greatest = ranks.all_of<Placed>(own);
    std::vector<Placed> common;
    ranks.together([&] { common = common_of(std::move(candidates), greatest, kind); });
    return common;
}

double processor_seconds() noexcept {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// What begins with a site, evenly over the ranks, by a sample of the cells.
template <std::size_t corners>
Stretches stretches_of(Communicator& ranks, std::span<const WholeCell<corners>> cells,
                       std::int64_t sites) {
    constexpr std::size_t wanted = 256;
    std::vector<std::int64_t> sample;
    for (std::size_t k = 0; k < wanted && !cells.empty(); ++k)
        sample.push_back(cells[mix(k) % cells.size()][0]);
    return {sites, ranks.all_of<std::int64_t>(sample), ranks.size()};
}

template <std::size_t corners>
Stretch stretch_of(RankTessellation& tessellation, Communicator& ranks) {
    Stretch stretch;
    stretch.corners = corners;
    std::vector<WholeCell<corners>> cells;
    std::vector<Adjacency> adjacencies;
    ranks.together([&] {
        tessellation.part->each_face([&](std::span<const std::int64_t> sites) {
            std::ranges::copy(sites, cells.emplace_back().begin());
        });
        tessellation.part->each_adjacency(
            [&](const Adjacency& each) { adjacencies.push_back(each); });
        stretch.hidden = tessellation.part->hidden();
        tessellation.part.reset();
    });
    // Faces, edges and hidden sites go to ranks by their first sites.
    const Stretches stretches = stretches_of<corners>(ranks, cells, tessellation.whole);
    const std::int64_t first = stretches.begin(ranks.rank());
    const std::int64_t last = stretches.begin(ranks.rank() + 1);
    SortedCells<corners> sorted(
        ranks.dealt(cells, [&](const WholeCell<corners>& cell) { return stretches.of(cell[0]); }),
        stretches.begin_of_faces(ranks.rank()), last);
    const ByNumber numbered_cells(ranks, sorted.cells().size());
    stretch.first_face = numbered_cells.first(ranks.rank());
    stretch.faces_of_all = numbered_cells.all();
    stretch.hidden = ranks.dealt(
        stretch.hidden, [&](const WholeHidden& hidden) { return stretches.of(hidden.site); });
    std::ranges::sort(stretch.hidden, {}, &WholeHidden::site);
    stretch.first_hidden = ranks.sum_before(static_cast<std::int64_t>(stretch.hidden.size()));
    stretch.hidden_of_all = ranks.sum(static_cast<std::int64_t>(stretch.hidden.size()));

    stretch.neighbours.assign(corners * sorted.cells().size(), -1);
    std::size_t known = 0;
    const auto tell = [&](std::int64_t place, std::int64_t neighbour) {
        const auto cell = static_cast<std::size_t>(place / 4 - stretch.first_face);
        stretch.neighbours[corners * cell + static_cast<std::size_t>(place % 4)] = neighbour;
        ++known;
    };
    std::vector<Half<corners>> waiting;
    // Cells that begin with the same site come one after the other. What two of them share, in
    // space, is no other's.
    if constexpr (corners == 4) {
        std::vector<Half<corners>> halves;
        for (std::size_t c = 0, end; c < sorted.cells().size(); c = end) {
            const std::int64_t site = sorted.cells()[c][0];
            halves.clear();
            for (end = c; end < sorted.cells().size() && sorted.cells()[end][0] == site; ++end)
                for (std::size_t corner = site < 0 ? corners : 1; corner < corners; ++corner)
                    halves.push_back(half_of(sorted.cells()[end],
                                             stretch.first_face + static_cast<std::int64_t>(end),
                                             corner));
            std::ranges::sort(halves, {}, &Half<corners>::others);
            for (std::size_t k = 0; k < halves.size(); ++k) {
                if (k + 1 == halves.size() || halves[k].others != halves[k + 1].others) {
                    waiting.push_back(halves[k]);
                    continue;
                }
                tell(halves[k].place, halves[k + 1].place / 4);
                tell(halves[k + 1].place, halves[k].place / 4);
                ++k;
            }
        }
    }
    // Other halves of edges or facets meet where their lesser sites are, and are told to their
    // cells: some of them at a time, for they take more memory than the cells.
    constexpr std::size_t at_a_time = std::size_t{1} << 22;
    const auto is_waiting = [](const WholeCell<corners>& cell, std::size_t corner) {
        return corners == 4 && cell[0] >= 0 && corner > 0;
    };
    const std::int64_t times =
        ranks.most(static_cast<std::int64_t>(corners * sorted.cells().size() / at_a_time + 1));
    std::vector<Half<corners>> halves;
    for (std::int64_t time = 0; time < times; ++time) {
        const auto is_due = [&](const Half<corners>& half) { return half.lesser % times == time; };
        std::int64_t number = stretch.first_face;
        for (const WholeCell<corners>& cell : sorted.cells()) {
            for (std::size_t corner = 0; corner < corners; ++corner) {
                if (is_waiting(cell, corner)) break;
                const Half<corners> half = half_of(cell, number, corner);
                if (is_due(half)) halves.push_back(half);
            }
            ++number;
        }
        halves = ranks.dealt(halves,
                             [&](const Half<corners>& half) { return stretches.of(half.lesser); });
        std::vector<Across> across;
        ranks.together([&] {
            std::ranges::copy_if(waiting, std::back_inserter(halves), is_due);
            across = joined<corners>(halves, first, last);
        });
        halves.clear();
        across = ranks.dealt(
            across, [&](const Across& each) { return numbered_cells.rank_with(each.place / 4); });
        for (const auto& [place, neighbour] : across) tell(place, neighbour);
    }
    // Of edges that are not alone between their sites, who has the neighbour tells its number.
    struct Numbered {
        WholeFace face;
        std::int64_t corner;
        std::int64_t neighbour;
    };
    std::vector<Numbered> numbered;
    if constexpr (corners == 3) {
        const std::vector<Adjacency> asked = ranks.dealt(
            adjacencies, [&](const Adjacency& each) { return stretches.of(each.neighbour[0]); });
        ranks.together([&] {
            for (const auto& [face, corner, neighbour] : asked)
                numbered.push_back(
                    {face, corner,
                     stretch.first_face + static_cast<std::int64_t>(sorted.place_of(neighbour))});
        });
        numbered =
            ranks.dealt(numbered, [&](const Numbered& each) { return stretches.of(each.face[0]); });
    }
    ranks.together([&] {
        if constexpr (corners == 3)
            for (const auto& [face, corner, neighbour] : numbered)
                tell(4 * (stretch.first_face + static_cast<std::int64_t>(sorted.place_of(face))) +
                         corner,
                     neighbour);
        if (known != stretch.neighbours.size())
            throw std::logic_error("the parts of a tessellation do not fit together");
    });
    stretch.faces.reserve(corners * sorted.cells().size());
    for (const WholeCell<corners>& cell : sorted.cells())
        stretch.faces.insert(stretch.faces.end(), cell.begin(), cell.end());
    return stretch;
}

}  // namespace

RankTessellation triangulate(std::vector<Placed> sites, MPI_Comm comm, const Kind& kind) {
    const double start = processor_seconds();
    Communicator ranks(comm);
    RankTessellation result;
    ranks.together([&] { check(sites, kind); });
    result.whole = ranks.sum(static_cast<std::int64_t>(sites.size()));
    if (result.whole == 0) throw NoStructure("no site");

    OwnedSites owned = owned_by_place(ranks, std::move(sites), result.whole, kind);
    result.sites = std::move(owned.sites);
    const SiteStore store(result.sites, kind);
    const std::vector<Placed> common = common_sites(ranks, store, owned.sample, kind);
    const std::vector<PartBounds> bounds =
        ranks.all_of<PartBounds>(std::array{PartBounds{store.extent_but(common), store.spacing()}});

    std::vector<Placed> others;
    std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
        return owned.cuts.part_of(place_of(each)) != ranks.rank();
    });
    RanksExchange exchange(ranks, store);
    result.part = make_part(kind);
    ranks.together([&] { result.part->settle(store, others, bounds, ranks.rank(), exchange, {}); });
    result.cost = {ranks.sent(), result.part->told().sites, result.part->told().rounds,
                   processor_seconds() - start - ranks.seconds()};
    return result;
}

Stretch in_order(RankTessellation& tessellation, MPI_Comm comm, const Kind& kind) {
    Communicator ranks(comm);
    return kind.dimension == 3 ? stretch_of<4>(tessellation, ranks)
                               : stretch_of<3>(tessellation, ranks);
}

}  // namespace signum::mpi
