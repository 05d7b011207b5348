/// Contacts in the supremum and Manhattan metrics, in the forms g and numbers G of
/// predicates/ladder/forms.hpp: a square touches m where the greatest of g_d(m) - G_d is 0,
/// and m is strictly inside where it is negative.
///
/// A square that i and j touch has G_d >= h_d, the greater of their two forms. A smaller one within
/// it, G_d still at least h_d, touches both as well, and is empty if the larger one is. So only the
/// smallest need be looked at. They lie between two opposite sides h_d and h_(d+2), and slide from
/// one end to the other between the two sides across.
///
/// Nothing is multiplied, so that all numbers are multiples of the least bit of any site's: in 128
/// bits they are integers, unless sites' numbers span more than that.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "../exact/floating_environment.hpp"
#include "../exact/multiprecision.hpp"
#include "../predicates/manhattan.hpp"
#include "../predicates/supremum.hpp"
#include "of_metric.hpp"

namespace signum {
namespace {

using exact::Rational;
using Integer = __int128;

/// The bits that the numbers of the sites take: powers of two of which all are multiples, and which
/// none reaches.
struct Bits {
    int least = 2000;
    int greatest = -2000;

    void include(double value) noexcept {
        if (value == 0.0) return;
        constexpr int digits = 53;
        int exponent = 0;
        const double fraction = std::frexp(std::abs(value), &exponent);
        const auto significand = static_cast<std::uint64_t>(std::ldexp(fraction, digits));
        least = std::min(least, exponent - digits + std::countr_zero(significand));
        greatest = std::max(greatest, exponent);
    }
    /// A form is below 3 numbers, a width below 6, the fourth side of a square below 15, an excess
    /// below 18, which takes 5 bits and a sign.
    [[nodiscard]] bool are_few() const noexcept { return greatest - least <= 120; }
};

/// Rational or Integer: then a multiple of 2^least.
template <class Directions, class Number>
class RectangularContacts {
    using Forms = std::array<Number, 4>;

 public:
    RectangularContacts(const Canonical& canonical, const Bits& bits)
        : canonical_(canonical), bits_(bits) {}

    bool operator()(Index i, Index j) const {
        if (canonical_.site(i) == canonical_.site(j)) return false;
        const Forms of_i = forms(i);
        const Forms of_j = forms(j);
        Forms least;
        for (std::size_t d = 0; d < 4; ++d) least[d] = std::max(of_i[d], of_j[d]);
        const std::size_t a = least[0] + least[2] >= least[1] + least[3] ? 0 : 1;
        const Number width = least[a] + least[a + 2];

        // The square with the side across at g.
        const std::size_t across = a + 1;
        const std::size_t opposite = (a + 3) % 4;
        const auto square = [&](const Number& g) {
            Forms result = least;
            result[across] = g;
            result[opposite] = width - g;
            return result;
        };
        const Number first = least[across];
        const Number last = width - least[opposite];
        Index at = start(i, j);
        const auto held = [&](const Forms& one, const Forms& other) {
            return one[a] == least[a] && other[a + 2] == least[a + 2];
        };
        if (!held(of_i, of_j) && !held(of_j, of_i)) {
            // One of them holds both sides; the other is touched at an end of the way, or nowhere.
            const auto is_contact = [&](const Number& g) {
                const Forms of_square = square(g);
                return excess(of_i, of_square) == 0 && excess(of_j, of_square) == 0 &&
                       excess(nearest(of_square, at), of_square) >= 0;
            };
            return is_contact(first) || is_contact(last);
        }
        // A site inside stays inside until the square has passed it.
        for (Number g = first; g <= last;) {
            const Forms of_square = square(g);
            const Forms inside = nearest(of_square, at);
            if (excess(inside, of_square) >= 0) return true;
            g = width - inside[opposite];
        }
        return false;
    }

 private:
    [[nodiscard]] Forms forms(Index i) const {
        const Site& s = canonical_.site(i);
        const Number x = number(s.x);
        const Number y = number(s.y);
        const Number r = number(s.r);
        Forms result;
        for (std::size_t d = 0; d < 4; ++d)
            result[d] = Number(static_cast<int>(Directions::x[d])) * x +
                        Number(static_cast<int>(Directions::y[d])) * y - r;
        return result;
    }

    [[nodiscard]] Number number(double value) const {
        if constexpr (std::is_same_v<Number, Rational>)
            return exact::to_rational(value);
        else
            return static_cast<Number>(std::ldexp(value, -bits_.least));
    }

    [[nodiscard]] static Number excess(const Forms& site, const Forms& square) {
        Number greatest = site[0] - square[0];
        for (std::size_t d = 1; d < 4; ++d)
            greatest = std::max(greatest, Number(site[d] - square[d]));
        return greatest;
    }

    /// A visible site to walk from.
    [[nodiscard]] Index start(Index i, Index j) const {
        return canonical_.lesser(canonical_.shown_for(i), canonical_.shown_for(j));
    }

    /// The forms of a site inside the square or, where there is none, of the one nearest to it.
    /// Walks from `at`, and leaves it there: unless a site is the nearest, in the order of ties
    /// where two are as near, a neighbour is nearer.
    [[nodiscard]] Forms nearest(const Forms& square, Index& at) const {
        Forms of_nearest = forms(at);
        Number least = excess(of_nearest, square);
        for (Index from = -1; from != at && least >= 0;) {
            from = at;
            for (const Index k : canonical_.tessellation().neighbours(from)) {
                if (k == infinite) continue;
                Forms of_k = forms(k);
                Number of_excess = excess(of_k, square);
                if (of_excess > least || (of_excess == least && !precedes(k, at))) continue;
                of_nearest = std::move(of_k);
                least = std::move(of_excess);
                at = k;
            }
        }
        return of_nearest;
    }

    [[nodiscard]] bool precedes(Index i, Index j) const {
        return additive::precedes(canonical_.site(i), i, canonical_.site(j), j);
    }

    const Canonical& canonical_;
    Bits bits_;
};

template <class Directions>
Contacts contacts_along(const Canonical& canonical) {
    const exact::IeeeEnvironment environment;
    Bits bits;
    for (const Site& site : canonical.tessellation().sites())
        for (const double number : {site.x, site.y, site.r}) bits.include(number);
    if (bits.are_few())
        return in_any_environment(RectangularContacts<Directions, Integer>(canonical, bits));
    return in_any_environment(RectangularContacts<Directions, Rational>(canonical, bits));
}

}  // namespace

template <>
Contacts contacts_in<Manhattan>(const Canonical& canonical) {
    return contacts_along<rectangular::Manhattan>(canonical);
}
template <>
Contacts contacts_in<Supremum>(const Canonical& canonical) {
    return contacts_along<rectangular::Supremum>(canonical);
}

}  // namespace signum
