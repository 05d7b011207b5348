#pragma once
/// Kernels: the predicates an algorithm asks, over the sites it works on, with one arithmetic.
///
/// Laws:
///  1. Sites are named by their place in the insertion order; `original` gives their numbers in the
///     input, which the tie rule needs last.
///  2. The exact kernels (is_exact) agree on every question. Their conflicts are perturbed and so
///     never undecided; ccw is exact and never perturbed. What the tie rule itself asks has a
///     filter in all of them.
///  3. The naive kernel and the single one round, and take a zero for no conflict.

#include <array>
#include <type_traits>

#include "../../predicates/arithmetic.hpp"
#include "../../predicates/power.hpp"

namespace signum::triangulation {

/// The signs that a construction asks for, none of them perturbed.
template <power::PowerSite S, Arithmetic arithmetic = Arithmetic::exact>
struct PowerSigns {
    using SiteType = S;
    static constexpr bool is_exact = signum::is_exact(arithmetic);
    static constexpr bool is_trusted = is_exact;

    [[nodiscard]] static Decision ccw(const S& a, const S& b, const S& q) noexcept {
        return predicates::decide<arithmetic, predicates::Ccw>(a, b, q);
    }
    [[nodiscard]] static Decision in_circle(const S& i, const S& j, const S& k,
                                            const S& q) noexcept {
        return predicates::decide<arithmetic, power::InCircle>(i, j, k, q);
    }
    [[nodiscard]] static Decision in_segment(const S& a, const S& b, const S& q) noexcept {
        return predicates::decide<arithmetic, power::InSegment>(a, b, q);
    }
    /// Which of a and b is nearer to p: +1 for a.
    [[nodiscard]] static Decision nearer(const Point& p, const S& a, const S& b) noexcept {
        return predicates::decide<arithmetic, power::Nearer>(p, a, b);
    }
};

/// The exact signs, for who asks many questions about sites that he knows.
template <power::PowerSite S>
struct SignsOfKnown : PowerSigns<S> {
    double exact_below = 0.0;  ///< see power::in_circle_filter()

    [[nodiscard]] Decision in_circle(const S& i, const S& j, const S& k,
                                     const S& q) const noexcept {
        const filters::Verdict verdict = power::in_circle_filter(i, j, k, q, exact_below);
        if (verdict.is_certain()) [[likely]]
            return {verdict.sign(), Stage::filter};
        return power::InCircle::behind<Arithmetic::exact>(i, j, k, q);
    }
    /// Of two circles at once whether q lies inside; nothing where a filter leaves either open.
    [[nodiscard]] static auto in_circles(const std::array<const S*, 3>& first,
                                         const std::array<const S*, 3>& second,
                                         const S& q) noexcept {
        return power::in_circles_filter(first, second, q);
    }
};

/// Signs: a PowerSigns, or what hands its questions on (construction/any_arithmetic.cpp).
template <class Signs, class Tally>
class PowerKernel {
    using S = typename Signs::SiteType;

 public:
    using SiteType = S;
    /// Whether answers can be trusted never to lead an algorithm astray.
    static constexpr bool is_exact = Signs::is_trusted;
    /// The edges of the dual are straight; see insert.hpp.
    static constexpr bool is_straight = true;
    /// Whether calls are counted, so that no two threads may share a kernel.
    static constexpr bool counts = std::is_same_v<Tally, filters::Tally>;

    /// Neither array is copied.
    PowerKernel(const S* sites, const Index* original, Signs signs = {}) noexcept
        : sites_(sites), original_(original), signs_(signs) {}

    /// The orientation of a, b and q.
    [[nodiscard]] Sign ccw(Index a, Index b, Index q) noexcept {
        return orientation(site(a), site(b), site(q));
    }

    /// Whether q conflicts with the face (i, j, k). Precondition: ccw(i,j,k) > 0.
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) noexcept {
        tally_.count_in_circle();
        const Sign sign = count(signs_.in_circle(site(i), site(j), site(k), site(q)));
        if (sign != 0 || !signs_.is_exact) [[likely]]
            return sign > 0;
        tally_.count_tie();
        return tie(i, j, k, q);
    }

    /// The same with two faces, which costs little more than one.
    [[nodiscard]] std::array<bool, 2> conflicts(const Index (&first)[3], const Index (&second)[3],
                                                Index q) noexcept {
        const auto of = [&](const Index(&face)[3]) {
            return std::array{&site(face[0]), &site(face[1]), &site(face[2])};
        };
        if constexpr (requires { signs_.in_circles(of(first), of(second), site(q)); } && !counts) {
            const auto are_inside = signs_.in_circles(of(first), of(second), site(q));
            if (are_inside) [[likely]]
                return *are_inside;
        }
        return {conflicts(first[0], first[1], first[2], q),
                conflicts(second[0], second[1], second[2], q)};
    }

