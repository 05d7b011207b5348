/// CGAL's triangulations on signum's predicates beside CGAL's on its own kernel's, interleaved:
/// what bindings/interop/cgal.hpp is worth.
///
/// usage: interop_benchmark [--sites=100000] [Google Benchmark's options]

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/version.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../bindings/interop/cgal.hpp"
#include "../tool/generate/generate.hpp"

#include "interleaved.hpp"

namespace signum::benchmarks {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = cgal::Traits<Kernel>;

using P2 = Kernel::Point_2;
using P3 = Kernel::Point_3;

/// At the centres of generated sites.
std::vector<P2> points(Distribution distribution, std::int64_t n) {
    std::vector<P2> result;
    for (const Site& site : generate(distribution, {.count = n}))
        result.emplace_back(site.x, site.y);
    return result;
}
std::vector<P3> points(SpaceDistribution distribution, std::int64_t n) {
    std::vector<P3> result;
    for (const Site3& site : generate(distribution, {.count = n}))
        result.emplace_back(site.x, site.y, site.z);
    return result;
}
std::vector<P2> grid(std::int64_t n) {
    const auto side = std::llround(std::sqrt(static_cast<double>(n)));
    std::vector<P2> points;
    for (std::int64_t i = 0; i < side * side; ++i)
        points.emplace_back(static_cast<double>(i % side), static_cast<double>(i / side));
    return points;
}
/// The same turned by half a radian: nearly tied.
const double cosine = std::cos(0.5);
const double sine = std::sin(0.5);
std::vector<P2> turned_grid(std::int64_t n) {
    std::vector<P2> points = grid(n);
    for (P2& p : points) p = {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()};
    return points;
}
std::vector<P3> lattice(std::int64_t n) {
    const auto side = std::llround(std::cbrt(static_cast<double>(n)));
    std::vector<P3> points;
    for (std::int64_t i = 0; i < side * side * side; ++i)
        points.emplace_back(static_cast<double>(i % side), static_cast<double>(i / side % side),
                            static_cast<double>(i / side / side));
    return points;
}
std::vector<P3> turned_lattice(std::int64_t n) {
    std::vector<P3> points = lattice(n);
    for (P3& p : points) {
        p = {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y(), p.z()};
        p = {p.x(), cosine * p.y() - sine * p.z(), sine * p.y() + cosine * p.z()};
    }
    return points;
}

/// Points that weigh up to `largest`, or all the same.
template <class P>
auto weighted(const std::vector<P>& points, double largest) {
    using Weighted =
        std::conditional_t<std::same_as<P, P2>, Kernel::Weighted_point_2, Kernel::Weighted_point_3>;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> weight(0.0, largest);
    std::vector<Weighted> result;
    for (const P& p : points) result.emplace_back(p, weight(random));
    return result;
}

template <class K>
using Delaunay2 = CGAL::Delaunay_triangulation_2<K>;
template <class K>
using Regular2 = CGAL::Regular_triangulation_2<K>;
template <class K>
using Delaunay3 = CGAL::Delaunay_triangulation_3<K>;
template <class K>
using Regular3 = CGAL::Regular_triangulation_3<K>;

/// The triangles or tetrahedra, corner by corner, in CGAL's order: the same where all signs are.
template <class Triangulation>
std::size_t hash_of(const Triangulation& triangulation) {
    std::size_t hash = 0;
    const auto add = [&hash](const auto& p) {
        for (auto c = p.cartesian_begin(); c != p.cartesian_end(); ++c)
            hash = hash * 1'000'003 + std::hash<double>{}(*c);
    };
    if constexpr (requires { triangulation.finite_cell_handles(); }) {
        for (const auto c : triangulation.finite_cell_handles())
            for (int k = 0; k < 4; ++k)
                add(triangulation.geom_traits().construct_point_3_object()(c->vertex(k)->point()));
    } else {
        for (const auto f : triangulation.finite_face_handles())
            for (int k = 0; k < 3; ++k)
                add(triangulation.geom_traits().construct_point_2_object()(f->vertex(k)->point()));
    }
    return hash;
}

class Contest {
 public:
    template <template <class> class Triangulation, class P>
    void add(const std::string& name, std::vector<P> points) {
        names_.push_back(name);
        const auto shared = std::make_shared<const std::vector<P>>(std::move(points));
        add_one<Triangulation<Kernel>>(name + ", kernel", shared);
        add_one<Triangulation<Traits>>(name + ", signum", shared);
    }
    /// Whether all results agree.
    [[nodiscard]] bool print(const Measurements& measured) const {
        constexpr double millisecond = 1e-3;
        print_header({"CGAL's", fmt::format("kernel of CGAL {}, ms", CGAL_VERSION_STR),
                      "signum's predicates, ms", "kernel / signum"});
        bool agree = true;
        for (const std::string& name : names_) {
            const std::string kernel = name + ", kernel";
            const std::string ours = name + ", signum";
            if (!measured.has(ours)) continue;  // left out by a filter
            print_row({name, measured.cell(kernel, millisecond), measured.cell(ours, millisecond),
                       measured.ratio(kernel, ours)});
            if (hashes_->at(kernel) != hashes_->at(ours)) {
                fmt::print(stderr, "{}: the results differ\n", name);
                agree = false;
            }
        }
        fmt::print("\n{}\n", measured.footnote());
        return agree;
    }

