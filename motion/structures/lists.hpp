#pragma once
/// Two structures of lists of neighbours, as the fastest codes keep them, by the cells that hold
/// them: `lists`: of one size; `levels`: of several, so that a large ball does not ruin small ones
/// (thesis 9.4.2, table 10.4.4).
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
/// Shells lie in the cells of their places, in the finest level whose cells are at least as wide as
/// the shell; each level's are four times as wide as those of the level below. So of its own level
/// and coarser ones 3^D cells hold all whose shells may overlap with a ball's, and of a finer one
/// those within the radius of its shell and half a cell.
///
/// There shells are floats, in units of a cell's width. A shell of radius R, in these units, sees
/// what lies up to R + 2 away; with the operations a difference and a reach err by less than
/// 2^-20 + R 2^-21. By twice that two shells together are thicker. And by the margin, which is far
/// more than places of balls are rounded by, a ball is told to leave its sphere earlier, and its
/// shell is thicker.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "../cells.hpp"
#include "../shells.hpp"
#include "../simulation.hpp"
#include "../sketch.hpp"
#include "../slot_lists.hpp"
#include "../world.hpp"

namespace signum::motion {

template <int D>
class Lists {
 public:
    /// `structure`: lists or levels.
    Lists(const World<D>& world, Structure structure)
        : Lists(world, Spread<D>(world), structure == Structure::levels ? most_levels : 1) {}

    [[nodiscard]] std::span<const Slot> list(Slot i) const noexcept { return lists_[i]; }
    void fetch(Slot i) const noexcept {
        __builtin_prefetch(&centres_[i]);
        lists_.fetch(i);
    }

