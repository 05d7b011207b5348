/// Tessellations of the plane and their diagrams, behind signum.h.

#include "../../triangulation/tessellation.hpp"

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

[[nodiscard]] std::vector<Face> faces_from(const std::int32_t* numbers, std::int64_t count) {
    std::vector<Face> faces(static_cast<std::size_t>(count));
    for (std::size_t f = 0; f < faces.size(); ++f)
        std::copy(numbers + 3 * f, numbers + 3 * f + 3, faces[f].begin());
    return faces;
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

signum_status signum_triangulate(const double* sites, int64_t count, int64_t stride,
                                 signum_metric metric, const signum_options* options,
                                 signum_tessellation** tessellation, signum_error* error) {
    return create(tessellation, "tessellation", error, [&] {
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
    return guarded(error, [&] {
        expect(tessellation, "tessellation");
        const TessellationArrays& all = tessellation->tessellation.arrays();
        signum_arrays shown = SIGNUM_ARRAYS;
        shown.metric = static_cast<signum_metric>(all.metric);
        shown.weight_is = static_cast<signum_weight_is>(all.weight_is);
        shown.sites = all.sites;
        shown.face_count = static_cast<std::int64_t>(all.faces.size());
        shown.faces = reinterpret_cast<const std::int32_t*>(all.faces.data());
        shown.neighbours = reinterpret_cast<const std::int32_t*>(all.neighbours.data());
        shown.hidden_count = static_cast<std::int64_t>(all.hidden.size());
        shown.hidden = reinterpret_cast<const std::int32_t*>(all.hidden.data());
        c::give(arrays, shown, "arrays");
    });
}

signum_status signum_tessellation_vertices(const signum_tessellation* tessellation,
                                           double* vertices, int64_t count, signum_error* error) {
    return guarded(error, [&] {
        expect(tessellation, "tessellation");
        c::expect_room(vertices, count, 3 * tessellation->tessellation.faces().size(),
                       "numbers of vertices");
        for (const DiagramVertex& vertex : signum::vertices(tessellation->tessellation)) {
            *vertices++ = vertex.x;
            *vertices++ = vertex.y;
            *vertices++ = vertex.rho;
        }
    });
}

signum_status signum_tessellation_locate(const signum_tessellation* tessellation,
                                         const double* point, int32_t* face, signum_error* error) {
    return guarded(error, [&] {
        expect(tessellation, "tessellation");
        expect(face, "face");
        *face = tessellation->tessellation.locate(c::point_of(point));
    });
}

signum_status signum_tessellation_nearest(const signum_tessellation* tessellation,
                                          const double* point, int32_t* site, signum_error* error) {
    return guarded(error, [&] {
        expect(tessellation, "tessellation");
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
                               .faces = c::faces_from(given.faces, given.face_count),
                               .neighbours = {},
                               .hidden = {}};
        if (given.neighbours != nullptr)
            all.neighbours = c::faces_from(given.neighbours, given.face_count);
        for (std::int64_t h = 0; h < given.hidden_count; ++h)
            all.hidden.push_back({given.hidden[2 * h], given.hidden[2 * h + 1]});
        const Validation judgement =
            validate(all, c::view(sites, count, stride, all.weight_is),
                     {.stop = {}, .progress = c::asked(options).options.progress});
        validation->valid = judgement.valid;
        validation->canonical = judgement.canonical;
        c::write(validation->message, judgement.message);
    });
}

signum_status signum_voronoi_create(const signum_tessellation* tessellation, int32_t merge,
                                    signum_voronoi** voronoi, signum_error* error) {
    return create(voronoi, "voronoi", error, [&] {
        expect(tessellation, "tessellation");
        return signum::voronoi(tessellation->tessellation, {.merge = merge != 0});
    });
}

void signum_voronoi_free(signum_voronoi* voronoi) {
    delete voronoi;
}

signum_status signum_voronoi_arrays(const signum_voronoi* voronoi, signum_diagram_arrays* arrays,
                                    signum_error* error) {
    return guarded(error, [&] {
        expect(voronoi, "voronoi");
        const auto vertices = voronoi->voronoi.vertices();
        const auto edges = voronoi->voronoi.edges();
        signum_diagram_arrays shown = SIGNUM_DIAGRAM_ARRAYS;
        shown.vertex_count = static_cast<std::int64_t>(vertices.size());
        shown.vertices = reinterpret_cast<const double*>(vertices.data());
        shown.edge_count = static_cast<std::int64_t>(edges.size());
        shown.edges = reinterpret_cast<const std::int32_t*>(edges.data());
        c::give(arrays, shown, "arrays");
    });
}

signum_status signum_voronoi_areas(const signum_voronoi* voronoi, const double* box, double* areas,
                                   int64_t count, signum_error* error) {
    return guarded(error, [&] {
        expect(voronoi, "voronoi");
        const Voronoi& diagram = voronoi->voronoi;
        const auto sites = diagram.tessellation().sites();
        c::expect_room(areas, count, sites.size(), "areas");
        if (sites.empty()) return;
        if (box != nullptr && !c::finite<4>(box)) throw c::Refused("the box is not finite");
        const ClippedVoronoi clipped(diagram, box == nullptr
                                                  ? default_box(sites, diagram.exponent())
                                                  : Box{box[0], box[1], box[2], box[3]});
        std::vector<double> measured;
        measured.reserve(sites.size());
        for (std::size_t i = 0; i < sites.size(); ++i)
            measured.push_back(measure(clipped.cell(static_cast<Index>(i))).area);
        std::copy(measured.begin(), measured.end(), areas);
    });
}
