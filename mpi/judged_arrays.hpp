#pragma once
/// The arrays of a tessellation over the ranks, as validate() judges them. For one source only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "../core/insertion_rounds.hpp"
#include "../exact/floating_environment.hpp"
#include "../triangulation/distributed/whole.hpp"
#include "../triangulation/structure/judgement.hpp"
#include "by_number.hpp"
#include "communicator.hpp"
#include "triangulate.hpp"

namespace signum::mpi {

using distributed::Buckets;
using distributed::Placed;
using distributed::WholeCell;
using distributed::WholeHidden;
using triangulation::Invalid;
using triangulation::Notes;

[[nodiscard]] inline std::string name_of_site(std::int64_t site) {
    return site < 0 ? "infinity" : "site " + std::to_string(site);
}

/// Work of each rank. What some find wrong is thrown on all: what the first of them found.
template <class Work>
void judge(Communicator& ranks, const Work& work) {
    std::string why;
    ranks.together([&] {
        try {
            const exact::IeeeEnvironment environment;
            work();
        } catch (const Invalid& invalid) {
            why = invalid.why;
        }
    });
    const auto own = static_cast<std::int64_t>(ranks.rank());
    const auto none = static_cast<std::int64_t>(ranks.size());
    const std::int64_t first = -ranks.most(why.empty() ? -none : -own);
    if (first == none) return;
    if (first != own) why.clear();
    const std::vector<char> told = ranks.all_of<char>(why);
    throw Invalid{std::string(told.begin(), told.end())};
}

/// Sorted, and each once.
inline void add_to_set(std::vector<std::int64_t>& set, std::vector<std::int64_t>& more) {
    std::ranges::sort(more);
    more.erase(std::unique(more.begin(), more.end()), more.end());
    std::vector<std::int64_t> both;
    both.reserve(set.size() + more.size());
    std::ranges::set_union(set, more, std::back_inserter(both));
    set = std::move(both);
    more.clear();
}

/// A facet as one of its cells has it; in the plane the cells are faces, and the facets edges.
template <std::size_t corners>
struct Side {
    std::array<std::int64_t, corners - 1> facet;  ///< rising, infinity the last
    std::int64_t cell;
    std::int64_t corner;     ///< the place in the cell of the vertex that is across
    std::int64_t apex;       ///< that vertex
    std::int64_t neighbour;  ///< the cell beyond, as it is given, or -1
    bool is_even;            ///< whether the apex and the facet are an even permutation of the cell
};

/// The arrays, before any place is looked at.
template <std::size_t corners>
class Arrays {
 public:
    using Cell = WholeCell<corners>;

    Arrays(Communicator& ranks, Stretch& stretch, std::span<const Placed> slice)
        : ranks_(ranks),
          stretch_(stretch),
          sites_(ranks, slice.size()),
          cells_(ranks, stretch.faces.size() / corners) {}

    [[nodiscard]] std::int64_t sites() const noexcept { return sites_.all(); }
    /// Of all ranks.
    [[nodiscard]] std::int64_t cells() const noexcept { return cells_.all(); }
    /// Of this one.
    [[nodiscard]] std::size_t size() const noexcept { return stretch_.faces.size() / corners; }
    [[nodiscard]] std::int64_t number(std::size_t c) const noexcept {
        return cells_.first(ranks_.rank()) + static_cast<std::int64_t>(c);
    }
    [[nodiscard]] std::size_t rank_of_cell(std::int64_t cell) const {
        return cells_.rank_with(cell);
    }
    [[nodiscard]] std::size_t rank_of_site(std::int64_t site) const {
        return sites_.rank_with(site);
    }
    [[nodiscard]] std::int64_t first_site() const noexcept { return sites_.first(ranks_.rank()); }
    [[nodiscard]] Cell cell(std::size_t c) const noexcept {
        Cell cell;
        std::copy_n(&stretch_.faces[corners * c], corners, cell.begin());
        return cell;
    }
    [[nodiscard]] static std::string name(std::int64_t cell) {
        return (corners == 3 ? "face " : "cell ") + std::to_string(cell);
    }
    [[nodiscard]] static const char* facet() noexcept { return corners == 3 ? "edge" : "facet"; }

