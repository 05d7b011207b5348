#pragma once
/// Space cut into equal cells, and tables of who lies in which.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "world.hpp"

namespace signum::motion {

/// How balls lie at the start: the box, or else around all of them.
template <int D>
struct Spread {
    Box<D> box;
    std::size_t balls = 0;
    double largest_radius = 0.0;
    double smallest_radius = infinity;
    double sum_of_powers = 0.0;  // of radii, of as many as there are dimensions

    explicit Spread(const World<D>& world) : balls(world.balls.size()) {
        box.low.fill(infinity);
        box.high.fill(-infinity);
        for (Slot i = 0; i < balls; ++i) {
            const double radius = world.radius(i);
            const Vector<D> x = world.centre(i, world.start);
            largest_radius = std::max(largest_radius, radius);
            sum_of_powers += D == 2 ? radius * radius : radius * radius * radius;
            smallest_radius = std::min(smallest_radius, radius);
            for (int k = 0; k < D; ++k) {
                box.low[k] = std::min(box.low[k], x[k] - radius);
                box.high[k] = std::max(box.high[k], x[k] + radius);
            }
        }
        if (world.region) {
            box = *world.region;
            return;
        }
        if (balls == 0) box = {};
        double widest = largest_radius > 0.0 ? largest_radius : 1.0;
        for (const double length : box.lengths()) widest = std::max(widest, length);
        for (int k = 0; k < D; ++k)
            box.high[k] = std::max(box.high[k], box.low[k] + 0x1p-10 * widest);
    }
    /// Of balls all alike that would fill as much.
    [[nodiscard]] double mean_radius() const noexcept {
        const double mean = sum_of_powers / static_cast<double>(std::max<std::size_t>(balls, 1));
        return D == 2 ? std::sqrt(mean) : std::cbrt(mean);
    }
    /// The edge of a cube that has so many balls in it.
    [[nodiscard]] double edge_of(double number) const noexcept {
        // Of balls that have flown apart for long the volume is no double.
        const auto root = [](double x) { return D == 2 ? std::sqrt(x) : std::cbrt(x); };
        double edge = root(number / static_cast<double>(std::max<std::size_t>(balls, 1)));
        for (const double length : box.lengths()) edge *= root(length);
        return edge;
    }
    /// What structures allow for: more than a place is rounded by, that of one far beyond as well,
    /// and than what a ball flies while its event is told late by half the distance of two doubles
    /// (Loop::see_clock). Little beside the distances of balls.
    [[nodiscard]] double margin() const noexcept {
        double farthest = 0.0;
        for (int k = 0; k < D; ++k)
            farthest = std::max({farthest, std::fabs(box.low[k]), std::fabs(box.high[k])});
        return std::max(0x1p-46 * farthest, 0x1p-18 * std::min(edge_of(1.0), shortest()));
    }
    [[nodiscard]] double shortest() const noexcept {
        const Vector<D> lengths = box.lengths();
        return *std::ranges::min_element(lengths);
    }
};

/// A cell, by its numbers along the axes.
template <int D>
using Cell = PerAxis<std::int32_t, D>;

/// Of a table whose size is a power of two.
template <int D>
[[nodiscard]] inline std::uint32_t hash_of(const Cell<D>& cell, std::size_t size) noexcept {
    std::uint64_t hash = 0;
    for (const std::int32_t number : cell)
        hash = (hash ^ static_cast<std::uint32_t>(number)) * 0x9E3779B97F4A7C15;
    return static_cast<std::uint32_t>(hash >> 32) & static_cast<std::uint32_t>(size - 1);
}

/// Which cell a place lies in. Inside a box cells are numbered from 0 and what lies beyond the last
/// one, by rounding, belongs to it; in a periodic one they go around. Elsewhere they have no end.
template <int D>
class CellGrid {
 public:
    /// No cell has a number beyond it.
    static constexpr std::int32_t outermost = 1 << 30;

    /// Cells at least as wide as told, or as the box, `divisions` of which along each axis make one
    /// of the widest that are planned, where there is room for that; so grids of the same spread
    /// whose widths differ by powers of two are nested.
    CellGrid(const World<D>& world, const Spread<D>& spread, double width,
             std::int32_t divisions = 1)
        : bounded_(world.region.has_value()),
          periodic_(world.effects.periodic),
          low_(spread.box.low) {
        for (int k = 0; k < D; ++k) {
            const double length = spread.box.high[k] - spread.box.low[k];
            const double widest = std::floor(length / (width * divisions));
            const double count =
                widest >= 1.0 ? divisions * std::min(widest, 0x1p24) : std::floor(length / width);
            count_[k] = static_cast<std::int32_t>(std::clamp(count, 1.0, 0x1p30));
            width_[k] = bounded_ ? length / count_[k] : width;
            per_width_[k] = 1.0 / width_[k];
        }
    }

