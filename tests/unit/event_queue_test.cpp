/// The queue of events against a list that is searched for its least entry.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../motion/event_queue.hpp"

namespace signum::motion {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Entry = EventQueue::Entry;

/// Keys and an order of equal ones, in the queue and in a list.
class Twins {
    [[nodiscard]] auto before() const {
        return [this](Entry a, Entry b) {
            return rank_[a] < rank_[b] || (rank_[a] == rank_[b] && a < b);
        };
    }

 public:
    explicit Twins(std::size_t entries)
        : queue_(entries), keys_(entries, infinity), rank_(entries) {
        for (std::size_t e = 0; e < entries; ++e) rank_[e] = static_cast<std::uint32_t>(e);
    }

    void set(Entry e, double key) { set(e, key, rank_[e]); }
    void set(Entry e, double key, std::uint32_t rank) {
        keys_[e] = key;
        rank_[e] = rank;
        queue_.set(e, key, before());
    }

    /// The least entry, the same in both. Those that never come have no order.
    Entry expect_same_top() {
        const Entry top = queue_.top(before());
        Entry least = 0;
        for (Entry e = 1; e < keys_.size(); ++e)
            if (keys_[e] < keys_[least] || (keys_[e] == keys_[least] && before()(e, least)))
                least = e;
        EXPECT_EQ(keys_[top], keys_[least]);
        EXPECT_EQ(queue_.key(top), keys_[top]);
        if (keys_[least] < infinity) {
            EXPECT_EQ(top, least);
        }
        return top;
    }
    void expect_same_keys() const {
        for (Entry e = 0; e < keys_.size(); ++e) ASSERT_EQ(queue_.key(e), keys_[e]);
    }

    /// Who is ahead is not before the top, which was asked for last; how many there are.
    std::size_t expect_later_ahead(Entry top, std::uint32_t& seen, std::uint32_t by) const {
        std::vector<Entry> ahead;
        queue_.for_each_ahead(seen, by, [&](Entry e) { ahead.push_back(e); });
        for (const Entry e : ahead) EXPECT_GE(keys_.at(e), keys_[top]);
        std::sort(ahead.begin(), ahead.end());
        EXPECT_EQ(std::adjacent_find(ahead.begin(), ahead.end()), ahead.end());
        return ahead.size();
    }

    [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
    [[nodiscard]] double key(Entry e) const { return keys_[e]; }

 private:
    EventQueue queue_;
    std::vector<double> keys_;
    std::vector<std::uint32_t> rank_;
};

class EventQueueTest : public testing::Test {
 protected:
    std::uint32_t below(std::size_t bound) {
        return static_cast<std::uint32_t>(random_() % static_cast<std::uint64_t>(bound));
    }
    double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }
    /// 0 to 1, or next to it by less and less.
    double of_many_binades() { return std::ldexp(unit(), -static_cast<int>(below(60))); }

    /// Events that come, each time the least: an entry comes again at next(time of its turn). A few
    /// others change at the same time.
    template <class Next>
    void expect_same_events(std::size_t entries, std::size_t events, double start,
                            const Next& next) {
        Twins twins(entries);
        for (Entry e = 0; e < entries; ++e) twins.set(e, next(start));
        std::uint32_t seen = 0;
        for (std::size_t i = 0; i < events; ++i) {
            const Entry top = twins.expect_same_top();
            twins.expect_later_ahead(top, seen, below(12));
            ASSERT_FALSE(HasFailure()) << "event " << i;
            const double now = twins.key(top) < infinity ? twins.key(top) : start;
            twins.set(top, next(now));
            for (std::uint32_t changes = below(4); changes > 0; --changes)
                twins.set(below(entries), next(now));
        }
        twins.expect_same_keys();
    }
    template <class Next>
    void expect_same_events_of_all_sizes(double start, const Next& next) {
        for (const std::size_t entries : {1U, 2U, 3U, 7U, 64U, 65U, 300U}) {
            SCOPED_TRACE(std::to_string(entries) + " entries");
            expect_same_events(entries, 1500, start, next);
            if (HasFailure()) return;
        }
    }

