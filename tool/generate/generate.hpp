#pragma once
/// Sites for tests, benchmarks and demonstrations: the four distributions of the thesis, and
/// families that stay hard at any size.
///
/// Laws:
///  1. The same options give the same doubles on every platform and with every standard library.
///  2. Centres, radii and perturbations of one seed do not depend on one another: other radii leave
///     the centres as they are.
/// The square is [0, 700]²; everything random comes from std::mt19937_64 and is mapped to doubles
/// here.
///
/// The more sites there are on one circle in doubles, the nearer they lie, and the more of what is
/// asked about them is decided by their rounding, that is by chance. So the hard families are many
/// patterns of the same size side by side, and exact where they say so.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "../../core/site.hpp"

namespace signum {

enum class Distribution : std::uint8_t {
    random,   ///< uniform in the square
    circle,   ///< uniform on the circle of radius 350 in the square
    square,   ///< uniform on the boundary of the square
    grid,     ///< square cells filling the square, whose circles and lines are exact ties
    lattice,  ///< integer points on circles, 192 on each: exactly cocircular
    rings,    ///< a thousand sites on each of many circles, cocircular but for rounding
    offset,   ///< a fine grid far from the origin: differences are doubles, sums are not
    tangent   ///< discs that touch a circle from outside, 192 on each: exactly tangent
};

inline constexpr std::array<Distribution, 8> all_distributions = {
    Distribution::random,  Distribution::circle, Distribution::square, Distribution::grid,
    Distribution::lattice, Distribution::rings,  Distribution::offset, Distribution::tangent};

[[nodiscard]] std::string_view name_of(Distribution distribution) noexcept;

/// In space, in the cube [0, 700]³.
enum class SpaceDistribution : std::uint8_t {
    random,  ///< uniform in the cube
    sphere,  ///< uniform on the sphere of radius 350 in the cube
    cube,    ///< uniform on the boundary of the cube
    grid     ///< cubes filling the cube, whose spheres and planes are exact ties
};

inline constexpr std::array<SpaceDistribution, 4> all_space_distributions = {
    SpaceDistribution::random, SpaceDistribution::sphere, SpaceDistribution::cube,
    SpaceDistribution::grid};

[[nodiscard]] std::string_view name_of(SpaceDistribution distribution) noexcept;

struct GenerateOptions {
    std::int64_t count = 0;  ///< sites, from 0 to max_sites
    double radius_from = 0.0;
    double radius_to =
        0.0;               ///< radii are uniform in [radius_from, radius_to]; tangent adds its own
    double perturb = 0.0;  ///< a uniform number from [0, perturb] is added to each coordinate
    std::uint64_t seed = 1;
};

/// Throws std::invalid_argument for options out of their range. O(count).
[[nodiscard]] std::vector<Site> generate(Distribution distribution, const GenerateOptions& options);
[[nodiscard]] std::vector<Site3> generate(SpaceDistribution distribution,
                                          const GenerateOptions& options);

/// Patterns of sixteen sites made to be wrong about (hard.hpp): lattices, tangent, nested and
/// collinear ones of each metric, with copies and mirror images, exact or moved by a few ulps. Each
/// lies where and is as large as its integers and its power of two have it, so that they overlap at
/// all scales. The options' radii and perturbations are added to their own.
[[nodiscard]] std::vector<Site> generate_hard(const GenerateOptions& options);
[[nodiscard]] std::vector<Site3> generate_hard_in_space(const GenerateOptions& options);

}  // namespace signum
