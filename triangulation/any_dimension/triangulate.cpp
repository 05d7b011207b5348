#include "triangulate.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../exact/floating_environment.hpp"
#include "../structure/watch.hpp"
#include "few.hpp"
#include "insertion.hpp"
#include "questions.hpp"

namespace signum {
namespace any_dimension {
namespace {

template <int D>
class Construction {
 public:
    using Site = power::SiteOf<D>;
    using Cell = CellOf<D>;

    Construction(std::span<const Site> sites, const Options& options)
        : sites_(sites), questions_(sites) {
        order_.resize(sites.size());
        std::iota(order_.begin(), order_.end(), 0);
        std::shuffle(order_.begin(), order_.end(), std::mt19937_64(options.seed));
    }

    [[nodiscard]] TessellationOf<D> run(const Options& options) {
        result_.sites = static_cast<std::int64_t>(sites_.size());
        if (sites_.empty()) return std::move(result_);
        choose_first();
        result_.dimension = static_cast<int>(questions_.dimension());
        if (result_.dimension == 0) {
            choose_one();
            return std::move(result_);
        }
        if (questions_.orientation(first_) < 0) std::swap(first_[0], first_[1]);
        Insertion<Site> insertion(questions_, sites_.size(), first_);
        const triangulation::Watch watch(options.stop, options.progress, sites_.size());
        std::vector<Index> hidden;
        std::size_t done = 0;
        for (const Index q : order_) {
            watch.at(++done);
            if (std::find(first_.begin(), first_.end(), q) != first_.end()) continue;
            if (!insertion.insert(q, [&](Index v) { hidden.push_back(v); })) hidden.push_back(q);
        }
        assemble(insertion);
        name_hiders(hidden);
        return std::move(result_);
    }

 private:
    static constexpr auto most = static_cast<std::size_t>(D);

    [[nodiscard]] static std::size_t at(Index i) noexcept { return static_cast<std::size_t>(i); }
    [[nodiscard]] std::size_t size() const noexcept { return questions_.dimension() + 1; }

    /// As many sites as span what all span, and axes that tell its points apart: where elimination
    /// finds its pivots.
    void choose_first() {
        using exact::Rational;
        first_.fill(no_vertex);
        first_[0] = order_[0];
        Axes<D> axes;
        std::vector<std::array<Rational, most>> rows;
        for (const Index i : order_) {
            if (axes.count == most) break;
            std::array<Rational, most> row;
            for (std::size_t x = 0; x < most; ++x)
                row[x] = offset<Rational>(sites_[at(i)], sites_[at(first_[0])], x);
            for (std::size_t r = 0; r < rows.size(); ++r) {
                const Rational factor = row[axes.axis[r]] / rows[r][axes.axis[r]];
                for (std::size_t x = 0; x < most; ++x) row[x] -= factor * rows[r][x];
            }
            const auto pivot = std::find_if(row.begin(), row.end(),
                                            [](const Rational& x) { return !x.is_zero(); });
            if (pivot == row.end()) continue;
            axes.axis[axes.count++] = static_cast<std::size_t>(pivot - row.begin());
            first_[axes.count] = i;
            rows.push_back(row);
        }
        // In their order, which orientations depend on.
        sort_few(axes.count, axes.axis);
        questions_.ask_along(axes);
    }

    /// All centres are one: the first site in the tie rule's order hides the others.
    void choose_one() {
        const auto precedes = [&](Index a, Index b) { return questions_.precedes(a, b); };
        const Index one = *std::min_element(order_.begin(), order_.end(), precedes);
        Cell cell;
        cell.fill(no_vertex);
        for (const Index v : {infinite, one}) {
            cell[0] = v;
            result_.cells.push_back(cell);
            cell[0] = v == infinite ? 1 : 0;
            result_.neighbours.push_back(cell);
        }
        for (Index i = 0; at(i) < sites_.size(); ++i)
            if (i != one) result_.hidden.push_back({i, one});
    }

