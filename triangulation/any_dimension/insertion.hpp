#pragma once
/// Site by site into a tessellation of k dimensions: find a cell in conflict, all that are
/// connected with it, and join their boundary to the site.
///
/// Laws between insertions:
///  1. vertex i of a cell lies across its facet i, as neighbour i does; with the vertex at infinity
///     the cells have no boundary;
///  2. a cell without it turns positively, one with it does so for every place that the hull's
///     facet separates from the sites;
///  3. the cells are those of the tie rule's tessellation of the sites inserted so far.
///
/// Why it is right. Cells are the lower hull of the lifted sites, which under the tie rule is
/// simplicial. A site below it sees the facets that conflict, which are connected, and the new ones
/// join it to their boundary. A site above it is hidden for ever. The hull's facet whose hyperplane
/// holds the site asks the finite cell behind it: in that hyperplane both say the same. A walk
/// toward a site comes to an end, for the tessellation is regular.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "few.hpp"
#include "questions.hpp"

namespace signum::any_dimension {

template <class S>
class Insertion {
 public:
    using Asked = Questions<S, exact::Rational>;
    using Cell = typename Asked::Cell;
    static constexpr Index free = -3;

    /// The first cell, of k+1 sites that turn positively, and those between it and infinity.
    Insertion(Asked& questions, std::size_t sites, const Cell& first)
        : questions_(questions), size_(questions.dimension() + 1), last_met_(sites, 0) {
        vertices_.push_back(first);
        neighbours_.push_back(unset());
        for (std::size_t i = 0; i < size_; ++i) {
            // Infinity in the place of a vertex lies on the other side.
            Cell cell = first;
            cell[i] = infinite;
            const std::size_t other = i == 0 ? 1 : 0;
            std::swap(cell[i], cell[other]);
            vertices_.push_back(cell);
            neighbours_.push_back(unset());
        }
        connect_all();
        mark_.resize(vertices_.size(), 0);
    }

    /// False where the site is hidden; otherwise `hide` is told which are so from now on.
    template <class Hide>
    bool insert(Index q, Hide hide) {
        const Index start = locate(q);
        ++round_;
        if (!conflicts(start, q)) return false;
        find_region(start, q);
        join_boundary(q);
        for (const Index c : region_)
            for (std::size_t i = 0; i < size_; ++i) {
                const Index v = vertices(c)[i];
                if (v < 0 || std::exchange(last_met_[at(v)], round_) == round_) continue;
                hide(v);
            }
        for (const Index c : region_) {
            vertices(c)[0] = free;
            free_.push_back(c);
        }
        return true;
    }

    [[nodiscard]] const std::vector<Cell>& all_vertices() const noexcept { return vertices_; }
    [[nodiscard]] const std::vector<Cell>& all_neighbours() const noexcept { return neighbours_; }

 private:
    /// A facet of a new cell: its vertices but the site, sorted.
    struct Side {
        std::array<Index, Asked::D> vertices;
        Index cell;
        std::size_t place;
        friend bool operator<(const Side& a, const Side& b) { return a.vertices < b.vertices; }
    };

    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    [[nodiscard]] static Cell unset() noexcept {
        Cell cell;
        cell.fill(no_vertex);
        return cell;
    }
    [[nodiscard]] Cell& vertices(Index c) noexcept { return vertices_[at(c)]; }
    [[nodiscard]] Cell& neighbours(Index c) noexcept { return neighbours_[at(c)]; }
    [[nodiscard]] std::size_t place_of(Index v, const Cell& among) const noexcept {
        return static_cast<std::size_t>(
            std::find(among.begin(), among.begin() + static_cast<std::ptrdiff_t>(size_), v) -
            among.begin());
    }

