#pragma once
/// What a cell of the study of moving balls is about.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "../rows.hpp"

namespace signum::study {

/// Discs in a box that shakes. The names are the columns of the table.
struct MotionSetting {
    std::string experiment;
    std::int64_t balls = 0;
    double size_ratio = 1.0;  ///< the largest radius to the smallest
    double packing = 0.0;     ///< the share of the box that balls fill
    double time_step = 0.0;   ///< in seconds; 0: from event to event

    static constexpr std::array<std::string_view, 5> columns = {"experiment", "balls", "size_ratio",
                                                                "packing", "time_step"};
    template <class Self>
    [[nodiscard]] static auto fields(Self& self) {
        return std::tie(self.experiment, self.balls, self.size_ratio, self.packing, self.time_step);
    }
    friend bool operator==(const MotionSetting&, const MotionSetting&) = default;
};
using MotionRow = RowOf<MotionSetting>;

}  // namespace signum::study
