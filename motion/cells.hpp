#pragma once
/// A grid of cells that hold balls: in a box a table of all cells, elsewhere (or where there would
/// be far more cells than balls) a hash table, in which different cells may share a place.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "world.hpp"

namespace signum::motion {

/// How balls are spread at the start.
template <int D>
struct Spread {
    Box<D> box;
    std::size_t balls = 0;
    double largest_radius = 0.0;

    [[nodiscard]] double volume() const noexcept {
        double volume = 1.0;
        for (int k = 0; k < D; ++k) volume *= box.high[k] - box.low[k];
        return volume;
    }
    /// A slack of shells that gives some neighbours to a ball.
    [[nodiscard]] double slack(double neighbours) const noexcept {
        const double unit = D == 2 ? std::numbers::pi : 4.0 / 3.0 * std::numbers::pi;
        const double space = neighbours * volume() / (static_cast<double>(std::max<std::size_t>(balls, 1)) * unit);
        const double reach = D == 2 ? std::sqrt(space) : std::cbrt(space);
        double least = infinity;
        for (int k = 0; k < D; ++k) least = std::min(least, box.high[k] - box.low[k]);
        const double slack = 0.5 * (reach - 2.0 * largest_radius);
        return std::max(std::min(std::max(slack, 0.05 * largest_radius), 0.05 * least), 0x1p-20 * least);
    }
};

template <int D>
Spread<D> spread_of(const World<D>& world) {
    Spread<D> spread;
    spread.balls = world.balls.size();
    if (world.effects.box) {
        spread.box = *world.effects.box;
    } else {
        spread.box.low.fill(infinity);
        spread.box.high.fill(-infinity);
    }
    for (const Ball<D>& ball : world.balls) {
        spread.largest_radius = std::max(spread.largest_radius, ball.radius);
        if (world.effects.box) continue;
        for (int k = 0; k < D; ++k) {
            spread.box.low[k] = std::min(spread.box.low[k], ball.x[k] - ball.radius);
            spread.box.high[k] = std::max(spread.box.high[k], ball.x[k] + ball.radius);
        }
    }
    if (!world.effects.box) {
        double widest = 0.0;
        for (int k = 0; k < D; ++k) widest = std::max(widest, spread.box.high[k] - spread.box.low[k]);
        if (!(widest > 0.0)) widest = 1.0;
        for (int k = 0; k < D; ++k) spread.box.high[k] = spread.box.low[k] + std::max(spread.box.high[k] - spread.box.low[k], 0.1 * widest);
    }
    return spread;
}

template <int D>
class Cells {
 public:
    Cells(const Spread<D>& spread, double width, const World<D>& world)
        : periodic_(world.effects.periodic), dense_(world.effects.box.has_value()), low_(spread.box.low), links_(spread.balls) {
        std::size_t cells = 1;
        double wide = width;
        if (dense_) {
            // No more than two cells a ball.
            const double unit = D == 2 ? std::sqrt(spread.volume() / (2.0 * static_cast<double>(spread.balls) + 64.0))
                                       : std::cbrt(spread.volume() / (2.0 * static_cast<double>(spread.balls) + 64.0));
            wide = std::max(wide, unit);
        }
        for (int k = 0; k < D; ++k) {
            length_[k] = spread.box.high[k] - spread.box.low[k];
            inverse_length_[k] = 1.0 / length_[k];
            count_[k] = std::max(1, static_cast<int>(std::min(length_[k] / wide, 0x1p20)));
            per_length_[k] = dense_ ? count_[k] / length_[k] : 1.0 / wide;
            cells *= static_cast<std::size_t>(count_[k]);
        }
        if (!dense_) cells = std::bit_ceil(2 * spread.balls + 1);
        heads_.assign(cells, none);
    }

    /// A place in the periodic box, or the place itself.
    [[nodiscard]] Vector<D> wrapped(Vector<D> x) const noexcept {
        if (periodic_)
            for (int k = 0; k < D; ++k)
                x[k] -= length_[k] * std::floor((x[k] - low_[k]) * inverse_length_[k]);
        return x;
    }
    void unwrap(Vector<D>& d) const noexcept {
        if (periodic_)
            for (int k = 0; k < D; ++k)
                d[k] -= length_[k] * nearest_integer(d[k] * inverse_length_[k]);
    }

