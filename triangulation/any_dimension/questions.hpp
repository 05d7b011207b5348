#pragma once
/// The questions of power tessellations in any dimension, of sites by their numbers.
///
/// Where the centres lie in a flat of k < D dimensions, k of the axes are enough to tell its points
/// apart, and all is asked as in k dimensions, along these axes, but of the heights |x|² - w of the
/// whole space: the projection is an affine map of the flat, and a lower hull does not mind one.
///
/// Laws, c_i being the centres along the axes:
///  1. orientation(v_0, ..., v_k) is the sign of det[c_i - c_0], never perturbed;
///  2. in_sphere(v, q), where the orientation of v is positive, is (-1)^k times the sign of
///     det[c_i - c_q, |c_i - c_q|² - w_i + w_q]: +1 where q is below the hyperplane through the
///     lifted v, 0 where it is on it;
///  3. conflicts(v, q) is the same under the tie rule: weights are thought of as reduced by
///     infinitesimals, infinitely larger for the later site in the rule's order. The coefficient of
///     that of v_i is the orientation of v with q in the place of v_i, that of q's own is -1. The
///     last site whose coefficient is not 0 decides.
///
/// A sign comes from the filter (rounded.hpp; in space those of predicates/space/), otherwise from
/// exact numbers of the type Exact (exact.hpp); a check in space asks integers of a few words
/// first. For the plane's own kinds of sites the predicates of predicates/power/ answer.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "../../core/index.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "exact.hpp"
#include "few.hpp"
#include "rounded.hpp"
#include "sites.hpp"
#include "word_integers.hpp"

namespace signum::any_dimension {

/// The axes along which sites are told apart.
template <int D>
struct Axes {
    std::array<std::size_t, static_cast<std::size_t>(D)> axis{};
    std::size_t count = 0;

    [[nodiscard]] static Axes all() noexcept {
        Axes result;
        for (result.count = 0; result.count < static_cast<std::size_t>(D); ++result.count)
            result.axis[result.count] = result.count;
        return result;
    }
    [[nodiscard]] bool has(std::size_t which) const noexcept {
        return std::find(axis.begin(), axis.begin() + count, which) != axis.begin() + count;
    }
};

/// Without filters exact numbers decide all.
template <class S, class Exact, bool has_filters = true>
class Questions {
 public:
    static constexpr bool is_filtered = has_filters;
    static constexpr int D = dimension_of<S>;
    using Cell = CellOf<D>;

    explicit Questions(std::span<const S> sites) : sites_(sites), unit_(sites) {}

    void ask_along(const Axes<D>& axes) noexcept { axes_ = axes; }
    [[nodiscard]] const Axes<D>& axes() const noexcept { return axes_; }
    /// k.
    [[nodiscard]] std::size_t dimension() const noexcept { return axes_.count; }
    [[nodiscard]] const S& site(Index i) const noexcept {
        return sites_[static_cast<std::size_t>(i)];
    }

