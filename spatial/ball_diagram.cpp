#include "ball_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "../exact/floating_environment.hpp"
#include "../filters/bounds.hpp"
#include "../predicates/space/ball_filter.hpp"
#include "../predicates/space/ccw.hpp"
#include "../predicates/space/euclidean.hpp"
#include "ball_cell.hpp"
#include "ball_tree.hpp"
#include "exact_sphere.hpp"
#include "touching_spheres.hpp"

namespace signum {
namespace {

using spatial::BallTree;
using spatial::CellSearch;
using spatial::ExactSphere;

constexpr std::size_t most_balls = std::size_t{1} << 28;

using Triple = std::array<Index, 3>;
using Quadruple = std::array<Index, 4>;

template <class... S>
[[nodiscard]] bool same_radius(const Site3& first, const S&... others) noexcept {
    return (filters::same_number(first.r, others.r) && ...);
}

/// Whether Γ (ball_polynomials.hpp) is certainly not 0: then no sphere touches the four balls in
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

/// What forward_order() says (exact_sphere.hpp), from spheres whose numbers are rounded: nothing
/// where that is not certain.
///
/// By heights n·x, n = X_b × X_c; on a loop also by whether the height rises forward, that is the
/// sign of det[w', b, c, (n, 0)] = h n·n + x·(R_b X_c × n - R_c X_b × n).
///
/// The bounds. Each number of a sphere errs by a part of 2^-53, and so do differences. With l the
/// sum of magnitudes, n errs by a part of 2^-51 of the sums of its products, m; W = <b,b> <c,c> -
/// <b,c>² by one of 2^-47 of the products of the sums of squares, heights and rises by less than
/// 2^-46 of the products below. Nothing is certain where numbers underflow.
class RoundedOrder {
 public:
    RoundedOrder(const std::array<Site3, 3>& curve) : first_(curve[0]) {
        using euclidean::balls::Row;
        using euclidean::balls::filter::pinned;
        const Row<3, double> b = euclidean::balls::row<3, double>(pinned(curve[1]), pinned(first_));
        const Row<3, double> c = euclidean::balls::row<3, double>(pinned(curve[2]), pinned(first_));
        const auto product = [](const Row<3, double>& p, const Row<3, double>& q) {
            return (p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) - p[3] * q[3];
        };
        const auto size = [&](const Row<3, double>& p) {
            return product(p, p) + 2.0 * p[3] * p[3];
        };
        const double bc = product(b, c);
        const double w = product(b, b) * product(c, c) - bc * bc;
        const double bound = 0x1p-46 * (size(b) * size(c)) + 0x1p-900;
        loop_ = w < -bound ? 1 : w > bound ? -1 : 0;
        double length_b = 0.0, length_c = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            normal_[k] = b[l] * c[m] - b[m] * c[l];
            size_ += filters::magnitude(b[l] * c[m]) + filters::magnitude(b[m] * c[l]);
            length_b += filters::magnitude(b[k]);
            length_c += filters::magnitude(c[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            rise_[k] = b[3] * (c[l] * normal_[m] - c[m] * normal_[l]) -
                       c[3] * (b[l] * normal_[m] - b[m] * normal_[l]);
        }
        size_of_rise_ =
            (filters::magnitude(b[3]) * length_c + filters::magnitude(c[3]) * length_b) * size_;
    }

    /// +1 of a loop, -1 of an open curve, 0 where that is not certain.
    [[nodiscard]] int loop() const noexcept { return loop_; }

    [[nodiscard]] std::optional<std::vector<std::size_t>> operator()(
        std::span<const Site3> spheres) const {
        if (loop_ == 0) return std::nullopt;
        struct Key {
            double rise, height, size;
            std::size_t number;
        };
        std::vector<Key> keys;
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            const Site3& s = spheres[i];
            const double x = s.x - first_.x, y = s.y - first_.y, z = s.z - first_.z;
            const double size = filters::magnitude(s.x) + filters::magnitude(s.y) +
                                filters::magnitude(s.z) + filters::magnitude(first_.x) +
                                filters::magnitude(first_.y) + filters::magnitude(first_.z);
            double rise = 1.0;
            if (loop_ > 0) {
                const double square =
                    normal_[0] * normal_[0] + normal_[1] * normal_[1] + normal_[2] * normal_[2];
                const double value =
                    (s.r + first_.r) * square + (x * rise_[0] + y * rise_[1] + z * rise_[2]);
                const double error =
                    0x1p-46 *
                        ((filters::magnitude(s.r) + filters::magnitude(first_.r)) * size_ * size_ +
                         size * size_of_rise_) +
                    0x1p-900;
                if (!(filters::magnitude(value) > error)) return std::nullopt;
                rise = value > 0.0 ? 1.0 : -1.0;
            }
            const double height = x * normal_[0] + y * normal_[1] + z * normal_[2];
            keys.push_back({rise, height, size * size_, i});
        }
        std::ranges::sort(keys, [](const Key& p, const Key& q) {
            if (p.rise != q.rise) return p.rise > q.rise;
            return p.rise * p.height < q.rise * q.height;
        });
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const bool is_first = i == 0 || keys[i - 1].rise != keys[i].rise;
            if (!is_first && !(filters::magnitude(keys[i].height - keys[i - 1].height) >
                               0x1p-46 * (keys[i].size + keys[i - 1].size) + 0x1p-900))
                return std::nullopt;
            order.push_back(keys[i].number);
        }
        return order;
    }