    /// Each number is infinity's or a site's, and there once.
    void check_numbers() const {
        judge(ranks_, [&] {
            for (std::size_t c = 0; c < size(); ++c) {
                const Cell own = cell(c);
                for (std::size_t k = 0; k < corners; ++k) {
                    if (own[k] < -1 || own[k] >= sites())
                        throw Invalid{name(number(c)) + ": there is no site " +
                                      std::to_string(own[k])};
                    if (std::count(own.begin(), own.end(), own[k]) != 1)
                        throw Invalid{name(number(c)) + " has " + name_of_site(own[k]) + " twice"};
                }
            }
            for (const auto& [site, by] : stretch_.hidden)
                for (const std::int64_t each : {site, by})
                    if (each < 0 || each >= sites())
                        throw Invalid{"hidden: there is no site " + std::to_string(each)};
        });
    }

    /// Glues cells along their facets, in pairs, and turns them alike across each. Afterwards
    /// apex(c, k) is the vertex beyond, and neighbour(c, k) the cell.
    void glue() {
        const bool are_given = ranks_.most(stretch_.neighbours.empty() ? 0 : 1) != 0;
        apexes_.assign(stretch_.faces.size(), -1);
        // Without hidden sites only messages ask for them.
        const bool are_kept =
            are_given || ranks_.most(static_cast<std::int64_t>(stretch_.hidden.size())) > 0;
        std::vector<std::int64_t> neighbours(are_kept ? stretch_.faces.size() : 0);
        const std::uint64_t times = times_of(stretch_.faces.size());
        struct Beyond {
            std::int64_t cell;
            std::int64_t corner;
            std::int64_t apex;
            std::int64_t neighbour;
        };
        for (std::uint64_t time = 0; time < times; ++time) {
            std::vector<Side<corners>> sides;
            for (std::size_t c = 0; c < size(); ++c)
                for (std::size_t k = 0; k < corners; ++k) {
                    const Cell own = cell(c);
                    if (hash(own, own[k]) / ranks_.size() % times == time)
                        sides.push_back(side_of(c, k, are_given));
                }
            sides = ranks_.dealt(sides, [&](const Side<corners>& side) {
                return static_cast<std::size_t>(hash(side.facet) % ranks_.size());
            });
            std::vector<Beyond> beyond;
            judge(ranks_, [&] {
                pair_up(sides, are_given, [&](const auto& one, const auto& other) {
                    beyond.push_back({one.cell, one.corner, other.apex, other.cell});
                    beyond.push_back({other.cell, other.corner, one.apex, one.cell});
                });
            });
            sides = {};
            for (const auto& [cell, corner, apex, neighbour] : ranks_.dealt(
                     beyond, [&](const Beyond& each) { return rank_of_cell(each.cell); })) {
                const std::size_t place = corners * static_cast<std::size_t>(cell - number(0)) +
                                          static_cast<std::size_t>(corner);
                apexes_[place] = apex;
                if (are_kept) neighbours[place] = neighbour;
            }
        }
        stretch_.neighbours = std::move(neighbours);
    }
    [[nodiscard]] std::int64_t apex(std::size_t c, std::size_t k) const noexcept {
        return apexes_[corners * c + k];
    }
    [[nodiscard]] std::int64_t neighbour(std::size_t c, std::size_t k) const noexcept {
        return stretch_.neighbours[corners * c + k];
    }
    [[nodiscard]] std::string name_across(std::size_t c, std::size_t k) const {
        return stretch_.neighbours.empty() ? "its neighbour" : name(neighbour(c, k));
    }

