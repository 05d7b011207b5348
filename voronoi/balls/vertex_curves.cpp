#include "vertex_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "../../predicates/space/ccw.hpp"
#include "../../predicates/space/euclidean.hpp"

namespace signum::balls {
namespace {

class CurveSearch {
 public:
    CurveSearch(const BallSet& balls, const BallVertex& vertex)
        : balls_(balls), vertex_(vertex), list_(vertex.all()) {}

    [[nodiscard]] std::vector<VertexCurve> run() {
        for (std::size_t corner = 0; corner < list_.size(); ++corner) {
            if (!find_hull_seen_from(corner)) {
                std::vector<Index> all(list_.begin(), list_.end());
                add_facet(all, std::nullopt);
                break;
            }
            for (std::size_t k = 0; k < hull_.size(); ++k)
                take_facet(corner, hull_[k], hull_[(k + 1) % hull_.size()]);
        }
        return std::move(curves_);
    }

 private:
    /// How the points of contact turn.
    [[nodiscard]] Sign turn(Index i, Index j, Index k, Index l) {
        const auto [a, b, c, d] = balls_.of(Quadruple{i, j, k, l});
        if (same_radius(a, b, c, d))
            return ccw_decision(centre3(a), centre3(b), centre3(c), centre3(d)).sign;
        const bool positive = euclidean::exists_decision(a, b, c, d).sign > 0;
        const bool negative = euclidean::exists_decision(a, c, b, d).sign > 0;
        if (positive != negative) return positive ? 1 : -1;
        if (!positive) return 0;
        return sphere().turn(a, b, c, d);
    }
    [[nodiscard]] const ExactSphere& sphere() {
        if (!sphere_) sphere_ = exact_sphere_of(balls_, vertex_);
        return *sphere_;
    }

    /// The corners of the hull of all others, in the order in which they turn positively; false
    /// where they lie in one plane.
    [[nodiscard]] bool find_hull_seen_from(std::size_t corner) {
        const Index i = list_[corner];
        others_.clear();
        for (const Index j : list_)
            if (j != i) others_.push_back(j);
        std::size_t third = 2;
        Sign first_turn = 0;
        for (; third < others_.size(); ++third) {
            first_turn = turn(i, others_[0], others_[1], others_[third]);
            if (first_turn != 0) break;
        }
        if (first_turn == 0) return false;
        hull_ = {others_[0], others_[1], others_[third]};
        if (first_turn < 0) std::swap(hull_[1], hull_[2]);
        for (std::size_t m = 2; m < others_.size(); ++m)
            if (m != third) add_to_hull(i, others_[m]);
        return true;
    }
    /// A point outside the hull has a side of it on its right. With these go those that it
    /// prolongs.
    void add_to_hull(Index i, Index point) {
        const std::size_t n = hull_.size();
        sides_.clear();
        for (std::size_t k = 0; k < n; ++k)
            sides_.push_back(turn(i, hull_[k], hull_[(k + 1) % n], point));
        if (std::ranges::find(sides_, -1) == sides_.end()) return;
        std::size_t first = 0;  // of the sides that stay
        while (sides_[first] <= 0 || sides_[(first + n - 1) % n] > 0) ++first;
        longer_hull_.clear();
        std::size_t k = first;
        for (; sides_[k % n] > 0; ++k) longer_hull_.push_back(hull_[k % n]);
        longer_hull_.push_back(hull_[k % n]);
        longer_hull_.push_back(point);
        std::swap(hull_, longer_hull_);
    }

    /// Of a facet's corners the first one has it added.
    void take_facet(std::size_t corner, Index j, Index k) {
        const Index i = list_[corner];
        facet_ = {i, j, k};
        Index beside = i;
        for (const Index l : others_) {
            if (l == j || l == k) continue;
            if (turn(i, j, k, l) == 0) {
                facet_.push_back(l);
            } else {
                beside = l;
            }
        }
        std::ranges::sort(facet_);
        if (facet_[0] == i) add_facet(facet_, beside);
    }

    /// Its balls, and another one, beside their plane.
    void add_facet(std::span<const Index> facet, std::optional<Index> beside) {
        for (std::size_t i = 0; i < facet.size(); ++i)
            for (std::size_t j = i + 1; j < facet.size(); ++j)
                for (std::size_t k = j + 1; k < facet.size(); ++k)
                    if (add_curve(facet, {facet[i], facet[j], facet[k]}, beside) &&
                        curves_.back().touching.size() == facet.size())
                        return;
    }
    /// False where some ball of the facet conflicts with it, or its balls have others before them.
    bool add_curve(std::span<const Index> facet, const Triple& three, std::optional<Index> beside) {
        const std::array<Site3, 3> curve = balls_.of(three);
        VertexCurve result{{three.begin(), three.end()}, true, true};
        for (const Index l : facet) {
            if (std::ranges::find(three, l) != three.end()) continue;
            if (balls_.touch_along_a_curve({three[0], three[1], three[2], l})) {
                if (l < three[2]) return false;
                result.touching.push_back(l);
            } else if (sphere().is_only_one_free_of(curve, balls_[l])) {
                return false;
            }
        }
        if (beside) {
            result.is_end = turn(three[0], three[1], three[2], *beside) > 0;
            result.is_start = !result.is_end;
        }
        curves_.push_back(std::move(result));
        return true;
    }

    const BallSet& balls_;
    const BallVertex& vertex_;
    std::span<const Index> list_;
    std::optional<ExactSphere> sphere_;
    std::vector<VertexCurve> curves_;
    std::vector<Index> others_;
    std::vector<Index> hull_, longer_hull_;
    std::vector<Sign> sides_;
    std::vector<Index> facet_;
};

}  // namespace

std::vector<VertexCurve> curves_at(const BallSet& balls, const BallVertex& vertex) {
    return CurveSearch(balls, vertex).run();
}

ExactSphere exact_sphere_of(const BallSet& balls, const BallVertex& vertex) {
    const std::array<Site3, 4> four = balls.of(vertex.four);
    for (ExactSphere& sphere : ExactSphere::touching(four))
        if (sphere.turn(four[0], four[1], four[2], four[3]) == vertex.turn)
            return std::move(sphere);
    throw std::logic_error("a vertex of four balls without a sphere");
}

}  // namespace signum::balls
