/// Threads that share work, and constructions by them: every task once, whatever throws leaves, and
/// who watches is told by the thread that asked.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "../../core/parallel.hpp"
#include "../../triangulation/space/triangulate.hpp"
#include "../../triangulation/triangulate.hpp"

namespace signum {
namespace {

TEST(Workers, AreAsManyAsAskedFor) {
    EXPECT_GE(usable_cores(), 1);
    EXPECT_EQ(Workers(0).count(), usable_cores());
    EXPECT_EQ(Workers(3).count(), 3);
    EXPECT_EQ(Workers(3, few_items - 1).count(), 1);
}

TEST(Workers, AreRefusedWhereThereCannotBeSoMany) {
    EXPECT_THROW(Workers(-1), std::invalid_argument);
    EXPECT_THROW(Workers(most_threads + 1), std::invalid_argument);
    EXPECT_EQ(Workers(most_threads, 1).count(), 1);
}

#if !defined(SIGNUM_WITHOUT_TBB) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
/// Of the address space so much is left that stacks for a few threads fit, not for all.
TEST(WorkersDeathTest, AreAsManyAsCanBeStarted) {
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const auto work = [] {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlim_t most = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + (60 << 20);
        const rlimit limit = {most, most};
        if (::setrlimit(RLIMIT_AS, &limit) != 0) std::exit(1);
        std::atomic<int> done = 0;
        for (const int asked : {64, 3, 200}) {
            const Workers workers(asked);
            if (workers.count() < 1 || workers.count() > 40) std::exit(2);
            workers.each(500, [&](std::size_t) { ++done; });
        }
        std::exit(done == 1500 ? 0 : 3);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(0), "");
}
#endif

TEST(Workers, DoEachTaskOnce) {
    for (const int threads : {1, 2, 5}) {
        std::vector<std::atomic<int>> done(1000);
        Workers(threads).each(done.size(), [&](std::size_t i) { ++done[i]; });
        for (const auto& times : done) ASSERT_EQ(times, 1);
    }
}

TEST(Workers, CutRangesThatMakeUpAll) {
    const Workers workers(4);
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, 3 * few_items + 7}) {
        std::vector<char> done(size, 0);
        workers.each_range(size, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++done[i];
        });
        EXPECT_EQ(std::count(done.begin(), done.end(), 1), static_cast<std::ptrdiff_t>(size));
    }
}

/// Tasks that ask for tasks do not wait for one another.
TEST(Workers, MayShareTheirTasksAgain) {
    const Workers workers(3);
    std::atomic<int> sum = 0;
    workers.each(20, [&](std::size_t) {
        workers.each(20, [&](std::size_t i) { sum += static_cast<int>(i); });
    });
    EXPECT_EQ(sum, 20 * 190);
}

TEST(Workers, ThrowWhatATaskThrows) {
    for (const int threads : {1, 4}) {
        const Workers workers(threads);
        EXPECT_THROW(workers.each(50,
                                  [](std::size_t i) {
                                      if (i == 17) throw std::out_of_range("17");
                                  }),
                     std::out_of_range);
        std::atomic<int> done = 0;
        workers.each(50, [&](std::size_t) { ++done; });
        EXPECT_EQ(done, 50);
    }
}

TEST(Deal, IsStable) {
    for (const int threads : {1, 4}) {
        const Workers workers(threads);
        const std::size_t size = 5 * few_items;
        const auto bucket_of = [](std::size_t i) {
            return i * i % 8;
        };  // 0, 1 and 4; 4 is left out
        std::vector<std::size_t> dealt;
        const auto begins = deal(
            workers, size, 4, bucket_of, [&](std::size_t count) { dealt.resize(count); },
            [&](std::size_t i, std::size_t place) { dealt[place] = i; });
        std::vector<std::size_t> expected(size);
        std::iota(expected.begin(), expected.end(), 0U);
        std::erase_if(expected, [&](std::size_t i) { return bucket_of(i) >= 4; });
        std::ranges::stable_sort(expected, {}, bucket_of);
        EXPECT_EQ(dealt, expected);
        EXPECT_EQ(begins.back(), dealt.size());
        EXPECT_EQ(bucket_of(dealt[begins[1]]), 1U);
    }
}

