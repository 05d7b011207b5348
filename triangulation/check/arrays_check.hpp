#pragma once
/// What is checked of a tessellation's arrays without knowing a coordinate: numbers, counts, order.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../../core/strided_sites.hpp"
#include "../arrays.hpp"
#include "../structure/judgement.hpp"
#include "../structure/spatial_order.hpp"
#include "../structure/topology.hpp"

namespace signum::triangulation {

/// The sites as the predicates take them. Throws std::invalid_argument for NaN and infinity.
template <class S>
[[nodiscard]] std::vector<S> load(const StridedSites& input) {
    std::vector<S> result(input.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Site site = input[i];
        if (!std::isfinite(site.x) || !std::isfinite(site.y) || !std::isfinite(site.r))
            throw std::invalid_argument("site " + std::to_string(i) + " is not finite");
        result[i] = {site.x, site.y, site.r};
    }
    return result;
}

/// The part of a check that all metrics share.
class ArraysCheck : protected Judgement {
 protected:
    /// Predicates are asked in four passes of the faces, and once over the hidden sites.
    ArraysCheck(const TessellationArrays& arrays, std::size_t sites,
                const ValidationOptions& options)
        : Judgement(options, 4 * arrays.faces.size() + arrays.hidden.size(),
                    std::max(arrays.faces.size(), arrays.hidden.size())),
          arrays_(arrays),
          sites_(sites) {}

    [[nodiscard]] static std::string face_name(Index f) { return "face " + std::to_string(f); }
    [[nodiscard]] const Face& face(Index f) const { return arrays_.faces[at(f)]; }
    [[nodiscard]] Index faces() const { return static_cast<Index>(arrays_.faces.size()); }
    /// Every number names a site; every site is visible or hidden, once; as many faces as Euler
    /// asks.
    void check_sites() {
        const auto n = static_cast<Index>(sites_);
        if (arrays_.sites != n)
            throw Invalid{"the tessellation speaks of " + std::to_string(arrays_.sites) +
                          " sites, the input has " + std::to_string(n)};
        std::vector<Seen> seen(sites_, Seen::nowhere);
        judge_each(arrays_.faces.size(), 0, [&](Notes&, std::size_t each) {
            const auto f = static_cast<Index>(each);
            const Face& v = face(f);
            for (const Index i : v) {
                if (i < infinite || i >= n)
                    throw Invalid{face_name(f) + ": there is no site " + std::to_string(i)};
                if (i != infinite) see_vertex(seen[at(i)]);
            }
            if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
                throw Invalid{face_name(f) + " has a vertex twice"};
        });
        see_hidden(arrays_.hidden, seen);
        if (arrays_.faces.empty()) {
            const auto lone = std::ranges::find(seen, Seen::nowhere);
            if (lone != seen.end()) *lone = Seen::as_vertex;
        }
        check_seen(arrays_.hidden, seen);
        visible_ = static_cast<Index>(std::ranges::count(seen, Seen::as_vertex));
        if (visible_ == 0 && n > 0) throw Invalid{"every site is hidden"};
        const Index expected = visible_ < 2 ? 0 : 2 * visible_ - 2;
        if (faces() != expected) {
            const bool has_infinite = std::ranges::any_of(arrays_.faces, [](const Face& face) {
                return std::ranges::find(face, infinite) != face.end();
            });
            throw Invalid{std::to_string(visible_) + " visible sites have " +
                          std::to_string(expected) + " faces, not " + std::to_string(faces()) +
                          (has_infinite ? "" : "; of the vertex at infinity, -1, there is none")};
        }
    }

    void check_neighbour_count() const {
        if (arrays_.neighbours.size() != arrays_.faces.size())
            throw Invalid{"there are " + std::to_string(arrays_.faces.size()) + " faces, but " +
                          std::to_string(arrays_.neighbours.size()) + " triples of neighbours"};
    }

    /// Glues the faces as their neighbours say; two sites may share several edges.
    void connect() {
        topology_ = Topology(sites_);
        for (const Face& v : arrays_.faces) topology_.add_face(v[0], v[1], v[2]);
        check_neighbour_count();
        judge_each(arrays_.faces.size(), 0, [&](Notes&, std::size_t each) {
            const auto f = static_cast<Index>(each);
            for (unsigned k = 0; k < 3; ++k) {
                const Index g = arrays_.neighbours[each][k];
                const HalfEdge h = Topology::first_edge(f) + (k + 1) % 3;
                // The neighbour's half is glued where it is looked at in its turn.
                topology_.record(f).twin[(k + 1) % 3] = edge_of_neighbour(f, k, g, h);
            }
        });
    }

