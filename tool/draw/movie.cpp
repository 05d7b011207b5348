#include "movie.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <ostream>
#include <utility>

#include <fmt/format.h>

#include "style.hpp"

namespace signum {
namespace {

constexpr double width = 640.0;
constexpr double seconds = 12.0;
/// Of the kinds of shapes in their order: the attributes of their paths, and a colour of text.
struct Pen {
    const char* attributes;
    const char* colour;
};
constexpr std::array<Pen, 8> pens = {
    {{R"(fill="#cc79a7" fill-opacity="0.1" stroke="#d9a3c2" stroke-width="2.6")", "#a34f7c"},
     {R"(fill="#009e73" fill-opacity="0.1" stroke="#66bfa3" stroke-width="2.2")", "#007a59"},
     {R"(fill="#e69f00" fill-opacity="0.1" stroke="#e8bc5c" stroke-width="1.6")", "#946600"},
     {R"(fill="#0072b2" fill-opacity="0.08" stroke="#6f9fbf" stroke-width="0.8")", "#3f7fa8"},
     {R"(fill="none" stroke="#777" stroke-width="1" stroke-linecap="round")", "#666"},
     {R"(fill="none" stroke="#d0007f" stroke-width="4" stroke-linecap="round")", "#d0007f"},
     {R"(fill="none" stroke="#666" stroke-width="1")", "#666"},
     {R"(fill="none" stroke="#d0007f" stroke-width="1.8")", "#d0007f"}}};

/// An element that moves something all the time; `value_of` gives what holds in a frame.
template <class ValueOf>
void animate(std::ostream& out, std::string_view element, bool jumps, std::size_t frames,
             const ValueOf& value_of) {
    out << fmt::format("<{} dur=\"{}s\" repeatCount=\"indefinite\" calcMode=\"{}\" values=\"",
                       element, seconds, jumps ? "discrete" : "linear");
    for (std::size_t f = 0; f < frames; ++f) out << (f > 0 ? ";" : "") << value_of(f);
    out << "\"/>";
}

}  // namespace

Movie::Movie(std::vector<double> radii, std::array<double, 2> low, std::array<double, 2> high,
             bool periodic)
    : radii_(std::move(radii)), low_(low), high_(high), periodic_(periodic) {
    shown_.resize(radii_.size());
    std::iota(shown_.begin(), shown_.end(), std::size_t{0});
}

void Movie::choose(const std::vector<Ball>& balls, const Shapes& shapes) {
    is_shown_.assign(radii_.size(), shown_.size() <= most_balls);
    if (shown_.size() <= most_balls) return;
    shows_middle_ = !shapes.borders.empty();
    std::vector<double> far;
    for (const Ball& ball : balls)
        far.push_back(std::hypot(ball.x - std::midpoint(low_[0], high_[0]),
                                 ball.y - std::midpoint(low_[1], high_[1])));
    // Of equal ones some from everywhere: multiples of the golden ratio lie evenly.
    const auto spread = [](std::size_t i) { return i * 0x9E3779B97F4A7C15; };
    std::ranges::sort(shown_, [&](std::size_t a, std::size_t b) {
        if (shows_middle_) return far[a] != far[b] ? far[a] < far[b] : a < b;
        return radii_[a] != radii_[b] ? radii_[a] > radii_[b] : spread(a) < spread(b);
    });
    shown_.resize(most_balls);
    std::ranges::sort(shown_);
    for (const std::size_t i : shown_) is_shown_[i] = true;
}

double Movie::scale() const {
    return width / std::max(high_[0] - low_[0], high_[1] - low_[1]);
}
// What flies far away stays in the file as far away.
double Movie::x_of(double x) const {
    return std::clamp(scale() * (x - low_[0]), -1e5, 1e5);
}
double Movie::y_of(double y) const {
    return std::clamp(scale() * (high_[1] - y), -1e5, 1e5);
}

void Movie::add(double time, const std::vector<Ball>& balls, const Shapes& shapes, double growth) {
    if (added_ == 0) choose(balls, shapes);
    if (added_++ % every_ != 0) return;
    std::vector<Ball> frame;
    frame.reserve(shown_.size());
    for (const std::size_t i : shown_) frame.push_back(balls[i]);
    times_.push_back(time);
    growths_.push_back(growth);
    frames_.push_back(std::move(frame));
    shapes_.push_back(drawn(balls, shapes));
    if (frames_.size() <= most_frames) return;
    every_ *= 2;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < frames_.size(); k += 2, ++kept) {
        times_[kept] = times_[k];
        growths_[kept] = growths_[k];
        if (kept == k) continue;
        frames_[kept] = std::move(frames_[k]);
        shapes_[kept] = std::move(shapes_[k]);
    }
    times_.resize(kept);
    growths_.resize(kept);
    frames_.resize(kept);
    shapes_.resize(kept);
}

bool Movie::is_shown(int ball) const {
    return ball < 0 || is_shown_[static_cast<std::size_t>(ball)];
}

Movie::Drawn Movie::drawn(const std::vector<Ball>& balls, const Shapes& shapes) {
    Drawn result;
    std::array<Paths, kinds>& paths = result.paths;
    const double wide = scale() * (high_[0] - low_[0]);
    const double high = scale() * (high_[1] - low_[1]);
    const auto is_seen = [&](double left, double top, double right, double bottom) {
        return right >= 0.0 && left <= wide && bottom >= 0.0 && top <= high;
    };
    for (const Shapes::Box& box : shapes.boxes) {
        const double x = x_of(box.low[0]);
        const double y = y_of(box.high[1]);
        const double right = x_of(box.high[0]);
        const double bottom = y_of(box.low[1]);
        if (!is_shown(box.ball) || !is_seen(x, y, right, bottom)) continue;
        const auto level = std::min(static_cast<std::size_t>(box.level), most_levels - 1);
        paths[finest - level].push_back(fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h-{:.1f}z", x, y,
                                                    right - x, bottom - y, right - x));
    }
    for (const Shapes::Round& round : shapes.rounds) {
        const double r = std::min(scale() * round.radius, 1e5);
        const double x = x_of(round.x);
        const double y = y_of(round.y);
        if (!is_shown(round.ball) || !is_seen(x - r, y - r, x + r, y + r)) continue;
        paths[finest].push_back(
            fmt::format("M{0:.1f} {1:.1f}a{2:.1f} {2:.1f} 0 0 1 {3:.1f} 0"
                        "a{2:.1f} {2:.1f} 0 0 1-{3:.1f} 0z",
                        x - r, y, r, 2.0 * r));
    }
    for (const Border& border : shapes.borders) {
        if (!is_shown_[border.a] && !is_shown_[border.b]) continue;
        const auto place = [&](const std::array<double, 2>& end) {
            return fmt::format("{:.1f} {:.1f}", x_of(end[0]), y_of(end[1]));
        };
        const std::string from = place(border.from);
        const std::string to = place(border.to);
        if (from == to) continue;
        paths[borders].push_back(fmt::format("M{}L{}", from, to));
        result.neighbours.emplace_back(border.a, border.b);
    }
    // Their ends lie under balls: whole pixels will do.
    const auto lines = [&](const auto& pairs, Paths& to) {
        for (const auto& [a, b] : pairs) {
            if (!is_shown_[a] || !is_shown_[b]) continue;
            const bool is_across = 2.0 * std::fabs(balls[a].x - balls[b].x) > high_[0] - low_[0] ||
                                   2.0 * std::fabs(balls[a].y - balls[b].y) > high_[1] - low_[1];
            if (periodic_ && is_across) continue;
            const auto [one, other] = std::minmax(a, b);
            const long x = std::lround(x_of(balls[one].x));
            const long y = std::lround(y_of(balls[one].y));
            to.push_back(fmt::format("M{} {}l{} {}", x, y, std::lround(x_of(balls[other].x)) - x,
                                     std::lround(y_of(balls[other].y)) - y));
        }
    };
    lines(shapes.links, paths[links]);
    lines(shapes.expected, paths[expected]);
    for (Paths& of_kind : paths) {
        if (of_kind.size() <= most_shapes) continue;
        of_kind.resize(most_shapes);
        leaves_out_shapes_ = true;
    }
    return result;
}

void Movie::mark_new_borders(std::vector<Drawn>& frames) {
    constexpr double marked_seconds = 0.5;
    const auto count = static_cast<double>(frames.size());
    const auto marked =
        static_cast<std::size_t>(std::max(1.0, std::round(marked_seconds / seconds * count)));
    // Of each two neighbours the first and the last of the frames in a row in which they are.
    std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> rows;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        Drawn& frame = frames[f];
        for (std::size_t i = 0; i < frame.neighbours.size(); ++i) {
            const auto& neighbours = frame.neighbours[i];
            auto& [first, last] = rows.try_emplace(neighbours, f, f).first->second;
            if (last + 1 < f) first = f;
            last = f;
            const bool is_new =
                first > 0 && f - first < marked && neighbours.first != neighbours.second;
            if (is_new && i < frame.paths[borders].size())
                frame.paths[new_borders].push_back(frame.paths[borders][i]);
        }
    }
}

void Movie::write_shapes(std::ostream& out, std::span<const Drawn> frames, std::size_t kind) const {
    const std::size_t count = frames.size();
    // In which frames each is, and by the first and the last of frames in a row what they show.
    std::map<std::string, std::vector<std::size_t>> frames_of;
    for (std::size_t f = 0; f < count; ++f)
        for (const std::string& path : frames[f].paths[kind]) frames_of[path].push_back(f);
    std::map<std::pair<std::size_t, std::size_t>, std::string> rows;
    for (const auto& [path, shown] : frames_of) {
        for (auto f = shown.begin(); f != shown.end();) {
            const std::size_t first = *f;
            std::size_t last = first;
            while (++f != shown.end() && *f <= last + 1) last = *f;
            rows[{first, last}] += path;
        }
    }
    if (rows.empty()) return;
    // When a frame begins, as a share of the whole: where balls jump, with them.
    const auto begin_of = [&](std::size_t f) {
        const auto frame = static_cast<double>(f);
        return periodic_ ? frame / static_cast<double>(count)
                         : (frame - 0.5) / (static_cast<double>(count) - 1.0);
    };
    out << fmt::format("<g {}>\n", pens[kind].attributes);
    for (const auto& [row, path] : rows) {
        const auto [first, last] = row;
        const bool from_start = first == 0;
        const bool to_end = last + 1 == count;
        out << fmt::format("<path{} d=\"{}\"", from_start ? "" : " display=\"none\"", path);
        if (from_start && to_end) {
            out << "/>\n";
            continue;
        }
        std::string values = "inline";
        std::string times = "0";
        if (!from_start) {
            values = "none;inline";
            times += fmt::format(";{:.4f}", begin_of(first));
        }
        if (!to_end) {
            values += ";none";
            times += fmt::format(";{:.4f}", begin_of(last + 1));
        }
        out << fmt::format(
            "><animate attributeName=\"display\" dur=\"{}s\" repeatCount=\"indefinite\" "
            "calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\"/></path>\n",
            seconds, values, times);
    }
    out << "</g>\n";
}

double Movie::drawn_radius(std::size_t ball) const {
    return std::max(scale() * radii_[ball], 1.0);
}

std::vector<std::array<double, 2>> Movie::copies_of(std::size_t k) const {
    std::vector<std::array<double, 2>> copies;
    if (!periodic_) return copies;
    const double wide = scale() * (high_[0] - low_[0]);
    const double high = scale() * (high_[1] - low_[1]);
    const double r = drawn_radius(shown_[k]);
    for (const double dx : {-wide, 0.0, wide}) {
        for (const double dy : {-high, 0.0, high}) {
            if (dx == 0.0 && dy == 0.0) continue;
            if (std::ranges::any_of(frames_, [&](const std::vector<Ball>& frame) {
                    const double x = x_of(frame[k].x) + dx;
                    const double y = y_of(frame[k].y) + dy;
                    return x + r > 0.0 && x - r < wide && y + r > 0.0 && y - r < high;
                }))
                copies.push_back({dx, dy});
        }
    }
    return copies;
}

void Movie::write_walls(std::ostream& out) const {
    if (walls_.empty()) return;
    out << "<g fill=\"none\" stroke=\"#444\" stroke-width=\"1.5\">\n";
    for (const Wall& wall : walls_) {
        const auto shift = [&](double time) {
            const auto [x, y] = wall.shift ? wall.shift(time) : std::array{0.0, 0.0};
            return std::array{scale() * x, 0.0 - scale() * y};
        };
        const auto [first_x, first_y] = shift(times_.empty() ? 0.0 : times_.front());
        if (wall.points.empty()) {
            out << fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"",
                               x_of(wall.centre[0]), y_of(wall.centre[1]), scale() * wall.radius);
        } else {
            out << "<path d=\"";
            for (const auto& [x, y] : wall.points)
                out << fmt::format("{}{:.1f} {:.1f}", &x == wall.points.front().data() ? "M" : "L",
                                   x_of(x), y_of(y));
            out << "\"";
        }
        out << fmt::format(" transform=\"translate({:.2f} {:.2f})\"", first_x, first_y);
        if (!wall.shift || times_.size() < 2) {
            out << "/>\n";
            continue;
        }
        out << ">";
        animate(out, R"(animateTransform attributeName="transform" type="translate")", false,
                times_.size(), [&](std::size_t f) {
                    const auto [x, y] = shift(times_[f]);
                    return fmt::format("{:.2f} {:.2f}", x, y);
                });
        out << (wall.points.empty() ? "</circle>\n" : "</path>\n");
    }
    out << "</g>\n";
}

void Movie::write(std::ostream& out, const std::string& title, const Meaning& meaning) const {
    const double wide = scale() * (high_[0] - low_[0]);
    const double high = scale() * (high_[1] - low_[1]);
    std::string legend = title;
    if (shown_.size() < radii_.size())
        legend += shows_middle_
                      ? fmt::format("; {} of them, in the middle at the start", shown_.size())
                      : fmt::format("; the {} largest of {} balls", shown_.size(), radii_.size());
    if (!times_.empty())
        legend += fmt::format("; t = {:.4g} to {:.4g}", times_.front(), times_.back());
    std::string colours_mean;
    const auto add_meaning = [&](std::size_t kind, const std::string& words) {
        if (words.empty()) return;
        colours_mean += fmt::format("{}<tspan fill=\"{}\">{}</tspan>",
                                    colours_mean.empty() ? "" : "; ", pens[kind].colour, words);
    };
    add_meaning(finest, meaning.outlines);
    add_meaning(borders,
                shown_.size() < radii_.size() && !meaning.borders.empty()
                    ? fmt::format("{} of the {} balls shown", meaning.borders, shown_.size())
                    : meaning.borders);
    add_meaning(new_borders, meaning.new_borders);
    add_meaning(links, meaning.links);
    add_meaning(expected, meaning.expected);
    if (leaves_out_shapes_)
        colours_mean += fmt::format("{}not all are drawn, at most {} of a kind",
                                    colours_mean.empty() ? "" : "; ", most_shapes);
    const double below = colours_mean.empty() ? 44.0 : 62.0;
    out << fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 {:.1f} {:.1f}\" "
        "font-family=\"sans-serif\" font-size=\"13\">\n<rect x=\"-10\" y=\"-10\" width=\"{:.1f}\" "
        "height=\"{:.1f}\" fill=\"white\"/>\n<rect width=\"{:.1f}\" height=\"{:.1f}\" "
        "fill=\"none\" stroke=\"#888\"/>\n<text x=\"0\" y=\"{:.1f}\" fill=\"#333\">{}</text>\n"
        "{}<clipPath id=\"box\"><rect width=\"{:.1f}\" height=\"{:.1f}\"/></clipPath>\n"
        "<g clip-path=\"url(#box)\" fill-opacity=\"0.75\" stroke=\"#222\" stroke-width=\"0.5\">\n",
        wide + 20.0, high + below, wide + 20.0, high + below, wide, high, high + 22.0, legend,
        colours_mean.empty() ? ""
                             : fmt::format("<text x=\"0\" y=\"{:.1f}\" fill=\"#333\">{}</text>\n",
                                           high + 40.0, colours_mean),
        wide, high);
    std::vector<Drawn> shapes = shapes_;
    mark_new_borders(shapes);
    for (std::size_t kind = 0; kind < kinds; ++kind) write_shapes(out, shapes, kind);
    write_walls(out);
    const bool grows = std::ranges::any_of(growths_, [](double growth) { return growth != 1.0; });
    std::vector<std::size_t> order(shown_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (!frames_.empty()) {
        std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
            return frames_.front()[a].depth > frames_.front()[b].depth;
        });
    }
    for (const std::size_t k : order) {
        const std::size_t number = shown_[k];
        const Ball first = frames_.empty() ? Ball{} : frames_.front()[k];
        const auto copies = copies_of(k);
        out << fmt::format(
            "<circle{} cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" fill=\"{}\"><title>{}</title>",
            copies.empty() ? "" : fmt::format(" id=\"ball{}\"", number), x_of(first.x),
            y_of(first.y), drawn_radius(number), ball_colour(number), number);
        if (frames_.size() > 1) {
            animate(out, R"(animate attributeName="cx")", periodic_, frames_.size(),
                    [&](std::size_t f) { return fmt::format("{:.1f}", x_of(frames_[f][k].x)); });
            animate(out, R"(animate attributeName="cy")", periodic_, frames_.size(),
                    [&](std::size_t f) { return fmt::format("{:.1f}", y_of(frames_[f][k].y)); });
        }
        if (grows && growths_.size() > 1) {
            animate(out, R"(animate attributeName="r")", periodic_, growths_.size(),
                    [&](std::size_t f) {
                        const double radius = scale() * radii_[number] * growths_[f];
                        return fmt::format("{:.2f}", std::max(radius, 1.0));
                    });
        }
        out << "</circle>\n";
        for (const auto& [x, y] : copies)
            out << fmt::format("<use href=\"#ball{}\" x=\"{:.1f}\" y=\"{:.1f}\"/>\n", number, x, y);
    }
    out << "</g>\n</svg>\n";
}

}  // namespace signum