TEST(MakeRoom, GivesZeros) {
    std::vector<int> a;
    std::vector<double> b;
    make_room(Workers(2), 3 * few_items, a, b);
    EXPECT_EQ(a, std::vector<int>(3 * few_items, 0));
    EXPECT_EQ(b, std::vector<double>(3 * few_items, 0.0));
}

std::vector<Site> spiral(int count) {
    std::vector<Site> sites;
    for (int i = 0; i < count; ++i) {
        const double t = std::sqrt(static_cast<double>(i));
        sites.push_back({t * std::cos(2.4 * i), t * std::sin(2.4 * i), 0.1 * (i % 3)});
    }
    return sites;
}

class ConstructionByThreads : public testing::TestWithParam<Metric> {};

TEST_P(ConstructionByThreads, TellsTheSame) {
    const std::vector<Site> sites = spiral(30'000);
    EXPECT_EQ(triangulate(sites, GetParam(), {.threads = 4}).arrays(),
              triangulate(sites, GetParam(), {.threads = 1}).arrays());
}

TEST_P(ConstructionByThreads, TellsItsCallerHowFarItIs) {
    const std::vector<Site> sites = spiral(60'000);
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<double> told;
    static_cast<void>(triangulate(sites, GetParam(), {.threads = 3, .progress = [&](double share) {
                                                          EXPECT_EQ(std::this_thread::get_id(),
                                                                    caller);
                                                          told.push_back(share);
                                                      }}));
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1.0);
}

/// So many that sites at cuts are cut again; and so that they are not, all being at each cut.
TEST(SpaceByThreads, TellsItsCallerHowFarItIs) {
    for (const bool is_sphere : {false, true}) {
        std::vector<Point3> sites;
        const int count = is_sphere ? 70'000 : 500'000;
        for (const Site& site : spiral(count)) {
            const double turn = 2.4 * static_cast<double>(sites.size());
            const double z = std::sqrt(static_cast<double>(count)) * std::sin(turn * turn);
            const double scale = is_sphere ? 1 / std::hypot(site.x, site.y, z + 0.5) : 1.0;
            sites.push_back({site.x * scale, site.y * scale, z * scale});
        }
        double last = 0.0;
        const Options options = {.threads = 3, .progress = [&](double share) {
                                     EXPECT_GE(share, last);
                                     last = share;
                                 }};
        static_cast<void>(triangulate(std::span<const Point3>(sites), Power{}, options));
        EXPECT_EQ(last, 1.0);
    }
}

TEST_P(ConstructionByThreads, StopsWhereItIsAskedTo) {
    const std::vector<Site> sites = spiral(60'000);
    std::stop_source stop;
    const Options options = {
        .threads = 3, .stop = stop.get_token(), .progress = [&](double) { stop.request_stop(); }};
    EXPECT_THROW(static_cast<void>(triangulate(sites, GetParam(), options)), Stopped);
}

TEST_P(ConstructionByThreads, EndsWhereItsCallerThrows) {
    const std::vector<Site> sites = spiral(60'000);
    const Options options = {.threads = 3,
                             .progress = [](double) { throw std::out_of_range("told"); }};
    EXPECT_THROW(static_cast<void>(triangulate(sites, GetParam(), options)), std::out_of_range);
}

INSTANTIATE_TEST_SUITE_P(, ConstructionByThreads, testing::ValuesIn(all_metrics),
                         [](const testing::TestParamInfo<Metric>& info) {
                             return std::string(name_of(info.param));
                         });

}  // namespace
}  // namespace signum
