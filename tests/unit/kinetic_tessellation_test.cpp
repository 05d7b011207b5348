/// What a tessellation of moving sites promises at its ends: few sites, no numbers, other clocks
/// and environments.

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "../../triangulation/moving/kinetic_tessellation.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/validate.hpp"
#include "../property/moving_systems.hpp"

namespace signum {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity_ = std::numeric_limits<double>::infinity();

TEST(KineticTessellation, RefusesWhatIsNoNumber) {
    EXPECT_THROW(KineticTessellation{nan}, std::invalid_argument);
    EXPECT_THROW(KineticTessellation(0.0, {0.0, infinity_}), std::invalid_argument);
    for (std::size_t k = 0; k < 6; ++k) {
        double numbers[6] = {1, 2, 3, 4, 5, 6};
        numbers[k] = k % 2 == 0 ? nan : -infinity_;
        const MovingSite bad{numbers[0], numbers[1], numbers[2],
                             numbers[3], numbers[4], numbers[5]};
        EXPECT_THROW(KineticTessellation(std::vector{MovingSite{}, bad}), std::invalid_argument);
        KineticTessellation moving(std::vector{MovingSite{}, MovingSite{1, 0, 0, 0, 0, 0}});
        EXPECT_THROW(moving.insert(bad), std::invalid_argument);
        EXPECT_THROW(moving.change(1, bad), std::invalid_argument);
        try {
            static_cast<void>(KineticTessellation(std::vector{MovingSite{}, bad}));
        } catch (const std::invalid_argument& error) {
            EXPECT_STREQ(error.what(), "a number of site 1 is not finite");
        }
        // Nothing has happened.
        EXPECT_EQ(moving.size(), 2);
        EXPECT_EQ(moving.site(1), (MovingSite{1, 0, 0, 0, 0, 0}));
        EXPECT_EQ(moving.insert({0, 1, 0, 0, 0, 0}), 2);
        EXPECT_EQ(moving.faces(), (std::vector<Face>{{0, 1, 2}}));
    }
}

TEST(KineticTessellation, RefusesTimesBackwardsAndUnknownHandles) {
    KineticTessellation moving(std::vector<MovingSite>(3), 2.0);
    EXPECT_THROW(moving.advance(1.5), std::invalid_argument);
    EXPECT_THROW(moving.advance(nan), std::invalid_argument);
    EXPECT_THROW(moving.advance(infinity_), std::invalid_argument);
    EXPECT_EQ(moving.time(), 2.0);
    moving.advance(2.0);
    for (const Index handle : {-1, 3, std::numeric_limits<Index>::max()}) {
        EXPECT_FALSE(moving.contains(handle));
        EXPECT_THROW(static_cast<void>(moving.site(handle)), std::out_of_range);
        EXPECT_THROW(moving.erase(handle), std::out_of_range);
        EXPECT_THROW(moving.change(handle, {}), std::out_of_range);
    }
    moving.erase(1);
    EXPECT_THROW(moving.erase(1), std::out_of_range);
    EXPECT_EQ(moving.insert({}), 1);
}

TEST(KineticTessellation, OfNoneOneAndTwo) {
    KineticTessellation moving;
    for (int number = 0; number < 3; ++number) {
        EXPECT_EQ(moving.size(), number);
        EXPECT_TRUE(moving.faces().empty());
        const Tessellation result = moving.tessellation();
        EXPECT_EQ(result.sites().size(), number);
        EXPECT_TRUE(validate(result).valid);
        EXPECT_FALSE(moving.next_event().has_value());
        moving.advance(moving.time() + 1.0);
        const double t = moving.time();
        EXPECT_EQ(moving.insert({t, -t, 0.5, 0.25, 1.0, t}), number);
    }
    for (const Index handle : {1, 0, 2}) moving.erase(handle);
    EXPECT_EQ(moving.size(), 0);
    EXPECT_TRUE(moving.tessellation().sites().empty());
}

TEST(KineticTessellation, OnALineAnotherOneMayBeHidden) {
    // A point flies along the line through two discs that overlap.
    KineticTessellation moving(
        std::vector<MovingSite>{{-2, 0, 0, 0, 2.5, 0}, {2, 0, 0, 0, 2.5, 0}, {-8, 0, 1, 0, 0, 0}});
    std::vector<std::array<Index, 3>> told;
    moving.watch([&](Index a, Index b, bool comes) { told.push_back({a, b, comes ? 1 : -1}); });
    EXPECT_TRUE(moving.faces().empty());
    EXPECT_TRUE(moving.tessellation().hidden().empty());
    // It is beside one of them, and beyond it.
    ASSERT_EQ(moving.next_event(), 6.0);
    moving.advance(6.0);
    EXPECT_EQ(told, (std::vector<std::array<Index, 3>>{{0, 2, -1}}));
    moving.advance(8.0);
    ASSERT_EQ(moving.tessellation().hidden().size(), 1);
    EXPECT_EQ(moving.tessellation().hidden()[0].site, 2);
    told.clear();
    moving.advance(16.0);
    EXPECT_EQ(told, (std::vector<std::array<Index, 3>>{{1, 2, 1}}));
    EXPECT_TRUE(moving.tessellation().hidden().empty());
    EXPECT_FALSE(moving.next_event().has_value());
}

TEST(KineticTessellation, IsNotChangedWhileItTells) {
    KineticTessellation moving(std::vector<MovingSite>{
        {0, 0, 0, 0, 0, 0}, {8, 0, 0, 0, 0, 0}, {8, 8, 0, 0, 0, 0}, {4, 1, 0, 0.5, 0, 0}});
    int refused = 0;
    moving.watch([&](Index, Index, bool) {
        EXPECT_THROW(moving.advance(100.0), std::logic_error);
        EXPECT_THROW(moving.erase(0), std::logic_error);
        EXPECT_THROW(moving.insert({}), std::logic_error);
        EXPECT_THROW(moving.change(0, {}), std::logic_error);
        EXPECT_THROW(moving.watch({}), std::logic_error);
        ++refused;
    });
    moving.advance(20.0);
    EXPECT_GT(refused, 0);
    EXPECT_EQ(moving.size(), 4);
    moving.watch({});
    moving.advance(30.0);
}

TEST(KineticTessellation, AnEdgeThatIsBackAtOnceIsNotTold) {
    // All three are on one line at 2, where all is built anew, and turn the other way.
    KineticTessellation moving(
        std::vector<MovingSite>{{-4, 0, 2, 0, 0, 0}, {4, -1, -2, 1, 0, 0}, {0, -2, 0, 1, 0, 0}});
    int told = 0;
    moving.watch([&](Index, Index, bool) { ++told; });
    const std::uint64_t rebuilds = moving.statistics().rebuilds;
    moving.advance(2.0);
    EXPECT_GT(moving.statistics().rebuilds, rebuilds);
    EXPECT_EQ(told, 0);
}

TEST(KineticTessellation, Moves) {
    Systems systems(11);
    const auto sites = systems.make(0, 20);
    KineticTessellation first(sites);
    first.advance(1.0);
    KineticTessellation second(std::move(first));
    second.advance(2.0);
    first = KineticTessellation(sites, 2.0);
    EXPECT_EQ(first.faces(), second.faces());
    EXPECT_EQ(second.time(), 2.0);
}

/// In a fall from one time on everybody is where he would be without it, but for the same way.
TEST(KineticTessellation, AFallIsADrift) {
    for (int kind = 0; kind < Systems::kinds; ++kind) {
        if (kind == 1 || kind == 8) continue;  // from their own times
        Systems systems(static_cast<std::uint64_t>(21 + kind));
        const auto sites = systems.make(kind, 12);
        KineticTessellation still(sites);
        KineticTessellation falls(sites, 0.0, {0.5, -9.75});
        for (int step = 1; step <= 20; ++step) {
            ASSERT_EQ(still.next_event(), falls.next_event());
            still.advance(step / 4.0);
            falls.advance(step / 4.0);
            ASSERT_EQ(still.faces(), falls.faces()) << "kind " << kind;
            ASSERT_TRUE(validate(falls.tessellation()).valid);
        }
    }
}

/// A clock that begins late makes no difference where its times are doubles.
TEST(KineticTessellation, IsTheSameByALateClock) {
    for (int kind = 0; kind < Systems::kinds; ++kind) {
        Systems systems(static_cast<std::uint64_t>(41 + kind));
        const auto sites = systems.make(kind, 15);
        constexpr double late = 0x1p33;
        auto shifted = sites;
        for (MovingSite& site : shifted) site.time += late;
        KineticTessellation soon(sites);
        KineticTessellation later(shifted, late);
        for (int step = 1; step <= 40; ++step) {
            soon.advance(step / 8.0);
            later.advance(late + step / 8.0);
            ASSERT_EQ(soon.faces(), later.faces()) << "kind " << kind << " step " << step;
        }
        EXPECT_EQ(soon.statistics().flips, later.statistics().flips);
    }
}

/// Whatever the steps, at times that are no dyadic numbers of few bits either.
TEST(KineticTessellation, DoesNotDependOnTheSteps) {
    for (int kind = 0; kind < Systems::kinds; ++kind) {
        Systems systems(static_cast<std::uint64_t>(61 + kind));
        const auto sites = systems.make(kind, 18);
        KineticTessellation many(sites);
        for (int step = 1; step <= 50; ++step) many.advance(std::sqrt(step / 2.0));
        KineticTessellation one(sites);
        one.advance(many.time());
        EXPECT_EQ(one.faces(), many.faces()) << "kind " << kind;
        EXPECT_EQ(KineticTessellation(sites, many.time()).faces(), many.faces());
    }
}

/// What next_event() told is kept for advance(), and is forgotten with the event.
TEST(KineticTessellation, IsWhereItWouldBeUnasked) {
    for (const int kind : {0, 1, 2, 5}) {
        Systems systems(static_cast<std::uint64_t>(91 + kind));
        const auto sites = systems.make(kind, 14);
        const auto others = systems.make(kind, 14);
        KineticTessellation asked(sites);
        KineticTessellation unasked(sites);
        for (int step = 0; step < 60; ++step) {
            const auto told = asked.next_event();
            // Another event may be the next one then, or none.
            if (step % 3 == 1) {
                const MovingSite& site = others[static_cast<std::size_t>(step) % others.size()];
                asked.change(step % 14, site);
                unasked.change(step % 14, site);
            }
            const auto event = asked.next_event();
            EXPECT_EQ(asked.next_event(), event);
            if (step % 3 != 1) {
                EXPECT_EQ(event, told);
            }
            if (!event) continue;
            const std::uint64_t times = unasked.statistics().times;
            if (const double before = std::nextafter(*event, -infinity_);
                before >= unasked.time()) {
                unasked.advance(before);
                EXPECT_EQ(unasked.statistics().times, times) << "kind " << kind << ", " << step;
                if (step % 2 == 0) asked.advance(before);
                EXPECT_EQ(asked.statistics().times, times);
            }
            unasked.advance(*event);
            EXPECT_GT(unasked.statistics().times, times) << "kind " << kind << ", " << step;
            asked.advance(*event);
            EXPECT_EQ(asked.statistics().times, unasked.statistics().times);
            EXPECT_EQ(asked.faces(), unasked.faces());
        }
    }
}

TEST(KineticTessellation, IsTheSameInEveryEnvironment) {
    for (const int kind : {0, 1, 2, 5, Systems::tied_for_ever}) {
        Systems systems(static_cast<std::uint64_t>(81 + kind));
        const auto sites = systems.make(kind, 10);
        KineticTessellation expected(sites);
        expected.advance(2.5);
        const auto event = expected.next_event();
        const Tessellation result = expected.tessellation();
        for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
            std::fesetround(mode);
            KineticTessellation moving(sites);
            moving.advance(1.25);
            moving.advance(2.5);
            const auto its_event = moving.next_event();
            const Tessellation its_result = moving.tessellation();
            const int after = std::fegetround();
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(after, mode);
            EXPECT_EQ(moving.faces(), expected.faces());
            EXPECT_EQ(its_event, event);
            EXPECT_TRUE(std::ranges::equal(its_result.faces(), result.faces()));
            EXPECT_TRUE(std::ranges::equal(its_result.sites(), result.sites()));
        }
    }
}

TEST(KineticTessellation, BeyondTheDoublesThereIsNoResult) {
    KineticTessellation moving(std::vector<MovingSite>{
        {0, 0, 1e308, 0, 0, 0}, {0, 1, 1e308, 0, 0, 0}, {0, 0, -1e308, 0, 0, 0}});
    moving.advance(1.0);
    EXPECT_NO_THROW(static_cast<void>(moving.tessellation()));
    moving.advance(2.0);
    EXPECT_THROW(static_cast<void>(moving.tessellation()), std::overflow_error);
    EXPECT_EQ(moving.faces().size(), 1);
}

}  // namespace
}  // namespace signum
