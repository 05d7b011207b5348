#pragma once
/// The power metric in integers, in the plane and in space. A site is lifted to the height
/// |c|² - w; spheres are hyperplanes through lifted sites, and who conflicts lies below.

#include <array>
#include <cstddef>
#include <cstdint>

#include "determinant.hpp"
#include "scaled.hpp"

namespace signum::fuzz::power_oracle {

/// A site relative to another one, and its height.
template <std::size_t d>
struct Lifted {
    std::array<Integer, d> x;
    Integer height;
};

template <std::size_t d>
[[nodiscard]] Integer weight(Kind kind, const Exact<d>& site) {
    return kind == Kind::radii ? site.size * site.size : site.size;
}

/// Heights differ from those of the definition by a linear function, which makes no difference.
template <std::size_t d>
[[nodiscard]] Lifted<d> lift(Kind kind, const Exact<d>& site, const Exact<d>& base) {
    Lifted<d> lifted;
    for (std::size_t k = 0; k < d; ++k) {
        lifted.x[k] = site.centre[k] - base.centre[k];
        lifted.height.add_product(lifted.x[k], lifted.x[k]);
    }
    if (kind != Kind::points) {
        lifted.height -= weight(kind, site);
        lifted.height += weight(kind, base);
    }
    return lifted;
}

/// How d + 1 centres turn.
template <std::size_t d, class Sites>
[[nodiscard]] int turn(const Sites& sites) {
    std::array<std::array<Integer, d>, d> rows;
    Matrix<d> matrix;
    for (std::size_t m = 0; m < d; ++m)
        for (std::size_t k = 0; k < d; ++k) {
            rows[m][k] = sites[m + 1]->centre[k] - sites[0]->centre[k];
            matrix[m][k] = &rows[m][k];
        }
    return determinant(matrix).sign();
}

/// d + 2 sites, the last of which is asked for; d + 1 others that turn positively.
template <std::size_t d>
class Question {
 public:
    template <class Sites>
    Question(Kind kind, const Sites& sites) {
        for (std::size_t m = 0; m <= d; ++m) lifted_[m] = lift(kind, *sites[m + 1], *sites[0]);
    }

    /// +1 where the last one lies below the hyperplane of the others.
    [[nodiscard]] int sign() const {
        std::array<const Integer*, d + 1> heights;
        for (std::size_t m = 0; m <= d; ++m) heights[m] = &lifted_[m].height;
        return sign_of(heights);
    }
    /// What 0 becomes: each site rises by an infinitesimal of its own, the later one in the order
    /// by an infinitely larger one; ranks are places in the order.
    [[nodiscard]] int sign_of_tie(const std::array<std::int32_t, d + 2>& ranks) const {
        static const Integer zero(0), one(1), less(-1);
        for (std::int32_t rank = d + 1; rank >= 0; --rank)
            for (std::size_t m = 0; m < d + 2; ++m) {
                if (ranks[m] != rank) continue;
                std::array<const Integer*, d + 1> heights;
                // Where the first one rises the others sink.
                heights.fill(m == 0 ? &less : &zero);
                if (m != 0) heights[m - 1] = &one;
                if (const int sign = sign_of(heights); sign != 0) return sign;
            }
        return 0;
    }

 private:
    [[nodiscard]] int sign_of(const std::array<const Integer*, d + 1>& heights) const {
        Matrix<d + 1> matrix;
        for (std::size_t m = 0; m <= d; ++m) {
            for (std::size_t k = 0; k < d; ++k) matrix[m][k] = &lifted_[m].x[k];
            matrix[m][d] = heights[m];
        }
        return -determinant(matrix).sign();
    }

    std::array<Lifted<d>, d + 1> lifted_;
};

/// Of q on the line of a and b, whose centres differ: the same on the line. In the plane.
template <class Sites>
[[nodiscard]] int in_segment(Kind kind, const Sites& sites) {
    const Lifted<2> b = lift<2>(kind, *sites[1], *sites[0]);
    const Lifted<2> q = lift<2>(kind, *sites[2], *sites[0]);
    const std::size_t k = b.x[0].sign() != 0 ? 0 : 1;
    return -b.x[k].sign() * minor(b.x[k], b.height, q.x[k], q.height).sign();
}
/// Its ties, by the same infinitesimals.
template <class Sites>
[[nodiscard]] int in_segment_tie(const Sites& sites, const std::array<std::int32_t, 3>& ranks) {
    const Lifted<2> b = lift<2>(Kind::points, *sites[1], *sites[0]);
    const Lifted<2> q = lift<2>(Kind::points, *sites[2], *sites[0]);
    const std::size_t k = b.x[0].sign() != 0 ? 0 : 1;
    for (std::int32_t rank = 2; rank >= 0; --rank)
        for (std::size_t m = 0; m < 3; ++m) {
            if (ranks[m] != rank) continue;
            const Integer of_b(m == 0 ? -1 : (m == 1 ? 1 : 0));
            const Integer of_q(m == 0 ? -1 : (m == 2 ? 1 : 0));
            const int sign = -b.x[k].sign() * minor(b.x[k], of_b, q.x[k], of_q).sign();
            if (sign != 0) return sign;
        }
    return 0;
}

/// +1 where a is nearer to the centre of the first of the three than b.
template <std::size_t d, class Sites>
[[nodiscard]] int nearer(Kind kind, const Sites& sites) {
    Integer difference;
    for (std::size_t k = 0; k < d; ++k) {
        const Integer to_a = sites[1]->centre[k] - sites[0]->centre[k];
        const Integer to_b = sites[2]->centre[k] - sites[0]->centre[k];
        difference.add_product(to_b, to_b);
        difference.subtract_product(to_a, to_a);
    }
    if (kind != Kind::points) {
        difference += weight(kind, *sites[1]);
        difference -= weight(kind, *sites[2]);
    }
    return difference.sign();
}

}  // namespace signum::fuzz::power_oracle
