#include "triangulate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "../../core/pages.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/space/nearer.hpp"
#include "../structure/watch.hpp"
#include "insert.hpp"
#include "kernel.hpp"
#include "nearest_site.hpp"
#include "order.hpp"

namespace signum {
namespace {

using spatial::Cells;
using spatial::infinite;

[[nodiscard]] bool are_collinear(const Point3& a, const Point3& b, const Point3& c) noexcept {
    return ccw(Point{a.x, a.y}, Point{b.x, b.y}, Point{c.x, c.y}) == 0 &&
           ccw(Point{a.y, a.z}, Point{b.y, b.z}, Point{c.y, c.z}) == 0 &&
           ccw(Point{a.z, a.x}, Point{b.z, b.x}, Point{c.z, c.x}) == 0;
}

/// Even permutations keep the orientation: the one that puts the least of four first, and the least
/// of the others second, by which of them are less than which. Without a branch, for nobody could
/// foretell it.
constexpr auto even_orders = [] {
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

/// A site and its number in the input, in the order of insertion. Apexes follow the input's.
template <class S>
struct Numbered {
    LargeArray<S> sites;
    LargeArray<Index> numbers;
};

/// Flat sites are joined to apexes, one for each dimension that they lack, outside what they span.
///
/// Why that changes nothing: a cell is then one of theirs joined to all apexes. Whether another of
/// them conflicts with it, the sphere of the cell says within what they span, where it is the one
/// of their own cell; the apex's height has the orientation of flat sites for a coefficient, which
/// is 0, and so has its infinitesimal.
template <class S, class Kernel>
class Construction {
 public:
    Construction(std::span<const S> sites, const Options& options) : sites_(sites) {
        order_ = spatial::insertion_order(
            sites.size(), [&](Index i) { return centre3(sites[static_cast<std::size_t>(i)]); },
            options.seed);
    }

    [[nodiscard]] SpaceTessellation run(const Options& options) {
        SpaceTessellation result;
        result.sites = static_cast<std::int64_t>(sites_.size());
        if (sites_.empty()) return result;
        choose_first();
        result.dimension = 3 - static_cast<int>(apexes_);
        Built built = structure(options, result);
        assemble(built.cells, std::move(built.room), result);
        if constexpr (!Kernel::is_exact) expect_all(result);
        return result;
    }

 private:
    using Built = typename spatial::Insertion<Kernel>::Built;

    /// All cells, and who is hidden.
    [[nodiscard]] Built structure(const Options& options, SpaceTessellation& result) {
        Kernel kernel(all_.sites, all_.numbers);
        spatial::Insertion<Kernel> insertion(
            kernel, spatial::frame_of(std::span<const S>(all_.sites)), all_.sites.size());
        // The hidden, and a site nearby each.
        std::vector<std::pair<Index, Index>> hidden;
        const triangulation::Watch watch(options.stop, options.progress, all_.sites.size());
        const auto last = static_cast<Index>(all_.sites.size());
        for (Index q = 4; q < last; ++q) {
            watch.at(static_cast<std::size_t>(q));
            insertion.insert(q, [&](Index v, Index near) { hidden.emplace_back(v, near); });
        }
        find_nearest(hidden, result.hidden);
        return std::move(insertion).release();
    }
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] bool is_independent(const std::vector<S>& first, const S& next) const noexcept {
        const auto at = [&](std::size_t k) { return centre3(first[k]); };
        const Point3 p = centre3(next);
        switch (first.size()) {
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
    /// The first four sites that span space come first, then the others; where there are not as
    /// many, apexes.
    void choose_first() {
        std::vector<S> first;
        std::vector<std::size_t> places;
        for (std::size_t place = 0; place < order_.size() && first.size() < 4; ++place) {
            if (!is_independent(first, site(order_[place]))) continue;
            first.push_back(site(order_[place]));
            places.push_back(place);
        }
        while (first.size() < 4) {
            first.push_back(apex(first));
            ++apexes_;
        }
        const std::size_t number = sites_.size() + apexes_;
        all_.sites.reserve(number);
        all_.numbers.reserve(number);
        expect_writes(all_.sites);
        expect_writes(all_.numbers);
        for (std::size_t k = 0; k < 4; ++k) {
            all_.sites.push_back(first[k]);
            all_.numbers.push_back(k < places.size()
                                       ? order_[places[k]]
                                       : static_cast<Index>(sites_.size() + k - places.size()));
        }
        if (ccw(centre3(first[0]), centre3(first[1]), centre3(first[2]), centre3(first[3])) < 0) {
            std::swap(all_.sites[0], all_.sites[1]);
            std::swap(all_.numbers[0], all_.numbers[1]);
        }
        for (std::size_t place = 0, next = 0; place < order_.size(); ++place) {
            if (next < places.size() && places[next] == place) {
                ++next;
                continue;
            }
            all_.sites.push_back(site(order_[place]));
            all_.numbers.push_back(order_[place]);
        }
        order_ = {};
    }
    /// The first site moved along an axis by about as much as the sites extend, toward 0.
    [[nodiscard]] S apex(const std::vector<S>& first) const {
        double extent = 0.0;
        for (const S& each : first)
            for (const double x : {each.x, each.y, each.z}) extent = std::max(extent, std::fabs(x));
        const double step = extent > 0.0 ? extent : 1.0;
        for (double S::*const axis : {&S::x, &S::y, &S::z}) {
            S candidate = first[0];
            candidate.*axis += candidate.*axis > 0.0 ? -step : step;
            if (is_independent(first, candidate)) return candidate;
        }
        throw std::logic_error("flat sites span space");
    }

    /// The visible site nearest to the centre of each hidden one. Looked for from whoever hid it or
    /// was nearest to it when it came, or, where that has become hidden itself, from whoever did so
    /// to that one.
    void find_nearest(const std::vector<std::pair<Index, Index>>& hidden,
                      std::vector<Hidden>& result) const {
        if (hidden.empty()) return;
        constexpr Index is_visible = -1;
        LargeArray<Index> hider(all_.sites.size(), is_visible);
        for (auto last = hidden.rbegin(); last != hidden.rend(); ++last) {
            const auto& [v, near] = *last;
            const Index of_near = hider[static_cast<std::size_t>(near)];
            hider[static_cast<std::size_t>(v)] = of_near == is_visible ? near : of_near;
        }
        LargeArray<Index> visible;
        visible.reserve(all_.sites.size() - hidden.size());
        for (Index v = 0; v < static_cast<Index>(all_.sites.size()); ++v)
            if (hider[static_cast<std::size_t>(v)] == is_visible && !is_apex(v))
                visible.push_back(v);
        if (!Kernel::is_exact && visible.empty()) throw BrokenStructure("all sites are hidden");
        const Index any = visible.front();
        spatial::NearestSite<S> nearest(all_.sites, all_.numbers, std::move(visible));
        result.reserve(hidden.size());
        for (const auto& [v, near] : hidden) {
            const Index start = hider[static_cast<std::size_t>(v)];
            const Index by = nearest(centre3(all_.sites[static_cast<std::size_t>(v)]),
                                     is_apex(start) ? any : start);
            result.push_back({all_.numbers[static_cast<std::size_t>(v)],
                              all_.numbers[static_cast<std::size_t>(by)]});
        }
        std::ranges::sort(result, {}, &Hidden::site);
    }
    [[nodiscard]] bool is_apex(Index v) const noexcept {
        return all_.numbers[static_cast<std::size_t>(v)] >= static_cast<Index>(sites_.size());
    }
    /// Laws 1 and 2 of the result, in memory that the structure had: the spheres', then the
    /// vertices'. It is read from its first cell to its last: there neighbours lie close to one
    /// another, which in the result they do not.
    void assemble(Cells& structure, std::vector<SpaceCell> room, SpaceTessellation& result) {
        const auto last = static_cast<Index>(structure.size());
        for (Index c = 0; c < last; ++c)
            if (!structure.is_free(c)) name(structure.vertex(c), structure.neighbour(c));
        all_ = {};
        result.cells = std::move(room);
        const auto place = sort_cells(structure, result.cells);
        result.neighbours = structure.forget_vertices();
        result.neighbours.resize(result.cells.size());
        for (Index c = 0; c < last; ++c) {
            const Index own = place[static_cast<std::size_t>(c)];
            if (own == no_vertex) continue;
            SpaceCell neighbours = structure.neighbour(c);
            for (Index& n : neighbours)
                if (n >= 0) n = place[static_cast<std::size_t>(n)];
            result.neighbours[static_cast<std::size_t>(own)] = neighbours;
        }
        for (std::vector<SpaceCell>* const each : {&result.cells, &result.neighbours})
            if (each->size() < each->capacity() / 2)
                *each = std::vector<SpaceCell>(each->begin(), each->end());
    }
    /// Every site is visible, or hidden by one that is. Where regions of conflict were no balls, or
    /// flat sites had volumes by rounding, that need not be so.
    static void expect_all(const SpaceTessellation& result) {
        std::vector<bool> is_visible(static_cast<std::size_t>(result.sites), false);
        for (const SpaceCell& cell : result.cells)
            for (const Index v : cell)
                if (v >= 0) is_visible[static_cast<std::size_t>(v)] = true;
        std::vector<bool> is_told = is_visible;
        for (const auto& [site, by] : result.hidden) {
            if (is_visible[static_cast<std::size_t>(site)])
                throw BrokenStructure("a hidden site is a vertex of a cell");
            if (!is_visible[static_cast<std::size_t>(by)])
                throw BrokenStructure("no site is near to a hidden one");
            is_told[static_cast<std::size_t>(site)] = true;
        }
        if (!std::ranges::all_of(is_told, std::identity{}))
            throw BrokenStructure("a site is neither visible nor hidden");
    }
    /// Gives a cell the names and the order of the result. One of flat sites loses the apexes; what
    /// is not joined to all of them becomes free.
    void name(SpaceCell& cell, SpaceCell& neighbour) const {
        std::size_t size = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Index v = cell[k];
            if (v >= 0 && is_apex(v)) continue;
            cell[size] = v >= 0 ? all_.numbers[static_cast<std::size_t>(v)] : infinite;
            neighbour[size++] = neighbour[k];
        }
        for (std::size_t k = size; k < 4; ++k) cell[k] = neighbour[k] = no_vertex;
        if (size + apexes_ > 4) {
            cell[0] = Cells::free;
        } else {
            put_in_order(cell, neighbour, size);
        }
    }
    /// The cells that are not free, sorted; returns at which place each of the structure is. By the
    /// first vertex into buckets, and by the second where the first is at infinity: there may be as
    /// many of these as of all others. Then within the buckets, whose members stand where the cells
    /// are to be, each with its number in place of the first vertex, which is the bucket's.
    [[nodiscard]] LargeArray<Index> sort_cells(const Cells& structure,
                                               std::vector<SpaceCell>& cells) const {
        const auto last = static_cast<Index>(structure.size());
        // From no_vertex up to the last.
        const auto vertices = static_cast<Index>(sites_.size()) - no_vertex;
        const auto bucket = [&](const SpaceCell& cell) {
            return static_cast<std::size_t>(cell[0] == infinite ? cell[1] - no_vertex
                                                                : vertices + cell[0]);
        };
        std::vector<Index> ends(2 * static_cast<std::size_t>(vertices), 0);
        for (Index c = 0; c < last; ++c)
            if (!structure.is_free(c)) ++ends[bucket(structure.vertex(c)) + 1];
        for (std::size_t b = 1; b < ends.size(); ++b) ends[b] += ends[b - 1];
        cells.resize(static_cast<std::size_t>(ends.back()));
        // The begin of each bucket moves to its end.
        for (Index c = 0; c < last; ++c) {
            if (structure.is_free(c)) continue;
            const SpaceCell& cell = structure.vertex(c);
            cells[static_cast<std::size_t>(ends[bucket(cell)]++)] = {cell[1], cell[2], cell[3], c};
        }
        const auto key = [](const SpaceCell& member) {
            return static_cast<std::uint64_t>(member[0]) << 32 |
                   static_cast<std::uint32_t>(member[1]);
        };
        Index begin = 0;
        for (const Index end : ends) {
            std::sort(cells.begin() + begin, cells.begin() + end,
                      [&](const SpaceCell& m, const SpaceCell& n) {
                          return key(m) != key(n) ? key(m) < key(n) : m[2] < n[2];
                      });
            begin = end;
        }
        LargeArray<Index> place;
        place.reserve(structure.size());
        expect_writes(place);
        place.assign(structure.size(), no_vertex);
        Index next = 0;
        for (std::size_t b = 0; b < ends.size(); ++b) {
            const Index first = std::max(static_cast<Index>(b) - vertices, infinite);
            for (; next < ends[b]; ++next) {
                SpaceCell& cell = cells[static_cast<std::size_t>(next)];
                place[static_cast<std::size_t>(cell[3])] = next;
                cell = {first, cell[0], cell[1], cell[2]};
            }
        }
        return place;
    }
    static void put_in_order(SpaceCell& cell, SpaceCell& neighbour, std::size_t size) {
        if (size < 4) {
            for (std::size_t k = 0; k < size; ++k)
                for (std::size_t m = k; m > 0 && cell[m] < cell[m - 1]; --m) {
                    std::swap(cell[m], cell[m - 1]);
                    std::swap(neighbour[m], neighbour[m - 1]);
                }
            return;
        }
        const auto is_less = [&](std::size_t a, std::size_t b) {
            return static_cast<std::size_t>(cell[a] < cell[b]);
        };
        const auto& [a, b, c, d] =
            even_orders[is_less(0, 1) | is_less(0, 2) << 1 | is_less(0, 3) << 2 |
                        is_less(1, 2) << 3 | is_less(1, 3) << 4 | is_less(2, 3) << 5];
        cell = {cell[a], cell[b], cell[c], cell[d]};
        neighbour = {neighbour[a], neighbour[b], neighbour[c], neighbour[d]};
    }

    std::span<const S> sites_;
    LargeArray<Index> order_;
    Numbered<S> all_;
    std::size_t apexes_ = 0;
};

template <class S>
SpaceTessellation construct(std::span<const S> sites, const Options& options) {
    if (std::ssize(sites) > max_sites_in_space)
        throw std::invalid_argument("too many sites: " + std::to_string(sites.size()) +
                                    "; at most " + std::to_string(max_sites_in_space));
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (!are_finite(sites[i]))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
    // Apexes, and who is nearest, want denormals kept; the predicates would be right without.
    const exact::IeeeEnvironment environment;
    switch (options.arithmetic) {
        case Arithmetic::exact:
            return Construction<S, spatial::ExactKernel<S>>(sites, options).run(options);
        case Arithmetic::naive:
            return Construction<S, spatial::NaiveKernel<S>>(sites, options).run(options);
        default:
            throw std::invalid_argument("tessellations of space know exact and naive arithmetic");
    }
}

}  // namespace

SpaceTessellation triangulate(std::span<const Point3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}
SpaceTessellation triangulate(std::span<const Site3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}
SpaceTessellation triangulate(std::span<const power::Site3> sites, Power /*metric*/,
                              const Options& options) {
    return construct(sites, options);
}

}  // namespace signum
