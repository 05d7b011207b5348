#pragma once
/// The questions that algorithms ask of a triangulation, of sites that move, at a moment right
/// after a time. For sources only.
///
/// Laws:
///  1. A sign is that which its polynomial has right after the time: 0 only where it is 0 for ever.
///     So at any moment nothing is tied but what is tied for ever, a time that is a root of many
///     polynomials included.
///  2. Ties for ever are decided as power/ties.hpp says, but that the order is by falling weight
///     and then rising number (certificate.hpp).
///  3. At the moment right after a double at which no polynomial that is asked for is 0, answers
///     are those of the kernel of the positions then (triangulation/kernels/power_kernel.hpp).

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "certificate.hpp"
#include "moment.hpp"

namespace signum::kinetic {

class MovingKernel {
 public:
    static constexpr bool is_exact = true;
    static constexpr bool is_straight = true;

    /// At a moment that may be set anew. Neither is copied.
    MovingKernel(const Sites& sites, const Moment& moment, roots::Tally& tally)
        : sites_(sites), moment_(moment), tally_(tally) {}

    [[nodiscard]] Sign ccw(Index a, Index b, Index q) {
        return sign({{a, b, q, q}, Certificate::Kind::left_turn});
    }
    /// Whether q is in conflict with a face. Precondition: ccw(i, j, k) > 0.
    [[nodiscard]] bool conflicts(Index i, Index j, Index k, Index q) {
        Sign outside = 0;
        certify_outside(sites_, i, j, k, q, [&](const Certificate& certificate) {
            outside = sign(certificate);
            return outside != 0;
        });
        return outside < 0;
    }
    /// Whether q is in conflict with the face (b, a, infinity) of the hull edge a -> b.
    [[nodiscard]] bool conflicts_infinite(Index a, Index b, Index q) {
        const Sign side = ccw(a, b, q);
        return side != 0 ? side < 0 : conflicts_on_line(a, b, q);
    }
    /// The same where q is for ever on the line through a and b.
    [[nodiscard]] bool conflicts_on_line(Index a, Index b, Index q) {
        const bool along_x = beyond(b, a, true) != 0;
        Sign inside = 0;
        certify_in_segment(sites_, a, b, q, along_x, [&](const Certificate& certificate) {
            inside = sign(certificate);
            return inside != 0;
        });
        return inside > 0;
    }
    /// Whether the centre of q is nearer to a than to b, ties going to the earlier site.
    [[nodiscard]] bool is_nearer(Index q, Index a, Index b) {
        const Sign s = sign({{q, a, b, b}, Certificate::Kind::nearer});
        return s != 0 ? s > 0 : precedes(a, b);
    }
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept { return sites_.precedes(a, b); }
    /// Below 0 where a comes before b along any line: by x and then by y. 0 where they are for ever
    /// at one place.
    [[nodiscard]] Sign compare_along(Index a, Index b) {
        const Sign s = beyond(a, b, true);
        return s != 0 ? s : beyond(a, b, false);
    }
    [[nodiscard]] Sign beyond(Index a, Index b, bool along_x) {
        return sign({{a, b, b, b}, Certificate::Kind::beyond, along_x});
    }

    /// Right after the time; 0 where it is 0 for ever.
    [[nodiscard]] Sign sign(const Certificate& certificate) {
        return moment_.sign_after(sites_, certificate, &tally_);
    }

 private:
    const Sites& sites_;
    const Moment& moment_;
    roots::Tally& tally_;
};

}  // namespace signum::kinetic
