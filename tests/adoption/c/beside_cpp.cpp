/// signum.h answers what the C++ library answers, of the same sites.

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <signum/signum.h>
#include <signum/signum.hpp>

namespace {

int mistakes = 0;
void expect(bool holds, const char* what, int about) {
    if (holds) return;
    std::fprintf(stderr, "%s (%d) is not as in C++\n", what, about);
    ++mistakes;
}

/// Small integers without order, so that ties abound.
std::vector<double> numbers(std::size_t count, std::uint32_t seed, std::uint32_t below) {
    std::vector<double> all(count);
    for (double& number : all) {
        seed = seed * 1664525u + 1013904223u;
        number = (seed >> 16) % below;
    }
    return all;
}

template <class Array>
bool same(const std::int32_t* of_c, std::int64_t count, const Array& of_cpp) {
    using Element = typename Array::value_type;
    return count == static_cast<std::int64_t>(of_cpp.size()) &&
           (count == 0 || std::memcmp(of_c, of_cpp.data(), sizeof(Element) * of_cpp.size()) == 0);
}

void in_the_plane(signum::Metric metric) {
    const auto which = static_cast<signum_metric>(metric);
    const std::vector<double> sites = numbers(std::size_t{4} * 300, 7, 40);
    std::vector<signum::Site> copies;
    for (std::size_t i = 0; i < 300; ++i)
        copies.push_back({sites[4 * i], sites[4 * i + 1], sites[4 * i + 2] / 16});
    std::vector<double> rows;
    for (const signum::Site& site : copies) rows.insert(rows.end(), {site.x, site.y, site.r, -1.0});

    const signum::Tessellation expected = signum::triangulate(copies, metric);
    signum_tessellation* t = nullptr;
    signum_arrays a = SIGNUM_ARRAYS;
    expect(signum_triangulate(rows.data(), 300, 4, which, nullptr, &t, nullptr) == SIGNUM_OK &&
               signum_tessellation_arrays(t, &a, nullptr) == SIGNUM_OK,
           "triangulate", which);
    expect(same(a.faces, a.face_count, expected.arrays().faces) &&
               same(a.neighbours, a.face_count, expected.arrays().neighbours) &&
               same(a.hidden, a.hidden_count, expected.arrays().hidden),
           "arrays", which);

    std::vector<double> vertices(3 * expected.faces().size());
    signum_tessellation_vertices(t, vertices.data(), static_cast<std::int64_t>(vertices.size()),
                                 nullptr);
    const auto of_cpp = signum::vertices(expected);
    expect(std::memcmp(vertices.data(), of_cpp.data(), vertices.size() * sizeof(double)) == 0,
           "vertices", which);

    signum_voronoi* d = nullptr;
    std::vector<double> areas(300);
    const double box[] = {-1, -2, 41, 42};
    signum_voronoi_create(t, 0, &d, nullptr);
    expect(signum_voronoi_areas(d, box, areas.data(), 300, nullptr) == SIGNUM_OK, "areas", which);
    const signum::Voronoi diagram = signum::voronoi(expected);
    const signum::ClippedVoronoi clipped(diagram, {-1, -2, 41, 42});
    double sum = 0;
    for (signum::Index i = 0; i < 300; ++i) {
        sum += areas[static_cast<std::size_t>(i)];
        expect(areas[static_cast<std::size_t>(i)] == signum::measure(clipped.cell(i)).area, "area",
               i);
    }
    expect(sum > 42 * 44 - 1e-6 && sum < 42 * 44 + 1e-6, "sum of areas", which);
    signum_voronoi_free(d);
    signum_tessellation_free(t);
}

void predicates() {
    const std::vector<double> all = numbers(4000, 3, 5);
    for (std::size_t n = 0; n + 20 <= all.size(); n += 20) {
        const double *i = &all[n], *j = i + 4, *k = j + 4, *l = k + 4, *q = l + 4;
        const auto disc = [](const double* s) { return signum::Site{s[0], s[1], s[2]}; };
        const auto ball = [](const double* s) { return signum::Site3{s[0], s[1], s[2], s[3]}; };
        const auto about = static_cast<int>(n);
        expect(signum_ccw(i, j, k) == signum::ccw(disc(i), disc(j), disc(k)), "ccw", about);
        expect(signum_exists(SIGNUM_EUCLIDEAN, i, j, k) ==
                   static_cast<int>(signum::euclidean::exists(disc(i), disc(j), disc(k))),
               "exists", about);
        expect(signum_hidden(SIGNUM_MANHATTAN, q, i) ==
                   static_cast<int>(signum::manhattan::hidden(disc(q), disc(i))),
               "hidden in Manhattan", about);
        expect(signum_hidden(SIGNUM_SUPREMUM, q, i) ==
                   static_cast<int>(signum::supremum::hidden(disc(q), disc(i))),
               "hidden in the supremum metric", about);
        if (signum::ccw(disc(i), disc(j), disc(k)) > 0)
            expect(signum_in_circle(SIGNUM_POWER, i, j, k, q) ==
                       signum::power::in_circle(disc(i), disc(j), disc(k), disc(q)),
                   "in_circle", about);
        const auto octahedra = signum::manhattan::spheres(ball(i), ball(j), ball(k), ball(l));
        const auto cubes = signum::supremum::spheres(ball(i), ball(j), ball(k), ball(l));
        expect(signum_spheres(SIGNUM_MANHATTAN, i, j, k, l) ==
                   (octahedra.infinitely_many ? SIGNUM_INFINITELY_MANY : octahedra.count),
               "octahedra", about);
        expect(signum_spheres(SIGNUM_SUPREMUM, i, j, k, l) ==
                   (cubes.infinitely_many ? SIGNUM_INFINITELY_MANY : cubes.count),
               "cubes", about);
        for (std::uint8_t sphere = 0; sphere < cubes.count && !cubes.infinitely_many; ++sphere)
            expect(signum_in_sphere(SIGNUM_SUPREMUM, i, j, k, l, q, sphere) ==
                       signum::supremum::in_sphere(ball(i), ball(j), ball(k), ball(l), ball(q),
                                                   sphere),
                   "in_sphere", about);
        expect(signum_spheres(SIGNUM_EUCLIDEAN, i, j, k, l) ==
                   static_cast<int>(signum::euclidean::exists(ball(i), ball(j), ball(k), ball(l))),
               "spheres", about);
    }
}

void in_space() {
    const std::vector<double> rows = numbers(std::size_t{4} * 200, 5, 12);
    std::vector<signum::Site3> copies;
    for (std::size_t i = 0; i < 200; ++i)
        copies.push_back({rows[4 * i], rows[4 * i + 1], rows[4 * i + 2], rows[4 * i + 3]});
    const signum::SpaceTessellation expected = signum::triangulate(copies, signum::Power{});
    signum_space_tessellation* t = nullptr;
    signum_space_arrays a = SIGNUM_SPACE_ARRAYS;
    expect(signum_triangulate_space(rows.data(), 200, 4, nullptr, &t, nullptr) == SIGNUM_OK &&
               signum_space_tessellation_arrays(t, &a, nullptr) == SIGNUM_OK,
           "triangulate_space", 0);
    expect(a.dimension == 3 && same(a.cells, a.cell_count, expected.cells) &&
               same(a.neighbours, a.cell_count, expected.neighbours) &&
               same(a.hidden, a.hidden_count, expected.hidden),
           "space_arrays", 0);
    std::vector<double> vertices(4 * expected.cells.size());
    signum_space_tessellation_vertices(t, vertices.data(),
                                       static_cast<std::int64_t>(vertices.size()), nullptr);
    const auto of_cpp = signum::vertices(expected, copies);
    for (std::size_t c = 0; c < of_cpp.size(); ++c)
        expect(std::memcmp(&vertices[4 * c], &of_cpp[c].x, sizeof(double)) == 0 ||
                   (of_cpp[c].x != of_cpp[c].x && vertices[4 * c] != vertices[4 * c]),
               "vertex", static_cast<int>(c));
    signum_space_tessellation_free(t);
}

// The numbers of C are those of C++.
static_assert(SIGNUM_SUPREMUM == static_cast<int>(signum::Metric::supremum));
static_assert(SIGNUM_MANHATTAN == static_cast<int>(signum::Metric::manhattan));
static_assert(SIGNUM_EUCLIDEAN == static_cast<int>(signum::Metric::euclidean));
static_assert(SIGNUM_NAIVE == static_cast<int>(signum::Arithmetic::naive));
static_assert(SIGNUM_SINGLE == static_cast<int>(signum::Arithmetic::single));
static_assert(SIGNUM_INTERVAL == static_cast<int>(signum::Arithmetic::interval));
static_assert(SIGNUM_SUM == static_cast<int>(signum::Arithmetic::sum));
static_assert(SIGNUM_MULTIPRECISION == static_cast<int>(signum::Arithmetic::multiprecision));
static_assert(SIGNUM_FLIPS == static_cast<int>(signum::Method::flips));
static_assert(SIGNUM_SWEEP == static_cast<int>(signum::Method::sweep));
static_assert(SIGNUM_STRIKES == static_cast<int>(signum::motion::Ending::strikes));
static_assert(SIGNUM_NOTHING == static_cast<int>(signum::motion::Ending::nothing));
static_assert(SIGNUM_STOPPED_BY_CALLER == static_cast<int>(signum::motion::Ending::stopped));
static_assert(SIGNUM_COLLAPSE == static_cast<int>(signum::motion::Ending::collapse));

}  // namespace

int main() {
    for (const signum::Metric metric : signum::all_metrics) in_the_plane(metric);
    predicates();
    in_space();
    return mistakes == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
