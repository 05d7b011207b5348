#include "validate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "../exact/dyadic.hpp"
#include "../exact/floating_environment.hpp"
#include "../filters/tally.hpp"
#include "../triangulation/any_dimension/questions.hpp"
#include "../triangulation/check/additive_questions.hpp"
#include "../triangulation/distributed/few.hpp"
#include "../triangulation/distributed/settling.hpp"
#include "../triangulation/distributed/whole.hpp"
#include "../triangulation/kernels/additive_kernel.hpp"
#include "owned_sites.hpp"

namespace signum::mpi {
namespace {

using distributed::Buckets;
using distributed::in_plane;
using distributed::straight;
using distributed::WholeCell;
using distributed::WholeHidden;
using triangulation::Invalid;
using triangulation::Notes;
using triangulation::RankedSite;

std::string name_of_site(std::int64_t site) {
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

/// Where each rank's stretch of so many items begins, and the end.
std::vector<std::int64_t> begins_of(Communicator& ranks, std::size_t items) {
    std::vector<std::int64_t> begins(1, 0);
    for (const std::int64_t each :
         ranks.all_of<std::int64_t>(std::array{static_cast<std::int64_t>(items)}))
        begins.push_back(begins.back() + each);
    return begins;
}
std::size_t rank_with(const std::vector<std::int64_t>& begins, std::int64_t item) {
    const auto after = std::ranges::upper_bound(begins, item);
    return static_cast<std::size_t>(after - begins.begin()) - 1;
}

/// Sorted, and each once.
void add_to_set(std::vector<std::int64_t>& set, std::vector<std::int64_t>& more) {
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
          site_begins_(begins_of(ranks, slice.size())),
          cell_begins_(begins_of(ranks, stretch.faces.size() / corners)) {}

    [[nodiscard]] std::int64_t sites() const noexcept { return site_begins_.back(); }
    /// Of all ranks.
    [[nodiscard]] std::int64_t cells() const noexcept { return cell_begins_.back(); }
    /// Of this one.
    [[nodiscard]] std::size_t size() const noexcept { return stretch_.faces.size() / corners; }
    [[nodiscard]] std::int64_t number(std::size_t c) const noexcept {
        return cell_begins_[ranks_.rank()] + static_cast<std::int64_t>(c);
    }
    [[nodiscard]] std::size_t rank_of_cell(std::int64_t cell) const {
        return rank_with(cell_begins_, cell);
    }
    [[nodiscard]] std::size_t rank_of_site(std::int64_t site) const {
        return rank_with(site_begins_, site);
    }
    [[nodiscard]] std::int64_t first_site() const noexcept { return site_begins_[ranks_.rank()]; }
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
                    const Side<corners> side = side_of(c, k, are_given);
                    if (hash(side) / ranks_.size() % times == time) sides.push_back(side);
                }
            sides = ranks_.dealt(sides, [&](const Side<corners>& side) {
                return static_cast<std::size_t>(hash(side) % ranks_.size());
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
        cell_at_.assign(static_cast<std::size_t>(site_begins_[ranks_.rank() + 1] - first_site()),
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
        if (corners == 3 && cell_begins_.back() != 2 * all - 2)
            throw Invalid{std::to_string(all) + " visible sites have " +
                          std::to_string(2 * all - 2) + " faces, not " +
                          std::to_string(cell_begins_.back())};
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
        const auto is_known = static_cast<std::size_t>(size() > 0 ? 1 : 0);
        std::vector<Cell> own;
        if (is_known != 0) own.push_back(cell(size() - 1));
        std::vector<std::int64_t> counts;
        for (std::size_t r = 0; r < ranks_.size(); ++r)
            counts.push_back(cell_begins_[r + 1] - cell_begins_[r]);
        const std::vector<Cell> lasts = ranks_.all_of<Cell>(own);
        std::optional<Cell> before;
        const auto ranks_before = static_cast<std::size_t>(std::count_if(
            counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(ranks_.rank()),
            [](std::int64_t count) { return count > 0; }));
        if (ranks_before > 0) before = lasts[ranks_before - 1];
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
    [[nodiscard]] static std::uint64_t hash(const Side<corners>& side) noexcept {
        std::uint64_t hash = 0;
        for (const std::int64_t site : side.facet)
            hash = mix(hash + static_cast<std::uint64_t>(site));
        return hash;
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
    std::vector<std::int64_t> site_begins_;
    std::vector<std::int64_t> cell_begins_;
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

/// What is counted.
struct Counts {
    std::uint64_t filtered = 0;
    std::uint64_t exact = 0;
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

/// Hidden sites and those that are said to hide them, or, of those of which nothing is said, some
/// other one.
template <std::size_t corners>
std::vector<std::array<Placed, 2>> hidden_of(Arrays<corners>& arrays, std::span<const Placed> slice,
                                             std::int64_t other) {
    std::vector<std::int64_t> ids;
    const auto by_of = [&](const WholeHidden& hidden) { return hidden.by < 0 ? other : hidden.by; };
    for (const WholeHidden& each : arrays.hidden()) ids.insert(ids.end(), {each.site, by_of(each)});
    std::vector<std::int64_t> set;
    add_to_set(set, ids);
    const std::vector<Site3> sites = arrays.places_of(set, slice);
    const auto placed = [&](std::int64_t id) {
        return Placed(
            sites[static_cast<std::size_t>(std::ranges::lower_bound(set, id) - set.begin())], id);
    };
    std::vector<std::array<Placed, 2>> result;
    for (const WholeHidden& each : arrays.hidden())
        result.push_back({placed(each.site), placed(by_of(each))});
    return result;
}

/// Who is nearest to the centres of hidden sites, of all sites.
template <class K>
std::vector<Placed> nearest(Communicator& ranks, std::span<const std::array<Placed, 2>> hidden,
                            std::span<const Placed> slice, std::int64_t whole, const Kind& kind) {
    const OwnedSites owned = owned_by_place(ranks, {slice.begin(), slice.end()}, whole, kind);
    const SiteStore store(owned.sites, kind);
    const std::vector<distributed::Extent> extents =
        ranks.all_of<distributed::Extent>(std::array{store.extent()});
    RanksExchange exchange(ranks, store);
    std::vector<std::array<Placed, 2>> found(hidden.begin(), hidden.end());
    distributed::ask_for_nearest<K>(found, extents, extents.size(), exchange);
    std::vector<Placed> result;
    for (const auto& [site, by] : found) result.push_back(by);
    return result;
}

/// Power tessellations: see any_dimension/check.hpp.
template <class K>
class StraightJudge {
    using S = typename K::S;
    using Asked = any_dimension::Questions<S, exact::Dyadic>;
    using Cell = typename Asked::Cell;
    static constexpr std::size_t corners = K::dimension + 1;

 public:
    StraightJudge(Communicator& ranks, Arrays<corners>& arrays, std::span<const Placed> slice,
                  Notes& notes)
        : ranks_(ranks),
          arrays_(arrays),
          local_(local_sites<corners, S>(arrays, slice,
                                         [](const Site3& site) {
                                             return straight<K>({site, 0});
                                         })),
          notes_(notes) {}

    void run() {
        choose_base();
        Asked asked{std::span<const S>(local_.sites)};
        judge(ranks_, [&] {
            for (std::size_t c = 0; c < arrays_.size(); ++c) judge_cell(asked, c);
        });
        counts_.filtered += asked.filtered_count();
        counts_.exact += asked.exact_count();
    }
    void judge_hidden(std::span<const Placed> slice, std::int64_t whole, const Kind& kind) {
        std::vector<WholeHidden>& hidden = arrays_.hidden();
        const std::vector<std::array<Placed, 2>> asked = hidden_of(arrays_, slice, base_.front());
        const std::vector<Placed> found = nearest<K>(ranks_, asked, slice, whole, kind);
        judge(ranks_, [&] {
            for (std::size_t h = 0; h < hidden.size(); ++h) {
                auto& [site, by] = hidden[h];
                if (by < 0) by = found[h].id;
                if (found[h].id == by) continue;
                const std::array three = {straight<K>(asked[h][0]), straight<K>(found[h]),
                                          straight<K>(asked[h][1])};
                Asked questions{std::span<const S>(three)};
                if (questions.nearer(0, 1, 2) > 0)
                    throw Invalid{name_of_site(site) + " is said to be hidden by " +
                                  name_of_site(by) + ", but " + name_of_site(found[h].id) +
                                  " is nearer"};
                notes_.note("by the tie rule " + name_of_site(site) + " is hidden by " +
                            name_of_site(found[h].id) + ", not " + name_of_site(by));
            }
        });
        walk(asked);
    }
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
    /// A finite cell that all others are compared with: a small one. Its sites follow the others.
    void choose_base() {
        struct Base {
            double extent = std::numeric_limits<double>::infinity();
            std::int64_t number = std::numeric_limits<std::int64_t>::max();
            WholeCell<corners> cell;
            std::array<S, corners> sites;
        };
        Base own;
        for (std::size_t c = 0; c < arrays_.size(); ++c) {
            const WholeCell<corners> cell = arrays_.cell(c);
            if (std::ranges::count(cell, -1) != 0) continue;
            const Cell at_places = places(cell);
            double extent = 0.0;
            for (std::size_t axis = 0; axis < K::dimension; ++axis) {
                const auto [low, high] = range(at_places, axis);
                extent += high - low;
            }
            if (own.number <= arrays_.number(c) && !(extent < own.extent)) continue;
            own = {extent, arrays_.number(c), cell, {}};
            for (std::size_t k = 0; k < corners; ++k) own.sites[k] = local_.sites[at(at_places[k])];
        }
        const std::vector<Base> all = ranks_.all_of<Base>(std::array{own});
        const Base& base = *std::ranges::min_element(
            all, {}, [](const Base& each) { return std::pair(each.extent, each.number); });
        if (base.number == std::numeric_limits<std::int64_t>::max())
            throw std::invalid_argument(
                "sites on a line, or in a plane of space, have no finite faces or cells: signum "
                "validate judges them");
        base_number_ = base.number;
        base_ = base.cell;
        for (std::size_t k = 0; k < corners; ++k) {
            base_places_[k] = static_cast<Index>(local_.sites.size());
            local_.sites.push_back(base.sites[k]);
        }
    }
    void judge_cell(Asked& asked, std::size_t c) {
        const Cell cell = places(arrays_.cell(c));
        std::array<Index, corners> beyond;
        for (std::size_t k = 0; k < corners; ++k) beyond[k] = local_.place(arrays_.apex(c, k));
        const auto* const at = std::ranges::find(cell, infinite);
        const auto place = static_cast<std::size_t>(at - cell.begin());
        if (place < corners) {
            const auto keep_within = [&](Index v) {
                Cell with = cell;
                with[place] = v;
                if (asked.orientation(with) > 0)
                    throw Invalid{name_of(v) + " lies beyond the hull's " +
                                  Arrays<corners>::facet() + " of " + cell_name(c)};
            };
            for (const Index v : base_places_) keep_within(v);
            for (std::size_t k = 0; k < corners; ++k)
                if (k != place) keep_within(beyond[k]);
            return;
        }
        const Sign sign = asked.orientation(cell);
        if (sign <= 0)
            throw Invalid{cell_name(c) + (sign == 0 ? " is flat" : " turns the wrong way")};
        if (arrays_.number(c) != base_number_ && is_near_base(cell) &&
            holds_middle_of_base(asked, cell))
            throw Invalid{cell_name(c) + " and " + Arrays<corners>::name(base_number_) +
                          " overlap"};
        for (std::size_t k = 0; k < corners; ++k) {
            // Each facet once.
            if (beyond[k] < cell[k]) continue;
            const Sign conflict = asked.in_sphere(cell, beyond[k]);
            if (conflict < 0) continue;
            const auto why = [&] {
                return name_of(beyond[k]) + " is in conflict with " + cell_name(c);
            };
            if (conflict > 0) throw Invalid{why()};
            if (asked.tie_conflicts(cell, beyond[k])) notes_.note("by the tie rule " + why());
        }
    }
    [[nodiscard]] bool is_near_base(const Cell& cell) const {
        for (std::size_t axis = 0; axis < K::dimension; ++axis) {
            const auto [low, high] = range(cell, axis);
            const auto [base_low, base_high] = range(base_places_, axis);
            if (high < base_low || low > base_high) return false;
        }
        return true;
    }
    [[nodiscard]] bool holds_middle_of_base(Asked& asked, const Cell& cell) const {
        for (std::size_t k = 0; k < corners; ++k)
            if (asked.orientation_with_middle(cell, k, base_places_) < 0) return false;
        return true;
    }

    /// A hidden site on its way to the cell that has its centre, from one at the site that hides
    /// it.
    struct Walker {
        Placed site;
        std::int64_t cell;
        std::uint64_t steps = 0;
    };
    void walk(std::span<const std::array<Placed, 2>> hidden) {
        const std::vector<std::int64_t> starts = arrays_.cells_at(arrays_.hidden());
        std::vector<Walker> walkers;
        for (std::size_t h = 0; h < hidden.size(); ++h)
            walkers.push_back({hidden[h][0], starts[h]});
        while (ranks_.most(static_cast<std::int64_t>(walkers.size())) > 0) {
            walkers = ranks_.dealt(
                walkers, [&](const Walker& each) { return arrays_.rank_of_cell(each.cell); });
            std::vector<Walker> going;
            judge(ranks_, [&] {
                for (Walker& each : walkers)
                    if (!arrives(each)) going.push_back(each);
            });
            walkers = std::move(going);
        }
    }
    /// Whether it does so at this rank, where it is judged.
    [[nodiscard]] bool arrives(Walker& walker) {
        while (true) {
            if (arrays_.rank_of_cell(walker.cell) != ranks_.rank()) return false;
            const auto c = static_cast<std::size_t>(walker.cell - arrays_.number(0));
            const WholeCell<corners> cell = arrays_.cell(c);
            if (std::ranges::count(cell, -1) != 0 ||
                walker.steps > 2 * static_cast<std::uint64_t>(arrays_.cells()) + 1000)
                throw Invalid{name_of_site(walker.site.id) +
                              " is said to be hidden, but lies outside the hull"};
            // By chance out of one of the facets that have it on the other side.
            const std::size_t first = mix(++walker.steps) % corners;
            const Asking few(*this, cell, walker.site);
            std::size_t way = corners;
            for (std::size_t m = 0; m < corners && way == corners; ++m)
                if (const std::size_t k = (first + m) % corners; few.lies_beyond(k)) way = k;
            if (way < corners) {
                walker.cell = arrays_.neighbour(c, way);
                continue;
            }
            if (const Sign sign = few.conflict(); sign >= 0) {
                const std::string why =
                    name_of_site(walker.site.id) + " is in conflict with " + cell_name(c);
                if (sign > 0) throw Invalid{why};
                if (few.tie_conflicts()) notes_.note("by the tie rule " + why);
            }
            return true;
        }
    }
    /// A cell, and a site of whichever rank.
    class Asking {
     public:
        Asking(StraightJudge& judge, const WholeCell<corners>& cell, const Placed& site)
            : judge_(judge) {
            std::array<std::int64_t, corners + 1> ids;
            std::ranges::copy(cell, ids.begin());
            ids[corners] = site.id;
            std::array<Index, corners + 1> numbers{};
            for (std::size_t a = 0; a <= corners; ++a) {
                for (const std::int64_t other : ids) numbers[a] += other < ids[a] ? 1 : 0;
                const auto to = static_cast<std::size_t>(numbers[a]);
                sites_[to] = a < corners ? judge.local_.sites[at(judge.local_.place(cell[a]))]
                                         : straight<K>(site);
            }
            std::copy_n(numbers.begin(), corners, cell_.begin());
            q_ = numbers[corners];
        }
        Asking(const Asking&) = delete;
        Asking& operator=(const Asking&) = delete;
        ~Asking() {
            judge_.counts_.filtered += asked_.filtered_count();
            judge_.counts_.exact += asked_.exact_count();
        }
        [[nodiscard]] bool lies_beyond(std::size_t k) const {
            Cell with = cell_;
            with[k] = q_;
            return asked_.orientation(with) < 0;
        }
        [[nodiscard]] Sign conflict() const { return asked_.in_sphere(cell_, q_); }
        [[nodiscard]] bool tie_conflicts() const { return asked_.tie_conflicts(cell_, q_); }

     private:
        StraightJudge& judge_;
        std::array<S, corners + 1> sites_;
        Cell cell_;
        Index q_;
        mutable Asked asked_{std::span<const S>(sites_)};
    };

    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    [[nodiscard]] Cell places(const WholeCell<corners>& cell) const {
        Cell places;
        for (std::size_t k = 0; k < corners; ++k) places[k] = local_.place(cell[k]);
        return places;
    }
    [[nodiscard]] std::string name_of(Index v) const {
        return name_of_site(at(v) < local_.ids.size() ? local_.ids[at(v)]
                                                      : base_[at(v) - local_.ids.size()]);
    }
    [[nodiscard]] std::string cell_name(std::size_t c) const {
        return Arrays<corners>::name(arrays_.number(c));
    }
    [[nodiscard]] std::pair<double, double> range(const Cell& cell, std::size_t axis) const {
        double low = any_dimension::coordinate(local_.sites[at(cell[0])], axis);
        double high = low;
        for (std::size_t k = 1; k < corners; ++k) {
            const double x = any_dimension::coordinate(local_.sites[at(cell[k])], axis);
            low = std::min(low, x);
            high = std::max(high, x);
        }
        return {low, high};
    }

    Communicator& ranks_;
    Arrays<corners>& arrays_;
    LocalSites<S> local_;
    Notes& notes_;
    WholeCell<corners> base_{};
    Cell base_places_{};
    std::int64_t base_number_ = 0;
    Counts counts_;
};

/// Tessellations of the metrics with additive weights: see check/additive_check.hpp. Each cycle of
/// faces at infinity turns once at least, so that one turn of all of them says that there is one.
template <class K>
class AdditiveJudge {
    /// As a judge asks, and counting.
    struct Judging : K {
        using Kernel =
            triangulation::AdditiveKernel<typename triangulation::PredicatesOf<typename K::Metric>::
                                              template Perturbed<Arithmetic::judging>,
                                          filters::Tally>;
    };
    using Kernel = typename Judging::Kernel;
    using Asked = triangulation::AdditiveQuestions<Kernel>;

 public:
    AdditiveJudge(Communicator& ranks, Arrays<3>& arrays, std::span<const Placed> slice,
                  Notes& notes)
        : ranks_(ranks),
          arrays_(arrays),
          local_(local_sites<3, RankedSite>(arrays, slice,
                                            [](const Site3& site) {
                                                return RankedSite{in_plane({site, 0}), 0};
                                            })),
          notes_(notes) {
        std::vector<Index> numbers(local_.sites.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        triangulation::rank(local_.sites, numbers, Workers(1));
    }

    void run() {
        Asked asked(notes_, Kernel(local_.sites.data()));
        std::int64_t turns = 0;
        judge(ranks_, [&] {
            for (std::size_t c = 0; c < arrays_.size(); ++c) turns += judge_face(asked, c);
        });
        count(asked);
        turns = ranks_.sum(turns);
        if (turns != 1) throw Invalid{"the hull turns " + std::to_string(turns) + " times"};
    }
    void judge_hidden(std::span<const Placed> slice, std::int64_t whole, const Kind& kind) {
        std::vector<WholeHidden>& hidden = arrays_.hidden();
        // Of whom nothing is said: anybody but the site itself.
        std::vector<std::array<Placed, 2>> asked =
            hidden_of(arrays_, slice, ranks_.most(local_.ids.empty() ? -1 : local_.ids.front()));
        const std::vector<Placed> found = nearest<K>(ranks_, asked, slice, whole, kind);
        judge(ranks_, [&] {
            for (std::size_t h = 0; h < hidden.size(); ++h) {
                if (hidden[h].by < 0) {
                    hidden[h].by = found[h].id;
                    asked[h][1] = found[h];
                }
                judge_one_hidden(asked[h][0], asked[h][1], found[h]);
            }
        });
        static_cast<void>(arrays_.cells_at(hidden));
    }
    [[nodiscard]] const Counts& counts() const noexcept { return counts_; }

 private:
    struct Names {
        const AdditiveJudge& judge;
        std::size_t face;
        std::size_t corner = 0;
        [[nodiscard]] std::string of(Index v) const {
            return name_of_site(v < 0 ? -1 : judge.local_.ids[static_cast<std::size_t>(v)]);
        }
        [[nodiscard]] std::string of_face() const {
            return Arrays<3>::name(judge.arrays_.number(face));
        }
        [[nodiscard]] std::string of_face_across() const {
            return judge.arrays_.name_across(face, corner);
        }
    };
    /// How often it holds the first direction at infinity.
    [[nodiscard]] std::int64_t judge_face(Asked& asked, std::size_t c) const {
        std::array<Index, 3> v;
        for (std::size_t k = 0; k < 3; ++k) v[k] = local_.place(arrays_.cell(c)[k]);
        asked.judge_vertex(v, Names{*this, c});
        std::int64_t turns = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Index i = v[(k + 1) % 3];
            const Index j = v[(k + 2) % 3];
            const Index beyond = local_.place(arrays_.apex(c, k));
            asked.judge_edge({i, j, v[k], beyond}, Names{*this, c, k});
            if (i == infinite) turns += asked.kernel.holds_first_direction(v[k], j, beyond) ? 1 : 0;
        }
        return turns;
    }
    void judge_one_hidden(const Placed& site, const Placed& by, const Placed& found) {
        distributed::Few<Judging, 3> few({&site, &by, &found});
        Asked asked(notes_, few.kernel());
        Kernel& kernel = asked.kernel;
        if (!kernel.hides(1, 0)) {
            if (!kernel.hides_if_first(1, 0))
                throw Invalid{name_of_site(by.id) + " does not hide " + name_of_site(site.id)};
            asked.note("by the tie rule " + name_of_site(by.id) + " does not hide " +
                       name_of_site(site.id));
        }
        if (found.id != by.id)
            asked.forbid([&] { return kernel.is_nearer(0, 2, 1); },
                         [&] {
                             return name_of_site(found.id) + " is nearer to the centre of " +
                                    name_of_site(site.id) + " than " + name_of_site(by.id) +
                                    ", which is said to hide it";
                         });
        count(asked);
    }
    void count(const Asked& asked) {
        const auto& stages = asked.kernel.tally().stages;
        counts_.filtered += stages[static_cast<int>(Stage::filter)];
        counts_.exact += stages[static_cast<int>(Stage::multiprecision)];
        if (!asked.is_canonical()) notes_.note(asked.first());
    }

    Communicator& ranks_;
    Arrays<3>& arrays_;
    LocalSites<RankedSite> local_;
    Notes& notes_;
    Counts counts_;
};

template <class K>
Validation judged(Communicator& ranks, std::span<const Placed> slice, Stretch stretch,
                  bool tells_hidden, const Kind& kind) {
    constexpr std::size_t corners = K::dimension + 1;
    Notes notes;
    Counts counts;
    Validation result;
    try {
        Arrays<corners> arrays(ranks, stretch, slice);
        if (arrays.cells() == 0)
            throw std::invalid_argument(
                "there is no face: signum validate judges such a tessellation");
        arrays.check_numbers();
        arrays.check_order(notes);
        arrays.check_sites(tells_hidden);
        arrays.glue();
        using Judge = std::conditional_t<K::is_straight, StraightJudge<K>, AdditiveJudge<K>>;
        Judge judge(ranks, arrays, slice, notes);
        judge.run();
        if (ranks.sum(static_cast<std::int64_t>(arrays.hidden().size())) > 0)
            judge.judge_hidden(slice, arrays.sites(), kind);
        result.valid = true;
        counts = judge.counts();
    } catch (const Invalid& invalid) {
        result.message = invalid.why;
        return result;
    }
    try {
        judge(ranks, [&] {
            if (!notes.is_canonical()) throw Invalid{notes.first()};
        });
        result.canonical = true;
    } catch (const Invalid& note) {
        result.message = note.why;
    }
    result.filtered =
        static_cast<std::uint64_t>(ranks.sum(static_cast<std::int64_t>(counts.filtered)));
    result.multiprecision =
        static_cast<std::uint64_t>(ranks.sum(static_cast<std::int64_t>(counts.exact)));
    return result;
}

}  // namespace

Validation validate(const std::vector<Placed>& slice, Stretch stretch, bool tells_hidden,
                    MPI_Comm comm, const Kind& kind) {
    const exact::IeeeEnvironment environment;
    Communicator ranks(comm);
    ranks.together([&] { check(slice, kind); });
    return distributed::with_kind(kind, [&]<class K>() {
        return judged<K>(ranks, slice, std::move(stretch), tells_hidden, kind);
    });
}

}  // namespace signum::mpi
