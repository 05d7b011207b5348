#pragma once
/// Lists of neighbours, as the fastest codes keep them.
///
/// Each ball has a shell, the place where its list was made and a distance, its slack; and when it
/// has flown that distance its list is made anew. Two balls are in each other's lists while the
/// shells around them overlap: their places are nearer than both radii and both slacks. So a pair
/// that meets is in the lists: each centre is within its slack of its place. When a list is made
/// all near pairs are proposed, and at a strike all of the two lists.
///
/// Places, not balls, lie in cells; a cell is at least as wide as two shells are apart, so that
/// 3^D cells hold all whose shells may overlap.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>
#include <vector>

#include "../cells.hpp"
#include "../simulation.hpp"
#include "../slot_lists.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Lists {
 public:
    explicit Lists(const World<D>& world, Structure = Structure::lists) : Lists(world, Spread<D>(world)) {}

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        for (const Slot j : lists_[i]) propose(j);
    }

    [[nodiscard]] std::span<const Slot> list(Slot i) const noexcept { return lists_[i]; }
    void fetch(Slot i) const noexcept {
        __builtin_prefetch(&places_[i]);
        lists_.fetch(i);
    }

    /// When the ball leaves its shell, or earlier.
    [[nodiscard]] double next(Slot i, double now) const {
        const Vector<D> v = world_.velocity(i, now);
        Vector<D> d = world_.centre(i, now);
        for (int k = 0; k < D; ++k) d[k] -= places_[i][k];
        const double flown = world_.nearest_square(d);
        double gravity = 0.0;
        for (const double g : world_.effects.gravity) gravity += g * g;
        const double c = slack_ * slack_ * (1.0 - 0x1p-20) - flown;
        if (c <= 0.0) return now;
        const double a = dot(v, v);
        const double b = dot(d, v);
        if (gravity > 0.0) {
            // Nearer than the slack for as long as speed · s + g s²/2 is below what is left of it.
            const double left = slack_ * (1.0 - 0x1p-20) - std::sqrt(flown);
            if (left < 0x1p-4 * slack_) return now;
            const double speed = std::sqrt(a);
            return now + 2.0 * left / (speed + std::sqrt(a + 2.0 * std::sqrt(gravity) * left));
        }
        // |d + v s|² = slack²; of the two forms of the root the one that does not cancel.
        const double root = std::sqrt(b * b + a * c);
        const double s = b > 0.0 ? c / (b + root) : (root - b) / a;
        return s < infinity ? now + s * (1.0 - 0x1p-40) : infinity;
    }

    /// Who was in the ball's list and still is has been proposed before, and need not be again.
    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch&) {
        const auto list = lists_[i];
        before_.assign(list.begin(), list.end());
        for (const Slot j : before_) leaves_[j] = 1;
        lists_.clear(i);
        in_cells_.remove_if(cell_[i], [i](const Shell& shell) { return shell.ball == i; });
        const Shell shell = shell_of(i, now);
        enter(shell);
        for_each_near(shell, [&](Slot j) {
            lists_.append(i, j);
            if (leaves_[j] != 0) {
                leaves_[j] = 0;
            } else {
                lists_.append(j, i);
                propose(j);
            }
        });
        for (const Slot j : before_) {
            if (leaves_[j] != 0) lists_.remove(j, i);
            leaves_[j] = 0;
        }
    }

 private:
    struct Shell {
        Vector<D> place;
        float reach;  // radius and slack, or more, as a share of the largest ball's
        Slot ball;
    };

    Lists(const World<D>& world, const Spread<D>& spread)
        : world_(world),
          slack_(slack_of(spread)),
          largest_(spread.largest_radius + slack_),
          grid_(world, spread,
                std::max(2.0 * (spread.largest_radius + slack_) * (1.0 + 0x1p-18),
                         spread.edge_of(0.5))),
          hashed_(!grid_.has_few_cells(world.balls.size())),
          in_cells_(hashed_ ? std::bit_ceil(world.balls.size() + 1)
                            : static_cast<std::size_t>(grid_.size())),
          places_(world.balls.size()),
          cell_(world.balls.size()),
          lists_(world.balls.size()),
          leaves_(world.balls.size()) {
        for (Slot i = 0; i < cell_.size(); ++i) enter(shell_of(i, world.start));
        for (Slot i = 0; i < cell_.size(); ++i)
            for_each_near(shell_of(i, world.start), [&](Slot j) { lists_.append(i, j); });
    }

    [[nodiscard]] Shell shell_of(Slot i, double now) const {
        const double reach = (world_.balls[i].radius + slack_) * (1.0 + 0x1p-20);
        return {world_.centre(i, now), static_cast<float>(reach / largest_), i};
    }
    [[nodiscard]] std::uint32_t list_of(const Cell<D>& cell) const noexcept {
        return hashed_ ? hash_of(cell, in_cells_.size()) : grid_.place(cell);
    }
    void enter(const Shell& shell) {
        const std::uint32_t list = list_of(grid_.cell_of(shell.place));
        in_cells_.append(list, shell);
        cell_[shell.ball] = list;
        places_[shell.ball] = shell.place;
    }

    /// So that a ball has some neighbours in its list.
    static double slack_of(const Spread<D>& spread) {
        constexpr double ball = D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi;
        const double reach = spread.edge_of((D == 2 ? 7.0 : 12.0) / ball);
        const double slack =
            std::max(0.5 * reach - spread.largest_radius, 0.05 * spread.largest_radius);
        return std::clamp(slack, 0x1p-20 * spread.shortest(), 0.05 * spread.shortest());
    }

    /// All whose shells overlap with one, itself left out.
    template <class Visit>
    void for_each_near(const Shell& shell, const Visit& visit) {
        const double farthest = largest_ * (1.0 + static_cast<double>(shell.reach));
        std::size_t size = 0;
        grid_.for_each_around(shell.place, farthest, [&](const Cell<D>& cell) {
            const auto shells = in_cells_[list_of(cell)];
            if (near_.size() < size + shells.size()) near_.resize(2 * (size + shells.size()));
            for (const Shell& other : shells) {
                Vector<D> d;
                for (int k = 0; k < D; ++k) d[k] = shell.place[k] - other.place[k];
                const double reaches = largest_ * static_cast<double>(shell.reach + other.reach);
                bool near = world_.nearest_square(d) < reaches * reaches;
                // Several cells may share a list.
                if (hashed_ && near) near = grid_.cell_of(other.place) == cell;
                // Written and perhaps forgotten: whether it is near is anybody's guess.
                near_[size] = other.ball;
                size += static_cast<std::size_t>(near);
            }
        });
        for (std::size_t k = 0; k < size; ++k)
            if (near_[k] != shell.ball) visit(near_[k]);
    }

    const World<D>& world_;
    double slack_;
    double largest_;
    CellGrid<D> grid_;
    bool hashed_;
    PooledLists<Shell> in_cells_;
    std::vector<Vector<D>> places_;
    std::vector<std::uint32_t> cell_;  // the list that a ball is in
    SlotLists lists_;
    // Of an event: the list before it, who of it is not in the new one, and all that are near.
    std::vector<Slot> before_;
    std::vector<std::uint8_t> leaves_;
    std::vector<Slot> near_;
};

}  // namespace signum::motion
