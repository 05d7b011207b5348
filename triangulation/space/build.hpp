#pragma once
/// Cells of sites by insertion, by the numbers of the sites in the input. For sources only.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/large_array.hpp"
#include "../../core/pages.hpp"
#include "../../predicates/ccw.hpp"
#include "../structure/watch.hpp"
#include "cells.hpp"
#include "insert.hpp"
#include "triangulate.hpp"

namespace signum::spatial {

[[nodiscard]] inline bool are_collinear(const Point3& a, const Point3& b,
                                        const Point3& c) noexcept {
    return ccw(Point{a.x, a.y}, Point{b.x, b.y}, Point{c.x, c.y}) == 0 &&
           ccw(Point{a.y, a.z}, Point{b.y, b.z}, Point{c.y, c.z}) == 0 &&
           ccw(Point{a.z, a.x}, Point{b.z, b.x}, Point{c.z, c.x}) == 0;
}

/// Even permutations keep the orientation: the one that puts the least of four first, and the least
/// of the others second, by which of them are less than which. Without a branch, for nobody could
/// foretell it.
inline constexpr auto even_orders = [] {
    std::array<std::array<std::uint8_t, 4>, 64> orders{};
    std::array<std::uint8_t, 4> number = {0, 1, 2, 3};  // of each place
    do {
        std::size_t key = 0;
        std::size_t bit = 0;
        for (std::size_t a = 0; a < 4; ++a)
            for (std::size_t b = a + 1; b < 4; ++b)
                key |= static_cast<std::size_t>(number[a] < number[b]) << bit++;
        std::array<std::uint8_t, 4> place{};
        for (std::uint8_t k = 0; k < 4; ++k) place[number[k]] = k;
        const bool is_odd = std::popcount(key) % 2 != 0;
        if (is_odd) std::swap(place[2], place[3]);
        orders[key] = place;
    } while (std::ranges::next_permutation(number).found);
    return orders;
}();
template <class Number>
[[nodiscard, gnu::always_inline]] inline const std::array<std::uint8_t, 4>& even_order_of(
    const std::array<Number, 4>& cell) noexcept {
    const auto is_less = [&](std::size_t a, std::size_t b) {
        return static_cast<std::size_t>(cell[a] < cell[b]);
    };
    return even_orders[is_less(0, 1) | is_less(0, 2) << 1 | is_less(0, 3) << 2 | is_less(1, 2) << 3 |
                       is_less(1, 3) << 4 | is_less(2, 3) << 5];
}

/// A hidden site, and one nearby: who hides it, or the nearest vertex where it would have been.
struct HiddenNear {
    Index site;
    Index near;
};

/// A site and its number in the input, in the order of insertion. Apexes follow the input's.
template <class S>
struct Numbered {
    LargeArray<S> sites;
    LargeArray<Index> numbers;
};

/// What is built of sites.
struct Built {
    Cells cells;                     ///< laws 1 and 2 of SpaceTessellation, but not sorted
    std::vector<Four> room;          ///< memory for as many fours
    std::vector<HiddenNear> hidden;  ///< places in the order; each before those hidden after it
};

/// Flat sites are joined to apexes, one for each dimension that they lack, outside what they span.
///
/// Why that changes nothing: a cell is then one of theirs joined to all apexes. Whether another of
/// them conflicts with it, the sphere of the cell says within what they span, where it is the one
/// of their own cell; the apex's height has the orientation of flat sites for a coefficient, which
/// is 0, and so has its infinitesimal.
template <class S>
class Builder {
 public:
    /// `order`: the numbers of some of the sites, at least one, in the order of insertion. Neither
    /// is copied.
    Builder(std::span<const S> sites, std::span<const Index> order) : sites_(sites), order_(order) {
        choose_first();
    }
    /// How many dimensions the sites lack.
    [[nodiscard]] std::size_t apexes() const noexcept { return 4 - places_.size(); }

