#pragma once
/// Three structures of cells, by what they are:
///  * `cells`: of one size, in a box, a list of balls for each (thesis 9.4). 3^D cells are asked at
///    a strike, 3^(D-1) where a centre enters a cell;
///  * `tree`: of one size, of which only the occupied ones are kept (thesis 9.5), so no bounds are
///    needed. The thesis keeps them in a search tree; here they are hashed;
///  * `levels`: of several sizes, each a power of two above the next, so that a large ball does not
///    ruin small ones (thesis 9.4.2, table 10.4.4).
///
/// Each level has cells a power of two times as wide as those of the level below, nested. A ball
/// lives in the level whose cells are just as wide as its diameter, or wider; it visits the cells
/// of all coarser levels in which its centre lies.
///
/// No meeting is missed: let a live in level k and b in level l >= k. When they touch, their
/// centres are at most the larger diameter apart, so they lie in neighbouring cells of level l or
/// in the same one. Since they were not proposed when they became neighbours there, or at the
/// start, or at the last strike of one of them, one of the two has entered a cell of level l since;
/// then b, which lives there, proposes all that live in or visit the cells that have become its
/// neighbours, and a, which visits, all that live there.
///
/// A crossing is told in rounded numbers; cells are wider than diameters by a part in 2^20 and a
/// margin, and what roundings move two places apart is less (Loop::see_clock).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../cells.hpp"
#include "../simulation.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Grid {
 public:
    /// `structure`: cells, tree or levels.
    Grid(const World<D>& world, Structure structure)
        : world_(world), cell_(world.balls.size()), level_(world.balls.size()) {
        const int most_levels = structure == Structure::levels ? 24 : 1;
        const bool hashed = structure == Structure::tree;
        const Spread<D> spread(world);
        margin_ = spread.margin();
        const double widest =
            std::max(width_for(spread.largest_radius, spread), 0x1p-24 * spread.shortest());
        const double no_wider = world.effects.periodic ? spread.shortest() / 5.0 : infinity;
        // Cells far narrower than balls are apart are crossed for nothing.
        const double narrowest =
            std::max({width_for(spread.smallest_radius, spread),
                      std::min(0.8 * spread.edge_of(1.0), no_wider), 0x1p-20 * widest});
        int number = 1;
        while (number < most_levels && std::ldexp(narrowest, number) <= widest) ++number;
        const double finest =
            number == 1 ? std::max(widest, narrowest) : std::ldexp(widest, 1 - number);
        grids_.reserve(static_cast<std::size_t>(number));
        for (int level = 0; level < number; ++level) {
            grids_.emplace_back(world, spread, std::ldexp(finest, level),
                                1 << (number - 1 - level));
            all_.emplace_back(grids_.back(), world.balls.size(), hashed);
            if (level > 0) residents_.emplace_back(grids_.back(), world.balls.size(), hashed);
        }
        for (Slot i = 0; i < cell_.size(); ++i) {
            int level = 0;
            while (level + 1 < number &&
                   std::ldexp(finest, level) < width_for(world.radius(i), spread))
                ++level;
            level_[i] = static_cast<std::uint8_t>(level);
            cell_[i] = grids_[level_[i]].cell_of(world.centre(i, world.start));
            if (level_[i] > 0) residents_[level_[i] - 1U].insert(i, cell_[i]);
            for (std::size_t at = level_[i]; at < grids_.size(); ++at)
                all_[at].insert(i, cell_above(i, at));
        }
    }
    Grid(const Grid&) = delete;
    Grid& operator=(const Grid&) = delete;

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        near_cells(i, cell_[i], propose, -1, 0);
        for (std::size_t above = level_[i] + 1U; above < grids_.size(); ++above)
            residents_near(above, cell_above(i, above), propose, -1, 0);
    }

    /// Of all pairs that are near one another each is told once: by the one that lives in the
    /// coarser level, for these are few, or in the first cell of a level, or is first in memory.
    template <class Propose>
    void near_once(Slot i, const Propose& propose) const {
        const std::size_t level = level_[i];
        const Cell<D>& cell = cell_[i];
        const auto of_own_cell = [&](Slot j) {
            if (level_[j] < level || j > i) propose(j);
        };
        const auto of_cell_before = [&](Slot j) {
            if (level_[j] < level) propose(j);
        };
        const CellTable<D>& table = all_[level];
        if (is_simple(level, cell)) {
            const std::uint32_t own = grids_[level].place(cell);
            grids_[level].for_each_row_around(cell, [&](std::uint32_t first) {
                for (std::uint32_t place = first; place < first + 3; ++place) {
                    if (place > own)
                        table.for_each_at(place, propose);
                    else if (place == own)
                        table.for_each_at(place, of_own_cell);
                    else if (level > 0)
                        table.for_each_at(place, of_cell_before);
                }
            });
            return;
        }
        grids_[level].for_each_around(cell, [&](const Cell<D>& each) {
            if (comes_before(cell, each))
                table.for_each_in(each, propose);
            else if (each == cell)
                table.for_each_in(each, of_own_cell);
            else
                table.for_each_in(each, of_cell_before);
        });
    }

    /// When the centre enters the next cell of its level; infinity where that is after `until`.
    [[nodiscard]] double next(Slot i, double now, double until = infinity) const {
        double s = infinity;
        for (int k = 0; k < D; ++k)
            if (!stays_between_sides(i, k, now, until)) s = std::min(s, crossing(i, k, now).after);
        return now + s;
    }

    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch&) {
        int axis = 0;
        Crossing first = crossing(i, 0, now);
        for (int k = 1; k < D; ++k) {
            const Crossing other = crossing(i, k, now);
            if (other.after < first.after) {
                first = other;
                axis = k;
            }
        }
        const Cell<D> before = cell_[i];
        Cell<D> after = before;
        const std::size_t level = level_[i];
        if (!grids_[level].shift(after, axis, first.side)) return;
        move(all_[level], i, after);
        if (level > 0) move(residents_[level - 1], i, after);
        cell_[i] = after;
        near_cells(i, after, propose, axis, first.side);
        for (std::size_t above = level + 1; above < grids_.size(); ++above) {
            const Cell<D> from = divided(before, above - level);
            const Cell<D> to = divided(after, above - level);
            if (from == to) break;
            move(all_[above], i, to);
            residents_near(above, to, propose, axis, first.side);
        }
    }

    [[nodiscard]] double margin() const noexcept { return margin_; }

    /// The cells in which balls live, each once.
    void sketch(double, Sketch<D>& sketch) const {
        std::vector<std::array<std::int32_t, D + 1>> occupied;
        for (Slot i = 0; i < cell_.size(); ++i) {
            std::array<std::int32_t, D + 1> numbers{level_[i]};
            std::ranges::copy(cell_[i], numbers.begin() + 1);
            occupied.push_back(numbers);
        }
        std::ranges::sort(occupied);
        occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
        for (const auto& numbers : occupied) {
            Box<D> box;
            for (int k = 0; k < D; ++k) {
                const CellGrid<D>& grid = grids_[static_cast<std::size_t>(numbers[0])];
                const std::int32_t number = numbers[static_cast<std::size_t>(k) + 1];
                box.low[k] = grid.start_of(k, number);
                box.high[k] = grid.start_of(k, number + 1);
            }
            sketch.areas.push_back({box, numbers[0], -1});
        }
    }

 private:
    [[nodiscard]] static double width_for(double radius, const Spread<D>& spread) noexcept {
        return 2.0 * radius * (1.0 + 0x1p-20) + spread.margin();
    }

    /// The next side of its cell that a centre comes to, after some time.
    struct Crossing {
        double after = infinity;
        std::int32_t side = 0;
    };

    /// Quicker to tell than when it crosses one.
    [[nodiscard]] bool stays_between_sides(Slot i, int k, double now, double until) const {
        if (!(until < infinity) || world_.effects.periodic) return false;
        const CellGrid<D>& grid = grids_[level_[i]];
        const double x = world_.centre(i, now)[k];
        const double time = until - now;
        const double way =
            2.0 * time *
            (std::fabs(world_.velocity(i, now)[k]) + std::fabs(world_.effects.gravity[k]) * time);
        return x - grid.start_of(k, cell_[i][k]) > way &&
               grid.start_of(k, cell_[i][k] + 1) - x > way;
    }
    [[nodiscard]] Crossing crossing(Slot i, int k, double now) const {
        const CellGrid<D>& grid = grids_[level_[i]];
        double x = world_.centre(i, now)[k];
        const double v = world_.velocity(i, now)[k];
        const double g = world_.effects.gravity[k];
        const double start = grid.start_of(k, cell_[i][k]);
        const double end = grid.start_of(k, cell_[i][k] + 1);
        if (world_.effects.periodic) {
            const double length = world_.effects.box->high[k] - world_.effects.box->low[k];
            x -= length * nearest_integer((x - 0.5 * (start + end)) / length);
        }
        Crossing up{time_to(std::max(end - x, 0.0), v, g), 1};
        Crossing down{time_to(std::max(x - start, 0.0), -v, -g), -1};
        if (!world_.effects.periodic && grid.is_bounded()) {
            Cell<D> cell = cell_[i];
            if (!grid.shift(cell, k, 1)) up.after = infinity;
            cell = cell_[i];
            if (!grid.shift(cell, k, -1)) down.after = infinity;
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

    [[nodiscard]] static Cell<D> divided(Cell<D> cell, std::size_t times) noexcept {
        for (std::int32_t& number : cell) number >>= times;
        return cell;
    }
    [[nodiscard]] Cell<D> cell_above(Slot i, std::size_t above) const noexcept {
        return divided(cell_[i], above - level_[i]);
    }
    /// Whether the cells around one are told by places alone: those of most balls, and the quicker
    /// way.
    [[nodiscard]] bool is_simple(std::size_t level, const Cell<D>& cell) const noexcept {
        return !all_[level].is_hashed() && grids_[level].is_inner(cell);
    }
    /// Those of a level's table in the cells around one; where an axis is given, of one side.
    template <class Visit>
    void for_each_around(const CellTable<D>& table, std::size_t level, const Cell<D>& cell,
                         const Visit& visit, int axis, std::int32_t side) const {
        if (axis < 0 && is_simple(level, cell))
            grids_[level].for_each_row_around(cell, [&](std::uint32_t first) {
                for (std::uint32_t x = 0; x < 3; ++x) table.for_each_at(first + x, visit);
            });
        else
            grids_[level].for_each_around(
                cell, [&](const Cell<D>& each) { table.for_each_in(each, visit); }, axis, side);
    }
    template <class Propose>
    void near_cells(Slot i, const Cell<D>& cell, const Propose& propose, int axis,
                    std::int32_t side) const {
        const auto propose_others = [&](Slot j) {
            if (j != i) propose(j);
        };
        for_each_around(all_[level_[i]], level_[i], cell, propose_others, axis, side);
    }
    template <class Propose>
    void residents_near(std::size_t level, const Cell<D>& cell, const Propose& propose, int axis,
                        std::int32_t side) const {
        for_each_around(residents_[level - 1], level, cell, propose, axis, side);
    }
    /// In the order of places.
    [[nodiscard]] static bool comes_before(const Cell<D>& a, const Cell<D>& b) noexcept {
        for (int k = D - 1; k >= 0; --k)
            if (a[k] != b[k]) return a[k] < b[k];
        return false;
    }
    static void move(CellTable<D>& table, Slot i, const Cell<D>& to) {
        table.remove(i);
        table.insert(i, to);
    }

    const World<D>& world_;
    double margin_ = 0.0;
    std::vector<CellGrid<D>> grids_;
    std::vector<CellTable<D>> all_;        // of each level those that live there or visit
    std::vector<CellTable<D>> residents_;  // of all levels but the finest
    std::vector<Cell<D>> cell_;            // in the level where the ball lives
    std::vector<std::uint8_t> level_;
};

}  // namespace signum::motion
