#pragma once
/// The supremum and Manhattan tessellations by sweeping the plane (thesis, chapter 5).
///
/// A line goes over the plane; behind it every wave that has started grows, and their front
/// consists of arcs, each of one site, in the order of their heights. Two arcs meet at a collision
/// point, which traces an edge of the diagram. Laws:
///  1. A wave starts as a ray within one arc and splits it (site event), unless that arc's site
///     hides the new one; if any site does, that one does.
///  2. An arc ends where its two collision points meet (circle event): a vertex, a face of the
///     tessellation.
///  3. A collision point moves with the edge of one of its waves, from its birth until it comes to
///     rest, or for ever (front.hpp). The thesis schedules that moment, a break event. Here both
///     numbers, the moving edge and the resting height, are known at birth; so whoever asks takes
///     the lesser, or the greater, of the two, and a break takes place without being scheduled.
///  4. The plane that no wave has reached is an arc of the infinite vertex, its tent lower than
///     any: an arc like the others.
///  5. Under the tie rule no two events that are both to come are simultaneous: infinitesimals that
///     cancel out would need the same three sites on the same sides.
/// O(n log n): a site adds two arcs at most, and an event changes those beside it.

#include <algorithm>
#include <array>
#include <boost/intrusive/set.hpp>
#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <type_traits>
#include <vector>

#include "../../core/contract.hpp"
#include "../../core/error_free.hpp"
#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../predicates/rectangular/front.hpp"
#include "../options.hpp"
#include "../structure/tie_order.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// The places of the sites in the order in which their waves start. Many may start at once, as
/// those on an edge do: so the times are kept to twice the precision, where ties are seen as such.
template <class Directions, Arithmetic arithmetic>
[[nodiscard]] LargeArray<Index> order_of_starts(std::span<const RankedSite> sites) {
    using Number = predicates::NumberOf<arithmetic>;
    struct Start {
        Number twice_time;
        double rest;   ///< to be added
        double error;  ///< 0: both are exact, or taken to be
        Index place;
    };
    const auto start_of = [&](Index place) -> Start {
        const RankedSite& site = sites[static_cast<std::size_t>(place)];
        const rectangular::RoundedForms<Directions, arithmetic> forms(site, false);
        if (arithmetic == Arithmetic::exact &&
            forms.error < std::numeric_limits<double>::infinity()) {
            const TwoTerms centre = two_sum((Directions::x[0] + Directions::x[1]) * site.x,
                                            (Directions::y[0] + Directions::y[1]) * site.y);
            const TwoTerms sum = two_sum(centre.high, -2 * site.r);
            const TwoTerms rest = two_sum(centre.low, sum.low);
            if (rest.low == 0.0) {
                const TwoTerms twice_time = two_sum(sum.high, rest.high);
                return {Number(twice_time.high), twice_time.low, 0.0, place};
            }
        }
        Number twice_time = forms.g[0] + forms.g[1];
        // No order has a place for a NaN.
        if constexpr (!is_exact(arithmetic))
            if (twice_time != twice_time) twice_time = 0;
        return {twice_time, 0.0, forms.error, place};
    };
    LargeArray<Start> starts(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) starts[i] = start_of(static_cast<Index>(i));
    std::sort(starts.begin(), starts.end(), [&](const Start& a, const Start& b) {
        const Number difference = b.twice_time - a.twice_time;
        const double error = a.error + b.error;
        if (filters::exceeds(difference, error)) [[likely]]
            return filters::sign_of_nonzero(difference) > 0;
        const RankedSite& of_a = sites[static_cast<std::size_t>(a.place)];
        const RankedSite& of_b = sites[static_cast<std::size_t>(b.place)];
        // Of equal times the later site's infinitesimal is the greater one.
        if (error == 0.0 && arithmetic != Arithmetic::interval)
            return a.rest != b.rest ? a.rest < b.rest : of_a.rank < of_b.rank;
        if (a.place == b.place) return false;
        const auto addend = [](const RankedSite& site, int side, int factor) {
            return rectangular::Addend{&site, site.rank, side, factor};
        };
        return rectangular::decide_sum<Directions, arithmetic>(
                   difference, false,
                   std::array{addend(of_b, 0, 1), addend(of_b, 1, 1), addend(of_a, 0, -1),
                              addend(of_a, 1, -1)})
                   .sign > 0;
    });
    LargeArray<Index> order(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) order[i] = starts[i].place;
    return order;
}