    void insert(Slot i, const Vector<D>& x) { enter(i, slot_of(cell_of(x))); }
    void move(Slot i, const Vector<D>& x) {
        const std::uint32_t to = slot_of(cell_of(x));
        if (to == links_[i].cell) return;
        leave(i);
        enter(i, to);
    }

    /// All that lie in the 3^D cells around a place, and maybe others.
    template <class Visit>
    void for_each_around(const Vector<D>& x, const Visit& visit) const {
        const std::array<int, D> middle = cell_of(x);
        std::array<int, D> first;
        std::array<int, D> last;
        for (int k = 0; k < D; ++k) {
            first[k] = middle[k] - 1;
            last[k] = middle[k] + 1;
            if (!dense_) continue;
            if (periodic_) {
                if (count_[k] < 3) {
                    first[k] = 0;
                    last[k] = count_[k] - 1;
                }
            } else {
                first[k] = std::max(first[k], 0);
                last[k] = std::min(last[k], count_[k] - 1);
            }
        }
        std::array<int, D> cell = first;
        if (!dense_) {
            // Two cells may share a place: each place once.
            std::array<std::uint32_t, D == 2 ? 9 : 27> places;
            std::size_t number = 0;
            do {
                places[number++] = slot_of(cell);
            } while (step(cell, first, last));
            std::sort(places.begin(), places.begin() + number);
            const auto end = std::unique(places.begin(), places.begin() + number);
            for (auto place = places.begin(); place != end; ++place) visit_cell(*place, visit);
            return;
        }
        do {
            visit_cell(slot_of(cell), visit);
        } while (step(cell, first, last));
    }

 private:
    static constexpr Slot none = ~Slot{0};
    struct Link {
        std::uint32_t cell;
        Slot next;
        Slot previous;
    };

    [[nodiscard]] std::array<int, D> cell_of(const Vector<D>& x) const noexcept {
        std::array<int, D> cell;
        for (int k = 0; k < D; ++k) {
            const double number = std::floor((x[k] - low_[k]) * per_length_[k]);
            cell[k] = static_cast<int>(dense_ ? std::clamp(number, 0.0, double(count_[k] - 1)) : std::clamp(number, -0x1p30, 0x1p30));
        }
        return cell;
    }
    [[nodiscard]] std::uint32_t slot_of(const std::array<int, D>& cell) const noexcept {
        if (dense_) {
            std::size_t slot = 0;
            for (int k = D - 1; k >= 0; --k) {
                int number = cell[k];
                if (number < 0) number += count_[k];
                if (number >= count_[k]) number -= count_[k];
                slot = slot * static_cast<std::size_t>(count_[k]) + static_cast<std::size_t>(number);
            }
            return static_cast<std::uint32_t>(slot);
        }
        std::uint64_t hash = 0;
        for (const int number : cell)
            hash = (hash ^ static_cast<std::uint32_t>(number)) * 0x9E3779B97F4A7C15;
        return static_cast<std::uint32_t>(hash >> 32) & static_cast<std::uint32_t>(heads_.size() - 1);
    }
    static bool step(std::array<int, D>& cell, const std::array<int, D>& first,
                     const std::array<int, D>& last) noexcept {
        for (int k = 0; k < D; ++k) {
            if (cell[k]++ < last[k]) return true;
            cell[k] = first[k];
        }
        return false;
    }
    template <class Visit>
    void visit_cell(std::uint32_t cell, const Visit& visit) const {
        for (Slot j = heads_[cell]; j != none; j = links_[j].next) visit(j);
    }
    void enter(Slot i, std::uint32_t cell) noexcept {
        links_[i] = {cell, heads_[cell], none};
        if (heads_[cell] != none) links_[heads_[cell]].previous = i;
        heads_[cell] = i;
    }
    void leave(Slot i) noexcept {
        const Link& link = links_[i];
        (link.previous == none ? heads_[link.cell] : links_[link.previous].next) = link.next;
        if (link.next != none) links_[link.next].previous = link.previous;
    }

    bool periodic_;
    bool dense_;
    Vector<D> low_;
    Vector<D> length_{};
    Vector<D> inverse_length_{};
    Vector<D> per_length_{};
    std::array<int, D> count_{};
    std::vector<Slot> heads_;
    std::vector<Link> links_;
};

}  // namespace signum::motion
