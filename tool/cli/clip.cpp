#include "clip.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "commands.hpp"

namespace signum::cli {

void add_clip(CLI::App& command, std::vector<double>& clip, const std::string& description,
              bool in_space) {
    const char* const numbers = in_space ? "X0 Y0 [Z0] X1 Y1 [Z1]" : "X0 Y0 X1 Y1";
    add_checked(command, "--clip", clip, numbers, finite_number(), description)
        ->option_text(numbers)
        ->expected(4, in_space ? 6 : 4);
}

void require_numbers(const std::vector<double>& clip, std::size_t count, const std::string& input) {
    if (clip.empty() || clip.size() == count) return;
    throw CallError(fmt::format("--clip: {} numbers, but the sites of {} lie in {}; give {}",
                                clip.size(), input, count == 4 ? "the plane" : "space",
                                count == 4 ? "X0 Y0 X1 Y1" : "X0 Y0 Z0 X1 Y1 Z1"));
}

std::optional<Box3> box_in_space_of(const std::vector<double>& clip) {
    if (clip.empty()) return std::nullopt;
    const Box3 box = {{clip[0], clip[1], clip[2]}, {clip[3], clip[4], clip[5]}};
    if (!(box.low.x < box.high.x && box.low.y < box.high.y && box.low.z < box.high.z)) {
        throw CallError(
            fmt::format("--clip {}: the corner with the least coordinates comes first, x0 < x1, "
                        "y0 < y1 and z0 < z1",
                        fmt::join(clip, " ")));
    }
    return box;
}

std::optional<Box> box_of(const std::vector<double>& clip, std::span<const Target> targets) {
    if (clip.empty()) return std::nullopt;
    const Box box = {clip[0], clip[1], clip[2], clip[3]};
    if (!(box.x0 < box.x1 && box.y0 < box.y1)) {
        throw CallError(
            fmt::format("--clip {}: the lower left corner comes first, x0 < x1 and y0 < y1",
                        fmt::join(clip, " ")));
    }
    // A picture is some hundred pixels wide.
    constexpr double slimmest = 1e-3;
    const auto [shorter, longer] = std::minmax({box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2});
    if (is_written(targets, "svg") && shorter < slimmest * longer) {
        throw CallError(
            "--clip: a picture of a box more than a thousand times as long as wide shows nothing; "
            "give another box, or leave the picture out");
    }
    return box;
}

void require_fit(const Box& box, const Voronoi& diagram) {
    if (fits(box, diagram)) return;
    throw CallError(
        fmt::format("the box {} {} {} {} is too large or too small beside the coordinates and "
                    "radii of the sites; cut the cells to another one with --clip",
                    box.x0, box.y0, box.x1, box.y1));
}

}  // namespace signum::cli
