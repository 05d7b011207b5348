#include <cmath>
#include <span>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "../../tool/io/read_balls.hpp"
#include "../../tool/io/read_xyz.hpp"
#include "../../tool/io/write_motion.hpp"

#include "memory_file.hpp"
#include "parsers.hpp"
#include "reading.hpp"

namespace signum::fuzz {
namespace {

bool are_same(const BallsFile& a, const BallsFile& b) {
    if (a.dimension != b.dimension || a.balls.size() != b.balls.size()) return false;
    for (std::size_t i = 0; i < a.balls.size(); ++i) {
        const BallLine& one = a.balls[i];
        const BallLine& other = b.balls[i];
        if (!are_same_numbers(one.x, other.x) || !are_same_numbers(one.v, other.v) ||
            !are_same_numbers(one.radius, other.radius) || !are_same_numbers(one.mass, other.mass))
            return false;
    }
    return true;
}

void judge_numbers(const BallsFile& file) {
    must(file.dimension == 2 || file.dimension == 3, "balls of neither dimension");
    must(!file.balls.empty(), "no balls");
    for (const BallLine& ball : file.balls) {
        bool is_finite = std::isfinite(ball.radius) && std::isfinite(ball.mass);
        for (const double number : ball.x) is_finite = is_finite && std::isfinite(number);
        for (const double number : ball.v) is_finite = is_finite && std::isfinite(number);
        must(is_finite, "a ball that is not finite");
        must(file.dimension == 3 || (ball.x[2] == 0.0 && ball.v[2] == 0.0),
             "a ball beside its plane");
    }
}

std::string lines_of(const BallsFile& file) {
    std::string text;
    const auto axes = static_cast<std::size_t>(file.dimension);
    for (const BallLine& ball : file.balls)
        text += fmt::format("{} {} {} {}\n", fmt::join(std::span(ball.x).first(axes), " "),
                            ball.radius, fmt::join(std::span(ball.v).first(axes), " "), ball.mass);
    return text;
}

std::string frame_of(const BallsFile& file) {
    std::vector<MotionFrame::Ball> balls;
    for (const BallLine& ball : file.balls) balls.push_back({ball.x, ball.v, ball.radius});
    MotionFrame frame;
    frame.dimension = file.dimension;
    frame.balls = balls;
    std::ostringstream text;
    write_xyz(text, frame);
    return text.str();
}

}  // namespace

void read_balls_target(Bytes bytes) {
    const MemoryFile file(bytes);
    const auto result = result_of(file.path(), read_balls);
    if (!result) return;
    judge_numbers(*result);
    for (const BallLine& ball : result->balls)
        must(ball.radius >= 0.0 && ball.mass > 0.0, "a radius or a mass below 0");
    const MemoryFile copy(lines_of(*result));
    must(are_same(read_balls(copy.path()), *result), "balls that do not read back to the same");
}

void read_frames_target(Bytes bytes) {
    static_cast<void>(
        looks_like_frames({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
    const MemoryFile file(bytes);
    const auto result = result_of(file.path(), read_last_frame);
    if (!result) return;
    judge_numbers(*result);
    const MemoryFile copy(frame_of(*result));
    must(are_same(read_last_frame(copy.path()), *result), "a frame that does not read back");
}

}  // namespace signum::fuzz