 private:
    template <class Triangulation, class P>
    void add_one(const std::string& name, std::shared_ptr<const std::vector<P>> points) {
        benchmark::RegisterBenchmark(name.c_str(),
                                     [points, name, hashes = hashes_](benchmark::State& state) {
                                         for (auto _ : state) {
                                             const Triangulation triangulation(points->begin(),
                                                                               points->end());
                                             state.PauseTiming();
                                             (*hashes)[name] = hash_of(triangulation);
                                             state.ResumeTiming();
                                         }
                                     })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }

    std::vector<std::string> names_;
    std::shared_ptr<std::map<std::string, std::size_t>> hashes_ =
        std::make_shared<std::map<std::string, std::size_t>>();
};

}  // namespace
}  // namespace signum::benchmarks

int main(int argc, char** argv) {
    using namespace signum::benchmarks;
    const std::int64_t n = take_sites(argc, argv, 100'000);
    // The squares of the mean distances of neighbours.
    const double in_plane = 700.0 * 700.0 / static_cast<double>(n);
    const double in_space = 700.0 * 700.0 * std::pow(static_cast<double>(n), -2.0 / 3.0);
    const auto square = points(signum::Distribution::random, n);
    const auto circle = points(signum::Distribution::circle, n / 10);
    const auto cube = points(signum::SpaceDistribution::random, n);
    const auto sphere = points(signum::SpaceDistribution::sphere, n / 10);
    Contest contest;
    contest.add<Delaunay2>("Delaunay_triangulation_2, random", square);
    contest.add<Delaunay2>("Delaunay_triangulation_2, grid", grid(n));
    contest.add<Delaunay2>("Delaunay_triangulation_2, turned grid", turned_grid(n));
    contest.add<Delaunay2>("Delaunay_triangulation_2, circle", circle);
    contest.add<Regular2>("Regular_triangulation_2, random", weighted(square, in_plane));
    contest.add<Regular2>("Regular_triangulation_2, grid of equal weights", weighted(grid(n), 0.0));
    contest.add<Regular2>("Regular_triangulation_2, circle", weighted(circle, 0.0));
    contest.add<Delaunay3>("Delaunay_triangulation_3, random", cube);
    contest.add<Delaunay3>("Delaunay_triangulation_3, lattice", lattice(n));
    contest.add<Delaunay3>("Delaunay_triangulation_3, turned lattice", turned_lattice(n));
    contest.add<Delaunay3>("Delaunay_triangulation_3, sphere", sphere);
    contest.add<Regular3>("Regular_triangulation_3, random", weighted(cube, in_space));
    contest.add<Regular3>("Regular_triangulation_3, lattice of equal weights",
                          weighted(lattice(n), 0.0));
    contest.add<Regular3>("Regular_triangulation_3, sphere", weighted(sphere, 0.0));
    return contest.print(run_interleaved(argc, argv, 7)) ? 0 : 1;
}
