#pragma once
/// Triangulations of CGAL's as signum's arrays, and such arrays as triangulations of CGAL's. Law 3
/// of ../cgal.hpp.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <CGAL/Unique_hash_map.h>

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>
#include <signum/triangulation/arrays.hpp>
#include <signum/triangulation/space/triangulate.hpp>
#include <signum/triangulation/tessellation.hpp>
#include "points.hpp"

namespace signum::cgal {

namespace details {

/// Whether a triangulation is one of the plane, and whether its points carry weights.
template <class T>
inline constexpr bool is_planar = requires {
    typename T::Face_handle;
};
template <class T>
inline constexpr bool is_weighted = requires(const typename T::Point& p) {
    p.weight();
};

/// The points or sites that go to and from a triangulation.
template <class T>
using SiteOf =
    std::conditional_t<is_planar<T>, std::conditional_t<is_weighted<T>, power::Site, Point>,
                       std::conditional_t<is_weighted<T>, power::Site3, Point3>>;
template <class T>
using ResultOf = std::conditional_t<is_planar<T>, TessellationArrays, SpaceTessellation>;

/// The numbers of sites by what they are; of equal ones the first counts.
template <class S>
class Numbers {
 public:
    explicit Numbers(std::span<const S> sites) : sites_(sites), order_(sites.size()) {
        for (std::size_t i = 0; i < sites.size(); ++i) order_[i] = static_cast<Index>(i);
        std::ranges::stable_sort(order_, {}, [this](Index i) { return key(at(i)); });
    }
    [[nodiscard]] Index operator()(const S& site) const {
        const auto found =
            std::ranges::lower_bound(order_, key(site), {}, [this](Index i) { return key(at(i)); });
        if (found == order_.end() || key(at(*found)) != key(site))
            throw std::invalid_argument("a vertex of the triangulation is none of the sites");
        return *found;
    }

 private:
    [[nodiscard]] const S& at(Index i) const { return sites_[static_cast<std::size_t>(i)]; }
    /// Its numbers: what it is made of, and nothing else.
    [[nodiscard]] static auto key(const S& s) {
        return std::bit_cast<std::array<double, sizeof(S) / sizeof(double)>>(s);
    }

