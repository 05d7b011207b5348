#include "box_edges.hpp"

#include <array>

namespace signum {

std::vector<EdgePart> edge_parts(std::span<const EdgeEnd> ends, bool is_whole_box) {
    constexpr int edges = 12;
    std::array<std::array<const EdgeEnd*, 2>, edges> found{};
    for (const EdgeEnd& each : ends)
        found[static_cast<std::size_t>(each.edge)][each.is_high ? 1 : 0] = &each;
    // A bit for each corner of the box that is in the cell: where a part has no end, and at both
    // ends of an edge that no face cuts.
    const auto bit_of = [](BoxEdge edge, bool is_high) {
        unsigned corner = 0;
        for (const Side side : {edge.next(), edge.last(), edge.end(is_high)})
            if (side.is_high()) corner |= 1U << side.axis_number();
        return 1U << corner;
    };
    unsigned corners = is_whole_box ? 255U : 0U;
    for (int round = 0; round < 4; ++round)
        for (int number = 0; number < edges; ++number) {
            const BoxEdge edge(number);
            const auto& [low, high] = found[static_cast<std::size_t>(number)];
            const unsigned low_bit = bit_of(edge, false);
            const unsigned high_bit = bit_of(edge, true);
            if (low != nullptr && high == nullptr) corners |= high_bit;
            if (low == nullptr && high != nullptr) corners |= low_bit;
            if (low == nullptr && high == nullptr && (corners & (low_bit | high_bit)) != 0)
                corners |= low_bit | high_bit;
        }
    std::vector<EdgePart> result;
    for (int number = 0; number < edges; ++number) {
        const auto& [low, high] = found[static_cast<std::size_t>(number)];
        const BoxEdge edge(number);
        if (low != nullptr || high != nullptr || (corners & bit_of(edge, false)) != 0)
            result.push_back({edge, low, high});
    }
    return result;
}

Box3 ends_of(const EdgePart& part, const Box3& box) noexcept {
    const auto end = [&](const EdgeEnd* known, bool is_high) {
        Point3 place = known != nullptr ? known->place : Point3{};
        if (known == nullptr) {
            const Side side = part.edge.end(is_high);
            place.*side.axis() = side.of(box);
        }
        for (const Side side : {part.edge.next(), part.edge.last()})
            place.*side.axis() = side.of(box);
        return place;
    };
    return {end(part.low, false), end(part.high, true)};
}

}  // namespace signum