 private:
    Site3 first_;
    int loop_ = 0;
    std::array<double, 3> normal_, rise_;
    double size_ = 0.0;
    double size_of_rise_ = 0.0;
};

/// A sphere that touches three balls, roughly: where the greatest distance along their curve is
/// least. Seen from the first ball it is the direction u with f_b(u) = f_c(u) (ball_cell.hpp).
///
/// The bounds. Where P is more than a part of 2^-10 of what it is the difference of, a and b err by
/// a part of 2^-40; where the difference N of the two a is no smaller than a part of 2^-8 of them,
/// the circle's radius no smaller than 2^-5, and the part of a across N one of 2^-10 of it, u is
/// off by less than 2^-18 from a direction of the curve. What is more by 2^-14 is certainly more.
class RoughSphere {
 public:
    RoughSphere(const Site3& i, const Site3& j, const Site3& k) : first_(i) {
        Function b, c;
        if (!function(j, b) || !function(k, c)) return;
        std::array<double, 3> n, across;
        double square = 0.0, along = 0.0, rest = 0.0;
        for (std::size_t m = 0; m < 3; ++m) {
            n[m] = b.a[m] - c.a[m];
            square += n[m] * n[m];
            along += n[m] * b.a[m];
        }
        const double difference = b.b - c.b, lengths = b.length + c.length;
        if (!(square > 0x1p-16 * lengths * lengths)) return;
        const double radius = 1.0 - difference * difference / square;
        for (std::size_t m = 0; m < 3; ++m) {
            across[m] = b.a[m] - along / square * n[m];
            rest += across[m] * across[m];
        }
        if (!(radius > 0x1p-10) || !(rest > 0x1p-20 * b.length * b.length)) return;
        for (std::size_t m = 0; m < 3; ++m)
            u_[m] = std::sqrt(radius / rest) * across[m] - difference / square * n[m];
        value_ = at(b);
        length_ = b.length;
        is_known_ = value_ > 0x1p-14 * length_;
    }
    [[nodiscard]] bool certainly_conflicts(const Site3& q) const {
        Function f;
        return is_known_ && function(q, f) &&
               at(f) > value_ + 0x1p-14 * (length_ + f.length + std::fabs(f.b));
    }

 private:
    struct Function {
        std::array<double, 3> a;
        double b, length;
    };
    [[nodiscard]] bool function(const Site3& j, Function& f) const {
        const double x = j.x - first_.x, y = j.y - first_.y, z = j.z - first_.z;
        const double r = j.r - first_.r, square = x * x + y * y + z * z;
        const double p = square - r * r;
        if (!(p > 0x1p-10 * (square + r * r) && p > 0x1p-200 && p < 0x1p200)) return false;
        f = {{2.0 * x / p, 2.0 * y / p, 2.0 * z / p}, 2.0 * r / p, 2.0 * std::sqrt(square) / p};
        return true;
    }
    [[nodiscard]] double at(const Function& f) const {
        return f.a[0] * u_[0] + f.a[1] * u_[1] + f.a[2] * u_[2] + f.b;
    }

