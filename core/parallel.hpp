#pragma once
/// Work on several threads. This header's source is the one place that knows the library which runs
/// them, oneTBB; without it everything runs on the calling thread.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "large_array.hpp"
#include "pages.hpp"

namespace signum {

/// How many threads can run at a time: the cores that the process may use, by its affinity and by
/// the processor time that its control group grants; 1 without a library for threads.
[[nodiscard]] int usable_cores() noexcept;

/// Below so many items, sites most often, one thread works: it is done before others have begun.
inline constexpr std::size_t few_items = 16384;

inline constexpr int most_threads = 1024;

/// Threads that share work, the calling one among them.
class Workers {
 public:
    /// As many as asked for, 0 being usable_cores(), or as can be started; one where there are few
    /// items. Throws std::invalid_argument for fewer than 0 or more than most_threads.
    explicit Workers(int threads, std::size_t items = few_items);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    [[nodiscard]] int count() const noexcept { return count_; }

    /// Calls task(0) … task(tasks - 1), each once, in no order, and returns when all are done. A
    /// task may call this again. Where tasks throw, those that have not begun are left out, and
    /// what one of them threw is thrown.
    void each(std::size_t tasks, const std::function<void(std::size_t)>& task) const;

    /// Calls task(begin, end) for ranges that make up 0 … size, a few for each thread.
    template <class Task>
    void each_range(std::size_t size, const Task& task) const {
        const std::size_t ranges = range_count(size);
        each(ranges, [&](std::size_t i) { task(size * i / ranges, size * (i + 1) / ranges); });
    }
    /// Into how many ranges each_range() cuts: 1 where one thread works.
    [[nodiscard]] std::size_t range_count(std::size_t size) const noexcept {
        if (count_ == 1 || size < few_items) return 1;
        return std::min(size / (few_items / 4), 8 * static_cast<std::size_t>(count_));
    }

 private:
    struct Threads;

    int count_;
    std::unique_ptr<Threads> threads_;
};

/// Gives empty arrays that many elements, zeros: memory is claimed by all threads, for to do so
/// takes far longer than to fill it.
template <class... T>
void make_room(const Workers& workers, std::size_t size, std::vector<T>&... arrays) {
    (arrays.reserve(size), ...);
    workers.each_range(size, [&](std::size_t begin, std::size_t end) {
        (expect_writes(arrays.data() + begin, (end - begin) * sizeof(T)), ...);
    });
    const std::array<std::function<void()>, sizeof...(T)> fill = {
        [&arrays, size] { arrays.resize(size); }...};
    workers.each(fill.size(), [&](std::size_t k) { fill[k](); });
}

/// An array of value_of(0) … value_of(size - 1).
template <class T, class ValueOf>
[[nodiscard]] LargeArray<T> made(const Workers& workers, std::size_t size,
                                 const ValueOf& value_of) {
    LargeArray<T> result(size);
    workers.each_range(size, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) result[i] = value_of(i);
    });
    return result;
}
/// 0 … size - 1.
template <class T>
[[nodiscard]] LargeArray<T> counted(const Workers& workers, std::size_t size) {
    return made<T>(workers, size, [](std::size_t i) { return static_cast<T>(i); });
}

/// Empties arrays whose elements need no destructor, and gives their memory back: by all threads,
/// as one thread takes a tenth of a second for a gigabyte.
template <class... Array>
void give_back(const Workers& workers, Array&... arrays) {
    const auto give = [&](auto& array) {
        using T = typename std::remove_reference_t<decltype(array)>::value_type;
        static_assert(std::is_trivially_destructible_v<T>);
        if (workers.range_count(array.size()) > 1)
            workers.each_range(array.size(), [&](std::size_t begin, std::size_t end) {
                expect_nothing(array.data() + begin, (end - begin) * sizeof(T));
            });
        release(array);
    };
    (give(arrays), ...);
}

/// Deals items 0 … size into buckets, each bucket's in their order: calls make_room(how many), then
/// put(item, place) for each, and returns where each bucket begins, and the end. bucket_of(item) is
/// asked twice, and tells `buckets` of an item that is left out. O(size), and as many numbers as
/// buckets for each range.
template <class BucketOf, class MakeRoom, class Put>
[[nodiscard]] std::vector<std::size_t> deal(const Workers& workers, std::size_t size,
                                            std::size_t buckets, const BucketOf& bucket_of,
                                            const MakeRoom& make_room, const Put& put) {
    const std::size_t ranges = workers.range_count(size);
    // How many items of each range go to each bucket; then where the next of them goes.
    std::vector<std::size_t> next(ranges * buckets, 0);
    const auto each_item = [&](const auto& task) {
        workers.each(ranges, [&](std::size_t range) {
            std::size_t* const own = &next[range * buckets];
            for (std::size_t i = size * range / ranges; i < size * (range + 1) / ranges; ++i) {
                const std::size_t bucket = bucket_of(i);
                if (bucket < buckets) task(i, own[bucket]);
            }
        });
    };
    each_item([](std::size_t, std::size_t& count) { ++count; });
    std::vector<std::size_t> begins(buckets + 1);
    std::size_t sum = 0;
    for (std::size_t b = 0; b < buckets; ++b) {
        begins[b] = sum;
        for (std::size_t range = 0; range < ranges; ++range)
            sum += std::exchange(next[range * buckets + b], sum);
    }
    begins[buckets] = sum;
    make_room(sum);
    each_item([&](std::size_t i, std::size_t& place) { put(i, place++); });
    return begins;
}

/// Lists one behind the other.
template <class T>
[[nodiscard]] std::vector<T> joined(const Workers& workers, std::vector<std::vector<T>> lists) {
    if (lists.size() == 1) return std::move(lists.front());
    std::vector<std::size_t> begins(1, 0);
    for (const std::vector<T>& list : lists) begins.push_back(begins.back() + list.size());
    std::vector<T> result;
    make_room(workers, begins.back(), result);
    workers.each(lists.size(), [&](std::size_t k) {
        std::move(lists[k].begin(), lists[k].end(), result.data() + begins[k]);
    });
    return result;
}

/// What collect(begin, end, list) adds to an empty list for each of the ranges that make up
/// 0 … size, one range's behind the other's.
template <class T, class Collect>
[[nodiscard]] std::vector<T> collected(const Workers& workers, std::size_t size,
                                       const Collect& collect) {
    const std::size_t ranges = workers.range_count(size);
    std::vector<std::vector<T>> lists(ranges);
    workers.each(ranges, [&](std::size_t range) {
        std::vector<T> list;  // its own memory: beside one another lists would share cache lines
        collect(size * range / ranges, size * (range + 1) / ranges, list);
        lists[range] = std::move(list);
    });
    return joined(workers, std::move(lists));
}

}  // namespace signum
