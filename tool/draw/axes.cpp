#include "axes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace signum {
namespace {

constexpr double least_distance = 90;  // pixels, from tick to tick
constexpr double tick_length = 6;
constexpr std::size_t longest = 6;         // characters of a number
constexpr std::int64_t offset_step = 100;  // units
constexpr double largest = std::numeric_limits<double>::max();

/// The double nearest to units · 10^exponent; nothing beyond the doubles.
std::optional<double> value_of(std::int64_t units, int exponent) {
    if (units == 0) return 0.0;
    const std::string digits = fmt::format("{}e{}", units, exponent);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc()) return std::nullopt;
    return value;
}

/// units · 10^exponent without an exponent.
std::string plain(std::int64_t units, int exponent) {
    if (units == 0) exponent = std::min(exponent, 0);
    std::string digits = fmt::format("{}", std::abs(units));
    if (exponent >= 0) {
        digits.append(static_cast<std::size_t>(exponent), '0');
    } else {
        const auto decimals = static_cast<std::size_t>(-exponent);
        if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
        digits.insert(digits.size() - decimals, ".");
    }
    return units < 0 ? "-" + digits : digits;
}

/// The same, with an exponent where that is shorter.
std::string number(std::int64_t units, int exponent) {
    std::string digits = fmt::format("{}", std::abs(units));
    const int first = exponent + static_cast<int>(digits.size()) - 1;
    const std::size_t significant = digits.find_last_not_of('0') + 1;
    const int zeros = static_cast<int>(digits.size() - significant);
    if (-5 < first && first < 18) {
        const int whole = std::clamp(-exponent, 0, zeros);  // zeros behind the point say nothing
        for (int i = 0; i < whole; ++i) units /= 10;
        return plain(units, exponent + whole);
    }
    digits.erase(significant);
    if (digits.size() > 1) digits.insert(1, ".");
    return fmt::format("{}{}e{}", units < 0 ? "-" : "", digits, first);
}

}  // namespace

Axes::Axes(const Frame& frame) : frame_(frame) {
    Box box = frame.box(0);
    double farthest = 0;
    for (double* side : {&box.x0, &box.y0, &box.x1, &box.y1}) {
        *side = std::clamp(*side, -largest, largest);
        farthest = std::max(farthest, std::abs(*side));
    }
    const double spacing_of_doubles = farthest - std::nextafter(farthest, 0.0);
    if (!(spacing_of_doubles > 0)) return;
    const double logarithm = std::max(std::log10(least_distance) + frame.log10_of_pixel(),
                                      std::log10(spacing_of_doubles));
    exponent_ = static_cast<int>(std::floor(logarithm));
    const double mantissa = std::pow(10, logarithm - exponent_);
    const int multiple = mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 1;
    if (mantissa > 5) ++exponent_;
    axes_ = {axis(box.x0, box.x1, multiple, &Point::x), axis(box.y0, box.y1, multiple, &Point::y)};
    choose_numbers();
}

Axes::Axis Axes::axis(double low, double high, int multiple, double Point::*coordinate) const {
    Axis result;
    // A denormal step would be rounded.
    const bool is_tiny = exponent_ < -290;
    const auto step = value_of(multiple, exponent_ + (is_tiny ? 100 : 0));
    if (!step) return result;
    const double enlarge = is_tiny ? 1e100 : 1;
    const double end = coordinate == &Point::x ? frame_.width() : frame_.height();
    const auto first = static_cast<std::int64_t>(std::floor(low * enlarge / *step)) - 1;
    const auto last = static_cast<std::int64_t>(std::ceil(high * enlarge / *step)) + 1;
    for (std::int64_t i = first; i <= last; ++i) {
        const auto value = value_of(i * multiple, exponent_);
        if (!value) continue;
        const double pixel = frame_.at(Point{*value, *value}).*coordinate;
        if (0 <= pixel && pixel <= end) result.ticks.push_back({i * multiple, pixel});
    }
    return result;
}

std::size_t Axes::longest_number() const {
    std::size_t length = 0;
    for (const Axis& axis : axes_)
        for (const Tick& tick : axis.ticks)
            length = std::max(length, plain(tick.units - axis.offset, exponent_ - unit_).size());
    return length;
}

void Axes::choose_numbers() {
    for (const bool less_an_offset : {false, true}) {
        std::int64_t most = 0;
        for (Axis& axis : axes_) {
            if (axis.ticks.empty()) continue;
            const auto [low, high] = std::minmax(axis.ticks.front().units, axis.ticks.back().units);
            if (less_an_offset && std::max(std::abs(low), std::abs(high)) >= 100 * offset_step)
                axis.offset = low / offset_step * offset_step - (low < 0 ? offset_step : 0);
            most = std::max({most, std::abs(low - axis.offset), std::abs(high - axis.offset)});
        }
        const int first = exponent_ + static_cast<int>(fmt::formatted_size("{}", most)) - 1;
        for (const int unit : {0, first}) {
            unit_ = unit;
            // The numbers of extreme powers of ten would have hundreds of digits.
            if (std::abs(first - unit) <= 6 && longest_number() <= longest) return;
        }
    }
}

void Axes::describe(Legend& legend) const {
    const std::string units = unit_ == 0 ? "" : fmt::format(" × 1e{}", unit_);
    if (axes_[0].offset == 0 && axes_[1].offset == 0) {
        if (unit_ != 0) legend.note("axes{}", units);
        return;
    }
    for (std::size_t i = 0; i < 2; ++i)
        if (axes_[i].offset != 0 || unit_ != 0)
            legend.note("{} = {}axis{}", "xy"[i],
                        axes_[i].offset == 0 ? "" : number(axes_[i].offset, exponent_) + " + ",
                        units);
}

void Axes::write(SvgText& text) const {
    const double bottom = frame_.height();
    text.add(R"(<g class="axes"><path d="M0 0h{0}v{1}h-{0}z)", Px{frame_.width()}, Px{bottom});
    for (const Tick& tick : axes_[0].ticks)
        text.add("M{} {}v{}", Px{tick.pixel}, Px{bottom}, Px{tick_length});
    for (const Tick& tick : axes_[1].ticks) text.add("M0 {}h{}", Px{tick.pixel}, Px{-tick_length});
    text.add("\"/>\n<g text-anchor=\"middle\">");
    const auto label = [&](const Axis& axis, const Tick& tick, double x, double y) {
        text.add("<text x=\"{}\" y=\"{}\">{}</text>", Px{x}, Px{y},
                 plain(tick.units - axis.offset, exponent_ - unit_));
    };
    for (const Tick& tick : axes_[0].ticks) label(axes_[0], tick, tick.pixel, bottom + 23);
    text.add("<text x=\"{}\" y=\"{}\">x</text></g>\n<g text-anchor=\"end\">",
             Px{frame_.width() + 13}, Px{bottom + 5});
    for (const Tick& tick : axes_[1].ticks) label(axes_[1], tick, -tick_length - 4, tick.pixel + 6);
    text.add("<text x=\"5\" y=\"-8\">y</text></g></g>\n");
}

}  // namespace signum
