#include "orthospheres.hpp"

#include <algorithm>
#include <cmath>

#include "../core/processor.hpp"
#include "../filters/four.hpp"
#include "../filters/rounding_count.hpp"

namespace signum::spatial {
namespace {

using filters::Four;

/// A row of which the height is known.
template <class Number>
struct Row {
    Number x;
    Number y;
    Number z;
    Number lift;
};

/// det(b, c, d), and what twice that times the centre comes to, relative to the site: the solution
/// of 2 m·p = lift_m for the three by Cramer's rule. For any type of number.
template <class Number>
struct Solution {
    Number determinant;
    Number x;
    Number y;
    Number z;
};
template <class Number>
[[gnu::always_inline]] constexpr void solve(Solution<Number>& solution, const Row<Number>& b,
                                            const Row<Number>& c, const Row<Number>& d) {
    const Number cd_x = c.y * d.z - c.z * d.y;
    const Number cd_y = c.z * d.x - c.x * d.z;
    const Number cd_z = c.x * d.y - c.y * d.x;
    const Number db_x = d.y * b.z - d.z * b.y;
    const Number db_y = d.z * b.x - d.x * b.z;
    const Number db_z = d.x * b.y - d.y * b.x;
    const Number bc_x = b.y * c.z - b.z * c.y;
    const Number bc_y = b.z * c.x - b.x * c.z;
    const Number bc_z = b.x * c.y - b.y * c.x;
    solution.determinant = b.x * cd_x + b.y * cd_y + b.z * cd_z;
    solution.x = b.lift * cd_x + c.lift * db_x + d.lift * bc_x;
    solution.y = b.lift * cd_y + c.lift * db_y + d.lift * bc_y;
    solution.z = b.lift * cd_z + c.lift * db_z + d.lift * bc_z;
}

/// Of what these may come to, six products: with the largest offset L and height H 6 L³ and 6 H L².
/// One more e than there are roundings pays for the terms in e², another one for those of the
/// errors themselves.
constexpr double determinant_error = 6 * 10 * filters::epsilon;
constexpr double numerator_error = 6 * 16 * filters::epsilon;
constexpr Solution<filters::RoundingCount> counted = [] {
    const auto row = power::lifted_row<filters::RoundingCount>(signum::Site3{}, signum::Site3{});
    const Row<filters::RoundingCount> rounded = {row.offset.x, row.offset.y, row.offset.z,
                                                 row.height()};
    Solution<filters::RoundingCount> solution{};
    solve(solution, rounded, rounded, rounded);
    return solution;
}();
static_assert(counted.determinant.roundings <= 8);
static_assert(counted.x.roundings <= 14 && counted.y.roundings <= 14 && counted.z.roundings <= 14);

[[gnu::always_inline]] inline void gather(Row<Four>& row, const ViewRow* rows,
                                          const std::array<const std::array<Seen, 3>*, 4>& facets,
                                          std::size_t vertex) noexcept {
    const ViewRow& a = rows[(*facets[0])[vertex]];
    const ViewRow& b = rows[(*facets[1])[vertex]];
    const ViewRow& c = rows[(*facets[2])[vertex]];
    const ViewRow& d = rows[(*facets[3])[vertex]];
    row.x = Four{a.offset.x, b.offset.x, c.offset.x, d.offset.x};
    row.y = Four{a.offset.y, b.offset.y, c.offset.y, d.offset.y};
    row.z = Four{a.offset.z, b.offset.z, c.offset.z, d.offset.z};
    row.lift = Four{a.lift, b.lift, c.lift, d.lift};
}

[[gnu::always_inline]] inline void largest(Four& result, const Four& x, const Four& y,
                                           const Four& z) noexcept {
    Four a;
    Four b;
    filters::magnitude(result, x);
    filters::magnitude(a, y);
    filters::magnitude(b, z);
    result = result > a ? result : a;
    result = result > b ? result : b;
}
[[gnu::always_inline]] inline void through_floats(Four& result, const Four& numbers) noexcept {
    using Floats = float __attribute__((vector_size(16)));
    result = __builtin_convertvector(__builtin_convertvector(numbers, Floats), Four);
}

}  // namespace

template <power::PowerSite3 S>
Frame frame_of(std::span<const S> sites) noexcept {
    Point3 low = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    Point3 high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const S& s : sites)
        for (double Point3::*const axis : {&Point3::x, &Point3::y, &Point3::z}) {
            low.*axis = std::min(low.*axis, centre3(s).*axis);
            high.*axis = std::max(high.*axis, centre3(s).*axis);
        }
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    // Within the window all that is computed of sites in the frame is far from the ends of doubles,
    // and subtracting the origin errs by less than 2^-50 of the extent.
    const double farthest = std::max({std::fabs(low.x), std::fabs(low.y), std::fabs(low.z),
                                      std::fabs(high.x), std::fabs(high.y), std::fabs(high.z)});
    if (!(extent >= 0x1p-150 && farthest <= 0x1p150)) return {};
    Frame frame;
    frame.origin = {0.5 * (low.x + high.x), 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)};
    frame.scale = std::ldexp(1.0, -std::ilogb(extent) - 1);
    for (const S& s : sites)
        frame.largest_weight =
            std::max(frame.largest_weight, static_cast<float>(std::fabs(in_frame(s, frame)[3])));
    return frame;
}
template Frame frame_of(std::span<const Point3>) noexcept;
template Frame frame_of(std::span<const Site3>) noexcept;
template Frame frame_of(std::span<const power::Site3>) noexcept;