    std::span<const S> sites_;
    std::vector<Index> order_;
};

/// Turns a row so that its smallest number comes first and, of a cell, the next smallest second;
/// the orientation stays. Of flat sites numbers rise.
template <std::size_t number>
void turn_row(std::array<Index, number>& row, std::array<Index, number>& neighbours,
              std::size_t used) {
    const auto exchange = [&](std::size_t a, std::size_t b) {
        std::swap(row[a], row[b]);
        std::swap(neighbours[a], neighbours[b]);
    };
    // By exchanges, of which an odd number is made even at the end, where that counts.
    bool is_odd = false;
    for (std::size_t k = 1; k < used; ++k)
        for (std::size_t m = k; m > 0 && row[m] < row[m - 1]; --m) {
            exchange(m, m - 1);
            is_odd = !is_odd;
        }
    if (is_odd && used == number) exchange(number - 2, number - 1);
}

/// Rows turned and sorted, each with its neighbours, which are renumbered.
template <std::size_t number>
void put_in_order(std::vector<std::array<Index, number>>& rows,
                  std::vector<std::array<Index, number>>& neighbours, std::size_t used = number) {
    const std::size_t count = rows.size();
    std::vector<Index> order(count);
    for (std::size_t i = 0; i < count; ++i) {
        order[i] = static_cast<Index>(i);
        turn_row(rows[i], neighbours[i], used);
    }
    std::ranges::sort(order, {}, [&](Index i) { return rows[static_cast<std::size_t>(i)]; });
    std::vector<Index> place(count);
    for (std::size_t i = 0; i < count; ++i)
        place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
    const auto sorted = [&](const auto& all) {
        auto result = all;
        for (std::size_t i = 0; i < count; ++i) result[i] = all[static_cast<std::size_t>(order[i])];
        return result;
    };
    rows = sorted(rows);
    neighbours = sorted(neighbours);
    for (auto& row : neighbours)
        for (std::size_t k = 0; k < used; ++k) row[k] = place[static_cast<std::size_t>(row[k])];
}

/// All faces or cells of a triangulation, infinite ones too, as rows of the sites' numbers.
template <std::size_t number, class T, class Handles, class Visit>
void read_rows(const T& triangulation, const Handles& handles, Visit number_of, std::size_t used,
               std::vector<std::array<Index, number>>& rows,
               std::vector<std::array<Index, number>>& neighbours) {
    using Handle = typename Handles::value_type;
    CGAL::Unique_hash_map<Handle, Index> numbers;
    Index count = 0;
    for (const Handle h : handles) numbers[h] = count++;
    for (const Handle h : handles) {
        auto& row = rows.emplace_back();
        auto& across = neighbours.emplace_back();
        row.fill(no_vertex);
        across.fill(no_vertex);
        for (std::size_t k = 0; k < used; ++k) {
            const auto v = h->vertex(static_cast<int>(k));
            row[k] = triangulation.is_infinite(v) ? infinite : number_of(v);
            across[k] = numbers[h->neighbor(static_cast<int>(k))];
        }
    }
}

/// The faces of visible sites on one line, in their order along it: between neighbours one on
/// either side, tied to infinity; beyond the ends the two sides meet.
inline void read_line(const std::vector<Index>& line, std::vector<Face>& faces,
                      std::vector<Face>& neighbours) {
    const auto last = static_cast<Index>(line.size()) - 2;
    for (Index i = 0; i <= last; ++i) {
        const Index a = line[static_cast<std::size_t>(i)];
        const Index b = line[static_cast<std::size_t>(i) + 1];
        const Index left = 2 * i;
        const Index right = left + 1;
        faces.push_back({a, b, infinite});
        neighbours.push_back({i == last ? right : left + 2, i == 0 ? right : left - 2, right});
        faces.push_back({b, a, infinite});
        neighbours.push_back({i == 0 ? left : right - 2, i == last ? left : right + 2, left});
    }
}

}  // namespace details

/// A Delaunay or regular triangulation of CGAL's, on any traits whose numbers are doubles, as
/// signum's arrays, in canonical order (triangulation/arrays.hpp,
/// triangulation/space/triangulate.hpp). `sites` are the points that it was made of, Point,
/// power::Site, Point3 or power::Site3, in any order: they give the numbers; of equal ones the
/// first is visible. Throws std::invalid_argument for a vertex that is none of them, and for sites
/// where the triangulation has no vertex. O(n log n), and for each hidden site the way to the
/// nearest.
template <class T>
[[nodiscard]] details::ResultOf<T> arrays(const T& triangulation,
                                          std::span<const details::SiteOf<T>> sites) {
    using S = details::SiteOf<T>;
    const details::Numbers<S> numbers(sites);
    std::vector<bool> is_visible(sites.size(), false);
    std::vector<Index> visible;
    const auto number_of = [&](const auto& vertex) {
        return numbers(details::ours(vertex->point()));
    };
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
         ++v) {
        visible.push_back(number_of(v));
        is_visible[static_cast<std::size_t>(visible.back())] = true;
    }
    if (visible.empty() && !sites.empty())
        throw std::invalid_argument("sites, and a triangulation of none");
    details::ResultOf<T> result;
    result.sites = static_cast<std::int64_t>(sites.size());
    const int dimension = triangulation.dimension();
    if constexpr (details::is_planar<T>) {
        if (details::is_weighted<T>) result.weight_is = WeightIs::weight;
        if (dimension == 2) {
            std::vector<typename T::Face_handle> handles;
            for (const auto f : triangulation.all_face_handles()) handles.push_back(f);
            details::read_rows(triangulation, handles, number_of, 3, result.faces,
                               result.neighbours);
        } else if (dimension == 1) {
            std::ranges::sort(visible, {}, [&](Index i) {
                const S& s = sites[static_cast<std::size_t>(i)];
                return std::pair(s.x, s.y);
            });
            details::read_line(visible, result.faces, result.neighbours);
        }
        details::put_in_order(result.faces, result.neighbours);
    } else {
        result.dimension = dimension;
        const auto used = static_cast<std::size_t>(dimension + 1);
        std::vector<typename T::Cell_handle> handles;
        if (dimension >= 0)
            for (auto c = triangulation.tds().raw_cells_begin();
                 c != triangulation.tds().raw_cells_end(); ++c)
                handles.push_back(c);
        details::read_rows(triangulation, handles, number_of, used, result.cells,
                           result.neighbours);
        details::put_in_order(result.cells, result.neighbours, used);
    }
    // Whoever is hidden: of points the equal one, of sites with weights the nearest.
    std::vector<Site> plane;
    if constexpr (details::is_planar<T> && details::is_weighted<T>)
        if (visible.size() < sites.size() && visible.size() > 1)
            for (const S& s : sites) plane.push_back({s.x, s.y, s.w});
    const Tessellation tessellation = [&]() -> Tessellation {
        if constexpr (details::is_planar<T>)
            if (!plane.empty()) return {result, std::move(plane), {}};
        return {};
    }();
    for (std::size_t i = 0; i < sites.size(); ++i) {
        if (is_visible[i]) continue;
        const S& s = sites[i];
        Index by = visible.front();
        if constexpr (!details::is_weighted<T>)
            by = numbers(s);
        else if constexpr (!details::is_planar<T>)
            by = number_of(triangulation.nearest_power_vertex({s.x, s.y, s.z}));
        else if (visible.size() > 1)
            by = tessellation.nearest({s.x, s.y});
        result.hidden.push_back({static_cast<Index>(i), by});
    }
    return result;
}

