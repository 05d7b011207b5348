#pragma once
/// Curves and their pieces, for who computes in IEEE 754's environment already: functions of
/// conic.hpp and curve.hpp without the look at the environment, which takes as long as they do. For
/// sources only.

#include <optional>
#include <vector>

#include "conic.hpp"
#include "curve.hpp"

namespace signum::in_ieee {

[[nodiscard]] inline Conic straight(Point from, Point to) noexcept {
    return {from, {from.x + (to.x - from.x) / 2, from.y + (to.y - from.y) / 2}, to, 1.0};
}
[[nodiscard]] Conic part(const Conic& conic, double first, double last) noexcept;
[[nodiscard]] Conic::Moments moments(const Conic& conic, Point origin) noexcept;
[[nodiscard]] double length(const Conic& conic);
[[nodiscard]] std::vector<Inside> parts_inside(const Conic& conic, const Box& box);

[[nodiscard]] Point at(const StraightCurve& curve, double t) noexcept;
[[nodiscard]] Point at(const HyperbolaCurve& curve, double t) noexcept;
[[nodiscard]] double parameter(const StraightCurve& curve, Point p) noexcept;
[[nodiscard]] double parameter(const HyperbolaCurve& curve, Point p) noexcept;
[[nodiscard]] double beyond(const StraightCurve& curve, double reach) noexcept;
[[nodiscard]] double beyond(const HyperbolaCurve& curve, double reach) noexcept;

[[nodiscard]] std::optional<Curve> bisector(Metric metric, WeightIs weight_is,
                                            const NumberedSite& a, const NumberedSite& b,
                                            int exponent, Point focus);
[[nodiscard]] std::vector<Conic> stretch(const Curve& curve, double from, Point start, double to,
                                         Point end);

}  // namespace signum::in_ieee
