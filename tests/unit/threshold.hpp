#pragma once
/// Where a filter begins to be certain: of a family of questions that moves away from a tie step by
/// step.

#include <cstdint>

#include <gtest/gtest.h>

namespace signum::threshold {

/// The least step in [1, most] at which `is_certain(step)`, by halving: once certain, a filter is
/// so farther from the tie. `most` where it is certain of no lesser one.
template <class IsCertain>
[[nodiscard]] std::int64_t first_certain(std::int64_t most, const IsCertain& is_certain) {
    std::int64_t uncertain = 0;
    std::int64_t certain = most;
    while (uncertain + 1 < certain) {
        const std::int64_t middle = (uncertain + certain) / 2;
        (is_certain(middle) ? certain : uncertain) = middle;
    }
    return certain;
}

/// That the step lies in (least, most].
template <class IsCertain>
void expect_first_certain(const char* what, double least, double most,
                          const IsCertain& is_certain) {
    const auto first = static_cast<double>(first_certain(std::int64_t{1} << 20, is_certain));
    EXPECT_GT(first, least) << what;
    EXPECT_LE(first, most) << what;
}

}  // namespace signum::threshold
