#include "vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../filters/bounds.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/space/ball_filter.hpp"
#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/euclidean.hpp"
#include "../../triangulation/structure/watch.hpp"
#include "cell.hpp"
#include "equal_radii.hpp"
#include "exact_sphere.hpp"
#include "rough_sphere.hpp"
#include "touching_spheres.hpp"
#include "tree.hpp"

namespace signum::balls {
namespace {

/// In sites of a tessellation, by which Workers judge whether several threads are worth it.
constexpr std::size_t work_of_a_ball = 256;

/// Whether Γ (formulas/balls.hpp) is certainly not 0: then no sphere touches the four balls in
/// points of one plane. By the filter of exists().
[[nodiscard]] bool is_certainly_not_flat(const Site3& i, const Site3& j, const Site3& k,
                                         const Site3& l) noexcept {
    using namespace euclidean::balls;
    const std::array<Ball<3, double>, 4> balls{filter::pinned(i), filter::pinned(j),
                                               filter::pinned(k), filter::pinned(l)};
    const std::array<Row<3, double>, 3> rows{row<3, double>(balls[1], balls[0]),
                                             row<3, double>(balls[2], balls[0]),
                                             row<3, double>(balls[3], balls[0])};
    const auto between = rows_between<3, double>(balls);
    const auto sizes = filter::sizes_of<3>(rows);
    const auto sizes_between = filter::sizes_of<3>(between);
    filter::Window window;
    window.take(sizes);
    window.take(sizes_between);
    if (!window.holds_all()) return false;
    const double g = filter::root_of_gamma_size(sizes, sizes_between);
    const double bound = (filter::roundings<3>.four_gamma + 3) * filters::epsilon * (g * g);
    return filters::magnitude(four_gamma<3, double>(rows, between)) > bound;
}

/// In space three centres are on a line where they are so in each plane of two axes.
[[nodiscard]] bool are_on_a_line(const Site3& a, const Site3& b, const Site3& c) noexcept {
    return ccw_decision(Point{a.x, a.y}, Point{b.x, b.y}, Point{c.x, c.y}).sign == 0 &&
           ccw_decision(Point{a.y, a.z}, Point{b.y, b.z}, Point{c.y, c.z}).sign == 0 &&
           ccw_decision(Point{a.z, a.x}, Point{b.z, b.x}, Point{c.z, c.x}).sign == 0;
}

/// What one thread finds.
class VertexSearch {
 public:
    /// may_be_unbounded: by ball, of which nobody else writes those that are asked here.
    VertexSearch(const BallSet& balls, const EqualRadii& equal, const BallTree& tree,
                 std::vector<char>& may_be_unbounded)
        : balls_(balls), equal_(equal), tree_(tree), may_be_unbounded_(may_be_unbounded) {}

    /// Of a ball: its cell, and those vertices and curves of which it is the first.
    void find_of(CellSearch::Place place, CellSearch& search) {
        const Index i = tree_.name(place);
        fours_.clear();
        pairs_.clear();
        before_.clear();
        const auto once = [](auto& tuples) {
            std::ranges::sort(tuples);
            tuples.erase(std::unique(tuples.begin(), tuples.end()), tuples.end());
        };
        // No more are kept than twice as many as there are.
        constexpr std::size_t least_untidy = 1 << 14;
        std::size_t most_untidy = least_untidy;
        const auto take = [&](std::span<const CellSearch::Place> list, std::size_t later) {
            later_.clear();
            for (std::size_t m = 0; m < later; ++m) later_.push_back(tree_.name(list[m]));
            std::ranges::sort(later_);
            if (later_ == before_) return;  // beside one another patches have the same
            before_ = later_;
            if (fours_.size() + pairs_.size() > most_untidy) {
                once(fours_);
                once(pairs_);
                most_untidy = 2 * (fours_.size() + pairs_.size()) + least_untidy;
            }
            for (std::size_t a = 0; a < later; ++a) {
                for (std::size_t b = a + 1; b < later; ++b) {
                    const Triple three{i, later_[a], later_[b]};
                    const bool are_of_a_kind = equal_.are_of_a_kind(three);
                    if (!are_of_a_kind) pairs_.push_back(three);
                    for (std::size_t c = b + 1; c < later; ++c)
                        if (!are_of_a_kind || equal_.kind(i) != equal_.kind(later_[c]))
                            fours_.push_back({i, later_[a], later_[b], later_[c]});
                }
            }
        };
        search.run(place, take);
        may_be_unbounded_[static_cast<std::size_t>(i)] = search.may_be_unbounded() ? 1 : 0;
        neighbours_.clear();
        for (const CellSearch::Place near : search.neighbours())
            neighbours_.push_back(tree_.name(near));
        once(fours_);
        once(pairs_);
        for (const Quadruple& four : fours_) try_four(four);
        for (const Quadruple& four : equal_.fours(i)) try_four_of_a_kind(four);
        for (const Triple& curve : pairs_) try_curve(curve, 0);
        for (const std::vector<Index>& curve : equal_.curves(i)) try_curve(curve, equal_.kind(i));
    }

