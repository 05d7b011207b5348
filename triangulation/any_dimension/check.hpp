#pragma once
/// The check of power tessellations in any dimension, of plane and space among them, whoever made
/// them.
///
/// Why it suffices, the centres spanning k >= 1 dimensions:
///  1. Every cell has k+1 different vertices, and its neighbours agree about their common facets;
///     every site is a vertex or hidden, not both. So facets are glued in pairs.
///  2. The centres lie in a flat of k dimensions: every one has the orientation 0 with k+1 that
///     span such a flat, along each further axis. Finite cells turn positively, so that there are
///     no fewer dimensions. Across a facet cells turn alike: so two finite ones lie on the two
///     sides of its hyperplane, and the sum of all finite ones has the hull's facets for its
///     border.
///  3. Let p be the middle of one finite cell, the base. No vertex of the base lies beyond a hull's
///     facet, and not all in its hyperplane, for the base is not flat, nor is the facet, being one
///     of a finite cell: so p lies strictly within. And no facet of the hull has the other vertex
///     of a neighbour there beyond its hyperplane.
///  4. No other finite cell contains p. So the sum of all covers p once, and its border, the hull,
///     winds around p once. All its facets turn the same side to p: so each direction from p meets
///     one of them, and the hull is the border of a star around p. The function that is 1 on it and
///     grows in proportion along the rays from p is linear over each facet and convex across the
///     border of any two (3). A continuous function that is convex across each wall between the
///     parts on which it is linear is convex, for it is so along all lines that meet none but
///     walls, and these are dense. So the hull is convex. How many cells contain a place changes
///     nowhere but at the hull: one does within, none outside, and neither a second layer nor cells
///     that turn twice around a common face are possible. The cells triangulate what the hull
///     encloses.
///  5. Across every facet the neighbour's other vertex is not in conflict. So the function that is
///     |x|² - w at the vertices and linear over cells is convex, by the same argument. (Facets of
///     the hull that lie in one hyperplane need no look of their own: the cells behind them do.)
///  6. The centre of a hidden site lies in a cell, and the site is not in conflict with it. So it
///     is not below the function, which therefore is the lower hull of all lifted sites: this is
///     what a power tessellation is.
///  7. No visible site is nearer to a hidden one's centre than the one that it names.
///  8. With ties the same holds of the tie rule's infinitesimals, which make all inequalities
///     strict and leave but one tessellation: where one is right without and wrong with them, the
///     arrays are valid, not canonical.
/// In one place (k = 0) one site hides the others. Conversely every one of these holds for a power
/// tessellation, so that nothing right is refused.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../exact/floating_environment.hpp"
#include "../structure/judgement.hpp"
#include "../structure/spatial_order.hpp"
#include "few.hpp"
#include "near_sites.hpp"
#include "questions.hpp"

namespace signum::any_dimension {

/// What is judged: the arrays of a SpaceTessellation, of a TessellationOf<D> or of the plane.
template <int D>
struct ArraysOf {
    int dimension;
    std::int64_t sites;
    std::span<const CellOf<D>> cells;
    std::span<const CellOf<D>> neighbours;
    std::span<const Hidden> hidden;
};

using triangulation::at;
using triangulation::Invalid;
using triangulation::name;
using triangulation::Seen;

/// All but the order of the arrays. CellName: a function from a cell's number to what messages call
/// it. Asked: Questions<S, a judge's numbers>.
template <class S, class CellName, class Asked = Questions<S, exact::Dyadic>>
class Check : private triangulation::Judgement {
 public:
    static constexpr int D = Asked::D;

    Check(const ArraysOf<D>& arrays, std::span<const S> sites, const CellName& cell_name,
          const ValidationOptions& options)
        : Judgement(options, passes * arrays.cells.size() + arrays.hidden.size(),
                    std::max(arrays.cells.size(), arrays.hidden.size())),
          arrays_(arrays),
          sites_(sites),
          cell_name_(cell_name),
          cells_(arrays.cells),
          neighbours_(arrays.neighbours),
          asked_(sites) {}