    [[nodiscard]] bool is_bounded() const noexcept { return bounded_; }
    /// The number of all cells in a box.
    [[nodiscard]] double size() const noexcept {
        double size = 1.0;
        for (const std::int32_t count : count_) size *= count;
        return size;
    }
    /// Whether there are not far more cells than balls, so that each may have a place in a table.
    [[nodiscard]] bool has_few_cells(std::size_t balls) const noexcept {
        return bounded_ && size() <= 4.0 * static_cast<double>(balls) + 64.0;
    }
    [[nodiscard]] Cell<D> cell_of(const Vector<D>& x) const noexcept {
        Cell<D> cell;
        for (int k = 0; k < D; ++k) {
            const double place = (x[k] - low_[k]) * per_width_[k];
            double number = whole_of(place);
            if (periodic_ && !(number >= 0.0 && number < count_[k]))
                number -= count_[k] * std::floor(number / count_[k]);
            cell[k] = static_cast<std::int32_t>(
                bounded_ ? std::clamp(number, 0.0, static_cast<double>(count_[k] - 1))
                         : std::clamp<double>(number, -outermost, outermost));
        }
        return cell;
    }
    /// How far into its cell a place lies, along each axis; beyond it where cells have an end.
    [[nodiscard]] Vector<D> into_cell(const Vector<D>& x, const Cell<D>& cell) const noexcept {
        Vector<D> into;
        for (int k = 0; k < D; ++k) {
            const double place = (x[k] - low_[k]) * per_width_[k];
            into[k] = (periodic_ ? place - whole_of(place) : place - cell[k]) * width_[k];
        }
        return into;
    }
    [[nodiscard]] const Vector<D>& width() const noexcept { return width_; }
    /// Whether there are at least three along each axis, or no periodic box; then a cell is around
    /// another one in one way.
    [[nodiscard]] bool images_are_distinct() const noexcept {
        return !periodic_ || *std::ranges::min_element(count_) > 2;
    }
    /// The place where a cell begins.
    [[nodiscard]] double start_of(int axis, std::int32_t number) const noexcept {
        return low_[axis] + number * width_[axis];
    }
    [[nodiscard]] Box<D> box_of(const Cell<D>& cell) const noexcept {
        Box<D> box;
        for (int k = 0; k < D; ++k) {
            box.low[k] = start_of(k, cell[k]);
            box.high[k] = start_of(k, cell[k] + 1);
        }
        return box;
    }
    /// Moves a cell's number along an axis; false, and nothing is moved, where there is no such
    /// cell.
    [[nodiscard]] bool shift(Cell<D>& cell, int axis, std::int32_t by) const noexcept {
        std::int32_t number = cell[axis] + by;
        if (bounded_ && !(number >= 0 && number < count_[axis])) {
            if (!periodic_) return false;
            number += number < 0 ? count_[axis] : -count_[axis];
        }
        cell[axis] = number;
        return true;
    }
    /// The cell's number among all of a box.
    [[nodiscard]] std::uint32_t place(const Cell<D>& cell) const noexcept {
        std::uint32_t place = 0;
        for (int k = D - 1; k >= 0; --k)
            place =
                place * static_cast<std::uint32_t>(count_[k]) + static_cast<std::uint32_t>(cell[k]);
        return place;
    }

    /// Whether all cells around one lie in the box, without going around it.
    [[nodiscard]] bool is_inner(const Cell<D>& cell) const noexcept {
        bool is_inner = bounded_;
        for (int k = 0; k < D; ++k) is_inner &= cell[k] > 0 && cell[k] + 1 < count_[k];
        return is_inner;
    }
    /// The places of the cells around one, for which is_inner() holds: three by three, which lie
    /// side by side, told by the first of each.
    template <class Visit>
    void for_each_row_around(const Cell<D>& middle, const Visit& visit) const {
        Cell<D> cell = middle;
        --cell[0];
        for (std::int32_t y = -1; y <= 1; ++y) {
            cell[1] = middle[1] + y;
            if constexpr (D == 2) {
                visit(place(cell));
            } else {
                for (std::int32_t z = -1; z <= 1; ++z) {
                    cell[2] = middle[2] + z;
                    visit(place(cell));
                }
            }
        }
    }

