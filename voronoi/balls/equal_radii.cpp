#include "equal_radii.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../../core/groups.hpp"
#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/euclidean.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "exact_sphere.hpp"

namespace signum::balls {
namespace {

/// Fewer are tried one by one.
constexpr std::size_t least_of_a_kind = 6;

/// Which cells of a tessellation have one sphere, or of flat sites one circle. Those whose vertices
/// a sphere touches fill the hull of these, so that they hang together.
template <class IsOnSphere>
Groups same_spheres(const SpaceTessellation& t, std::size_t corners, const IsOnSphere& touches) {
    Groups groups(t.cells.size());
    for (std::size_t c = 0; c < t.cells.size(); ++c) {
        for (std::size_t k = 0; k < corners; ++k) {
            const auto other = static_cast<std::size_t>(t.neighbours[c][k]);
            if (other < c || t.cells[c][0] == infinite || t.cells[other][0] == infinite) continue;
            std::size_t across = 0;
            while (t.neighbours[other][across] != static_cast<Index>(c)) ++across;
            if (touches(c, t.cells[other][across])) groups.join(c, other);
        }
    }
    return groups;
}

}  // namespace

EqualRadii::EqualRadii(const BallSet& balls, std::span<const Index> visible, const Options& options)
    : kinds_(balls.size()) {
    std::vector<Index> order(visible.begin(), visible.end());
    std::ranges::sort(order, [&](Index i, Index j) {
        return balls[i].r != balls[j].r ? balls[i].r < balls[j].r : i < j;
    });
    Kind kind = 0;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last < order.size() && same_radius(balls[order[first]], balls[order[last]])) ++last;
        if (last - first >= least_of_a_kind) {
            ++kind;
            const std::span<const Index> names(order.data() + first, last - first);
            for (const Index i : names) kinds_[static_cast<std::size_t>(i)] = kind;
            tessellate(balls, names, options);
        }
        first = last;
    }
    std::ranges::sort(fours_);
    std::ranges::sort(curves_);
}

void EqualRadii::tessellate(const BallSet& balls, std::span<const Index> names,
                            const Options& options) {
    std::vector<Point3> centres;
    for (const Index i : names) centres.push_back(centre3(balls[i]));
    Options silent;
    silent.stop = options.stop;
    silent.threads = options.threads;
    const SpaceTessellation t = triangulate(std::span<const Point3>(centres), {}, silent);
    const auto name = [&](Index vertex) { return names[static_cast<std::size_t>(vertex)]; };
    const auto ball = [&](Index vertex) -> const Site3& { return balls[name(vertex)]; };
    if (t.dimension == 3) {
        Groups groups = same_spheres(t, 4, [&](std::size_t c, Index q) {
            const auto [i, j, k, l] = t.cells[c];
            return euclidean::in_sphere_decision(ball(i), ball(j), ball(k), ball(l), ball(q))
                       .sign == 0;
        });
        std::vector<Quadruple> first(t.cells.size());  // of each group, in the order of words
        for (std::size_t c = 0; c < t.cells.size(); ++c) {
            if (t.cells[c][0] == infinite) continue;
            Quadruple four;
            for (std::size_t k = 0; k < 4; ++k) four[k] = name(t.cells[c][k]);
            std::ranges::sort(four);
            const std::size_t group = groups.of(c);
            first[group] = group == c ? four : std::min(first[group], four);
        }
        for (std::size_t c = 0; c < t.cells.size(); ++c)
            if (t.cells[c][0] != infinite && groups.of(c) == c) fours_.push_back(first[c]);
    } else if (t.dimension == 2) {
        // A sphere through three of them meets their plane in the circle.
        std::optional<ExactSphere> sphere;
        std::size_t its_cell = t.cells.size();
        Groups groups = same_spheres(t, 3, [&](std::size_t c, Index q) {
            const auto [i, j, k, none] = t.cells[c];
            if (its_cell != c) sphere = ExactSphere::on_curve({ball(i), ball(j), ball(k)});
            its_cell = c;
            return sphere->conflict(ball(q)) == 0;
        });
        std::vector<std::vector<Index>> lists(t.cells.size());
        for (std::size_t c = 0; c < t.cells.size(); ++c)
            for (std::size_t k = 0; k < 3 && t.cells[c][0] != infinite; ++k)
                lists[groups.of(c)].push_back(name(t.cells[c][k]));
        for (std::vector<Index>& list : lists) {
            std::ranges::sort(list);
            list.erase(std::unique(list.begin(), list.end()), list.end());
            if (!list.empty()) curves_.push_back(std::move(list));
        }
    }
}

}  // namespace signum::balls
