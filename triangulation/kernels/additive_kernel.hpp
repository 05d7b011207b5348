#pragma once
/// The kernel of the metrics with additive weights, over the predicates of one of them.
///
/// Laws: those of power_kernel.hpp, and: all answers are perturbed, so that none is undecided; the
/// naive kernel and the single one too follow the tie rule where rounded numbers agree.

#include <array>
#include <type_traits>

#include "../../core/index.hpp"
#include "../../core/site.hpp"
#include "../../filters/tally.hpp"
#include "../../predicates/additive.hpp"
#include "../../predicates/arithmetic.hpp"
#include "../structure/tie_order.hpp"

namespace signum::triangulation {

/// Predicates: those of a metric under the tie rule (rectangular::Perturbed), or what hands their
/// questions on (construction/any_arithmetic.cpp).
template <class Predicates, class Tally>
class AdditiveKernel {
 public:
    using SiteType = RankedSite;
    static constexpr bool is_exact = signum::is_exact(Predicates::arithmetic_used);
    /// The edges of the dual are curved; see insert.hpp.
    static constexpr bool is_straight = false;
    /// Whether calls are counted, so that no two threads may share a kernel.
    static constexpr bool counts = std::is_same_v<Tally, filters::Tally>;

    /// The array is not copied.
    explicit AdditiveKernel(const RankedSite* sites, Predicates predicates = {}) noexcept
        : sites_(sites), predicates_(predicates) {}

    /// Whether site i hides site q.
    [[nodiscard]] bool hides(Index i, Index q) noexcept {
        return decide(predicates_.hides(site(i), site(q), {site(i).rank, site(q).rank}));
    }
    /// Whether i would hide q if it came before it in the tie rule's order.
    [[nodiscard]] bool hides_if_first(Index i, Index q) noexcept {
        return decide(predicates_.hides(site(i), site(q), {0, 1}));
    }
    /// Whether a circle touches i, j, k counterclockwise.
    [[nodiscard]] bool exists(Index i, Index j, Index k) noexcept {
        return decide(predicates_.exists(site(i), site(j), site(k),
                                         {site(i).rank, site(j).rank, site(k).rank}));
    }
    /// Whether circles touch i, j, k both counterclockwise and clockwise.
    [[nodiscard]] bool exist_twice(Index i, Index j, Index k) noexcept {
        return decide(predicates_.exists_twice(site(i), site(j), site(k),
                                               {site(i).rank, site(j).rank, site(k).rank}));
    }
    /// Whether q's part of the bisector of i and j, or what it leaves, comes before k's; see
    /// Predicates.
    [[nodiscard]] bool precedes_on_bisector(Index i, Index j, Index q, Index k) noexcept {
        return decide(predicates_.precedes_on_bisector(
            site(i), site(j), site(q), site(k),
            {site(i).rank, site(j).rank, site(q).rank, site(k).rank}));
    }
    /// Whether k, q (or, with `rest`, what it leaves) and l follow one another counterclockwise
    /// around the horizon of s; see Predicates.
    [[nodiscard]] bool in_order_at_infinity(Index s, Index k, Index q, Index l,
                                            bool rest) noexcept {
        return decide(predicates_.in_order_at_infinity(
            site(s), site(k), site(q), site(l), rest,
            {site(s).rank, site(k).rank, site(q).rank, site(l).rank}));
    }
    /// Whether q conflicts with the vertex of i, j, k. Preconditions: exists(i,j,k), and none of
    /// them hides q.
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) noexcept {
        tally_.count_in_circle();
        return decide(predicates_.in_circle_of_visible(
            site(i), site(j), site(k), site(q),
            {site(i).rank, site(j).rank, site(k).rank, site(q).rank}));
    }
    /// The same where q may be hidden, which is no conflict.
    [[nodiscard]] bool conflicts_if_visible(Index i, Index j, Index k, Index q) noexcept {
        tally_.count_in_circle();
        return decide(
            predicates_.in_circle(site(i), site(j), site(k), site(q),
                                  {site(i).rank, site(j).rank, site(k).rank, site(q).rank}));
    }
    /// Whether q conflicts with the face (b, a, infinity) of the hull edge a -> b.
    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) noexcept {
        tally_.count_in_circle();
        return decide(predicates_.in_circle_infinite(site(a), site(b), site(q),
                                                     {site(a).rank, site(b).rank, site(q).rank}));
    }
    /// Whether the part of the horizon from hull edge k -> s on to s -> l contains the first
    /// direction. Precondition: neither of s and k, or s and l, hides the other.
    [[nodiscard]] bool holds_first_direction(Index k, Index s, Index l) noexcept {
        return decide(predicates_.holds_first_direction(
            site(k), site(s), site(l), {site(k).rank, site(s).rank, site(l).rank}));
    }
    /// How far the centre of q is from a: computed once by who compares many sites there.
    using Distance = additive::Distance;
    [[nodiscard]] Distance distance(Index q, Index a) const noexcept {
        return predicates_.distance(centre(q), site(a));
    }
    /// Whether the centre of q is nearer to a than to b, ties going to the earlier site.
    [[nodiscard]] bool is_nearer(Index q, Index a, const Distance& to_a, Index b,
                                 const Distance& to_b) noexcept {
        if constexpr (Predicates::arithmetic_used == Arithmetic::exact) {
            const filters::Verdict verdict = additive::nearer(to_a, to_b);
            if (verdict.is_certain()) [[likely]] {
                tally_.count_nearer();
                return decide({verdict.sign(), Stage::filter});
            }
        }
        return is_nearer(q, a, b);
    }
    [[nodiscard]] bool is_nearer(Index q, Index a, Index b) noexcept {
        tally_.count_nearer();
        return decide(
            predicates_.nearer(centre(q), site(a), site(b), {site(a).rank, site(b).rank}));
    }
    /// The same where a is no site of the tessellation, and first in the tie rule's order.
    [[nodiscard]] bool would_be_nearer(Index q, const Site& a, Index b) noexcept {
        tally_.count_nearer();
        return decide(predicates_.nearer(centre(q), a, site(b), {0, 1}));
    }
    /// The third number of a site: the greater, the nearer it is to everything.
    [[nodiscard]] double weight(Index i) const noexcept { return site(i).r; }

    [[nodiscard]] const RankedSite& site(Index i) const noexcept { return sites_[i]; }
    [[nodiscard]] Point centre(Index i) const noexcept { return {sites_[i].x, sites_[i].y}; }
    [[nodiscard]] const Tally& tally() const noexcept { return tally_; }

    /// Counts a decision, made here or not.
    Sign count(Decision decision) noexcept {
        tally_.count_stage(decision.stage);
        if (decision.tied) tally_.count_tie();
        return decision.sign;
    }

 private:
    [[nodiscard]] bool decide(Decision decision) noexcept { return count(decision) > 0; }

    const RankedSite* sites_;
    [[no_unique_address]] Predicates predicates_;
    [[no_unique_address]] Tally tally_;
};

}  // namespace signum::triangulation
