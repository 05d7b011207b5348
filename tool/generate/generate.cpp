#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "../../core/index.hpp"
#include "generate.hpp"
#include "hard.hpp"
#include "uniform.hpp"

namespace signum {
namespace {

constexpr double box_side = 700.0;

Site square_site(Uniform& uniform) {
    const double x = box_side * uniform();
    return {x, box_side * uniform()};
}

/// Von Neumann: a uniform direction, its angle doubled. No sine, whose last bit differs from
/// library to library.
Site circle_site(Uniform& uniform) {
    for (;;) {
        const double u = 2.0 * uniform() - 1.0;
        const double v = 2.0 * uniform() - 1.0;
        const double norm = u * u + v * v;
        if (norm > 1.0 || norm < 0x1p-40) continue;
        const double radius = box_side / 2.0;
        return {radius + radius * ((u * u - v * v) / norm), radius + radius * (2.0 * u * v / norm)};
    }
}

Site boundary_site(Uniform& uniform) {
    const double place = 4.0 * uniform();
    const double edge = std::floor(place);
    const double along = box_side * (place - edge);
    if (edge == 0.0) return {along, 0.0};
    if (edge == 1.0) return {box_side, along};
    if (edge == 2.0) return {box_side - along, box_side};
    return {0.0, box_side - along};
}

Site3 cube_site(Uniform& uniform) {
    const double x = box_side * uniform();
    const double y = box_side * uniform();
    return {x, y, box_side * uniform()};
}

/// Marsaglia: from a uniform point of the disc; the root is rounded to nearest everywhere.
Site3 sphere_site(Uniform& uniform) {
    for (;;) {
        const double u = 2.0 * uniform() - 1.0;
        const double v = 2.0 * uniform() - 1.0;
        const double square = u * u + v * v;
        if (square >= 1.0) continue;
        const double root = 2.0 * std::sqrt(1.0 - square);
        const double radius = box_side / 2.0;
        return {radius + radius * (root * u), radius + radius * (root * v),
                radius + radius * (1.0 - 2.0 * square)};
    }
}

Site3 surface_site(Uniform& uniform) {
    const double place = 6.0 * uniform();
    const double face = std::floor(place);
    const double u = box_side * (place - face);
    const double v = box_side * uniform();
    if (face == 0.0) return {0.0, u, v};
    if (face == 1.0) return {box_side, u, v};
    if (face == 2.0) return {u, 0.0, v};
    if (face == 3.0) return {u, box_side, v};
    return {u, v, face == 4.0 ? 0.0 : box_side};
}

/// The columns of the smallest square or cubic grid that holds `count` points.
std::int64_t grid_columns(std::int64_t count, int dimension = 2) {
    std::int64_t columns = 1;
    while (columns * columns * (dimension == 3 ? columns : 1) < count) ++columns;
    return columns;
}

/// The step of the grid, rounded down to 24 bits so that its multiples are exact.
double grid_step(std::int64_t columns) {
    if (columns < 2) return box_side;
    const double step = box_side / static_cast<double>(columns - 1);
    const double unit = std::ldexp(1.0, std::ilogb(step) - 23);
    return std::floor(step / unit) * unit;
}

/// The place of a pattern among patterns that lie side by side, in patterns.
Site place_of(std::int64_t pattern, std::int64_t columns) {
    return {static_cast<double>(pattern % columns), static_cast<double>(pattern / columns)};
}

/// How many sites a pattern of integers has.
constexpr std::int64_t pattern_size = 192;

/// The 192 integer points with x² + y² = 5² 13 17 29 37 = 5928325.
std::vector<Site> lattice_circle() {
    constexpr std::int64_t square = 5928325;
    std::vector<Site> points;
    for (std::int64_t x = -2434; x <= 2434; ++x) {
        const std::int64_t rest = square - x * x;
        const auto y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(rest)) + 0.5);
        if (y * y != rest) continue;
        const auto u = static_cast<double>(x);
        const auto v = static_cast<double>(y);
        points.push_back({u, v});
        if (y != 0) points.push_back({u, -v});
    }
    return points;
}

