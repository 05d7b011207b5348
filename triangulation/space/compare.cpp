#include "compare.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum {
namespace {

[[nodiscard]] bool is_finite(const SpaceCell& cell) noexcept {
    return std::ranges::count(cell, infinite) == 0;
}

/// Cells and neighbours as they must be, so that nobody reads beyond an array.
void require_sites(const SpaceTessellation& tessellation, std::size_t sites) {
    if (tessellation.sites != static_cast<std::int64_t>(sites))
        throw std::invalid_argument("a tessellation to be compared is of other sites");
    if (tessellation.neighbours.size() != tessellation.cells.size())
        throw std::invalid_argument("a tessellation to be compared lacks neighbours of cells");
    const std::ptrdiff_t size = tessellation.dimension + 1;
    if (size < 0 || size > 4)
        throw std::invalid_argument("a tessellation to be compared has no dimension of space");
    const auto all_below = [size](const std::vector<SpaceCell>& tuples, Index least,
                                  std::size_t end) {
        return std::ranges::all_of(tuples, [&](const SpaceCell& each) {
            return std::all_of(each.begin(), each.begin() + size, [&](Index i) {
                return i >= least && (i < 0 || static_cast<std::size_t>(i) < end);
            });
        });
    };
    if (!all_below(tessellation.cells, infinite, sites) ||
        !all_below(tessellation.neighbours, 0, tessellation.cells.size()))
        throw std::invalid_argument(
            "a tessellation to be compared names a site or a cell that there is not");
}

/// Sorted.
[[nodiscard]] std::vector<SpaceCell> finite_cells(const SpaceTessellation& tessellation,
                                                  const Workers& workers) {
    const std::vector<SpaceCell>& all = tessellation.cells;
    // Dealt by their first site, so that one bucket is sorted beside another.
    const std::size_t buckets = workers.range_count(all.size());
    const std::size_t sites = std::max<std::size_t>(tessellation.sites, 1);
    std::vector<SpaceCell> cells;
    const std::vector<std::size_t> begins = deal(
        workers, all.size(), buckets,
        [&](std::size_t c) {
            if (!is_finite(all[c])) return buckets;
            return std::min(static_cast<std::size_t>(all[c][0]) * buckets / sites, buckets - 1);
        },
        [&](std::size_t count) { make_room(workers, count, cells); },
        [&](std::size_t c, std::size_t place) { cells[place] = all[c]; });
    workers.each(buckets, [&](std::size_t b) {
        std::sort(cells.data() + begins[b], cells.data() + begins[b + 1]);
    });
    return cells;
}

/// A cell of each site; infinite: hidden.
[[nodiscard]] std::vector<Index> cells_of_sites(const SpaceTessellation& tessellation,
                                                std::size_t sites) {
    std::vector<Index> result(sites, infinite);
    for (std::size_t c = 0; c < tessellation.cells.size(); ++c)
        for (const Index v : tessellation.cells[c])
            if (v >= 0) result[static_cast<std::size_t>(v)] = static_cast<Index>(c);
    return result;
}

/// Its corners, which turn positively; nothing where they do not, or span less than all sites do.
/// One of flat sites gets corners outside of what they span for the dimensions that they lack:
/// whether another of them conflicts does not depend on these
/// (triangulation/space/triangulate.cpp).
template <class S>
[[nodiscard]] std::optional<std::array<S, 4>> corners_of(const SpaceCell& cell,
                                                         std::size_t dimension,
                                                         std::span<const S> sites) {
    std::array<S, 4> corners;
    double extent = 0.0;
    for (std::size_t m = 0; m <= dimension; ++m) {
        corners[m] = sites[static_cast<std::size_t>(cell[m])];
        for (const double x : {corners[m].x, corners[m].y, corners[m].z})
            extent = std::max(extent, std::fabs(x));
    }
    const auto turn = [&] {
        return ccw(centre3(corners[0]), centre3(corners[1]), centre3(corners[2]),
                   centre3(corners[3]));
    };
    if (dimension == 3) return turn() > 0 ? std::optional(corners) : std::nullopt;
    const double step = extent > 0.0 ? extent : 1.0;
    constexpr std::array<double S::*, 3> axes = {&S::x, &S::y, &S::z};
    // Some of the axes complete whatever spans a dimension less for each.
    for (std::size_t first = 0; first < 3; ++first) {
        for (std::size_t m = dimension + 1; m < 4; ++m) {
            corners[m] = corners[0];
            double& moved = corners[m].*axes[(first + m) % 3];
            moved += moved > 0.0 ? -step : step;
        }
        const Sign sign = turn();
        if (sign == 0) continue;
        if (sign < 0) std::swap(corners[2], corners[3]);
        return corners;
    }
    return std::nullopt;
}

/// Whether cells are valid, by the canonical tessellation.
///
/// Why the sites around one visible site of a cell tell: over what the centres span, the canonical
/// tessellation is a convex function of height, the least that lifted sites allow, and the vertex
/// of the cell is an affine one, H. A conflict is a lifted site below H. Their difference is
/// convex, linear on each canonical cell, and at most 0 at a corner of the cell that is visible
/// (there it is 0). Where it is negative anywhere, it is so along a line from this corner at once,
/// which lies in a canonical cell around it: so at another corner of that one.
template <class S>
class Validity {
 public:
    /// cell_of: cells_of_sites() of the canonical one.
    Validity(const SpaceTessellation& canonical, std::span<const S> sites,
             std::span<const Index> cell_of)
        : canonical_(canonical),
          sites_(sites),
          size_(static_cast<std::size_t>(canonical.dimension + 1)),
          cell_of_(cell_of),
          visited_(canonical.cells.size(), 0) {}