    std::vector<BallVertex> vertices;
    std::vector<FreeCurve> free_curves;

 private:
    void try_four(const Quadruple& four) {
        const auto [a, b, c, d] = balls_.of(four);
        const bool positive = euclidean::exists_decision(a, b, c, d).sign > 0;
        const bool negative = euclidean::exists_decision(a, c, b, d).sign > 0;
        if (positive) {
            try_sphere(four, 1, [&, a = a, b = b, c = c, d = d](const Site3& q) {
                return euclidean::in_sphere_decision(a, b, c, d, q).sign;
            });
        }
        if (negative) {
            try_sphere(four, -1, [&, a = a, b = b, c = c, d = d](const Site3& q) {
                return euclidean::in_sphere_decision(a, c, b, d, q).sign;
            });
        }
        if (positive || negative || same_radius(a, b, c, d)) return;
        if (is_certainly_not_flat(a, b, c, d)) return;
        for (const ExactSphere& sphere : ExactSphere::touching({a, b, c, d}))
            try_sphere(four, 0, [&](const Site3& q) { return sphere.conflict(q); });
    }
    template <class Conflict>
    void try_sphere(const Quadruple& four, Sign turn, const Conflict& conflict) {
        if (!find_touching(four, turn, four[2], conflict)) return;
        if (touching_.size() == 4) return add_vertex({four, turn, {}, {}});
        std::ranges::sort(touching_);
        if (is_first_four(four, touching_)) add_vertex({four, turn, touching_, {}});
    }
    /// All that touch a sphere; false where some ball conflicts with it, or where one touches that
    /// comes before `least` and is not of the four. What has no conflict with the first is mostly
    /// a vertex: then its sphere, rounded, tells most others from those that must be asked.
    template <class Conflict>
    [[nodiscard]] bool find_touching(const Quadruple& four, Sign turn, Index least,
                                     const Conflict& conflict) {
        constexpr std::size_t asked_first = 16;
        touching_.assign(four.begin(), four.end());
        rounded_.reset();
        bool is_rounded = false;
        for (std::size_t place = 0; place < neighbours_.size(); ++place) {
            const Index q = neighbours_[place];
            if (std::find(four.begin(), four.end(), q) != four.end()) continue;
            if (place >= asked_first && !is_rounded) {
                rounded_ = rounded_sphere(four, turn);
                is_rounded = true;
            }
            if (rounded_ && is_certainly_outside(*rounded_, balls_[q])) continue;
            const Sign sign = conflict(balls_[q]);
            if (sign < 0) continue;
            if (sign == 0 && q > least) {
                touching_.push_back(q);
                continue;
            }
            // Who is in the way of one is in that of others, too.
            std::swap(neighbours_[place], neighbours_[place / 2]);
            return false;
        }
        return true;
    }
    /// Those whose first four are not of a kind are found otherwise.
    void try_four_of_a_kind(const Quadruple& four) {
        const auto [a, b, c, d] = balls_.of(four);
        const bool is_positive =
            ccw_decision(centre3(a), centre3(b), centre3(c), centre3(d)).sign > 0;
        const bool is_empty = find_touching(
            four, is_positive ? 1 : -1, four[0],
            [&, a = a, b = is_positive ? b : c, c = is_positive ? c : b, d = d](const Site3& q) {
                return euclidean::in_sphere_decision(a, b, c, d, q).sign;
            });
        if (!is_empty) return;
        if (touching_.size() == 4) return add_vertex({four, is_positive ? 1 : -1, {}, {}});
        std::ranges::sort(touching_);
        Quadruple first{touching_[0], touching_[1], touching_[2], touching_[3]};
        for (std::size_t m = 4; balls_.touch_along_a_curve(first); ++m) first[3] = touching_[m];
        if (!equal_.are_of_a_kind(first)) return;
        const auto [i, j, k, l] = balls_.of(first);
        const Sign turn = ccw_decision(centre3(i), centre3(j), centre3(k), centre3(l)).sign;
        add_vertex({first, turn, touching_, {}});
    }
    /// Whether they are the first four in the list, in the order of words, that finitely many
    /// spheres touch: none is in it before the third of them but these. Of three this is so always.
    [[nodiscard]] bool is_first_four(const Quadruple& four, std::span<const Index> list) const {
        for (std::size_t m = 3; list[m] != four[3]; ++m)
            if (!balls_.touch_along_a_curve({four[0], four[1], four[2], list[m]})) return false;
        return true;
    }
    void add_vertex(BallVertex vertex) {
        if (!rounded_) rounded_ = rounded_sphere(vertex.four, vertex.turn);
        if (!rounded_)
            throw std::logic_error("balls touch no sphere of the orientation that was found");
        vertex.sphere = *rounded_;
        vertices.push_back(std::move(vertex));
    }
    [[nodiscard]] std::optional<Site3> rounded_sphere(const Quadruple& four, Sign turn) const {
        const TouchingSpheres<Site3> found = touching_spheres(balls_.of(four));
        for (const TouchingSphere<Site3>& each : found.spheres)
            if (each.orientation == turn) return each.sphere;
        return {};
    }
    /// Of a sphere whose numbers are each rounded once. Where one of them is infinite, none is.
    [[nodiscard]] static bool is_certainly_outside(const Site3& sphere, const Site3& q) {
        const double x = q.x - sphere.x, y = q.y - sphere.y, z = q.z - sphere.z;
        const double sizes = std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z) + std::fabs(q.r) +
                             std::fabs(sphere.x) + std::fabs(sphere.y) + std::fabs(sphere.z) +
                             std::fabs(sphere.r);
        return std::hypot(x, y, z) - sphere.r - q.r > 0x1p-46 * sizes + 0x1p-1060;
    }

