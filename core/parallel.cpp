#include "parallel.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#if !defined(SIGNUM_WITHOUT_TBB)
#include <sys/mman.h>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#endif

#if defined(SIGNUM_THREAD_SANITIZER)
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif

namespace signum {

#if !defined(SIGNUM_WITHOUT_TBB)

namespace {

/// How many cores' time a control group of Linux grants, version 2 of their interface or 1;
/// infinity where it sets no limit.
double granted_cores(const std::string& group, bool is_unified) {
    const auto unlimited = HUGE_VAL;
    double quota = unlimited;
    double period = 0.0;
    if (is_unified) {
        std::ifstream file("/sys/fs/cgroup" + group + "/cpu.max");
        if (!(file >> quota >> period)) return unlimited;  // "max 100000" is no number
    } else {
        std::ifstream("/sys/fs/cgroup/cpu" + group + "/cpu.cfs_quota_us") >> quota;
        std::ifstream("/sys/fs/cgroup/cpu" + group + "/cpu.cfs_period_us") >> period;
    }
    return quota > 0.0 && period > 0.0 ? quota / period : unlimited;
}

/// The least of all groups that the process is in. A container sees its own group as the root.
double granted_cores() {
    double least = std::min(granted_cores("", true), granted_cores("", false));
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        const std::size_t first = line.find(':');
        const std::size_t second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        const bool is_unified = controllers.empty();
        if (!is_unified && controllers.find("cpu") == std::string::npos) continue;
        for (std::string path = line.substr(second + 1); path.size() > 1;
             path.erase(path.rfind('/')))
            least = std::min(least, granted_cores(path, is_unified));
    }
    return least;
}

}  // namespace

int usable_cores() noexcept {
    static const int cores = [] {
        const int by_affinity = tbb::info::default_concurrency();
        try {
            const double granted = std::ceil(granted_cores());
            return granted < by_affinity ? std::max(1, static_cast<int>(granted)) : by_affinity;
        } catch (...) {
            return by_affinity;  // what cannot be read sets no limit
        }
    }();
    return cores;
}

namespace {

/// What the thread sanitizer does not see, for the library for threads is compiled without it:
/// tasks follow what was done before the call, and what is done after it follows all of them, also
/// where one throws.
class Order {
 public:
#if defined(SIGNUM_THREAD_SANITIZER)
    Order() {
        __tsan_release(&begin_);
    }
    ~Order() {
        __tsan_acquire(&end_);
    }

    class Task {
     public:
        explicit Task(Order& order) : order_(order) { __tsan_acquire(&order_.begin_); }
        ~Task() { __tsan_release(&order_.end_); }

     private:
        Order& order_;
    };

 private:
    char begin_ = 0;
    char end_ = 0;
#else
    struct Task {
        explicit Task(Order& /*order*/) {}
    };
#endif
};

/// Whether so many more threads can be started: that many are, and do nothing; and for each there
/// are the addresses that its stack takes and, for a while, the C library for its memory.
bool can_start(int count) {
    constexpr std::size_t each = std::size_t{8 + 128} << 20;
    const std::size_t size = each * static_cast<std::size_t>(count);
    void* const range =
        ::mmap(nullptr, size, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (range == MAP_FAILED) return false;
    ::munmap(range, size);
    std::atomic<bool> is_over = false;
    std::vector<std::thread> tried;
    try {
        while (std::ssize(tried) < count) tried.emplace_back([&] { is_over.wait(false); });
    } catch (const std::exception&) {
        // Fewer.
    }
    is_over = true;
    is_over.notify_all();
    for (std::thread& thread : tried) thread.join();
    return std::ssize(tried) == count;
}

/// Has oneTBB start its threads up to so many, and waits for them, though not for ever.
void start(int count) {
    // Not taken away at the end: threads would go with the last arena.
    static tbb::task_arena* keeps_threads = nullptr;
    if (keeps_threads == nullptr) (keeps_threads = new tbb::task_arena(2))->initialize();
    // One limit for all, for of several the least would hold.
    static tbb::global_control* limit = nullptr;
    if (count > tbb::info::default_concurrency()) {
        delete std::exchange(limit, nullptr);
        limit = new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                        static_cast<std::size_t>(count));
    }
    std::atomic<int> arrived = 0;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
    tbb::task_arena(count).execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, count, 1),
            [&](const tbb::blocked_range<int>&) {
                ++arrived;
                while (arrived < count && std::chrono::steady_clock::now() < deadline)
                    std::this_thread::yield();
            },
            tbb::simple_partitioner{});
    });
}

/// How many threads, up to so many, can work at a time. oneTBB ends the program where one of its
/// own does not start: it is asked for no more than have been tried, all at once or, where there is
/// no room for all, a few after the others.
int startable(int count) {
    static std::mutex one_at_a_time;
    static int started = 1;  // the calling thread among them
    const std::scoped_lock lock(one_at_a_time);
    for (int step = count - started; step > 0 && started < count;
         step = std::min(step, count - started))
        if (can_start(step))
            start(started += step);
        else
            step /= 2;
    return std::min(count, started);
}

}  // namespace

struct Workers::Threads {
    explicit Threads(int count) : arena(count) {}
    tbb::task_arena arena;
};

void Workers::each(std::size_t tasks, const std::function<void(std::size_t)>& task) const {
    if (threads_ == nullptr || tasks < 2) {
        for (std::size_t i = 0; i < tasks; ++i) task(i);
        return;
    }
    [[maybe_unused]] Order order;
    threads_->arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, tasks, 1),
            [&](const tbb::blocked_range<std::size_t>& range) {
                [[maybe_unused]] const Order::Task one(order);
                for (std::size_t i = range.begin(); i < range.end(); ++i) task(i);
            },
            tbb::simple_partitioner{});
    });
}

#else

int usable_cores() noexcept {
    return 1;
}

struct Workers::Threads {
    explicit Threads(int /*count*/) {}
};

namespace {
int startable(int count) noexcept {
    return count;  // by one after the other
}
}  // namespace

void Workers::each(std::size_t tasks, const std::function<void(std::size_t)>& task) const {
    for (std::size_t i = 0; i < tasks; ++i) task(i);
}

#endif

Workers::Workers(int threads, std::size_t items)
    : count_(items < few_items ? 1
             : threads > 0     ? threads
                               : usable_cores()) {
    if (threads < 0 || threads > most_threads)
        throw std::invalid_argument(std::to_string(threads) + " threads; 0 to " +
                                    std::to_string(most_threads) +
                                    " are possible, 0 for as many as there are cores to use");
    if (count_ > 1) count_ = startable(count_);
    if (count_ > 1) threads_ = std::make_unique<Threads>(count_);
}

Workers::~Workers() = default;

}  // namespace signum