    [[nodiscard]] bool of(const SpaceCell& cell) {
        const auto corners = corners_of(cell, size_ - 1, sites_);
        if (!corners) return false;
        const auto& [i, j, k, l] = *corners;
        // A binding by its own name is more than clang++ 14 captures.
        const auto conflicts = [this, &i = i, &j = j, &k = k, &l = l](Index q) {
            return power::in_sphere(i, j, k, l, site(q)) > 0;
        };
        const auto own = std::span(cell).first(size_);
        const auto visible = std::ranges::find_if(own, [&](Index v) { return is_visible(v); });
        if (visible != own.end()) return !any_around(*visible, conflicts);
        for (std::size_t q = 0; q < sites_.size(); ++q)
            if (is_visible(static_cast<Index>(q)) && conflicts(static_cast<Index>(q))) return false;
        return true;
    }

 private:
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool is_visible(Index i) const noexcept {
        return cell_of_[static_cast<std::size_t>(i)] != infinite;
    }

    /// Whether `holds` for a corner of the cells around a visible site.
    template <class Condition>
    [[nodiscard]] bool any_around(Index centre, const Condition& holds) {
        ++round_;
        const auto visit = [&](Index c) {
            if (std::exchange(visited_[static_cast<std::size_t>(c)], round_) != round_)
                around_.push_back(c);
        };
        around_.clear();
        visit(cell_of_[static_cast<std::size_t>(centre)]);
        for (std::size_t next = 0; next < around_.size(); ++next) {
            const auto c = static_cast<std::size_t>(around_[next]);
            for (std::size_t m = 0; m < size_; ++m) {
                const Index v = canonical_.cells[c][m];
                if (v == centre) continue;
                if (v >= 0 && holds(v)) return true;
                visit(canonical_.neighbours[c][m]);
            }
        }
        return false;
    }