    [[nodiscard]] Validation run() {
        Validation result = judgement([this] {
            check_counts();
            check_cells();
            triangulation::see_hidden(arrays_.hidden, seen_);
            triangulation::check_seen(arrays_.hidden, seen_);
            if (arrays_.dimension == 0) check_one_place();
            if (arrays_.dimension > 0) {
                check_neighbours();
                check_dimension();
                check_orientations();
                check_turns();
                check_hull();
                check_cover();
                check_facets();
                check_hidden();
            }
        });
        result.filtered = filtered_ + passed_;
        result.multiprecision = exact_;
        return result;
    }

 private:
    using Cell = typename Asked::Cell;
    static constexpr std::size_t passes = 5;

    [[nodiscard]] Index cells() const noexcept { return static_cast<Index>(cells_.size()); }
    /// What messages call a facet.
    [[nodiscard]] std::string facet() const { return arrays_.dimension == 2 ? "edge" : "facet"; }
    /// k + 1.
    [[nodiscard]] std::size_t size() const noexcept { return at(arrays_.dimension) + 1; }
    [[nodiscard]] std::size_t place_of(Index v, const Cell& among) const noexcept {
        std::size_t place = 0;
        while (place < size() && among[place] != v) ++place;
        return place;
    }
    [[nodiscard]] bool is_infinite(Index c) const noexcept {
        return place_of(infinite, cells_[at(c)]) < size();
    }
    /// Where the vertex of a neighbour is that the cell lacks.
    [[nodiscard]] std::size_t place_beyond(const Cell& cell, const Cell& beyond) const noexcept {
        std::size_t place = 0;
        while (place < size() && place_of(beyond[place], cell) < size()) ++place;
        return place;
    }
    /// What is asked of one range of a loop, and noted.
    struct Part : triangulation::Notes {
        Asked questions;
        Asked of_ties;  ///< asked as long as nothing is noted
    };
    [[nodiscard]] Part fresh() const { return {notes(), asked_, asked_}; }
    void merge(const Part& part) noexcept {
        filtered_ += part.questions.filtered_count();
        exact_ += part.questions.exact_count();
        // Where something was noted in a range before, nobody would have asked.
        if (!is_canonical()) return;
        filtered_ += part.of_ties.filtered_count();
        exact_ += part.of_ties.exact_count();
    }
    /// judge(part, c) for each cell; see judge_each().
    template <class Judge>
    void judge_cells(std::size_t advances, const Judge& judge) {
        this->judge_each(
            cells_.size(), advances, fresh(),
            [&](Part& part, std::size_t c) { judge(part, static_cast<Index>(c)); },
            [this](const Part& part) { merge(part); });
    }
    /// judge(part), on one thread.
    template <class Judge>
    void judge_once(const Judge& judge) {
        this->judge_each(
            1, 0, fresh(), [&](Part& part, std::size_t) { judge(part); },
            [this](const Part& part) { merge(part); });
    }
    [[nodiscard]] Sign orientation_with(Part& part, Cell cell, std::size_t place, Index v) const {
        cell[place] = v;
        return part.questions.orientation(cell);
    }

    // ---- numbers ------------------------------------------------------------------------------

