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
#include <numbers>
#include <vector>

#include "../cells.hpp"
#include "../slot_lists.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Lists {
 public:
    static constexpr const char* name = "lists";

    explicit Lists(const World<D>& world) : Lists(world, Spread<D>(world)) {}

    template <class Propose>
    void near(Slot i, const Propose& propose) const {
        for (const Slot j : lists_[i]) propose(j);
    }

    /// When the ball leaves its shell, or earlier.
    [[nodiscard]] double next(Slot i, double now) const {
        const Vector<D> v = world_.velocity(i, now);
        Vector<D> d = world_.centre(i, now);
        for (int k = 0; k < D; ++k) d[k] -= shells_[i].place[k];
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

    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch&) {
        for (const Slot j : lists_[i]) lists_.remove(j, i);
        lists_.clear(i);
        Shell& shell = shells_[i];
        shell.place = world_.centre(i, now);
        table_.remove(i);
        table_.insert(i, grid_.cell_of(shell.place));
        for_each_near(i, [&](Slot j) {
            lists_.append(i, j);
            lists_.append(j, i);
            propose(j);
        });
    }

 private:
    struct Shell {
        Vector<D> place;
        double reach;  // radius and slack
    };

    Lists(const World<D>& world, const Spread<D>& spread)
        : world_(world),
          slack_(slack_of(spread)),
          grid_(world, spread,
                std::max(2.0 * (spread.largest_radius + slack_) * (1.0 + 0x1p-30),
                         spread.edge_of(0.5))),
          table_(grid_, world.balls.size(), false),
          shells_(world.balls.size()),
          lists_(world.balls.size()) {
        for (Slot i = 0; i < shells_.size(); ++i) {
            shells_[i] = {world.centre(i, world.start),
                          (world.balls[i].radius + slack_) * (1.0 + 0x1p-30)};
            table_.insert(i, grid_.cell_of(shells_[i].place));
        }
        for (Slot i = 0; i < shells_.size(); ++i)
            for_each_near(i, [&](Slot j) { lists_.append(i, j); });
    }

    /// So that a ball has some neighbours in its list.
    static double slack_of(const Spread<D>& spread) {
        constexpr double ball = D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi;
        const double reach = spread.edge_of((D == 2 ? 7.0 : 12.0) / ball);
        const double slack =
            std::max(0.5 * reach - spread.largest_radius, 0.05 * spread.largest_radius);
        return std::clamp(slack, 0x1p-20 * spread.shortest(), 0.05 * spread.shortest());
    }

    template <class Visit>
    void for_each_near(Slot i, const Visit& visit) const {
        const Shell shell = shells_[i];
        const auto look = [&](Slot j) {
            const Shell& other = shells_[j];
            Vector<D> d;
            for (int k = 0; k < D; ++k) d[k] = shell.place[k] - other.place[k];
            const double reach = shell.reach + other.reach;
            if (world_.nearest_square(d) < reach * reach && j != i) visit(j);
        };
        grid_.for_each_around(grid_.cell_of(shell.place),
                              [&](const Cell<D>& cell) { table_.for_each_in(cell, look); });
    }

    const World<D>& world_;
    double slack_;
    CellGrid<D> grid_;
    CellTable<D> table_;
    std::vector<Shell> shells_;
    SlotLists lists_;
};

}  // namespace signum::motion