/// Kernel: an AdditiveKernel over the predicates of these directions.
template <class Directions, Arithmetic arithmetic, class Kernel>
class Sweep {
 public:
    /// `exact_sums`: rectangular::sums_are_exact(sites), for the exact kernel alone.
    Sweep(Topology& topology, Kernel& kernel, std::span<Index> hidden_by, bool exact_sums)
        : topology_(topology),
          kernel_(kernel),
          hidden_by_(hidden_by),
          exact_sums_(exact_sums),
          queue_(Later{this}) {}

    /// Sweeps all sites, given in the order of their starts. `watch` is called with the number of
    /// sites reached so far.
    template <class Watch>
    void run(std::size_t sites, Watch watch) {
        arcs_.reserve(2 * sites + 1);
        for (std::size_t i = 0; i < sites; ++i)
            greatest_error_ = std::max(greatest_error_, forms(static_cast<Index>(i)).error);
        Arc& plane = new_arc(infinite);
        front_.push_back(plane);
        for (std::size_t next = 0;;) {
            while (!queue_.empty() && queue_.top().is_stale()) queue_.pop();
            if (next == sites && queue_.empty()) break;
            ++events_;
            if (queue_.empty() ||
                (next < sites && before(site_event(static_cast<Index>(next)), queue_.top()))) {
                start_wave(static_cast<Index>(next++));
                watch(next);
            } else {
                Arc& arc = *queue_.top().arc;
                const Meeting meeting = queue_.top().meeting();
                queue_.pop();
                end_arc(arc, meeting);
            }
        }
        if (sites > 0) close();
    }

    /// Site and circle events so far.
    [[nodiscard]] std::uint64_t events() const noexcept { return events_; }

 private:
    using Forms = rectangular::RoundedForms<Directions, arithmetic>;
    using Number = typename Forms::Number;
    using Addend = rectangular::Addend;
    static constexpr HalfEdge none = ~HalfEdge{0};
    static constexpr std::uint32_t nobody = ~std::uint32_t{0};

    /// Where an arc's two collision points meet, and what sum of forms is twice that time.
    enum class Meeting : std::uint8_t {
        none,
        moving,       ///< both move: g_1(i) + g_0(k)
        upper_rests,  ///< 2 g_1(i) + g_3(k) - g_2(j)
        lower_rests   ///< 2 g_0(k) + g_2(i) - g_3(j)
    };

    /// An arc of the front, and the collision point at its lower end. A cache line: where many
    /// waves are under way, those that meet next lie far apart in memory.
    struct alignas(64) Arc
        : boost::intrusive::set_base_hook<boost::intrusive::optimize_size<true>> {
        Number edge{};  ///< rises: g_1 of the site below; falls: g_0 of this one
        Number rest{};  ///< twice the height
        Index site = infinite;
        /// Of the one event that counts, in steps of 4; below it two flags of the collision point.
        std::uint32_t stamp_and_flags = 0;
        std::uint32_t below = nobody;  ///< the arcs beside this one, as places in arcs_
        std::uint32_t above = nobody;
        /// The collision point traces the edge whose half-edge `open` is glued already at its other
        /// end; or, while there is `none`, `partner` traces that other end.
        std::uint32_t partner = nobody;
        HalfEdge open = none;

        static constexpr std::uint32_t rising = 1;    ///< with the upper edge of the wave below
        static constexpr std::uint32_t stopping = 2;  ///< at `rest`
        static constexpr std::uint32_t flags = rising | stopping;
        [[nodiscard]] bool rises() const noexcept { return (stamp_and_flags & rising) != 0; }
        [[nodiscard]] bool stops() const noexcept { return (stamp_and_flags & stopping) != 0; }
    };
    static_assert(!std::is_same_v<Number, double> || sizeof(Arc) == 64);

    /// Half a cache line, for the same reason.
    struct Event {
        Number twice_time;
        Index i, j, k;
        std::uint32_t stamp_and_meeting;  ///< meeting none: a site event, of i
        Arc* arc;

        [[nodiscard]] Meeting meeting() const noexcept {
            return static_cast<Meeting>(stamp_and_meeting & Arc::flags);
        }
        [[nodiscard]] bool is_stale() const noexcept {
            return ((stamp_and_meeting ^ arc->stamp_and_flags) & ~Arc::flags) != 0;
        }
    };
    struct Later {
        Sweep* sweep;
        bool operator()(const Event& a, const Event& b) const { return sweep->before(b, a); }
    };

