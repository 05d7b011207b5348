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

/// The planes in which the sites of a cell have the powers of its first site, without the vertex at
/// infinity, and where they meet, times the determinant, which turns positively as the cell does. By
/// Cramer's rule, as the spheres in floats, and with their bounds (orthospheres.hpp).
struct CellPlanes {
    Meeting<double> meeting;
    double length;             ///< the largest coordinate of an offset from the first site
    double height;             ///< the largest height
    double determinant_error;  ///< of the determinant
    double numerator_error;    ///< of each coordinate of the meeting

    template <power::PowerSite3 S>
    CellPlanes(std::span<const S> sites, const Four& cell) noexcept : length(0.0), height(0.0) {
        using filters::magnitude;
        const auto plane = [&](std::size_t k) -> Plane<double> {
            const power::LiftedRow<double> row =
                power::lifted_row(sites[static_cast<std::size_t>(cell[k])],
                                  sites[static_cast<std::size_t>(cell[0])]);
            const auto& [x, y, z] = row.offset;
            length = std::max({length, magnitude(x), magnitude(y), magnitude(z)});
            height = std::max(height, (x * x + y * y + z * z) + magnitude(row.weight));
            return {x, y, z, row.height()};
        };
        const Plane<double> b = plane(1);
        const Plane<double> c = plane(2);
        const Plane<double> d = plane(3);
        meet(meeting, b, c, d);
        const double square = length * length;
        determinant_error = orthospheres::determinant_error * length * square;
        numerator_error = orthospheres::numerator_error * height * square;
    }
    /// Whether no underflow matters: of six products, each of which loses 2^-1074, the bound is
    /// above 2^-700.
    [[nodiscard]] bool are_in_window() const noexcept {
        return length > 0x1p-150 && length < 0x1p150 && height < 0x1p300;
    }
};

/// The orthosphere of a cell without the vertex at infinity. A coordinate is off by
///     (numerator_error + 2 |x| determinant_error) / (2 |determinant|)
/// at most, but for a factor of 2 where the determinant is at least twice its own error.
template <power::PowerSite3 S>
[[nodiscard]] inline Ball ball_of(std::span<const S> sites, const Four& cell) noexcept {
    using filters::magnitude;
    const CellPlanes planes(sites, cell);
    const Meeting<double>& meeting = planes.meeting;
    const double half = 0.5 / meeting.determinant;
    const std::array<double, 3> offset = {meeting.x * half, meeting.y * half, meeting.z * half};
    const double farthest =
        std::max({magnitude(offset[0]), magnitude(offset[1]), magnitude(offset[2])});
    const double determinant = magnitude(meeting.determinant);
    double error =
        (planes.numerator_error + 2.0 * farthest * planes.determinant_error) / determinant +
        0x1p-50 * farthest;
    if (!(planes.are_in_window() && determinant > 2.0 * planes.determinant_error)) [[unlikely]]
        error = HUGE_VAL;
    const S& origin = sites[static_cast<std::size_t>(cell[0])];
    return Ball::from({origin.x, origin.y, origin.z}, weight_of(origin), offset, error);
}

/// The same sphere where it is large, for cells that are nearly flat have balls of which doubles
/// do not know the centres, and the cells at the border of all sites are many: not the sphere, but
/// what is positive outside it, with x the place of a site from the first site o of the cell, D the
/// determinant and N the meeting:
///     D (|x|² - w + w_o) - N·x
class InSphereForm {
 public:
    template <power::PowerSite3 S>
    InSphereForm(std::span<const S> sites, const Four& cell) noexcept
        : planes_(sites, cell), place_{}, weight_(0.0) {
        const S& origin = sites[static_cast<std::size_t>(cell[0])];
        place_ = {origin.x, origin.y, origin.z};
        weight_ = weight_of(origin);
        // It is positive, if not as rounded.
        determinant_ = std::max(planes_.meeting.determinant, 0.0);
    }
    /// A lower bound of the form over the sites in a finite box, no matter in what unit: above 0
    /// where none conflicts. Along each axis it is a parabola; by where that is least nothing
    /// rounded is told. Terms are summed within 2^-48 of their magnitudes.
    [[nodiscard]] double excess(const Box& box) const noexcept {
        using std::fabs;
        if (!planes_.are_in_window()) [[unlikely]]
            return -HUGE_VAL;
        const std::array<double, 3> n = {planes_.meeting.x, planes_.meeting.y, planes_.meeting.z};
        const double weights = fabs(weight_) + fabs(box.greatest);
        double value = determinant_ * (weight_ - box.greatest);
        double magnitude = determinant_ * weights;
        double squares = weights;
        double lengths = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double rounded = 0x1p-52 * (fabs(box.low[k]) + fabs(box.high[k]) + fabs(place_[k]));
            const double low = (box.low[k] - place_[k]) - rounded;
            const double high = (box.high[k] - place_[k]) + rounded;
            const double middle = 0.5 * n[k] / determinant_;
            const double x = middle > low ? std::min(middle, high) : low;
            const double square = determinant_ * x * x;
            const double product = n[k] * x;
            value += square - product;
            magnitude += square + fabs(product);
            const double farthest = std::max(fabs(low), fabs(high));
            squares += farthest * farthest;
            lengths += farthest;
        }
        return value - (planes_.determinant_error * squares + planes_.numerator_error * lengths +
                        0x1p-48 * magnitude);
    }

 private:
    CellPlanes planes_;
    std::array<double, 3> place_;
    double weight_;
    double determinant_;
};

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
