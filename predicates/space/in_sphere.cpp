#include "in_sphere.hpp"

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <initializer_list>

#include "../../core/processor.hpp"
#include "../../exact/expansion.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../filters/wide.hpp"
#include "multiprecision.hpp"
#include "refined.hpp"

namespace signum::power {
namespace {

using filters::DoubleDouble;
using filters::magnitude;
using filters::Verdict;

/// The determinant in integers, where the differences to q are exact and multiples of one power of
/// two g below 2^60 g: on grids, where exact ties abound, and for most sites that lie close
/// together. Heights are then below 2^123, minors of two rows below 2^121 and of three below 2^183,
/// and the sum of four products below 2^308. Of those below 2^20 g all is below 2^108.
class IntegerRows {
 public:
    template <PowerSite3 S>
    IntegerRows(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
        const S* sites[4] = {&i, &j, &k, &l};
        TwoTerms offsets[4][3];
        double all[4 * 3 + 5];
        std::size_t numbers = 0;
        for (int m = 0; m < 4; ++m) {
            offsets[m][0] = two_difference(sites[m]->x, q.x);
            offsets[m][1] = two_difference(sites[m]->y, q.y);
            offsets[m][2] = two_difference(sites[m]->z, q.z);
            for (const TwoTerms& each : offsets[m]) {
                is_exact_ &= each.low == 0.0;
                all[numbers++] = each.high;
            }
        }
        if constexpr (requires { q.r; })
            for (const S* site : {&i, &j, &k, &l, &q}) all[numbers++] = site->r;
        if (!is_exact_) return;
        // The exponents of the largest number, and of the last bit of any.
        int highest = -2000;
        int lowest = 2000;
        for (std::size_t n = 0; n < numbers; ++n) {
            if (all[n] == 0.0) continue;
            const auto bits = std::bit_cast<std::uint64_t>(all[n]);
            const int exponent = static_cast<int>(bits >> 52 & 0x7FF) - 1023;
            const std::uint64_t significand = (bits & 0xF'FFFF'FFFF'FFFF) | 1ULL << 52;
            highest = std::max(highest, exponent);
            lowest = std::min(lowest, exponent - 52 + std::countr_zero(significand));
        }
        bits_ = highest - lowest + 1;
        is_exact_ = bits_ <= 60;
        if (!is_exact_) return;
        const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - lowest) << 52);
        for (int m = 0; m < 4; ++m) {
            rows_[m].offset = {integer(offsets[m][0].high * scale),
                               integer(offsets[m][1].high * scale),
                               integer(offsets[m][2].high * scale)};
            rows_[m].weight = weight(*sites[m], q, scale);
        }
    }

    /// The exact sign, or uncertain where the sites are not such integers.
    [[nodiscard]] Verdict sign_if_narrow() const noexcept {
        if (!is_exact_ || bits_ > 20) return Verdict::uncertain();
        const Integer128 determinant = in_sphere_determinant(
            row<Integer128>(0), row<Integer128>(1), row<Integer128>(2), row<Integer128>(3));
        return Verdict::certain((determinant > 0) - (determinant < 0));
    }
    [[nodiscard]] Verdict sign_if_wide() const noexcept {
        if (!is_exact_) return Verdict::uncertain();
        return Verdict::certain(in_sphere_determinant(row<Integer512>(0), row<Integer512>(1),
                                                      row<Integer512>(2), row<Integer512>(3))
                                    .sign());
    }

 private:
    using Integer128 = __int128;
    using Integer512 = boost::multiprecision::int512_t;
    struct IntegerRow {
        predicates::Offset3<std::int64_t> offset;
        Integer128 weight;
    };

    template <class Integer>
    [[nodiscard]] LiftedRow<Integer> row(int m) const noexcept {
        const auto& [x, y, z] = rows_[m].offset;
        return {{Integer(x), Integer(y), Integer(z)}, Integer(rows_[m].weight)};
    }
    [[nodiscard]] static std::int64_t integer(double value) noexcept {
        return static_cast<std::int64_t>(value);
    }
    [[nodiscard]] static Integer128 weight(const Point3&, const Point3&, double) noexcept {
        return 0;
    }
    [[nodiscard]] Integer128 weight(const Site3& m, const Site3& q, double scale) noexcept {
        const TwoTerms difference = two_difference(m.w, q.w);
        const double value = difference.high * scale * scale;
        const double most = bits_ <= 20 ? 0x1p42 : 0x1p122;
        if (difference.low != 0.0 || !(magnitude(value) < most)) {
            // A weight that is too large for narrow integers may suit wide ones.
            if (bits_ <= 20 && difference.low == 0.0 && magnitude(value) < 0x1p122)
                bits_ = 60;
            else
                is_exact_ = false;
        }
        if (!is_exact_) return 0;
        const auto result = static_cast<Integer128>(value);
        is_exact_ &= static_cast<double>(result) == value;
        return result;
    }
    [[nodiscard]] static Integer128 weight(const signum::Site3& m, const signum::Site3& q,
                                           double scale) noexcept {
        const Integer128 m_radius = integer(m.r * scale);
        const Integer128 q_radius = integer(q.r * scale);
        return (m_radius - q_radius) * (m_radius + q_radius);
    }

