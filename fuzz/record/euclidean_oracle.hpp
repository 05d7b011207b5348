#pragma once
/// The metric |p - c| - r in integers, in the plane and in space, from the equations of a sphere
/// that touches: no polynomial of the library's, and no rule for ties.
///
/// Relative to the first site a sphere of centre X and radius rho has R = rho + r_0, and P = (X, R)
/// obeys |X|² = R² and, for each other site, x·X + r R = p / 2 with p = |x|² - r². The latter are d
/// equations: P = P0 + t n, with n across all rows (x, r). In Lorentz's form <P,P> = |X|² - R²
/// that is a t² + 2 b t + c = 0, with a = <n,n>, b = <P0,n>, c = <P0,P0>, of whose roots
/// <P,n> = b + a t = ±√(b² - ac). Where all R + r > 0 the points of contact, directions
/// (x - X) / (R + r), turn as det[direction, 1] does, which is that of the rows (x - X, r + R), of
/// the first (-X, R): so one root turns positively and the other negatively, as <P,n> is negative
/// or positive in the plane, and the other way round in space.
///
/// P0 = N / (2δ), where δ is a component of n that is not 0 and N by Cramer's rule.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "determinant.hpp"
#include "scaled.hpp"

namespace signum::fuzz::euclidean_oracle {

/// A site relative to another one: its centre, then its radius.
template <std::size_t d>
using Row = std::array<Integer, d + 1>;

template <std::size_t d>
[[nodiscard]] Row<d> row(const Exact<d>& site, const Exact<d>& base) {
    Row<d> result;
    for (std::size_t k = 0; k < d; ++k) result[k] = site.centre[k] - base.centre[k];
    result[d] = site.size - base.size;
    return result;
}
template <std::size_t d>
[[nodiscard]] Integer lorentz(const Row<d>& a, const Row<d>& b) {
    Integer sum = a[0] * b[0];
    for (std::size_t k = 1; k < d; ++k) sum.add_product(a[k], b[k]);
    return std::move(sum.subtract_product(a[d], b[d]));
}
template <std::size_t d>
[[nodiscard]] Integer inner(const Row<d>& a, const Row<d>& b) {
    Integer sum = a[0] * b[0];
    for (std::size_t k = 1; k <= d; ++k) sum.add_product(a[k], b[k]);
    return sum;
}

/// How one site lies to another one.
enum class Cover : std::int8_t { none, touches, inside };
/// Whether i covers q: |c_i - c_q| <= r_i - r_q, with or without a touch.
template <std::size_t d>
[[nodiscard]] Cover cover(const Exact<d>& i, const Exact<d>& q) {
    const Row<d> to = row(q, i);
    if (to[d].sign() > 0) return Cover::none;
    const int sign = lorentz<d>(to, to).sign();
    return sign > 0 ? Cover::none : (sign == 0 ? Cover::touches : Cover::inside);
}

/// The sphere that touches d + 1 sites with positively oriented points of contact.
template <std::size_t d>
class Sphere {
 public:
    template <class Sites>
    explicit Sphere(const Sites& sites) : base_(*sites[0]) {
        std::array<Row<d>, d> rows;
        std::array<Integer, d> powers;
        for (std::size_t m = 0; m < d; ++m) {
            rows[m] = row<d>(*sites[m + 1], base_);
            powers[m] = lorentz<d>(rows[m], rows[m]);
            other_radii_[m] = rows[m][d];
        }
        // n_k = (-1)^k det of the rows without column k.
        const auto without = [&](std::size_t column) {
            Matrix<d> matrix;
            for (std::size_t m = 0; m < d; ++m)
                for (std::size_t k = 0; k < d; ++k) matrix[m][k] = &rows[m][k < column ? k : k + 1];
            return matrix;
        };
        std::size_t pivot = d + 1;
        for (std::size_t k = 0; k <= d; ++k) {
            n_[k] = determinant(without(k));
            if (k % 2 == 1) n_[k] = -std::move(n_[k]);
            if (n_[k].sign() != 0) pivot = k;
        }
        if (pivot > d) return;  // all sites in a line, or a plane, with their radii
        spans_ = true;
        delta_ = n_[pivot];
        for (std::size_t k = 0; k <= d; ++k) {
            if (k == pivot) continue;
            Matrix<d> matrix = without(pivot);
            for (std::size_t m = 0; m < d; ++m) matrix[m][k < pivot ? k : k - 1] = &powers[m];
            start_[k] = determinant(matrix);
            if (pivot % 2 == 1) start_[k] = -std::move(start_[k]);
        }
        a_ = lorentz<d>(n_, n_);
        b_ = lorentz<d>(start_, n_);
        c_ = lorentz<d>(start_, start_);
        s_ = minor(b_, a_, c_, b_);
        constexpr int turn = d == 2 ? -1 : 1;
        has_root_ = a_.sign() != 0 ? s_.sign() > 0 : b_.sign() * delta_.sign() == turn;
        if (!has_root_) return;
        // Positive distances to all: the first one is R.
        Row<d> unit;
        unit[d] = Integer(1);
        bool touches = true;
        for (std::size_t m = 0; m <= d && touches; ++m) {
            const int sign = sign_of(unit, m == 0 ? Integer() : other_radii_[m - 1]);
            touches = sign > 0;
            meets_centre_ |= sign == 0;
        }
        exists_ = touches;
    }