    /// A cell that holds the site, or an infinite one beyond whose facet it lies.
    [[nodiscard]] Index locate(Index q) {
        Index c = last_;
        while (place_of(infinite, vertices(c)) == size_) {
            std::size_t i = 0;
            for (; i < size_; ++i) {
                Cell with_q = vertices(c);
                with_q[i] = q;
                if (questions_.orientation(with_q) < 0) break;
            }
            if (i == size_) break;
            c = neighbours(c)[i];
        }
        return c;
    }
    [[nodiscard]] bool conflicts(Index c, Index q) {
        const std::size_t i = place_of(infinite, vertices(c));
        if (i == size_) return questions_.conflicts(vertices(c), q);
        Cell with_q = vertices(c);
        with_q[i] = q;
        if (const Sign sign = questions_.orientation(with_q); sign != 0) return sign > 0;
        return questions_.conflicts(vertices(neighbours(c)[i]), q);
    }

    /// From a cell in conflict.
    void find_region(Index start, Index q) {
        region_.assign(1, start);
        mark_[at(start)] = 2 * round_ + 1;
        for (std::size_t next = 0; next < region_.size(); ++next)
            for (std::size_t i = 0; i < size_; ++i) {
                const Index n = neighbours(region_[next])[i];
                if (mark_[at(n)] >= 2 * round_) continue;
                const bool is_in = conflicts(n, q);
                mark_[at(n)] = 2 * round_ + static_cast<std::uint64_t>(is_in);
                if (is_in) region_.push_back(n);
            }
    }
    /// A new cell is one of the region with the site in the place of a vertex that lies across from
    /// the boundary.
    void join_boundary(Index q) {
        sides_.clear();
        last_met_[at(q)] = round_;
        for (const Index c : region_)
            for (std::size_t i = 0; i < size_; ++i) {
                const Index beyond = neighbours(c)[i];
                if (mark_[at(beyond)] == 2 * round_ + 1) continue;
                const Index made = add();
                vertices(made) = vertices(c);
                vertices(made)[i] = q;
                neighbours(made) = unset();
                neighbours(made)[i] = beyond;
                neighbours(beyond)[place_of(c, neighbours(beyond))] = made;
                for (std::size_t m = 0; m < size_; ++m) {
                    const Index v = vertices(made)[m];
                    if (v >= 0) last_met_[at(v)] = round_;
                    if (m != i) sides_.push_back(side(made, m));
                }
                if (place_of(infinite, vertices(made)) == size_) last_ = made;
            }
        connect();
    }
    [[nodiscard]] Index add() {
        // Those of the region are not free yet.
        if (!free_.empty()) {
            const Index c = free_.back();
            free_.pop_back();
            return c;
        }
        if (vertices_.size() >= at(std::numeric_limits<Index>::max()))
            throw std::length_error("too many cells");
        vertices_.push_back(unset());
        neighbours_.push_back(unset());
        mark_.push_back(0);
        return static_cast<Index>(vertices_.size() - 1);
    }

    [[nodiscard]] Side side(Index c, std::size_t place) {
        Side result{{}, c, place};
        std::size_t number = 0;
        for (std::size_t m = 0; m < size_; ++m)
            if (m != place) result.vertices[number++] = vertices(c)[m];
        sort_few(number, result.vertices);
        return result;
    }
    /// Sides of the same vertices belong to neighbours.
    void connect() {
        std::sort(sides_.begin(), sides_.end());
        for (std::size_t s = 0; s + 1 < sides_.size(); s += 2) {
            const Side& a = sides_[s];
            const Side& b = sides_[s + 1];
            neighbours(a.cell)[a.place] = b.cell;
            neighbours(b.cell)[b.place] = a.cell;
        }
    }
    void connect_all() {
        for (Index c = 0; at(c) < vertices_.size(); ++c)
            for (std::size_t m = 0; m < size_; ++m) sides_.push_back(side(c, m));
        connect();
    }

    Asked& questions_;
    std::size_t size_;  // vertices of a cell
    std::vector<Cell> vertices_;
    std::vector<Cell> neighbours_;
    std::vector<Index> free_;
    Index last_ = 0;  // a finite cell
    std::uint64_t round_ = 0;
    std::vector<std::uint64_t> mark_;  // by cell: twice the round, and 1 more where it conflicts
    std::vector<std::uint64_t> last_met_;  // by site: the round in which it was met last
    std::vector<Index> region_;
    std::vector<Side> sides_;
};

}  // namespace signum::any_dimension
