/// Two structures of cells of one size, by what they are:
///  * `cells`: in a box, a list of balls for each (thesis 9.4). 3^D cells are asked at a strike,
///    3^(D-1) where a centre enters a cell;
///  * `tree`: only the occupied ones are kept (thesis 9.5), so no bounds are needed. The thesis
///    keeps them in a search tree; here they are hashed.
///
/// No meeting is missed: when two balls touch, their centres are at most the larger diameter apart,
/// so they lie in neighbouring cells or in the same one. Since they were not proposed when they
/// became neighbours, or at the start, or at the last strike of one of them, one of the two has
/// entered a cell since; then it proposes all that lie in the cells that have become its
/// neighbours.
///
/// A centre leaves its cell when it is a margin beyond the side. So it never goes to and fro at one
/// time, as it could at an apex on a side: the way back begins two margins away, and within one
/// tick of the clock it flies less than half a margin (Loop::see_clock). Cells are wider than
/// diameters by a part in 2^20 and three margins: two to leave by, one for what roundings move two
/// places apart, which is less.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../cells.hpp"
#include "../loop.hpp"
#include "../simulation.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Grid {
 public:
    /// `structure`: cells or tree.
    Grid(const World<D>& world, Structure structure)
        : Grid(world, Spread<D>(world), structure == Structure::tree) {}
    Grid(const Grid&) = delete;
    Grid& operator=(const Grid&) = delete;

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        const auto propose_other = [&](Slot j) {
            if (j != i) propose(j);
        };
        const Cell<D>& cell = cell_[i];
        if (is_simple(cell))
            grid_.for_each_row_around(cell, [&](std::uint32_t first) {
                for (std::uint32_t x = 0; x < 3; ++x) table_.for_each_at(first + x, propose_other);
            });
        else
            grid_.for_each_around(
                cell, [&](const Cell<D>& each) { table_.for_each_in(each, propose_other); });
    }

    /// Of all pairs that are near one another each is told once: by the one that lies in the first
    /// cell, or is first in memory.
    template <class Propose>
    void near_once(Slot i, const Propose& propose) const {
        const Cell<D>& cell = cell_[i];
        const auto of_own_cell = [&](Slot j) {
            if (j > i) propose(j);
        };
        if (is_simple(cell)) {
            const std::uint32_t own = grid_.place(cell);
            grid_.for_each_row_around(cell, [&](std::uint32_t first) {
                for (std::uint32_t place = first; place < first + 3; ++place) {
                    if (place > own)
                        table_.for_each_at(place, propose);
                    else if (place == own)
                        table_.for_each_at(place, of_own_cell);
                }
            });
            return;
        }
        grid_.for_each_around(cell, [&](const Cell<D>& each) {
            if (comes_before(cell, each))
                table_.for_each_in(each, propose);
            else if (each == cell)
                table_.for_each_in(each, of_own_cell);
        });
    }

    /// When the centre enters the next cell; infinity where that is after `until`. Which cell that
    /// is is kept until then: at an apex on a side the crossing vanishes when it is computed again.
    [[nodiscard]] double next(Slot i, double now, double until = infinity) {
        Crossing first;
        for (int k = 0; k < D; ++k) {
            if (stays_between_sides(i, k, now, until)) continue;
            const Crossing other = crossing(i, k, now);
            if (other.after < first.after) first = other;
        }
        due_[i] = first;
        return now + first.after;
    }

    template <class Propose, class Touch>
    void own_event(Slot i, double, const Propose& propose, const Touch&) {
        const auto [after, axis, side] = due_[i];
        Cell<D>& cell = cell_[i];
        if (after == infinity || !grid_.shift(cell, axis, side)) return;
        table_.remove(i);
        table_.insert(i, cell);
        grid_.for_each_around(
            cell, [&](const Cell<D>& each) { table_.for_each_in(each, propose); }, axis, side);
    }

    [[nodiscard]] double margin() const noexcept { return margin_; }

    /// The cells in which centres lie.
    void sketch(double, Sketch<D>& sketch) const {
        for (const Cell<D>& cell : cell_) sketch.areas.push_back({grid_.box_of(cell), 0, -1});
    }

 private:
    Grid(const World<D>& world, const Spread<D>& spread, bool hashed)
        : world_(world),
          margin_(spread.margin()),
          grid_(world, spread, width_for(world, spread)),
          table_(grid_, world.balls.size(), hashed),
          cell_(world.balls.size()),
          due_(world.balls.size()) {
        for (Slot i = 0; i < cell_.size(); ++i) {
            cell_[i] = grid_.cell_of(world.centre(i, world.start));
            table_.insert(i, cell_[i]);
        }
    }
    /// Cells far narrower than balls are apart are crossed for nothing.
    [[nodiscard]] static double width_for(const World<D>& world, const Spread<D>& spread) noexcept {
        const double no_wider = world.effects.periodic ? spread.shortest() / 5.0 : infinity;
        return std::max({2.0 * spread.largest_radius * (1.0 + 0x1p-20) + 3.0 * spread.margin(),
                         0x1p-24 * spread.shortest(),
                         std::min(0.8 * spread.edge_of(1.0), no_wider)});
    }

    /// The next side of its cell that a centre comes to, after some time.
    struct Crossing {
        double after = infinity;
        std::int32_t axis = 0;
        std::int32_t side = 0;
    };

    /// Quicker to tell than when it crosses one.
    [[nodiscard]] bool stays_between_sides(Slot i, int k, double now, double until) const {
        if (!(until < infinity) || world_.effects.periodic) return false;
        const double x = world_.centre(i, now)[k];
        const double time = until - now;
        const double way =
            2.0 * time *
            (std::fabs(world_.velocity(i, now)[k]) + std::fabs(world_.effects.gravity[k]) * time);
        return x - grid_.start_of(k, cell_[i][k]) > way &&
               grid_.start_of(k, cell_[i][k] + 1) - x > way;
    }
    [[nodiscard]] Crossing crossing(Slot i, int k, double now) const {
        double x = world_.centre(i, now)[k];
        const double v = world_.velocity(i, now)[k];
        const double g = world_.effects.gravity[k];
        const double start = grid_.start_of(k, cell_[i][k]) - margin_;
        const double end = grid_.start_of(k, cell_[i][k] + 1) + margin_;
        if (world_.effects.periodic)
            x -= world_.length[k] * nearest_integer((x - 0.5 * (start + end)) / world_.length[k]);
        Crossing up{time_to(std::max(end - x, 0.0), v, g), k, 1};
        Crossing down{time_to(std::max(x - start, 0.0), -v, -g), k, -1};
        if (!world_.effects.periodic && grid_.is_bounded()) {
            Cell<D> cell = cell_[i];
            if (!grid_.shift(cell, k, 1)) up.after = infinity;
            cell = cell_[i];
            if (!grid_.shift(cell, k, -1)) down.after = infinity;
        }
        // The outermost cells of an endless grid have no end.
        if (cell_[i][k] >= CellGrid<D>::outermost) up.after = infinity;
        if (cell_[i][k] <= -CellGrid<D>::outermost) down.after = infinity;
        return up.after < down.after ? up : down;
    }
    /// The first time s >= 0 at which v s + g s²/2 rises through `way` >= 0.
    static double time_to(double way, double v, double g) noexcept {
        if (g == 0.0) return v > 0.0 ? way / v : infinity;
        const double square = v * v + 2.0 * g * way;
        if (v > 0.0) return square >= 0.0 ? 2.0 * way / (v + std::sqrt(square)) : infinity;
        return g > 0.0 ? (std::sqrt(square) - v) / g : infinity;
    }

    /// Whether the cells around one are told by places alone: those of most balls, and the quicker
    /// way.
    [[nodiscard]] bool is_simple(const Cell<D>& cell) const noexcept {
        return !table_.is_hashed() && grid_.is_inner(cell);
    }
    /// In the order of places.
    [[nodiscard]] static bool comes_before(const Cell<D>& a, const Cell<D>& b) noexcept {
        for (int k = D - 1; k >= 0; --k)
            if (a[k] != b[k]) return a[k] < b[k];
        return false;
    }

    const World<D>& world_;
    double margin_;
    CellGrid<D> grid_;
    CellTable<D> table_;
    std::vector<Cell<D>> cell_;
    std::vector<Crossing> due_;  // that next() told last
};

SIGNUM_LOOPS_OVER(Grid)

}  // namespace signum::motion
