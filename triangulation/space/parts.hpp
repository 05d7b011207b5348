#pragma once
/// A tessellation of space from those of parts of its sites, which several threads build. The
/// theorem, and how two parts are joined, are those of the plane
/// (triangulation/parts/construct_parts.hpp), with facets for edges. For sources only.
///
/// The sites of a join, B+N, are many in space: a layer along the cut. So they are cut into parts
/// themselves.

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../parts/joining.hpp"
#include "../parts/plan.hpp"
#include "../structure/watch.hpp"
#include "build.hpp"
#include "cells.hpp"
#include "kernel.hpp"
#include "order.hpp"
#include "reach.hpp"

namespace signum::spatial {

/// Cells of several leaves: cell c of leaf k is named k << shift | c.
struct Leaves {
    /// What a name says.
    struct Names {
        int shift;
        Index mask;

        [[nodiscard]] std::size_t leaf(Index name) const noexcept {
            return static_cast<std::size_t>(name) >> shift;
        }
        [[nodiscard]] Index local(Index name) const noexcept { return name & mask; }
    };
    std::vector<Cells> cells;
    int shift = 31;

    [[nodiscard]] Names names() const noexcept { return {shift, static_cast<Index>(most() - 1)}; }
    /// How many cells a leaf can have.
    [[nodiscard]] std::uint32_t most() const noexcept { return std::uint32_t{1} << shift; }
    [[nodiscard]] std::size_t leaf(Index name) const noexcept { return names().leaf(name); }
    [[nodiscard]] Index local(Index name) const noexcept { return names().local(name); }
    [[nodiscard]] Index name(std::size_t leaf, Index local) const noexcept {
        return static_cast<Index>(leaf << shift) | local;
    }

    [[nodiscard]] const Four& vertex(Index name) const noexcept {
        return cells[leaf(name)].vertex(local(name));
    }
    [[nodiscard]] Four& vertex(Index name) noexcept {
        return cells[leaf(name)].vertex(local(name));
    }
    [[nodiscard]] const Four& neighbour(Index name) const noexcept {
        return cells[leaf(name)].neighbour(local(name));
    }
    [[nodiscard]] Four& neighbour(Index name) noexcept {
        return cells[leaf(name)].neighbour(local(name));
    }
};

/// How many levels of cuts give these workers enough to do, for so many sites: a leaf each, for
/// whatever more is cut has to be joined; where that is no power of two, two to four each.
[[nodiscard]] inline int levels_for(std::size_t sites, const Workers& workers) noexcept {
    if (workers.count() == 1) return 0;
    const auto count = static_cast<std::size_t>(workers.count());
    const std::size_t leaves = std::has_single_bit(count) ? count : 2 * std::bit_ceil(count);
    return std::clamp(static_cast<int>(std::bit_width(std::min(leaves, sites / few_items))) - 1, 0,
                      10);
}
/// How many sites are tried in two parts, before many more are: of fewer half would be at the cut.
inline constexpr std::size_t sampled = 8192;
/// As many as levels_for() says; none where the trial would take too large a share of the time.
inline constexpr int any_levels = -1;

/// What a construction in parts knows of sites.
enum class Mark : std::uint8_t { is_elsewhere, is_reached, is_neighbour, is_hidden };

/// One construction; that of the sites of a join is another.
template <class S>
class PartsOfSpace {
 public:
    /// A part that is built.
    struct Part {
        Index outer = unset;       ///< a cell at infinity; unset where there are no cells, and then
        std::vector<Index> loose;  ///< the visible sites
        std::vector<HiddenNear> hidden;   ///< numbers; each before those hidden after it
        std::size_t sites = 0;            ///< how many, hidden ones included
        std::size_t first = 0, last = 0;  ///< leaves
    };
    struct Result {
        Leaves leaves;
        Part part;
        LargeArray<Index> numbers;  ///< of the sites, near ones near
    };

