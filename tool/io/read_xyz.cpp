#include "read_xyz.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "input_file.hpp"
#include "number.hpp"
#include "xyz_comment.hpp"

namespace signum {
namespace {

constexpr std::string_view columns = "species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1";
constexpr std::string_view advice = "give frames as signum writes them";

class Frames {
 public:
    explicit Frames(const std::string& path) : file_(path, "frames in extended XYZ") {}

    BallsFile last() {
        BallsFile frame;
        while (next_line()) {
            const auto balls = parse_whole_number(line_);
            if (!balls) fail(1, fmt::format("no number of balls; {}", advice));
            next_line_of_frame();
            const std::optional<XyzValue> properties = value_in_comment(line_, "properties");
            if (!properties || properties->value != columns)
                fail(properties ? properties->column : 1,
                     fmt::format("no Properties={}; {}", columns, advice));
            frame.balls.clear();
            for (std::uint64_t i = 0; i < *balls; ++i) {
                next_line_of_frame();
                frame.balls.push_back(ball());
            }
        }
        if (frame.balls.empty()) fail(1, fmt::format("no ball in the last frame; {}", advice));
        const bool is_flat = std::ranges::all_of(
            frame.balls, [](const BallLine& each) { return each.x[2] == 0.0 && each.v[2] == 0.0; });
        frame.dimension = is_flat ? 2 : 3;
        return frame;
    }

 private:
    [[noreturn]] void fail(std::size_t column, std::string_view message) const {
        file_.fail(
            {std::max<std::int64_t>(file_.line_number(), 1), static_cast<std::int64_t>(column)},
            message);
    }
    bool next_line() { return file_.next_line(line_, advice); }
    void next_line_of_frame() {
        if (!next_line()) fail(1, fmt::format("the file ends within a frame; {}", advice));
    }
    /// A species, eight numbers and nothing more.
    BallLine ball() {
        BallLine ball;
        ball.position.line = file_.line_number();
        std::size_t at = line_.find(' ');
        const auto number = [&] {
            const std::size_t begin = line_.find_first_not_of(' ', at);
            if (begin == std::string_view::npos)
                fail(line_.size() + 1,
                     fmt::format("a ball without all of its numbers; {}", advice));
            at = std::min(line_.find(' ', begin), line_.size());
            const std::string_view text = line_.substr(begin, at - begin);
            const Number number = parse_number(text);
            if (number.fault != NumberFault::none) fail(begin + 1, explain(number.fault, text));
            return number.value;
        };
        for (double& x : ball.x) x = number();
        for (double& v : ball.v) v = number();
        ball.radius = number();
        static_cast<void>(number());
        if (at != line_.size())
            fail(at + 1, fmt::format("more behind a ball than its numbers; {}", advice));
        return ball;
    }

    InputFile file_;
    std::string_view line_;
};

}  // namespace

bool looks_like_frames(std::string_view text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return false;
    std::string_view number = text.substr(0, end);
    if (number.ends_with('\r')) number.remove_suffix(1);
    const std::string_view second = text.substr(end + 1, text.find('\n', end + 1) - end - 1);
    return parse_whole_number(number) && value_in_comment(second, "properties");
}

BallsFile read_last_frame(const std::string& path) {
    return Frames(path).last();
}

}  // namespace signum
