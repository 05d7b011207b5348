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
#include "judged_arrays.hpp"
#include "owned_sites.hpp"

namespace signum::mpi {
namespace {

using distributed::in_plane;
using distributed::straight;
using triangulation::RankedSite;

/// What is counted.
struct Counts {
    std::uint64_t filtered = 0;
    std::uint64_t exact = 0;
};

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
