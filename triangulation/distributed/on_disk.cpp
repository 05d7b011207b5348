#include "on_disk.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "../../core/insertion_rounds.hpp"
#include "../../core/parallel.hpp"
#include "../options.hpp"
#include "common.hpp"
#include "cuts.hpp"
#include "disk_files.hpp"
#include "shared_exchange.hpp"
#include "site_store.hpp"
#include "whole.hpp"

namespace signum::distributed {
namespace {

/// How far the work is.
class Steps {
 public:
    explicit Steps(const DiskOptions& options) : options_(options) {}
    /// How many there are. Before it is known nothing is told.
    void expect(std::size_t all) noexcept { all_ = all; }
    /// One more of as many as there are, on whatever thread. Throws Stopped.
    void step() {
        const std::size_t done = ++done_;
        if (options_.stop.stop_requested()) throw Stopped();
        const std::lock_guard lock(one_at_a_time_);
        if (options_.progress && all_ > 0 && done > told_) {
            told_ = done;
            options_.progress(static_cast<double>(done) / static_cast<double>(all_));
        }
    }

 private:
    const DiskOptions& options_;
    std::size_t all_ = 0;
    std::atomic<std::size_t> done_ = 0;
    std::mutex one_at_a_time_;
    std::size_t told_ = 0;
};

/// The piece of a name and how many sites it says are hidden, where it is there and whole.
template <class T>
std::optional<std::pair<Scratch<T>, std::int64_t>> kept_piece(const PieceName& name,
                                                              PiecesFound& found) {
    auto piece = Scratch<T>::kept(name, [&] { found.damaged.push_back(name.path); });
    if (piece) ++found.whole;
    return piece;
}

template <std::size_t corners>
void build_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                   const std::function<void(const WholeCounts&)>& begin,
                   const std::function<void(std::span<const std::int64_t>)>& put) {
    // More files for what is made than parts, for the first ones have more faces: of three sites
    // one is among the first half nearly always.
    const auto files_for = [](std::size_t parts) { return std::min(corners * parts, most_parts); };
    using Cell = WholeCell<corners>;
    Steps steps(options);
    WholeCounts counts;
    const bool keeps = !options.pieces.folder.empty();
    constexpr std::uint64_t version = 1;  // of the pieces
    counts.checksum = version;

    // Once through the sites for a sample: all of the first ones, then ever fewer.
    constexpr std::size_t most_sampled = 65'536;
    std::vector<Placed> sample;
    std::uint64_t spared = ~std::uint64_t{0};
    for (std::size_t slice = 0; slice < sites.slices; ++slice) {
        const std::vector<Placed> some = sites.read(slice);
        check(some, kind);
        counts.checksum = sum_of<Placed>(some, counts.checksum);
        counts.sites += static_cast<std::int64_t>(some.size());
        const auto is_in = [&](const Placed& each) {
            return mix(static_cast<std::uint64_t>(each.id)) <= spared;
        };
        for (const Placed& each : some) {
            if (!is_in(each)) continue;
            sample.push_back(each);
            if (sample.size() < 2 * most_sampled) continue;
            spared /= 2;
            std::erase_if(sample, [&](const Placed& one) { return !is_in(one); });
        }
        steps.step();
    }
    if (counts.sites == 0) throw NoStructure("no site");
    const std::size_t parts = options.parts(counts.sites);
    if (parts == 0 || parts > most_parts)
        throw std::invalid_argument("parts: " + std::to_string(parts) + ", 1 to " +
                                    std::to_string(most_parts) + " are possible");
    counts.parts = parts;
    steps.expect(2 * sites.slices + 2 * parts + files_for(parts));
    std::vector<Point3> points;
    for (const Placed& each : sample) points.push_back(place_of(each));
    const Cuts cuts(std::move(points), parts);

    // What an earlier call kept counts where it did the same work.
    if (keeps && options.pieces.belong) options.pieces.belong(counts);
    const auto piece_of = [&](bool are_faces, std::size_t part) -> PieceName {
        const std::array<std::uint64_t, 6> work = {static_cast<std::uint64_t>(kind.metric),
                                                   static_cast<std::uint64_t>(kind.weight_is),
                                                   kind.dimension,
                                                   parts,
                                                   are_faces ? 1U : 0U,
                                                   part};
        return {options.pieces.folder + (are_faces ? "/faces-" : "/sites-") + std::to_string(part) +
                    ".piece",
                sum_of<std::uint64_t>(work, counts.checksum)};
    };
    const auto sites_of = [&](std::size_t part) { return piece_of(false, part); };
    const auto faces_of = [&](std::size_t part) { return piece_of(true, part); };
    PiecesFound found = {.all = 2 * parts, .damaged = {}};

    // And once more, for the parts.
    std::vector<std::optional<Mapped<Placed>>> mapped(parts);
    const auto forget = [&] {
        for (const auto& each : mapped) each->forget();
    };
    if (keeps) {
        for (std::size_t k = 0; k < parts; ++k)
            if (auto piece = kept_piece<Placed>(sites_of(k), found))
                mapped[k].emplace(piece->first);
    }
    {
        std::vector<Scratch<Placed>> dealt;
        for (std::size_t k = 0; k < parts; ++k) dealt.emplace_back(options.folder);
        const bool are_all_there =
            std::ranges::all_of(mapped, [](const auto& own) { return own.has_value(); });
        std::uint64_t checksum = version;
        for (std::size_t slice = 0; slice < sites.slices; ++slice) {
            if (!are_all_there) {
                const std::vector<Placed> some = sites.read(slice);
                checksum = sum_of<Placed>(some, checksum);
                for (const Placed& each : some) {
                    const std::size_t part = cuts.part_of(place_of(each));
                    if (!mapped[part]) dealt[part].append(each);
                }
            }
            steps.step();
        }
        if (!are_all_there && checksum != counts.checksum)
            throw SitesChanged("other sites were read the second time");
        for (std::size_t k = parts; k-- > 0;) {
            // The last one first, so that each is gone when it has been read.
            std::vector<Placed> own = dealt.back().read();
            dealt.pop_back();
            if (!mapped[k]) {
                order_along_curve(own, kind);
                auto in_order =
                    keeps ? Scratch<Placed>(sites_of(k)) : Scratch<Placed>(options.folder);
                in_order.append(own);
                if (keeps) in_order.keep();
                mapped[k].emplace(in_order);
            }
            steps.step();
        }
    }
    std::vector<SiteStore> stores;
    Extent whole = no_extent();
    for (const auto& own : mapped) {
        stores.emplace_back(own->all(), kind);
        if (!is_empty(stores.back().extent())) whole.include(stores.back().extent());
        own->forget();
    }

    Farthest farthest(kind, whole);
    farthest.include(sample);
    std::vector<Placed> candidates;
    std::vector<Placed> greatest;
    const auto add = [](std::vector<Placed>& all, const std::vector<Placed>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    for (const SiteStore& store : stores) {
        add(candidates, endless_among(store, farthest));
        add(greatest, greatest_of(store.sites(), kind));
        forget();
    }
    const std::vector<Placed> common = common_of(std::move(candidates), greatest, kind);
    std::vector<PartBounds> bounds;
    for (const SiteStore& store : stores) {
        bounds.push_back({store.extent_but(common), store.spacing()});
        forget();
    }

    // Faces go to files by their first sites.
    const std::size_t count = files_for(parts);
    const Stretches stretches(counts.sites, count);
    std::vector<Scratch<Cell>> files;
    for (std::size_t k = 0; k < count; ++k) files.emplace_back(options.folder);
    const auto put_cell = [&](const Cell& cell) {
        ++counts.faces;
        counts.infinite_faces += cell[0] < 0 ? 1 : 0;
        files[stretches.of(cell[0])].append(cell);
    };
    std::vector<std::size_t> unsettled;
    for (std::size_t k = 0; k < parts; ++k) {
        auto piece = keeps ? kept_piece<Cell>(faces_of(k), found) : std::nullopt;
        if (!piece) {
            unsettled.push_back(k);
            continue;
        }
        piece->first.each(
            [&](std::span<const Cell> cells) { std::ranges::for_each(cells, put_cell); });
        counts.hidden += piece->second;
        steps.step();
    }
    counts.settled = unsettled.size();
    if (keeps && options.pieces.found) options.pieces.found(found);

    std::mutex one_at_a_time;
    const Workers workers(options.threads, static_cast<std::size_t>(counts.sites));
    workers.each(unsettled.size(), [&](std::size_t next) {
        const std::size_t number = unsettled[next];
        std::vector<Placed> others;
        std::ranges::copy_if(common, std::back_inserter(others), [&](const Placed& each) {
            return cuts.part_of(place_of(each)) != number;
        });
        SharedExchange exchange(stores);
        const std::unique_ptr<Part> part = make_part(kind);
        part->settle(stores[number], others, bounds, number, exchange, options.stop);
        const auto hidden = static_cast<std::int64_t>(part->hidden().size());
        const auto each_cell = [&](const auto& use) {
            part->each_face([&](std::span<const std::int64_t> sites_of_cell) {
                Cell cell;
                std::ranges::copy(sites_of_cell, cell.begin());
                use(cell);
            });
        };
        if (keeps) {
            Scratch<Cell> piece(faces_of(number));
            each_cell([&](const Cell& cell) { piece.append(cell); });
            piece.keep(hidden);
        }
        const std::lock_guard lock(one_at_a_time);
        each_cell(put_cell);
        counts.hidden += hidden;
        forget();
        steps.step();
    });

    begin(counts);
    for (std::size_t k = 0; k < count; ++k) {
        const SortedCells<corners> sorted(files[k].read(), stretches.begin_of_faces(k),
                                          stretches.begin(k + 1));
        put({sorted.cells().data()->data(), corners * sorted.cells().size()});
        steps.step();
    }
}

}  // namespace

void triangulate_on_disk(const SlicedSites& sites, const Kind& kind, const DiskOptions& options,
                         const std::function<void(const WholeCounts&)>& begin,
                         const std::function<void(std::span<const std::int64_t>)>& put) {
    if (kind.dimension == 3)
        build_on_disk<4>(sites, kind, options, begin, put);
    else
        build_on_disk<3>(sites, kind, options, begin, put);
}

}  // namespace signum::distributed