    /// A curve without a vertex is an edge as a whole where no other ball ever touches, and none
    /// conflicts with one of its spheres. Of the balls of a kind that is not 0 it is known which
    /// touch along it, and that no others do.
    void try_curve(std::span<const Index> known, EqualRadii::Kind kind) {
        const Triple curve{known[0], known[1], known[2]};
        const auto [a, b, c] = balls_.of(curve);
        const auto is_known = [&](Index q) {
            return q == curve[1] || q == curve[2] || (kind != 0 && equal_.kind(q) == kind);
        };
        const RoughSphere rough(balls_.scaled(curve[0]), balls_.scaled(curve[1]),
                                balls_.scaled(curve[2]));
        for (std::size_t place = 0; place < neighbours_.size(); ++place) {
            const Index q = neighbours_[place];
            if (is_known(q)) continue;
            const Site3& l = balls_[q];
            if (!rough.certainly_conflicts(balls_.scaled(q)) &&
                euclidean::exists_decision(a, b, c, l).sign < 0 &&
                euclidean::exists_decision(a, c, b, l).sign < 0)
                continue;
            std::swap(neighbours_[place], neighbours_[place / 2]);
            return;
        }
        const std::optional<ExactSphere> sphere = ExactSphere::on_curve({a, b, c});
        if (!sphere) return;
        FreeCurve free{{known.begin(), known.end()}, false};
        for (const Index q : neighbours_) {
            if (is_known(q)) continue;
            const Sign sign = sphere->conflict(balls_[q]);
            if (sign < 0) continue;
            if (sign > 0 || !balls_.touch_along_a_curve({curve[0], curve[1], curve[2], q})) return;
            free.touching.push_back(q);
        }
        std::ranges::sort(free.touching);
        const Triple first{free.touching[0], free.touching[1], free.touching[2]};
        if (kind == 0 ? first != curve : !equal_.are_of_a_kind(first)) return;
        free.is_loop = is_loop({a, b, c});
        free_curves.push_back(std::move(free));
    }