    void check_counts() const {
        const auto n = static_cast<std::int64_t>(sites_.size());
        if (arrays_.sites != n)
            throw Invalid{"the tessellation speaks of " + std::to_string(arrays_.sites) +
                          " sites, the input has " + std::to_string(n)};
        const int k = arrays_.dimension;
        if (k < -1 || k > D || (k == -1) != (n == 0))
            throw Invalid{std::to_string(n) + " sites do not span " + std::to_string(k) +
                          " dimensions"};
        if (cells_.size() > at(std::numeric_limits<Index>::max()))
            throw Invalid{"there are more than 2^31 cells"};
        if (cells_.empty() != (n == 0))
            throw Invalid{cells_.empty() ? "there is no cell" : "there are cells, but no site"};
        if (neighbours_.size() != cells_.size())
            throw Invalid{"there are " + std::to_string(cells_.size()) + " cells, but " +
                          std::to_string(neighbours_.size()) + " tuples of neighbours"};
    }
    /// Each number of a cell is infinity's or a site's, and there once.
    void check_cells() {
        seen_.resize(sites_.size(), Seen::nowhere);
        const auto n = static_cast<std::int64_t>(sites_.size());
        judge_cells(1, [&](Part&, Index c) {
            const Cell& cell = cells_[at(c)];
            for (std::size_t i = 0; i < cell.size(); ++i) {
                if (i >= size()) {
                    if (cell[i] != no_vertex)
                        throw Invalid{cell_name_(c) + " has more than " + std::to_string(size()) +
                                      " vertices"};
                    continue;
                }
                if (cell[i] < infinite || cell[i] >= n)
                    throw Invalid{cell_name_(c) + ": there is no site " + std::to_string(cell[i])};
                if (place_of(cell[i], cell) != i)
                    throw Invalid{cell_name_(c) + " has " + name(cell[i]) + " twice"};
                if (cell[i] != infinite) triangulation::see_vertex(seen_[at(cell[i])]);
            }
        });
    }
    /// Whether facets are glued in pairs.
    void check_neighbours() {
        judge_cells(1, [&](Part&, Index c) {
            const Cell& cell = cells_[at(c)];
            for (std::size_t i = 0; i < cell.size(); ++i) {
                const Index n = neighbours_[at(c)][i];
                if (i >= size()) {
                    if (n != no_vertex)
                        throw Invalid{cell_name_(c) + " has more than " + std::to_string(size()) +
                                      " neighbours"};
                    continue;
                }
                const auto across = [&] {
                    return cell_name_(c) + ", across from " + name(cell[i]) + ": ";
                };
                if (n < 0 || n >= cells() || n == c)
                    throw Invalid{across() + cell_name_(n) + " is no neighbour"};
                const Cell& beyond = cells_[at(n)];
                const std::size_t back = place_beyond(cell, beyond);
                bool share = back < size();
                for (std::size_t m = 0; m < size(); ++m)
                    share &= m == i || place_of(cell[m], beyond) < size();
                if (!share)
                    throw Invalid{across() + cell_name_(n) + " does not share the " + facet()};
                if (neighbours_[at(n)][back] != c)
                    throw Invalid{across() + cell_name_(n) + " has another neighbour there"};
            }
        });
    }

    // ---- one place ----------------------------------------------------------------------------

    void check_one_place() {
        if (cells() != 2 || is_infinite(0) == is_infinite(1))
            throw Invalid{"one visible site has a cell and infinity another"};
        for (Index c = 0; c < 2; ++c)
            for (std::size_t i = 0; i < cells_[0].size(); ++i)
                if (neighbours_[at(c)][i] != (i == 0 ? 1 - c : no_vertex))
                    throw Invalid{cell_name_(c) + " and the other one are not neighbours"};
        const Index one = cells_[is_infinite(0) ? 1 : 0][0];
        for (Index q = 0; at(q) < sites_.size(); ++q) {
            if (q == one) continue;
            if (!have_one_centre(sites_[at(q)], sites_[at(one)]))
                throw Invalid{name(q) + " and " + name(one) + " are not in one place"};
            if (filters::compare_numbers(power::weight_key(sites_[at(q)]),
                                         power::weight_key(sites_[at(one)])) > 0)
                throw Invalid{name(one) + " does not hide " + name(q)};
            if (asked_.precedes(q, one)) note("by the tie rule " + name(q) + " hides " + name(one));
        }
    }

    // ---- places -------------------------------------------------------------------------------

