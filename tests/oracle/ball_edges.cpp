#include "ball_edges.hpp"

#include "balls_space.hpp"
#include "linear_system.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace signum::oracle {
namespace {

using Sphere = TouchingSphere<3>;

Rational dot(const RationalVector& a, const RationalVector& b) {
    Rational sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

/// x·x' - h h' of (x, h) and (x', h')
Rational of_cone(const RationalVector& a, const RationalVector& b) {
    return dot(a, b) - 2 * a.back() * b.back();
}

RationalVector sum(const RationalVector& a, const Rational& t, const RationalVector& b) {
    RationalVector result = a;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += t * b[k];
    return result;
}

/// The spheres that touch three balls, of which none contains another: with x = c - c_0 and h = rho
/// + r_0, they are the points (x, h) of a plane with |x| = h. They are looked at along parallel
/// lines of the plane, each of which meets them once or, if they are an ellipse, twice.
class TouchingCurve {
 public:
    TouchingCurve(const SpaceBall<3>& a, const SpaceBall<3>& b, const SpaceBall<3>& c) : first_(a) {
        std::vector<RationalVector> rows;
        for (const SpaceBall<3>& ball : {b, c}) {
            // |x - X| = h + R, squared, less |x| = h: 2 X·x + 2 R h = |X|² - R²
            RationalVector row;
            for (std::size_t k = 0; k < 3; ++k) row.push_back(ball.c[k] - a.c[k]);
            row.push_back(ball.r - a.r);
            const Rational square = of_cone(row, row);
            for (Rational& number : row) number *= 2;
            row.push_back(square);
            rows.push_back(std::move(row));
        }
        const std::optional<Flat> plane = solutions(std::move(rows), 4);
        if (!plane) return;
        if (plane->directions.size() != 2)
            throw std::logic_error("oracle: three balls in no general position");
        origin_ = plane->point;
        choose_directions(plane->directions[0], plane->directions[1]);
        if (is_ellipse_) {
            // Lines from the first to the last that meet it: b² - ac >= 0 as below, of the points
            // origin + t across.
            const Rational a0 = of_cone(along_, along_), b0 = of_cone(origin_, along_),
                           b1 = of_cone(across_, along_);
            const Rational square = b1 * b1 - a0 * of_cone(across_, across_);
            const Rational middle = b0 * b1 - a0 * of_cone(origin_, across_);
            const Rational rest = b0 * b0 - a0 * of_cone(origin_, origin_);
            const Rational g = middle * middle - square * rest;
            if (g.sign() <= 0) return;
            ends_ = {Surd(-middle / square, 1 / square, g), Surd(-middle / square, -1 / square, g)};
            if (ends_[1] < ends_[0]) std::swap(ends_[0], ends_[1]);
        }
        const Rational inside = is_ellipse_ ? between(ends_[0], ends_[1]) : Rational(0);
        exists_ = !at(inside).empty();
    }

    bool exists() const { return exists_; }
    bool is_ellipse() const { return is_ellipse_; }
    /// Of an ellipse the first and the last line.
    const std::array<Surd, 2>& ends() const { return ends_; }

    /// The line on which a sphere lies.
    Surd line(const Sphere& sphere) const { return product(across_form_, sphere); }
    /// On which side of the middle of this line's part in an ellipse, or 0 if it is the middle.
    int half(const Sphere& sphere) const {
        RationalVector form = along_;
        form.back() = -form.back();
        return product(form, sphere).sign();
    }

    /// The spheres on a line: for an ellipse those of its first half and its second.
    std::vector<Sphere> at(const Rational& line) const {
        const RationalVector p = sum(origin_, line, across_);
        const Rational a = of_cone(along_, along_), b = of_cone(p, along_), c = of_cone(p, p);
        std::vector<Surd> roots;
        if (a.is_zero()) {
            roots = {Surd(-c / (2 * b))};
        } else {
            const Rational g = b * b - a * c;
            if (g.sign() < 0) return {};
            roots = {{-b / a, 1 / a, g}, {-b / a, -1 / a, g}};
        }
        std::vector<Sphere> spheres;
        for (const Surd& root : roots) {
            const auto number = [&](std::size_t k) { return Surd(p[k]) + root * Surd(along_[k]); };
            if (number(3).sign() < 0) continue;
            Sphere& sphere = spheres.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) sphere.c[k] = number(k) + Surd(first_.c[k]);
            sphere.rho = number(3) - Surd(first_.r);
        }
        if (spheres.size() == 2 && half(spheres[0]) < 0) std::swap(spheres[0], spheres[1]);
        return spheres;
    }

 private:
    /// Lines are to meet a branch once: they go along a direction within the cone if there is one,
    /// or on it.
    void choose_directions(const RationalVector& d, const RationalVector& e) {
        const Rational a = of_cone(d, d), b = of_cone(d, e), c = of_cone(e, e);
        const int kind = Rational(a * c - b * b).sign();
        is_ellipse_ = kind > 0;
        along_ = d;
        if (kind == 0 && !a.is_zero()) along_ = sum(e, -b / a, d);
        if (kind < 0 && a.sign() > 0) along_ = sum(e, -b / a, d);
        if (kind < 0 && a.is_zero()) along_ = sum(e, -(c + 1) / (2 * b), d);
        across_ = along_ == d ? e : d;
        // Of a point origin + t across + u along this is t.
        RationalVector along_row = along_, across_row = across_;
        along_row.push_back(0);
        across_row.push_back(1);
        across_form_ = solutions({along_row, across_row}, 4)->point;
        origin_ = sum(origin_, -dot(across_form_, origin_), across_);
    }

    /// Of a form and (x, h).
    Surd product(const RationalVector& form, const Sphere& sphere) const {
        Surd result = (sphere.rho + Surd(first_.r)) * Surd(form.back());
        for (std::size_t k = 0; k < 3; ++k)
            result = result + (sphere.c[k] - Surd(first_.c[k])) * Surd(form[k]);
        return result;
    }

    SpaceBall<3> first_;
    RationalVector origin_, along_, across_, across_form_;
    std::array<Surd, 2> ends_;
    bool is_ellipse_ = false;
    bool exists_ = false;
};

/// The curve of three balls between those of its points where others touch.
class Arcs {
 public:
    Arcs(std::span<const SpaceBall<3>> balls, const std::vector<std::size_t>& visible,
         const std::array<std::size_t, 3>& triple)
        : balls_(balls), curve_(balls[triple[0]], balls[triple[1]], balls[triple[2]]) {
        if (!curve_.exists()) return;
        for (const std::size_t q : visible) {
            if (std::find(triple.begin(), triple.end(), q) != triple.end()) {
                edge_.balls.push_back(static_cast<std::int32_t>(q));
                continue;
            }
            const auto touching = touching_spheres<3>(
                {balls[triple[0]], balls[triple[1]], balls[triple[2]], balls[q]});
            if (touching.count == SphereCount::infinitely_many) {
                edge_.balls.push_back(static_cast<std::int32_t>(q));
                continue;
            }
            others_.push_back(q);
            stops_.insert(stops_.end(), touching.spheres.begin(), touching.spheres.end());
        }
        curve_.is_ellipse() ? go_around() : go_along();
    }

