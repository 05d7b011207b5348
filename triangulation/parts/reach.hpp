#pragma once
/// Which faces of a part sites beyond a cut may reach.
///
/// Let n point beyond the cut, at a right angle to it, and t be a site beyond. A site that no such
/// t can take a point from is *settled*; the faces of a part tell which may not be.
///
///  - power: t conflicts with a face whose vertex p has a power of more than |p - t|² - w_t. A site
///    none of whose faces conflicts with any t keeps its star when they come, one after the other.
///    The faces in conflict with t lie side by side, and some of them at infinity, for far out
///    towards n t is nearer than every site of the part.
///  - the others: let h be the least n·t, and G no less than any radius, those of the part's own
///    sites among them. With f(q) = d(q, s) - r_s + n·q for the site s nearest to q, a face may be
///    reached where f(p) >= h - G at its vertex p; all faces at infinity may.
///
///    *Ends of edges decide:* on an edge f is greatest at one of its ends.
///      · Euclid: f = const is a parabola with focus s, the bisector half a hyperbola with the same
///        focus; two such conics meet at most twice. Far out on the bisector f grows, but for one
///        direction, and is bounded below; so if it has an extremum, that is its least value.
///      · supremum: a square that touches s and t has a side at one of s and a side at one of t.
///        Where these are opposite, the square has its least size and slides between them, in one
///        stretch, across the wider of the two gaps. Elsewhere they meet in a corner that stands
///        while the two other sides move outward, away from the slide. f is the place of the
///        square's side towards n: from the slide on it does not fall, and in the slide it moves
///        one way.
///      · Manhattan: the same, turned by 45°. f is the place of a corner, half the sum of the
///        places of two sides, of which one stands while the square slides.
///    *Settled is who has no such face.* By the triangle inequality d(q, t) - r_t >= h - n·q - G: t
///    takes no point q with f(q) < h - G. On a ray out of the centre of s f does not fall, for d
///    grows as fast as n·q can fall; so if f < h - G at the vertices of a cell without an end at
///    infinity, then in all of it.
///    *They are found from infinity.* At q beyond the cut f(q) >= h - G. If t takes a point q, it
///    takes all between q and its centre, and there f >= h - G, as above. From any point beyond the
///    cut go towards n: f does not fall, for d falls no faster than n·q grows, and in the end one
///    is in a cell with a face at infinity. Where such ways cross an edge, one of its ends may be
///    reached, and joins the two sites.
///
/// All this in doubles, with bounds that are on the safe side: what is not surely out of reach is
/// in reach, so that signs, infinitesimals of the tie rule and lack of precision need no special
/// case.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/power/weight.hpp"
#include "../kernels/power_kernel.hpp"
#include "../vertices/vertex_of_face.hpp"
#include "orthoball.hpp"
#include "plan.hpp"

namespace signum::triangulation {

/// A cut as one of its sides sees it.
struct Crossing {
    std::size_t axis;
    bool is_above;  ///< the other side's coordinates are the greater ones
    Box<2> own;
    Box<2> beyond;
};

/// The circle of a face in the power metric.
///
/// The vertex solves b·p = H_b / 2, c·p = H_c / 2 with H = |b|² - (w_b - w_a), relative to the
/// first site. A product H_b c_y is in error by at most 12 · 2^-53 h_b |c_y|, where h_b =
/// |b|² + |w_b| + |w_a|; the area, if at least 2^-26 of the sum A of its terms' magnitudes,
/// by 2^-25 of itself. So a coordinate is off by 2^-48 (h_b |c| + h_c |b|) / area + 2^-23 of
/// itself at most, the first of which pays for the second order too.
/// 2^-100 (|b| + |c|) pays for underflow where the area is above 2^-300. Then one of the
/// offsets is above 2^-151. A height loses less than 2^-1071; times |c| / area that is below
/// 2^-771 |c|. The two products and this bound lose less than 2^-1071; over the area that is
/// below 2^-771, and so below 2^-620 (|b| + |c|).
template <class S>
[[nodiscard]] Orthoball<2> circle_of(const S& a, const S& b, const S& c) noexcept {
    using std::fabs;
    const double w = weight_of(a);
    const double bx = b.x - a.x, by = b.y - a.y, bw = weight_of(b);
    const double cx = c.x - a.x, cy = c.y - a.y, cw = weight_of(c);
    const double b_square = bx * bx + by * by;
    const double c_square = cx * cx + cy * cy;
    const double b_height = b_square - (bw - w);
    const double c_height = c_square - (cw - w);
    const double area = bx * cy - cx * by;
    const double half = 0.5 / area;
    const double x = (b_height * cy - c_height * by) * half;
    const double y = (c_height * bx - b_height * cx) * half;
    const double b_most = b_square + (fabs(bw) + fabs(w));
    const double c_most = c_square + (fabs(cw) + fabs(w));
    const double b_length = fabs(bx) + fabs(by);
    const double c_length = fabs(cx) + fabs(cy);
    double error = 0x1p-48 * (b_most * c_length + c_most * b_length) / area +
                   0x1p-23 * (fabs(x) + fabs(y)) + 0x1p-100 * (b_length + c_length);
    if (!(area > 0x1p-26 * (fabs(bx * cy) + fabs(cx * by)) && area > 0x1p-300)) error = HUGE_VAL;
    return Orthoball<2>::from({a.x, a.y}, w, {x, y}, error);
}

/// Faces of the power metric.
template <class Kernel>
class PowerReach {
 public:
    explicit PowerReach(const Kernel& kernel) noexcept : kernel_(kernel) {}