    /// The axes along which the sites of flat ones are told apart. Precondition: there is a cell.
    void check_dimension() {
        base_ = 0;
        while (base_ < cells() && is_infinite(base_)) ++base_;
        if (base_ == cells()) throw Invalid{"there is no finite cell"};
        if (arrays_.dimension == D) return;
        judge_once([this](Part& part) { find_axes(part); });
        judge_once([this](Part& part) { turn_flat_cells(part); });
    }
    void find_axes(Part& part) {
        const auto k = at(arrays_.dimension);
        const Cell& base = cells_[at(base_)];
        Axes<D> axes;
        for (std::size_t set = 0; set < std::size_t{1} << D; ++set) {
            if (static_cast<std::size_t>(std::popcount(set)) != k) continue;
            axes.count = 0;
            for (std::size_t axis = 0; axis < at(D); ++axis)
                if ((set >> axis & 1) != 0) axes.axis[axes.count++] = axis;
            if (part.questions.orientation(base, axes) != 0) break;
            axes.count = 0;
        }
        if (axes.count == 0) throw Invalid{cell_name_(base_) + " is flat"};
        asked_.ask_along(axes);
        for (Index q = 0; at(q) < sites_.size(); ++q)
            for (std::size_t axis = 0; axis < at(D); ++axis) {
                if (axes.has(axis)) continue;
                Axes<D> more = axes;
                more.axis[more.count++] = axis;
                Cell with_q = base;
                with_q[k + 1] = q;
                if (part.questions.orientation(with_q, more) != 0)
                    throw Invalid{name(q) +
                                  (k == 1 ? " does not lie on the line of "
                                          : " does not lie in the flat of dimension " +
                                                std::to_string(k) + " of ") +
                                  cell_name_(base_)};
            }
    }
    /// Cells of flat sites have no orientation of their own: one is chosen for each, by which
    /// finite ones turn positively and those at infinity away from the base.
    void turn_flat_cells(Part& part) {
        turned_cells_.assign(cells_.begin(), cells_.end());
        turned_neighbours_.assign(neighbours_.begin(), neighbours_.end());
        for (Index c = 0; c < cells(); ++c) {
            const std::size_t place = place_of(infinite, cells_[at(c)]);
            Sign sign = 0;
            if (place == size()) {
                sign = part.questions.orientation(cells_[at(c)]);
            } else {
                for (std::size_t m = 0; m < size() && sign == 0; ++m)
                    sign = -orientation_with(part, cells_[at(c)], place, cells_[at(base_)][m]);
            }
            if (sign >= 0) continue;
            std::swap(turned_cells_[at(c)][0], turned_cells_[at(c)][1]);
            std::swap(turned_neighbours_[at(c)][0], turned_neighbours_[at(c)][1]);
        }
        cells_ = turned_cells_;
        neighbours_ = turned_neighbours_;
    }

    /// Finite cells turn positively. For a base a small one is taken, as few others are near it.
    void check_orientations() {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        struct Smallest : Part {
            double least;
            Index cell;
        };
        double least = infinity;
        const auto judge = [&](Smallest& part, std::size_t i) {
            const auto c = static_cast<Index>(i);
            if (is_infinite(c)) return;
            const Sign sign = part.questions.orientation(cells_[i]);
            if (sign <= 0)
                throw Invalid{cell_name_(c) + (sign == 0 ? " is flat" : " turns the wrong way")};
            double extent = 0.0;
            for (std::size_t axis = 0; axis < at(D); ++axis) {
                const auto [low, high] = range(c, axis);
                extent += high - low;
            }
            if (extent >= part.least) return;
            part.least = extent;
            part.cell = c;
        };
        this->judge_each(cells_.size(), 1, Smallest{fresh(), infinity, base_}, judge,
                         [&](const Smallest& part) {
                             merge(part);
                             if (part.least >= least) return;
                             least = part.least;
                             base_ = part.cell;
                         });
    }
    /// The least and the greatest coordinate of a finite cell.
    [[nodiscard]] std::pair<double, double> range(Index c, std::size_t axis) const noexcept {
        const Cell& cell = cells_[at(c)];
        double low = coordinate(sites_[at(cell[0])], axis);
        double high = low;
        for (std::size_t m = 1; m < size(); ++m) {
            const double x = coordinate(sites_[at(cell[m])], axis);
            low = std::min(low, x);
            high = std::max(high, x);
        }
        return {low, high};
    }