    /// Every site is a vertex or hidden by one; in the plane there are as many faces as Euler asks.
    /// Where it is not told who is hidden, that are all others, by nobody.
    void check_sites(bool tells_hidden) {
        struct At {
            std::int64_t site;
            bool is_infinite;  // a finite one is asked for
            std::int64_t cell;
        };
        const auto in_order = [](const At& each) { return std::pair(each.site, each.is_infinite); };
        cell_at_.assign(static_cast<std::size_t>(sites_.first(ranks_.rank() + 1) - first_site()),
                        -1);
        const std::uint64_t times = times_of(stretch_.faces.size());
        for (std::uint64_t time = 0; time < times; ++time) {
            std::vector<At> all;
            for (std::size_t c = 0; c < size(); ++c) {
                const Cell own = cell(c);
                const bool is_infinite = std::ranges::count(own, -1) != 0;
                for (const std::int64_t site : own)
                    if (site >= 0 && mix(static_cast<std::uint64_t>(site)) % times == time)
                        all.push_back({site, is_infinite, number(c)});
            }
            std::ranges::sort(all, {}, in_order);
            std::vector<At> at;
            std::ranges::unique_copy(all, std::back_inserter(at), {}, &At::site);
            all = {};
            at = ranks_.dealt(at, [&](const At& each) { return rank_of_site(each.site); });
            std::ranges::sort(at, {}, in_order);
            for (const auto& [site, is_infinite, cell] : at) {
                std::int64_t& known = cell_at_[static_cast<std::size_t>(site - first_site())];
                if (known < 0) known = cell;
            }
        }
        std::vector<WholeHidden> hidden = stretch_.hidden;
        hidden =
            ranks_.dealt(hidden, [&](const WholeHidden& each) { return rank_of_site(each.site); });
        std::vector<char> is_hidden(cell_at_.size(), 0);
        judge(ranks_, [&] {
            for (const auto& [site, by] : hidden) {
                const auto place = static_cast<std::size_t>(site - first_site());
                if (cell_at_[place] >= 0)
                    throw Invalid{name_of_site(site) + " is both visible and hidden"};
                if (std::exchange(is_hidden[place], 1) != 0)
                    throw Invalid{name_of_site(site) + " is hidden twice"};
            }
            for (std::size_t place = 0; place < cell_at_.size(); ++place) {
                if (cell_at_[place] >= 0 || is_hidden[place] != 0) continue;
                const std::int64_t site = first_site() + static_cast<std::int64_t>(place);
                if (tells_hidden)
                    throw Invalid{name_of_site(site) + " is neither visible nor hidden"};
                stretch_.hidden.push_back({site, -1});
            }
        });
        const auto visible = static_cast<std::int64_t>(
            std::ranges::count_if(cell_at_, [](std::int64_t cell) { return cell >= 0; }));
        const std::int64_t all = ranks_.sum(visible);
        if (corners == 3 && cells() != 2 * all - 2)
            throw Invalid{std::to_string(all) + " visible sites have " +
                          std::to_string(2 * all - 2) + " faces, not " + std::to_string(cells())};
    }
    /// A cell at each of some sites, of whichever rank. Throws Invalid for one that is no vertex.
    [[nodiscard]] std::vector<std::int64_t> cells_at(std::span<const WholeHidden> hidden) {
        std::vector<std::vector<WholeHidden>> asked(ranks_.size());
        std::vector<std::size_t> asked_of;
        for (const WholeHidden& each : hidden) {
            asked_of.push_back(rank_of_site(each.by));
            asked[asked_of.back()].push_back(each);
        }
        std::vector<std::vector<std::int64_t>> answers(ranks_.size());
        const std::vector<std::vector<WholeHidden>> coming = ranks_.exchanged(asked);
        judge(ranks_, [&] {
            for (std::size_t r = 0; r < coming.size(); ++r)
                for (const auto& [site, by] : coming[r]) {
                    answers[r].push_back(cell_at_[static_cast<std::size_t>(by - first_site())]);
                    if (answers[r].back() < 0)
                        throw Invalid{name_of_site(site) + " is hidden by " + name_of_site(by) +
                                      ", which is hidden itself"};
                }
        });
        answers = ranks_.exchanged(answers);
        std::vector<std::size_t> next(ranks_.size());
        std::vector<std::int64_t> cells;
        for (const std::size_t r : asked_of) cells.push_back(answers[r][next[r]++]);
        return cells;
    }