    /// When the ball leaves its sphere, or earlier.
    [[nodiscard]] double next(Slot i, double now) const {
        const Vector<D> v = world_.velocity(i, now);
        Vector<D> d = world_.centre(i, now) - centres_[i].place;
        const double square = world_.nearest_square(d);
        if (world_.falls) return now + time_falling(d, v);
        const double c = sphere_ * sphere_ - square;
        if (c <= 0.0) return now;
        const double a = dot(v, v);
        const double b = dot(d, v);
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
        levels_[centres_[i].level].shells.remove(centres_[i].list, i);
        enter(i, now);
        for_each_near(i, 0, [&](Slot j) {
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
    /// Whether balls have crowded so that lists should be made anew, with less slack.
    [[nodiscard]] bool is_crowded() const noexcept {
        return lists_.entries() > 2 * most_listed * centres_.size() && slack_ > least_slack_;
    }

    /// The balls' shells, and listed pairs; of several levels the cells in which shells lie. Slots
    /// stand for numbers.
    void sketch(double, Sketch<D>& sketch) const {
        for (Slot i = 0; i < centres_.size(); ++i) {
            const auto& [place, level, list] = centres_[i];
            sketch.rounds.push_back(
                {static_cast<std::int32_t>(i), place, world_.radius(i) + slack_});
            for (const Slot j : lists_[i]) link(sketch, i, j);
            const CellGrid<D>& grid = levels_[level].grid;
            if (levels_.size() > 1)
                sketch.areas.push_back(
                    {grid.box_of(grid.cell_of(place)), static_cast<int>(level), -1});
        }
    }

 private:
    static constexpr int most_levels = 12;
    static constexpr std::size_t most_listed = 32;  // a ball, on average, where that can be
    static constexpr int doublings = 2;             // of the width from a level to the next

    /// Where a ball's shell lies.
    struct Centre {
        Vector<D> place;
        std::uint32_t level;
        std::uint32_t list;  // of the level's shells
    };
    /// Cells of one size, and the shells that lie in them.
    struct Level {
        Level(const CellGrid<D>& cells, std::vector<Slot> balls_then, double largest_then)
            : grid(cells),
              balls(std::move(balls_then)),
              largest(largest_then),
              hashed(!grid.has_few_cells(balls.size())),
              images_are_distinct(grid.images_are_distinct()),
              unit(*std::ranges::max_element(grid.width())),
              shells(hashed ? std::bit_ceil(balls.size() + 1)
                            : static_cast<std::size_t>(grid.size())) {}

        [[nodiscard]] std::uint32_t list_of(const Cell<D>& cell) const noexcept {
            return hashed ? hash_of(cell, shells.size()) : grid.place(cell);
        }

        CellGrid<D> grid;
        std::vector<Slot> balls;
        double largest;  // radius of a shell
        bool hashed;
        bool images_are_distinct;
        double unit;  // of floats
        ShellLists<D> shells;
    };

    Lists(const World<D>& world, const Spread<D>& spread, int most)
        : world_(world),
          margin_(spread.margin()),
          slack_(slack_of(world, spread)),
          least_slack_(least_slack(spread)),
          centres_(world.balls.size()),
          lists_(world.balls.size()),
          leaves_(world.balls.size()) {
        while (!make_lists(spread, most)) slack_ = std::max(0.5 * slack_, least_slack_);
    }

    /// False, before that is done, where they become long and the slack could be less.
    [[nodiscard]] bool make_lists(const Spread<D>& spread, int most) {
        sphere_ = slack_ * (1.0 - 0x1p-20) - margin_;
        levels_.clear();
        add_levels(spread, most);
        lists_ = SlotLists(centres_.size());
        for (Slot i = 0; i < centres_.size(); ++i) enter(i, world_.start);
        for (Slot i = 0; i < centres_.size(); ++i) {
            const std::uint32_t own = centres_[i].level;
            for_each_near(i, own, [&](Slot j) {
                if (centres_[j].level == own && j > i) return;
                lists_.link(i, j);
            });
            if (lists_.entries() > most_listed * centres_.size() && slack_ > least_slack_)
                return false;
        }
        return true;
    }
    void add_levels(const Spread<D>& spread, int most) {
        const double widest = width_for(spread.largest_radius);
        // Cells far narrower than balls are apart are looked into for nothing.
        const double apart = spread.edge_of(0.5) * (slack_ / slack_of(world_, spread));
        const double narrowest =
            std::max({width_for(spread.smallest_radius), apart, 0x1p-20 * widest});
        int number = 1;
        while (number < most && std::ldexp(narrowest, doublings * number) <= widest) ++number;
        const double finest = number == 1 ? std::max(widest, narrowest)
                                          : std::ldexp(widest, doublings * (1 - number));
        std::vector<std::vector<Slot>> members(static_cast<std::size_t>(number));
        for (Slot i = 0; i < centres_.size(); ++i) {
            int level = 0;
            while (level + 1 < number &&
                   std::ldexp(finest, doublings * level) < width_for(world_.radius(i)))
                ++level;
            centres_[i].level = static_cast<std::uint32_t>(level);
            members[centres_[i].level].push_back(i);
        }
        levels_.reserve(members.size());
        for (int level = 0; level < number; ++level) {
            std::vector<Slot>& own = members[static_cast<std::size_t>(level)];
            double largest = 0.0;
            for (const Slot i : own) largest = std::max(largest, radius_of_shell(i));
            levels_.emplace_back(CellGrid<D>(world_, spread, std::ldexp(finest, doublings * level),
                                             1 << doublings * (number - 1 - level)),
                                 std::move(own), largest);
        }
    }
    /// Of a cell in which a ball's shell may lie.
    [[nodiscard]] double width_for(double radius) const noexcept {
        return 2.0 * (radius + slack_ + margin_) * (1.0 + 0x1p-12);
    }
    [[nodiscard]] double radius_of_shell(Slot i) const noexcept {
        return (world_.radius(i) + slack_ + margin_) * (1.0 + 0x1p-20);
    }
    /// Seen from its cell.
    [[nodiscard]] Shell<D> shell_of(Slot i, const Level& level,
                                    const Vector<D>& into) const noexcept {
        Shell<D> shell;
        double farthest = 0.0;
        for (int k = 0; k < D; ++k) {
            farthest = std::max(farthest, std::fabs(into[k] / level.grid.width()[k]));
            shell.into[k] = static_cast<float>(std::clamp(into[k] / level.unit, -0x1p50, 0x1p50));
        }
        // Where the outermost cell has no end, floats tell nothing.
        shell.reach =
            farthest < 2.0
                ? static_cast<float>(radius_of_shell(i) / level.unit * (1.0 + 0x1p-20) + 0x1p-20)
                : std::numeric_limits<float>::infinity();
        shell.ball = i;
        return shell;
    }
    void enter(Slot i, double now) {
        Centre& centre = centres_[i];
        Level& level = levels_[centre.level];
        centre.place = world_.centre(i, now);
        const Vector<D> v = world_.velocity(i, now);
        if (const double ahead = 0.4 * slack_ / norm(v); ahead < infinity)
            centre.place = centre.place + ahead * v;
        const Cell<D> cell = level.grid.cell_of(centre.place);
        centre.list = level.list_of(cell);
        level.shells.insert(centre.list,
                            shell_of(i, level, level.grid.into_cell(centre.place, cell)));
    }

    /// How long a ball that lies so from its place, and falls, surely stays in its sphere: for as
    /// long as it would if it flew straight away from the place, and from there again.
    [[nodiscard]] double time_falling(Vector<D> d, Vector<D> v) const {
        const Vector<D>& g = world_.effects.gravity;
        double time = 0.0;
        for (int step = 0; step < 3; ++step) {
            const double left = sphere_ - norm(d);
            if (left < 0x1p-4 * slack_) break;
            const double s = time_for(v, world_.pull, left);
            d = d + s * (v + 0.5 * s * g);
            v = v + s * g;
            time += s;
        }
        return time;
    }

    /// So that a ball has some neighbours in its list, as those of one size have that are spread
    /// evenly. Where they are not that makes many, and it is halved until they are few.
    static double slack_of(const World<D>& world, const Spread<D>& spread) {
        const double reach = spread.edge_of((D == 2 ? 8.0 : 12.0) / ball_volume<D>(1.0));
        const double radius = spread.mean_radius();
        const double slack = std::max(0.5 * reach - radius, 0.05 * radius);
        // In a periodic box two whose shells overlap are never nearer in another image.
        const double most = world.effects.periodic ? 0.05 * spread.shortest() : infinity;
        return std::max(std::min(slack, most), least_slack(spread));
    }
    [[nodiscard]] static double least_slack(const Spread<D>& spread) noexcept {
        return std::max(0x1p-20 * spread.shortest(), 8.0 * spread.margin());
    }

    /// All others whose shells overlap with a ball's and lie in that level or a coarser one.
    template <class Visit>
    void for_each_near(Slot i, std::uint32_t finest, const Visit& visit) {
        std::size_t size = 0;
        for (std::uint32_t level = finest; level < levels_.size(); ++level)
            if (!levels_[level].balls.empty()) find_near(i, level, size);
        for (std::size_t k = 0; k < size; ++k)
            if (near_[k] != i) visit(near_[k]);
    }
    /// Appends to the first `size` of near_ those of one level.
    void find_near(Slot i, std::uint32_t number, std::size_t& size) {
        const Level& level = levels_[number];
        const Vector<D>& place = centres_[i].place;
        const Cell<D> middle = level.grid.cell_of(place);
        const Vector<D> into = level.grid.into_cell(place, middle);
        const Shell<D> shell = shell_of(i, level, into);
        const double farthest =
            (radius_of_shell(i) + level.largest) * (1.0 + 0x1p-18) + 0x1p-18 * level.unit;
        const auto look = [&](const Cell<D>& cell, const Cell<D>& steps) {
            Shell<D> seen = shell;
            for (int k = 0; k < D; ++k)
                seen.into[k] -= static_cast<float>(steps[k] * level.grid.width()[k] / level.unit);
            if (!level.images_are_distinct) seen.reach = std::numeric_limits<float>::infinity();
            const std::size_t before = size;
            level.shells.find_overlapping(level.list_of(cell), seen, near_, size);
            if (level.hashed || !level.images_are_distinct) [[unlikely]]
                size = confirm(i, level, cell, before, size);
        };
        if (number >= centres_[i].level) {
            level.grid.for_each_around(middle, into, farthest, look);
        } else if (level.grid.number_within(middle, into, farthest) <
                   static_cast<double>(level.balls.size())) {
            level.grid.for_each_within(middle, into, farthest, look);
        } else {
            for (const Slot j : level.balls) {
                if (!overlap(i, j)) continue;
                if (near_.size() == size) near_.resize(2 * size + 16);
                near_[size++] = j;
            }
        }
    }
    [[nodiscard]] bool overlap(Slot i, Slot j) const noexcept {
        Vector<D> d = centres_[i].place - centres_[j].place;
        const double reach = radius_of_shell(i) + radius_of_shell(j);
        return world_.nearest_square(d) < reach * reach;
    }
    /// Of those that were found in a cell keeps the ones that lie there, for several may share a
    /// list, and whose shells overlap with i's in doubles.
    [[nodiscard]] std::size_t confirm(Slot i, const Level& level, const Cell<D>& cell,
                                      std::size_t begin, std::size_t end) {
        std::size_t kept = begin;
        for (std::size_t k = begin; k < end; ++k) {
            const Slot j = near_[k];
            if (level.grid.cell_of(centres_[j].place) == cell && overlap(i, j)) near_[kept++] = j;
        }
        return kept;
    }

    const World<D>& world_;
    double margin_;
    double slack_;
    double least_slack_;
    double sphere_ = 0.0;  // how far from its place a ball may be
    std::vector<Level> levels_;
    LargeArray<Centre, Pages::large> centres_;
    SlotLists lists_;
    // Of an event: the list before it, who of it is not in the new one, and all that are near.
    std::vector<Slot> before_;
    std::vector<std::uint8_t> leaves_;
    std::vector<Slot> near_;
};

}  // namespace signum::motion
