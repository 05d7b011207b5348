#pragma once
/// Which cells of a part of space sites beyond a cut may reach (triangulation/parts/reach.hpp, the
/// power metric).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "../../core/index.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "../parts/orthoball.hpp"
#include "cells.hpp"
#include "cramer.hpp"
#include "orthospheres.hpp"

namespace signum::spatial {

using Box = triangulation::Box<3>;
using Ball = triangulation::Orthoball<3>;
using triangulation::weight_of;

/// The box around one site.
template <power::PowerSite3 S>
[[nodiscard]] inline Box box_of(const S& site) noexcept {
    return {{site.x, site.y, site.z}, {site.x, site.y, site.z}, weight_of(site)};
}

/// The orthosphere of a cell without the vertex at infinity. By Cramer's rule, as those in floats,
/// and with their bounds (orthospheres.hpp): a coordinate is off by
///     (numerator_error + 2 |x| determinant_error) / (2 |determinant|)
/// at most, but for a factor of 2 where the determinant is at least twice its own error. Within the
/// window no underflow matters: of six products, each of which loses 2^-1074, the bound is above
/// 2^-700.
template <power::PowerSite3 S>
[[nodiscard]] inline Ball ball_of(std::span<const S> sites, const Four& cell) noexcept {
    using filters::magnitude;
    const auto at = [&](std::size_t k) -> const S& {
        return sites[static_cast<std::size_t>(cell[k])];
    };
    const S& origin = at(0);
    double length = 0.0;
    double height = 0.0;
    const auto plane = [&](const S& site) -> Plane<double> {
        const power::LiftedRow<double> row = power::lifted_row(site, origin);
        const auto& [x, y, z] = row.offset;
        length = std::max({length, magnitude(x), magnitude(y), magnitude(z)});
        height = std::max(height, (x * x + y * y + z * z) + magnitude(row.weight));
        return {x, y, z, row.height()};
    };
    const Plane<double> b = plane(at(1));
    const Plane<double> c = plane(at(2));
    const Plane<double> d = plane(at(3));
    Meeting<double> meeting;
    meet(meeting, b, c, d);
    const double half = 0.5 / meeting.determinant;
    const std::array<double, 3> offset = {meeting.x * half, meeting.y * half, meeting.z * half};
    const double farthest =
        std::max({magnitude(offset[0]), magnitude(offset[1]), magnitude(offset[2])});
    const double square = length * length;
    const double determinant = magnitude(meeting.determinant);
    const double determinant_error = orthospheres::determinant_error * length * square;
    double error =
        (orthospheres::numerator_error * height * square + 2.0 * farthest * determinant_error) /
            determinant +
        0x1p-50 * farthest;
    if (!(length > 0x1p-150 && length < 0x1p150 && height < 0x1p300 &&
          determinant > 2.0 * determinant_error)) [[unlikely]]
        error = HUGE_VAL;
    return Ball::from({origin.x, origin.y, origin.z}, weight_of(origin), offset, error);
}

/// Where a box lies, as the facet of a cell with the vertex at infinity, its first, sees it: +1
/// where a part of it is beyond the facet's plane, 0 where it only touches that. Exact.
template <power::PowerSite3 S>
[[nodiscard]] inline Sign side_of(std::span<const S> sites, const Four& cell,
                                  const Box& box) noexcept {
    const auto at = [&](std::size_t k) {
        return centre3(sites[static_cast<std::size_t>(cell[k])]);
    };
    Sign farthest = -1;
    for (const double x : {box.low[0], box.high[0]})
        for (const double y : {box.low[1], box.high[1]})
            for (const double z : {box.low[2], box.high[2]}) {
                farthest = std::max(farthest, ccw(Point3{x, y, z}, at(1), at(2), at(3)));
                if (farthest > 0) return farthest;
            }
    return farthest;
}

}  // namespace signum::spatial