    /// Where the arrays are not in canonical order, which is noted.
    void check_order(Notes& notes) const {
        struct Last {
            std::int64_t number;
            Cell cell;
        };
        std::vector<Last> last;
        if (size() > 0) last.push_back({number(size() - 1), cell(size() - 1)});
        std::optional<Cell> before;
        for (const auto& [at, cell] : ranks_.all_of<Last>(last))
            if (at < number(0)) before = cell;
        for (std::size_t c = 0; c < size(); ++c) {
            const Cell now = cell(c);
            bool rises = true;
            for (std::size_t m = 1; m < corners; ++m)
                rises &= m + 1 < corners ? now[m - 1] < now[m] : now[m - 2] < now[m];
            if (!rises) notes.note(name(number(c)) + ": its numbers are not in canonical order");
            if (before && now < *before) notes.note(name(number(c)) + " is not in canonical order");
            before = now;
        }
        // Each rank's first and last one, where it has any.
        std::vector<std::int64_t> ends;
        if (!stretch_.hidden.empty())
            ends = {stretch_.hidden.front().site, stretch_.hidden.back().site};
        ends = ranks_.all_of<std::int64_t>(ends);
        if (!std::ranges::is_sorted(stretch_.hidden, {}, &WholeHidden::site) ||
            !std::ranges::is_sorted(ends))
            notes.note("the hidden sites are not in canonical order");
    }

    [[nodiscard]] std::vector<WholeHidden>& hidden() noexcept { return stretch_.hidden; }
    /// How often some of so many are looked at, of each rank as many as fit beside the cells.
    [[nodiscard]] std::uint64_t times_of(std::size_t all) {
        // Each time passes over all of them, so that it is not to be often.
        const std::size_t at_a_time = std::max(std::size_t{1} << 22, all / 16);
        return static_cast<std::uint64_t>(
            ranks_.most(static_cast<std::int64_t>(all / at_a_time + 1)));
    }
    /// Sites by their numbers, rising, of whichever rank.
    [[nodiscard]] std::vector<Site3> places_of(std::span<const std::int64_t> ids,
                                               std::span<const Placed> slice) {
        std::vector<std::vector<std::int64_t>> asked(ranks_.size());
        for (const std::int64_t id : ids) asked[rank_of_site(id)].push_back(id);
        asked = ranks_.exchanged(asked);
        std::vector<std::vector<Site3>> answers(ranks_.size());
        ranks_.together([&] {
            for (std::size_t r = 0; r < asked.size(); ++r)
                for (const std::int64_t id : asked[r])
                    answers[r].push_back(slice[static_cast<std::size_t>(id - first_site())].site);
        });
        asked = {};
        std::vector<Site3> places;
        for (const std::vector<Site3>& some : ranks_.exchanged(answers))
            places.insert(places.end(), some.begin(), some.end());
        return places;
    }

 private:
    /// Of a facet: its sites, in any order, or those of a cell but one.
    template <std::size_t size>
    [[nodiscard]] static std::uint64_t hash(const std::array<std::int64_t, size>& sites,
                                            std::optional<std::int64_t> but = {}) noexcept {
        std::uint64_t sum = 0;
        for (const std::int64_t site : sites)
            if (site != but) sum += mix(static_cast<std::uint64_t>(site));
        return mix(sum);
    }
    [[nodiscard]] Side<corners> side_of(std::size_t c, std::size_t k, bool are_given) const {
        const Cell own = cell(c);
        Side<corners> side;
        side.cell = number(c);
        side.corner = static_cast<std::int64_t>(k);
        side.apex = own[k];
        side.neighbour = are_given ? stretch_.neighbours[corners * c + k] : -1;
        side.is_even = k % 2 == 0;
        for (std::size_t m = 0, to = 0; m < corners; ++m)
            if (m != k) side.facet[to++] = own[m];
        for (std::size_t end = corners - 1; end > 1; --end)
            for (std::size_t m = 0; m + 1 < end; ++m) {
                // Infinity, as a number without a sign, after all others.
                if (static_cast<std::uint64_t>(side.facet[m]) <
                    static_cast<std::uint64_t>(side.facet[m + 1]))
                    continue;
                std::swap(side.facet[m], side.facet[m + 1]);
                side.is_even = !side.is_even;
            }
        return side;
    }
    /// Calls put(one, other) for the two sides of each facet.
    template <class Put>
    static void pair_up(std::vector<Side<corners>>& sides, bool are_given, const Put& put) {
        const auto key = [&](const Side<corners>& side) {
            const auto [less, more] = std::minmax(side.cell, side.neighbour);
            return std::tuple(side.facet, are_given ? less : 0, are_given ? more : 0, side.cell);
        };
        std::ranges::sort(sides, {}, key);
        for (std::size_t s = 0; s < sides.size(); s += 2) {
            const Side<corners>& one = sides[s];
            const auto across = [&] {
                return name(one.cell) + ", across from " + name_of_site(one.apex) + ": ";
            };
            const bool are_two = s + 1 < sides.size() && sides[s + 1].facet == one.facet;
            if (!are_given) {
                if (!are_two)
                    throw Invalid{across() + "the " + facet() + " belongs to no other " +
                                  (corners == 3 ? "face" : "cell")};
                if (s + 2 < sides.size() && sides[s + 2].facet == one.facet)
                    throw std::invalid_argument(
                        across() + "the " + facet() +
                        " occurs more than twice, and only neighbours tell which is which: write "
                        ".h5, which has them");
            } else if (!are_two || sides[s + 1].cell != one.neighbour ||
                       sides[s + 1].neighbour != one.cell || one.neighbour == one.cell) {
                throw Invalid{across() + name(one.neighbour) + " is no neighbour"};
            }
            const Side<corners>& other = sides[s + 1];
            if (one.is_even == other.is_even)
                throw Invalid{name(one.cell) + " and " + name(other.cell) +
                              " lie on the same side of their " + facet()};
            put(one, other);
        }
    }

