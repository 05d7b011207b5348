/// Tessellations of the plane and their diagrams, behind signum.h.

#include "../../triangulation/tessellation.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "../../core/strided_sites.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../../voronoi/clip.hpp"
#include "../../voronoi/voronoi.hpp"
#include "boundary.hpp"
#include "handles.hpp"

struct signum_voronoi {
    static constexpr const char* name = "voronoi";
    signum::Voronoi voronoi;
};

namespace signum::c {
namespace {

static_assert(sizeof(Face) == 3 * sizeof(std::int32_t) &&
              sizeof(Hidden) == 2 * sizeof(std::int32_t) &&
              sizeof(DiagramVertex) == 3 * sizeof(double) &&
              sizeof(VoronoiEdge) == 6 * sizeof(std::int32_t));
static_assert(infinite == SIGNUM_INFINITE && at_infinity == SIGNUM_INFINITE);

/// The sites as the library sees them; nothing is copied.
[[nodiscard]] StridedSites view(const double* sites, std::int64_t count, std::int64_t stride,
                                WeightIs weight_is, Arithmetic arithmetic = Arithmetic::exact) {
    expect_sites(sites, count, stride, 2,
                 arithmetic == Arithmetic::single ? std::numeric_limits<float>::max()
                                                  : std::numeric_limits<double>::max());
    if (count == 0)
        return StridedSites(0, sizeof(double), nullptr, nullptr, nullptr,
                            weight_is == WeightIs::weight);
    return StridedSites(static_cast<std::size_t>(count),
                        static_cast<std::ptrdiff_t>(sizeof(double)) * stride, sites, sites + 1,
                        stride > 2 ? sites + 2 : nullptr, weight_is == WeightIs::weight);
}

[[nodiscard]] Point point_of(const double* numbers) {
    if (!finite<2>(numbers)) throw Refused("the point is null or not finite");
    return {numbers[0], numbers[1]};
}

}  // namespace
}  // namespace signum::c

using namespace signum;
using c::create;
using c::expect;
using c::guarded;
using c::with;

signum_status signum_triangulate(const double* sites, int64_t count, int64_t stride,
                                 signum_metric metric, const signum_options* options,
                                 signum_tessellation** tessellation, signum_error* error) {
    return create(tessellation, error, [&] {
        const c::Asked asked = c::asked(options);
        const Metric which = c::metric_of(metric);
        return triangulate(c::view(sites, count, stride, asked.weight_is, asked.options.arithmetic),
                           which, asked.options);
    });
}

void signum_tessellation_free(signum_tessellation* tessellation) {
    delete tessellation;
}

signum_status signum_tessellation_arrays(const signum_tessellation* tessellation,
                                         signum_arrays* arrays, signum_error* error) {
    return with(tessellation, error, [&] {
        const TessellationArrays& all = tessellation->tessellation.arrays();
        signum_arrays shown = SIGNUM_ARRAYS;
        shown.metric = static_cast<signum_metric>(all.metric);
        shown.weight_is = static_cast<signum_weight_is>(all.weight_is);
        shown.sites = all.sites;
        c::show(all.neighbours, shown.neighbours, shown.face_count);
        c::show(all.faces, shown.faces, shown.face_count);
        c::show(all.hidden, shown.hidden, shown.hidden_count);
        c::give(arrays, shown, "arrays");
    });
}

signum_status signum_tessellation_vertices(const signum_tessellation* tessellation,
                                           double* vertices, int64_t count, signum_error* error) {
    return with(tessellation, error, [&] {
        c::expect_room(vertices, count, 3 * tessellation->tessellation.faces().size(),
                       "numbers of vertices");
        const auto all = signum::vertices(tessellation->tessellation);
        std::copy_n(reinterpret_cast<const double*>(all.data()), count, vertices);
    });
}

signum_status signum_tessellation_locate(const signum_tessellation* tessellation,
                                         const double* point, int32_t* face, signum_error* error) {
    return with(tessellation, error, [&] {
        expect(face, "face");
        *face = tessellation->tessellation.locate(c::point_of(point));
    });
}

signum_status signum_tessellation_nearest(const signum_tessellation* tessellation,
                                          const double* point, int32_t* site, signum_error* error) {
    return with(tessellation, error, [&] {
        expect(site, "site");
        *site = tessellation->tessellation.nearest(c::point_of(point));
    });
}

signum_status signum_validate(const signum_arrays* arrays, const double* sites, int64_t count,
                              int64_t stride, const signum_options* options,
                              signum_validation* validation, signum_error* error) {
    return guarded(error, [&] {
        expect(arrays, "arrays");
        expect(validation, "validation");
        const signum_arrays given = c::read(arrays, signum_arrays SIGNUM_ARRAYS, "arrays");
        c::expect_array(given.faces, given.face_count, "faces");
        c::expect_array(given.hidden, given.hidden_count, "hidden sites");
        TessellationArrays all{.metric = c::metric_of(given.metric),
                               .weight_is = c::weight_of(given.weight_is),
                               .sites = given.sites,
                               .faces = c::rows_from<Face>(given.faces, given.face_count),
                               .neighbours = {},
                               .hidden = c::rows_from<Hidden>(given.hidden, given.hidden_count)};
        if (given.neighbours != nullptr)
            all.neighbours = c::rows_from<Face>(given.neighbours, given.face_count);
        const Validation judgement = validate(all, c::view(sites, count, stride, all.weight_is),
                                              c::for_validation(c::asked(options)));
        validation->valid = judgement.valid;
        validation->canonical = judgement.canonical;
        c::write(validation->message, judgement.message);
    });
}

signum_status signum_voronoi_create(const signum_tessellation* tessellation, int32_t merge,
                                    signum_voronoi** voronoi, signum_error* error) {
    return create(voronoi, error, [&] {
        expect(tessellation);
        return signum::voronoi(tessellation->tessellation, {.merge = merge != 0});
    });
}

void signum_voronoi_free(signum_voronoi* voronoi) {
    delete voronoi;
}

signum_status signum_voronoi_arrays(const signum_voronoi* voronoi, signum_diagram_arrays* arrays,
                                    signum_error* error) {
    return with(voronoi, error, [&] {
        signum_diagram_arrays shown = SIGNUM_DIAGRAM_ARRAYS;
        c::show(voronoi->voronoi.vertices(), shown.vertices, shown.vertex_count);
        c::show(voronoi->voronoi.edges(), shown.edges, shown.edge_count);
        c::give(arrays, shown, "arrays");
    });
}

signum_status signum_voronoi_areas(const signum_voronoi* voronoi, const double* box, double* areas,
                                   int64_t count, signum_error* error) {
    return with(voronoi, error, [&] {
        const Voronoi& diagram = voronoi->voronoi;
        const auto sites = diagram.tessellation().sites();
        c::expect_room(areas, count, sites.size(), "areas");
        if (sites.empty()) return;
        if (box != nullptr && !c::finite<4>(box)) throw c::Refused("the box is not finite");
        const ClippedVoronoi clipped(diagram, box == nullptr
                                                  ? default_box(sites, diagram.exponent())
                                                  : Box{box[0], box[1], box[2], box[3]});
        const std::vector<Measure> measured = measures(clipped);
        std::ranges::transform(measured, areas, &Measure::area);
    });
}
