#include "order.hpp"

#include <numeric>
#include <vector>

#include "../../core/insertion_rounds.hpp"
#include "../../core/pages.hpp"
#include "../structure/curve_order.hpp"

namespace signum::spatial {

void put_in_insertion_order(std::span<Index> sites, const std::function<Point3(Index)>& place,
                            std::uint64_t seed) {
    const LargeArray<Index> given(sites.begin(), sites.end());
    const InsertionRounds rounds(given.size(), seed);
    // The sites of each round, one round after the other.
    std::vector<std::size_t> sizes(static_cast<std::size_t>(rounds.last()) + 1);
    const auto round_of = [&](std::size_t i) {
        return static_cast<std::size_t>(rounds.of(static_cast<std::size_t>(given[i])));
    };
    for (std::size_t i = 0; i < given.size(); ++i) ++sizes[round_of(i)];
    std::vector<std::size_t> begins(sizes.size());
    for (std::size_t r = 1; r < sizes.size(); ++r) begins[r] = begins[r - 1] + sizes[r - 1];
    LargeArray<std::uint64_t> keys(given.size());
    expect_writes(keys);
    std::vector<std::size_t> next = begins;
    for (std::size_t i = 0; i < given.size(); ++i) keys[next[round_of(i)]++] = i;
    constexpr CurveKeys layout{32, 10};
    const Workers one(1);
    for (std::size_t r = 0; r < sizes.size(); ++r)
        sort_along_curve<3>(
            {keys.data() + begins[r], sizes[r]}, layout,
            [&](std::size_t i) {
                const Point3 p = place(given[i]);
                return std::array{p.x, p.y, p.z};
            },
            one);
    for (std::size_t i = 0; i < given.size(); ++i) sites[i] = given[layout.item(keys[i])];
}

LargeArray<Index> insertion_order(std::size_t sites, const std::function<Point3(Index)>& place,
                                  std::uint64_t seed) {
    LargeArray<Index> result(sites);
    std::iota(result.begin(), result.end(), 0);
    put_in_insertion_order(result, place, seed);
    return result;
}

}  // namespace signum::spatial
