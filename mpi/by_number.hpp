#pragma once
/// Items that the ranks have in the order of their numbers, each a stretch. For sources only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "communicator.hpp"

namespace signum::mpi {

class ByNumber {
 public:
    /// Collective: of so many items of this rank.
    ByNumber(Communicator& ranks, std::size_t own) {
        for (const std::int64_t each :
             ranks.all_of<std::int64_t>(std::array{static_cast<std::int64_t>(own)}))
            begins_.push_back(begins_.back() + each);
    }
    [[nodiscard]] std::int64_t all() const noexcept { return begins_.back(); }
    /// Of a rank; of the one after the last, how many there are.
    [[nodiscard]] std::int64_t first(std::size_t rank) const { return begins_[rank]; }
    [[nodiscard]] std::size_t rank_with(std::int64_t item) const {
        const auto after = std::ranges::upper_bound(begins_, item);
        return static_cast<std::size_t>(after - begins_.begin()) - 1;
    }

 private:
    std::vector<std::int64_t> begins_ = {0};
};

}  // namespace signum::mpi
