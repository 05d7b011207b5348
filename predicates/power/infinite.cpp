#include "infinite.hpp"

#include "../../exact/floating_environment.hpp"
#include "compared.hpp"
#include "exact_rows.hpp"
#include "multiprecision.hpp"

namespace signum::power {
namespace {

using filters::magnitude;

template <PowerSite S>
[[nodiscard]] filters::Verdict filter(const Row<double>& a, const Row<double>& b, double t_a,
                                      double t_b) noexcept {
    const auto [determinant, bound] = compared_in_segment(a, b, t_a, t_b);
    if (magnitude(determinant) > bound)
        return filters::Verdict::certain(filters::sign_of_nonzero(determinant));
    return filters::Verdict::uncertain();
}

template <PowerSite S>
[[nodiscard]] Sign expand(const S& a, const S& b, const S& q) noexcept {
    const bool along_x = a.x != b.x;
    const Sign direction = (along_x ? a.x < b.x : a.y < b.y) ? 1 : -1;
    const cold::ExpansionRow<S> row_a(a, q);
    const cold::ExpansionRow<S> row_b(b, q);
    const auto& t_a = along_x ? row_a.x : row_a.y;
    const auto& t_b = along_x ? row_b.x : row_b.y;
    return direction * (row_a.height * t_b - row_b.height * t_a).sign();
}

template <PowerSite S>
[[nodiscard]] Decision decide(const S& a, const S& b, const S& q) noexcept {
    if (!cold::in_window(a, b, q))
        return {multiprecision::in_segment(a, b, q), Stage::multiprecision};
    const bool along_x = a.x != b.x;
    const Sign direction = (along_x ? a.x < b.x : a.y < b.y) ? 1 : -1;
    const Row<double> row_a = row(a, q);
    const Row<double> row_b = row(b, q);
    const filters::Verdict verdict =
        filter<S>(row_a, row_b, along_x ? row_a.x : row_a.y, along_x ? row_b.x : row_b.y);
    if (verdict.is_certain()) return {direction * verdict.sign(), Stage::filter};
    return {expand(a, b, q), Stage::exact};
}

}  // namespace

Decision in_segment_decision(const Point& a, const Point& b, const Point& q) noexcept {
    return exact::in_ieee_environment(decide<Point>, a, b, q);
}
Decision in_segment_decision(const Site& a, const Site& b, const Site& q) noexcept {
    return exact::in_ieee_environment(decide<Site>, a, b, q);
}
Decision in_segment_decision(const signum::Site& a, const signum::Site& b,
                             const signum::Site& q) noexcept {
    return exact::in_ieee_environment(decide<signum::Site>, a, b, q);
}

}  // namespace signum::power
