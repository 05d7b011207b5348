#pragma once
/// What is to happen, in an order that the user gives: of every subject, which is named by a
/// number, one event at most. So nothing that is out of date waits here, and events that an order
/// compares are all about things as they are.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/contract.hpp"

namespace signum::triangulation {

/// Compare(a, b) is below 0 where of two values of When the first comes first, and above 0 where
/// the second does; of equal ones the event that was set first comes first. A binary heap that
/// knows where everybody's event is: O(log n) comparisons for every change.
template <class When, class Compare>
class EventQueue {
 public:
    using Subject = std::uint32_t;
    struct Event {
        When when;
        std::uint64_t number;  ///< of discovery
        Subject subject;
    };

    EventQueue(std::size_t subjects, Compare compare)
        : place_(subjects, none), compare_(std::move(compare)) {}
    /// Those that are there stay.
    void make_room(std::size_t subjects) { place_.resize(subjects, none); }

    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return heap_.size(); }
    /// The first one. Precondition: not empty.
    [[nodiscard]] const Event& top() const noexcept { return heap_.front(); }
    [[nodiscard]] Event pop() {
        Event first = heap_.front();
        erase(first.subject);
        return first;
    }

    /// Gives the subject an event, instead of the one that it may have.
    void set(Subject subject, const When& when) {
        std::uint32_t place = place_[subject];
        if (place == none) {
            place = static_cast<std::uint32_t>(heap_.size());
            heap_.push_back({when, ++number_, subject});
            rise(place, heap_.back());
        } else {
            settle(place, {when, ++number_, subject});
        }
    }
    /// Nothing happens where it has none.
    void erase(Subject subject) {
        const std::uint32_t place = place_[subject];
        if (place == none) return;
        place_[subject] = none;
        const Event last = heap_.back();
        heap_.pop_back();
        if (last.subject != subject) settle(place, last);
    }
    void clear() noexcept {
        for (const Event& event : heap_) place_[event.subject] = none;
        heap_.clear();
    }

 private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    /// As many children has a place, which lie side by side: memory is waited for half as often as
    /// with two.
    static constexpr std::uint32_t ways = 4;

    [[nodiscard]] bool is_before(const Event& a, const Event& b) const {
        const int order = compare_(a.when, b.when);
        return order != 0 ? order < 0 : a.number < b.number;
    }
    [[nodiscard]] static std::uint32_t parent(std::uint32_t place) noexcept {
        return (place - 1) / ways;
    }
    /// Puts an event where its place is, from a place that is free.
    void settle(std::uint32_t place, const Event& event) {
        if (place > 0 && is_before(event, heap_[parent(place)])) return rise(place, event);
        const auto size = static_cast<std::uint32_t>(heap_.size());
        for (std::uint32_t child = ways * place + 1; child < size; child = ways * place + 1) {
            std::uint32_t first = child;
            const std::uint32_t end = std::min(child + ways, size);
            while (++child < end)
                if (is_before(heap_[child], heap_[first])) first = child;
            if (!is_before(heap_[first], event)) break;
            put(place, heap_[first]);
            place = first;
        }
        put(place, event);
    }
    void rise(std::uint32_t place, Event event) {
        for (; place > 0 && is_before(event, heap_[parent(place)]); place = parent(place))
            put(place, heap_[parent(place)]);
        put(place, event);
    }
    void put(std::uint32_t place, const Event& event) {
        SIGNUM_EXPECTS(place < heap_.size());
        heap_[place] = event;
        place_[event.subject] = place;
    }

    std::vector<Event> heap_;
    std::vector<std::uint32_t> place_;
    std::uint64_t number_ = 0;
    Compare compare_;
};

}  // namespace signum::triangulation
