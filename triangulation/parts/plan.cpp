#include "plan.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "../../core/insertion_rounds.hpp"
#include "../structure/spatial_order.hpp"

namespace signum::triangulation {
namespace {

using Place = std::array<double, 2>;

Place place_of(const StridedSites& sites, std::size_t i) noexcept {
    const Site site = sites[i];
    return {site.x, site.y};
}

/// Cuts the part of node k through the middle of a sample, across its longer side.
void cut(std::span<Place> sample, std::size_t k, std::vector<Cut>& cuts) {
    if (k >= cuts.size()) return;
    std::size_t middle = sample.size() / 2;
    if (!sample.empty()) {
        std::array<double, 2> extent{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const auto [least, greatest] =
                std::ranges::minmax(sample, {}, [axis](const Place& place) { return place[axis]; });
            // Halved, so that it cannot overflow.
            extent[axis] = 0.5 * greatest[axis] - 0.5 * least[axis];
        }
        Cut& here = cuts[k];
        here.axis = extent[1] > extent[0] ? 1 : 0;
        const auto coordinate = [&](const Place& place) { return place[here.axis]; };
        std::ranges::nth_element(sample, sample.begin() + static_cast<std::ptrdiff_t>(middle), {},
                                 coordinate);
        here.at = sample[middle][here.axis];
    }
    cut(sample.first(middle), 2 * k + 1, cuts);
    cut(sample.subspan(middle), 2 * k + 2, cuts);
}

}  // namespace

int levels_for(std::size_t sites, const Workers& workers) noexcept {
    if (workers.count() == 1) return 0;
    const std::size_t leaves =
        std::min(4 * static_cast<std::size_t>(workers.count()), sites / (few_items / 2));
    return std::min(static_cast<int>(std::bit_width(leaves)) - 1, 16);
}

Plan make_plan(const StridedSites& sites, int levels, std::uint64_t seed, const Workers& workers) {
    const std::size_t n = sites.size();
    Plan plan;
    plan.levels = levels;
    plan.cuts.resize(plan.leaves() - 1);
    std::vector<Place> sample(std::min(n, 512 * plan.leaves()));
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = place_of(sites, mix(seed + i) % n);
    cut(sample, 0, plan.cuts);

    const auto leaf_of = [&](std::size_t i) {
        const Place place = place_of(sites, i);
        std::size_t k = 0;
        for (int level = 0; level < plan.levels; ++level) {
            const Cut& here = plan.cuts[k];
            k = 2 * k + 1 + static_cast<std::size_t>(place[here.axis] >= here.at);
        }
        return k - plan.cuts.size();
    };
    const std::size_t ranges = workers.range_count(n);
    const auto each_range = [&](const auto& task) {
        workers.each(ranges, [&](std::size_t range) {
            for (std::size_t i = n * range / ranges; i < n * (range + 1) / ranges; ++i)
                task(range, i);
        });
    };
    // How many sites of each range go to each leaf; then where the next of them goes.
    std::vector<std::size_t> next(ranges * plan.leaves(), 0);
    LargeArray<std::uint16_t> leaf(n);
    each_range([&](std::size_t range, std::size_t i) {
        leaf[i] = static_cast<std::uint16_t>(leaf_of(i));
        ++next[range * plan.leaves() + leaf[i]];
    });
    std::size_t sum = 0;
    for (std::size_t l = 0; l < plan.leaves(); ++l) {
        plan.begins.push_back(sum);
        for (std::size_t range = 0; range < ranges; ++range)
            sum += std::exchange(next[range * plan.leaves() + l], sum);
    }
    plan.begins.push_back(n);
    plan.numbers = LargeArray<Index>(n);
    each_range([&](std::size_t range, std::size_t i) {
        plan.numbers[next[range * plan.leaves() + leaf[i]]++] = static_cast<Index>(i);
    });
    workers.each(plan.leaves(), [&](std::size_t l) {
        order_spatially(
            sites,
            std::span(plan.numbers).subspan(plan.begins[l], plan.begins[l + 1] - plan.begins[l]),
            seed);
    });
    return plan;
}

}  // namespace signum::triangulation
