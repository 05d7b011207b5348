/// What many cores would do where there are few: work and critical path of constructions in parts.
///
/// Workers of this program's own run every task on one thread, one after the other, and add up
/// processor time: all of it (work), and along the longest chain of tasks that follow one another
/// (path). A scheduler that lets no core be idle while there is a task takes no longer on p cores
/// than (work - path) / p + path (Brent 1974). What cores lack when all of them ask for memory at
/// once is not in it.
///
/// usage: critical_path_benchmark [SITES [CORES]]      10000000 sites, 16 cores

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../core/parallel.hpp"
#include "../tool/generate/generate.hpp"
#include "../triangulation/space/triangulate.hpp"
#include "../triangulation/triangulate.hpp"

namespace signum {
namespace {

double processor_seconds() {
    std::timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Seconds {
    double work = 0.0;
    double path = 0.0;
};
Seconds so_far;     // of the task that runs
double mark = 0.0;  // up to where its time is in it

void add_up() {
    const double now = processor_seconds();
    so_far.work += now - mark;
    so_far.path += now - mark;
    mark = now;
}

}  // namespace

// In place of the library's: core/parallel.cpp is not linked.

struct Workers::Threads {};

int usable_cores() noexcept {
    return 1;
}
Workers::Workers(int threads, std::size_t items)
    : count_(items < few_items ? 1 : std::max(threads, 1)) {}
Workers::~Workers() = default;

void Workers::each(std::size_t tasks, const std::function<void(std::size_t)>& task) const {
    add_up();
    const Seconds before = std::exchange(so_far, {});
    Seconds all;
    for (std::size_t i = 0; i < tasks; ++i) {
        task(i);
        add_up();
        const Seconds one = std::exchange(so_far, {});
        all.work += one.work;
        all.path = count_ == 1 ? all.path + one.path : std::max(all.path, one.path);
    }
    so_far = {before.work + all.work, before.path + all.path};
}

namespace {

Seconds seconds_of(const std::function<void()>& construct) {
    so_far = {};
    mark = processor_seconds();
    construct();
    add_up();
    return so_far;
}

void row(const std::string& name, int cores, const std::function<void(int)>& construct) {
    const double one = seconds_of([&] { construct(1); }).work;
    const Seconds many = seconds_of([&] { construct(cores); });
    const double bound = (many.work - many.path) / cores + many.path;
    fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} | {:.1f} |\n", name, one, many.work, many.path,
               one / bound);
    std::fflush(stdout);
}

int run(std::int64_t count, int cores) {
    fmt::print("| {} random sites | one thread, s | work for {} | path | ratio at least |\n"
               "|:--|--:|--:|--:|--:|\n",
               count, cores);
    const std::vector<Site> sites =
        generate(Distribution::random, {.count = count, .radius_to = 0.1});
    for (const Metric metric : all_metrics)
        row(std::string(name_of(metric)), cores, [&](int threads) {
            static_cast<void>(triangulate(sites, metric, {.threads = threads}));
        });
    const std::vector<Site3> balls =
        generate(SpaceDistribution::random, {.count = count, .radius_to = 0.1});
    row("space", cores, [&](int threads) {
        static_cast<void>(triangulate(balls, Power{}, {.threads = threads}));
    });
    return 0;
}

}  // namespace
}  // namespace signum

int main(int count, char** arguments) {
    const auto number = [&](int place, int otherwise) {
        return place < count ? std::atoi(arguments[place]) : otherwise;
    };
    return signum::run(number(1, 10'000'000), number(2, 16));
}
