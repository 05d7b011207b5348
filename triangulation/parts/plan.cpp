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
    if (levels == 0) {
        plan.begins = {0, n};
        plan.numbers = spatial_order(sites, seed);
        return plan;
    }
    plan.levels = levels;
    plan.cuts.resize(plan.leaves() - 1);
    std::vector<Place> sample(std::min(n, 512 * plan.leaves()));
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = place_of(sites, mix(seed + i) % n);
    cut(sample, 0, plan.cuts);

    LargeArray<std::uint16_t> leaf(n);
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Place place = place_of(sites, i);
            std::size_t k = 0;
            for (int level = 0; level < levels; ++level) {
                const Cut& here = plan.cuts[k];
                k = 2 * k + 1 + static_cast<std::size_t>(place[here.axis] >= here.at);
            }
            leaf[i] = static_cast<std::uint16_t>(k - plan.cuts.size());
        }
    });
    plan.begins = deal(
        workers, n, plan.leaves(), [&](std::size_t i) { return leaf[i]; },
        [&](std::size_t all) { plan.numbers = LargeArray<Index>(all); },
        [&](std::size_t i, std::size_t place) { plan.numbers[place] = static_cast<Index>(i); });
    workers.each(plan.leaves(), [&](std::size_t l) {
        order_spatially(
            sites,
            std::span(plan.numbers).subspan(plan.begins[l], plan.begins[l + 1] - plan.begins[l]),
            seed);
    });
    return plan;
}

}  // namespace signum::triangulation
