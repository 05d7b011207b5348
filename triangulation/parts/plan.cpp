#include "plan.hpp"

#include <bit>
#include <cstdint>

#include "../../core/insertion_rounds.hpp"
#include "../structure/spatial_order.hpp"

namespace signum::triangulation {
namespace {

/// Cuts the part of node k through the middle of a sample, at a right angle to the axis along which
/// most of it is spread widest. A few sites far out do not count: where those at a cut are cut
/// again, hull and giants reach far along the first cut's axis, and all others lie close to it.
template <std::size_t D>
void cut(std::span<std::array<double, D>> sample, std::size_t k, std::vector<Cut>& cuts) {
    using Place = std::array<double, D>;
    if (k >= cuts.size()) return;
    std::size_t middle = sample.size() / 2;
    if (!sample.empty()) {
        const auto put_in_place = [&](std::size_t place, std::size_t axis) {
            std::ranges::nth_element(sample, sample.begin() + static_cast<std::ptrdiff_t>(place),
                                     {}, [axis](const Place& each) { return each[axis]; });
            return sample[place][axis];
        };
        Place spread{};
        for (std::size_t axis = 0; axis < D; ++axis) {
            const std::size_t eighth = sample.size() / 8;
            // Halved, so that it cannot overflow.
            spread[axis] = 0.5 * put_in_place(sample.size() - 1 - eighth, axis) -
                           0.5 * put_in_place(eighth, axis);
        }
        Cut& here = cuts[k];
        here.axis = static_cast<std::size_t>(std::ranges::max_element(spread) - spread.begin());
        here.at = put_in_place(middle, here.axis);
    }
    cut(sample.first(middle), 2 * k + 1, cuts);
    cut(sample.subspan(middle), 2 * k + 2, cuts);
}

/// Cuts n sites, of which place_of(i) tells where they lie, and returns in which leaf each is: none
/// where there is one leaf. `sampled`: how many a leaf.
template <std::size_t D, class PlaceOf>
LargeArray<std::uint16_t> cut_into_leaves(Plan& plan, std::size_t n, const PlaceOf& place_of,
                                          std::size_t sampled, std::uint64_t seed,
                                          const Workers& workers) {
    if (plan.levels == 0) return {};
    plan.cuts.resize(plan.leaves() - 1);
    std::vector<std::array<double, D>> sample(std::min(n, sampled * plan.leaves()));
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = place_of(mix(seed + i) % n);
    cut(std::span(sample), 0, plan.cuts);

    LargeArray<std::uint16_t> leaf(n);
    workers.each_range(n, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const std::array<double, D> place = place_of(i);
            std::size_t k = 0;
            for (int level = 0; level < plan.levels; ++level) {
                const Cut& here = plan.cuts[k];
                k = 2 * k + 1 + static_cast<std::size_t>(place[here.axis] >= here.at);
            }
            leaf[i] = static_cast<std::uint16_t>(k - plan.cuts.size());
        }
    });
    return leaf;
}

}  // namespace

int levels_for(std::size_t sites, const Workers& workers) noexcept {
    if (workers.count() == 1) return 0;
    const std::size_t leaves =
        std::min(4 * static_cast<std::size_t>(workers.count()), sites / (few_items / 2));
    return std::min(static_cast<int>(std::bit_width(leaves)) - 1, 16);
}

Plan make_plan(const StridedSites& sites, int levels, std::uint64_t seed, const Workers& workers,
               bool with_ranks) {
    const std::size_t n = sites.size();
    Plan plan;
    plan.levels = levels;
    LargeArray<std::uint16_t> leaf = cut_into_leaves<2>(
        plan, n,
        [&](std::size_t i) {
            const Site site = sites[i];
            return std::array{site.x, site.y};
        },
        512, seed, workers);
    plan.numbers = counted<Index>(workers, n);
    AlongCurve along(sites, plan.numbers, seed, workers);
    if (with_ranks) plan.ranks = LargeArray<Index>(n);
    const std::size_t rounds = along.rounds();
    const std::vector<std::size_t> begins = deal(
        workers, n, plan.leaves() * rounds,
        [&](std::size_t k) {
            return (leaf.empty() ? 0 : leaf[along.place(k)] * rounds) + along.round(k);
        },
        [](std::size_t) {},
        [&](std::size_t k, std::size_t place) {
            plan.numbers[place] = static_cast<Index>(along.place(k));
            if (with_ranks) plan.ranks[place] = static_cast<Index>(k);
        });
    for (std::size_t l = 0; l <= plan.leaves(); ++l) plan.begins.push_back(begins[l * rounds]);
    give_back(workers, leaf);
    along.give_back(workers);
    return plan;
}

Plan make_plan(std::span<const Index> given, const PlaceInSpace& place,
               const std::function<void(std::span<Index>)>& order, int levels, std::uint64_t seed,
               const Workers& workers) {
    Plan plan;
    plan.levels = levels;
    const LargeArray<std::uint16_t> leaf = cut_into_leaves<3>(
        plan, given.size(), [&](std::size_t i) { return place(given[i]); }, 8192, seed, workers);
    plan.begins = deal(
        workers, given.size(), plan.leaves(),
        [&](std::size_t i) { return leaf.empty() ? std::size_t{0} : leaf[i]; },
        [&](std::size_t all) { plan.numbers = LargeArray<Index>(all); },
        [&](std::size_t i, std::size_t to) { plan.numbers[to] = given[i]; });
    workers.each(plan.leaves(), [&](std::size_t l) { order(plan.numbers_of(l)); });
    return plan;
}

}  // namespace signum::triangulation
