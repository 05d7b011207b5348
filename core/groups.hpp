#pragma once
/// Which of many things belong together, as one learns it pair by pair: union-find. For sources
/// only.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace signum {

/// Things 0 … n - 1. A group is named by its least one.
class Groups {
 public:
    /// Each alone.
    explicit Groups(std::size_t things = 0) : above_(things) {
        std::iota(above_.begin(), above_.end(), std::size_t{0});
    }
    /// Each with the one that is said, which does not come after it.
    explicit Groups(std::vector<std::size_t> above) : above_(std::move(above)) {}

    [[nodiscard]] std::size_t of(std::size_t thing) noexcept {
        while (above_[thing] != thing) thing = above_[thing] = above_[above_[thing]];
        return thing;
    }
    void join(std::size_t a, std::size_t b) noexcept {
        a = of(a);
        b = of(b);
        above_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<std::size_t> above_;
};

}  // namespace signum
