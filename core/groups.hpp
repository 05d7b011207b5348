#pragma once
/// Which of many things belong together, as one learns it pair by pair: union-find. For sources
/// only.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace signum {

/// Things 0 … n - 1, 2^32 at most. A group is named by its least one.
class Groups {
 public:
    explicit Groups(std::size_t things = 0) : above_(things) {
        std::iota(above_.begin(), above_.end(), 0U);
    }
    [[nodiscard]] std::size_t of(std::size_t thing) noexcept {
        while (above_[thing] != thing) {
            above_[thing] = above_[above_[thing]];
            thing = above_[thing];
        }
        return thing;
    }
    void join(std::size_t a, std::size_t b) noexcept {
        a = of(a);
        b = of(b);
        above_[std::max(a, b)] = static_cast<std::uint32_t>(std::min(a, b));
    }

 private:
    std::vector<std::uint32_t> above_;
};

}  // namespace signum
