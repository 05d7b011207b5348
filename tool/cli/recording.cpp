#include "recording.hpp"

namespace signum::cli {

bool has_frames(std::span<const Target> targets) {
    return std::ranges::any_of(targets,
                               [](const Target& target) { return target.format != "csv"; });
}

template <int D>
Movie::Shapes shapes_of(const motion::Sketch<D>& sketch) {
    Movie::Shapes shapes;
    for (const auto& [box, level, ball] : sketch.areas)
        shapes.boxes.push_back({{box.low[0], box.low[1]}, {box.high[0], box.high[1]}, level, ball});
    for (const auto& [ball, centre, radius] : sketch.rounds)
        shapes.rounds.push_back({centre[0], centre[1], radius, ball});
    for (const auto& [a, b] : sketch.links)
        shapes.links.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    for (const auto& expected : sketch.expected) {
        if (expected.partner >= 0)
            shapes.expected.emplace_back(static_cast<std::size_t>(expected.ball),
                                         static_cast<std::size_t>(expected.partner));
    }
    return shapes;
}

template Movie::Shapes shapes_of(const motion::Sketch<2>&);
template Movie::Shapes shapes_of(const motion::Sketch<3>&);

}  // namespace signum::cli
