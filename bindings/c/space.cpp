/// Tessellations of space, behind signum.h.

#include <limits>
#include <span>
#include <variant>
#include <vector>

#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/space/vertices.hpp"
#include "boundary.hpp"
#include "handles.hpp"

namespace signum::c {
namespace {

static_assert(sizeof(SpaceCell) == 4 * sizeof(std::int32_t) &&
              sizeof(SpaceVertex) == 4 * sizeof(double) && no_vertex == SIGNUM_NO_VERTEX);

using SpaceSites = std::variant<std::vector<Point3>, std::vector<Site3>, std::vector<power::Site3>>;

template <class S>
[[nodiscard]] SpaceSites copied(const double* sites, std::int64_t count, std::int64_t stride) {
    std::vector<S> copy(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < copy.size(); ++i)
        copy[i] = as<S>(sites + static_cast<std::int64_t>(i) * stride);
    return copy;
}
/// In the type that says what their numbers mean. Throws Refused for such that cannot be.
[[nodiscard]] SpaceSites space_sites(const double* sites, std::int64_t count, std::int64_t stride,
                                     WeightIs weight_is) {
    expect_sites(sites, count, stride, 3, std::numeric_limits<double>::max(), max_sites_in_space);
    if (stride == 3) return copied<Point3>(sites, count, stride);
    return weight_is == WeightIs::weight ? copied<power::Site3>(sites, count, stride)
                                         : copied<Site3>(sites, count, stride);
}

/// The sites are kept: vertices are asked of both.
struct SpaceResult {
    SpaceSites sites;
    SpaceTessellation tessellation;
};

/// A span of the sites in their own type.
template <class Visit>
decltype(auto) with_sites(const SpaceSites& sites, Visit&& visit) {
    return std::visit([&](const auto& of_type) { return visit(std::span(of_type)); }, sites);
}

}  // namespace
}  // namespace signum::c

struct signum_space_tessellation {
    static constexpr const char* name = "tessellation";
    signum::c::SpaceResult result;
};

using namespace signum;
using c::expect;
using c::guarded;
using c::with;

signum_status signum_triangulate_space(const double* sites, int64_t count, int64_t stride,
                                       const signum_options* options,
                                       signum_space_tessellation** tessellation,
                                       signum_error* error) {
    return c::create(tessellation, error, [&] {
        const c::Asked asked = c::asked(options);
        c::SpaceSites copy = c::space_sites(sites, count, stride, asked.weight_is);
        SpaceTessellation made =
            c::with_sites(copy, [&](auto all) { return triangulate(all, Power{}, asked.options); });
        return c::SpaceResult{std::move(copy), std::move(made)};
    });
}

void signum_space_tessellation_free(signum_space_tessellation* tessellation) {
    delete tessellation;
}

signum_status signum_space_tessellation_arrays(const signum_space_tessellation* tessellation,
                                               signum_space_arrays* arrays, signum_error* error) {
    return with(tessellation, error, [&] {
        const SpaceTessellation& all = tessellation->result.tessellation;
        signum_space_arrays shown = SIGNUM_SPACE_ARRAYS;
        shown.dimension = all.dimension;
        shown.sites = all.sites;
        c::show(all.neighbours, shown.neighbours, shown.cell_count);
        c::show(all.cells, shown.cells, shown.cell_count);
        c::show(all.hidden, shown.hidden, shown.hidden_count);
        c::give(arrays, shown, "arrays");
    });
}

signum_status signum_space_tessellation_vertices(const signum_space_tessellation* tessellation,
                                                 double* vertices, int64_t count,
                                                 signum_error* error) {
    return with(tessellation, error, [&] {
        const auto& [sites, made] = tessellation->result;
        c::expect_room(vertices, count, 4 * made.cells.size(), "numbers of vertices");
        const std::vector<SpaceVertex> all = c::with_sites(
            sites, [&made = made](auto of_type) { return signum::vertices(made, of_type); });
        std::copy_n(reinterpret_cast<const double*>(all.data()), count, vertices);
    });
}

signum_status signum_validate_space(const signum_space_arrays* arrays, const double* sites,
                                    int64_t count, int64_t stride, const signum_options* options,
                                    signum_validation* validation, signum_error* error) {
    return guarded(error, [&] {
        expect(arrays, "arrays");
        expect(validation, "validation");
        const signum_space_arrays given =
            c::read(arrays, signum_space_arrays SIGNUM_SPACE_ARRAYS, "arrays");
        c::expect_array(given.cells, given.cell_count, "cells");
        c::expect_array(given.neighbours, given.cell_count, "neighbours");
        c::expect_array(given.hidden, given.hidden_count, "hidden sites");
        SpaceTessellation all{
            .dimension = given.dimension,
            .sites = given.sites,
            .cells = c::rows_from<SpaceCell>(given.cells, given.cell_count),
            .neighbours = c::rows_from<SpaceCell>(given.neighbours, given.cell_count),
            .hidden = c::rows_from<Hidden>(given.hidden, given.hidden_count)};
        const c::Asked asked = c::asked(options);
        const ValidationOptions watched = c::for_validation(asked);
        const c::SpaceSites copy = c::space_sites(sites, count, stride, asked.weight_is);
        const Validation judgement =
            c::with_sites(copy, [&](auto of_type) { return validate(all, of_type, watched); });
        validation->valid = judgement.valid;
        validation->canonical = judgement.canonical;
        c::write(validation->message, judgement.message);
    });
}
