#include "plan.hpp"

#include <bit>
#include <cstdint>
#include <utility>

#include "../../core/insertion_rounds.hpp"
#include "../structure/spatial_order.hpp"

namespace signum::triangulation {
namespace {

/// Cuts the part of node k through the middle of a sample, across its longest side.
template <std::size_t D>
void cut(std::span<std::array<double, D>> sample, std::size_t k, std::vector<Cut>& cuts) {
    using Place = std::array<double, D>;
    if (k >= cuts.size()) return;
    std::size_t middle = sample.size() / 2;
    if (!sample.empty()) {
        Place extent{};
        for (std::size_t axis = 0; axis < D; ++axis) {
            const auto [least, greatest] =
                std::ranges::minmax(sample, {}, [axis](const Place& place) { return place[axis]; });
            // Halved, so that it cannot overflow.
            extent[axis] = 0.5 * greatest[axis] - 0.5 * least[axis];
        }
        Cut& here = cuts[k];
        here.axis = static_cast<std::size_t>(std::ranges::max_element(extent) - extent.begin());
        const auto coordinate = [&](const Place& place) { return place[here.axis]; };
        std::ranges::nth_element(sample, sample.begin() + static_cast<std::ptrdiff_t>(middle), {},
                                 coordinate);
        here.at = sample[middle][here.axis];
    }
    cut(sample.first(middle), 2 * k + 1, cuts);
    cut(sample.subspan(middle), 2 * k + 2, cuts);
}

/// Of n sites, whose number and place are asked for by where they stand in what is given, and
/// place_of(where) of some in advance. `sampled`: how many a leaf.
template <std::size_t D, class NumberOf, class PlaceOf, class Order>
Plan plan_of(std::size_t n, const NumberOf& number_of, const PlaceOf& place_of, const Order& order,
             std::size_t sampled, int levels, std::uint64_t seed, const Workers& workers) {
    Plan plan;
    plan.levels = levels;
    plan.cuts.resize(plan.leaves() - 1);
    std::vector<std::array<double, D>> sample(levels == 0 ? 0
                                                          : std::min(n, sampled * plan.leaves()));
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = place_of(mix(seed + i) % n);
    cut(std::span(sample), 0, plan.cuts);

    LargeArray<std::uint16_t> leaf(n);
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::array<double, D> place = place_of(i);
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
        [&](std::size_t i, std::size_t place) { plan.numbers[place] = number_of(i); });
    workers.each(plan.leaves(), [&](std::size_t l) { order(plan.numbers_of(l)); });
    return plan;
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
    if (levels == 0) {
        Plan plan;
        plan.begins = {0, n};
        plan.numbers = spatial_order(sites, seed);
        return plan;
    }
    return plan_of<2>(
        n, [](std::size_t i) { return static_cast<Index>(i); },
        [&](std::size_t i) {
            const Site site = sites[i];
            return std::array{site.x, site.y};
        },
        [&](std::span<Index> numbers) { order_spatially(sites, numbers, seed); }, 512, levels, seed,
        workers);
}

Plan make_plan(std::span<const Index> given, const PlaceInSpace& place,
               const std::function<void(std::span<Index>)>& order, int levels, std::uint64_t seed,
               const Workers& workers) {
    return plan_of<3>(
        given.size(), [&](std::size_t i) { return given[i]; },
        [&](std::size_t i) { return place(given[i]); }, order, 8192, levels, seed, workers);
}

}  // namespace signum::triangulation