    Site3 first_;
    std::array<double, 3> u_ = {};
    double value_ = 0.0;
    double length_ = 0.0;
    bool is_known_ = false;
};

class DiagramConstruction {
 public:
    DiagramConstruction(std::span<const Site3> balls, const Options& options)
        : balls_(balls), options_(options) {}

    [[nodiscard]] BallDiagram run() {
        result_.balls = static_cast<std::int64_t>(balls_.size());
        scale();
        find_hidden();
        find_vertices();
        sort_vertices();
        find_edges();
        return std::move(result_);
    }

 private:
    [[nodiscard]] const Site3& ball(Index i) const noexcept {
        return balls_[static_cast<std::size_t>(i)];
    }
    template <std::size_t n>
    [[nodiscard]] std::array<Site3, n> balls_of(const std::array<Index, n>& names) const noexcept {
        std::array<Site3, n> balls;
        for (std::size_t m = 0; m < n; ++m) balls[m] = ball(names[m]);
        return balls;
    }

    /// By a power of two, so that the largest number is about 1.
    void scale() {
        double largest = 0.0;
        for (const Site3& b : balls_)
            for (const double number : {b.x, b.y, b.z, b.r})
                largest = std::max(largest, std::fabs(number));
        int exponent = 0;
        std::frexp(largest, &exponent);
        scaled_.reserve(balls_.size());
        for (const Site3& b : balls_)
            scaled_.push_back({std::ldexp(b.x, -exponent), std::ldexp(b.y, -exponent),
                               std::ldexp(b.z, -exponent), std::ldexp(b.r, -exponent)});
    }
    [[nodiscard]] BallTree tree_of(std::vector<Index> names) const {
        std::vector<Site3> balls;
        balls.reserve(names.size());
        for (const Index i : names) balls.push_back(scaled_[static_cast<std::size_t>(i)]);
        return {std::move(balls), std::move(names)};
    }

    // ---- hidden balls ---------------------------------------------------------------------------

