#include "vertices.hpp"

#include <limits>
#include <stdexcept>

#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/ladder/ladder.hpp"
#include "../../predicates/space/in_sphere.hpp"
#include "cramer.hpp"

namespace signum {
namespace {

using exact::Rational;
using filters::Bounded;

/// As predicates::ladder::Refined, with a bound.
struct Boundedly {
    using Number = Bounded;
    [[nodiscard]] static Bounded difference(double a, double b) noexcept {
        return Bounded::exactly(filters::exact_difference(a, b));
    }
    [[nodiscard]] static Bounded difference_of_squares(double a, double b) noexcept {
        return difference(a, b) * Bounded::exactly(filters::exact_sum(a, b));
    }
    [[nodiscard]] static Bounded zero() noexcept { return {}; }
};
using Exactly = predicates::ladder::Exactly<Arithmetic::multiprecision>;

/// The point at equal power distance from i and three others: relative to i, the solution p of
/// 2 m·p = |m|² - (w_m - w_i) for the three.
template <class In>
struct Centre {
    using Number = typename In::Number;
    Number x;
    Number y;
    Number z;
    Number rho;

    template <power::PowerSite3 S>
    [[gnu::flatten]] Centre(const S& i, const S& j, const S& k, const S& l) {
        const auto plane = [&i](const S& m) -> spatial::Plane<Number> {
            const auto row = power::lifted_row<In>(m, i);
            return {row.offset.x, row.offset.y, row.offset.z, row.height()};
        };
        spatial::Meeting<Number> meeting;
        spatial::meet(meeting, plane(j), plane(k), plane(l));
        const Number twice = meeting.determinant + meeting.determinant;
        const Number from_x = meeting.x / twice;
        const Number from_y = meeting.y / twice;
        const Number from_z = meeting.z / twice;
        x = from_x + In::difference(i.x, 0.0);
        y = from_y + In::difference(i.y, 0.0);
        z = from_z + In::difference(i.z, 0.0);
        rho = from_x * from_x + from_y * from_y + from_z * from_z -
              power::weight_difference<In>(i, S{});
    }
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr SpaceVertex no_place = {nan, nan, nan, nan};

/// Precondition: the four are not in one plane.
template <power::PowerSite3 S>
SpaceVertex vertex_of(const S& i, const S& j, const S& k, const S& l) {
    const Centre<Boundedly> quick(i, j, k, l);
    const auto x = quick.x.rounded();
    const auto y = quick.y.rounded();
    const auto z = quick.z.rounded();
    const auto rho = quick.rho.rounded();
    if (x && y && z && rho) return {*x, *y, *z, *rho};
    const Centre<Exactly> centre(i, j, k, l);
    using exact::round_to_double;
    return {round_to_double(centre.x), round_to_double(centre.y), round_to_double(centre.z),
            round_to_double(centre.rho)};
}

template <class S>
std::vector<SpaceVertex> vertices_of(const SpaceTessellation& tessellation,
                                     std::span<const S> sites, int threads) {
    if (tessellation.sites != static_cast<std::int64_t>(sites.size()))
        throw std::invalid_argument("a tessellation of another number of sites");
    const auto is_site = [&](Index v) { return v >= 0 && v < static_cast<Index>(sites.size()); };
    const std::vector<SpaceCell>& cells = tessellation.cells;
    const Workers workers(threads, cells.size());
    std::vector<SpaceVertex> result;
    make_room(workers, cells.size(), result);
    workers.each_range(cells.size(), [&](std::size_t begin, std::size_t end) {
        const exact::IeeeEnvironment environment;
        for (std::size_t c = begin; c < end; ++c) {
            const SpaceCell& cell = cells[c];
            for (const Index v : cell)
                if (!is_site(v) && v != -1 && v != no_vertex)
                    throw std::invalid_argument("a cell has a vertex that is no site");
            const auto site = [&](std::size_t m) {
                return sites[static_cast<std::size_t>(cell[m])];
            };
            const bool has_vertex = is_site(cell[0]) && is_site(cell[1]) && is_site(cell[2]) &&
                                    is_site(cell[3]) &&
                                    ccw(site(0), site(1), site(2), site(3)) != 0;
            result[c] = has_vertex ? vertex_of(site(0), site(1), site(2), site(3)) : no_place;
        }
    });
    return result;
}

}  // namespace

std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const Point3> sites, int threads) {
    return vertices_of(tessellation, sites, threads);
}
std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const Site3> sites, int threads) {
    return vertices_of(tessellation, sites, threads);
}
std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const power::Site3> sites, int threads) {
    return vertices_of(tessellation, sites, threads);
}

}  // namespace signum