    const SpaceTessellation& canonical_;
    std::span<const S> sites_;
    std::size_t size_;  ///< of a cell
    std::span<const Index> cell_of_;
    std::vector<std::uint64_t> visited_;  ///< by cell the last round in which it was visited
    std::uint64_t round_ = 0;
    std::vector<Index> around_;
};

template <class S>
CellComparison compare(const SpaceTessellation& tessellation, const SpaceTessellation& canonical,
                       std::span<const S> sites, int threads) {
    require_sites(tessellation, sites.size());
    require_sites(canonical, sites.size());
    if (tessellation.dimension != canonical.dimension)
        throw std::invalid_argument("two tessellations to be compared are of two dimensions");
    const Workers workers(threads, canonical.cells.size());
    const std::vector<SpaceCell> compared = finite_cells(tessellation, workers);
    const std::vector<SpaceCell> expected = finite_cells(canonical, workers);
    std::vector<SpaceCell> unexpected;
    std::ranges::set_difference(compared, expected, std::back_inserter(unexpected));

    CellComparison result;
    result.cells = static_cast<std::int64_t>(compared.size());
    if (unexpected.empty()) return result;
    const std::vector<Index> cell_of = cells_of_sites(canonical, sites.size());
    std::vector<char> are_valid(unexpected.size());
    workers.each_range(unexpected.size(), [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        Validity<S> is_valid(canonical, sites, cell_of);
        for (std::size_t c = begin; c < end; ++c) are_valid[c] = is_valid.of(unexpected[c]);
    });
    for (std::size_t c = 0; c < unexpected.size(); ++c)
        (are_valid[c] != 0 ? result.different : result.wrong).push_back(unexpected[c]);
    return result;
}

template <class S>
FacetTies count_ties(const SpaceTessellation& canonical, std::span<const S> sites, int threads) {
    require_sites(canonical, sites.size());
    const auto dimension = static_cast<std::size_t>(canonical.dimension);
    const Workers workers(threads, canonical.cells.size());
    std::atomic<std::int64_t> facets = 0;
    std::atomic<std::int64_t> ties = 0;
    workers.each_range(canonical.cells.size(), [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        FacetTies own;
        for (std::size_t c = begin; c < end; ++c) {
            const SpaceCell& cell = canonical.cells[c];
            if (!is_finite(cell)) continue;
            const auto corners = corners_of(cell, dimension, sites);
            if (!corners) continue;
            const auto& [i, j, k, l] = *corners;
            for (const Index n : std::span(canonical.neighbours[c]).first(dimension + 1)) {
                const SpaceCell& other = canonical.cells[static_cast<std::size_t>(n)];
                if (static_cast<std::size_t>(n) <= c || !is_finite(other)) continue;
                const auto across = std::ranges::find_if(
                    other, [&](Index v) { return std::ranges::count(cell, v) == 0; });
                if (across == other.end()) continue;
                ++own.facets;
                const S& q = sites[static_cast<std::size_t>(*across)];
                own.ties += power::in_sphere(i, j, k, l, q) == 0;
            }
        }
        facets += own.facets;
        ties += own.ties;
    });
    return {facets, ties};
}

}  // namespace

CellComparison compare_cells(const SpaceTessellation& tessellation,
                             const SpaceTessellation& canonical, std::span<const Point3> sites,
                             int threads) {
    return compare(tessellation, canonical, sites, threads);
}
CellComparison compare_cells(const SpaceTessellation& tessellation,
                             const SpaceTessellation& canonical, std::span<const Site3> sites,
                             int threads) {
    return compare(tessellation, canonical, sites, threads);
}
CellComparison compare_cells(const SpaceTessellation& tessellation,
                             const SpaceTessellation& canonical,
                             std::span<const power::Site3> sites, int threads) {
    return compare(tessellation, canonical, sites, threads);
}

FacetTies ties_of(const SpaceTessellation& canonical, std::span<const Point3> sites, int threads) {
    return count_ties(canonical, sites, threads);
}
FacetTies ties_of(const SpaceTessellation& canonical, std::span<const Site3> sites, int threads) {
    return count_ties(canonical, sites, threads);
}
FacetTies ties_of(const SpaceTessellation& canonical, std::span<const power::Site3> sites,
                  int threads) {
    return count_ties(canonical, sites, threads);
}

}  // namespace signum