    [[nodiscard]] bool hides(Index i, Index q) const noexcept {
        if (i == q || euclidean::hides_decision(ball(i), ball(q)).sign < 0) return false;
        return i < q || euclidean::hides_decision(ball(q), ball(i)).sign < 0;
    }
    /// Calls visit(i) for all that may hide q, until it returns false.
    template <class Visit>
    bool visit_hiders(const BallTree& tree, std::size_t number, const Site3& q,
                      const Visit& visit) const {
        const BallTree::Node& node = tree.nodes()[number];
        const double more = node.greatest_radius - q.r;
        if (more < 0.0) return true;
        const std::array<double, 3> centre{q.x, q.y, q.z};
        double square = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double away = std::max({node.low[k] - centre[k], centre[k] - node.high[k], 0.0});
            square += away * away;
        }
        if (square * (1.0 - 0x1p-48) > more * more + 0x1p-1000) return true;
        if (node.second != 0)
            return visit_hiders(tree, number + 1, q, visit) &&
                   visit_hiders(tree, node.second, q, visit);
        for (std::size_t place = node.first; place < node.last; ++place)
            if (tree.ball(place).r >= q.r && !visit(tree.name(place))) return false;
        return true;
    }
    void find_hidden() {
        std::vector<Index> all(balls_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
        is_hidden_.assign(balls_.size(), 0);
        if (all.empty()) return;
        const BallTree tree = tree_of(all);
        std::vector<Index> hidden;
        for (const Index q : all) {
            const auto is_no_hider = [&](Index i) { return !hides(i, q); };
            if (visit_hiders(tree, 0, scaled_[static_cast<std::size_t>(q)], is_no_hider)) continue;
            is_hidden_[static_cast<std::size_t>(q)] = 1;
            hidden.push_back(q);
        }
        for (const Index q : hidden) {
            Index by = std::numeric_limits<Index>::max();
            const auto note = [&](Index i) {
                if (i < by && is_hidden_[static_cast<std::size_t>(i)] == 0 && hides(i, q)) by = i;
                return true;
            };
            visit_hiders(tree, 0, scaled_[static_cast<std::size_t>(q)], note);
            result_.hidden.push_back({q, by});
        }
    }

    // ---- vertices -------------------------------------------------------------------------------

    /// A sphere that touches four balls. The positive one of b0, b1, b2, b3 where turn is 1, of b0,
    /// b2, b1, b3 where it is -1; where it is 0, `flat`.
    struct Vertex {
        Quadruple four;
        Sign turn;
        std::vector<Index> touching;  // all, where they are more than the four
        Site3 sphere;
    };
    /// Three balls whose curve meets no vertex.
    struct FreeCurve {
        std::vector<Index> touching;
        bool is_loop;
    };

    /// Of each ball: its cell, and those vertices and curves of which it is the first.
    void find_vertices() {
        std::vector<Index> visible;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            if (is_hidden_[i] == 0) visible.push_back(static_cast<Index>(i));
        may_be_unbounded_.assign(balls_.size(), 0);
        if (visible.empty()) return;
        const BallTree tree = tree_of(std::move(visible));
        CellSearch search(tree);
        constexpr std::size_t between_questions = 256;
        constexpr std::size_t many = 12;
        for (std::size_t place = 0; place < tree.size(); ++place) {
            if (place % between_questions == 0) {
                if (options_.stop.stop_requested()) throw Stopped();
                if (options_.progress)
                    options_.progress(static_cast<double>(place) /
                                      static_cast<double>(tree.size()));
            }
            const Index i = tree.name(place);
            fours_.clear();
            pairs_.clear();
            const auto take = [&](std::span<const CellSearch::Place> list, std::size_t later) {
                later_.clear();
                for (std::size_t m = 0; m < later; ++m) later_.push_back(tree.name(list[m]));
                std::ranges::sort(later_);
                const bool are_flat = later > many && are_points_of_a_plane(i, later_);
                for (std::size_t a = 0; a < later; ++a) {
                    for (std::size_t b = a + 1; b < later; ++b) {
                        pairs_.push_back({i, later_[a], later_[b]});
                        for (std::size_t c = b + 1; c < later && !are_flat; ++c)
                            fours_.push_back({i, later_[a], later_[b], later_[c]});
                    }
                }
            };
            search.run(static_cast<CellSearch::Place>(place), take);
            may_be_unbounded_[static_cast<std::size_t>(i)] = search.may_be_unbounded() ? 1 : 0;
            neighbours_.clear();
            for (const CellSearch::Place near : search.neighbours())
                neighbours_.push_back(tree.name(near));
            const auto once = [](auto& tuples) {
                std::ranges::sort(tuples);
                tuples.erase(std::unique(tuples.begin(), tuples.end()), tuples.end());
            };
            once(fours_);
            once(pairs_);
            for (const Quadruple& four : fours_) try_four(four);
            for (const Triple& curve : pairs_) try_curve(curve);
        }
    }

    /// The face of a grid, say: seen from one of them, all meet in the direction away from the
    /// others. No four of them have a vertex.
    [[nodiscard]] bool are_points_of_a_plane(Index i, std::span<const Index> list) const {
        const Site3& first = ball(i);
        if (!std::ranges::all_of(list, [&](Index j) { return same_radius(first, ball(j)); }))
            return false;
        const auto turn = [&](Index j, Index k, Index l) {
            return ccw_decision(centre3(first), centre3(ball(j)), centre3(ball(k)),
                                centre3(ball(l)))
                .sign;
        };
        for (std::size_t k = 1; k < list.size(); ++k)
            for (std::size_t l = k + 1; l < list.size(); ++l)
                if (turn(list[0], list[k], list[l]) != 0) return false;
        return true;
    }

    /// Whether infinitely many spheres touch four balls, of which one sphere touches all.
    [[nodiscard]] bool touch_along_a_curve(const Quadruple& four) const {
        const auto [a, b, c, d] = balls_of(four);
        if (same_radius(a, b, c, d))
            return ccw_decision(centre3(a), centre3(b), centre3(c), centre3(d)).sign == 0;
        if (euclidean::exists_decision(a, b, c, d).sign > 0) return false;
        if (euclidean::exists_decision(a, c, b, d).sign > 0) return false;
        return spatial::touch_along_a_curve({a, b, c, d});
    }

    void try_four(const Quadruple& four) {
        const auto [a, b, c, d] = balls_of(four);
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
        touching_.assign(four.begin(), four.end());
        for (std::size_t place = 0; place < neighbours_.size(); ++place) {
            const Index q = neighbours_[place];
            if (std::find(four.begin(), four.end(), q) != four.end()) continue;
            const Sign sign = conflict(ball(q));
            if (sign == 0) touching_.push_back(q);
            if (sign <= 0) continue;
            // Who has a conflict has others, too.
            std::swap(neighbours_[place], neighbours_[place / 2]);
            return;
        }
        if (touching_.size() == 4) return add_vertex({four, turn, {}, {}});
        std::ranges::sort(touching_);
        if (is_first_four(four, touching_)) add_vertex({four, turn, touching_, {}});
    }
    /// Whether they are the first four in the list, in the order of words, that finitely many
    /// spheres touch. Of three this is so always.
    [[nodiscard]] bool is_first_four(const Quadruple& four, std::span<const Index> list) const {
        for (std::size_t m = 0; m < 3; ++m)
            if (four[m] != list[m]) return false;
        for (std::size_t m = 3; list[m] != four[3]; ++m)
            if (!touch_along_a_curve({four[0], four[1], four[2], list[m]})) return false;
        return true;
    }
    void add_vertex(Vertex vertex) {
        const TouchingSpheres<Site3> found = touching_spheres(balls_of(vertex.four));
        for (const TouchingSphere<Site3>& each : found.spheres) {
            if (each.orientation != vertex.turn) continue;
            vertex.sphere = each.sphere;
            break;
        }
        vertices_.push_back(std::move(vertex));
    }

    /// A curve without a vertex is an edge as a whole where no other ball ever touches, and none
    /// conflicts with one of its spheres.
    void try_curve(const Triple& curve) {
        const auto [a, b, c] = balls_of(curve);
        const auto scaled = [&](Index i) -> const Site3& {
            return scaled_[static_cast<std::size_t>(i)];
        };
        const RoughSphere rough(scaled(curve[0]), scaled(curve[1]), scaled(curve[2]));
        for (std::size_t place = 0; place < neighbours_.size(); ++place) {
            const Index q = neighbours_[place];
            if (q == curve[1] || q == curve[2]) continue;
            const Site3& l = ball(q);
            if (!rough.certainly_conflicts(scaled(q)) &&
                euclidean::exists_decision(a, b, c, l).sign < 0 &&
                euclidean::exists_decision(a, c, b, l).sign < 0)
                continue;
            std::swap(neighbours_[place], neighbours_[place / 2]);
            return;
        }
        const std::optional<ExactSphere> sphere = ExactSphere::on_curve({a, b, c});
        if (!sphere) return;
        FreeCurve free{{curve.begin(), curve.end()}, false};
        for (const Index q : neighbours_) {
            if (q == curve[1] || q == curve[2]) continue;
            const Sign sign = sphere->conflict(ball(q));
            if (sign < 0) continue;
            if (sign > 0 || !touch_along_a_curve({curve[0], curve[1], curve[2], q})) return;
            free.touching.push_back(q);
        }
        std::ranges::sort(free.touching);
        if (!std::equal(curve.begin(), curve.end(), free.touching.begin())) return;
        free.is_loop = spatial::is_loop({a, b, c});
        free_curves_.push_back(std::move(free));
    }

    [[nodiscard]] static std::span<const Index> touching_of(const Vertex& vertex) noexcept {
        if (vertex.touching.empty()) return vertex.four;
        return vertex.touching;
    }
    void sort_vertices() {
        std::ranges::sort(vertices_, [](const Vertex& v, const Vertex& w) {
            if (!v.touching.empty() || !w.touching.empty()) {
                const auto a = touching_of(v), b = touching_of(w);
                const auto order =
                    std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
                if (order != 0) return order < 0;
            } else if (v.four != w.four) {
                return v.four < w.four;
            }
            return v.turn > w.turn;
        });
        for (const Vertex& vertex : vertices_) {
            result_.vertices.add(touching_of(vertex));
            result_.spheres.push_back(vertex.sphere);
            result_.turns.push_back(vertex.turn);
        }
    }

    // ---- edges ----------------------------------------------------------------------------------

    /// A vertex on the curve of three balls, of which these are the first that touch along it: an
    /// edge begins there or ends there, forward along the curve (exact_sphere.hpp).
    struct End {
        Triple curve;
        Index vertex;
        bool is_start;
    };

    /// The ball that turns positively begins to conflict, and the edge ends.
    void find_edges() {
        for (std::size_t v = 0; v < vertices_.size(); ++v) {
            const auto name = static_cast<Index>(v);
            const Vertex& vertex = vertices_[v];
            if (vertex.touching.empty() && vertex.turn != 0) {
                const auto [a, b, c, d] = vertex.four;
                const bool positive = vertex.turn > 0;
                ends_.push_back({{a, b, c}, name, !positive});
                ends_.push_back({{a, b, d}, name, positive});
                ends_.push_back({{a, c, d}, name, !positive});
                ends_.push_back({{b, c, d}, name, positive});
            } else {
                find_ends(vertex, name);
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
        for (const FreeCurve& curve : free_curves_) {
            const Triple three{curve.touching[0], curve.touching[1], curve.touching[2]};
            if (std::ranges::binary_search(ends_, three, {}, &End::curve)) continue;
            if (curve.touching.size() > 3) longer_[three] = curve.touching;
            const Index end = curve.is_loop ? no_end : infinite;
            edges_.push_back({three, {end, end}});
        }
        sort_edges();
    }

    [[nodiscard]] ExactSphere exact(const Vertex& vertex) const {
        const std::array<Site3, 4> four = balls_of(vertex.four);
        for (ExactSphere& sphere : ExactSphere::touching(four))
            if (sphere.turn(four[0], four[1], four[2], four[3]) == vertex.turn)
                return std::move(sphere);
        throw std::logic_error("a vertex of four balls without a sphere");
    }
    /// How the points of contact of four balls turn on the sphere of a vertex that touches them.
    [[nodiscard]] Sign turn(const Vertex& vertex, std::optional<ExactSphere>& sphere, Index i,
                            Index j, Index k, Index l) const {
        const auto [a, b, c, d] = balls_of(Quadruple{i, j, k, l});
        if (same_radius(a, b, c, d))
            return ccw_decision(centre3(a), centre3(b), centre3(c), centre3(d)).sign;
        const bool positive = euclidean::exists_decision(a, b, c, d).sign > 0;
        const bool negative = euclidean::exists_decision(a, c, b, d).sign > 0;
        if (positive != negative) return positive ? 1 : -1;
        if (!positive) return 0;
        if (!sphere) sphere = exact(vertex);
        return sphere->turn(a, b, c, d);
    }
    /// Of a vertex that more than four balls touch, or four in one plane: each three of them.
    void find_ends(const Vertex& vertex, Index name) {
        const std::span<const Index> list = touching_of(vertex);
        std::optional<ExactSphere> sphere;
        std::vector<Index> along;
        for (std::size_t i = 0; i < list.size(); ++i) {
            for (std::size_t j = i + 1; j < list.size(); ++j) {
                for (std::size_t k = j + 1; k < list.size(); ++k) {
                    const Triple curve{list[i], list[j], list[k]};
                    bool is_start = true, is_end = true, is_first = true;
                    along.clear();
                    for (std::size_t l = 0; l < list.size() && is_first && (is_start || is_end);
                         ++l) {
                        if (l == i || l == j || l == k) continue;
                        const Sign sign = turn(vertex, sphere, list[i], list[j], list[k], list[l]);
                        if (sign > 0) is_start = false;
                        if (sign < 0) is_end = false;
                        if (sign != 0) continue;
                        if (touch_along_a_curve({curve[0], curve[1], curve[2], list[l]})) {
                            is_first = l > k;
                            along.push_back(list[l]);
                            continue;
                        }
                        if (!sphere) sphere = exact(vertex);
                        if (sphere->is_only_one_free_of(balls_of(curve), ball(list[l])))
                            is_start = is_end = false;
                    }
                    if (!is_first) continue;
                    if (is_start) ends_.push_back({curve, name, true});
                    if (is_end) ends_.push_back({curve, name, false});
                    if (along.empty() || !(is_start || is_end)) continue;
                    std::vector<Index>& longer = longer_[curve];
                    longer.assign(curve.begin(), curve.end());
                    longer.insert(longer.end(), along.begin(), along.end());
                }
            }
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
        const bool is_bounded = std::ranges::any_of(
            curve, [&](Index i) { return may_be_unbounded_[static_cast<std::size_t>(i)] == 0; });
        if (ends.size() == 2 && starts == 1 && is_bounded) {
            add(ends[0].vertex, ends[1].vertex);
            return;
        }
        const std::array<Site3, 3> balls = balls_of(curve);
        const RoundedOrder rounded(balls);
        std::vector<Index> names;
        std::vector<Site3> spheres;
        for (const End& end : ends) {
            if (!names.empty() && names.back() == end.vertex) continue;
            names.push_back(end.vertex);
            spheres.push_back(vertices_[static_cast<std::size_t>(end.vertex)].sphere);
        }
        std::optional<std::vector<std::size_t>> order = rounded(spheres);
        if (!order) {
            std::vector<ExactSphere> exact_spheres;
            for (const Index name : names)
                exact_spheres.push_back(exact(vertices_[static_cast<std::size_t>(name)]));
            order = spatial::forward_order(balls, exact_spheres);
        }
        std::vector<End> in_order;
        for (const std::size_t place : *order)
            for (const bool is_start : {false, true})
                for (const End& end : ends)
                    if (end.vertex == names[place] && end.is_start == is_start)
                        in_order.push_back(end);
        // On a loop what begins last ends first.
        Index before = infinite;
        if (rounded.loop() != 0 ? rounded.loop() > 0 : spatial::is_loop(balls)) {
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
        friend auto operator<=>(const Edge&, const Edge&) = default;
    };
    void sort_edges() {
        if (longer_.empty()) {
            std::ranges::sort(edges_);
        } else {
            std::ranges::sort(edges_, [&](const Edge& a, const Edge& b) {
                const auto p = touching_of(a), q = touching_of(b);
                const auto order =
                    std::lexicographical_compare_three_way(p.begin(), p.end(), q.begin(), q.end());
                return order != 0 ? order < 0 : a.ends < b.ends;
            });
        }
        for (const Edge& edge : edges_) {
            result_.edges.add(touching_of(edge));
            result_.ends.push_back(edge.ends);
        }
    }
    [[nodiscard]] std::span<const Index> touching_of(const Edge& edge) const {
        const auto longer = longer_.find(edge.curve);
        if (longer == longer_.end()) return edge.curve;
        return longer->second;
    }

    std::span<const Site3> balls_;
    const Options& options_;
    BallDiagram result_;
    std::vector<Site3> scaled_;
    std::vector<char> is_hidden_;
    std::vector<char> may_be_unbounded_;
    std::vector<Vertex> vertices_;
    std::vector<FreeCurve> free_curves_;
    // Of the ball in question: who may be its neighbours, and what is to be tried.
    std::vector<Index> neighbours_;
    std::vector<Index> later_;
    std::vector<Index> touching_;
    std::vector<Quadruple> fours_;
    std::vector<Triple> pairs_;
    std::vector<End> ends_;
    std::vector<Edge> edges_;
    std::map<Triple, std::vector<Index>> longer_;  // of curves that more than three touch
};

/// Out of line, so that no arithmetic leaves the guard around the call.
[[nodiscard, gnu::noinline]] BallDiagram construct_diagram(std::span<const Site3> balls,
                                                           const Options& options) {
    return DiagramConstruction(balls, options).run();
}

}  // namespace

BallDiagram ball_diagram(std::span<const Site3> balls, const Options& options) {
    if (balls.size() > most_balls)
        throw std::invalid_argument("too many balls: " + std::to_string(balls.size()) +
                                    "; at most " + std::to_string(most_balls));
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!are_finite(balls[i]))
            throw std::invalid_argument("ball " + std::to_string(i) + " is not finite");
    const exact::IeeeEnvironment environment;
    return construct_diagram(balls, options);
}

}  // namespace signum
