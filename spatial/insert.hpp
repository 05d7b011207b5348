#pragma once
/// Insertion of sites, one after the other: find the cell in which the centre lies, all cells in
/// conflict around it, and join the boundary of these to the site.
///
/// A site whose own cell is in no conflict is hidden. Of those in conflict whatever vertex is on no
/// facet of the boundary becomes hidden.
///
/// A cell with the vertex at infinity is in conflict with a site that lies beyond its facet's
/// plane. In the plane of the facet it is where the finite cell behind the facet is, under the tie
/// rule, too: there the sphere of that cell and the circle of the facet are one, and the fourth
/// vertex has the coefficient 0.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cells.hpp"

namespace signum::spatial {

template <class Kernel>
class Insertion {
 public:
    /// The first four sites turn positively. `sites`: how many there will be.
    Insertion(const Kernel& kernel, std::size_t sites) : kernel_(kernel), on_boundary_(sites, 0) {
        cells_.reserve(7 * sites + 64);
        // A cell and those across its facets, which have the vertex at infinity.
        constexpr std::array<Index, 4> first = {0, 1, 2, 3};
        const Index inner = cells_.add({first, {1, 2, 3, 4}});
        for (std::size_t k = 0; k < 4; ++k) {
            Cell outer{first, {unset, unset, unset, unset}};
            outer.vertex[k] = infinite;
            // Seen from beyond the facet the other three turn the other way.
            std::swap(outer.vertex[(k + 1) % 4], outer.vertex[(k + 2) % 4]);
            for (std::size_t m = 0; m < 4; ++m) {
                const Index v = outer.vertex[m];
                outer.neighbour[m] = v == infinite ? inner : v + 1;
            }
            static_cast<void>(cells_.add(outer));
        }
        conflict_.resize(cells_.size());
    }

    /// False where the site is hidden; `hidden(v)` tells of each that it hides.
    template <class Hidden>
    bool insert(Index q, const Hidden& hidden) {
        const Index home = locate(q);
        if (!conflicts(home, q)) return false;
        find_region(home, q);
        join(q);
        for (const Index c : region_)
            for (const Index v : cells_[c].vertex)
                if (v >= 0 && on_boundary_[static_cast<std::size_t>(v)] != q) {
                    on_boundary_[static_cast<std::size_t>(v)] = q;
                    hidden(v);
                }
        for (const Index c : region_) {
            conflict_[static_cast<std::size_t>(c)] = unknown;
            cells_.remove(c);
        }
        for (const Index c : rim_) conflict_[static_cast<std::size_t>(c)] = unknown;
        return true;
    }

    /// The cell in which a site's centre lies, or one with the vertex at infinity that is in
    /// conflict with it. A walk: across any facet that has the site on its other side. To ask them
    /// in a random order keeps it from going around where sites are tied.
    [[nodiscard]] Index locate(Index q) noexcept {
        Index c = last_;
        if (const int infinity = cells_[c].place_of_infinity(); infinity >= 0)
            c = cells_[c].neighbour[static_cast<std::size_t>(infinity)];
        Index from = unset;
        for (;;) {
            const Cell& cell = cells_[c];
            random_ = random_ * 1664525U + 1013904223U;
            const std::size_t first = random_ >> 30;
            std::size_t k = 0;
            for (; k < 4; ++k) {
                const std::size_t place = (first + k) & 3U;
                if (cell.neighbour[place] == from || side(cell, place, q) >= 0) continue;
                from = c;
                c = cell.neighbour[place];
                break;
            }
            if (k == 4 || cells_[c].place_of_infinity() >= 0) return c;
        }
    }

    [[nodiscard]] const Cells& cells() const noexcept { return cells_; }

 private:
    enum Conflict : std::uint8_t { unknown, in_conflict, in_none };
    /// Of a cell in conflict the facet to one that is in none.
    struct Facet {
        Index cell;
        int place;
    };

