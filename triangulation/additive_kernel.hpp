#pragma once
/// The kernel of the metrics with additive weights, over the predicates of one of them.
///
/// Laws: those of kernel.hpp, and: all answers are perturbed, so that none is undecided; the naive
/// kernel too follows the tie rule where rounded numbers agree.

#include <array>

#include <signum/core/index.hpp>
#include <signum/core/site.hpp>
#include <signum/filters/tally.hpp>
#include <signum/triangulation/triangulate.hpp>

namespace signum::triangulation {

/// Predicates: hides, exists, in_circle, in_circle_infinite and nearer under the tie rule.
template <class Predicates, Arithmetic arithmetic, class Tally>
class AdditiveKernel {
 public:
    using SiteType = Site;
    static constexpr bool is_exact = arithmetic != Arithmetic::naive;
    /// The edges of the dual are curved; see insert.hpp.
    static constexpr bool is_straight = false;

    /// Neither array is copied. ranks[i] is the place of site i in the tie rule's order.
    AdditiveKernel(const Site* sites, const Index* ranks) noexcept : sites_(sites), ranks_(ranks) {}

    /// Whether site i hides site q.
    [[nodiscard]] bool hides(Index i, Index q) noexcept {
        return decide(Predicates::hides(site(i), site(q), {ranks_[i], ranks_[q]}));
    }
    /// Whether a circle touches i, j, k counterclockwise.
    [[nodiscard]] bool exists(Index i, Index j, Index k) noexcept {
        return decide(
            Predicates::exists(site(i), site(j), site(k), {ranks_[i], ranks_[j], ranks_[k]}));
    }
    /// Whether q conflicts with the vertex of i, j, k. Precondition: exists(i,j,k).
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) noexcept {
        tally_.count_in_circle();
        return decide(Predicates::in_circle(site(i), site(j), site(k), site(q),
                                            {ranks_[i], ranks_[j], ranks_[k], ranks_[q]}));
    }
    /// Whether q conflicts with the face (b, a, infinity) of the hull edge a -> b.
    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) noexcept {
        tally_.count_in_circle();
        return decide(Predicates::in_circle_infinite(site(a), site(b), site(q),
                                                     {ranks_[a], ranks_[b], ranks_[q]}));
    }
    /// Whether the centre of q is nearer to a than to b.
    [[nodiscard]] bool is_nearer(Index q, Index a, Index b) noexcept {
        return decide(Predicates::nearer(centre(q), site(a), site(b), {ranks_[a], ranks_[b]}));
    }
    /// Whether the point is nearer to a than to b, ties going to the earlier site.
    [[nodiscard]] bool nearer(Point point, Index a, Index b) const noexcept {
        return Predicates::nearer(point, site(a), site(b), {ranks_[a], ranks_[b]}).sign > 0;
    }

    [[nodiscard]] const Site& site(Index i) const noexcept { return sites_[i]; }
    [[nodiscard]] Point centre(Index i) const noexcept { return {sites_[i].x, sites_[i].y}; }
    [[nodiscard]] const Tally& tally() const noexcept { return tally_; }

 private:
    [[nodiscard]] bool decide(Decision decision) noexcept {
        tally_.count_stage(decision.stage);
        if (decision.tied) tally_.count_tie();
        return decision.sign > 0;
    }

    const Site* sites_;
    const Index* ranks_;
    [[no_unique_address]] Tally tally_;
};

}  // namespace signum::triangulation