    /// Of some of the sites, whose marks are is_elsewhere. is_forced: with one level less for the
    /// sites of joins, however few. Neither sites nor marks are copied.
    PartsOfSpace(std::span<const S> sites, std::span<const Index> numbers, int levels,
                 bool is_forced, std::span<Mark> marks, const Workers& workers, std::uint64_t seed,
                 const triangulation::Watch& watch)
        : sites_(sites),
          is_forced_(is_forced),
          marks_(marks),
          workers_(workers),
          seed_(seed),
          watch_(watch),
          plan_(triangulation::make_plan(
              numbers,
              [&](Index i) {
                  const S& s = site(i);
                  return std::array{s.x, s.y, s.z};
              },
              [&](std::span<Index> some) {
                  put_in_insertion_order(
                      some, [&](Index i) { return centre3(site(i)); }, seed);
              },
              levels, seed, workers)),
          cell_marks_(plan_.leaves()) {
        leaves_.cells.resize(plan_.leaves());
        leaves_.shift = 31 - levels;
    }

    /// All cells; none, and loose sites, where nothing is gained by parts. To be guarded by the
    /// watch (Watch::guard_all), those of joins within it.
    [[nodiscard]] Result run() && {
        boxes_ = triangulation::boxes_of<3>(plan_, workers_, [this](std::size_t leaf) {
            Box box;
            for (const Index i : plan_.numbers_of(leaf)) box.include(box_of(site(i)));
            return box;
        });
        Part whole = triangulation::built<Part>(
            plan_, workers_, watch_, [this](std::size_t number) { return leaf(number); },
            [this](std::array<Part, 2>& parts, std::size_t k) { return join(parts, k); });
        return {std::move(leaves_), std::move(whole), std::move(plan_.numbers)};
    }

 private:
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] Mark& mark(Index v) const noexcept { return marks_[static_cast<std::size_t>(v)]; }
    /// What a join knows of a cell: whether it goes, and whether it has been seen at a vertex.
    enum CellMark : std::uint8_t { stays = 0, goes = 1, is_seen = 2 };
    [[nodiscard]] std::uint8_t& cell_mark(Index c) noexcept {
        return cell_marks_[leaves_.leaf(c)][static_cast<std::size_t>(leaves_.local(c))];
    }

    [[nodiscard]] Part leaf(std::size_t number) {
        Part part;
        const std::span<const Index> numbers = plan_.numbers_of(number);
        part.sites = numbers.size();
        part.first = number;
        part.last = number + 1;
        if (numbers.empty()) return part;
        Builder<S> builder(sites_, numbers);
        if (builder.apexes() > 0) return given_up(std::move(part));
        builder.copy_sites();
        triangulation::Watch::Loop loop(watch_);
        Built built = builder.template run<ExactKernel<S>>([&](Index) { loop.step(); },
                                                           leaves_.name(number, 0));
        part.hidden = std::move(built.hidden);
        for (auto& [hidden, near] : part.hidden) {
            hidden = builder.number(hidden);
            near = builder.number(near);
            mark(hidden) = Mark::is_hidden;
        }
        if (built.cells.size() > leaves_.most()) return given_up(std::move(part));
        Cells& cells = leaves_.cells[number] = std::move(built.cells);
        cell_marks_[number].assign(cells.size(), stays);
        Index outer = 0;
        while (cells.is_free(outer) || cells.vertex(outer)[0] != infinite) ++outer;
        part.outer = leaves_.name(number, outer);
        return part;
    }

    /// The part without its cells: its visible sites are to be inserted.
    [[nodiscard]] Part given_up(Part part) {
        part.outer = unset;
        part.loose.clear();
        for (std::size_t leaf = part.first; leaf < part.last; ++leaf) {
            leaves_.cells[leaf] = {};
            release(cell_marks_[leaf]);
            for (const Index i : plan_.numbers_of(leaf))
                if (mark(i) != Mark::is_hidden) part.loose.push_back(i);
        }
        return part;
    }

