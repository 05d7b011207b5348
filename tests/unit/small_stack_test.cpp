// A stack of 256 KiB suffices for every construction: of hundreds of sites near ties, and of sets
// on which one step may lead to the next, and so on through all sites.

#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "../thoroughness.hpp"
#include "constructions.hpp"

namespace signum {
namespace {

/// Frames are several times as large where memory is watched or nothing is optimized.
#if defined(__SANITIZE_THREAD__)
const std::size_t stack_bytes = std::size_t{1} << 21;
#else
const std::size_t stack_bytes = std::size_t{1} << (is_fast ? 18 : 21);
#endif

/// Does the job on such a stack; what it throws is a failure.
void run_on_small_stack(const std::function<void()>& job) {
    pthread_attr_t attributes;
    ASSERT_EQ(pthread_attr_init(&attributes), 0);
    ASSERT_EQ(pthread_attr_setstacksize(&attributes, stack_bytes), 0);
    const auto start = [](void* given) -> void* {
        try {
            (*static_cast<const std::function<void()>*>(given))();
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
        return nullptr;
    };
    pthread_t thread;
    ASSERT_EQ(pthread_create(&thread, &attributes, start, const_cast<std::function<void()>*>(&job)),
              0);
    ASSERT_EQ(pthread_join(thread, nullptr), 0);
    ASSERT_EQ(pthread_attr_destroy(&attributes), 0);
}

struct Family {
    const char* name;
    Site (*site)(std::size_t i, std::size_t number);
};
/// Sets on which one step may lead to the next, and so on through all sites.
constexpr std::array families = {
    Family{"identical",
           [](std::size_t, std::size_t) {
               return Site{1.0, 2.0, 0.5};
           }},
    Family{"collinear",
           [](std::size_t i, std::size_t) {
               return Site{1.0 * static_cast<double>(i), 2.0 * static_cast<double>(i), 0.0};
           }},
    Family{"cocircular",
           [](std::size_t i, std::size_t number) {
               const double angle =
                   6.283185307179586 * static_cast<double>(i) / static_cast<double>(number);
               return Site{std::cos(angle), std::sin(angle), 0.0};
           }},
    // Each touches the next one from inside.
    Family{"nested",
           [](std::size_t i, std::size_t) {
               return Site{static_cast<double>(i), 0.0, static_cast<double>(i)};
           }},
    // t, t², and t² again for a radius.
    Family{"parabola",
           [](std::size_t i, std::size_t number) {
               const double t = static_cast<double>(i) / static_cast<double>(number);
               return Site{t, t * t, t * t};
           }},
};

std::vector<Site> sites_of(const Family& family, std::size_t number) {
    std::vector<Site> sites;
    for (std::size_t i = 0; i < number; ++i) sites.push_back(family.site(i, number));
    return sites;
}

TEST(SmallStack, SufficesForAllConstructions) {
    for (const constructions::Construction& each : constructions::all) {
        SCOPED_TRACE(each.name);
        // The diagram of balls takes m⁴ steps for m that touch one sphere.
        const std::size_t number = each.few < 20 || !is_fast ? each.few : 4 * each.few;
        run_on_small_stack([&] { each.run(constructions::sites_near_ties(number)); });
        for (const Family& family : families) {
            SCOPED_TRACE(family.name);
            run_on_small_stack([&] { each.run(sites_of(family, number)); });
        }
    }
}

}  // namespace
}  // namespace signum
