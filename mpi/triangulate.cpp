#include "triangulate.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "../core/insertion_rounds.hpp"
#include "../triangulation/distributed/common.hpp"
#include "../triangulation/distributed/cuts.hpp"
#include "../triangulation/distributed/exchange.hpp"
#include "../triangulation/distributed/site_store.hpp"
#include "../triangulation/distributed/whole.hpp"
#include "communicator.hpp"

namespace signum::mpi {
namespace {

using namespace distributed;

/// Ranks that ask one another, all at the same time.
class RanksExchange final : public Exchange {
 public:
    RanksExchange(Communicator& ranks, const SiteStore& store) : ranks_(ranks), store_(store) {}

    [[nodiscard]] std::vector<Answers> ask(std::vector<Questions> questions) override {
        std::vector<Questions> coming(questions.size());
        carry(questions, coming, &Questions::boxes);
        carry(questions, coming, &Questions::faces);
        carry(questions, coming, &Questions::edges);
        carry(questions, coming, &Questions::hidden);
        std::vector<Answers> answers(questions.size());
        ranks_.together([&] {
            for (std::size_t r = 0; r < coming.size(); ++r)
                if (!coming[r].are_none()) answers[r] = store_.answer(coming[r]);
        });
        std::vector<Answers> result(questions.size());
        carry(answers, result, &Answers::sites);
        carry(answers, result, &Answers::nearest);
        return result;
    }
    [[nodiscard]] bool is_for_any(bool own) override { return ranks_.most(own ? 1 : 0) != 0; }

 private:
    template <class Message, class T>
    void carry(std::vector<Message>& to, std::vector<Message>& from,
               std::vector<T> Message::*member) {
        std::vector<std::vector<T>> lists;
        for (Message& each : to) lists.push_back(std::move(each.*member));
        std::vector<std::vector<T>> coming = ranks_.exchanged(lists);
        for (std::size_t r = 0; r < from.size(); ++r) from[r].*member = std::move(coming[r]);
    }