    /// The parts below and above the cut of node k.
    [[nodiscard]] Part join(std::array<Part, 2>& parts, std::size_t k) {
        auto& [below, above] = parts;
        Part joined;
        joined.sites = below.sites + above.sites;
        joined.first = below.first;
        joined.last = above.last;
        joined.hidden = std::move(below.hidden);
        joined.hidden.insert(joined.hidden.end(), above.hidden.begin(), above.hidden.end());
        for (const std::size_t side : {0, 1})
            if (parts[side].sites == 0) {
                joined.outer = parts[1 - side].outer;
                joined.loose = std::move(parts[1 - side].loose);
                return joined;
            }

        std::array<Border, 2> borders;
        workers_.each(2, [&](std::size_t side) {
            const exact::IeeeEnvironment environment;
            borders[side] = border_of(parts[side], boxes_[2 * k + 2 - side]);
        });
        std::vector<Index> sites;  // B first, then N
        for (const Border& border : borders)
            sites.insert(sites.end(), border.reached.begin(), border.reached.end());
        const std::size_t reached = sites.size();
        for (const Border& border : borders)
            sites.insert(sites.end(), border.neighbours.begin(), border.neighbours.end());
        std::vector<Index> going = std::move(borders[0].cells);
        going.insert(going.end(), borders[1].cells.begin(), borders[1].cells.end());
        const auto mark_all = [&](std::size_t count, Mark as) {
            for (const Index v : std::span(sites).first(count))
                if (mark(v) != Mark::is_hidden) mark(v) = as;
        };
        mark_all(sites.size(), Mark::is_elsewhere);

        if (2 * sites.size() <= joined.sites - joined.hidden.size()) {
            const auto built = [&](std::span<const Index> some, int levels) {
                Result patch =
                    PartsOfSpace(sites_, some, levels, is_forced_, marks_, workers_, seed_, watch_)
                        .run();
                joined.hidden.insert(joined.hidden.end(), patch.part.hidden.begin(),
                                     patch.part.hidden.end());
                return patch;
            };
            const int levels = is_forced_ ? plan_.levels - 1 : levels_for(sites.size(), workers_);
            Result patch = built(sites, levels);
            if (levels > 0 && !patch.part.loose.empty())
                patch = built(std::vector<Index>(patch.part.loose), 0);
            if (patch.part.loose.empty()) {
                mark_all(reached, Mark::is_reached);
                replace(going, patch.leaves, joined);
                mark_all(reached, Mark::is_elsewhere);
            }
        }
        return joined.outer == unset ? given_up(std::move(joined)) : std::move(joined);
    }

    /// Calls visit(c) for all cells at a vertex, of which one is given; they are in `star` then.
    template <class Visit>
    void around(Index v, Index first, std::vector<Index>& star, const Visit& visit) {
        star.assign(1, first);
        cell_mark(first) |= is_seen;
        for (std::size_t i = 0; i < star.size(); ++i) {
            visit(star[i]);
            const Four& vertex = leaves_.vertex(star[i]);
            const Four& neighbour = leaves_.neighbour(star[i]);
            for (std::size_t k = 0; k < 4; ++k) {
                std::uint8_t& mark = cell_mark(neighbour[k]);
                if (vertex[k] == v || (mark & is_seen) != 0) continue;
                mark |= is_seen;
                __builtin_prefetch(&leaves_.vertex(neighbour[k]));
                __builtin_prefetch(&leaves_.neighbour(neighbour[k]));
                star.push_back(neighbour[k]);
            }
        }
        for (const Index c : star) cell_mark(c) &= goes;
    }

