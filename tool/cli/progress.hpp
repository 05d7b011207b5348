#pragma once
/// A progress bar on standard error: on a terminal alone, after one second of work, and never where
/// a call is quiet.

#include <chrono>
#include <functional>

#include "../../triangulation/space/validate.hpp"
#include "../../triangulation/validate.hpp"

namespace signum::cli {

class Progress {
 public:
    explicit Progress(bool quiet);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Wipes the bar.
    ~Progress();

    /// Shows the share of the work done, from 0 to 1; cheap when nothing changes.
    void show(double share) noexcept;

 private:
    std::chrono::steady_clock::time_point start_;
    bool is_seen_;
    int shown_ = -1;  ///< per cent on the screen; -1 while there is no bar
};

/// What `work` makes, given what shows the share of it that is done: nothing where it is quiet.
template <class Work>
auto with_progress(bool quiet, const Work& work) {
    Progress bar(quiet);
    std::function<void(double)> show;
    if (!quiet) show = [&](double share) { bar.show(share); };
    return work(show);
}

/// validate() with a bar unless quiet.
template <class Tessellation, class Sites>
[[nodiscard]] Validation validate_with_progress(const Tessellation& tessellation,
                                                const Sites& sites, bool quiet, int threads) {
    return with_progress(quiet, [&](const std::function<void(double)>& show) {
        return validate(tessellation, sites, {.progress = show, .threads = threads});
    });
}

}  // namespace signum::cli
