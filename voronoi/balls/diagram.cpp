#include "diagram.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "../../exact/floating_environment.hpp"
#include "edges.hpp"
#include "hidden_balls.hpp"
#include "set.hpp"
#include "vertices.hpp"

namespace signum {
namespace {

/// Out of line, so that no arithmetic leaves the guard around the call.
[[nodiscard, gnu::noinline]] BallDiagram construct_diagram(std::span<const Site3> balls,
                                                           const Options& options) {
    const balls::BallSet set(balls);
    BallDiagram result;
    result.balls = static_cast<std::int64_t>(balls.size());
    result.hidden = balls::hidden_balls(set);
    const balls::BallVertices found = balls::find_vertices(set, result.hidden, options);
    for (const balls::BallVertex& vertex : found.vertices) {
        result.vertices.add(vertex.all());
        result.spheres.push_back(vertex.sphere);
        result.turns.push_back(vertex.turn);
    }
    balls::find_edges(set, found, result);
    return result;
}

}  // namespace

BallDiagram ball_diagram(std::span<const Site3> balls, const Options& options) {
    if (std::ssize(balls) > max_sites_in_space)
        throw std::invalid_argument("too many balls: " + std::to_string(balls.size()) +
                                    "; at most " + std::to_string(max_sites_in_space));
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (!are_finite(balls[i]))
            throw std::invalid_argument("ball " + std::to_string(i) + " is not finite");
    const exact::IeeeEnvironment environment;
    return construct_diagram(balls, options);
}

}  // namespace signum