    Communicator& ranks_;
    const SiteStore& store_;
};

/// Of all sites so many, as they come by their numbers; all of them where they are few.
std::vector<Placed> sampled(Communicator& ranks, std::span<const Placed> own, std::int64_t whole,
                            std::int64_t wanted) {
    const double share = static_cast<double>(wanted) / static_cast<double>(whole);
    std::vector<Placed> sample;
    for (const Placed& each : own)
        if (static_cast<double>(mix(static_cast<std::uint64_t>(each.id))) * 0x1p-64 < share)
            sample.push_back(each);
    sample = ranks.all_of<Placed>(sample);
    std::ranges::sort(sample, {}, &Placed::id);
    return sample;
}

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

/// Of faces or cells, so many numbers each.
template <std::size_t corners>
std::vector<WholeCell<corners>> cells_of(const std::vector<std::int64_t>& numbers) {
    std::vector<WholeCell<corners>> cells(numbers.size() / corners);
    for (std::size_t c = 0; c < cells.size(); ++c)
        std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(corners * c), corners,
                    cells[c].begin());
    return cells;
}

template <std::size_t corners>
Stretch stretch_of(RankTessellation& tessellation, Communicator& ranks) {
    // Faces, edges and hidden sites go to ranks by their first sites.
    const Stretches stretches(tessellation.whole, ranks.size());
    const std::int64_t first = stretches.begin(ranks.rank());
    const std::int64_t last = stretches.begin(ranks.rank() + 1);

    Stretch stretch;
    stretch.corners = corners;
    std::vector<WholeCell<corners>> cells = cells_of<corners>(tessellation.faces);
    tessellation.faces = {};
    SortedCells<corners> sorted(
        ranks.dealt(
            cells, [&](const WholeCell<corners>& cell) { return stretches.of(cell[0]); }),
        stretches.begin_of_faces(ranks.rank()), last);
    const auto count = static_cast<std::int64_t>(sorted.cells().size());
    const std::vector<std::int64_t> counts = ranks.all_of<std::int64_t>(std::array{count});
    std::vector<std::int64_t> begins(1, 0);
    for (const std::int64_t each : counts) begins.push_back(begins.back() + each);
    stretch.first_face = begins[ranks.rank()];
    stretch.faces_of_all = begins.back();
    stretch.hidden = ranks.dealt(
        tessellation.hidden, [&](const WholeHidden& hidden) { return stretches.of(hidden.site); });
    std::ranges::sort(stretch.hidden, {}, &WholeHidden::site);
    stretch.first_hidden = ranks.sum_before(static_cast<std::int64_t>(stretch.hidden.size()));
    stretch.hidden_of_all = ranks.sum(static_cast<std::int64_t>(stretch.hidden.size()));

    // Halves of edges or facets meet where their lesser sites are, and are told to their cells.
    std::vector<Across> across;
    {
        std::vector<Half<corners>> halves;
        halves.reserve(corners * sorted.cells().size());
        std::int64_t number = stretch.first_face;
        for (const WholeCell<corners>& cell : sorted.cells())
            each_half(cell, number++, [&](const Half<corners>& half) { halves.push_back(half); });
        halves = ranks.dealt(
            halves, [&](const Half<corners>& half) { return stretches.of(half.lesser); });
        ranks.together([&] { across = joined<corners>(halves, first, last); });
    }
    across = ranks.dealt(across, [&](const Across& each) {
        const auto end = std::ranges::upper_bound(begins, each.place / 4);
        return static_cast<std::size_t>(end - begins.begin()) - 1;
    });
    // Of edges that are not alone between their sites, who has the neighbour tells its number.
    struct Numbered {
        WholeFace face;
        std::int64_t corner;
        std::int64_t neighbour;
    };
    std::vector<Numbered> numbered;
    if constexpr (corners == 3) {
        const std::vector<Adjacency> asked =
            ranks.dealt(tessellation.adjacencies,
                        [&](const Adjacency& each) { return stretches.of(each.neighbour[0]); });
        ranks.together([&] {
            for (const auto& [face, corner, neighbour] : asked)
                numbered.push_back(
                    {face, corner,
                     stretch.first_face + static_cast<std::int64_t>(sorted.place_of(neighbour))});
        });
        numbered = ranks.dealt(numbered,
                               [&](const Numbered& each) { return stretches.of(each.face[0]); });
    }
    ranks.together([&] {
        if (across.size() + numbered.size() != corners * sorted.cells().size())
            throw std::logic_error("the parts of a tessellation do not fit together");
        stretch.neighbours.resize(corners * sorted.cells().size());
        const auto neighbour_of = [&](std::size_t cell, std::int64_t corner) -> std::int64_t& {
            return stretch.neighbours[corners * cell + static_cast<std::size_t>(corner)];
        };
        for (const auto& [place, neighbour] : across)
            neighbour_of(static_cast<std::size_t>(place / 4 - stretch.first_face), place % 4) =
                neighbour;
        if constexpr (corners == 3)
            for (const auto& [face, corner, neighbour] : numbered)
                neighbour_of(sorted.place_of(face), corner) = neighbour;
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

    const std::vector<Placed> sample = sampled(ranks, sites, result.whole, 65'536);
    std::vector<Point3> points;
    for (const Placed& each : sample) points.push_back(place_of(each));
    const Cuts cuts(std::move(points), ranks.size());
    result.sites = ranks.dealt(sites, [&](const Placed& each) {
        return cuts.part_of(place_of(each));
    });
    ranks.together([&] { order_along_curve(result.sites, kind); });
    const SiteStore store(result.sites, kind);
    const std::vector<Placed> common = common_sites(ranks, store, sample, kind);
    const std::vector<PartBounds> bounds =
        ranks.all_of<PartBounds>(std::array{PartBounds{store.extent_but(common), store.spacing()}});

    std::vector<Placed> others;
    std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
        return cuts.part_of(place_of(each)) != ranks.rank();
    });
    RanksExchange exchange(ranks, store);
    const std::unique_ptr<Part> part = make_part(kind);
    ranks.together([&] {
        part->settle(store, others, bounds, ranks.rank(), exchange, {});
        part->each_face([&](std::span<const std::int64_t> face) {
            result.faces.insert(result.faces.end(), face.begin(), face.end());
        });
        part->each_adjacency([&](const Adjacency& each) { result.adjacencies.push_back(each); });
        result.hidden = part->hidden();
        part->each_star([&](std::int64_t site, std::span<const std::int64_t> neighbours) {
            const std::size_t first = result.neighbours.size();
            result.neighbours.insert(result.neighbours.end(), neighbours.begin(), neighbours.end());
            result.stars.push_back({site, first, result.neighbours.size()});
        });
    });
    result.cost = {ranks.sent(), part->told().sites, part->told().rounds,
                   processor_seconds() - start - ranks.seconds()};
    return result;
}

Stretch in_order(RankTessellation& tessellation, MPI_Comm comm, const Kind& kind) {
    Communicator ranks(comm);
    return kind.dimension == 3 ? stretch_of<4>(tessellation, ranks)
                               : stretch_of<3>(tessellation, ranks);
}

}  // namespace signum::mpi
