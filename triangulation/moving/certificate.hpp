#pragma once
/// What keeps a triangulation of moving sites as it is: polynomials in time that are above 0. For
/// sources only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "bounded_forms.hpp"
#include "forms.hpp"

namespace signum::kinetic {

struct Certificate {
    enum class Kind : std::uint8_t {
        outside,     ///< the last of four is not in conflict with the others' circle
        left_turn,   ///< of three
        in_segment,  ///< the third, on the line of the others, is in conflict with their stretch
        beyond,      ///< the first is beyond the second along an axis
        ahead,       ///< the first is beyond the second, as the third is beyond the fourth
        nearer       ///< the first is nearer to the second than to the third
    };
    std::array<Index, 4> sites{};
    Kind kind = Kind::outside;
    bool along_x = true;
};

/// All sites, and what they have in common.
struct Sites {
    std::span<const MovingSite> moving;
    Fall fall;

    [[nodiscard]] const MovingSite& operator[](Index i) const noexcept {
        return moving[static_cast<std::size_t>(i)];
    }
    /// The order of the tie rule, by falling weight and then rising number: one by coordinates
    /// would change while sites move.
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        const double of_a = std::fabs((*this)[a].r);
        const double of_b = std::fabs((*this)[b].r);
        return of_a != of_b ? of_a > of_b : a < b;
    }
};

/// A certificate of sites, which have to outlive it: a form (roots/polynomial.hpp).
struct CertificateForm {
    std::array<const MovingSite*, 4> sites;
    Fall fall;
    Certificate::Kind kind;
    bool along_x;

    CertificateForm(const Certificate& certificate, const Sites& all)
        : fall(all.fall), kind(certificate.kind), along_x(certificate.along_x) {
        for (std::size_t k = 0; k < 4; ++k) sites[k] = &all[certificate.sites[k]];
    }

    template <class Number>
    [[nodiscard]] PolynomialIn<Number, 4> in(double origin) const {
        const MovingSite& a = *sites[0];
        const MovingSite& b = *sites[1];
        const MovingSite& c = *sites[2];
        const MovingSite& d = *sites[3];
        const Frame at{fall, origin};
        if constexpr (std::is_same_v<Number, Approximation>) {
            if (kind == Certificate::Kind::outside)
                if (const auto p = bounded_in_circle(b, a, c, d, at)) return *p;
            if (kind == Certificate::Kind::left_turn)
                if (const auto p = bounded_orientation(a, b, c, at)) return *p;
        }
        switch (kind) {
            case Certificate::Kind::outside:
                return in_circle<Number>(b, a, c, d, at);
            case Certificate::Kind::left_turn:
                return roots::widened<4>(orientation<Number>(a, b, c, at));
            case Certificate::Kind::in_segment:
                return in_segment<Number>(a, b, c, along_x, at);
            case Certificate::Kind::beyond:
                return roots::widened<4>(beyond<Number>(a, b, along_x, at));
            case Certificate::Kind::ahead:
                return roots::widened<4>(beyond<Number>(a, b, along_x, at) *
                                         beyond<Number>(c, d, along_x, at));
            default:
                return roots::widened<4>(nearer<Number>(a, b, c, at));
        }
    }
};

/// Sites by the order of the tie rule, the last one first.
template <std::size_t n>
[[nodiscard]] std::array<std::size_t, n> last_first(const Sites& all,
                                                    const std::array<Index, n>& sites) {
    std::array<std::size_t, n> order{};
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t place = k;
        for (; place > 0 && all.precedes(sites[order[place - 1]], sites[k]); --place)
            order[place] = order[place - 1];
        order[place] = k;
    }
    return order;
}

/// Shows the certificates by which q is not in conflict with the circle of i, j and k, one after
/// the other until one is taken: the next is meant where all before it are 0 for ever. By the tie
/// rule every weight is less by an infinitesimal, which is infinitely larger for the later site.
/// Whether one was taken.
template <class Take>
bool certify_outside(const Sites& all, Index i, Index j, Index k, Index q, const Take& take) {
    using Kind = Certificate::Kind;
    if (take(Certificate{{i, j, k, q}, Kind::outside})) [[likely]]
        return true;
    for (const std::size_t raised : last_first<4>(all, {i, j, k, q})) {
        // Of q it is the turn of the face: above 0, but it has a root where the face turns over.
        const Certificate turn = raised == 0   ? Certificate{{k, j, q, q}, Kind::left_turn}
                                 : raised == 1 ? Certificate{{i, k, q, q}, Kind::left_turn}
                                 : raised == 2 ? Certificate{{j, i, q, q}, Kind::left_turn}
                                               : Certificate{{i, j, k, k}, Kind::left_turn};
        if (take(turn)) return true;
    }
    return false;
}

/// The same, by which q is in conflict with the stretch from a to b, where all three are for ever
/// on one line; a and b are not for ever at one place of the axis. Where none is taken q is in no
/// conflict.
template <class Take>
bool certify_in_segment(const Sites& all, Index a, Index b, Index q, bool along_x,
                        const Take& take) {
    using Kind = Certificate::Kind;
    if (take(Certificate{{a, b, q, q}, Kind::in_segment, along_x})) [[likely]]
        return true;
    for (const std::size_t raised : last_first<3>(all, {a, b, q})) {
        if (raised == 2) return false;
        // By the height of a the determinant grows as b is beyond q, by that of b as q beyond a.
        const Certificate ahead = raised == 0 ? Certificate{{b, q, b, a}, Kind::ahead, along_x}
                                              : Certificate{{q, a, b, a}, Kind::ahead, along_x};
        if (take(ahead)) return true;
    }
    return false;
}

}  // namespace signum::kinetic
