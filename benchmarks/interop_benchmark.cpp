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
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../bindings/interop/cgal.hpp"

#include "interleaved.hpp"

namespace signum::benchmarks {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = cgal::Traits<Kernel>;

using P2 = Kernel::Point_2;
using P3 = Kernel::Point_3;
using Random = std::mt19937_64;
double uniform(Random& random) {
    return std::uniform_real_distribution<double>(0.0, 1.0)(random);
}
double normal(Random& random) {
    return std::normal_distribution<double>()(random);
}

/// As many as make(random) gives.
auto many(std::int64_t n, auto make) {
    Random random(1);
    std::vector<decltype(make(random))> points;
    while (std::ssize(points) < n) points.push_back(make(random));
    return points;
}
std::vector<P2> square(std::int64_t n) {
    return many(n, [](Random& random) {
        const double x = uniform(random);
        return P2(x, uniform(random));
    });
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
std::vector<P2> circle(std::int64_t n) {
    return many(n, [](Random& random) {
        const double angle = 2.0 * std::numbers::pi * uniform(random);
        return P2(std::cos(angle), std::sin(angle));
    });
}
std::vector<P3> cube(std::int64_t n) {
    return many(n, [](Random& random) {
        const double x = uniform(random);
        const double y = uniform(random);
        return P3(x, y, uniform(random));
    });
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
std::vector<P3> sphere(std::int64_t n) {
    return many(n, [](Random& random) {
        const double x = normal(random);
        const double y = normal(random);
        const double z = normal(random);
        const double r = std::sqrt(x * x + y * y + z * z);
        return P3(x / r, y / r, z / r);
    });
}
/// Points that weigh up to `largest`, or all the same.
template <class P>
auto weighted(const std::vector<P>& points, double largest) {
    using Weighted =
        std::conditional_t<std::same_as<P, P2>, Kernel::Weighted_point_2, Kernel::Weighted_point_3>;
    Random random(2);
    std::vector<Weighted> result;
    for (const P& p : points) result.emplace_back(p, largest * uniform(random));
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
    const double in_plane = 1.0 / static_cast<double>(n);
    const double in_space = std::pow(static_cast<double>(n), -2.0 / 3.0);
    Contest contest;
    contest.add<Delaunay2>("Delaunay_triangulation_2, random", square(n));
    contest.add<Delaunay2>("Delaunay_triangulation_2, grid", grid(n));
    contest.add<Delaunay2>("Delaunay_triangulation_2, turned grid", turned_grid(n));
    contest.add<Delaunay2>("Delaunay_triangulation_2, circle", circle(n / 10));
    contest.add<Regular2>("Regular_triangulation_2, random", weighted(square(n), in_plane));
    contest.add<Regular2>("Regular_triangulation_2, grid of equal weights", weighted(grid(n), 0.0));
    contest.add<Regular2>("Regular_triangulation_2, circle", weighted(circle(n / 10), 0.0));
    contest.add<Delaunay3>("Delaunay_triangulation_3, random", cube(n));
    contest.add<Delaunay3>("Delaunay_triangulation_3, lattice", lattice(n));
    contest.add<Delaunay3>("Delaunay_triangulation_3, turned lattice", turned_lattice(n));
    contest.add<Delaunay3>("Delaunay_triangulation_3, sphere", sphere(n / 10));
    contest.add<Regular3>("Regular_triangulation_3, random", weighted(cube(n), in_space));
    contest.add<Regular3>("Regular_triangulation_3, lattice of equal weights",
                          weighted(lattice(n), 0.0));
    contest.add<Regular3>("Regular_triangulation_3, sphere", weighted(sphere(n / 10), 0.0));
    return contest.print(run_interleaved(argc, argv, 7)) ? 0 : 1;
}