    /// The cells around one, itself included; of an axis that is given those on one side alone. In
    /// a periodic box of fewer than three cells along an axis each of them once.
    template <class Visit>
    void for_each_around(const Cell<D>& middle, const Visit& visit, int axis = -1,
                         std::int32_t side = 0) const {
        Around around;
        for (int k = 0; k < D; ++k) {
            std::int32_t first = periodic_ && count_[k] < 3 ? 0 : -1;
            std::int32_t last = periodic_ && count_[k] < 2 ? 0 : 1;
            if (k == axis) first = last = side;
            for (std::int32_t by = first; by <= last; ++by) around.add(*this, middle, k, by, 0.0);
        }
        around.for_each([&](const Cell<D>& cell, const Cell<D>&) { visit(cell); }, infinity);
    }

    /// Those of them that may have a place within a distance of one, up to the width of a cell;
    /// the place is given by its cell and how far into it it lies. Told with the numbers of cells
    /// from it along the axes.
    template <class Visit>
    void for_each_around(const Cell<D>& middle, const Vector<D>& into, double distance,
                         const Visit& visit) const {
        Around around;
        for (int k = 0; k < D; ++k) {
            const double below = std::max(into[k], 0.0);
            const double above = std::max(width_[k] - into[k], 0.0);
            around.add(*this, middle, k, 0, 0.0);
            if (!periodic_ || count_[k] > 2) around.add(*this, middle, k, -1, below * below);
            if (!periodic_ || count_[k] > 1)
                around.add(*this, middle, k, 1, count_[k] == 2 ? 0.0 : above * above);
        }
        around.for_each(visit, distance * distance * (1.0 + 0x1p-16));
    }
    /// The cells that may have a place within any distance of one, told as above; precondition:
    /// their number is finite.
    template <class Visit>
    void for_each_within(const Cell<D>& middle, const Vector<D>& into, double distance,
                         const Visit& visit) const {
        PerAxis<Range, D> ranges;
        for (int k = 0; k < D; ++k) ranges[k] = range_within(middle, into, distance, k);
        Cell<D> steps{};
        along<D - 1>(ranges, middle, into, distance * distance * (1.0 + 0x1p-16), steps, visit);
    }
    /// How many these are, and some in the corners; infinity where they would meet one another
    /// around a periodic box.
    [[nodiscard]] double number_within(const Cell<D>& middle, const Vector<D>& into,
                                       double distance) const {
        double number = 1.0;
        for (int k = 0; k < D; ++k) {
            const Range range = range_within(middle, into, distance, k);
            const double along = static_cast<double>(range.last) - range.first + 1.0;
            number *= periodic_ && along > count_[k] ? infinity : along;
        }
        return number;
    }

 private:
    struct Range {
        std::int32_t first;
        std::int32_t last;
    };
    /// Numbers of cells from one along an axis.
    [[nodiscard]] Range range_within(const Cell<D>& middle, const Vector<D>& into, double distance,
                                     int axis) const noexcept {
        // The place itself may lie beyond the outermost cell, to which it belongs.
        double first = std::min(std::floor((into[axis] - distance) * per_width_[axis]), 0.0);
        double last = std::max(std::floor((into[axis] + distance) * per_width_[axis]), 0.0);
        if (!periodic_) {
            const double lowest = bounded_ ? 0.0 : -outermost;
            const double highest = bounded_ ? count_[axis] - 1.0 : outermost;
            first = std::max(first, lowest - middle[axis]);
            last = std::min(last, highest - middle[axis]);
        }
        return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(last)};
    }
    template <int axis, class Visit>
    void along(const PerAxis<Range, D>& ranges, const Cell<D>& middle, const Vector<D>& into,
               double square, Cell<D>& steps, const Visit& visit) const {
        for (std::int32_t by = ranges[axis].first; by <= ranges[axis].last; ++by) {
            const double start = by * width_[axis] - into[axis];
            const double away = by > 0 ? start : by < 0 ? -start - width_[axis] : 0.0;
            const double left = square - (away > 0.0 ? away * away : 0.0);
            if (left < 0.0) continue;
            steps[axis] = by;
            if constexpr (axis > 0) {
                along<axis - 1>(ranges, middle, into, left, steps, visit);
            } else {
                Cell<D> cell;
                for (int k = 0; k < D; ++k) {
                    cell[k] = middle[k] + steps[k];
                    if (periodic_)
                        cell[k] += cell[k] < 0 ? count_[k] : cell[k] >= count_[k] ? -count_[k] : 0;
                }
                visit(cell, steps);
            }
        }
    }

