#include "orthospheres.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../../core/processor.hpp"
#include "../../filters/four.hpp"
#include "../../filters/rounding_count.hpp"
#include "cramer.hpp"

namespace signum::spatial {
namespace {

using Doubles = filters::Four;

/// The roundings of Cramer's rule, for which the bounds in the header pay.
constexpr Meeting<filters::RoundingCount> counted = [] {
    const auto row = power::lifted_row<filters::RoundingCount>(signum::Site3{}, signum::Site3{});
    const Plane<filters::RoundingCount> rounded = {row.offset.x, row.offset.y, row.offset.z,
                                                   row.height()};
    Meeting<filters::RoundingCount> meeting{};
    meet(meeting, rounded, rounded, rounded);
    return meeting;
}();
static_assert(counted.determinant.roundings <= 8);
static_assert(counted.x.roundings <= 14 && counted.y.roundings <= 14 && counted.z.roundings <= 14);

using Facets = std::array<const Facet*, 4>;

/// The rows of one vertex of each facet, column by column.
[[gnu::always_inline]] inline void gather(Plane<Doubles>& row, const ViewRow* rows,
                                          const Facets& facets, std::size_t vertex) noexcept {
    const auto load = [&](Doubles & numbers, std::size_t facet) __attribute__((always_inline)) {
        static_assert(sizeof(ViewRow) == sizeof(Doubles));
        std::memcpy(&numbers, &rows[facets[facet]->vertex[vertex]], sizeof numbers);
    };
    Doubles a;
    Doubles b;
    Doubles c;
    Doubles d;
    load(a, 0);
    load(b, 1);
    load(c, 2);
    load(d, 3);
    const Doubles ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Doubles ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Doubles cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Doubles cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    row.x = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    row.y = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    row.z = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    row.height = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

[[gnu::always_inline]] inline void largest(Doubles& result, const Doubles& x, const Doubles& y,
                                           const Doubles& z) noexcept {
    Doubles a;
    Doubles b;
    filters::magnitude(result, x);
    filters::magnitude(a, y);
    filters::magnitude(b, z);
    result = result > a ? result : a;
    result = result > b ? result : b;
}
using orthospheres::Floats;
[[gnu::always_inline]] inline void to_floats(Floats& result, const Doubles& numbers) noexcept {
    result = __builtin_convertvector(numbers, Floats);
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
      numerator_error_(orthospheres::numerator_error * height * largest * largest),
      determinant_error_(orthospheres::determinant_error * largest * largest * largest) {}

/// A site in the frame, and the errors of the numbers that it sees.
struct SphereMaker::Wide {
    const SphereMaker& of;

    [[gnu::always_inline]] void operator()(const Facets& facets,
                                           const std::array<Orthosphere*, 4>& spheres) const {
        const auto& [rows, site, scale, numerator_error, determinant_error] = of;
        Plane<Doubles> b;
        Plane<Doubles> c;
        Plane<Doubles> d;
        gather(b, rows, facets, 0);
        gather(c, rows, facets, 1);
        gather(d, rows, facets, 2);
        Meeting<Doubles> meeting;
        meet(meeting, b, c, d);
        const Doubles twice = meeting.determinant + meeting.determinant;
        const Doubles x = meeting.x / twice;
        const Doubles y = meeting.y / twice;
        const Doubles z = meeting.z / twice;
        // The centre is farther from the site than this, but not twice as far.
        Doubles near;
        largest(near, x, y, z);
        const Doubles reach = near * scale;
        const Doubles cx = site[0] + x * scale;
        const Doubles cy = site[1] + y * scale;
        const Doubles cz = site[2] + z * scale;
        Doubles far;
        largest(far, cx, cy, cz);
        Doubles volume;
        filters::magnitude(volume, meeting.determinant);
        // The solution's error is below 2^-13 of the distance, and that of rounding it too.
        const filters::Flags is_good =
            ((numerator_error + 2.1 * near * determinant_error) * 0x1p14 <= near * volume) &
            (far <= 0x1p9 * reach) & (reach >= 0x1.01p-11) & (reach <= 0x1p40);
        Floats float_x;
        Floats float_y;
        Floats float_z;
        to_floats(float_x, cx);
        to_floats(float_y, cy);
        to_floats(float_z, cz);
        const Doubles dx = __builtin_convertvector(float_x, Doubles) - site[0];
        const Doubles dy = __builtin_convertvector(float_y, Doubles) - site[1];
        const Doubles dz = __builtin_convertvector(float_z, Doubles) - site[2];
        Floats power;
        to_floats(power, (dx * dx + dy * dy + dz * dz) - site[3]);
        const auto is_known = __builtin_convertvector(is_good, orthospheres::Flags);
        power =
            (Floats)((is_known & (orthospheres::Flags)power) | (~is_known & orthospheres::unknown));
        const Floats xy_low = __builtin_shufflevector(float_x, float_y, 0, 4, 1, 5);
        const Floats xy_high = __builtin_shufflevector(float_x, float_y, 2, 6, 3, 7);
        const Floats zp_low = __builtin_shufflevector(float_z, power, 0, 4, 1, 5);
        const Floats zp_high = __builtin_shufflevector(float_z, power, 2, 6, 3, 7);
        const auto store = [&](std::size_t k, const Floats& sphere) __attribute__((always_inline)) {
            std::memcpy(spheres[k]->data(), &sphere, sizeof sphere);
        };
        store(0, __builtin_shufflevector(xy_low, zp_low, 0, 1, 4, 5));
        store(1, __builtin_shufflevector(xy_low, zp_low, 2, 3, 6, 7));
        store(2, __builtin_shufflevector(xy_high, zp_high, 0, 1, 4, 5));
        store(3, __builtin_shufflevector(xy_high, zp_high, 2, 3, 6, 7));
    }
};

void SphereMaker::make(std::span<const Facet> facets, const Index* cells,
                       Orthosphere* spheres) const noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        const Wide make_four{*this};
        for (std::size_t i = 0; i < facets.size(); i += 4) {
            // The last one several times where there are no more.
            const auto at = [&](std::size_t k) __attribute__((always_inline)) {
                return std::min(i + k, facets.size() - 1);
            };
            const auto sphere = [&](std::size_t k) __attribute__((always_inline)) {
                return &spheres[cells[at(k)]];
            };
            make_four({&facets[at(0)], &facets[at(1)], &facets[at(2)], &facets[at(3)]},
                      {sphere(0), sphere(1), sphere(2), sphere(3)});
        }
    });
}

}  // namespace signum::spatial