    /// Of a part: the sites that may be reached from beyond a cut, their neighbours that may not,
    /// and the cells at the former, which go.
    struct Border {
        std::vector<Index> reached;  ///< all that have no cells among them
        std::vector<Index> neighbours;
        std::vector<Index> cells;
    };
    /// From the cells at infinity on, from site to site by cells that may be reached.
    [[nodiscard]] Border border_of(const Part& part, const Box& beyond) {
        Border border;
        std::vector<Index> cell_at;  // of those reached
        const auto take = [&](Index v, Index c) {
            if (v < 0 || mark(v) == Mark::is_reached) return;
            mark(v) = Mark::is_reached;
            border.reached.push_back(v);
            cell_at.push_back(c);
        };
        for (const Index v : part.loose) take(v, unset);
        if (part.outer == unset) return border;
        const auto look_at = [&](Index c) {
            if (!may_be_reached(c, beyond)) return;
            for (const Index v : leaves_.vertex(c)) take(v, c);
        };
        std::vector<Index> star;
        around(infinite, part.outer, star, look_at);
        for (std::size_t i = 0; i < cell_at.size(); ++i)
            around(border.reached[i], cell_at[i], star, [&](Index c) {
                if ((cell_mark(c) & goes) != 0) return;
                cell_mark(c) |= goes;
                border.cells.push_back(c);
                look_at(c);
            });
        for (const Index c : border.cells)
            for (const Index v : leaves_.vertex(c)) {
                if (v < 0 || mark(v) != Mark::is_elsewhere) continue;
                mark(v) = Mark::is_neighbour;
                border.neighbours.push_back(v);
            }
        return border;
    }
    /// One with the vertex at infinity by sites beyond its facet's plane, or in that plane where
    /// the cell behind the facet is (insert.hpp).
    [[nodiscard]] bool may_be_reached(Index c, const Box& beyond) const noexcept {
        const Four& cell = leaves_.vertex(c);
        if (cell[0] != infinite) return InSphereForm(sites_, cell).may_be_reached_from(beyond);
        const Sign side = side_of(sites_, cell, beyond);
        if (side != 0) return side > 0;
        return InSphereForm(sites_, leaves_.vertex(leaves_.neighbour(c)[0]))
            .may_be_reached_from(beyond);
    }

