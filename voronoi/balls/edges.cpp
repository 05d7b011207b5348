#include "edges.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "exact_sphere.hpp"
#include "rounded_order.hpp"
#include "vertex_curves.hpp"

namespace signum::balls {
namespace {

class EdgeSearch {
 public:
    EdgeSearch(const BallSet& balls, const BallVertices& found) : balls_(balls), found_(found) {}

    /// The ball that turns positively begins to conflict, and the edge ends.
    void run(BallDiagram& result) {
        for (std::size_t v = 0; v < found_.vertices.size(); ++v) {
            const auto name = static_cast<Index>(v);
            const BallVertex& vertex = found_.vertices[v];
            if (vertex.touching.empty() && vertex.turn != 0) {
                const auto [a, b, c, d] = vertex.four;
                const bool positive = vertex.turn > 0;
                ends_.push_back({{a, b, c}, name, !positive});
                ends_.push_back({{a, b, d}, name, positive});
                ends_.push_back({{a, c, d}, name, !positive});
                ends_.push_back({{b, c, d}, name, positive});
            } else {
                add_ends(vertex, name);
            }
        }
        std::ranges::sort(ends_, [](const End& a, const End& b) {
            if (a.curve != b.curve) return a.curve < b.curve;
            if (a.vertex != b.vertex) return a.vertex < b.vertex;
            return a.is_start < b.is_start;
        });
        for (std::size_t first = 0; first < ends_.size();) {
            std::size_t last = first;
            while (last < ends_.size() && ends_[last].curve == ends_[first].curve) ++last;
            join({ends_.data() + first, last - first});
            first = last;
        }
        for (const FreeCurve& curve : found_.free_curves) {
            const Triple three{curve.touching[0], curve.touching[1], curve.touching[2]};
            if (std::ranges::binary_search(ends_, three, {}, &End::curve)) continue;
            if (curve.touching.size() > 3) longer_[three] = curve.touching;
            const Index end = curve.is_loop ? no_end : infinite;
            edges_.push_back({three, {end, end}});
        }
        put_sorted(result);
    }

 private:
    /// A vertex on the curve of three balls, of which these are the first that touch along it: an
    /// edge begins there or ends there, forward along the curve (exact_sphere.hpp).
    struct End {
        Triple curve;
        Index vertex;
        bool is_start;
    };

    /// Of a vertex that more than four balls touch, or four in one plane.
    void add_ends(const BallVertex& vertex, Index name) {
        for (const VertexCurve& curve : curves_at(balls_, vertex)) {
            const Triple three{curve.touching[0], curve.touching[1], curve.touching[2]};
            if (curve.is_start) ends_.push_back({three, name, true});
            if (curve.is_end) ends_.push_back({three, name, false});
            if (curve.touching.size() > 3) longer_[three] = curve.touching;
        }
    }

    /// From each start to the next end, forward along a curve; to infinity, where there is none.
    void join(std::span<const End> ends) {
        const Triple& curve = ends.front().curve;
        const auto add = [&](Index start, Index end) {
            edges_.push_back({curve, {std::min(start, end), std::max(start, end)}});
        };
        const auto starts = std::ranges::count_if(ends, &End::is_start);
        if (ends.size() == 1) {
            add(ends[0].vertex, infinite);
            return;
        }
        const bool is_bounded = std::ranges::any_of(curve, [&](Index i) {
            return found_.may_be_unbounded[static_cast<std::size_t>(i)] == 0;
        });
        if (ends.size() == 2 && starts == 1 && is_bounded) {
            add(ends[0].vertex, ends[1].vertex);
            return;
        }
        const std::array<Site3, 3> balls = balls_.of(curve);
        const RoundedOrder rounded(balls);
        std::vector<Index> names;
        std::vector<Site3> spheres;
        for (const End& end : ends) {
            if (!names.empty() && names.back() == end.vertex) continue;
            names.push_back(end.vertex);
            spheres.push_back(found_.vertices[static_cast<std::size_t>(end.vertex)].sphere);
        }
        std::optional<std::vector<std::size_t>> order = rounded(spheres);
        if (!order) {
            std::vector<ExactSphere> exact_spheres;
            for (const Index name : names)
                exact_spheres.push_back(
                    exact_sphere_of(balls_, found_.vertices[static_cast<std::size_t>(name)]));
            order = forward_order(balls, exact_spheres);
        }
        std::vector<End> in_order;
        for (const std::size_t place : *order)
            for (const bool is_start : {false, true})
                for (const End& end : ends)
                    if (end.vertex == names[place] && end.is_start == is_start)
                        in_order.push_back(end);
        // On a loop what begins last ends first.
        Index before = infinite;
        if (rounded.loop() != 0 ? rounded.loop() > 0 : is_loop(balls)) {
            const End& last = in_order.back();
            if (last.is_start) before = last.vertex;
        }
        Index open = before;
        bool is_open = !in_order.front().is_start;
        for (const End& end : in_order) {
            if (end.is_start) {
                open = end.vertex;
                is_open = true;
            } else {
                add(open, end.vertex);
                is_open = false;
            }
        }
        if (is_open && before == infinite) add(open, infinite);
    }

    struct Edge {
        Triple curve;
        std::array<Index, 2> ends;
    };
    void put_sorted(BallDiagram& result) {
        std::ranges::sort(edges_, [&](const Edge& a, const Edge& b) {
            const auto order = compare(touching_of(a), touching_of(b));
            return order != 0 ? order < 0 : a.ends < b.ends;
        });
        for (const Edge& edge : edges_) {
            result.edges.add(touching_of(edge));
            result.ends.push_back(edge.ends);
        }
    }
    [[nodiscard]] std::span<const Index> touching_of(const Edge& edge) const {
        const auto longer = longer_.find(edge.curve);
        if (longer == longer_.end()) return edge.curve;
        return longer->second;
    }

    const BallSet& balls_;
    const BallVertices& found_;
    std::vector<End> ends_;
    std::vector<Edge> edges_;
    std::map<Triple, std::vector<Index>> longer_;  // of curves that more than three touch
};

}  // namespace

void find_edges(const BallSet& balls, const BallVertices& found, BallDiagram& result) {
    EdgeSearch(balls, found).run(result);
}

}  // namespace signum::balls
