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

/// The predicates of one metric beside those that C asks by its number, whatever they say.
struct Plane {
    signum_metric metric;
    bool (*exists)(const signum::Site&, const signum::Site&, const signum::Site&);
    signum::Sign (*in_circle)(const signum::Site&, const signum::Site&, const signum::Site&,
                              const signum::Site&);
    signum::Sign (*in_circle_infinite)(const signum::Site&, const signum::Site&,
                                       const signum::Site&);
    signum::Sign (*in_circle_perturbed)(const signum::Site&, const signum::Site&,
                                        const signum::Site&, const signum::Site&,
                                        const std::array<signum::Index, 4>&);
    signum::Sign (*in_circle_infinite_perturbed)(const signum::Site&, const signum::Site&,
                                                 const signum::Site&,
                                                 const std::array<signum::Index, 3>&);
    bool (*hidden)(const signum::Site&, const signum::Site&);
    signum::Sign (*nearer)(signum::Point, const signum::Site&, const signum::Site&);
};
template <class Site>
constexpr Plane power_of = {SIGNUM_POWER,
                            signum::power::exists<Site>,
                            signum::power::in_circle<Site>,
                            signum::power::in_circle_infinite<Site>,
                            signum::power::in_circle_perturbed<Site>,
                            signum::power::in_circle_infinite_perturbed<Site>,
                            signum::power::hidden<Site>,
                            signum::power::nearer<Site>};
constexpr Plane plane[] = {
    power_of<signum::Site>,
    {SIGNUM_EUCLIDEAN, signum::euclidean::exists, signum::euclidean::in_circle,
     signum::euclidean::in_circle_infinite, signum::euclidean::in_circle_perturbed,
     signum::euclidean::in_circle_infinite_perturbed, signum::euclidean::hidden,
     signum::euclidean::nearer},
    {SIGNUM_MANHATTAN, signum::manhattan::exists, signum::manhattan::in_circle,
     signum::manhattan::in_circle_infinite, signum::manhattan::in_circle_perturbed,
     signum::manhattan::in_circle_infinite_perturbed, signum::manhattan::hidden,
     signum::manhattan::nearer},
    {SIGNUM_SUPREMUM, signum::supremum::exists, signum::supremum::in_circle,
     signum::supremum::in_circle_infinite, signum::supremum::in_circle_perturbed,
     signum::supremum::in_circle_infinite_perturbed, signum::supremum::hidden,
     signum::supremum::nearer}};

void predicates_of_the_plane(const Plane& m, const double* i, const double* j, const double* k,
                             const double* q, int about) {
    const auto disc = [](const double* s) { return signum::Site{s[0], s[1], s[2]}; };
    const signum::Site a = disc(i), b = disc(j), c = disc(k), d = disc(q);
    const std::int32_t four[] = {2, 0, 3, 1};
    const std::int32_t three[] = {2, 0, 1};
    expect(signum_hidden(m.metric, q, i) == int(m.hidden(d, a)), "hidden", about);
    expect(signum_nearer(m.metric, q, i, j) == m.nearer({q[0], q[1]}, a, b), "nearer", about);
    const bool exists = m.exists(a, b, c);
    expect(signum_exists(m.metric, i, j, k) == int(exists), "exists", about);
    const auto hides = [&](const signum::Site& s, const signum::Site& t) {
        return m.hidden(s, t) || m.hidden(t, s);
    };
    if (!hides(a, b)) {
        expect(signum_in_circle_infinite(m.metric, i, j, q) == m.in_circle_infinite(a, b, d),
               "in_circle_infinite", about);
        expect(signum_in_circle_infinite_perturbed(m.metric, i, j, q, three) ==
                   m.in_circle_infinite_perturbed(a, b, d, {2, 0, 1}),
               "in_circle_infinite_perturbed", about);
    }
    if (!exists || m.hidden(d, a) || m.hidden(d, b) || m.hidden(d, c)) return;
    expect(signum_in_circle(m.metric, i, j, k, q) == m.in_circle(a, b, c, d), "in_circle", about);
    expect(signum_in_circle_perturbed(m.metric, i, j, k, q, four) ==
               m.in_circle_perturbed(a, b, c, d, {2, 0, 3, 1}),
           "in_circle_perturbed", about);
}

/// Of a metric with several spheres: each of them.
template <class Spheres, class InSphere>
void spheres_beside(signum_metric metric, const Spheres& spheres, const InSphere& in_sphere,
                    const double* i, const double* j, const double* k, const double* l,
                    const double* q, int about) {
    expect(signum_spheres(metric, i, j, k, l) ==
               (spheres.infinitely_many ? SIGNUM_INFINITELY_MANY : spheres.count),
           "spheres", about);
    for (std::uint8_t n = 0; n < spheres.count && !spheres.infinitely_many; ++n)
        expect(signum_in_sphere(metric, i, j, k, l, q, n) == in_sphere(n), "in_sphere", about);
}

void predicates() {
    const std::vector<double> all = numbers(4000, 3, 5);
    for (std::size_t n = 0; n + 20 <= all.size(); n += 20) {
        const double *i = &all[n], *j = i + 4, *k = j + 4, *l = k + 4, *q = l + 4;
        const auto ball = [](const double* s) { return signum::Site3{s[0], s[1], s[2], s[3]}; };
        const signum::Site3 a = ball(i), b = ball(j), c = ball(k), d = ball(l), e = ball(q);
        const auto about = static_cast<int>(n);
        expect(signum_ccw(i, j, k) == signum::ccw({i[0], i[1]}, {j[0], j[1]}, {k[0], k[1]}), "ccw",
               about);
        for (const Plane& metric : plane) predicates_of_the_plane(metric, i, j, k, q, about);

        const bool turn = signum::ccw(a, b, c, d) > 0;
        expect(signum_spheres(SIGNUM_POWER, i, j, k, l) == int(turn), "spheres, power", about);
        if (turn)
            expect(signum_in_sphere(SIGNUM_POWER, i, j, k, l, q, 0) ==
                       signum::power::in_sphere(a, b, c, d, e),
                   "in_sphere, power", about);
        const bool touched = signum::euclidean::exists(a, b, c, d);
        expect(signum_spheres(SIGNUM_EUCLIDEAN, i, j, k, l) == int(touched), "spheres, Euclidean",
               about);
        if (touched)
            expect(signum_in_sphere(SIGNUM_EUCLIDEAN, i, j, k, l, q, 0) ==
                       signum::euclidean::in_sphere(a, b, c, d, e),
                   "in_sphere, Euclidean", about);
        spheres_beside(
            SIGNUM_MANHATTAN, signum::manhattan::spheres(a, b, c, d),
            [&](std::uint8_t s) { return signum::manhattan::in_sphere(a, b, c, d, e, s); }, i, j, k,
            l, q, about);
        spheres_beside(
            SIGNUM_SUPREMUM, signum::supremum::spheres(a, b, c, d),
            [&](std::uint8_t s) { return signum::supremum::in_sphere(a, b, c, d, e, s); }, i, j, k,
            l, q, about);
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
        expect(std::memcmp(&vertices[4 * c], &of_cpp[c], 4 * sizeof(double)) == 0, "vertex",
               static_cast<int>(c));
    signum_space_tessellation_free(t);
}

// The numbers of C are those of C++; structure/metric_test has those of metrics.
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