    [[nodiscard]] Sign orientation(const Cell& v) { return orientation(v, axes_); }
    /// Along other axes, of one vertex more than these are.
    [[nodiscard]] Sign orientation(const Cell& v, const Axes<D>& axes) {
        if constexpr (power::PowerSite<S>)
            if (axes.count == 2)
                return decided(predicates::decide<in_plane, predicates::Ccw>(site(v[0]), site(v[1]),
                                                                             site(v[2])));
        if constexpr (D == 3 && HasCentre3<S>) {
            if (axes.count == 3) {
                const filters::Verdict verdict =
                    predicates::ccw_filter(site(v[0]), site(v[1]), site(v[2]), site(v[3]));
                if (verdict.is_certain()) [[likely]]
                    return filtered(verdict.sign());
                return exactly(exact_orientation(v, axes));
            }
        }
        RoundedDeterminant<most> rounded;
        rounded.size = axes.count;
        for (std::size_t i = 0; i < axes.count; ++i)
            for (std::size_t k = 0; k < axes.count; ++k)
                rounded.set(i, k, offset<double>(site(v[i + 1]), site(v[0]), axes.axis[k]));
        const filters::Verdict verdict = rounded_sign<D, false>(rounded, unit_);
        if (has_filters && verdict.is_certain()) return filtered(verdict.sign());
        return exactly(exact_orientation(v, axes));
    }
    /// The orientation of v with the middle of the sites of another cell in the place of one of its
    /// vertices; k >= 1.
    [[nodiscard]] Sign orientation_with_middle(Cell v, std::size_t place, const Cell& other) {
        Sign turn = 1;
        if (place == 0) {
            std::swap(v[0], v[1]);
            place = 1;
            turn = -1;
        }
        // Its row k+1 times, which is a sum of offsets.
        const std::size_t k = axes_.count;
        RoundedDeterminant<most> rounded;
        rounded.size = k;
        for (std::size_t i = 0; i < k; ++i)
            for (std::size_t m = 0; m < k; ++m) {
                if (i + 1 != place) {
                    rounded.set(i, m, offset<double>(site(v[i + 1]), site(v[0]), axes_.axis[m]));
                    continue;
                }
                double terms = 0.0;
                for (std::size_t each = 0; each <= k; ++each) {
                    const double x = offset<double>(site(other[each]), site(v[0]), axes_.axis[m]);
                    rounded.rows[i][m] += x;
                    terms += filters::magnitude(x);
                }
                rounded.largest[m] = std::max(rounded.largest[m], terms);
            }
        // Adding up and its terms' own sum commit k + 1 more roundings each.
        const filters::Verdict verdict =
            rounded_sign<D, false>(rounded, unit_, 2 * static_cast<int>(k + 1));
        if (has_filters && verdict.is_certain()) return filtered(turn * verdict.sign());
        Matrix<Exact, most> rows = exact_offsets(v, axes_, place);
        for (std::size_t m = 0; m < k; ++m)
            for (std::size_t each = 0; each <= k; ++each)
                rows[place - 1][m] = rows[place - 1][m] +
                                     offset<Exact>(site(other[each]), site(v[0]), axes_.axis[m]);
        return exactly(turn * sign_of_determinant(rows, k));
    }
    /// Precondition: orientation(v) > 0.
    [[nodiscard]] Sign in_sphere(const Cell& v, Index q) {
        const std::size_t k = axes_.count;
        if constexpr (power::PowerSite<S>)
            if (k == 2)
                return decided(predicates::decide<in_plane, power::InCircle>(site(v[0]), site(v[1]),
                                                                             site(v[2]), site(q)));
        const Sign turn = k % 2 == 0 ? 1 : -1;
        if constexpr (D == 3 && HasCentre3<S>) {
            if (k == 3) {
                const filters::Verdict verdict = power::in_sphere_filter(
                    site(v[0]), site(v[1]), site(v[2]), site(v[3]), site(q));
                if (verdict.is_certain()) [[likely]]
                    return filtered(verdict.sign());
                return exactly(turn * exact_in_sphere(v, q));
            }
        }
        RoundedDeterminant<most> rounded;
        rounded.size = k + 1;
        for (std::size_t i = 0; i <= k; ++i) {
            for (std::size_t m = 0; m < k; ++m)
                rounded.set(i, m, offset<double>(site(v[i]), site(q), axes_.axis[m]));
            rounded.rows[i][k] = height<double>(site(v[i]), site(q));
            // What it is a sum of, without the signs.
            double terms =
                filters::magnitude(power::weight_difference<double>(site(v[i]), site(q)));
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis) {
                const double x = offset<double>(site(v[i]), site(q), axis);
                terms += x * x;
            }
            rounded.largest[k] = std::max(rounded.largest[k], terms);
        }
        const filters::Verdict verdict = rounded_sign<D, true>(rounded, unit_);
        if (has_filters && verdict.is_certain()) return filtered(turn * verdict.sign());
        return exactly(turn * exact_in_sphere(v, q));
    }
    /// in_sphere(v, q) = 0 under the tie rule.
    [[nodiscard]] bool tie_conflicts(const Cell& v, Index q) {
        std::array<std::size_t, static_cast<std::size_t>(D) + 2> order;
        const std::size_t vertices = axes_.count + 1;
        const auto number = [&](std::size_t m) { return m == vertices ? q : v[m]; };
        for (std::size_t m = 0; m <= vertices; ++m) order[m] = m;
        // The last site first.
        sort_few(
            vertices + 1,
            [&](std::size_t a, std::size_t b) {
                return precedes(number(order[a]), number(order[b]));
            },
            [&](std::size_t a, std::size_t b) { std::swap(order[a], order[b]); });
        for (std::size_t m = 0; m <= vertices; ++m) {
            if (order[m] == vertices) return false;
            Cell with_q = v;
            with_q[order[m]] = q;
            if (const Sign sign = orientation(with_q); sign != 0) return sign > 0;
        }
        return false;
    }
    [[nodiscard]] bool conflicts(const Cell& v, Index q) {
        const Sign sign = in_sphere(v, q);
        return sign != 0 ? sign > 0 : tie_conflicts(v, q);
    }
    /// +1 where the centre of q is nearer to a than to b: |q - a|² - w_a < |q - b|² - w_b.
    [[nodiscard]] Sign nearer(Index q, Index a, Index b) {
        const S origin = without_weight(site(q));
        const double to_a = height<double>(site(a), origin);
        const double to_b = height<double>(site(b), origin);
        double terms = 0.0;
        for (const Index each : {a, b}) {
            terms += filters::magnitude(power::weight_difference<double>(site(each), origin));
            for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis) {
                const double x = offset<double>(site(each), site(q), axis);
                terms += x * x;
            }
        }
        // Each height has D + 4 roundings at most, their difference one more; as in rounded.hpp.
        // Underflow loses 2^-1070 at most.
        constexpr double error = (D + 4 + 1 + 2) * filters::epsilon;
        if (has_filters && terms < 0x1p1000 &&
            filters::magnitude(to_b - to_a) > error * terms + 0x1p-1000)
            return filtered(sign_of(to_b - to_a));
        return exactly((height<Exact>(site(b), origin) - height<Exact>(site(a), origin)).sign());
    }
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        return any_dimension::precedes(site(a), a, site(b), b);
    }

    /// How many signs came from filters, and from exact numbers.
    [[nodiscard]] std::uint64_t filtered_count() const noexcept { return filtered_; }
    [[nodiscard]] std::uint64_t exact_count() const noexcept { return exact_; }

 private:
    static constexpr std::size_t most = static_cast<std::size_t>(D) + 1;
    /// A judge's numbers in space: first those of a few words (word_integers.hpp).
    static constexpr bool is_judge = std::is_same_v<Exact, exact::Dyadic>;
    static constexpr bool judges_in_words = D == 3 && HasCentre3<S> && is_judge;
    static constexpr Arithmetic in_plane =
        is_judge ? Arithmetic::judging : Arithmetic::multiprecision;

    Sign decided(const Decision& decision) noexcept {
        return decision.stage == Stage::filter ? filtered(decision.sign) : exactly(decision.sign);
    }
    Sign filtered(Sign sign) noexcept {
        ++filtered_;
        return sign;
    }
    Sign exactly(Sign sign) noexcept {
        ++exact_;
        return sign;
    }
    [[nodiscard]] static S without_weight(S s) noexcept {
        if constexpr (requires { s.w; }) s.w = 0.0;
        if constexpr (requires { s.r; }) s.r = 0.0;
        return s;
    }
    /// c_i - c_0; row i - 1 is 0 for one i, if it is to be.
    [[nodiscard]] Matrix<Exact, most> exact_offsets(const Cell& v, const Axes<D>& axes,
                                                    std::size_t but = 0) const {
        Matrix<Exact, most> rows;
        for (std::size_t i = 0; i < axes.count; ++i)
            for (std::size_t k = 0; k < axes.count && i + 1 != but; ++k)
                rows[i][k] = offset<Exact>(site(v[i + 1]), site(v[0]), axes.axis[k]);
        return rows;
    }
    [[nodiscard, gnu::cold]] Sign exact_orientation(const Cell& v, const Axes<D>& axes) const {
        if constexpr (judges_in_words) {
            if (axes.count == 3)
                if (const std::optional<Sign> sign =
                        orientation_in_words(site(v[0]), site(v[1]), site(v[2]), site(v[3])))
                    return *sign;
        }
        return sign_of_determinant(exact_offsets(v, axes), axes.count);
    }
    [[nodiscard, gnu::cold]] Sign exact_in_sphere(const Cell& v, Index q) const {
        const std::size_t k = axes_.count;
        if constexpr (judges_in_words) {
            if (k == 3)
                if (const std::optional<Sign> sign = in_sphere_in_words(
                        std::array{site(v[0]), site(v[1]), site(v[2]), site(v[3])}, site(q)))
                    return *sign;
        }
        Matrix<Exact, most> rows;
        for (std::size_t i = 0; i <= k; ++i) {
            for (std::size_t m = 0; m < k; ++m)
                rows[i][m] = offset<Exact>(site(v[i]), site(q), axes_.axis[m]);
            rows[i][k] = height<Exact>(site(v[i]), site(q));
        }
        return sign_of_determinant(rows, k + 1);
    }

    std::span<const S> sites_;
    Unit unit_;
    Axes<D> axes_ = Axes<D>::all();
    std::uint64_t filtered_ = 0;
    std::uint64_t exact_ = 0;
};

}  // namespace signum::any_dimension