    /// Copies the sites in their order, which is no longer needed then.
    void copy_sites() {
        const std::size_t size = order_.size() + apexes();
        auto& [all, numbers] = all_;
        all.reserve(size);
        numbers.reserve(size);
        expect_writes(all);
        expect_writes(numbers);
        // The first four, then the others.
        for (std::size_t k = 0; k < 4; ++k) {
            all.push_back(first_[k]);
            numbers.push_back(k < places_.size()
                                  ? order_[places_[k]]
                                  : static_cast<Index>(sites_.size() + k - places_.size()));
        }
        if (ccw(centre3(first_[0]), centre3(first_[1]), centre3(first_[2]), centre3(first_[3])) <
            0) {
            std::swap(all[0], all[1]);
            std::swap(numbers[0], numbers[1]);
        }
        for (std::size_t place = 0, next = 0; place < order_.size(); ++place) {
            if (next < places_.size() && places_[next] == place) {
                ++next;
                continue;
            }
            all.push_back(site(order_[place]));
            numbers.push_back(order_[place]);
        }
    }
    /// Step: called before each site but for four, with how many came before. Neighbours are named
    /// first_cell | place, by their places among the cells. Precondition: the sites are copied.
    template <class Kernel, class Step>
    [[nodiscard]] Built run(const Step& step, Index first_cell = 0) {
        Built built;
        {
            Kernel kernel(all_.sites, all_.numbers);
            Insertion<Kernel> insertion(kernel, frame_of(std::span<const S>(all_.sites)),
                                        all_.sites.size());
            const auto last = static_cast<Index>(all_.sites.size());
            for (Index q = 4; q < last; ++q) {
                step(q);
                insertion.insert(q, [&](Index v, Index near) {
                    built.hidden.push_back({v, near});
                });
            }
            auto [cells, room] = std::move(insertion).release();
            built.cells = std::move(cells);
            built.room = std::move(room);
        }
        const auto last = static_cast<Index>(built.cells.size());
        for (Index c = 0; c < last; ++c)
            if (!built.cells.is_free(c))
                name(built.cells.vertex(c), built.cells.neighbour(c), first_cell);
        return built;
    }
    /// The sites in the order of insertion, apexes among them.
    [[nodiscard]] Numbered<S> release_sites() && noexcept { return std::move(all_); }
    /// Of one by its place in the order.
    [[nodiscard]] Index number(Index v) const noexcept {
        return all_.numbers[static_cast<std::size_t>(v)];
    }

 private:
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool is_apex(Index v) const noexcept {
        return number(v) >= static_cast<Index>(sites_.size());
    }
    [[nodiscard]] bool is_independent(const S& next) const noexcept {
        const auto at = [&](std::size_t k) { return centre3(first_[k]); };
        const Point3 p = centre3(next);
        switch (first_.size()) {
            case 0:
                return true;
            case 1: {
                const Point3 a = at(0);
                return !(filters::same_number(a.x, p.x) && filters::same_number(a.y, p.y) &&
                         filters::same_number(a.z, p.z));
            }
            case 2:
                return !are_collinear(at(0), at(1), p);
            default:
                return ccw(at(0), at(1), at(2), p) != 0;
        }
    }
    /// The first four sites that span space; where there are not as many, apexes.
    void choose_first() {
        for (std::size_t place = 0; place < order_.size() && first_.size() < 4; ++place) {
            if (!is_independent(site(order_[place]))) continue;
            first_.push_back(site(order_[place]));
            places_.push_back(place);
        }
        while (first_.size() < 4) first_.push_back(apex());
    }
    /// The first site moved along an axis by about as much as the sites extend, toward 0.
    [[nodiscard]] S apex() const {
        double extent = 0.0;
        for (const S& each : first_)
            for (const double x : {each.x, each.y, each.z}) extent = std::max(extent, std::fabs(x));
        const double step = extent > 0.0 ? extent : 1.0;
        for (double S::*const axis : {&S::x, &S::y, &S::z}) {
            S candidate = first_[0];
            candidate.*axis += candidate.*axis > 0.0 ? -step : step;
            if (is_independent(candidate)) return candidate;
        }
        throw std::logic_error("flat sites span space");
    }
    /// Gives a cell the names and the order of the result. One of flat sites loses the apexes; what
    /// is not joined to all of them becomes free.
    void name(Four& cell, Four& neighbour, Index first_cell) const {
        std::size_t size = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Index v = cell[k];
            if (v >= 0 && is_apex(v)) continue;
            cell[size] = v >= 0 ? number(v) : infinite;
            neighbour[size++] = first_cell | neighbour[k];
        }
        for (std::size_t k = size; k < 4; ++k) cell[k] = neighbour[k] = no_vertex;
        if (size + apexes() > 4) {
            cell[0] = Cells::free;
        } else {
            put_in_order(cell, neighbour, size);
        }
    }
    static void put_in_order(Four& cell, Four& neighbour, std::size_t size) {
        if (size < 4) {
            for (std::size_t k = 0; k < size; ++k)
                for (std::size_t m = k; m > 0 && cell[m] < cell[m - 1]; --m) {
                    std::swap(cell[m], cell[m - 1]);
                    std::swap(neighbour[m], neighbour[m - 1]);
                }
            return;
        }
        const auto& [a, b, c, d] = even_order_of(cell);
        cell = {cell[a], cell[b], cell[c], cell[d]};
        neighbour = {neighbour[a], neighbour[b], neighbour[c], neighbour[d]};
    }

    std::span<const S> sites_;
    std::span<const Index> order_;
    std::vector<S> first_;
    std::vector<std::size_t> places_;  // of those of the first that are no apexes, in the order
    Numbered<S> all_;
};

}  // namespace signum::spatial