    const BallEdge& edge() const { return edge_; }

 private:
    bool is_empty(const Sphere& sphere) const {
        return std::all_of(others_.begin(), others_.end(),
                           [&](std::size_t q) { return side<3>(sphere, balls_[q]) > 0; });
    }

    static void sort(std::vector<Surd>& lines) {
        std::sort(lines.begin(), lines.end());
        lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
    }

    void go_along() {
        std::vector<Surd> lines;
        for (const Sphere& stop : stops_) lines.push_back(curve_.line(stop));
        sort(lines);
        const auto beyond = [](const Surd& x, int sign) {  // √g <= 1 + g
            return Rational(x.a() + sign * (abs(x.b()) * (1 + x.g()) + 1));
        };
        std::vector<Rational> samples;
        samples.push_back(lines.empty() ? Rational(0) : beyond(lines.front(), -1));
        for (std::size_t i = 1; i < lines.size(); ++i)
            samples.push_back(between(lines[i - 1], lines[i]));
        if (!lines.empty()) samples.push_back(beyond(lines.back(), 1));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!is_empty(curve_.at(samples[i]).at(0))) continue;
            ++edge_.arcs;
            edge_.ends_at_infinity += (i == 0) + (i + 1 == samples.size());
            std::optional<Sphere> first, last;
            if (i > 0) first = stop_on(lines[i - 1], {});
            if (i < lines.size()) last = stop_on(lines[i], {});
            edge_.ends.push_back({first, last});
        }
    }
    /// The stop on a line; of an ellipse that in one of its halves.
    std::optional<Sphere> stop_on(const Surd& line, std::optional<int> half) const {
        for (const Sphere& stop : stops_)
            if (curve_.line(stop) == line && (!half || curve_.half(stop) == *half)) return stop;
        return {};
    }
    /// Of an ellipse, between two lines in one of its halves, in the direction around.
    struct Piece {
        bool is_arc;
        std::optional<Sphere> first;
        std::optional<Sphere> last;  // none where the next one goes on
    };

    /// From the first line to the last in the one half, and back in the other. Where the halves
    /// meet a piece ends; unless there is a stop, its arc goes on.
    void go_around() {
        std::vector<Piece> pieces;
        for (const int half : {1, -1}) {
            std::vector<Surd> lines(curve_.ends().begin(), curve_.ends().end());
            for (const Sphere& stop : stops_)
                if (curve_.half(stop) == half) lines.push_back(curve_.line(stop));
            sort(lines);
            // The halves meet on the first line and on the last.
            const auto end = [&](std::size_t i) {
                return stop_on(lines[i], i == 0 || i + 1 == lines.size() ? 0 : half);
            };
            std::vector<Piece> of_half;
            for (std::size_t i = 1; i < lines.size(); ++i) {
                const bool is_arc =
                    is_empty(curve_.at(between(lines[i - 1], lines[i])).at(half > 0 ? 0 : 1));
                of_half.push_back({is_arc, end(i - 1), end(i)});
            }
            if (half < 0) {
                std::reverse(of_half.begin(), of_half.end());
                for (Piece& piece : of_half) std::swap(piece.first, piece.last);
            }
            pieces.insert(pieces.end(), of_half.begin(), of_half.end());
        }
        const auto next = [&](std::size_t i) { return i + 1 == pieces.size() ? 0 : i + 1; };
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (!pieces[i].is_arc || !pieces[i].first) continue;
            std::size_t j = i;
            while (!pieces[j].last) j = next(j);
            ++edge_.arcs;
            edge_.ends.push_back({pieces[i].first, pieces[j].last});
        }
        if (stops_.empty() && pieces[0].is_arc) {
            edge_.arcs = 1;
            edge_.is_closed = true;
        }
    }

    std::span<const SpaceBall<3>> balls_;
    TouchingCurve curve_;
    std::vector<std::size_t> others_;  // visible balls that do not touch all along the curve
    std::vector<Sphere> stops_;        // where one of them touches
    BallEdge edge_;
};

}  // namespace

std::vector<BallEdge> ball_edges(std::span<const SpaceBall<3>> balls) {
    const std::vector<bool> hidden = hidden_balls(balls);
    std::vector<std::size_t> visible;
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!hidden[i]) visible.push_back(i);
    std::vector<BallEdge> edges;
    for (std::size_t k = 0; k < visible.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j) {
            for (std::size_t i = 0; i < j; ++i) {
                const Arcs arcs(balls, visible, {visible[i], visible[j], visible[k]});
                if (arcs.edge().arcs > 0) edges.push_back(arcs.edge());
            }
        }
    }
    // Of four balls on one curve each three have found it.
    const auto by_balls = [](const BallEdge& a, const BallEdge& b) { return a.balls < b.balls; };
    std::sort(edges.begin(), edges.end(), by_balls);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

}  // namespace signum::oracle