    /// Across a facet cells turn alike: with the vertex beyond in the place of the one across from
    /// it, the cell is an odd permutation of its neighbour.
    void check_turns() {
        judge_cells(0, [this](Part&, Index c) {
            for (std::size_t i = 0; i < size(); ++i) {
                const Index n = neighbours_[at(c)][i];
                if (n < c) continue;
                const Cell& beyond = cells_[at(n)];
                Cell cell = cells_[at(c)];
                cell[i] = beyond[place_beyond(cell, beyond)];
                std::array<std::size_t, static_cast<std::size_t>(D) + 1> places{};
                for (std::size_t m = 0; m < size(); ++m) places[m] = place_of(cell[m], beyond);
                if (sort_few(size(), places))
                    throw Invalid{cell_name_(c) + " and " + cell_name_(n) +
                                  " lie on the same side of their " + facet()};
            }
        });
    }

    void check_hull() {
        const Cell base = cells_[at(base_)];
        judge_cells(1, [&](Part& part, Index c) {
            const Cell& cell = cells_[at(c)];
            const std::size_t place = place_of(infinite, cell);
            if (place == size()) return;
            const auto keep_within = [&](Index v) {
                if (orientation_with(part, cell, place, v) > 0)
                    throw Invalid{name(v) + " lies beyond the hull's " + facet() + " of " +
                                  cell_name_(c)};
            };
            for (std::size_t m = 0; m < size(); ++m) keep_within(base[m]);
            for (std::size_t m = 0; m < size(); ++m) {
                if (m == place) continue;
                const Cell& beyond = cells_[at(neighbours_[at(c)][m])];
                keep_within(beyond[place_beyond(cell, beyond)]);
            }
        });
    }

    /// The middle of the base lies in no other cell.
    void check_cover() {
        std::array<std::pair<double, double>, static_cast<std::size_t>(D)> base_range;
        for (std::size_t axis = 0; axis < at(D); ++axis) base_range[axis] = range(base_, axis);
        const auto is_near = [&](Index c) {
            for (std::size_t axis = 0; axis < at(D); ++axis) {
                const auto [low, high] = range(c, axis);
                if (high < base_range[axis].first || low > base_range[axis].second) return false;
            }
            return true;
        };
        judge_cells(0, [&](Part& part, Index c) {
            if (c != base_ && !is_infinite(c) && is_near(c) && holds_middle_of_base(part, c))
                throw Invalid{cell_name_(c) + " and " + cell_name_(base_) + " overlap"};
        });
    }
    [[nodiscard]] bool holds_middle_of_base(Part& part, Index c) const {
        for (std::size_t i = 0; i < size(); ++i)
            if (part.questions.orientation_with_middle(cells_[at(c)], i, cells_[at(base_)]) < 0)
                return false;
        return true;
    }

    // ---- conflicts ----------------------------------------------------------------------------

    void judge(Part& part, Index c, Index q) const {
        const Sign sign = part.questions.in_sphere(cells_[at(c)], q);
        if (sign < 0) return;
        const auto why = [&] { return name(q) + " is in conflict with " + cell_name_(c); };
        if (sign > 0) throw Invalid{why()};
        if (part.is_canonical() && part.of_ties.tie_conflicts(cells_[at(c)], q))
            part.note("by the tie rule " + why());
    }
    /// Each facet once: from the smaller of its cells.
    void check_facets() {
        judge_cells(1, [this](Part& part, Index c) {
            if (is_infinite(c)) return;
            for (std::size_t i = 0; i < size(); ++i) {
                const Index n = neighbours_[at(c)][i];
                if (n < c || is_infinite(n)) continue;
                const Cell& beyond = cells_[at(n)];
                judge(part, c, beyond[place_beyond(cells_[at(c)], beyond)]);
            }
        });
    }

