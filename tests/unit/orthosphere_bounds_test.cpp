/// What rounded spheres of cells tell, and which are made at all: beside the lemma and the counted
/// roundings of triangulation/space/orthospheres.hpp.

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "../../triangulation/space/orthospheres.hpp"

#include "threshold.hpp"

namespace signum::spatial {
namespace {

using filters::epsilon;
using threshold::expect_first_certain;

/// A sphere about the origin, and a site at a distance from it along x, whose power is so much
/// above that of the sphere.
struct Asked {
    float power;
    double distance;
    double weight;
    float largest_weight;
};
Told told(const Asked& asked) {
    const auto sphere = std::bit_cast<Orthosphere>(std::array{0.0F, 0.0F, 0.0F, asked.power});
    const SphereTest test({asked.distance, 0, 0, asked.weight}, Frame{{}, 1, asked.largest_weight});
    std::array<Told, 4> result;
    test(sphere, unknown_sphere, unknown_sphere, unknown_sphere, result);
    return result[0];
}

/// 2^-9 of the square, of the power and of the largest weight.
TEST(OrthosphereBounds, OfWhatIsTold) {
    const auto expect_told = [](const char* what, double bound, const auto& asked) {
        for (const int side : {1, -1})
            expect_first_certain(what, 0.99 * bound, 1.01 * bound, [&](std::int64_t steps) {
                return told(asked(side * static_cast<double>(steps) * 0x1p-19)) ==
                       (side > 0 ? Told::none : Told::conflict);
            });
    };
    const double unit = 0x1p-9 * 0x1p19;
    expect_told("square and power", 2 * unit, [](double above) {
        return Asked{static_cast<float>(1.0 - above), 1.0, 0.0, 0.0F};
    });
    expect_told("weight", unit, [](double above) {
        return Asked{static_cast<float>(-above), 0.0, 0.0, 1.0F};
    });
    expect_told("square and weight", 2 * unit, [](double above) {
        return Asked{0.0F, 1.0, 1.0 - above, 1.0F};
    });
    expect_told("power and weight", 2 * unit, [](double above) {
        return Asked{static_cast<float>(-1.0 - above), 0.0, 1.0, 1.0F};
    });
}

/// A cell of a site in the origin and three vertices, of the volume `flat`, in the order in which
/// it is made.
bool is_made(double flat, double lift_of_first, double lift_of_last) {
    const std::array<ViewRow, 3> rows = {
        {{{1, 0, 0}, lift_of_first}, {{0, 1, 0}, 0.0}, {{0, 0, flat}, lift_of_last}}};
    const SphereMaker maker(rows.data(), {0, 0, 0, 0}, Frame{{}, 1}, 1.0, 1.0);
    const std::array<Facet, 1> facets = {Facet{.vertex = {0, 1, 2}}};
    constexpr std::array<Index, 1> cells = {0};
    std::array<Orthosphere, 1> spheres;
    maker.make(facets, cells.data(), spheres.data());
    return spheres[0] != unknown_sphere &&
           !std::isnan(std::bit_cast<std::array<float, 4>>(spheres[0])[3]);
}

/// The volume is told to 2^-14 of it, six products of 8 roundings and an epsilon or two more; and
/// what is divided by it, of 14, where the centre is not far.
TEST(OrthosphereBounds, OfWhatIsMade) {
    const double unit = 0x1p14 * epsilon;
    // The centre is as far as the volume is small: (0, 0, 1/2 flat).
    expect_first_certain("determinant", 2 * 6 * 8, 2.2 * 6 * 10, [&](std::int64_t steps) {
        return is_made(static_cast<double>(steps) * unit, 0.0, 1.0);
    });
    // It is (1/2, 0, 0).
    expect_first_certain(
        "numerator", 2 * 6 * 14 + 2 * 6 * 8, 2 * 6 * 16 + 2.2 * 6 * 10,
        [&](std::int64_t steps) { return is_made(static_cast<double>(steps) * unit, 1.0, 0.0); });
}

}  // namespace
}  // namespace signum::spatial
