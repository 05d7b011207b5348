#pragma once
/// The questions that algorithms ask of a triangulation, of sites that move, at a moment right
/// after a time. For sources only.
///
/// Laws:
///  1. A sign is that which its polynomial has right after the time: 0 only where it is 0 for ever.
///     So at any moment nothing is tied but what is tied for ever, a time that is a root of many
///     polynomials included.
///  2. Ties for ever are decided as power/ties.hpp says, but that the order is by falling weight
///  and
///     then rising number: one by coordinates would change while sites move. Every weight is
///     reduced by an infinitesimal, infinitely larger for the later site.
///  3. At the moment right after a double at which no polynomial that is asked for is 0, answers
///     are those of the kernel of the positions then (triangulation/kernels/power_kernel.hpp).

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "../core/index.hpp"
#include "../core/sign.hpp"
#include "../roots/polynomial.hpp"
#include "forms.hpp"

namespace signum::kinetic {

class MovingKernel {
 public:
    static constexpr bool is_exact = true;
    static constexpr bool is_straight = true;

    /// Right after a double.
    MovingKernel(std::span<const MovingSite> sites, double time) : sites_(sites), time_(time) {}
    /// Right after a root, whose polynomial has to outlive the kernel.
    MovingKernel(std::span<const MovingSite> sites, const roots::RootOf& time)
        : sites_(sites), time_(0.0), root_(time) {}

    [[nodiscard]] Sign ccw(Index a, Index b, Index q) {
        return sign(Orientation{site(a), site(b), site(q)});
    }
    /// Whether q is in conflict with a face. Precondition: ccw(i, j, k) > 0.
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) {
        const Sign s = sign(InCircle{site(i), site(j), site(k), site(q)});
        if (s != 0) [[likely]]
            return s > 0;
        return tie<4>({i, j, k, q}, [&](std::size_t raised) {
                   switch (raised) {
                       case 0:
                           return ccw(j, k, q);
                       case 1:
                           return ccw(k, i, q);
                       case 2:
                           return ccw(i, j, q);
                       default:
                           return Sign{-1};
                   }
               }) > 0;
    }
    /// Whether q is in conflict with the face (b, a, infinity) of the hull edge a -> b.
    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) {
        const Sign side = ccw(a, b, q);
        return side != 0 ? side < 0 : conflicts_on_line(a, b, q);
    }
    /// The same where q is for ever on the line through a and b.
    [[nodiscard]] bool conflicts_on_line(Index a, Index b, Index q) {
        Sign ahead = beyond(b, a, true);
        const bool along_x = ahead != 0;
        if (!along_x) ahead = beyond(b, a, false);
        const Sign s = sign(InSegment{site(a), site(b), site(q), along_x}) * ahead;
        if (s != 0) return s > 0;
        return tie<3>({a, b, q}, [&](std::size_t raised) {
                   switch (raised) {
                       case 0:
                           return beyond(b, q, along_x) * ahead;
                       case 1:
                           return -beyond(a, q, along_x) * ahead;
                       default:
                           return Sign{-1};
                   }
               }) > 0;
    }
    /// Whether the centre of q is nearer to a than to b, ties going to the earlier site.
    [[nodiscard]] bool is_nearer(Index q, Index a, Index b) {
        const Sign s = sign(Nearer{site(q), site(a), site(b)});
        return s != 0 ? s > 0 : precedes(a, b);
    }
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        const double of_a = std::fabs(site(a).r);
        const double of_b = std::fabs(site(b).r);
        return of_a != of_b ? of_a > of_b : a < b;
    }

    [[nodiscard]] const MovingSite& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const roots::Tally& tally() const noexcept { return tally_; }

 private:
    template <class Form>
    [[nodiscard]] Sign sign(const Form& form) {
        const roots::Polynomial p(form);
        return root_ ? p.sign_after(*root_, &tally_) : p.sign_after(time_, &tally_);
    }
    [[nodiscard]] Sign beyond(Index a, Index b, bool along_x) {
        return sign(Beyond{site(a), site(b), along_x});
    }
    /// The derivative by the height of the last site in the order of which it is not 0.
    template <std::size_t n, class Derivative>
    [[nodiscard]] Sign tie(const std::array<Index, n>& sites, const Derivative& by_height) {
        std::array<std::size_t, n> order{};
        for (std::size_t k = 0; k < n; ++k) {
            std::size_t place = k;
            for (; place > 0 && precedes(sites[order[place - 1]], sites[k]); --place)
                order[place] = order[place - 1];
            order[place] = k;
        }
        for (const std::size_t k : order)
            if (const Sign s = by_height(k); s != 0) return s;
        return -1;
    }

    std::span<const MovingSite> sites_;
    double time_;
    std::optional<roots::RootOf> root_;
    roots::Tally tally_;
};

}  // namespace signum::kinetic
