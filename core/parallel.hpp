#pragma once
/// Work on several threads. This header's source is the one place that knows the library which runs
/// them, oneTBB; without it everything runs on the calling thread.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

namespace signum {

/// How many threads can run at a time: the cores that the process may use, by its affinity and by
/// the processor time that its control group grants; 1 without a library for threads.
[[nodiscard]] int usable_cores() noexcept;

/// Below so many items, sites most often, one thread works: it is done before others have begun.
inline constexpr std::size_t few_items = 16384;

/// Threads that share work, the calling one among them.
class Workers {
 public:
    /// As many as asked for, 0 being usable_cores(); one where there are few items.
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

}  // namespace signum