    /// The cells around one, along each axis: their numbers, how many cells away, and the square of
    /// the distance.
    struct Around {
        struct Step {
            std::int32_t number;
            std::int32_t by;
            double square;
        };
        PerAxis<PerAxis<Step, 3>, D> steps;
        PerAxis<int, D> size;

        void add(const CellGrid& grid, Cell<D> cell, int axis, std::int32_t by, double square) {
            if (grid.shift(cell, axis, by)) steps[axis][size[axis]++] = {cell[axis], by, square};
        }
        /// Those whose distance is not beyond one.
        template <class Visit>
        void for_each(const Visit& visit, double square) const {
            Cell<D> cell;
            Cell<D> by;
            for_each_along<D - 1>(visit, square, cell, by);
        }
        template <int axis, class Visit>
        void for_each_along(const Visit& visit, double square, Cell<D>& cell, Cell<D>& by) const {
            for (int k = 0; k < size[axis]; ++k) {
                const Step& step = steps[axis][k];
                if (step.square > square) continue;
                cell[axis] = step.number;
                by[axis] = step.by;
                if constexpr (axis == 0)
                    visit(cell, by);
                else
                    for_each_along<axis - 1>(visit, square - step.square, cell, by);
            }
        }
    };

    /// std::floor, which is a call on some processors.
    [[nodiscard]] static double whole_of(double x) noexcept {
        if (!(std::abs(x) < 0x1p62)) return x;
        const auto whole = static_cast<std::int64_t>(x);
        return static_cast<double>(whole -
                                   static_cast<std::int64_t>(static_cast<double>(whole) > x));
    }

    bool bounded_;
    bool periodic_;
    Vector<D> low_;
    Vector<D> width_{};
    Vector<D> per_width_{};
    PerAxis<std::int32_t, D> count_{};
};

/// Who lies in which cell: in a box that has not far more cells than balls a list for each cell,
/// elsewhere a hash table.
template <int D>
class CellTable {
 public:
    CellTable(const CellGrid<D>& grid, std::size_t balls, bool hashed)
        : grid_(&grid),
          hashed_(hashed || !grid.has_few_cells(balls)),
          heads_(hashed_ ? std::bit_ceil(balls + 1) : static_cast<std::size_t>(grid.size()), none),
          links_(balls) {
        if (hashed_) cells_.resize(balls);
    }

    void insert(Slot i, const Cell<D>& cell) {
        const std::uint32_t place = place_of(cell);
        // All other cells are told from those of balls by shifts, which do not leave the box.
        if (place >= heads_.size()) throw std::logic_error("a ball's cell is none of the box");
        links_[i] = {place, heads_[place], none};
        if (heads_[place] != none) links_[heads_[place]].previous = i;
        heads_[place] = i;
        if (hashed_) cells_[i] = cell;
    }
    void remove(Slot i) {
        const Link& link = links_[i];
        (link.previous == none ? heads_[link.place] : links_[link.previous].next) = link.next;
        if (link.next != none) links_[link.next].previous = link.previous;
    }
    [[nodiscard]] bool is_hashed() const noexcept { return hashed_; }
    /// Those in the cell of that place; precondition: the table is not hashed.
    template <class Visit>
    void for_each_at(std::uint32_t place, const Visit& visit) const {
        for (Slot j = heads_[place]; j != none; j = links_[j].next) visit(j);
    }
    template <class Visit>
    void for_each_in(const Cell<D>& cell, const Visit& visit) const {
        for (Slot j = heads_[place_of(cell)]; j != none; j = links_[j].next)
            if (!hashed_ || cells_[j] == cell) visit(j);
    }

 private:
    static constexpr Slot none = ~Slot{0};
    struct Link {
        std::uint32_t place;
        Slot next;
        Slot previous;
    };

    [[nodiscard]] std::uint32_t place_of(const Cell<D>& cell) const noexcept {
        if (!hashed_) return grid_->place(cell);
        return hash_of(cell, heads_.size());
    }

    const CellGrid<D>* grid_;
    bool hashed_;
    std::vector<Slot> heads_;
    std::vector<Link> links_;
    std::vector<Cell<D>> cells_;
};

}  // namespace signum::motion
