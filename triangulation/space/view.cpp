#include "view.hpp"

#include <algorithm>
#include <limits>

#include "../../core/processor.hpp"
#include "../../filters/four.hpp"
#include "../../predicates/ladder/ladder.hpp"
#include "../../predicates/space/in_sphere.hpp"

namespace signum::spatial {
namespace {

using filters::Four;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Rows {
    Four x;
    Four y;
    Four z;
    Four lift;
};

[[gnu::always_inline]] inline void gather(Rows& rows,
                                          const std::array<const ViewRow*, 4>& of) noexcept {
    const auto& [a, b, c, d] = of;
    rows.x = Four{a->offset.x, b->offset.x, c->offset.x, d->offset.x};
    rows.y = Four{a->offset.y, b->offset.y, c->offset.y, d->offset.y};
    rows.z = Four{a->offset.z, b->offset.z, c->offset.z, d->offset.z};
    rows.lift = Four{a->lift, b->lift, c->lift, d->lift};
}
template <int a, int b, int c, int d>
[[gnu::always_inline]] inline void choose(Rows& chosen, const Rows& rows) noexcept {
    chosen.x = Four{rows.x[a], rows.x[b], rows.x[c], rows.x[d]};
    chosen.y = Four{rows.y[a], rows.y[b], rows.y[c], rows.y[d]};
    chosen.z = Four{rows.z[a], rows.z[b], rows.z[c], rows.z[d]};
    chosen.lift = Four{rows.lift[a], rows.lift[b], rows.lift[c], rows.lift[d]};
}

/// The vertices of the cells beyond, a those beyond the facets.
struct Beyond {
    Rows a;
    Rows b;
    Rows c;
    Rows d;
};
[[gnu::always_inline]] inline void gather(Beyond& rows, const std::array<const ViewRow*, 4>& cell,
                                          const std::array<const ViewRow*, 4>& beyond) noexcept {
    Rows vertices;
    gather(vertices, cell);
    gather(rows.a, beyond);
    // Beyond a facet its vertices turn the other way.
    choose<1, 0, 0, 0>(rows.b, vertices);
    choose<3, 2, 3, 1>(rows.c, vertices);
    choose<2, 3, 1, 2>(rows.d, vertices);
}
/// By what the heights are multiplied in power::in_sphere_determinant; those of b and d with the
/// other sign.
struct Coefficients {
    Four a;
    Four b;
    Four c;
    Four d;
};
[[gnu::always_inline]] inline void find(Coefficients& coefficients, const Beyond& rows) noexcept {
    const auto& [a, b, c, d] = rows;
    const Four ab = a.x * b.y - b.x * a.y;
    const Four bc = b.x * c.y - c.x * b.y;
    const Four cd = c.x * d.y - d.x * c.y;
    const Four da = d.x * a.y - a.x * d.y;
    const Four ac = a.x * c.y - c.x * a.y;
    const Four bd = b.x * d.y - d.x * b.y;
    coefficients.a = b.z * cd - c.z * bd + d.z * bc;
    coefficients.b = c.z * da + d.z * ac + a.z * cd;
    coefficients.c = d.z * ab + a.z * bd + b.z * da;
    coefficients.d = a.z * bc - b.z * ac + c.z * ab;
}
/// All of these, and the determinants.
[[gnu::always_inline]] inline void find(Four& result, Coefficients& of, Beyond& rows,
                                        const std::array<const ViewRow*, 4>& cell,
                                        const std::array<const ViewRow*, 4>& beyond) noexcept {
    gather(rows, cell, beyond);
    find(of, rows);
    result = (rows.a.lift * of.a + rows.c.lift * of.c) - (rows.b.lift * of.b + rows.d.lift * of.d);
}

}  // namespace

void in_spheres_beyond(const std::array<const ViewRow*, 4>& cell,
                       const std::array<const ViewRow*, 4>& beyond,
                       std::array<double, 4>& determinants) noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        Beyond rows;
        Coefficients coefficients;
        Four result;
        find(result, coefficients, rows, cell, beyond);
        for (std::size_t k = 0; k < 4; ++k) determinants[k] = result[k];
    });
}

