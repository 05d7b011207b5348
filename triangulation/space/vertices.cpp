#include "vertices.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../../exact/floating_environment.hpp"
#include "../../exact/multiprecision.hpp"
#include "../../filters/bounded.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum {
namespace {

using exact::Rational;
using filters::Bounded;

/// A double in one of the two arithmetics, and the exact difference of two.
Bounded number(Bounded /*kind*/, double value) {
    return Bounded::exactly(value);
}
Rational number(const Rational& /*kind*/, double value) {
    return exact::to_rational(value);
}
Bounded difference(Bounded /*kind*/, double a, double b) {
    return Bounded::exactly(filters::exact_difference(a, b));
}
Rational difference(const Rational& /*kind*/, double a, double b) {
    return exact::to_rational(a) - exact::to_rational(b);
}

template <class Number, power::PowerSite3 S>
Number weight(const S& s) {
    const Number kind{};
    if constexpr (requires { s.w; }) {
        return number(kind, s.w);
    } else if constexpr (requires { s.r; }) {
        return number(kind, s.r) * number(kind, s.r);
    } else {
        return number(kind, 0.0);
    }
}

/// The point at equal power distance from i and three others: relative to i, the solution p of
/// 2 m·p = |m|² - (w_m - w_i) for the three, by Cramer's rule.
template <class Number>
struct Centre {
    Number x;
    Number y;
    Number z;
    Number rho;

    template <power::PowerSite3 S>
    Centre(const S& i, const S& j, const S& k, const S& l) {
        const Row b(j, i);
        const Row c(k, i);
        const Row d(l, i);
        const Cross cd(c, d);
        const Cross db(d, b);
        const Cross bc(b, c);
        const Number volume = b.x * cd.x + b.y * cd.y + b.z * cd.z;
        const Number twice = volume + volume;
        const auto solution = [&](const Number& along_cd, const Number& along_db,
                                  const Number& along_bc) {
            return Number((b.height * along_cd + c.height * along_db + d.height * along_bc) /
                          twice);
        };
        const Number from_x = solution(cd.x, db.x, bc.x);
        const Number from_y = solution(cd.y, db.y, bc.y);
        const Number from_z = solution(cd.z, db.z, bc.z);
        x = from_x + number(volume, i.x);
        y = from_y + number(volume, i.y);
        z = from_z + number(volume, i.z);
        rho = from_x * from_x + from_y * from_y + from_z * from_z - weight<Number>(i);
    }

 private:
    struct Row {
        Number x;
        Number y;
        Number z;
        Number height;
        template <class S>
        Row(const S& m, const S& i)
            : x(difference(Number{}, m.x, i.x)),
              y(difference(Number{}, m.y, i.y)),
              z(difference(Number{}, m.z, i.z)),
              height(x * x + y * y + z * z - (weight<Number>(m) - weight<Number>(i))) {}
    };
    struct Cross {
        Number x;
        Number y;
        Number z;
        Cross(const Row& a, const Row& b)
            : x(a.y * b.z - a.z * b.y), y(a.z * b.x - a.x * b.z), z(a.x * b.y - a.y * b.x) {}
    };
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr SpaceVertex no_place = {nan, nan, nan, nan};

/// Precondition: the four are not in one plane.
template <power::PowerSite3 S>
SpaceVertex vertex_of(const S& i, const S& j, const S& k, const S& l) {
    const Centre<Bounded> quick(i, j, k, l);
    const auto x = quick.x.rounded();
    const auto y = quick.y.rounded();
    const auto z = quick.z.rounded();
    const auto rho = quick.rho.rounded();
    if (x && y && z && rho) return {*x, *y, *z, *rho};
    const Centre<Rational> exact(i, j, k, l);
    const auto rounded = [](const Rational& value) {
        const double result = exact::round_to_double(value);
        return std::isfinite(result) ? result : nan;
    };
    return {rounded(exact.x), rounded(exact.y), rounded(exact.z), rounded(exact.rho)};
}

template <class S>
std::vector<SpaceVertex> vertices_of(const SpaceTessellation& tessellation,
                                     std::span<const S> sites) {
    if (tessellation.sites != static_cast<std::int64_t>(sites.size()))
        throw std::invalid_argument("a tessellation of another number of sites");
    const exact::IeeeEnvironment environment;
    std::vector<SpaceVertex> result;
    result.reserve(tessellation.cells.size());
    for (const SpaceCell& cell : tessellation.cells) {
        const auto is_site = [&](Index v) {
            return v >= 0 && v < static_cast<Index>(sites.size());
        };
        for (const Index v : cell)
            if (!is_site(v) && v != -1 && v != no_vertex)
                throw std::invalid_argument("a cell has a vertex that is no site");
        const auto site = [&](std::size_t m) { return sites[static_cast<std::size_t>(cell[m])]; };
        const bool has_vertex = is_site(cell[0]) && is_site(cell[1]) && is_site(cell[2]) &&
                                is_site(cell[3]) && ccw(site(0), site(1), site(2), site(3)) != 0;
        result.push_back(has_vertex ? vertex_of(site(0), site(1), site(2), site(3)) : no_place);
    }
    return result;
}

}  // namespace

std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const Point3> sites) {
    return vertices_of(tessellation, sites);
}
std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const Site3> sites) {
    return vertices_of(tessellation, sites);
}
std::vector<SpaceVertex> vertices(const SpaceTessellation& tessellation,
                                  std::span<const power::Site3> sites) {
    return vertices_of(tessellation, sites);
}

}  // namespace signum