    [[nodiscard]] Sign side(const Cell& cell, std::size_t place, Index q) const noexcept {
        std::array<Index, 4> v = cell.vertex;
        v[place] = q;
        return kernel_.ccw(v[0], v[1], v[2], v[3]);
    }
    [[nodiscard]] bool conflicts(Index c, Index q) const noexcept {
        const Cell& cell = cells_[c];
        const int infinity = cell.place_of_infinity();
        if (infinity < 0) [[likely]]
            return kernel_.conflicts(cell.vertex, q);
        const auto place = static_cast<std::size_t>(infinity);
        const Sign sign = side(cell, place, q);
        if (sign != 0) return sign > 0;
        return kernel_.conflicts(cells_[cell.neighbour[place]].vertex, q);
    }

    void find_region(Index home, Index q) {
        conflict_.resize(cells_.size());
        region_.assign(1, home);
        rim_.clear();
        boundary_.clear();
        conflict_[static_cast<std::size_t>(home)] = in_conflict;
        for (std::size_t next = 0; next < region_.size(); ++next) {
            const Index c = region_[next];
            for (int k = 0; k < 4; ++k) {
                const Index n = cells_[c].neighbour[static_cast<std::size_t>(k)];
                std::uint8_t& known = conflict_[static_cast<std::size_t>(n)];
                if (known == unknown) {
                    const bool conflict = conflicts(n, q);
                    known = conflict ? in_conflict : in_none;
                    (conflict ? region_ : rim_).push_back(n);
                }
                if (known == in_none) boundary_.push_back({c, k});
            }
        }
    }

    /// A new cell over each facet of the boundary. Two of them are neighbours across what an edge
    /// of the boundary spans with the site; to find the other one a walk goes around the edge,
    /// through the cells in conflict.
    void join(Index q) {
        new_.clear();
        for (const Facet& facet : boundary_) {
            const auto place = static_cast<std::size_t>(facet.place);
            Cell cell = cells_[facet.cell];
            const Index outer = cell.neighbour[place];
            const int back = cells_[outer].place_of_neighbour(facet.cell);
            cell.vertex[place] = q;
            cell.neighbour = {unset, unset, unset, unset};
            cell.neighbour[place] = outer;
            for (const Index v : cell.vertex)
                if (v >= 0) on_boundary_[static_cast<std::size_t>(v)] = q;
            const Index made = cells_.add(cell);
            cells_[outer].neighbour[static_cast<std::size_t>(back)] = made;
            new_.push_back(made);
        }
        for (std::size_t i = 0; i < boundary_.size(); ++i)
            for (std::size_t k = 0; k < 4; ++k)
                if (cells_[new_[i]].neighbour[k] == unset) link(boundary_[i], new_[i], k);
        last_ = new_.front();
        // New cells are in no conflict that is known.
        conflict_.resize(cells_.size());
    }
    void link(const Facet& facet, Index made, std::size_t across) {
        Index c = facet.cell;
        // The facet that is left through, and its vertex that is not on the edge.
        std::size_t exit = across;
        Index apex = cells_[c].vertex[static_cast<std::size_t>(facet.place)];
        const std::array<Index, 4>& own = cells_[made].vertex;
        for (;;) {
            const Index next = cells_[c].neighbour[exit];
            const Cell& cell = cells_[next];
            // The vertex of the next cell that is not on the facet.
            std::size_t opposite = 0;
            const auto is_on_facet = [&](Index v) {
                if (v == apex) return true;
                for (std::size_t m = 0; m < 4; ++m)
                    if (m != across && m != static_cast<std::size_t>(facet.place) && own[m] == v)
                        return true;
                return false;
            };
            while (is_on_facet(cell.vertex[opposite])) ++opposite;
            if (conflict_[static_cast<std::size_t>(next)] != in_conflict) {
                const Index other = cell.neighbour[opposite];
                cells_[made].neighbour[across] = other;
                cells_[other].neighbour[static_cast<std::size_t>(cells_[other].place_of(apex))] =
                    made;
                return;
            }
            exit = static_cast<std::size_t>(cell.place_of(apex));
            apex = cell.vertex[opposite];
            c = next;
        }
    }

    const Kernel& kernel_;
    Cells cells_;
    Index last_ = 0;
    std::uint32_t random_ = 1;
    std::vector<std::uint8_t> conflict_;
    std::vector<Index> region_;
    std::vector<Index> rim_;
    std::vector<Facet> boundary_;
    std::vector<Index> new_;
    std::vector<Index> on_boundary_;  // the last site that had this vertex on its boundary
};

}  // namespace signum::spatial
