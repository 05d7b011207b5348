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

/// Predicates: those of a metric under the tie rule (rectangular::Perturbed).
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
    /// Whether i would hide q if it came before it in the tie rule's order.
    [[nodiscard]] bool hides_if_first(Index i, Index q) noexcept {
        return decide(Predicates::hides(site(i), site(q), {0, 1}));
    }
    /// Whether a circle touches i, j, k counterclockwise.
    [[nodiscard]] bool exists(Index i, Index j, Index k) noexcept {
        return decide(
            Predicates::exists(site(i), site(j), site(k), {ranks_[i], ranks_[j], ranks_[k]}));
    }
    /// Whether circles touch i, j, k both counterclockwise and clockwise.
    [[nodiscard]] bool exist_twice(Index i, Index j, Index k) noexcept {
        return decide(
            Predicates::exists_twice(site(i), site(j), site(k), {ranks_[i], ranks_[j], ranks_[k]}));
    }
    /// Whether q's part of the bisector of i and j, or what it leaves, comes before k's; see
    /// Predicates.
    [[nodiscard]] bool precedes(Index i, Index j, Index q, Index k) noexcept {
        return decide(Predicates::precedes(site(i), site(j), site(q), site(k),
                                           {ranks_[i], ranks_[j], ranks_[q], ranks_[k]}));
    }
    /// Whether k, q (or, with `rest`, what it leaves) and l follow one another counterclockwise
    /// around the horizon of s; see Predicates.
    [[nodiscard]] bool in_order_at_infinity(Index s, Index k, Index q, Index l,
                                            bool rest) noexcept {
        return decide(
            Predicates::in_order_at_infinity(site(s), site(k), site(q), site(l), rest,
                                             {ranks_[s], ranks_[k], ranks_[q], ranks_[l]}));
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
    /// Whether the part of the horizon from hull edge k -> s on to s -> l contains the first
    /// direction. Precondition: neither of s and k, or s and l, hides the other.
    [[nodiscard]] bool holds_first_direction(Index k, Index s, Index l) noexcept {
        return decide(Predicates::holds_first_direction(site(k), site(s), site(l),
                                                        {ranks_[k], ranks_[s], ranks_[l]}));
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