    /// Whether q conflicts with the face (b, a, infinity) of the hull edge a -> b.
    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) noexcept {
        const Sign side = orientation(site(a), site(b), site(q));
        return side != 0 ? side < 0 : conflicts_on_line(a, b, q);
    }

    /// The same where q is known to lie on the line through a and b.
    [[nodiscard]] bool conflicts_on_line(Index a, Index b, Index q) noexcept {
        tally_.count_in_circle();
        const Sign sign = count(signs_.in_segment(site(a), site(b), site(q)));
        if (sign != 0 || !signs_.is_exact) return sign > 0;
        tally_.count_tie();
        return power::in_segment_tie(centre(a), centre(b), centre(q), places({a, b, q})) > 0;
    }

    /// Below 0 where a comes before b along any line: by x and then by y. 0 at equal centres.
    [[nodiscard]] Sign compare_along(Index a, Index b) const noexcept {
        const Point p = centre(a);
        const Point q = centre(b);
        return p.x != q.x ? filters::compare_numbers(p.x, q.x) : filters::compare_numbers(p.y, q.y);
    }

    /// Whether a comes before b in the tie rule's order.
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        return power::precedes(site(a), original_[a], site(b), original_[b]);
    }

    /// Squares of distances would cancel: two sites are compared at once, and nothing is kept.
    struct Distance {};
    [[nodiscard]] static Distance distance(Index, Index) noexcept { return {}; }
    /// Whether the centre of q is nearer to a than to b, ties going to the earlier site.
    [[nodiscard]] bool is_nearer(Index q, Index a, Distance, Index b, Distance) noexcept {
        return is_nearer(q, a, b);
    }
    [[nodiscard]] bool is_nearer(Index q, Index a, Index b) noexcept {
        tally_.count_nearer();
        const Sign sign = nearer_sign(centre(q), site(a), site(b));
        return sign != 0 ? sign > 0 : precedes(a, b);
    }
    /// The same where a is no site of the tessellation, and first in the tie rule's order. Its
    /// third number is what weight() says of a site.
    [[nodiscard]] bool would_be_nearer(Index q, const Site& a, Index b) noexcept {
        tally_.count_nearer();
        return nearer_sign(centre(q), power::made_of<S>(a), site(b)) >= 0;
    }
    /// The third number of a site, without its sign where that does not matter: the greater, the
    /// nearer the site is to everything.
    [[nodiscard]] double weight(Index i) const noexcept { return power::weight_key(site(i)); }

    [[nodiscard]] const S& site(Index i) const noexcept { return sites_[i]; }
    [[nodiscard]] Point centre(Index i) const noexcept { return power::centre(sites_[i]); }
    [[nodiscard]] const Tally& tally() const noexcept { return tally_; }

 private:
    [[nodiscard]] Sign orientation(const S& a, const S& b, const S& q) noexcept {
        tally_.count_ccw();
        return count(signs_.ccw(a, b, q));
    }
    [[nodiscard]] Sign nearer_sign(Point p, const S& a, const S& b) noexcept {
        return count(signs_.nearer(p, a, b));
    }

    [[nodiscard, gnu::noinline]] bool tie(Index i, Index j, Index k, Index q) const noexcept {
        // The last of the four decides, nearly always.
        const Index last_of_face = later(later(i, j), k);
        if (precedes(last_of_face, q)) return false;
        const Index next = last_of_face == i ? j : last_of_face == j ? k : i;
        const Index after = last_of_face == i ? k : last_of_face == j ? i : j;
        const Sign sign = signum::ccw(centre(next), centre(after), centre(q));
        if (sign != 0) return sign > 0;
        return power::in_circle_tie(centre(i), centre(j), centre(k), centre(q),
                                    places({i, j, k, q})) > 0;
    }

    [[nodiscard]] Index later(Index a, Index b) const noexcept { return precedes(a, b) ? b : a; }

    /// The places of a few sites in the order among themselves.
    template <std::size_t n>
    [[nodiscard]] std::array<Index, n> places(const Index (&sites)[n]) const noexcept {
        std::array<Index, n> result{};
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < a; ++b) ++result[precedes(sites[a], sites[b]) ? b : a];
        return result;
    }

    [[nodiscard]] Sign count(Decision decision) noexcept {
        tally_.count_stage(decision.stage);
        return decision.sign;
    }

    const S* sites_;
    const Index* original_;
    [[no_unique_address]] Signs signs_;
    [[no_unique_address]] Tally tally_;
};

}  // namespace signum::triangulation