    [[nodiscard]] const RankedSite& site(Index m) const noexcept { return kernel_.site(m); }
    [[nodiscard]] Forms forms(Index m) const noexcept { return Forms(site(m), exact_sums_); }
    [[nodiscard]] Addend addend(int side, Index m, int factor) const noexcept {
        return {&site(m), site(m).rank, side, factor};
    }
    [[nodiscard]] Arc& below(const Arc& arc) noexcept { return arcs_[arc.below]; }
    [[nodiscard]] Arc& above(const Arc& arc) noexcept { return arcs_[arc.above]; }
    [[nodiscard]] std::uint32_t place_of(const Arc& arc) const noexcept {
        return static_cast<std::uint32_t>(&arc - arcs_.data());
    }

    /// The sign of a sum of forms of six sites at most, from its rounded value; `addends` makes it.
    template <class Addends>
    [[nodiscard]] Sign sign(const Number& rounded, Addends addends) {
        // Nearly always the error of the worst sites will do.
        if (filters::exceeds(rounded, 6 * greatest_error_)) [[likely]]
            return kernel_.count({filters::sign_of_nonzero(rounded), Stage::filter});
        return resolve(rounded, addends());
    }
    template <std::size_t count>
    [[nodiscard, gnu::noinline]] Sign resolve(const Number& rounded,
                                              const std::array<Addend, count>& addends) {
        double error = 0.0;
        for (const Addend& addend : addends) error += Forms(*addend.site, exact_sums_).error;
        if (filters::exceeds(rounded, error))
            return kernel_.count({filters::sign_of_nonzero(rounded), Stage::filter});
        return kernel_.count(
            rectangular::decide_sum<Directions, arithmetic>(rounded, exact_sums_, addends));
    }
    /// The sign of g_side(a) - g_side(b).
    [[nodiscard]] Sign compare(int side, Index a, Index b) {
        return sign(forms(a).g[side] - forms(b).g[side], [&] {
            return std::array{addend(side, a, 1), addend(side, b, -1)};
        });
    }

    // ---------------------------------------------------------------- events

    [[nodiscard]] Event site_event(Index q) const noexcept {
        const Forms of_q = forms(q);
        return {of_q.g[0] + of_q.g[1], q, q, q, 0, nullptr};
    }
    [[nodiscard]] Event circle_event(Arc& arc, Meeting meeting) noexcept {
        const Index i = below(arc).site;
        const Index j = arc.site;
        const Index k = above(arc).site;
        const Forms of_i = forms(i);
        const Forms of_k = forms(k);
        Number time = of_i.g[1] + of_k.g[0];
        if (meeting == Meeting::upper_rests)
            time = 2 * of_i.g[1] + (of_k.g[3] - forms(j).g[2]);
        else if (meeting == Meeting::lower_rests)
            time = 2 * of_k.g[0] + (of_i.g[2] - forms(j).g[3]);
        const std::uint32_t stamp = arc.stamp_and_flags & ~Arc::flags;
        return {time, i, j, k, stamp | static_cast<std::uint32_t>(meeting), &arc};
    }
    /// Four forms whose sum, each times the factor, is twice the time of the event; where two would
    /// do, two that cancel out are added.
    void add_time(const Event& e, int factor, Addend* to) const noexcept {
        switch (e.meeting()) {
            case Meeting::none:  // i and k are the site
            case Meeting::moving:
                to[0] = addend(1, e.i, factor);
                to[1] = addend(0, e.k, factor);
                to[2] = addend(0, e.i, factor);
                to[3] = addend(0, e.i, -factor);
                return;
            case Meeting::upper_rests:
                to[0] = to[1] = addend(1, e.i, factor);
                to[2] = addend(3, e.k, factor);
                to[3] = addend(2, e.j, -factor);
                return;
            case Meeting::lower_rests:
                to[0] = to[1] = addend(0, e.k, factor);
                to[2] = addend(2, e.i, factor);
                to[3] = addend(3, e.j, -factor);
                return;
        }
    }
    [[nodiscard]] bool before(const Event& a, const Event& b) {
        return sign(b.twice_time - a.twice_time, [&] {
                   std::array<Addend, 8> addends;
                   add_time(b, 1, addends.data());
                   add_time(a, -1, addends.data() + 4);
                   return addends;
               }) > 0;
    }

    // ---------------------------------------------------------------- collision points

