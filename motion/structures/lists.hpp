#pragma once
/// Lists of neighbours, as the fastest codes keep them.
///
/// Each ball's centre lies within a distance, the slack, of a place, and when it is about to leave
/// that sphere it gets a new place, and its list is made anew. Around the place lies the ball's
/// shell, whose radius is the ball's and the slack. Two balls are in each other's lists while their
/// shells overlap: one of them, whose place is the newer one, sees it and tells both, so that they
/// never disagree. So a pair that meets is in the lists. When a list is made those that are new in
/// it are proposed, and at a strike all of the two lists.
///
/// A place is somewhat ahead of where the ball was, so that it stays longer.
///
/// Shells lie in the cells of their places; a cell is at least as wide as two shells are apart, so
/// that 3^D cells hold all whose shells may overlap. There they are floats, in units of the widest
/// cell: a place errs by less than 2^-23, and a difference of two, with the operations, by less
/// than 2^-21; by twice that shells are thicker. And by the margin, which is far more than places
/// of balls are rounded by, a ball is told to leave its sphere earlier, and its shell is thicker.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "../cells.hpp"
#include "../shells.hpp"
#include "../simulation.hpp"
#include "../slot_lists.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Lists {
 public:
    explicit Lists(const World<D>& world, Structure = Structure::lists)
        : Lists(world, Spread<D>(world)) {}

    [[nodiscard]] std::span<const Slot> list(Slot i) const noexcept { return lists_[i]; }
    void fetch(Slot i) const noexcept {
        __builtin_prefetch(&centres_[i]);
        lists_.fetch(i);
    }

    /// When the ball leaves its shell, or earlier.
    [[nodiscard]] double next(Slot i, double now) const {
        const Vector<D> v = world_.velocity(i, now);
        Vector<D> d = world_.centre(i, now);
        for (int k = 0; k < D; ++k) d[k] -= centres_[i].place[k];
        const double flown = world_.nearest_square(d);
        const double c = sphere_ * sphere_ - flown;
        if (c <= 0.0) return now;
        const double a = dot(v, v);
        const double b = dot(d, v);
        if (world_.falls) {
            // Nearer than the slack for as long as speed · s + g s²/2 is below what is left of it.
            const double left = sphere_ - std::sqrt(flown);
            if (left < 0x1p-4 * slack_) return now;
            const double speed = std::sqrt(a);
            return now + 2.0 * left / (speed + std::sqrt(a + 2.0 * world_.pull * left));
        }
        // |d + v s|² = sphere²; of the two forms of the root the one that does not cancel.
        const double root = std::sqrt(b * b + a * c);
        const double s = (b > 0.0 ? c : root - b) / (b > 0.0 ? b + root : a);
        return s < infinity ? now + s * (1.0 - 0x1p-40) : infinity;
    }

    /// Who was in the ball's list and still is has been proposed before, and need not be again.
    template <class Propose, class Touch>
    void own_event(Slot i, double now, const Propose& propose, const Touch&) {
        const auto list = lists_[i];
        before_.assign(list.begin(), list.end());
        for (const Slot j : before_) leaves_[j] = 1;
        lists_.clear(i);
        shells_.remove(centres_[i].list, i);
        enter(i, now);
        for_each_near(i, [&](Slot j) {
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

    [[nodiscard]] double margin() const noexcept { return margin_; }

    /// The balls' shells, and listed pairs; slots stand for numbers.
    void sketch(double, Sketch<D>& sketch) const {
        for (Slot i = 0; i < centres_.size(); ++i) {
            sketch.rounds.push_back(
                {static_cast<std::int32_t>(i), centres_[i].place, world_.radius(i) + slack_});
            for (const Slot j : lists_[i])
                if (i < j)
                    sketch.links.emplace_back(static_cast<std::int32_t>(i),
                                              static_cast<std::int32_t>(j));
        }
    }

 private:
    /// Where a ball's shell lies.
    struct Centre {
        Vector<D> place;
        std::uint32_t list;  // of shells
    };

    Lists(const World<D>& world, const Spread<D>& spread)
        : world_(world),
          margin_(spread.margin()),
          slack_(slack_of(spread)),
          sphere_(slack_ * (1.0 - 0x1p-20) - margin_),
          largest_(spread.largest_radius + slack_ + margin_),
          grid_(world, spread,
                std::max(2.0 * (spread.largest_radius + slack_ + margin_) * (1.0 + 0x1p-12),
                         spread.edge_of(0.5))),
          hashed_(!grid_.has_few_cells(world.balls.size())),
          images_are_distinct_(grid_.images_are_distinct()),
          unit_(*std::ranges::max_element(grid_.width())),
          shells_(hashed_ ? std::bit_ceil(world.balls.size() + 1)
                          : static_cast<std::size_t>(grid_.size())),
          centres_(world.balls.size()),
          lists_(world.balls.size()),
          leaves_(world.balls.size()) {
        for (Slot i = 0; i < centres_.size(); ++i) enter(i, world.start);
        for (Slot i = 0; i < centres_.size(); ++i)
            for_each_near(i, [&](Slot j) {
                if (j > i) return;
                lists_.append(i, j);
                lists_.append(j, i);
            });
    }

    [[nodiscard]] double radius_of_shell(Slot i) const noexcept {
        return (world_.radius(i) + slack_ + margin_) * (1.0 + 0x1p-20);
    }
    [[nodiscard]] std::uint32_t list_of(const Cell<D>& cell) const noexcept {
        return hashed_ ? hash_of(cell, shells_.size()) : grid_.place(cell);
    }
    /// Seen from its cell.
    [[nodiscard]] Shell<D> shell_of(Slot i, const Vector<D>& into) const noexcept {
        Shell<D> shell;
        double farthest = 0.0;
        for (int k = 0; k < D; ++k) {
            farthest = std::max(farthest, std::fabs(into[k] / grid_.width()[k]));
            shell.into[k] = static_cast<float>(std::clamp(into[k] / unit_, -0x1p50, 0x1p50));
        }
        // Where the outermost cell has no end, floats tell nothing.
        shell.reach = farthest < 2.0 ? static_cast<float>(radius_of_shell(i) / unit_ + 0x1p-20)
                                     : std::numeric_limits<float>::infinity();
        shell.ball = i;
        return shell;
    }
    void enter(Slot i, double now) {
        Centre& centre = centres_[i];
        centre.place = world_.centre(i, now);
        const Vector<D> v = world_.velocity(i, now);
        const double speed = std::sqrt(dot(v, v));
        if (const double ahead = 0.4 * slack_ / speed; ahead < infinity)
            for (int k = 0; k < D; ++k) centre.place[k] += ahead * v[k];
        const Cell<D> cell = grid_.cell_of(centre.place);
        centre.list = list_of(cell);
        shells_.insert(centre.list, shell_of(i, grid_.into_cell(centre.place, cell)));
    }

    /// So that a ball has some neighbours in its list.
    static double slack_of(const Spread<D>& spread) {
        constexpr double ball = D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi;
        const double reach = spread.edge_of((D == 2 ? 7.0 : 12.0) / ball);
        const double slack =
            std::max(0.5 * reach - spread.largest_radius, 0.05 * spread.largest_radius);
        return std::max(std::clamp(slack, 0x1p-20 * spread.shortest(), 0.05 * spread.shortest()),
                        8.0 * spread.margin());
    }

    /// All others whose shells overlap with a ball's.
    template <class Visit>
    void for_each_near(Slot i, const Visit& visit) {
        const Vector<D>& place = centres_[i].place;
        const Cell<D> middle = grid_.cell_of(place);
        const Vector<D> into = grid_.into_cell(place, middle);
        const Shell<D> shell = shell_of(i, into);
        const double farthest = radius_of_shell(i) + largest_ * (1.0 + 0x1p-18) + 0x1p-18 * unit_;
        std::size_t size = 0;
        grid_.for_each_around(
            middle, into, farthest, [&](const Cell<D>& cell, const Cell<D>& steps) {
                Shell<D> seen = shell;
                for (int k = 0; k < D; ++k)
                    seen.into[k] -= static_cast<float>(steps[k] * grid_.width()[k] / unit_);
                if (!images_are_distinct_) seen.reach = std::numeric_limits<float>::infinity();
                const std::size_t before = size;
                shells_.find_overlapping(list_of(cell), seen, near_, size);
                if (hashed_ || !images_are_distinct_) [[unlikely]]
                    size = confirm(i, cell, before, size);
            });
        for (std::size_t k = 0; k < size; ++k)
            if (near_[k] != i) visit(near_[k]);
    }
    /// Of those that were found in a cell keeps the ones that lie there, for several may share a
    /// list, and whose shells overlap with i's in doubles.
    [[nodiscard]] std::size_t confirm(Slot i, const Cell<D>& cell, std::size_t begin,
                                      std::size_t end) {
        std::size_t kept = begin;
        for (std::size_t k = begin; k < end; ++k) {
            const Slot j = near_[k];
            const Vector<D>& place = centres_[j].place;
            Vector<D> d;
            for (int axis = 0; axis < D; ++axis) d[axis] = centres_[i].place[axis] - place[axis];
            const double reach = radius_of_shell(i) + radius_of_shell(j);
            if (grid_.cell_of(place) == cell && world_.nearest_square(d) < reach * reach)
                near_[kept++] = j;
        }
        return kept;
    }

    const World<D>& world_;
    double margin_;
    double slack_;
    double sphere_;   // how far from its place a ball may be
    double largest_;  // shell, but for what roundings it is thicker by
    CellGrid<D> grid_;
    bool hashed_;
    bool images_are_distinct_;
    double unit_;  // of floats
    ShellLists<D> shells_;
    LargeArray<Centre, Pages::large> centres_;
    SlotLists lists_;
    // Of an event: the list before it, who of it is not in the new one, and all that are near.
    std::vector<Slot> before_;
    std::vector<std::uint8_t> leaves_;
    std::vector<Slot> near_;
};

}  // namespace signum::motion