    /// A facet of three settled sites, infinity among them perhaps, and a site of B: the cell with
    /// the facet that stays, across from which that site is, and at which of its places.
    using Key = std::array<std::uint64_t, 2>;
    struct Seam {
        Key key;
        Index cell;
        std::uint32_t place;
    };
    /// The facet across from a vertex, as the cell turns, its least vertex first; and that vertex.
    [[nodiscard]] static Key key_of(const Four& cell, std::size_t place) noexcept {
        const auto& [i, j, k] = facet_of[place];
        std::array<Index, 3> facet = {cell[i], cell[j], cell[k]};
        std::rotate(facet.begin(), std::ranges::min_element(facet), facet.end());
        const auto both = [](Index a, Index b) {
            return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 |
                   static_cast<std::uint32_t>(b);
        };
        return {both(facet[0], facet[1]), both(facet[2], cell[place])};
    }
    /// The facets between cells that go and cells that stay, in the order of their keys.
    [[nodiscard]] std::vector<Seam> seams_of(std::span<const Index> going) {
        std::vector<std::vector<Seam>> found(workers_.range_count(going.size()));
        workers_.each(found.size(), [&](std::size_t i) {
            const std::size_t end = going.size() * (i + 1) / found.size();
            for (std::size_t g = going.size() * i / found.size(); g < end; ++g)
                for (std::size_t k = 0; k < 4; ++k) {
                    const Index n = leaves_.neighbour(going[g])[k];
                    if ((cell_mark(n) & goes) == 0)
                        found[i].push_back(
                            {key_of(leaves_.vertex(going[g]), k), n,
                             static_cast<std::uint32_t>(place_of(going[g], leaves_.neighbour(n)))});
                }
        });
        std::vector<Seam> seams;
        for (const std::vector<Seam>& some : found)
            seams.insert(seams.end(), some.begin(), some.end());
        std::ranges::sort(seams, {}, &Seam::key);
        return seams;
    }
    /// Cells that have a site of B, of one leaf.
    struct Placed {
        std::vector<Index> order;  ///< by local cell: how many such cells come before; or unset
        std::size_t first = 0;     ///< how many are in leaves before
        std::size_t count = 0;
        Index outer = unset;  ///< one of them at infinity, by how many come before it
    };
    [[nodiscard]] std::vector<Placed> place(const Leaves& patch) const {
        std::vector<Placed> placed(patch.cells.size());
        const auto is_reached = [&](Index v) { return v >= 0 && mark(v) == Mark::is_reached; };
        workers_.each(placed.size(), [&](std::size_t leaf) {
            const Cells& cells = patch.cells[leaf];
            auto& [order, first, count, outer] = placed[leaf];
            order.assign(cells.size(), unset);
            for (Index c = 0; c < static_cast<Index>(cells.size()); ++c) {
                if (cells.is_free(c) || std::ranges::none_of(cells.vertex(c), is_reached)) continue;
                order[static_cast<std::size_t>(c)] = static_cast<Index>(count);
                if (cells.vertex(c)[0] == infinite) outer = static_cast<Index>(count);
                ++count;
            }
        });
        for (std::size_t leaf = 1; leaf < placed.size(); ++leaf)
            placed[leaf].first = placed[leaf - 1].first + placed[leaf - 1].count;
        return placed;
    }
    /// Puts the cells of the patch that have a site of B in the place of those that go.
    void replace(std::vector<Index>& going, const Leaves& patch, Part& joined) {
        const std::vector<Seam> seams = seams_of(going);
        for (const Index c : going) cell_mark(c) = stays;
        const std::vector<Placed> placed = place(patch);
        const std::size_t count = placed.back().first + placed.back().count;
        if (!make_as_many(count, going, joined.first)) return;

        const auto place_of_patch = [&](Index c) {
            const Placed& there = placed[patch.leaf(c)];
            const Index order = there.order[static_cast<std::size_t>(patch.local(c))];
            return order == unset ? unset : going[there.first + static_cast<std::size_t>(order)];
        };
        std::atomic<std::size_t> met = 0;
        const auto put = [&](std::size_t leaf, Index begin, Index end) {
            const Cells& cells = patch.cells[leaf];
            std::size_t met_here = 0;
            for (Index c = begin; c < end; ++c) {
                const Index to = place_of_patch(patch.name(leaf, c));
                if (to == unset) continue;
                const Four& vertex = cells.vertex(c);
                leaves_.vertex(to) = vertex;
                for (std::size_t k = 0; k < 4; ++k) {
                    Index& across = leaves_.neighbour(to)[k];
                    across = place_of_patch(cells.neighbour(c)[k]);
                    if (across != unset) continue;
                    const auto key = key_of(vertex, k);
                    const auto seam = std::ranges::lower_bound(seams, key, {}, &Seam::key);
                    if (seam == seams.end() || seam->key != key) throw_no_fit();
                    across = seam->cell;
                    leaves_.neighbour(seam->cell)[seam->place] = to;
                    ++met_here;
                }
            }
            met += met_here;
        };
        for (std::size_t leaf = 0; leaf < placed.size(); ++leaf)
            workers_.each_range(placed[leaf].order.size(), [&](std::size_t begin, std::size_t end) {
                put(leaf, static_cast<Index>(begin), static_cast<Index>(end));
            });
        if (met != seams.size()) throw_no_fit();
        for (const Placed& some : placed)
            if (some.outer != unset)
                joined.outer = going[some.first + static_cast<std::size_t>(some.outer)];
    }
    /// Makes as many cells of those that go, in a leaf or out of where they are. False, and nothing
    /// is done, where the leaf has no room.
    [[nodiscard]] bool make_as_many(std::size_t count, std::vector<Index>& going,
                                    std::size_t leaf) {
        Cells& own = leaves_.cells[leaf];
        if (count > going.size()) {
            if (own.size() + (count - going.size()) > leaves_.most()) return false;
            std::vector<Index> added(count - going.size());
            own.add(added);
            cell_marks_[leaf].resize(own.size(), stays);
            for (const Index c : added) going.push_back(leaves_.name(leaf, c));
        }
        for (; going.size() > count; going.pop_back())
            leaves_.cells[leaves_.leaf(going.back())].remove(leaves_.local(going.back()));
        return true;
    }
    [[noreturn]] static void throw_no_fit() {
        throw std::logic_error("two parts of a tessellation of space do not fit together");
    }

    std::span<const S> sites_;
    bool is_forced_;
    std::span<Mark> marks_;  // of the sites
    const Workers& workers_;
    std::uint64_t seed_;
    const triangulation::Watch& watch_;
    triangulation::Plan plan_;
    std::vector<Box> boxes_;  // around the sites of each node
    Leaves leaves_;
    std::vector<std::vector<std::uint8_t>> cell_marks_;  // of each leaf's cells
};

}  // namespace signum::spatial