    Communicator& ranks_;
    Stretch& stretch_;
    ByNumber sites_;
    ByNumber cells_;
    std::vector<std::int64_t> apexes_;
    std::vector<std::int64_t> cell_at_;  ///< of each site of the slice a cell, or -1
};

/// The sites of a rank's cells and of those beyond, as the judge's questions take them: by their
/// numbers, so that ties are decided as in the whole.
template <class S>
struct LocalSites {
    std::vector<std::int64_t> ids;  ///< rising
    std::vector<S> sites;
    Buckets buckets;
    std::vector<Index> begins;  ///< of each bucket, among them

    explicit LocalSites(std::vector<std::int64_t> rising)
        : ids(std::move(rising)),
          buckets(ids.empty() ? 0 : ids.front(), ids.empty() ? 1 : ids.back() + 1, ids.size()),
          begins(buckets.count() + 1) {
        for (const std::int64_t id : ids) ++begins[buckets.of(id) + 1];
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
    }
    /// Of one of them, or of infinity. Expected O(1).
    [[nodiscard]] Index place(std::int64_t id) const noexcept {
        if (id < 0) return infinite;
        auto place = static_cast<std::size_t>(begins[buckets.of(id)]);
        while (ids[place] < id) ++place;
        return static_cast<Index>(place);
    }
};

/// S: made of Placed by make().
template <std::size_t corners, class S, class Make>
LocalSites<S> local_sites(Arrays<corners>& arrays, std::span<const Placed> slice,
                          const Make& make) {
    std::vector<std::int64_t> ids;
    std::vector<std::int64_t> more;
    const auto add = [&](std::int64_t id) {
        if (id < 0) return;
        more.push_back(id);
        if (more.size() > (std::size_t{1} << 22) + ids.size()) add_to_set(ids, more);
    };
    for (std::size_t c = 0; c < arrays.size(); ++c) {
        for (const std::int64_t id : arrays.cell(c)) add(id);
        for (std::size_t k = 0; k < corners; ++k) add(arrays.apex(c, k));
    }
    add_to_set(ids, more);
    if (ids.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()) - 8)
        throw std::length_error("more sites than a rank can judge");
    LocalSites<S> local(std::move(ids));
    local.sites.reserve(local.ids.size() + corners);
    const std::uint64_t times = arrays.times_of(local.ids.size());
    for (std::uint64_t time = 0; time < times; ++time) {
        const std::size_t begin = local.ids.size() * time / times;
        const std::size_t end = local.ids.size() * (time + 1) / times;
        for (const Site3& site :
             arrays.places_of(std::span(local.ids).subspan(begin, end - begin), slice))
            local.sites.push_back(make(site));
    }
    return local;
}

}  // namespace signum::mpi
