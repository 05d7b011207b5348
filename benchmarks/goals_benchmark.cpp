/// What signum is to reach, and what it does: ratios in one run, each time from a fresh process,
/// the two sides of a ratio in turn.
///
/// usage: goals_benchmark [SITES [ROUNDS [GROUP]]]      1000000 sites, 5 rounds, all groups
/// Groups: threads, CGAL, space, discs, squares, exact, sizes, hub.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../core/parallel.hpp"
#include "../tool/generate/generate.hpp"
#include "../tool/io/output_file.hpp"
#include "../tool/io/read_sites.hpp"
#include "../tool/io/threads.hpp"
#include "../tool/io/write_sites.hpp"
#include "../tool/io/write_tessellation.hpp"
#include "../triangulation/space/triangulate.hpp"
#include "../triangulation/triangulate.hpp"
#include "../triangulation/validate.hpp"
#include "../voronoi/balls/diagram.hpp"
#include "../voronoi/clip.hpp"
#include "../voronoi/space/cells.hpp"

#include "cgal_constructions.hpp"
#include "measuring.hpp"

namespace signum::benchmarks {
namespace {

/// Prepares what is needed, and returns what is timed.
using Prepare = std::function<std::function<void()>()>;

/// Wall-clock seconds of the work in a process of its own;
/// below 0 where the process failed.
double in_fresh_process(const Prepare& prepare) {
    int ends[2];
    if (::pipe(ends) != 0) return -1.0;
    const ::pid_t child = ::fork();
    if (child == 0) {
        const std::function<void()> work = prepare();
        const auto begin = std::chrono::steady_clock::now();
        work();
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const bool is_told = ::write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
        ::_exit(is_told ? 0 : 1);
    }
    ::close(ends[1]);
    double seconds = -1.0;
    if (child < 0 || ::read(ends[0], &seconds, sizeof seconds) != sizeof seconds) seconds = -1.0;
    ::close(ends[0]);
    if (child > 0) ::waitpid(child, nullptr, 0);
    return seconds;
}

/// How much longer `more` takes than `less`, both a unit of work.
struct Goal {
    std::string group;
    std::string work;
    double bound;
    bool at_least;
    Prepare more;
    Prepare less;
    double more_units = 1.0;
    double less_units = 1.0;
};

class Table {
 public:
    Table(int rounds, std::string_view group) : rounds_(rounds), group_(group) {
        fmt::print("| | work | goal | ratio | seconds |\n|:--|:--|--:|--:|--:|\n");
    }

    void row(const Goal& goal) {
        if (!group_.empty() && goal.group != group_) return;
        std::vector<double> ratios, more, less;
        for (int round = 0; round < rounds_; ++round) {
            more.push_back(in_fresh_process(goal.more) / goal.more_units);
            less.push_back(in_fresh_process(goal.less) / goal.less_units);
            if (more.back() < 0.0 || less.back() < 0.0) {
                fmt::print("| {} | {} | | a process failed | |\n", goal.group, goal.work);
                return;
            }
            ratios.push_back(more.back() / less.back());
        }
        const double ratio = median(ratios);
        const bool is_reached = goal.at_least ? ratio >= goal.bound : ratio <= goal.bound;
        fmt::print("| {} | {} | {} {} | {}{:.2f}{} ({:.2f}–{:.2f}) | {:.3g} / {:.3g} |\n",
                   goal.group, goal.work, goal.at_least ? "≥" : "≤", goal.bound,
                   is_reached ? "" : "**", ratio, is_reached ? "" : "**", std::ranges::min(ratios),
                   std::ranges::max(ratios), median(more), median(less));
        std::fflush(stdout);
    }