void in_spheres_beyond_by_rule(const std::array<const ViewRow*, 4>& cell,
                               const std::array<const ViewRow*, 4>& beyond, double along_x,
                               double along_y, std::array<double, 4>& determinants) noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        Beyond rows;
        Coefficients coefficients;
        Four result;
        find(result, coefficients, rows, cell, beyond);
        // Where the site stands in the order, and what it decides.
        Four last{};
        Four decisive = Four{} - 1.0;
        const auto ask = [&](const Rows& of, const Four& coefficient)
            __attribute__((always_inline)) {
            const Four place = of.x * along_x + of.y * along_y + of.z;
            const auto is_later = (place > last) & (coefficient != 0.0);
            decisive = place == 0.0 ? Four{} : is_later ? coefficient : decisive;
            last = place == 0.0 ? Four{} + infinity : is_later ? place : last;
        };
        ask(rows.a, coefficients.a);
        ask(rows.b, -coefficients.b);
        ask(rows.c, coefficients.c);
        ask(rows.d, -coefficients.d);
        result = result == 0.0 ? decisive : result;
        for (std::size_t k = 0; k < 4; ++k) determinants[k] = result[k];
    });
}

// ---- the same in double-doubles
// ------------------------------------------------------------------

static_assert(refined_error > power::refined_in_sphere_error);

namespace {

using filters::DoubleDouble;
using filters::FourDoubleDoubles;

using RefinedRows = power::LiftedRow<FourDoubleDoubles>;

[[gnu::always_inline]] inline void put(FourDoubleDoubles& numbers, std::size_t lane,
                                       const DoubleDouble& number) noexcept {
    numbers.high[lane] = number.high;
    numbers.low[lane] = number.low;
}
template <class S>
[[gnu::always_inline]] inline void gather(RefinedRows& rows, const std::array<const S*, 4>& of,
                                          const S& eye) noexcept {
    for (std::size_t k = 0; k < 4; ++k) {
        const auto row = power::lifted_row<predicates::ladder::Refined>(*of[k], eye);
        put(rows.offset.x, k, row.offset.x);
        put(rows.offset.y, k, row.offset.y);
        put(rows.offset.z, k, row.offset.z);
        put(rows.weight, k, row.weight);
    }
}
/// Rows of which the height is known.
struct HighRows {
    predicates::Offset3<FourDoubleDoubles> offset;
    FourDoubleDoubles lift;
    [[gnu::always_inline]] const FourDoubleDoubles& height() const noexcept { return lift; }
};
template <int a, int b, int c, int d>
[[gnu::always_inline]] inline void choose(FourDoubleDoubles& chosen,
                                          const FourDoubleDoubles& of) noexcept {
    chosen.high = Four{of.high[a], of.high[b], of.high[c], of.high[d]};
    chosen.low = Four{of.low[a], of.low[b], of.low[c], of.low[d]};
}
template <int a, int b, int c, int d>
[[gnu::always_inline]] inline void choose(HighRows& chosen, const HighRows& rows) noexcept {
    choose<a, b, c, d>(chosen.offset.x, rows.offset.x);
    choose<a, b, c, d>(chosen.offset.y, rows.offset.y);
    choose<a, b, c, d>(chosen.offset.z, rows.offset.z);
    choose<a, b, c, d>(chosen.lift, rows.lift);
}

}  // namespace

template <power::PowerSite3 S>
void refined_in_spheres_beyond(const S& eye, const std::array<const S*, 4>& cell,
                               const std::array<const S*, 4>& beyond,
                               std::array<double, 4>& determinants) noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        RefinedRows rows;
        gather(rows, cell, eye);
        const HighRows vertices = {rows.offset, rows.height()};
        gather(rows, beyond, eye);
        const HighRows a = {rows.offset, rows.height()};
        HighRows b;
        HighRows c;
        HighRows d;
        choose<1, 0, 0, 0>(b, vertices);
        choose<3, 2, 3, 1>(c, vertices);
        choose<2, 3, 1, 2>(d, vertices);
        const FourDoubleDoubles result = power::in_sphere_determinant(a, b, c, d);
        for (std::size_t k = 0; k < 4; ++k) determinants[k] = result.high[k];
    });
}

template <power::PowerSite3 S>
bool are_in_window(std::span<const S> sites) noexcept {
    return std::ranges::all_of(sites, [](const S& site) {
        return predicates::ladder::in_window<power::InSphere::window>(site);
    });
}

#define SIGNUM_OF(S)                                                                  \
    template void refined_in_spheres_beyond(const S&, const std::array<const S*, 4>&, \
                                            const std::array<const S*, 4>&,           \
                                            std::array<double, 4>&) noexcept;         \
    template bool are_in_window(std::span<const S>) noexcept
SIGNUM_OF(Point3);
SIGNUM_OF(Site3);
SIGNUM_OF(power::Site3);
#undef SIGNUM_OF

}  // namespace signum::spatial
