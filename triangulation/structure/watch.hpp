#pragma once
/// Long work that its caller watches: it says how far it has come, and stops where it is asked to.

#include <cstddef>
#include <functional>
#include <stop_token>

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
        if (done % period_ != 0) return;
        if (stop_.stop_requested()) throw Stopped();
        if (!progress_) return;
        const exact::KeptEnvironment kept;
        progress_(static_cast<double>(done) / static_cast<double>(all_));
    }

 private:
    const std::stop_token& stop_;
    const std::function<void(double)>& progress_;
    std::size_t all_;
    std::size_t period_;
};

}  // namespace signum::triangulation