SphereMaker::SphereMaker(const ViewRow* rows, const std::array<double, 4>& site, const Frame& frame,
                         double largest, double height) noexcept
    : rows_(rows),
      site_(site),
      scale_(frame.scale),
      numerator_error_(numerator_error * height * largest * largest),
      determinant_error_(determinant_error * largest * largest * largest) {}

void SphereMaker::make(const std::array<const std::array<Seen, 3>*, 4>& facets,
                       std::array<Orthosphere, 4>& spheres) const noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        Row<Four> b;
        Row<Four> c;
        Row<Four> d;
        gather(b, rows_, facets, 0);
        gather(c, rows_, facets, 1);
        gather(d, rows_, facets, 2);
        Solution<Four> solution;
        solve(solution, b, c, d);
        const Four twice = solution.determinant + solution.determinant;
        const Four x = solution.x / twice;
        const Four y = solution.y / twice;
        const Four z = solution.z / twice;
        // The centre is farther from the site than this, but not twice as far.
        Four near;
        largest(near, x, y, z);
        const Four reach = near * scale_;
        const Four cx = site_[0] + x * scale_;
        const Four cy = site_[1] + y * scale_;
        const Four cz = site_[2] + z * scale_;
        Four far;
        largest(far, cx, cy, cz);
        Four volume;
        filters::magnitude(volume, solution.determinant);
        // The solution's error is below 2^-13 of the distance, and that of rounding it too.
        const filters::Flags is_good =
            ((numerator_error_ + 2.1 * near * determinant_error_) * 0x1p14 <= near * volume) &
            (far <= 0x1p9 * reach) & (reach >= 0x1.01p-11) & (reach <= 0x1p40);
        Four from_x;
        Four from_y;
        Four from_z;
        through_floats(from_x, cx);
        through_floats(from_y, cy);
        through_floats(from_z, cz);
        const Four dx = from_x - site_[0];
        const Four dy = from_y - site_[1];
        const Four dz = from_z - site_[2];
        const Four power = (dx * dx + dy * dy + dz * dz) - site_[3];
        for (std::size_t k = 0; k < 4; ++k)
            spheres[k] = {static_cast<float>(from_x[k]), static_cast<float>(from_y[k]),
                          static_cast<float>(from_z[k]),
                          is_good[k] != 0 ? static_cast<float>(power[k]) : unknown_sphere.power};
    });
}

}  // namespace signum::spatial