    void check_hidden() {
        if (!arrays_.hidden.empty()) judge_once([this](Part& part) { check_hidden(part); });
    }
    void check_hidden(Part& part) {
        std::vector<Index> cell_of(sites_.size(), infinite);
        for (Index c = 0; c < cells(); ++c)
            if (!is_infinite(c))
                for (std::size_t m = 0; m < size(); ++m) cell_of[at(cells_[at(c)][m])] = c;
        std::vector<Index> visible;
        for (Index i = 0; at(i) < sites_.size(); ++i)
            if (seen_[at(i)] == Seen::as_vertex) visible.push_back(i);
        const NearSites<S> near(sites_, std::move(visible), this->workers());
        Index last = infinite;
        Index c = infinite;
        for (const auto& [q, by] : hidden_in_order()) {
            check_nearest(part, q, by, near);
            const bool is_other = std::exchange(last, by) != by;
            if (is_plane()) {
                if (is_other) sort_star(by, cell_of[at(by)]);
                c = cell_that_holds(part, q, cell_toward(by, q), c);
            } else {
                c = cell_that_holds(part, q, is_other ? cell_of[at(by)] : c, infinite);
            }
            judge(part, c, q);
            advance();
        }
    }
    /// Those of one site together; in the plane, where these may be very many, along a curve.
    [[nodiscard]] std::vector<Hidden> hidden_in_order() const {
        std::vector<Hidden> result(arrays_.hidden.begin(), arrays_.hidden.end());
        if constexpr (power::PowerSite<S>) {
            std::vector<Point> centres;
            for (const Hidden& hidden : result)
                centres.push_back(power::centre(sites_[at(hidden.site)]));
            std::ranges::transform(triangulation::spatial_order(centres, 1), result.begin(),
                                   [this](Index i) { return arrays_.hidden[at(i)]; });
        } else {
            std::ranges::sort(result, {}, &Hidden::site);
        }
        std::ranges::stable_sort(result, {}, &Hidden::by);
        return result;
    }
    [[nodiscard]] bool is_plane() const noexcept { return D == 2 && arrays_.dimension == 2; }
    /// The directions of the edges at a site of the plane, rounded, with the cells on their left:
    /// where a walk from the site starts, which may start anywhere.
    void sort_star(Index v, Index cell_of_v) {
        star_.clear();
        Index c = cell_of_v;
        do {
            const std::size_t next = (place_of(v, cells_[at(c)]) + 1) % size();
            if (!is_infinite(c)) star_.emplace_back(direction(v, cells_[at(c)][next]), c);
            c = neighbours_[at(c)][next];
        } while (c != cell_of_v);
        std::ranges::sort(star_);
    }
    [[nodiscard]] Index cell_toward(Index v, Index q) const {
        const auto after = std::ranges::upper_bound(star_, std::pair(direction(v, q), cells()));
        return (after == star_.begin() ? star_.back() : *(after - 1)).second;
    }
    [[nodiscard]] double direction(Index from, Index to) const {
        return std::atan2(offset<double>(sites_[at(to)], sites_[at(from)], 1),
                          offset<double>(sites_[at(to)], sites_[at(from)], 0));
    }
    void check_nearest(Part& part, Index q, Index by, const NearSites<S>& near) {
        const auto ask = [&](Index v) {
            if (v == by) return;
            const Sign sign = part.questions.nearer(q, v, by);
            if (sign > 0)
                throw Invalid{name(q) + " is said to be hidden by " + name(by) + ", but " +
                              name(v) + " is nearer"};
            if (sign == 0 && asked_.precedes(v, by))
                part.note("by the tie rule " + name(q) + " is hidden by " + name(v) + ", not " +
                          name(by));
        };
        passed_ += near.template visit_near<Asked::is_filtered>(sites_[at(q)], sites_[at(by)], ask);
    }
    /// A finite cell with the centre of q in it. By chance out of one of the facets that have it on
    /// the other side: where ties are decided otherwise than by the rule a walk that always takes
    /// the first may go in circles. What is not a few steps away is looked for from `other`, if
    /// there is one.
    [[nodiscard]] Index cell_that_holds(Part& part, Index q, Index start, Index other) {
        constexpr std::size_t few = 4;
        Index c = start;
        for (std::size_t steps = 0; steps < 2 * cells_.size() + 1000; ++steps) {
            if (steps == few && other != infinite) c = other;
            chance_ = chance_ * 6364136223846793005U + 1442695040888963407U;
            const std::size_t first = (chance_ >> 33) % size();
            const Index next = way_to(part, q, c, first);
            if (next == c) return c;
            if (is_infinite(next))
                throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
            c = next;
        }
        for (c = 0; c < cells(); ++c)
            if (!is_infinite(c) && way_to(part, q, c, 0) == c) return c;
        throw Invalid{name(q) + " is said to be hidden, but lies outside the hull"};
    }
    /// The neighbour on the side of q, or the cell itself where it holds it.
    [[nodiscard]] Index way_to(Part& part, Index q, Index c, std::size_t first) const {
        for (std::size_t m = 0; m < size(); ++m) {
            const std::size_t i = (first + m) % size();
            if (orientation_with(part, cells_[at(c)], i, q) < 0) return neighbours_[at(c)][i];
        }
        return c;
    }

