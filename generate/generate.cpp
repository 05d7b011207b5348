#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <signum/core/index.hpp>
#include <signum/generate/generate.hpp>

namespace signum {
namespace {

constexpr double side = 700.0;

/// Uniform doubles from [0, 1), multiples of 2^-53: the upper bits of the generator.
class Uniform {
 public:
    explicit Uniform(std::uint64_t seed) : bits_(seed) {}
    double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
    std::mt19937_64 bits_;
};

Point random_point(Uniform& uniform) {
    const double x = side * uniform();
    return {x, side * uniform()};
}

/// Von Neumann: a uniform direction, its angle doubled. No sine, whose last bit differs from
/// library to library.
Point circle_point(Uniform& uniform) {
    for (;;) {
        const double u = 2.0 * uniform() - 1.0;
        const double v = 2.0 * uniform() - 1.0;
        const double norm = u * u + v * v;
        if (norm > 1.0 || norm < 0x1p-40) continue;
        const double radius = side / 2.0;
        return {radius + radius * ((u * u - v * v) / norm), radius + radius * (2.0 * u * v / norm)};
    }
}

Point square_point(Uniform& uniform) {
    const double place = 4.0 * uniform();
    const double edge = std::floor(place);
    const double along = side * (place - edge);
    if (edge == 0.0) return {along, 0.0};
    if (edge == 1.0) return {side, along};
    if (edge == 2.0) return {side - along, side};
    return {0.0, side - along};
}

/// The columns of the smallest square grid that holds `count` points.
std::int64_t grid_columns(std::int64_t count) {
    auto columns = static_cast<std::int64_t>(std::sqrt(static_cast<double>(count)));
    while (columns * columns < count) ++columns;
    return columns;
}

/// The step of the grid, rounded down to 24 bits so that its multiples are exact.
double grid_step(std::int64_t columns) {
    if (columns < 2) return side;
    const double step = side / static_cast<double>(columns - 1);
    const double unit = std::ldexp(1.0, std::ilogb(step) - 23);
    return std::floor(step / unit) * unit;
}

void check(const GenerateOptions& options) {
    if (options.count < 0 || options.count > max_sites) {
        throw std::invalid_argument("the number of sites is out of range");
    }
    if (!std::isfinite(options.radius_from) || !std::isfinite(options.radius_to) ||
        !std::isfinite(options.radius_to - options.radius_from) ||
        options.radius_from > options.radius_to) {
        throw std::invalid_argument("the radii need two finite numbers, the smaller one first");
    }
    if (!std::isfinite(options.perturb) || options.perturb < 0.0) {
        throw std::invalid_argument("the perturbation must be finite and not negative");
    }
}

}  // namespace

std::vector<Site> generate(Distribution distribution, const GenerateOptions& options) {
    check(options);
    std::vector<Site> sites;
    sites.reserve(static_cast<std::size_t>(options.count));
    // Centres, radii and perturbations each have their own numbers, and so do not move one another.
    Uniform centres(options.seed);
    Uniform radii(options.seed ^ 0x9e3779b97f4a7c15U);
    Uniform perturbations(options.seed ^ 0xc2b2ae3d27d4eb4fU);
    const std::int64_t columns = grid_columns(options.count);
    const double step = grid_step(columns);
    for (std::int64_t i = 0; i < options.count; ++i) {
        Point centre;
        switch (distribution) {
            case Distribution::random:
                centre = random_point(centres);
                break;
            case Distribution::circle:
                centre = circle_point(centres);
                break;
            case Distribution::square:
                centre = square_point(centres);
                break;
            case Distribution::grid:
                centre = {step * static_cast<double>(i % columns),
                          step * static_cast<double>(i / columns)};
                break;
        }
        const double dx = options.perturb * perturbations();
        const double dy = options.perturb * perturbations();
        const double width = options.radius_to - options.radius_from;
        const double radius = std::min(options.radius_from + width * radii(), options.radius_to);
        sites.push_back({centre.x + dx, centre.y + dy, radius});
    }
    return sites;
}

}  // namespace signum