 private:
    std::mt19937_64 random_{1804};
};

TEST_F(EventQueueTest, OfEventsSpreadEvenly) {
    expect_same_events_of_all_sizes(0.0, [&](double now) { return now + unit(); });
}

TEST_F(EventQueueTest, OfANegativeStart) {
    expect_same_events_of_all_sizes(-1e6, [&](double now) { return now + 1e4 * unit(); });
}

TEST_F(EventQueueTest, OfEqualKeys) {
    expect_same_events_of_all_sizes(0.0, [&](double now) { return now + below(3); });
}

TEST_F(EventQueueTest, OfAllAtOneTime) {
    expect_same_events_of_all_sizes(2.0, [](double now) { return now; });
}

TEST_F(EventQueueTest, OfKeysThatNeverCome) {
    expect_same_events_of_all_sizes(
        1.0, [&](double now) { return below(3) == 0 ? now + unit() : infinity; });
}

TEST_F(EventQueueTest, OfClustersOfManyMagnitudes) {
    expect_same_events_of_all_sizes(1.0, [&](double now) {
        return below(16) == 0 ? now * (2.0 + unit()) : now + of_many_binades() * now;
    });
}

/// Neighbouring doubles, so that a bucket is as wide as they are apart.
TEST_F(EventQueueTest, OfNeighbouringDoubles) {
    expect_same_events_of_all_sizes(1e12, [&](double now) {
        for (std::uint32_t steps = below(3); steps > 0; --steps)
            now = std::nextafter(now, infinity);
        return now;
    });
}

/// As long as their differences are doubles.
TEST_F(EventQueueTest, OfTheEndsOfTheDoubles) {
    constexpr double largest = std::numeric_limits<double>::max();
    constexpr double least = std::numeric_limits<double>::denorm_min();
    for (const std::vector<double>& keys :
         {std::vector<double>{0.0, least, 0x1p-1000, 1.0, std::nextafter(largest, 0.0), largest,
                              infinity},
          std::vector<double>{-0x1p1022, -1.0, -least, 0.0, least, 0x1p1022, infinity},
          std::vector<double>{-largest, -1.0, 1.0, largest}})
        expect_same_events_of_all_sizes(0.0, [&](double) { return keys[below(keys.size())]; });
}

/// New keys are sooner than the least one as often as not.
TEST_F(EventQueueTest, OfKeysBelowTheBucketAtHand) {
    expect_same_events_of_all_sizes(0.0, [&](double now) {
        return now + (unit() - 0.5) * std::ldexp(1.0, int(below(20)) - 10);
    });
}

/// Any key and any place among equals, and the least asked for now and then.
TEST_F(EventQueueTest, OfEntriesSetManyTimes) {
    for (const std::size_t entries : {1U, 2U, 5U, 100U}) {
        SCOPED_TRACE(std::to_string(entries) + " entries");
        Twins twins(entries);
        std::uint32_t seen = 0;
        for (int i = 0; i < 10'000; ++i) {
            const Entry e = below(entries);
            const std::uint32_t kind = below(8);
            const double key = kind == 0   ? twins.key(e)  // but perhaps another place
                               : kind == 1 ? infinity
                               : kind < 5  ? below(4)
                                           : 8.0 * unit() - 2.0;
            twins.set(e, key, below(3));
            if (below(3) > 0) continue;
            const Entry top = twins.expect_same_top();
            twins.expect_later_ahead(top, seen, below(8));
            ASSERT_FALSE(HasFailure()) << "change " << i;
        }
        twins.expect_same_keys();
    }
}

/// Nobody is due before all have been set, and after all are through.
TEST_F(EventQueueTest, EmptiesAndFillsAgain) {
    Twins twins(40);
    for (int round = 0; round < 20; ++round) {
        EXPECT_EQ(twins.key(twins.expect_same_top()), infinity);
        for (Entry e = 0; e < twins.size(); ++e) twins.set(e, 20.0 - round + unit());
        for (std::size_t i = 0; i < twins.size(); ++i) twins.set(twins.expect_same_top(), infinity);
    }
}

TEST_F(EventQueueTest, ShowsWhoIsAhead) {
    Twins twins(1000);
    for (Entry e = 0; e < twins.size(); ++e) twins.set(e, unit());
    std::uint32_t seen = 0;
    std::size_t visits = 0;
    for (std::size_t i = 0; i < twins.size(); ++i) {
        const Entry top = twins.expect_same_top();
        visits += twins.expect_later_ahead(top, seen, 9);
        ASSERT_FALSE(HasFailure()) << "event " << i;
        twins.set(top, infinity);
    }
    EXPECT_GT(visits, twins.size() / 2);  // nearly all, some of them before they are in the heap
}

}  // namespace
}  // namespace signum::motion