    const BallSet& balls_;
    const EqualRadii& equal_;
    const BallTree& tree_;
    std::vector<char>& may_be_unbounded_;
    // Of the ball in question: who may be its neighbours, and what is to be tried.
    std::vector<Index> neighbours_;
    std::vector<Index> later_;
    std::vector<Index> before_;
    std::vector<Index> touching_;
    std::optional<Site3> rounded_;  // the sphere that is asked about, where it is known
    std::vector<Quadruple> fours_;
    std::vector<Triple> pairs_;
};

/// The direction of the line that all centres are on.
[[nodiscard]] std::optional<Point3> line_of(const BallSet& balls, const BallTree& tree) {
    const Site3& first = tree.ball(0);
    Point3 direction;
    double length = 0.0;
    std::size_t last = 0;
    for (std::size_t place = 1; place < tree.size(); ++place) {
        const Site3& b = tree.ball(place);
        const Point3 way = minus(centre3(b), centre3(first));
        const double its_length = std::hypot(way.x, way.y, way.z);
        if (!(its_length > length)) continue;
        length = its_length;
        direction = way;
        last = place;
    }
    if (!(length > 0x1p-960)) return {};
    direction = {direction.x / length, direction.y / length, direction.z / length};
    const Site3 &a = balls[tree.name(0)], &b = balls[tree.name(last)];
    for (std::size_t place = 1; place < tree.size(); ++place)
        if (!are_on_a_line(a, b, balls[tree.name(place)])) return {};
    return direction;
}

[[nodiscard]] std::vector<Index> visible_of(const BallSet& balls, std::span<const Hidden> hidden) {
    std::vector<Index> visible;
    for (std::size_t i = 0, h = 0; i < balls.size(); ++i) {
        if (h < hidden.size() && hidden[h].site == static_cast<Index>(i)) {
            ++h;
        } else {
            visible.push_back(static_cast<Index>(i));
        }
    }
    return visible;
}

}  // namespace

BallVertices find_vertices(const BallSet& balls, std::span<const Hidden> hidden,
                           const Options& options) {
    BallVertices result;
    result.may_be_unbounded.assign(balls.size(), 0);
    const std::vector<Index> visible = visible_of(balls, hidden);
    if (visible.empty()) return result;
    const EqualRadii equal(balls, visible, options);
    const BallTree tree = balls.tree_of(visible);
    std::vector<EqualRadii::Kind> kinds;
    for (std::size_t place = 0; place < tree.size(); ++place)
        kinds.push_back(equal.kind(tree.name(place)));
    const std::optional<Point3> line = line_of(balls, tree);

    const std::size_t work = work_of_a_ball * tree.size();
    const Workers workers(options.threads, work);
    const std::size_t ranges = workers.range_count(work);
    const triangulation::Watch watch(options.stop, options.progress, tree.size(), 256);
    watch.at(0);
    std::vector<std::vector<BallVertex>> vertices(ranges);
    std::vector<std::vector<FreeCurve>> free_curves(ranges);
    workers.each(ranges, [&](std::size_t range) {
        const exact::IeeeEnvironment environment;
        VertexSearch own(balls, equal, tree, result.may_be_unbounded);
        CellSearch search(tree, kinds, line);
        triangulation::Watch::Loop loop(watch);
        for (std::size_t place = tree.size() * range / ranges;
             place < tree.size() * (range + 1) / ranges; ++place) {
            own.find_of(static_cast<CellSearch::Place>(place), search);
            loop.step();
        }
        vertices[range] = std::move(own.vertices);
        free_curves[range] = std::move(own.free_curves);
    });
    result.vertices = joined(workers, std::move(vertices));
    result.free_curves = joined(workers, std::move(free_curves));
    std::ranges::sort(result.vertices, [](const BallVertex& v, const BallVertex& w) {
        const auto order = compare(v.all(), w.all());
        return order != 0 ? order < 0 : v.turn > w.turn;
    });
    return result;
}

}  // namespace signum::balls