 private:
    int rounds_;
    std::string group_;
};

std::vector<Site> sites_of(Distribution distribution, std::int64_t count, double radius) {
    const double spacing = 700.0 / std::sqrt(static_cast<double>(count));
    return generate(distribution, {.count = count, .radius_to = radius * spacing});
}

Prepare ours(Distribution distribution, std::int64_t count, double radius, Metric metric,
             Options options) {
    return [=]() -> std::function<void()> {
        return [sites = sites_of(distribution, count, radius), metric, options] {
            static_cast<void>(triangulate(sites, metric, options));
        };
    };
}
Prepare cgals(Distribution distribution, std::int64_t count, double radius,
              Construction (*made)(const std::vector<Site>&)) {
    return [=]() -> std::function<void()> {
        return [construct = made(sites_of(distribution, count, radius))] {
            static_cast<void>(construct());
        };
    };
}
std::vector<Site3> balls_of(SpaceDistribution distribution, std::int64_t count, double radius) {
    const double spacing = 700.0 / std::cbrt(static_cast<double>(count));
    return generate(distribution, {.count = count, .radius_to = radius * spacing});
}

/// Gone when the process ends.
int nameless_file() {
    char name[] = "/tmp/goals_XXXXXX";
    const int file = ::mkstemp(name);
    ::unlink(name);
    return file;
}

Prepare in_space(SpaceDistribution distribution, std::int64_t count, double radius, bool by_cgal,
                 int threads) {
    return [=]() -> std::function<void()> {
        std::vector<Site3> sites = balls_of(distribution, count, radius);
        if (by_cgal)
            return [construct = cgal::in_space(sites, radius > 0.0)] {
                static_cast<void>(construct());
            };
        return [sites = std::move(sites), threads] {
            static_cast<void>(triangulate(sites, Power{}, {.threads = threads}));
        };
    };
}

void threads(Table& table, std::int64_t n) {
    const auto goal = [&](std::string work, const auto& with) {
        table.row({"threads", std::move(work), 1.75, true, with(1), with(2)});
    };
    for (const Metric metric : all_metrics)
        goal(fmt::format("{}, {} random sites, two threads", name_of(metric), n), [&](int count) {
            return ours(Distribution::random, n, 0.4, metric, {.threads = count});
        });
    goal(fmt::format("space, {} random sites", n),
         [&](int count) { return in_space(SpaceDistribution::random, n, 0.4, false, count); });
    for (const Metric metric : all_metrics)
        goal(fmt::format("validate, {}, {}", name_of(metric), n / 4), [&](int count) -> Prepare {
            return [=]() -> std::function<void()> {
                auto sites = sites_of(Distribution::random, n / 4, 0.4);
                auto arrays = triangulate(sites, metric).arrays();
                return [sites = std::move(sites), arrays = std::move(arrays), count] {
                    static_cast<void>(validate(arrays, sites, {.threads = count}));
                };
            };
        });
    goal(fmt::format("diagram of {} random balls", n / 100), [&](int count) -> Prepare {
        return [=]() -> std::function<void()> {
            return [balls = balls_of(SpaceDistribution::random, n / 100, 0.4), count] {
                static_cast<void>(ball_diagram(balls, {.threads = count}));
            };
        };
    });
    goal(fmt::format("areas of {} cells of the plane", n), [&](int count) -> Prepare {
        return [=]() -> std::function<void()> {
            return [built = triangulate(sites_of(Distribution::random, n, 0.4), Power{}), count] {
                const Voronoi voronoi(built, {.merge = false, .threads = count});
                const ClippedVoronoi clipped(voronoi, {0.0, 0.0, 700.0, 700.0},
                                             Lengths::of_the_plane, count);
                static_cast<void>(measures(clipped, count));
            };
        };
    });
    goal(fmt::format("volumes of {} cells of space", n / 10), [&](int count) -> Prepare {
        return [=]() -> std::function<void()> {
            auto balls = balls_of(SpaceDistribution::random, n / 10, 0.4);
            auto built = triangulate(balls, Power{});
            return [balls = std::move(balls), built = std::move(built), count] {
                static_cast<void>(space_cells(built, balls, default_box(balls), count));
            };
        };
    });
    goal(fmt::format("{} sites of text read", n), [&](int count) -> Prepare {
        return [=]() -> std::function<void()> {
            const int file = nameless_file();
            DescriptorStream out(file, "sites");
            write_sites(out, sites_of(Distribution::random, n, 0.4), SitesFormat::text);
            out.flush();
            return [file, count] {
                threads_of_files = count;
                static_cast<void>(read_sites(fmt::format("/proc/self/fd/{}", file), {}));
            };
        };
    });
    goal(fmt::format("faces of {} sites written as JSON", n), [&](int count) -> Prepare {
        return [=]() -> std::function<void()> {
            return [built = triangulate(sites_of(Distribution::random, n, 0.4), Power{}), count] {
                threads_of_files = count;
                DescriptorStream out(nameless_file(), "faces");
                write_json(out, built);
                out.flush();
            };
        };
    });
}

constexpr Distribution distributions[] = {
    Distribution::random, Distribution::grid,  Distribution::lattice, Distribution::circle,
    Distribution::square, Distribution::rings, Distribution::offset};

void beside_cgal(Table& table, std::int64_t n) {
    for (const double radius : {0.0, 1.0})
        for (const Distribution distribution : distributions)
            for (const Order order : all_orders)
                table.row(
                    {"CGAL",
                     fmt::format("{} {}, order {}", radius > 0.0 ? "regular" : "Delaunay",
                                 name_of(distribution), name_of(order)),
                     order == Order::curve ? 2.5 : 2.2, true,
                     cgals(distribution, n, radius, radius > 0.0 ? cgal::regular : cgal::delaunay),
                     ours(distribution, n, radius, Metric::power, {.order = order, .threads = 1})});
    for (const SpaceDistribution distribution : all_space_distributions)
        for (const double radius : {0.0, 1.0})
            table.row({"space",
                       fmt::format("{}{}", radius > 0.0 ? "regular " : "", name_of(distribution)),
                       3.0, true, in_space(distribution, n * 3 / 10, radius, true, 1),
                       in_space(distribution, n * 3 / 10, radius, false, 1)});
    for (const Distribution distribution : distributions)
        table.row({"discs", fmt::format("{}, CGAL's Apollonius hierarchy", name_of(distribution)),
                   10.0, true, cgals(distribution, n / 20, 0.1, cgal::apollonius),
                   ours(distribution, n / 20, 0.1, Metric::euclidean, {.threads = 1})});
    table.row({"discs", "supremum, random points, CGAL's", 12.0, true,
               cgals(Distribution::random, n / 20, 0.0, cgal::linf),
               ours(Distribution::random, n / 20, 0.0, Metric::supremum, {.threads = 1})});
}

void alone(Table& table, std::int64_t n) {
    const Options one{.threads = 1};
    for (const Metric metric : {Metric::manhattan, Metric::supremum})
        table.row({"squares", fmt::format("{} against power, random", name_of(metric)), 1.5, false,
                   ours(Distribution::random, n / 4, 0.4, metric, one),
                   ours(Distribution::random, n / 4, 0.4, Metric::power, one)});
    const Options naive{.arithmetic = Arithmetic::naive, .threads = 1};
    for (const Distribution distribution :
         {Distribution::random, Distribution::grid, Distribution::lattice})
        table.row({"exact", fmt::format("exact against doubles, {}", name_of(distribution)),
                   distribution == Distribution::random ? 1.03 : 1.5, false,
                   ours(distribution, n, 0.0, Metric::power, one),
                   ours(distribution, n, 0.0, Metric::power, naive)});
    table.row({"sizes", fmt::format("{} sites against {}, a site", 10 * n, n), 1.2, false,
               ours(Distribution::random, 10 * n, 0.4, Metric::power, one),
               ours(Distribution::random, n, 0.4, Metric::power, one), 10.0, 1.0});
    const auto hub = [n]() -> std::function<void()> {
        std::vector<Site> sites = {{0.0, 0.0, 300.0}};
        const auto rim = static_cast<double>(n / 10);
        for (double i = 0.0; i < rim; ++i)
            sites.push_back(
                {301.0 * std::cos(6.28318 * i / rim), 301.0 * std::sin(6.28318 * i / rim), 0.002});
        return [sites = std::move(sites)] { static_cast<void>(triangulate(sites, Euclidean{})); };
    };
    table.row({"hub",
               fmt::format("a disc with {} small ones on its rim, against random, a site", n / 10),
               10.0, false, hub, ours(Distribution::random, n / 10, 0.4, Metric::euclidean, {})});
}

int run(std::int64_t count, int rounds, std::string_view group) {
    Table table(rounds, group);
    threads(table, count);
    if (cgal::is_there) beside_cgal(table, count);
    alone(table, count);
    return 0;
}

}  // namespace
}  // namespace signum::benchmarks

int main(int count, char** arguments) {
    const auto number = [&](int place, int otherwise) {
        return place < count ? std::atoi(arguments[place]) : otherwise;
    };
    return signum::benchmarks::run(number(1, 1'000'000), number(2, 5),
                                   count > 3 ? arguments[3] : "");
}
