#pragma once
/// A progress bar on standard error: on a terminal alone, and after one second of work.

#include <chrono>

#include "../../triangulation/validate.hpp"

namespace signum::cli {

class Progress {
 public:
    Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Wipes the bar.
    ~Progress();

    /// Shows the share of the work done, from 0 to 1; cheap when nothing changes.
    void show(double share) noexcept;

 private:
    std::chrono::steady_clock::time_point start_;
    bool on_terminal_;
    int shown_ = -1;  ///< per cent on the screen; -1 while there is no bar
};

/// validate() with a bar unless quiet.
[[nodiscard]] Validation validate_with_progress(const TessellationArrays& arrays,
                                                StridedSites sites, bool quiet);

}  // namespace signum::cli