    /// The sites that are not said to be hidden.
    [[nodiscard]] std::vector<Index> visible_sites() const {
        std::vector<char> is_hidden(sites_, 0);
        for (const Hidden& hidden : arrays_.hidden) is_hidden[at(hidden.site)] = 1;
        std::vector<Index> result;
        for (std::size_t i = 0; i < sites_; ++i)
            if (is_hidden[i] == 0) result.push_back(static_cast<Index>(i));
        return result;
    }

    /// Whether the neighbours are missing, which is noted.
    [[nodiscard]] bool must_find_neighbours() {
        if (!arrays_.neighbours.empty() || faces() == 0) return false;
        note("the neighbours are missing");
        return true;
    }

    /// Glues faces without neighbours along their edges, each of which must be unique.
    void connect_unique() {
        topology_ = Topology(sites_);
        for (const Face& v : arrays_.faces) topology_.add_face(v[0], v[1], v[2]);
        std::vector<std::pair<Edge, HalfEdge>> edges;
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const HalfEdge h = Topology::first_edge(f) + k;
                edges.push_back({{topology_.origin(h), topology_.target(h)}, h});
            }
        std::sort(edges.begin(), edges.end());
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const auto [from, to] = edges[e].first;
            const auto which = [from = from, to = to] {
                return "the edge from " + name(from) + " to " + name(to);
            };
            if (e > 0 && edges[e - 1].first == edges[e].first)
                throw Invalid{which() + " occurs twice: only neighbours can tell which is which"};
            const auto back = std::lower_bound(edges.begin(), edges.end(),
                                               std::pair(Edge{to, from}, HalfEdge{0}));
            if (back == edges.end() || back->first != Edge{to, from})
                throw Invalid{face_name(Topology::face(edges[e].second)) + ": " + which() +
                              " belongs to one face only"};
            topology_.glue(edges[e].second, back->second);
        }
    }

    /// The faces at infinity are one cycle.
    ///
    /// Together with Euler's count and what is shown of the faces in a metric, this makes them a
    /// sphere. Think of a vertex where they were several cycles as of so many vertices. Then the
    /// faces are closed surfaces, and each of them has infinity among its vertices: mapped to the
    /// plane with every face in its orientation, a closed surface cannot leave infinity out. So
    /// there is one surface. Its Euler characteristic, which is at most 2, is 2 and one more for
    /// each vertex that was thought to be several: there are none.
    void check_infinity() const {
        Index degree = 0;
        HalfEdge spoke = 0;
        for (Index f = 0; f < faces(); ++f)
            for (unsigned k = 0; k < 3; ++k)
                if (face(f)[k] == infinite) {
                    ++degree;
                    spoke = Topology::first_edge(f) + k;
                }
        if (degree == 0) throw Invalid{"infinity is no vertex"};
        for ([[maybe_unused]] const HalfEdge h : topology_.fan(spoke)) --degree;
        if (degree != 0) throw Invalid{"the faces at infinity are not one cycle"};
    }

    /// The arrays as the library itself would write them. Of the sites their centres are looked at.
    void check_canonical_order(const StridedSites& sites) {
        LargeArray<Index> ranks;
        if (arrays_.order == Order::curve) ranks = ranks_along_curve(sites, workers());
        const auto rank = [&](Index v) { return v < 0 || ranks.empty() ? v : ranks[at(v)]; };
        Face before = {infinite, infinite, infinite};
        for (Index f = 0; f < faces(); ++f) {
            const auto [a, b, c] = face(f);
            const Face v = {rank(a), rank(b), rank(c)};
            if (v[0] > v[1] || v[0] > v[2])
                note(face_name(f) + " does not begin with its smallest vertex");
            if (v < before) note(face_name(f) + " is not in sorted order");
            before = v;
        }
        for (std::size_t i = 1; i < arrays_.hidden.size(); ++i)
            if (arrays_.hidden[i].site < arrays_.hidden[i - 1].site)
                note("the hidden sites are not in sorted order");
    }

    const TessellationArrays& arrays_;
    std::size_t sites_;
    Topology topology_{0};
    Index visible_ = 0;

 private:
    /// The edge of face g that is h, backwards; g must say so too.
    [[nodiscard]] HalfEdge edge_of_neighbour(Index f, unsigned k, Index g, HalfEdge h) const {
        if (g >= 0 && g < faces())
            for (unsigned m = 0; m < 3; ++m) {
                const HalfEdge back = Topology::first_edge(g) + (m + 1) % 3;
                if (arrays_.neighbours[at(g)][m] == f &&
                    topology_.origin(back) == topology_.target(h) &&
                    topology_.target(back) == topology_.origin(h))
                    return back;
            }
        throw Invalid{face_name(f) + ": neighbour " + std::to_string(k) + " is given as " +
                      std::to_string(g) + ", which does not share the edge"};
    }
};

}  // namespace signum::triangulation
