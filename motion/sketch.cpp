#include "sketch.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

namespace signum::motion {

namespace {

/// One for each ball's box and each cell.
template <int D>
auto key_of(const typename Sketch<D>::Area& area) {
    std::array<double, D> low;
    std::ranges::copy(area.box.low, low.begin());
    return std::tuple(area.ball, area.level, low);
}

}  // namespace

template <int D>
void put_in_order(Sketch<D>& sketch, std::span<const std::int32_t> numbers,
                  const Effects<D>& effects) {
    for (auto& round : sketch.rounds)
        for (int k = 0; k < D; ++k) round.centre[k] = in_box(round.centre[k], k, effects);
    const auto renumber = [&](std::int32_t& ball) {
        if (ball >= 0) ball = numbers[static_cast<std::size_t>(ball)];
    };
    for (auto& area : sketch.areas) renumber(area.ball);
    for (auto& round : sketch.rounds) renumber(round.ball);
    for (auto& [a, b] : sketch.links) {
        renumber(a);
        renumber(b);
        if (a > b) std::swap(a, b);
    }
    for (auto& expected : sketch.expected) {
        renumber(expected.ball);
        renumber(expected.partner);
    }
    std::ranges::sort(sketch.areas, {}, key_of<D>);
    const auto is_again = [](const auto& a, const auto& b) { return key_of<D>(a) == key_of<D>(b); };
    sketch.areas.erase(std::unique(sketch.areas.begin(), sketch.areas.end(), is_again),
                       sketch.areas.end());
    std::ranges::sort(sketch.rounds, {}, &Sketch<D>::Round::ball);
    std::ranges::sort(sketch.links);
    std::ranges::sort(sketch.expected, {}, &Sketch<D>::Expected::ball);
}

template void put_in_order(Sketch<2>&, std::span<const std::int32_t>, const Effects<2>&);
template void put_in_order(Sketch<3>&, std::span<const std::int32_t>, const Effects<3>&);

}  // namespace signum::motion
