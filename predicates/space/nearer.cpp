#include "nearer.hpp"

#include "../../exact/floating_environment.hpp"
#include "../../filters/wide.hpp"
#include "multiprecision.hpp"

namespace signum::power {
namespace {

/// Long doubles hold squares of all doubles, and their bound tells nearly all.
template <PowerSite3 S>
[[nodiscard]] Decision decide(const Point3& p, const S& a, const S& b) noexcept {
    const filters::Verdict verdict = nearer_difference<filters::Wide>(p, a, b).sign();
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return {multiprecision::nearer(p, a, b), Stage::multiprecision};
}

}  // namespace

Decision nearer_cold(const Point3& p, const Point3& a, const Point3& b) noexcept {
    return exact::in_ieee_environment(decide<Point3>, p, a, b);
}
Decision nearer_cold(const Point3& p, const Site3& a, const Site3& b) noexcept {
    return exact::in_ieee_environment(decide<Site3>, p, a, b);
}
Decision nearer_cold(const Point3& p, const signum::Site3& a, const signum::Site3& b) noexcept {
    return exact::in_ieee_environment(decide<signum::Site3>, p, a, b);
}

}  // namespace signum::power
