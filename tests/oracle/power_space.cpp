#include "power_space.hpp"

#include "linear_form.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace signum::oracle {
namespace {

using Vector = std::vector<Rational>;
using Simplex = std::vector<std::size_t>;  // numbers of sites

struct Weighted {
    Vector centre;
    Rational weight;
};

/// Of all rising tuples of numbers below `count`, the one that follows in the order of words; false
/// after the last.
bool next_subset(Simplex& tuple, std::size_t count) {
    for (std::size_t i = tuple.size(); i-- > 0;) {
        if (tuple[i] == count - tuple.size() + i) continue;
        ++tuple[i];
        for (std::size_t j = i + 1; j < tuple.size(); ++j) tuple[j] = tuple[j - 1] + 1;
        return true;
    }
    return false;
}

std::vector<Simplex> subsets(std::size_t count, std::size_t size) {
    if (size > count) return {};
    Simplex tuple(size);
    for (std::size_t i = 0; i < size; ++i) tuple[i] = i;
    std::vector<Simplex> all{tuple};
    while (next_subset(tuple, count)) all.push_back(tuple);
    return all;
}

Simplex without(Simplex tuple, std::size_t place) {
    tuple.erase(tuple.begin() + static_cast<std::ptrdiff_t>(place));
    return tuple;
}

/// By the first row; 1 where there is none.
Rational determinant(const std::vector<Vector>& rows) {
    if (rows.empty()) return 1;
    Rational sum = 0;
    for (std::size_t column = 0; column < rows.size(); ++column) {
        if (rows[0][column].is_zero()) continue;
        std::vector<Vector> minor(rows.begin() + 1, rows.end());
        for (Vector& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
        const Rational term = rows[0][column] * determinant(minor);
        column % 2 == 0 ? sum += term : sum -= term;
    }
    return sum;
}

/// det[c_i - c_0] in some of the coordinates.
Rational volume(const std::vector<Weighted>& sites, const Simplex& tuple,
                const std::vector<std::size_t>& coordinates) {
    std::vector<Vector> rows;
    for (std::size_t i = 1; i < tuple.size(); ++i) {
        Vector& row = rows.emplace_back();
        for (const std::size_t x : coordinates)
            row.push_back(sites[tuple[i]].centre[x] - sites[tuple[0]].centre[x]);
    }
    return determinant(rows);
}

/// Coordinates that tell the points of the flat through all centres apart, as many as the flat has
/// dimensions: where elimination finds its pivots.
std::vector<std::size_t> spanning_coordinates(const std::vector<Weighted>& sites) {
    std::vector<Vector> rows;
    for (const Weighted& site : sites) {
        Vector& row = rows.emplace_back(site.centre);
        for (std::size_t x = 0; x < row.size(); ++x) row[x] -= sites[0].centre[x];
    }
    std::vector<std::size_t> pivots;
    for (std::size_t x = 0; x < sites[0].centre.size(); ++x) {
        const std::size_t top = pivots.size();
        std::size_t found = top;
        while (found < rows.size() && rows[found][x].is_zero()) ++found;
        if (found == rows.size()) continue;
        std::swap(rows[top], rows[found]);
        for (std::size_t i = top + 1; i < rows.size(); ++i) {
            const Rational factor = rows[i][x] / rows[top][x];
            for (std::size_t y = x; y < rows[i].size(); ++y) rows[i][y] -= factor * rows[top][y];
        }
        pivots.push_back(x);
    }
    return pivots;
}

std::vector<std::size_t> order_of_ties(const std::vector<Weighted>& sites) {
    const auto precedes = [&](std::size_t a, std::size_t b) {
        if (sites[a].weight != sites[b].weight) return sites[a].weight > sites[b].weight;
        if (sites[a].centre != sites[b].centre) return sites[a].centre < sites[b].centre;
        return a < b;
    };
    std::vector<std::size_t> ranks(sites.size(), 0);
    for (std::size_t a = 0; a < sites.size(); ++a)
        for (std::size_t b = 0; b < sites.size(); ++b)
            if (precedes(a, b)) ++ranks[b];
    return ranks;
}

/// The sites as points (c, |c|² - w + e) of a space with one dimension more, e the infinitesimal by
/// which the weight is reduced. Their lower hull is the tessellation. Centres are never perturbed,
/// so heights enter every determinant linearly.
///
/// Where the centres lie in a flat of k dimensions, so do the lifted sites in one of k + 1, and it
/// is enough to look at k coordinates and the height: a lower hull does not mind an affine map of
/// the points below it.
class Lifting {
 public:
    Lifting(const std::vector<Weighted>& sites, const Ranks& ranks)
        : sites_(sites),
          ranks_(ranks.empty() ? order_of_ties(sites) : ranks),
          coordinates_(spanning_coordinates(sites)) {
        for (std::size_t i = 0; i < sites.size(); ++i) {
            Rational height = -sites[i].weight;
            for (const Rational& x : sites[i].centre) height += x * x;
            height_.push_back(LinearForm(height) + LinearForm::infinitesimal(ranks_[i]));
        }
    }

    std::size_t dimension() const { return coordinates_.size(); }

    /// Simplices that do not lie in a flat of less dimensions and whose plane has every other site
    /// above it.
    std::vector<Simplex> cells() const {
        std::map<Simplex, Rational> orientation;
        for (const Simplex& simplex : subsets(sites_.size(), dimension() + 1))
            orientation.emplace(simplex, volume(sites_, simplex, coordinates_));

        std::set<Simplex> refuted;
        for (const Simplex& tuple : subsets(sites_.size(), dimension() + 2)) {
            // One site and a simplex, in k + 2 ways. The centres have an affine dependency, that is
            // sum a_i = 0 and sum a_i c_i = 0: a_i is the orientation of the others, with changing
            // signs. So the plane through the others is, at c_i, as high as -(sum of the other
            // a_j h_j) / a_i, and site i is (sum of all a_j h_j) / a_i above it.
            Vector a;
            LinearForm sum;
            for (std::size_t i = 0; i < tuple.size(); ++i) {
                const Rational& others = orientation.at(without(tuple, i));
                a.push_back(i % 2 == 0 ? others : -others);
                if (!others.is_zero()) sum += height_[tuple[i]] * a[i];
            }
            for (std::size_t i = 0; i < tuple.size(); ++i) {
                if (a[i].is_zero()) continue;
                const int above = sum.sign() * a[i].sign();
                if (above == 0) throw std::logic_error("oracle: the tie rule does not decide");
                if (above < 0) refuted.insert(without(tuple, i));
            }
        }

        std::vector<Simplex> cells;
        for (const auto& [simplex, size] : orientation)
            if (!size.is_zero() && !refuted.contains(simplex)) cells.push_back(simplex);
        return cells;
    }

    /// The power distance from the centre of q to a site with its reduced weight.
    LinearForm distance(std::size_t q, std::size_t site) const {
        Rational distance = -sites_[site].weight;
        for (std::size_t x = 0; x < sites_[q].centre.size(); ++x) {
            const Rational difference = sites_[q].centre[x] - sites_[site].centre[x];
            distance += difference * difference;
        }
        return LinearForm(distance) + LinearForm::infinitesimal(ranks_[site]);
    }

 private:
    std::vector<Weighted> sites_;
    std::vector<std::size_t> ranks_;
    std::vector<std::size_t> coordinates_;
    std::vector<LinearForm> height_;
};

template <int D>
std::vector<Weighted> exact_sites(std::span<const SpaceSite<D>> sites) {
    std::vector<Weighted> exact;
    for (const SpaceSite<D>& site : sites) {
        Weighted& copy = exact.emplace_back();
        for (const double x : site.c) copy.centre.push_back(exactly(x));
        copy.weight = exactly(site.w);
    }
    return exact;
}

template <int N>
SpaceTuple<N> padded(const Simplex& simplex) {
    SpaceTuple<N> tuple;
    tuple.fill(no_site);
    for (std::size_t i = 0; i < simplex.size(); ++i)
        tuple[i] = static_cast<std::int32_t>(simplex[i]);
    return tuple;
}

/// The sides of the cells that have no cell beyond them.
std::vector<Simplex> hull(const std::vector<Simplex>& cells) {
    std::map<Simplex, int> sides;
    for (const Simplex& cell : cells)
        for (std::size_t i = 0; i < cell.size(); ++i) ++sides[without(cell, i)];
    std::vector<Simplex> facets;
    for (const auto& [side, times] : sides) {
        if (times > 2) throw std::logic_error("oracle: more than two cells share a side");
        if (times == 1) facets.push_back(side);
    }
    return facets;
}

}  // namespace

template <int D>
SpaceTessellation<D> power_space(std::span<const SpaceSite<D>> sites, const Ranks& ranks) {
    SpaceTessellation<D> result;
    if (sites.empty()) return result;
    const Lifting lifting(exact_sites(sites), ranks);
    const std::vector<Simplex> cells = lifting.cells();
    if (cells.empty()) throw std::logic_error("oracle: no cell");

    std::set<std::size_t> visible;
    for (const Simplex& cell : cells) {
        result.cells.push_back(padded<D + 1>(cell));
        visible.insert(cell.begin(), cell.end());
    }
    result.dimension = static_cast<int>(lifting.dimension());
    if (result.dimension > 0)
        for (const Simplex& facet : hull(cells)) result.facets.push_back(padded<D>(facet));

    for (std::size_t q = 0; q < sites.size(); ++q) {
        if (visible.contains(q)) continue;
        std::size_t by = *visible.begin();
        for (const std::size_t i : visible)
            if (i != by && less(lifting.distance(q, i), lifting.distance(q, by))) by = i;
        result.hidden.push_back({static_cast<std::int32_t>(q), static_cast<std::int32_t>(by)});
    }
    return result;
}

template <int D>
int orientation(std::span<const SpaceSite<D>> sites, const SpaceTuple<D + 1>& tuple) {
    Simplex simplex;
    std::vector<std::size_t> coordinates;
    for (const std::int32_t site : tuple) {
        if (site == no_site) return 0;
        simplex.push_back(static_cast<std::size_t>(site));
    }
    for (std::size_t x = 0; x < static_cast<std::size_t>(D); ++x) coordinates.push_back(x);
    return volume(exact_sites(sites), simplex, coordinates).sign();
}

template SpaceTessellation<1> power_space<1>(std::span<const SpaceSite<1>>, const Ranks&);
template SpaceTessellation<2> power_space<2>(std::span<const SpaceSite<2>>, const Ranks&);
template SpaceTessellation<3> power_space<3>(std::span<const SpaceSite<3>>, const Ranks&);
template SpaceTessellation<4> power_space<4>(std::span<const SpaceSite<4>>, const Ranks&);
template SpaceTessellation<5> power_space<5>(std::span<const SpaceSite<5>>, const Ranks&);
template SpaceTessellation<6> power_space<6>(std::span<const SpaceSite<6>>, const Ranks&);
template int orientation<1>(std::span<const SpaceSite<1>>, const SpaceTuple<2>&);
template int orientation<2>(std::span<const SpaceSite<2>>, const SpaceTuple<3>&);
template int orientation<3>(std::span<const SpaceSite<3>>, const SpaceTuple<4>&);
template int orientation<4>(std::span<const SpaceSite<4>>, const SpaceTuple<5>&);

}  // namespace signum::oracle