    /// A collision point that moves with one edge, from now on.
    void set_motion(Arc& arc, bool rises) {
        const Index i = below(arc).site;
        const Index j = arc.site;
        const Index leader = rises ? i : j;
        const Forms of_leader = forms(leader);
        arc.edge = of_leader.g[rises ? 1 : 0];
        // It comes to rest where the other tent is the higher one far ahead, on the slope that
        // falls.
        const bool stops =
            i != infinite && j != infinite && (rises ? compare(2, i, j) > 0 : compare(3, j, i) > 0);
        if (stops) {
            const Forms of_other = forms(rises ? j : i);
            arc.rest = rises ? of_other.g[3] - of_leader.g[2] : of_leader.g[3] - of_other.g[2];
        }
        arc.stamp_and_flags = (arc.stamp_and_flags & ~Arc::flags) | (rises ? Arc::rising : 0U) |
                              (stops ? Arc::stopping : 0U);
    }
    /// Whether one collision point rests below another. Both stop.
    [[nodiscard]] bool rests_below(const Arc& a, const Arc& b) {
        return sign(b.rest - a.rest, [&] {
                   return std::array{addend(3, b.site, 1), addend(2, below(b).site, -1),
                                     addend(3, a.site, -1), addend(2, below(a).site, 1)};
               }) > 0;
    }
    /// The sign of the height where the upper edge of i and the lower edge of k meet, less that
    /// where a collision point rests.
    [[nodiscard]] Sign compare_meeting(Index i, Index k, const Arc& arc) {
        return sign((forms(k).g[0] - forms(i).g[1]) - arc.rest, [&] {
            return std::array{addend(0, k, 1), addend(1, i, -1), addend(3, arc.site, -1),
                              addend(2, below(arc).site, 1)};
        });
    }
    /// Whether the start of q, now, lies above a collision point.
    [[nodiscard]] bool is_above(Index q, const Forms& of_q, const Arc& arc) {
        if (arc.below == nobody) return true;
        if (arc.rises()) {
            if (sign(arc.edge - of_q.g[1], [&] {
                    return std::array{addend(1, below(arc).site, 1), addend(1, q, -1)};
                }) > 0)
                return true;
            return arc.stops() && is_above_rest(q, of_q, arc);
        }
        if (sign(of_q.g[0] - arc.edge, [&] {
                return std::array{addend(0, q, 1), addend(0, arc.site, -1)};
            }) < 0)
            return false;
        return !arc.stops() || is_above_rest(q, of_q, arc);
    }
    [[nodiscard]] bool is_above_rest(Index q, const Forms& of_q, const Arc& arc) {
        return sign((of_q.g[0] - of_q.g[1]) - arc.rest, [&] {
                   return std::array{addend(0, q, 1), addend(1, q, -1), addend(3, arc.site, -1),
                                     addend(2, below(arc).site, 1)};
               }) > 0;
    }
    /// The edge that a collision point traces ends at half-edge h.
    void end_edge(Arc& arc, HalfEdge h) noexcept {
        if (arc.open != none) {
            topology_.glue(arc.open, h);
        } else {
            arcs_[arc.partner].open = h;
        }
    }

    // ---------------------------------------------------------------- arcs

    [[nodiscard]] Arc& new_arc(Index site) {
        if (unused_.empty()) {
            Arc& arc = arcs_.emplace_back();
            arc.site = site;
            return arc;
        }
        Arc& arc = *unused_.back();
        unused_.pop_back();
        arc.site = site;
        arc.open = none;
        return arc;
    }
    [[nodiscard]] Arc& insert_above(Arc& arc, Index site) {
        Arc& fresh = new_arc(site);
        fresh.below = place_of(arc);
        fresh.above = arc.above;
        arc.above = place_of(fresh);
        if (fresh.above != nobody) above(fresh).below = arc.above;
        front_.insert_before(std::next(front_.iterator_to(arc)), fresh);
        return fresh;
    }
    /// The arc at the height where q starts.
    [[nodiscard]] Arc& arc_at(Index q) {
        const Forms of_q = forms(q);
        const auto starts_below = [&](Index, const Arc& arc) { return !is_above(q, of_q, arc); };
        return *std::prev(front_.upper_bound(q, starts_below));
    }

    void start_wave(Index q) {
        Arc& lower = arc_at(q);
        const Index j = lower.site;
        if (j != infinite && kernel_.hides(j, q)) {
            hidden_by_[static_cast<std::size_t>(q)] = j;
            return;
        }
        Arc& middle = insert_above(lower, q);
        Arc& upper = insert_above(middle, j);
        middle.partner = place_of(upper);
        upper.partner = place_of(middle);
        set_motion(middle, false);
        set_motion(upper, true);
        schedule(lower);
        schedule(upper);
    }

