// Memory that runs out: of all that a construction allocates each in turn is denied. It throws
// std::bad_alloc and leaves nothing behind; what was there before can be used, or replaced. Numbers
// of GMP are granted: GMP ends the program (docs/failure.md).

#include <gmp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

#include "constructions.hpp"

namespace {

/// Blocks that are held: by operator new, and by GMP. MPFR asks GMP for its functions.
long held = 0;
/// How many allocations are granted before one is denied; none is where it is negative.
long granted = -1;
/// Whether one was, and whether the one who asked can do without.
bool was_denied = false;
bool was_optional = false;

/// Memory by operator new, or none. What comes behind the one denied is granted again: an exception
/// needs memory, too.
void* allocated(std::size_t size, std::size_t alignment, bool is_optional) {
    if (granted >= 0 && granted-- == 0) {
        was_denied = true;
        was_optional = is_optional;
        return nullptr;
    }
    void* const memory =
        alignment == 0
            ? std::malloc(size)
            : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    held += memory != nullptr ? 1 : 0;
    return memory;
}
void* required(std::size_t size, std::size_t alignment) {
    void* const memory = allocated(size, alignment, false);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
void released(void* memory) noexcept {
    held -= memory != nullptr ? 1 : 0;
    std::free(memory);
}

void* counted_for_gmp(std::size_t size) {
    ++held;
    return std::malloc(size);
}
void* counted_again_for_gmp(void* memory, std::size_t, std::size_t size) {
    return std::realloc(memory, size);
}
void free_for_gmp(void* memory, std::size_t) {
    --held;
    std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
    return required(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return required(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocated(size, 0, true);
}
void operator delete(void* memory) noexcept {
    released(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    released(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    released(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    released(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    released(memory);
}

namespace signum {
namespace {

class BadAlloc : public testing::Test {
 protected:
    void SetUp() override {
#if defined(SIGNUM_WITHOUT_GMP)
        GTEST_SKIP() << "the integers that stand for GMP's end the program where it would";
#endif
        mp_get_memory_functions(&allocate_, &reallocate_, &free_);
        mp_set_memory_functions(counted_for_gmp, counted_again_for_gmp, free_for_gmp);
    }
    void TearDown() override {
        if (free_ != nullptr) mp_set_memory_functions(allocate_, reallocate_, free_);
    }

    /// Does the job again and again, each time with the next allocation denied, until all are
    /// granted: how many they are.
    static long deny_each(const char* name, const std::function<std::uint64_t()>& job) {
        const std::uint64_t result = job();
        for (long turn = 0;; ++turn) {
            const long before = held;
            was_denied = false;
            granted = turn;
            try {
                EXPECT_EQ(job(), result) << name << ", allocation " << turn;
                EXPECT_TRUE(!was_denied || was_optional) << name << ", allocation " << turn;
            } catch (const std::bad_alloc&) {
                EXPECT_TRUE(was_denied) << name << ", allocation " << turn;
            }
            granted = -1;
            EXPECT_EQ(held, before) << name << ", allocation " << turn;
            if (!was_denied || HasFailure()) return turn;
        }
    }

 private:
    void* (*allocate_)(std::size_t) = nullptr;
    void* (*reallocate_)(void*, std::size_t, std::size_t) = nullptr;
    void (*free_)(void*, std::size_t) = nullptr;
};

TEST_F(BadAlloc, LeavesNothingBehind) {
    for (const constructions::Construction& each : constructions::all) {
        const std::vector<Site> sites =
            constructions::sites_near_ties(std::min<std::size_t>(each.few / 2, 12));
        const long turns = deny_each(each.name, [&] { return each.run(sites); });
        EXPECT_GT(turns, 10) << each.name;
    }
}

/// By the handle, what a tessellation holds, and the result.
using Held = std::pair<std::vector<Site>, std::vector<Face>>;
Held held_by(const DynamicTessellation& dynamic, std::size_t handles) {
    Held result;
    for (std::size_t h = 0; h < handles; ++h)
        if (const auto handle = static_cast<Index>(h); dynamic.contains(handle))
            result.first.push_back(dynamic.site(handle));
    const Tessellation built = dynamic.tessellation();
    constructions::require(validate(built));
    result.second.assign(built.faces().begin(), built.faces().end());
    return result;
}

/// Denies a change of a tessellation each allocation in turn. The sites are those before the
/// change, and it can be made afterwards.
void deny_change(Metric metric, bool has_gap,
                 const std::function<void(DynamicTessellation&)>& change) {
    // Of 16 sites there is no room for another one.
    const std::size_t number = has_gap ? 12 : 16;
    const std::vector<Site> sites = constructions::sites_near_ties(number);
    const auto begun = [&] {
        DynamicTessellation dynamic(metric);
        for (const Site& s : sites) dynamic.insert(s);
        if (has_gap) dynamic.erase(3);
        return dynamic;
    };
    DynamicTessellation undisturbed = begun();
    const Held before = held_by(undisturbed, number + 2);
    change(undisturbed);
    const Held after = held_by(undisturbed, number + 2);
    for (long turn = 0;; ++turn) {
        DynamicTessellation dynamic = begun();
        was_denied = false;
        granted = turn;
        bool is_done = false;
        try {
            change(dynamic);
            is_done = true;
        } catch (const std::bad_alloc&) {
        }
        granted = -1;
        ASSERT_EQ(held_by(dynamic, number + 2), is_done ? after : before)
            << name_of(metric) << ", allocation " << turn;
        if (!is_done) {
            change(dynamic);
            ASSERT_EQ(held_by(dynamic, number + 2), after)
                << name_of(metric) << ", allocation " << turn;
        }
        if (!was_denied) return;
    }
}

TEST_F(BadAlloc, LeavesADynamicTessellationAsItWas) {
    for (const Metric metric : all_metrics) {
        deny_change(metric, true, [](auto& dynamic) { dynamic.insert({1.5, 1.25, 0.5}); });
        deny_change(metric, false, [](auto& dynamic) { dynamic.insert({1.5, 1.25, 0.5}); });
        deny_change(metric, true, [](auto& dynamic) { dynamic.erase(5); });
        deny_change(metric, true, [](auto& dynamic) { dynamic.change(5, 2.0); });
        deny_change(metric, true, [](auto& dynamic) { dynamic.change(6, 0.0); });
        deny_change(metric, true, [](auto& dynamic) { dynamic.move(5, {1.75, 1.5}); });
        deny_change(metric, true, [](auto& dynamic) { dynamic.move(7, {7.0, -1.5}); });
        for (const double far : {0x1p-20, 4.0})
            deny_change(metric, true, [far](auto& dynamic) {
                std::vector<Point> centres;
                for (Index h = 0; h < 12; ++h)
                    if (dynamic.contains(h)) {
                        const Site site = dynamic.site(h);
                        centres.push_back({site.x + far * (h % 3), site.y - far * (h % 2)});
                    }
                dynamic.move_all(centres);
            });
    }
}

/// What may only be destroyed or given a new value afterwards can be given one.
template <class Moving>
void deny_and_replace(const std::function<Moving()>& begun,
                      const std::function<std::uint64_t(Moving&)>& change) {
    Moving undisturbed = begun();
    const std::uint64_t result = change(undisturbed);
    for (long turn = 0;; ++turn) {
        Moving moving = begun();
        was_denied = false;
        granted = turn;
        try {
            EXPECT_EQ(change(moving), result);
        } catch (const std::bad_alloc&) {
            granted = -1;
            moving = begun();
            ASSERT_EQ(change(moving), result) << "allocation " << turn;
        }
        granted = -1;
        if (was_denied) continue;
        EXPECT_GT(turn, 3);
        return;
    }
}

TEST_F(BadAlloc, LeavesWhatMovesToBeReplaced) {
    std::vector<MovingSite> sites;
    for (const Site& s : constructions::sites_near_ties(10))
        sites.push_back({s.x, s.y, s.y - 1.0, 1.0 - s.x, s.r});
    deny_and_replace<KineticTessellation>([&] { return KineticTessellation(sites); },
                                          [](KineticTessellation& kinetic) {
                                              constructions::Digest digest;
                                              kinetic.advance(0.25);
                                              digest.add_all(kinetic.faces());
                                              return digest.value();
                                          });
    std::vector<motion::Body<2>> bodies;
    for (int i = 0; i < 9; ++i)
        bodies.push_back({{1.0 * (i % 3), 1.0 * (i / 3)}, {0.5 - i % 2, 0.25 * i}, 0.375});
    motion::Effects<2> effects;
    effects.box = {{-1.0, -1.0}, {3.0, 3.0}};
    deny_and_replace<motion::Simulation<2>>(
        [&] { return motion::Simulation<2>(motion::start<2>(bodies, effects), effects); },
        [](motion::Simulation<2>& simulation) {
            constructions::Digest digest;
            motion::Limits limits;
            limits.strikes = 20;
            simulation.run(limits, [&](const motion::Strike& strike) { digest.add(strike.time); });
            return digest.value();
        });
}

}  // namespace
}  // namespace signum
