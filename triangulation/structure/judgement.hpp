#pragma once
/// How a check of a tessellation comes to its judgement.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../core/index.hpp"
#include "../../core/parallel.hpp"
#include "../../exact/floating_environment.hpp"
#include "../validate.hpp"
#include "watch.hpp"

namespace signum::triangulation {

[[nodiscard]] inline std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

[[nodiscard]] inline std::string name(Index vertex) {
    return vertex == infinite ? "infinity" : "site " + std::to_string(vertex);
}

/// Why the arrays are no valid tessellation.
struct Invalid {
    std::string why;
};

/// Does two things by two threads, where there are so many; see BoxTree.
[[nodiscard]] inline auto both_by(const Workers& workers) {
    return [&workers](const auto& first, const auto& second) {
        workers.each(2, [&](std::size_t which) {
            const exact::IeeeEnvironment environment;
            which == 0 ? first() : second();
        });
    };
}
/// Of so many items each thread has a few parts.
[[nodiscard]] inline std::size_t most_alone(const Workers& workers, std::size_t items) noexcept {
    if (workers.count() == 1) return items;
    return std::max(items / (4 * static_cast<std::size_t>(workers.count())), few_items);
}

/// What is said of a site.
enum class Seen : std::uint8_t { nowhere, as_vertex, as_hidden };

/// Notes a vertex, as others may do at the same time.
inline void see_vertex(Seen& site) noexcept {
    std::atomic_ref(site).store(Seen::as_vertex, std::memory_order_relaxed);
}
/// Notes who is said to be hidden. Vertices have been noted.
inline void see_hidden(std::span<const Hidden> hidden, std::vector<Seen>& seen) {
    const auto n = static_cast<std::int64_t>(seen.size());
    for (const auto& [site, by] : hidden) {
        for (const Index each : {site, by})
            if (each < 0 || each >= n)
                throw Invalid{"hidden: there is no site " + std::to_string(each)};
        if (seen[at(site)] != Seen::nowhere)
            throw Invalid{name(site) + (seen[at(site)] == Seen::as_vertex
                                            ? " is both visible and hidden"
                                            : " is hidden twice")};
        seen[at(site)] = Seen::as_hidden;
    }
}
/// Every site is a vertex or hidden by one.
inline void check_seen(std::span<const Hidden> hidden, const std::vector<Seen>& seen) {
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] == Seen::nowhere)
            throw Invalid{name(static_cast<Index>(i)) + " is neither visible nor hidden"};
    for (const auto& [site, by] : hidden)
        if (seen[at(by)] != Seen::as_vertex)
            throw Invalid{name(site) + " is hidden by " + name(by) + ", which is hidden itself"};
}

/// What is right but not the canonical choice: the first of it.
class Notes {
 public:
    void note(const std::string& why) {
        if (first_.empty()) first_ = why;
    }
    [[nodiscard]] bool is_canonical() const noexcept { return first_.empty(); }
    [[nodiscard]] const std::string& first() const noexcept { return first_; }

 private:
    std::string first_;
};

/// What is wrong is thrown as Invalid; what is right but not the canonical choice is noted. Several
/// threads say what one says: the first of what there is, in the order of faces, cells or sites.
class Judgement {
 protected:
    /// `all`: how often advance() will be called, or what stands for it; `items`: how many faces,
    /// cells or sites there are.
    Judgement(const ValidationOptions& options, std::size_t all, std::size_t items)
        : workers_(options.threads, items), watch_(options.stop, options.progress, all) {}

    [[nodiscard]] const Workers& workers() const noexcept { return workers_; }

    /// One more face, cell or hidden site is done.
    void advance() { loop_.step(); }
    void note(const std::string& why) { notes_.note(why); }
    [[nodiscard]] bool is_canonical() const noexcept { return notes_.is_canonical(); }
    [[nodiscard]] const Notes& notes() const noexcept { return notes_; }

    /// Calls judge(part, i) for 0 … size in ranges, one after the other or by several threads; each
    /// range has a part of its own, a copy of `fresh`, whose Notes are those so far. Then
    /// merge(part) for the ranges in their order, up to the first with something that is Invalid,
    /// which is thrown. An i stands for so many calls of advance().
    template <class Part, class Judge, class Merge>
    void judge_each(std::size_t size, std::size_t advances, const Part& fresh, const Judge& judge,
                    const Merge& merge) {
        struct Outcome {
            std::optional<Part> part;
            std::optional<Invalid> invalid;
        };
        const std::size_t ranges = workers_.range_count(size);
        std::vector<Outcome> outcomes(ranges);
        std::atomic<std::size_t> last = ranges;  // the first range that is known to end early
        workers_.each(ranges, [&](std::size_t range) {
            if (range > last) return;
            const exact::IeeeEnvironment environment;
            Part part = fresh;
            std::optional<Invalid> invalid;
            const std::size_t end = size * (range + 1) / ranges;
            Watch::Loop own(watch_);
            Watch::Loop& loop = ranges == 1 ? loop_ : own;
            try {
                for (std::size_t i = size * range / ranges; i < end; ++i) {
                    judge(part, i);
                    for (std::size_t k = 0; k < advances; ++k) loop.step();
                }
            } catch (Invalid& found) {
                invalid = std::move(found);
                std::size_t known = last;
                while (range < known && !last.compare_exchange_weak(known, range)) {
                }
            }
            outcomes[range] = {std::move(part), std::move(invalid)};
        });
        for (const auto& [part, invalid] : outcomes) {
            merge(*part);
            if (!part->is_canonical()) note(part->first());
            if (invalid) throw Invalid(*invalid);
        }
    }
    /// The same where there is nothing to merge.
    template <class Judge>
    void judge_each(std::size_t size, std::size_t advances, const Judge& judge) {
        judge_each(
            size, advances, notes(), [&](Notes& notes, std::size_t i) { judge(notes, i); },
            [](const Notes&) {});
    }

    /// The judgement of the checks that `all` makes.
    template <class Checks>
    [[nodiscard]] Validation judgement(Checks all) {
        Validation result;
        try {
            all();
            result.valid = true;
            result.canonical = is_canonical();
            result.message = notes_.first();
        } catch (const Invalid& invalid) {
            result.message = invalid.why;
        }
        return result;
    }

 private:
    Workers workers_;
    Watch watch_;
    Watch::Loop loop_{watch_};
    Notes notes_;
};

}  // namespace signum::triangulation
