#include "scaled_sites.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "../core/error_free.hpp"
#include "../exact/multiprecision.hpp"

namespace signum {
namespace {

using exact::Rational;

/// Below it a product of three differences of coordinates and two squares is a double.
constexpr double largest = 0x1p200;

[[nodiscard]] bool is_usual(const Point3& p) noexcept {
    // A NaN fails.
    return std::fabs(p.x) <= largest && std::fabs(p.y) <= largest && std::fabs(p.z) <= largest;
}

[[nodiscard]] Point3 divided(const Point3& p, int exponent) noexcept {
    return {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
}

[[nodiscard]] int exponent_of(const Box3& box) {
    // Halves, whose difference is a double.
    const auto side = [&](double Point3::*axis) { return box.high.*axis / 2 - box.low.*axis / 2; };
    const double longest = std::max({side(&Point3::x), side(&Point3::y), side(&Point3::z)});
    int exponent = 0;
    std::frexp(longest, &exponent);
    return exponent;
}

template <class S>
[[nodiscard]] ScaledSite scaled(const S& site, int exponent) noexcept {
    const Point3 centre = divided({site.x, site.y, site.z}, exponent);
    if constexpr (requires { site.r; }) {
        const double r = std::ldexp(site.r, -exponent);
        // What is below 2^-400 nobody sees beside the box.
        if (std::fabs(r) < 0x1p-400 || !(std::fabs(r) <= largest)) return {centre, r * r, 0.0};
        const auto [high, low] = two_product(r, r);
        return {centre, high, low};
    } else if constexpr (requires { site.w; }) {
        return {centre, std::ldexp(site.w, -2 * exponent), 0.0};
    } else {
        return {centre, 0.0, 0.0};
    }
}

struct ExactSite {
    std::array<Rational, 3> x;
    Rational weight;
};
template <class S>
[[nodiscard]] ExactSite exact_site(const S& site) {
    using exact::to_rational;
    ExactSite result = {{to_rational(site.x), to_rational(site.y), to_rational(site.z)}, 0};
    if constexpr (requires { site.r; }) result.weight = to_rational(site.r) * to_rational(site.r);
    if constexpr (requires { site.w; }) result.weight = to_rational(site.w);
    return result;
}

}  // namespace

ScaledSites::ScaledSites(const AnySites3& sites, const Box3& box) : given_(sites), box_(box) {
    if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z))
        throw std::invalid_argument("a box needs low < high along all axes");
    if (!are_finite(box.low, box.high))
        throw std::invalid_argument("the corners of a box are to be finite");
    exponent_ = exponent_of(box);
    box_ = {divided(box.low, exponent_), divided(box.high, exponent_)};
    if (!is_usual(box_.low) || !is_usual(box_.high))
        throw std::invalid_argument("the box is too small beside its coordinates");
    std::visit(
        [&](const auto& all) {
            scaled_.reserve(all.size());
            for (const auto& site : all) {
                scaled_.push_back(scaled(site, exponent_));
                const ScaledSite& made = scaled_.back();
                if (!is_usual(made.centre) || !(std::fabs(made.weight) <= largest * largest))
                    throw std::invalid_argument("site " + std::to_string(scaled_.size() - 1) +
                                                " is not finite, or too large beside the box");
            }
        },
        sites);
}

Bisector ScaledSites::bisector(Index i, Index j) const noexcept {
    Point3 normal = offset(i, j);
    double norm = length(normal);
    if (norm < 0x1p-200) [[unlikely]] {
        // The squares may be none.
        normal = divided(normal, -900);
        norm = length(normal);
        normal = plus({}, normal, 1.0 / norm);
        norm = std::ldexp(norm, -900);
    } else {
        normal = plus({}, normal, 1.0 / norm);
    }
    const double difference = weight_difference(i, j) / norm;
    return {normal, (norm - difference) / 2, (norm + difference) / 2};
}

Point3 ScaledSites::exact_vertex(const SpaceCell& cell) const {
    std::array<ExactSite, 4> sites;
    for (std::size_t k = 0; k < 4; ++k)
        sites[k] = std::visit(
            [&](const auto& all) { return exact_site(all[static_cast<std::size_t>(cell[k])]); },
            given_);
    // Rows m.v = h: Cramer's rule.
    std::array<std::array<Rational, 3>, 3> m;
    std::array<Rational, 3> h;
    for (std::size_t k = 0; k < 3; ++k) {
        h[k] = sites[0].weight - sites[k + 1].weight;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            m[k][axis] = sites[k + 1].x[axis] - sites[0].x[axis];
            h[k] += m[k][axis] * m[k][axis];
        }
        h[k] /= 2;
    }
    std::array<Rational, 3> v = {0, 0, 0};
    Rational determinant = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto& a = m[(k + 1) % 3];
        const auto& b = m[(k + 2) % 3];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t y = (axis + 1) % 3;
            const std::size_t z = (axis + 2) % 3;
            const Rational minor = a[y] * b[z] - a[z] * b[y];
            v[axis] += h[k] * minor;
            if (k == 0) determinant += m[0][axis] * minor;
        }
    }
    const auto rounded = [&](Rational number) {
        constexpr double most = 0x1p1000;
        number /= determinant;
        const mpq_ptr numeral = number.backend().data();
        if (exponent_ > 0)
            mpq_div_2exp(numeral, numeral, static_cast<mp_bitcnt_t>(exponent_));
        else
            mpq_mul_2exp(numeral, numeral, static_cast<mp_bitcnt_t>(-exponent_));
        const double nearest = exact::round_to_double(number);
        if (std::isnan(nearest)) return number.sign() < 0 ? -most : most;
        return std::clamp(nearest, -most, most);
    };
    return {rounded(v[0]), rounded(v[1]), rounded(v[2])};
}

}  // namespace signum