/// 192 discs that touch the circle of radius 10000 around the origin from outside. With a² + b² =
/// c² the centre (ka, kb) is kc away: the disc's radius is kc - 10000.
std::vector<Site> tangent_discs() {
    constexpr std::int64_t radius = 10000;
    std::vector<Site> discs;
    const auto add = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
        const std::int64_t k = (radius + c - 1) / c;
        discs.push_back({static_cast<double>(k * a), static_cast<double>(k * b),
                         static_cast<double>(k * c - radius)});
    };
    // Every primitive triple is m² - n², 2mn, m² + n².
    for (std::int64_t m = 2; std::ssize(discs) < pattern_size; ++m)
        for (std::int64_t n = 1 + m % 2; n < m && std::ssize(discs) < pattern_size; n += 2) {
            if (std::gcd(m, n) != 1) continue;
            const std::int64_t a = m * m - n * n;
            const std::int64_t b = 2 * m * n;
            const std::int64_t c = m * m + n * n;
            for (const std::int64_t s : {1, -1})
                for (const std::int64_t t : {1, -1}) {
                    add(s * a, t * b, c);
                    add(s * b, t * a, c);
                }
        }
    return discs;
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

/// The sites of one distribution, one after the other.
class Centres {
 public:
    Centres(Distribution distribution, const GenerateOptions& options)
        : distribution_(distribution),
          uniform_(options.seed),
          columns_(grid_columns(options.count)),
          step_(grid_step(columns_)) {
        if (distribution == Distribution::lattice) pattern_ = lattice_circle();
        if (distribution == Distribution::tangent) pattern_ = tangent_discs();
        if (distribution == Distribution::rings) patterns_ = (options.count + 999) / 1000;
        if (!pattern_.empty()) patterns_ = (options.count + pattern_size - 1) / pattern_size;
        pattern_columns_ = grid_columns(patterns_);
    }

    /// The i-th site; to be asked in order.
    Site operator()(std::int64_t i) {
        switch (distribution_) {
            case Distribution::random:
                return square_site(uniform_);
            case Distribution::circle:
                return circle_site(uniform_);
            case Distribution::square:
                return boundary_site(uniform_);
            case Distribution::grid:
                return {step_ * static_cast<double>(i % columns_),
                        step_ * static_cast<double>(i / columns_), 0.0};
            case Distribution::offset: {
                // From a lowest to a highest bit these coordinates take all 53.
                constexpr double corner = 0x1.8p40;
                return {corner + 0x1p-12 * static_cast<double>(i % columns_),
                        corner + 0x1p-12 * static_cast<double>(i / columns_), 0.0};
            }
            case Distribution::rings: {
                const Site place = place_of(i / 1000, pattern_columns_);
                const Site point = circle_site(uniform_);
                const auto width = static_cast<double>(pattern_columns_);
                return {(box_side * place.x + point.x) / width,
                        (box_side * place.y + point.y) / width, 0.0};
            }
            case Distribution::lattice:
            case Distribution::tangent: {
                const Site& site = pattern_[static_cast<std::size_t>(i % pattern_size)];
                const Site place = place_of(i / pattern_size, pattern_columns_);
                const double pitch = distribution_ == Distribution::lattice ? 0x1p13 : 0x1p15;
                return {pitch * place.x + site.x, pitch * place.y + site.y, site.r};
            }
        }
        return {};
    }

 private:
    Distribution distribution_;
    Uniform uniform_;
    std::int64_t columns_;  ///< of a grid
    double step_;
    std::vector<Site> pattern_;
    std::int64_t patterns_ = 1;
    std::int64_t pattern_columns_ = 1;
};

/// Radii and perturbations of sites. These, and the centres, each have their own numbers, and so do
/// not move one another.
class Changes {
 public:
    explicit Changes(const GenerateOptions& options)
        : options_(options),
          radii_(options.seed ^ 0x9e3779b97f4a7c15U),
          perturbations_(options.seed ^ 0xc2b2ae3d27d4eb4fU) {}

    Site operator()(const Site& site) {
        const double dx = shift();
        const double dy = shift();
        return {site.x + dx, site.y + dy, site.r + radius()};
    }
    Site3 operator()(const Site3& site) {
        const double dx = shift();
        const double dy = shift();
        const double dz = shift();
        return {site.x + dx, site.y + dy, site.z + dz, site.r + radius()};
    }