    [[nodiscard]] bool exists() const { return exists_; }
    /// Where the equations are not those of two spheres: one has become a line (a plane), both are
    /// one, or the sites are not independent.
    [[nodiscard]] bool is_degenerate() const {
        return !spans_ || a_.sign() == 0 || s_.sign() == 0 || meets_centre_;
    }
    /// +1 where q is nearer to the centre than the sites, 0 where it touches the sphere.
    [[nodiscard]] int conflict(const Exact<d>& q) const {
        Row<d> to = row<d>(q, base_);
        Row<d> unit;
        unit[d] = Integer(1);
        if (sign_of(unit, to[d]) < 0) return -1;  // no distance is negative
        const Integer power = lorentz<d>(to, to);
        for (Integer& x : to) x += Integer(x);
        return sign_of(to, -power);
    }

 private:
    /// The sign of linear·P + constant.
    [[nodiscard]] int sign_of(const Row<d>& linear, const Integer& constant) const {
        const Integer at_start = inner<d>(linear, start_);
        const Integer along = inner<d>(linear, n_);
        const Integer twice = constant + constant;
        if (a_.sign() == 0) {
            // t = -c / (2b): times 4 δ B.
            Integer value = b_ * (at_start + at_start);
            value.add_product(b_ * delta_, twice + twice);
            value.subtract_product(along, c_);
            return value.sign() * b_.sign() * delta_.sign();
        }
        // Times 2 δ a.
        Integer rational = at_start;
        rational.add_product(delta_, twice);
        rational = a_ * rational;
        rational.subtract_product(along, b_);
        const bool minus = (d == 2) == (delta_.sign() > 0);
        const int sign = sign_with_root(rational, minus ? -along : along, s_);
        return sign * a_.sign() * delta_.sign();
    }

    Exact<d> base_;
    std::array<Integer, d> other_radii_;
    Row<d> n_;
    Row<d> start_;  // 2 δ P0
    Integer delta_;
    Integer a_;
    Integer b_;  // 2 δ b
    Integer c_;  // 4 δ² c
    Integer s_;  // b² - ac of these
    bool spans_ = false;
    bool has_root_ = false;
    bool exists_ = false;
    bool meets_centre_ = false;
};

/// Whether q reaches across the line that has first a and then b on its left and touches both: 0
/// where it touches the line. With its normal m, m·(c_b - c_a) = r_b - r_a. In the plane.
[[nodiscard]] inline int across_line(const Exact<2>& a, const Exact<2>& b, const Exact<2>& q) {
    const Row<2> u = row<2>(b, a);
    const Row<2> w = row<2>(q, a);
    // |u|² m = s u + √p (-u_y, u_x); q reaches across where m·w < z.
    const Integer p = lorentz<2>(u, u);
    Integer square = u[0] * u[0];
    square.add_product(u[1], u[1]);
    Integer along = u[0] * w[0];
    along.add_product(u[1], w[1]);
    return sign_with_root(minor(w[2], u[2], along, square), minor(u[1], u[0], w[1], w[0]), p);
}

/// +1 where a is nearer to the centre of the first one than b.
template <std::size_t d>
[[nodiscard]] int nearer(const Exact<d>& point, const Exact<d>& a, const Exact<d>& b) {
    const auto square = [&](const Exact<d>& site) {
        Integer sum;
        for (std::size_t k = 0; k < d; ++k) {
            const Integer x = site.centre[k] - point.centre[k];
            sum.add_product(x, x);
        }
        return sum;
    };
    // √v - √u + s, the distances of b and a and the difference of the radii.
    const Integer u = square(a);
    const Integer v = square(b);
    const Integer s = a.size - b.size;
    Integer rest = v - u;
    if (s.sign() >= 0) return sign_with_root(rest.add_product(s, s), s + s, v);
    return sign_with_root(rest.subtract_product(s, s), s + s, u);
}

}  // namespace signum::fuzz::euclidean_oracle
