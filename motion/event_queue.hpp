#pragma once
/// The next event of every ball, the least first: n entries, whatever happens.
///
/// Buckets of equal width hold the entries of the near future unsorted, a heap those of the bucket
/// whose time has come, a list what is farther off than all buckets. When the buckets are through,
/// that list is dealt into them anew, four times as wide as the last round's events were apart. So
/// an entry is sorted only among the few that come next, and a change costs O(1) expected, O(log n)
/// at worst (all at the same time).
///
/// Law: whatever the buckets, top() is the least entry by key and, of equal keys, by the order the
/// caller gives. A bucket's number is a monotone function of the key.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "../core/contract.hpp"
#include "../core/large_array.hpp"

namespace signum::motion {

class EventQueue {
 public:
    using Entry = std::uint32_t;

    explicit EventQueue(std::size_t entries)
        : items_(entries),
          heads_(std::bit_ceil(std::max<std::size_t>(entries, 1)) + 1, none),
          far_(static_cast<std::uint32_t>(heads_.size() - 1)),
          bucket_(far_) {
        for (Entry e = 0; e < entries; ++e) {
            items_[e].key = infinity;
            insert(e, far_);
        }
    }

    [[nodiscard]] double key(Entry e) const noexcept { return items_[e].key; }

    /// Gives an entry a key, or the same one where its place among equals has changed.
    template <class Before>
    [[gnu::always_inline]] void set(Entry e, double key, const Before& before) {
        const std::uint32_t from = items_[e].bucket;
        items_[e].key = key;
        const std::uint32_t to = bucket_ == far_ ? far_ : bucket_of(key);
        if (from == in_heap) {
            if (to <= bucket_ && to != far_) {
                sift(items_[e].place, e, before);
                return;
            }
            leave_heap(e, before);
        } else {
            if (from == to && to > bucket_) return;
            leave_bucket(e);
        }
        if (to <= bucket_ && to != far_) {
            heap_.push_back(e);
            items_[e].bucket = in_heap;
            sift(heap_.size() - 1, e, before);
        } else {
            insert(e, to);
        }
    }

    /// The least entry; any where all keys are infinite. Precondition: there is one.
    template <class Before>
    [[nodiscard]] Entry top(const Before& before) {
        while (heap_.empty()) {
            if ((bucket_ == far_ || ++bucket_ == far_) && !deal()) return heads_[far_];
            for (Entry e = heads_[bucket_]; e != none;) {
                const Entry next = items_[e].next;
                items_[e].bucket = in_heap;
                heap_.push_back(e);
                sift(heap_.size() - 1, e, before);
                e = next;
            }
            heads_[bucket_] = none;
        }
        ++taken_;
        return heap_.front();
    }

    /// Those whose turn is soon: the entries of the buckets up to some ahead of the one whose time
    /// has come, of each bucket once: `seen` is kept by the caller.
    template <class Visit>
    void for_each_ahead(std::uint32_t& seen, std::uint32_t by, const Visit& visit) const {
        if (seen > bucket_ + by) seen = bucket_;
        for (const std::uint32_t last = std::min(bucket_ + by, far_ - 1); seen < last;) {
            const std::uint32_t beyond = std::min(++seen + 3, far_);
            if (heads_[beyond] != none) __builtin_prefetch(&items_[heads_[beyond]]);
            for (Entry e = heads_[seen]; e != none; e = items_[e].next) visit(e);
        }
    }

 private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    static constexpr Entry none = ~Entry{0};
    static constexpr std::uint32_t in_heap = ~std::uint32_t{0};

    struct Item {
        double key;
        std::uint32_t bucket;
        union {
            Entry next;
            std::uint32_t place;  // in the heap
        };
        Entry previous;
    };

    [[nodiscard]] std::uint32_t bucket_of(double key) const noexcept {
        const double number = (key - start_) * per_time_;
        return number < static_cast<double>(far_)
                   ? number > 0.0 ? static_cast<std::uint32_t>(number) : 0
                   : far_;
    }
    void insert(Entry e, std::uint32_t bucket) noexcept {
        Item& item = items_[e];
        item.bucket = bucket;
        item.next = heads_[bucket];
        item.previous = none;
        if (item.next != none) items_[item.next].previous = e;
        heads_[bucket] = e;
    }
    void leave_bucket(Entry e) noexcept {
        const Item& item = items_[e];
        (item.previous == none ? heads_[item.bucket] : items_[item.previous].next) = item.next;
        if (item.next != none) items_[item.next].previous = item.previous;
    }
    template <class Before>
    void leave_heap(Entry e, const Before& before) {
        const std::size_t place = items_[e].place;
        const Entry last = heap_.back();
        heap_.pop_back();
        if (last != e) sift(place, last, before);
    }
    template <class Before>
    void sift(std::size_t place, Entry e, const Before& before) {
        const auto is_before = [&](Entry a, Entry b) {
            return items_[a].key < items_[b].key ||
                   (items_[a].key == items_[b].key && before(a, b));
        };
        while (place > 0 && is_before(e, heap_[(place - 1) / 2])) {
            put(place, heap_[(place - 1) / 2]);
            place = (place - 1) / 2;
        }
        for (std::size_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
            if (child + 1 < heap_.size() && is_before(heap_[child + 1], heap_[child])) ++child;
            if (!is_before(heap_[child], e)) break;
            put(place, heap_[child]);
            place = child;
        }
        put(place, e);
    }
    void put(std::size_t place, Entry e) noexcept {
        heap_[place] = e;
        items_[e].place = static_cast<std::uint32_t>(place);
    }

    /// Deals what is far off into buckets, from its least key on; false where that is infinity.
    bool deal() {
        double least = infinity;
        std::vector<double>& keys = scratch_;
        keys.clear();
        for (Entry e = heads_[far_]; e != none; e = items_[e].next) {
            least = std::min(least, items_[e].key);
            if (taken_ == 0 && items_[e].key < infinity) keys.push_back(items_[e].key);
        }
        if (!(least < infinity)) {
            bucket_ = far_;
            return false;
        }
        double width = 0.0;
        if (taken_ > 0) {
            width = 4.0 * (least - start_) / static_cast<double>(taken_);
        } else {
            const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
            std::nth_element(keys.begin(), middle, keys.end());
            width = (*middle - least) / static_cast<double>(keys.size());
        }
        width = std::clamp(std::max(width, 0x1p-45 * std::abs(least)), 0x1p-900, 0x1p900);
        start_ = least;
        per_time_ = 1.0 / width;
        taken_ = 0;
        bucket_ = 0;
        Entry e = heads_[far_];
        heads_[far_] = none;
        while (e != none) {
            const Entry next = items_[e].next;
            insert(e, bucket_of(items_[e].key));
            e = next;
        }
        return true;
    }

    LargeArray<Item, Pages::large> items_;
    LargeArray<Entry, Pages::large> heads_;
    std::uint32_t far_;
    std::uint32_t bucket_;  // the heap's, or far_ before the first round
    std::vector<Entry> heap_;
    std::vector<double> scratch_;
    double start_ = 0.0;
    double per_time_ = 0.0;
    std::uint64_t taken_ = 0;
};

}  // namespace signum::motion