 private:
    double shift() { return options_.perturb * perturbations_(); }
    double radius() {
        const double width = options_.radius_to - options_.radius_from;
        return std::min(options_.radius_from + width * radii_(), options_.radius_to);
    }

    const GenerateOptions& options_;
    Uniform radii_;
    Uniform perturbations_;
};

/// Sites as site_at(i) tells them one after the other, with the options' changes.
template <class SiteAt>
auto changed(const GenerateOptions& options, SiteAt site_at) {
    std::vector<decltype(site_at(0))> sites;
    sites.reserve(static_cast<std::size_t>(options.count));
    Changes change(options);
    for (std::int64_t i = 0; i < options.count; ++i) sites.push_back(change(site_at(i)));
    return sites;
}

/// The hard sites, one after the other.
template <std::size_t d>
class HardSites {
 public:
    explicit HardSites(std::uint64_t seed) : moves_(seed) {}

    const hard::Ball<d>& operator()() {
        if (next_ == pattern_.size()) make_pattern();
        return pattern_[next_++];
    }

 private:
    void make_pattern() {
        using hard::Kind;
        // A weight is no radius.
        constexpr std::array kinds = {Kind::points, Kind::radii, Kind::euclidean, Kind::supremum,
                                      Kind::manhattan};
        const Kind kind = kinds[made_++ % kinds.size()];
        moves_.any_pattern(kind, pattern_);
        // Radii below 0 the tool takes for weights; in these metrics their differences alone count.
        double least = 0.0;
        for (const hard::Ball<d>& ball : pattern_) least = std::min(least, ball.size);
        for (hard::Ball<d>& ball : pattern_) ball.size -= least;
        if (!moves_.once_in(4))
            moves_.move_by_ulps(kind, pattern_, static_cast<int>(moves_.integer(1, 6)), 4);
        for (hard::Ball<d>& ball : pattern_) ball.size = std::abs(ball.size);
        if (moves_.once_in(4))
            moves_.scale(kind, pattern_, static_cast<int>(moves_.integer(-20, 20)));
        next_ = 0;
    }

    hard::Moves<d> moves_;
    std::array<hard::Ball<d>, 16> pattern_;
    std::size_t next_ = 16;
    std::size_t made_ = 0;
};

}  // namespace

std::vector<Site> generate_hard(const GenerateOptions& options) {
    check(options);
    return changed(options, [balls = HardSites<2>(options.seed)](std::int64_t) mutable {
        const auto& [centre, size] = balls();
        return Site{centre[0], centre[1], size};
    });
}

std::vector<Site3> generate_hard_in_space(const GenerateOptions& options) {
    check(options);
    return changed(options, [balls = HardSites<3>(options.seed)](std::int64_t) mutable {
        const auto& [centre, size] = balls();
        return Site3{centre[0], centre[1], centre[2], size};
    });
}

std::string_view name_of(Distribution distribution) noexcept {
    constexpr std::string_view names[] = {"random",  "circle", "square", "grid",
                                          "lattice", "rings",  "offset", "tangent"};
    return names[static_cast<int>(distribution)];
}

std::vector<Site> generate(Distribution distribution, const GenerateOptions& options) {
    check(options);
    return changed(options, Centres(distribution, options));
}

std::string_view name_of(SpaceDistribution distribution) noexcept {
    constexpr std::string_view names[] = {"random", "sphere", "cube", "grid"};
    return names[static_cast<int>(distribution)];
}

std::vector<Site3> generate(SpaceDistribution distribution, const GenerateOptions& options) {
    check(options);
    Uniform uniform(options.seed);
    const std::int64_t columns = grid_columns(options.count, 3);
    const double step = grid_step(columns);
    return changed(options, [&](std::int64_t i) -> Site3 {
        switch (distribution) {
            case SpaceDistribution::random:
                return cube_site(uniform);
            case SpaceDistribution::sphere:
                return sphere_site(uniform);
            case SpaceDistribution::cube:
                return surface_site(uniform);
            case SpaceDistribution::grid:
                return {step * static_cast<double>(i % columns),
                        step * static_cast<double>(i / columns % columns),
                        step * static_cast<double>(i / (columns * columns))};
        }
        return {};
    });
}

}  // namespace signum