    void end_arc(Arc& arc, Meeting meeting) {
        Arc& lower = below(arc);
        Arc& upper = above(arc);
        const Index i = lower.site;
        const Index k = upper.site;
        if constexpr (!Kernel::is_exact)
            if (i == k) throw BrokenStructure("a cell has a single neighbour");
        SIGNUM_EXPECTS(i != k);
        const HalfEdge h = Topology::first_edge(topology_.add_face(i, arc.site, k));
        end_edge(arc, h);
        end_edge(upper, h + 1);
        upper.open = h + 2;
        lower.above = arc.above;
        upper.below = arc.below;
        front_.erase(front_.iterator_to(arc));
        arc.stamp_and_flags += Arc::flags + 1;
        unused_.push_back(&arc);

        set_motion(upper, meeting == Meeting::moving ? upper_edge_leads(i, k)
                                                     : meeting == Meeting::upper_rests);
        schedule(lower);
        schedule(upper);
    }
    /// Whether i's tent is the higher one where its upper edge meets k's lower edge: whether i's
    /// centre lies farther ahead. Where neither does, both tents rest there, whichever is said to
    /// lead.
    [[nodiscard]] bool upper_edge_leads(Index i, Index k) {
        if (i == infinite || k == infinite) return k == infinite;
        const Forms of_i = forms(i);
        const Forms of_k = forms(k);
        return sign((of_i.g[1] - of_i.g[2]) - (of_k.g[0] - of_k.g[3]), [&] {
                   return std::array{addend(1, i, 1), addend(2, i, -1), addend(0, k, -1),
                                     addend(3, k, 1)};
               }) >= 0;
    }

    /// Whether and where the two collision points of an arc meet, each the lesser or the greater of
    /// its edge and its rest.
    [[nodiscard]] Meeting meeting(const Arc& arc) {
        const Arc& upper = above(arc);
        if (arc.stops() && upper.stops() && rests_below(arc, upper)) return Meeting::none;
        if (arc.rises() && !upper.rises()) {
            const Index i = below(arc).site;
            const Index k = upper.site;
            if (upper.stops() && compare_meeting(i, k, upper) < 0) return Meeting::upper_rests;
            if (arc.stops() && compare_meeting(i, k, arc) > 0) return Meeting::lower_rests;
            return Meeting::moving;
        }
        if (arc.rises() && upper.stops()) return Meeting::upper_rests;
        if (!upper.rises() && arc.stops()) return Meeting::lower_rests;
        return Meeting::none;
    }
    /// Replaces the event of an arc one of whose collision points is new.
    void schedule(Arc& arc) {
        arc.stamp_and_flags += Arc::flags + 1;
        if (arc.below == nobody || arc.above == nobody) return;
        const Meeting where = meeting(arc);
        if (where != Meeting::none) queue_.push(circle_event(arc, where));
    }

    /// All events are over: the arcs that are left reach infinity, one beside the other.
    void close() {
        Arc& first = above(*front_.begin());
        Arc& top = *front_.rbegin();
        if (first.above == place_of(top)) {
            // One arc. It lies between the two ends of one edge to infinity, if there is one.
            if (first.open != none) topology_.glue(first.open, top.open);
            return;
        }
        HalfEdge last = none;
        for (Arc* lower = &first; lower->above != place_of(top); lower = &above(*lower)) {
            Arc& upper = above(*lower);
            if constexpr (!Kernel::is_exact)
                if (lower->site == infinite || upper.site == infinite)
                    throw BrokenStructure("the front does not close");
            const HalfEdge h =
                Topology::first_edge(topology_.add_face(lower->site, upper.site, infinite));
            end_edge(upper, h);
            if (last == none) {
                end_edge(first, h + 2);
            } else {
                topology_.glue(last, h + 2);
            }
            last = h + 1;
        }
        end_edge(top, last);
    }

    Topology& topology_;
    Kernel& kernel_;
    std::span<Index> hidden_by_;
    bool exact_sums_;
    double greatest_error_ = 0.0;
    std::uint64_t events_ = 0;
    LargeArray<Arc> arcs_;  ///< none ever moves
    std::vector<Arc*> unused_;
    boost::intrusive::set<Arc, boost::intrusive::constant_time_size<false>> front_;
    std::priority_queue<Event, LargeArray<Event>, Later> queue_;
};

}  // namespace signum::triangulation