    /// Laws 1 and 2 of the result.
    void assemble(const Insertion<Site>& insertion) {
        std::vector<Index> cells;
        std::vector<Cell> vertices = insertion.all_vertices();
        std::vector<Cell> neighbours = insertion.all_neighbours();
        for (Index c = 0; at(c) < vertices.size(); ++c) {
            if (vertices[at(c)][0] == Insertion<Site>::free) continue;
            put_in_order(vertices[at(c)], neighbours[at(c)]);
            cells.push_back(c);
        }
        std::sort(cells.begin(), cells.end(),
                  [&](Index a, Index b) { return vertices[at(a)] < vertices[at(b)]; });
        std::vector<Index> place(vertices.size(), no_vertex);
        for (std::size_t i = 0; i < cells.size(); ++i) place[at(cells[i])] = static_cast<Index>(i);
        for (const Index c : cells) {
            result_.cells.push_back(vertices[at(c)]);
            Cell& beyond = neighbours[at(c)];
            for (std::size_t i = 0; i < size(); ++i) beyond[i] = place[at(beyond[i])];
            result_.neighbours.push_back(beyond);
        }
    }
    void put_in_order(Cell& vertices, Cell& neighbours) const {
        const auto exchange = [&](std::size_t a, std::size_t b) {
            std::swap(vertices[a], vertices[b]);
            std::swap(neighbours[a], neighbours[b]);
        };
        const bool is_even = sort_few(
            size(), [&](std::size_t a, std::size_t b) { return vertices[b] < vertices[a]; },
            exchange);
        if (size() == most + 1 && !is_even) exchange(most - 1, most);
    }

    /// The visible site nearest to a hidden one's centre, from neighbour to ever nearer neighbour:
    /// where all neighbours are farther, all sites are, for the distance from a fixed place is
    /// convex over a tessellation. Of those as near it is the first in the rule's order, whose
    /// weight is reduced the least.
    void name_hiders(std::vector<Index>& hidden) {
        if (hidden.empty()) return;
        std::vector<std::vector<Index>> joined(sites_.size());
        for (const Cell& cell : result_.cells)
            for (std::size_t i = 0; i < size(); ++i)
                for (std::size_t k = 0; k < size(); ++k)
                    if (i != k && cell[i] >= 0 && cell[k] >= 0)
                        joined[at(cell[i])].push_back(cell[k]);
        for (std::vector<Index>& list : joined) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
        std::sort(hidden.begin(), hidden.end());
        Index by = *std::find_if(result_.cells.back().begin(), result_.cells.back().end(),
                                 [](Index v) { return v >= 0; });
        for (const Index q : hidden) {
            const auto is_nearer = [&](Index a, Index b) {
                const Sign sign = questions_.nearer(q, a, b);
                return sign != 0 ? sign > 0 : questions_.precedes(a, b);
            };
            for (Index before = infinite; before != by;) {
                before = by;
                for (const Index v : joined[at(before)])
                    if (is_nearer(v, by)) by = v;
            }
            result_.hidden.push_back({q, by});
        }
    }

    std::span<const Site> sites_;
    Questions<Site, exact::Rational> questions_;
    std::vector<Index> order_;  // of insertion
    Cell first_{};
    TessellationOf<D> result_;
};

}  // namespace
}  // namespace any_dimension

template <int D>
TessellationOf<D> triangulate(std::span<const power::SiteOf<D>> sites, const Options& options) {
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!any_dimension::is_finite(sites[i]))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
    if (options.arithmetic != Arithmetic::exact)
        throw std::invalid_argument("tessellations in any dimension have exact arithmetic alone");
    const exact::IeeeEnvironment environment;
    return any_dimension::Construction<D>(sites, options).run(options);
}

#define SIGNUM_INSTANTIATE(D) \
    template TessellationOf<D> triangulate<D>(std::span<const power::SiteOf<D>>, const Options&);
SIGNUM_INSTANTIATE(1)
SIGNUM_INSTANTIATE(2)
SIGNUM_INSTANTIATE(3)
SIGNUM_INSTANTIATE(4)
SIGNUM_INSTANTIATE(5)
SIGNUM_INSTANTIATE(6)
#undef SIGNUM_INSTANTIATE

}  // namespace signum
