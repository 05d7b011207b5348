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
using triangulation::weight_of;

/// The box around one site.
template <power::PowerSite3 S>
[[nodiscard]] inline Box box_of(const S& site) noexcept {
    return {{site.x, site.y, site.z}, {site.x, site.y, site.z}, weight_of(site)};
}

/// The orthosphere of a cell without the vertex at infinity, as a form that is positive outside it:
/// with x the place of a site from the first site o of the cell,
///     D (|x|² - w + w_o) - N·x
/// where N / 2D is the centre by Cramer's rule (cramer.hpp). Nothing is divided, so that nearly
/// flat cells, of which there are many at the border of all sites, are told as well as others.
class InSphereForm {
 public:
    template <power::PowerSite3 S>
    InSphereForm(std::span<const S> sites, const Four& cell) noexcept {
        using filters::magnitude;
        const S& origin = sites[static_cast<std::size_t>(cell[0])];
        place_ = {origin.x, origin.y, origin.z};
        weight_ = weight_of(origin);
        double length = 0.0;
        double height = 0.0;
        const auto plane = [&](std::size_t k) -> Plane<double> {
            const power::LiftedRow<double> row =
                power::lifted_row(sites[static_cast<std::size_t>(cell[k])], origin);
            const auto& [x, y, z] = row.offset;
            length = std::max({length, magnitude(x), magnitude(y), magnitude(z)});
            height = std::max(height, (x * x + y * y + z * z) + magnitude(row.weight));
            return {x, y, z, row.height()};
        };
        const Plane<double> b = plane(1);
        const Plane<double> c = plane(2);
        const Plane<double> d = plane(3);
        Meeting<double> meeting;
        meet(meeting, b, c, d);
        // Of a cell that turns positively, it is positive, if not as rounded.
        determinant_ = std::max(meeting.determinant, 0.0);
        numerator_ = {meeting.x, meeting.y, meeting.z};
        // The bounds of orthospheres.hpp. Within the window no underflow matters: of six products,
        // each of which loses 2^-1074, the bound is above 2^-700.
        const double square = length * length;
        determinant_error_ = orthospheres::determinant_error * length * square;
        numerator_error_ = orthospheres::numerator_error * height * square;
        is_in_window_ = length > 0x1p-150 && length < 0x1p150 && height < 0x1p300;
    }

    /// A lower bound of the form over the sites in a finite box, above 0 where none conflicts.
    /// Along each axis the form is a parabola, which is bounded by its value where that is least,
    /// to within the square of how far that place is rounded. Terms are summed within 2^-48 of
    /// their magnitudes.
    [[nodiscard]] double excess(const Box& box) const noexcept {
        using std::fabs;
        if (!is_in_window_) [[unlikely]]
            return -HUGE_VAL;
        const double weights = fabs(weight_) + fabs(box.greatest);
        double value = determinant_ * (weight_ - box.greatest);
        double magnitude = determinant_ * weights;
        double squares = weights;
        double lengths = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double rounded =
                0x1p-52 * (fabs(box.low[k]) + fabs(box.high[k]) + fabs(place_[k]));
            const double low = (box.low[k] - place_[k]) - rounded;
            const double high = (box.high[k] - place_[k]) + rounded;
            const double middle = 0.5 * numerator_[k] / determinant_;
            const double x = middle > low ? std::min(middle, high) : low;
            const double square = determinant_ * x * x;
            const double product = numerator_[k] * x;
            value += square - product;
            magnitude += square + fabs(product);
            const double farthest = std::max(fabs(low), fabs(high));
            squares += farthest * farthest;
            lengths += farthest;
        }
        // Near the origin products underflow.
        const double underflow = 0x1p-1000 * (1.0 + determinant_);
        return value - (determinant_error_ * squares + numerator_error_ * lengths +
                        0x1p-48 * magnitude + underflow);
    }
    /// Whether a site in a finite box may conflict with the cell.
    [[nodiscard]] bool may_be_reached_from(const Box& box) const noexcept {
        return !(excess(box) > 0.0);
    }

 private:
    std::array<double, 3> place_;
    double weight_;
    double determinant_;
    double determinant_error_;
    std::array<double, 3> numerator_;
    double numerator_error_;
    bool is_in_window_;
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