    const ArraysOf<D>& arrays_;
    std::span<const S> sites_;
    const CellName& cell_name_;
    // Those of the arrays, or turned ones.
    std::span<const Cell> cells_;
    std::span<const Cell> neighbours_;
    std::vector<Cell> turned_cells_;
    std::vector<Cell> turned_neighbours_;
    Asked asked_;  // a copy for each part: itself it is asked nothing that counts
    std::vector<Seen> seen_;
    Index base_ = 0;
    std::vector<std::pair<double, Index>> star_;  // of the site that hides, in the plane
    std::uint64_t filtered_ = 0;                  // questions that filters decided
    std::uint64_t exact_ = 0;                     // and exact numbers
    std::uint64_t passed_ = 0;                    // and intervals
    std::uint64_t chance_ = 1;
};

/// Where the arrays of a valid tessellation are not in canonical order; empty if they are.
template <int D>
[[nodiscard]] std::string first_out_of_order(const ArraysOf<D>& arrays) {
    const auto size = at(arrays.dimension) + 1;
    const auto& given = arrays.cells;
    for (std::size_t c = 0; c < given.size(); ++c) {
        const std::size_t free = arrays.dimension == D ? 1 : 0;
        bool rises = true;
        for (std::size_t m = 1; m < size; ++m)
            rises &= m + free == size ? m < 2 || given[c][m - 2] < given[c][m]
                                      : given[c][m - 1] < given[c][m];
        if (!rises) return "cell " + std::to_string(c) + ": its numbers are not in canonical order";
        if (c > 0 && given[c] < given[c - 1])
            return "cell " + std::to_string(c) + " is not in canonical order";
    }
    return std::ranges::is_sorted(arrays.hidden, {}, &Hidden::site)
               ? ""
               : "the hidden sites are not in canonical order";
}

/// T: SpaceTessellation or TessellationOf<D>. Throws std::invalid_argument for a site that is not
/// finite.
template <class S, class T>
[[nodiscard]] Validation check(const T& tessellation, std::span<const S> sites,
                               const ValidationOptions& options) {
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!is_finite(sites[i]))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
    const exact::IeeeEnvironment environment;
    const ArraysOf<dimension_of<S>> arrays{tessellation.dimension, tessellation.sites,
                                           tessellation.cells, tessellation.neighbours,
                                           tessellation.hidden};
    const auto cell_name = [](Index c) { return "cell " + std::to_string(c); };
    Validation result = Check(arrays, sites, cell_name, options).run();
    if (result.canonical) {
        result.message = first_out_of_order(arrays);
        result.canonical = result.message.empty();
    }
    return result;
}

}  // namespace signum::any_dimension