/// The other way: makes a triangulation of CGAL's out of signum's arrays, without asking a
/// predicate but for flat sites and hidden ones, and returns the vertex of every site: of a hidden
/// point that of the equal one, of a hidden site what CGAL's insert() returns, which keeps it among
/// its own hidden ones. Flat sites are inserted as CGAL does. Throws std::invalid_argument where
/// the sites are not as many as the arrays say. Precondition: the arrays are a tessellation of the
/// sites, with their neighbours; of whom one does not know that, validate() is to be asked. O(n),
/// and CGAL's insertions of those.
template <class T>
std::vector<typename T::Vertex_handle> assign(T& triangulation, const details::ResultOf<T>& result,
                                              std::span<const details::SiteOf<T>> sites) {
    if (result.sites != static_cast<std::int64_t>(sites.size()))
        throw std::invalid_argument("the tessellation is of " + std::to_string(result.sites) +
                                    " sites, and there are " + std::to_string(sites.size()));
    using Vertex_handle = typename T::Vertex_handle;
    std::vector<bool> is_hidden(sites.size(), false);
    for (const Hidden& h : result.hidden) is_hidden[static_cast<std::size_t>(h.site)] = true;
    std::vector<Vertex_handle> vertices(sites.size());
    const auto point = [&](std::size_t i) { return details::theirs<typename T::Point>(sites[i]); };

    const auto& rows = [&]() -> const auto& {
        if constexpr (details::is_planar<T>)
            return result.faces;
        else
            return result.cells;
    }
    ();
    const bool is_flat = [&] {
        if constexpr (details::is_planar<T>)
            return std::ranges::none_of(rows, [](const Face& face) { return face[0] >= 0; });
        else
            return result.dimension < 3;
    }();
    if (is_flat) {
        triangulation.clear();
        for (std::size_t i = 0; i < sites.size(); ++i)
            if (!is_hidden[i]) vertices[i] = triangulation.insert(point(i));
    } else {
        auto& tds = triangulation.tds();
        triangulation.clear();
        tds.clear();
        tds.set_dimension(details::is_planar<T> ? 2 : 3);
        const Vertex_handle at_infinity = tds.create_vertex();
        triangulation.set_infinite_vertex(at_infinity);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            if (is_hidden[i]) continue;
            vertices[i] = tds.create_vertex();
            vertices[i]->set_point(point(i));
        }
        const auto vertex = [&](Index i) {
            return i == infinite ? at_infinity : vertices[static_cast<std::size_t>(i)];
        };
        const auto create = [&](const auto& row) {
            if constexpr (details::is_planar<T>) {
                const auto f = tds.create_face(vertex(row[0]), vertex(row[1]), vertex(row[2]));
                for (const Index i : row) vertex(i)->set_face(f);
                return f;
            } else {
                const auto c =
                    tds.create_cell(vertex(row[0]), vertex(row[1]), vertex(row[2]), vertex(row[3]));
                for (const Index i : row) vertex(i)->set_cell(c);
                return c;
            }
        };
        std::vector<decltype(create(rows.front()))> handles;
        handles.reserve(rows.size());
        for (const auto& row : rows) handles.push_back(create(row));
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t k = 0; k < rows[i].size(); ++k)
                handles[i]->set_neighbor(
                    static_cast<int>(k),
                    handles[static_cast<std::size_t>(result.neighbours[i][k])]);
    }
    for (const auto& [site, by] : result.hidden) {
        Vertex_handle& hidden = vertices[static_cast<std::size_t>(site)];
        if constexpr (details::is_weighted<T>)
            hidden = triangulation.insert(point(static_cast<std::size_t>(site)));
        else
            hidden = vertices[static_cast<std::size_t>(by)];
    }
    return vertices;
}

}  // namespace signum::cgal