    bool is_exact_ = true;
    int bits_ = 0;
    IntegerRow rows_[4];
};

/// The determinant's magnitude: every operand replaced by its absolute value, every difference by a
/// sum.
[[nodiscard]] double determinant_magnitude(const LiftedRow<double> (&rows)[4]) noexcept {
    const auto of_minor = [&](int j, int k, int l) {
        const auto& [bx, by, bz] = rows[j].offset;
        const auto& [cx, cy, cz] = rows[k].offset;
        const auto& [dx, dy, dz] = rows[l].offset;
        return magnitude(bz) * (magnitude(cx * dy) + magnitude(cy * dx)) +
               magnitude(cz) * (magnitude(dx * by) + magnitude(dy * bx)) +
               magnitude(dz) * (magnitude(bx * cy) + magnitude(by * cx));
    };
    const auto height = [&](int m) {
        const auto& [x, y, z] = rows[m].offset;
        return (x * x + y * y + z * z) + magnitude(rows[m].weight);
    };
    return height(0) * of_minor(1, 2, 3) + height(1) * of_minor(2, 3, 0) +
           height(2) * of_minor(3, 0, 1) + height(3) * of_minor(0, 1, 2);
}

[[nodiscard]] Verdict judged(double determinant, double bound) noexcept {
    if (magnitude(determinant) > bound)
        return Verdict::certain(filters::sign_of_nonzero(determinant));
    return Verdict::uncertain();
}

/// Where double-doubles might over- or underflow. The origin may be any of the five: the
/// determinant is that of five rows (1, x, y, z, height), of which exchanging two turns the sign.
template <PowerSite3 S>
[[nodiscard]] Decision decide_beyond_window(const S& i, const S& j, const S& k, const S& l,
                                            const S& q) noexcept {
    std::array sites = {&i, &j, &k, &l, &q};
    const Sign turn = filters::base_on_least(sites);
    const auto row = [&](std::size_t m) { return lifted_row<filters::Wide>(*sites[m], *sites[4]); };
    const Verdict verdict = in_sphere_determinant(row(0), row(1), row(2), row(3)).sign();
    if (verdict.is_certain()) return {turn * verdict.sign(), Stage::filter};
    return {multiprecision::in_sphere(i, j, k, l, q), Stage::multiprecision};
}

/// Whether five sites of equal weights are corners of a box along the axes: no more than two
/// coordinates along each. They lie on one sphere then, however these were rounded: all of a grid.
template <PowerSite3 S>
[[nodiscard]] bool are_corners_of_a_box(const S& i, const S& j, const S& k, const S& l,
                                        const S& q) noexcept {
    const auto are_two = [&](double S::*const axis) {
        const double one = q.*axis;
        double other = one;
        for (const S* site : {&i, &j, &k, &l}) {
            const double here = site->*axis;
            if (here != one && other != one && here != other) return false;
            if (here != one) other = here;
        }
        return true;
    };
    const auto is_one = [&](double S::*const number) {
        return i.*number == q.*number && j.*number == q.*number && k.*number == q.*number &&
               l.*number == q.*number;
    };
    if constexpr (requires { q.r; }) {
        if (!is_one(&S::r)) return false;
    }
    if constexpr (requires { q.w; }) {
        if (!is_one(&S::w)) return false;
    }
    return are_two(&S::x) && are_two(&S::y) && are_two(&S::z);
}

template <PowerSite3 S>
[[nodiscard]] Decision decide(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
    if (!in_window(i) || !in_window(j) || !in_window(k) || !in_window(l) || !in_window(q))
        return decide_beyond_window(i, j, k, l, q);
    const LiftedRow<double> rows[4] = {lifted_row(i, q), lifted_row(j, q), lifted_row(k, q),
                                       lifted_row(l, q)};
    const double determinant = in_sphere_determinant(rows[0], rows[1], rows[2], rows[3]);
    const double size = determinant_magnitude(rows);
    if (const Verdict verdict = judged(determinant, in_sphere_error * size); verdict.is_certain())
        return {verdict.sign(), Stage::filter};
    if (are_corners_of_a_box(i, j, k, l, q)) return {0, Stage::exact};
    // Narrow integers are faster than double-doubles, and these than wide ones.
    const IntegerRows integers(i, j, k, l, q);
    if (const Verdict verdict = integers.sign_if_narrow(); verdict.is_certain())
        return {verdict.sign(), Stage::exact};
    DoubleDouble refined;
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        refined = in_sphere_determinant(double_double_row(i, q), double_double_row(j, q),
                                        double_double_row(k, q), double_double_row(l, q));
    });
    if (const Verdict verdict = judged(refined.high, refined_in_sphere_error * size);
        verdict.is_certain())
        return {verdict.sign(), Stage::refine};
    if (const Verdict verdict = integers.sign_if_wide(); verdict.is_certain())
        return {verdict.sign(), Stage::exact};
    return {multiprecision::in_sphere(i, j, k, l, q), Stage::multiprecision};
}

}  // namespace

Decision in_sphere_cold(const Point3& i, const Point3& j, const Point3& k, const Point3& l,
                        const Point3& q) noexcept {
    return exact::in_ieee_environment(decide<Point3>, i, j, k, l, q);
}
Decision in_sphere_cold(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                        const Site3& q) noexcept {
    return exact::in_ieee_environment(decide<Site3>, i, j, k, l, q);
}
Decision in_sphere_cold(const signum::Site3& i, const signum::Site3& j, const signum::Site3& k,
                        const signum::Site3& l, const signum::Site3& q) noexcept {
    return exact::in_ieee_environment(decide<signum::Site3>, i, j, k, l, q);
}

}  // namespace signum::power
