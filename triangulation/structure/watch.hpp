#pragma once
/// Long work that its caller watches: it says how far it has come, and stops where it is asked to.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <stop_token>
#include <thread>

#include "../../exact/kept_environment.hpp"
#include "../options.hpp"

namespace signum::triangulation {

/// Calls the user back every so many units of work.
class Watch {
 public:
    /// Neither is copied.
    Watch(const std::stop_token& stop, const std::function<void(double)>& progress, std::size_t all,
          std::size_t period = 4096) noexcept
        : stop_(stop), progress_(progress), all_(all), period_(period) {}

    /// So many units are done. Throws Stopped.
    void at(std::size_t done) const {
        if (done % period_ == 0) tell(done);
    }

    /// One loop of several, on whatever thread: says one unit after the other.
    class Loop {
     public:
        explicit Loop(const Watch& watch) noexcept : watch_(watch) {}
        /// One more is done. Throws Stopped, also where another loop has failed.
        void step() {
            if (++own_ % watch_.period_ != 0) return;
            const std::size_t done = watch_.done_ += watch_.period_;
            if (watch_.has_failed_) throw Stopped();
            watch_.tell(done);
        }

     private:
        const Watch& watch_;
        std::size_t own_ = 0;
    };

    /// A part of the work, on whatever thread; where it throws, other loops stop.
    template <class Work>
    void guard(const Work& work) const {
        try {
            work();
        } catch (...) {
            if (!has_failed_.exchange(true)) failure_ = std::current_exception();
            throw;
        }
    }
    /// All of the work, which may have several parts: throws what the first of them threw. Not
    /// within a part.
    template <class Work>
    void guard_all(const Work& work) const {
        try {
            work();
        } catch (...) {
            if (failure_) std::rethrow_exception(failure_);
            throw;
        }
    }
    /// Everything is done.
    void end() const { tell(all_); }

 private:
    void tell(std::size_t done) const {
        if (stop_.stop_requested()) throw Stopped();
        if (!progress_ || std::this_thread::get_id() != caller_) return;
        const exact::KeptEnvironment kept;
        // Sites at a cut are inserted twice, and all where parts do not help: more units than are
        // known in advance.
        const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(all_));
        told_ = std::max(told_, share);
        progress_(told_);
    }

    const std::stop_token& stop_;
    const std::function<void(double)>& progress_;
    std::size_t all_;
    std::size_t period_;
    std::thread::id caller_ = std::this_thread::get_id();
    mutable double told_ = 0.0;  ///< by the calling thread
    mutable std::atomic<std::size_t> done_ = 0;
    mutable std::atomic<bool> has_failed_ = false;
    mutable std::exception_ptr failure_;  ///< read when all parts have ended
};

}  // namespace signum::triangulation
