#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "progress.hpp"

namespace signum::cli {
namespace {

constexpr int width = 40;

}  // namespace

Progress::Progress(bool quiet)
    : start_(std::chrono::steady_clock::now()), is_seen_(!quiet && ::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (shown_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share) noexcept {
    if (!is_seen_) return;
    const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
    if (percent == shown_) return;
    if (std::chrono::steady_clock::now() - start_ < std::chrono::seconds(1)) return;
    shown_ = percent;
    char bar[width + 1] = {};
    std::fill(bar, bar + width, ' ');
    std::fill(bar, bar + percent * width / 100, '#');
    std::fprintf(stderr, "\r[%s] %3d %%", bar, percent);
    std::fflush(stderr);
}

}  // namespace signum::cli
