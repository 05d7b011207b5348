#include "view.hpp"

#include "../core/processor.hpp"
#include "../filters/four.hpp"

namespace signum::spatial {
namespace {

using filters::Four;

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

}  // namespace

void in_spheres_beyond(const std::array<const ViewRow*, 4>& cell,
                       const std::array<const ViewRow*, 4>& beyond,
                       std::array<double, 4>& determinants) noexcept {
    as_wide_as_possible([&]() __attribute__((always_inline)) {
        Rows vertices;
        Rows a;
        Rows b;
        Rows c;
        Rows d;
        gather(vertices, cell);
        gather(a, beyond);
        // Beyond a facet its vertices turn the other way.
        choose<1, 0, 0, 0>(b, vertices);
        choose<3, 2, 3, 1>(c, vertices);
        choose<2, 3, 1, 2>(d, vertices);
        // power::in_sphere_determinant
        const Four ab = a.x * b.y - b.x * a.y;
        const Four bc = b.x * c.y - c.x * b.y;
        const Four cd = c.x * d.y - d.x * c.y;
        const Four da = d.x * a.y - a.x * d.y;
        const Four ac = a.x * c.y - c.x * a.y;
        const Four bd = b.x * d.y - d.x * b.y;
        const Four result =
            (a.lift * (b.z * cd - c.z * bd + d.z * bc) +
             c.lift * (d.z * ab + a.z * bd + b.z * da)) -
            (b.lift * (c.z * da + d.z * ac + a.z * cd) + d.lift * (a.z * bc - b.z * ac + c.z * ab));
        for (std::size_t k = 0; k < 4; ++k) determinants[k] = result[k];
    });
}

}  // namespace signum::spatial