    /// w of a site, rounded.
    [[nodiscard]] double third(Index i) const noexcept { return weight_of(kernel_.site(i)); }

    [[nodiscard]] bool may_be_reached(const std::array<Index, 3>& face,
                                      const Crossing& crossing) const noexcept {
        for (std::size_t k = 0; k < 3; ++k)
            if (face[k] == infinite)
                return may_reach_edge(face[(k + 2) % 3], face[(k + 1) % 3], crossing.beyond);
        return at_face(face[0], face[1], face[2]).may_be_reached_from(crossing.beyond);
    }

 private:
    using Circle = Orthoball<2>;

    /// The face beyond the hull edge a -> b: by sites on its right, or on its line and near.
    [[nodiscard]] bool may_reach_edge(Index a, Index b, const Box<2>& box) const noexcept {
        bool is_on_line = false;
        for (const double x : {box.low[0], box.high[0]})
            for (const double y : {box.low[1], box.high[1]}) {
                const Sign side = ccw(kernel_.centre(a), kernel_.centre(b), Point{x, y});
                if (side < 0) return true;
                is_on_line = is_on_line || side == 0;
            }
        return is_on_line && at_edge(a, b).may_be_reached_from(box);
    }

    [[nodiscard]] Circle at_face(Index i, Index j, Index k) const noexcept {
        return circle_of(kernel_.site(i), kernel_.site(j), kernel_.site(k));
    }
    /// The point of the line through both sites from which both are as far.
    [[nodiscard]] Circle at_edge(Index from_site, Index to_site) const noexcept {
        const auto& a = kernel_.site(from_site);
        const auto& b = kernel_.site(to_site);
        const double x = b.x - a.x, y = b.y - a.y;
        const double w = weight_of(a), bw = weight_of(b);
        const double square = x * x + y * y;
        const double part = (square - (bw - w)) * (0.5 / square);
        const double most = (square + (std::fabs(bw) + std::fabs(w))) / square;
        const double error =
            square > 0x1p-900 ? 0x1p-48 * most * (std::fabs(x) + std::fabs(y)) : HUGE_VAL;
        return Circle::from({a.x, a.y}, w, {part * x, part * y}, error);
    }

    const Kernel& kernel_;
};

/// Faces of a metric M with additive weights.
template <class M, class Kernel>
class AdditiveReach {
 public:
    AdditiveReach(const Kernel& kernel, std::span<const Index> numbers) noexcept
        : kernel_(kernel), numbers_(numbers) {}

    [[nodiscard]] double third(Index i) const noexcept { return kernel_.site(i).r; }

    [[nodiscard]] bool may_be_reached(const std::array<Index, 3>& face,
                                      const Crossing& crossing) const {
        if ((face[0] | face[1] | face[2]) < 0) return true;
        const auto number = [&](Index i) { return numbers_[static_cast<std::size_t>(i)]; };
        const DiagramVertex vertex = vertex_of_face<M>(
            {&kernel_.site(face[0]), &kernel_.site(face[1]), &kernel_.site(face[2])},
            {number(face[0]), number(face[1]), number(face[2])}, WeightIs::radius);
        const double p = crossing.axis == 0 ? vertex.x : vertex.y;
        const double border = crossing.is_above ? crossing.beyond.low[crossing.axis]
                                                : crossing.beyond.high[crossing.axis];
        const double distance = crossing.is_above ? border - p : p - border;
        const double greatest = std::max(crossing.own.greatest, crossing.beyond.greatest);
        // Each number of the vertex is the nearest double, and no more is rounded than the
        // difference, two sums and what pays for them: six times 2^-53 of the slack, or of a
        // denormal 2^-1075 twice. Where there is no vertex, NaN.
        const double slack =
            (std::fabs(p) + std::fabs(border)) + (std::fabs(vertex.rho) + std::fabs(greatest));
        return !(distance > vertex.rho + greatest + (0x1p-50 * slack + 0x1p-1072));
    }

 private:
    const Kernel& kernel_;
    std::span<const Index> numbers_;
};

}  // namespace signum::triangulation
