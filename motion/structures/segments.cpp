/// The balls' projections onto each axis, segments, whose ends are kept in order (thesis 9.6).
///
/// Two balls whose boxes overlap on all axes are partners; when two ends of projections change
/// places, the overlap on that axis begins or is over. Balls that touch have overlapping boxes; the
/// overlap on the last axis began with such an event, which proposed the pair, or was there at the
/// start; and at a strike all partners are proposed.
///
/// Ends stand off their balls by a margin that is far more than places are rounded by, so that an
/// exchange which is told too late by a rounding is not too late.
///
/// In a periodic box an axis is a circle, and the first end follows the last one. A ball is at most
/// a quarter as wide as the box, so that two projections overlap in one place, that of the image
/// which is nearest.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "../cells.hpp"
#include "../loop.hpp"
#include "../simulation.hpp"
#include "../slot_lists.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Segments {
 public:
    explicit Segments(const World<D>& world, Structure = Structure::segments)
        : world_(world), partners_(world.balls.size()) {
        const Spread<D> spread(world);
        margin_ = spread.margin();
        for (int k = 0; k < D; ++k) {
            Axis& axis = axes_[k];
            axis.order.resize(2 * world.balls.size());
            std::iota(axis.order.begin(), axis.order.end(), End{0});
            std::ranges::sort(axis.order, [&](End a, End b) {
                const double x = in_box(place(a, k, world.start), k, world.effects);
                const double y = in_box(place(b, k, world.start), k, world.effects);
                return x < y || (x == y && is_upper(a) < is_upper(b));
            });
            axis.rank.resize(axis.order.size());
            for (std::uint32_t r = 0; r < axis.order.size(); ++r) axis.rank[axis.order[r]] = r;
        }
        // Once around to know who lies across the circle's beginning.
        std::vector<Slot> open;
        for (const bool pairs : {false, true}) {
            for (const End end : axes_[0].order) {
                const Slot i = ball_of(end);
                if (is_upper(end)) {
                    std::erase(open, i);
                    continue;
                }
                for (const Slot j : open)
                    if (pairs && are_partners(i, j)) partners_.link(i, j);
                open.push_back(i);
            }
        }
    }

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        for (const Slot j : partners_[i]) propose(j);
    }
    /// When an end of the ball's projections changes places with another one.
    [[nodiscard]] double next(Slot i, double now) const { return now + exchange(i, now).after; }

    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch& touch) {
        const Exchange first = exchange(i, now);
        // The neighbour may have struck something since the exchange was told.
        if (now + first.after > now) return;
        Axis& axis = axes_[first.axis];
        const End a = axis.order[first.rank];
        End& upper = axis.order[after(first.rank)];
        const End b = upper;
        std::swap(axis.order[first.rank], upper);
        std::swap(axis.rank[a], axis.rank[b]);
        const Slot j = ball_of(a) == i ? ball_of(b) : ball_of(a);
        if (is_upper(a) && !is_upper(b)) {
            if (are_partners(i, j)) {
                partners_.link(i, j);
                propose(j);
            }
        } else if (!is_upper(a) && is_upper(b)) {
            partners_.remove(i, j);
            partners_.remove(j, i);
        }
        // It has new neighbours, too.
        touch(j);
    }

    [[nodiscard]] double margin() const noexcept { return margin_; }

    /// The balls' boxes, and partners; slots stand for numbers.
    void sketch(double now, Sketch<D>& sketch) const {
        for (Slot i = 0; i < world_.balls.size(); ++i) {
            Box<D> box;
            for (int k = 0; k < D; ++k) {
                box.low[k] = place(2 * i, k, now);
                box.high[k] = place(2 * i + 1, k, now);
            }
            sketch.areas.push_back({box, 0, static_cast<std::int32_t>(i)});
            for (const Slot j : partners_[i]) link(sketch, i, j);
        }
    }

 private:
    /// 2 · ball, 1 more for the upper end.
    using End = std::uint32_t;
    struct Axis {
        std::vector<End> order;
        std::vector<std::uint32_t> rank;
    };
    struct Exchange {
        double after = infinity;
        int axis = 0;
        std::uint32_t rank = 0;  // of the lower one of the two
    };

    static bool is_upper(End end) noexcept { return end % 2 != 0; }
    static Slot ball_of(End end) noexcept { return end / 2; }

    [[nodiscard]] double place(End end, int k, double now) const noexcept {
        const Ball<D>& ball = world_.balls[ball_of(end)];
        const double x = coordinate(ball, k, now, world_.effects);
        // On a circle two projections end to end are to be wider than gap() takes for nothing.
        const double reach = std::max(world_.radius(ball_of(end)), 3.0 * margin_) + margin_;
        return is_upper(end) ? x + reach : x - reach;
    }
    [[nodiscard]] double speed(End end, int k, double now) const noexcept {
        return motion::speed(world_.balls[ball_of(end)], k, now, world_.effects);
    }
    [[nodiscard]] std::uint32_t ends() const noexcept {
        return 2 * static_cast<std::uint32_t>(world_.balls.size());
    }
    [[nodiscard]] std::uint32_t after(std::uint32_t rank) const noexcept {
        return rank + 1 < ends() ? rank + 1 : 0;
    }
    [[nodiscard]] std::uint32_t before(std::uint32_t rank) const noexcept {
        return rank > 0 ? rank - 1 : ends() - 1;
    }
    /// From one end to the next one up, on a circle less than once around; rounded below 0 it stays
    /// so.
    [[nodiscard]] double gap(double from, double to, int k) const noexcept {
        const double gap = to - from;
        if (!world_.effects.periodic) return gap;
        const double rounded = std::max(0x1p-20, 4.0 * margin_ * world_.inverse_length[k]);
        return gap - world_.length[k] * std::floor(gap * world_.inverse_length[k] + rounded);
    }
    [[nodiscard]] bool are_partners(Slot i, Slot j) const noexcept {
        return std::ranges::all_of(axes_, [&](const Axis& axis) {
            const auto begins_within = [&](Slot inner, Slot outer) {
                const std::uint32_t begin = axis.rank[2 * outer];
                const auto up_from_there = [&](End end) {
                    const std::uint32_t rank = axis.rank[end];
                    return rank >= begin ? rank - begin : rank + ends() - begin;
                };
                return up_from_there(2 * inner) < up_from_there(2 * outer + 1);
            };
            return begins_within(i, j) || begins_within(j, i);
        });
    }
    [[nodiscard]] Exchange exchange(Slot i, double now) const {
        Exchange first;
        for (int k = 0; k < D; ++k) {
            const Axis& axis = axes_[k];
            for (const End end : {2 * i, 2 * i + 1}) {
                const std::uint32_t rank = axis.rank[end];
                const double x = place(end, k, now);
                const double v = speed(end, k, now);
                const auto consider = [&](std::uint32_t lower, double gap, double closing) {
                    const double after = closing > 0.0 ? std::max(gap, 0.0) / closing : infinity;
                    if (after < first.after) first = {after, k, lower};
                };
                if (const End other = axis.order[before(rank)];
                    (rank > 0 || world_.effects.periodic) && ball_of(other) != i)
                    consider(before(rank), gap(place(other, k, now), x, k),
                             speed(other, k, now) - v);
                if (const End other = axis.order[after(rank)];
                    (rank + 1 < ends() || world_.effects.periodic) && ball_of(other) != i)
                    consider(rank, gap(x, place(other, k, now), k), v - speed(other, k, now));
            }
        }
        return first;
    }

    const World<D>& world_;
    double margin_ = 0.0;
    PerAxis<Axis, D> axes_;
    SlotLists partners_;
};

SIGNUM_LOOPS_OVER(Segments)

}  // namespace signum::motion
