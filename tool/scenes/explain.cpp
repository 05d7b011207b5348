#include "explain.hpp"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrangement.hpp"

namespace signum {
namespace {

/// An effect: what it says and needs where it is on; what is so where it is left out.
struct Row {
    std::string_view name;
    bool is_on = false;
    std::string value;
    std::string_view needs;
    std::string_view without;
};

template <int D>
class Explanation {
 public:
    explicit Explanation(const Scene<D>& scene) : scene_(scene), effects_(scene.effects) {}

    std::string text(std::string_view records) {
        if (!scene_.title.empty()) line("scene", scene_.title);
        line("balls", balls());
        line("mass", mass());
        line("units", fmt::format("{}, {}, {}", scene_.units.name_of(dimensions::length),
                                  scene_.units.name_of(dimensions::time),
                                  scene_.units.name_of(dimensions::mass)));
        line("flight", flight());
        line("walls", walls());
        const motion::Choice choice =
            motion::choose(scene_.run.structure, scene_.start, scene_.effects);
        line("structure", fmt::format("{}: {}", motion::name_of(choice.structure), choice.why));
        line("time",
             effects_.time_step > 0.0
                 ? fmt::format("steps of {}; strikes within a step are found in their order",
                               quantity(effects_.time_step, dimensions::time))
                 : "no steps: from one event to the next");
        line("end", end());
        // Itself is the first one.
        if (scene_.files.size() > 1)
            line("reads",
                 fmt::format("{}", fmt::join(scene_.files.begin() + 1, scene_.files.end(), ", ")));
        line("records", records);
        const std::vector<Row> rows = rows_of_effects();
        text_ += "\nOn\n";
        for (const Row& row : rows)
            if (row.is_on)
                text_ +=
                    fmt::format("  {:<17} {}\n  {:<17} {}\n", row.name, row.value, "", row.needs);
        if (std::ranges::none_of(rows, &Row::is_on))
            text_ += "  nothing: balls fly straight and strike elastically\n";
        text_ += "\nLeft out: not computed, not stored\n";
        for (const Row& row : rows)
            if (!row.is_on) text_ += fmt::format("  {:<17} {}\n", row.name, row.without);
        return std::move(text_);
    }

 private:
    void line(std::string_view name, std::string_view value) {
        text_ += fmt::format("{:<11}{}\n", name, value);
    }

    /// A number or a vector; of a matrix nothing.
    template <class Value>
    [[nodiscard]] std::string quantity(const Value& value, const Dimension& dimension) const {
        const std::string unit = scene_.units.name_of(dimension);
        if constexpr (std::is_same_v<Value, motion::Vector<D>>)
            return fmt::format("({}) {}", fmt::join(value.begin(), value.end(), ", "), unit);
        else if constexpr (std::is_arithmetic_v<Value>)
            return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
        else
            return "";
    }

    [[nodiscard]] std::string balls() const {
        double least = std::numeric_limits<double>::infinity();
        double largest = 0.0;
        double filled = 0.0;
        for (const motion::Ball<D>& ball : scene_.start.balls) {
            least = std::min(least, ball.radius);
            largest = std::max(largest, ball.radius);
            filled += motion::ball_volume<D>(ball.radius);
        }
        const std::string text = fmt::format(
            "{} in {}, {}", scene_.start.balls.size(), D == 2 ? "the plane" : "space",
            least < largest ? fmt::format("radii {:.4g} to {:.4g} {}", least, largest,
                                          scene_.units.name_of(dimensions::length))
                            : fmt::format("radius {}", quantity(largest, dimensions::length)));
        if (!effects_.box) return text;
        for (const double length : effects_.box->lengths()) filled /= length;
        return text + fmt::format("; they fill {:.3g} of the box", filled);
    }

    [[nodiscard]] std::string mass() const {
        double sum = 0.0;
        for (const double each : scene_.start.masses) sum += each;
        return fmt::format("{:.4g} {} in all", sum, scene_.units.name_of(dimensions::mass));
    }

    [[nodiscard]] std::string flight() const {
        if (effects_.time_step > 0.0) return "straight within a step; forces act between steps";
        return effects_.gravity == motion::Vector<D>{}
                   ? "straight: places are x + v t"
                   : "parabolas: places are x + v t + g t²/2, without error";
    }

    [[nodiscard]] std::string walls() const {
        std::vector<std::string> parts;
        if (effects_.box)
            parts.push_back(effects_.periodic ? "a periodic box: who leaves comes in again"
                            : effects_.shake  ? fmt::format("{} sides of a box that shakes", 2 * D)
                                              : fmt::format("{} sides of a box", 2 * D));
        std::size_t half_spaces = 0;
        std::size_t spheres = 0;
        for (const auto& obstacle : effects_.obstacles) {
            half_spaces += std::holds_alternative<motion::HalfSpace<D>>(obstacle) ? 1U : 0U;
            spheres += std::holds_alternative<motion::Sphere<D>>(obstacle) ? 1U : 0U;
        }
        const auto add = [&](std::size_t count, std::string_view one) {
            if (count > 0)
                parts.push_back(fmt::format("{} {}{}", count, one, count > 1 ? "s" : ""));
        };
        add(half_spaces, "half-space");
        add(spheres, D == 2 ? "circle" : "sphere");
        add(effects_.obstacles.size() - half_spaces - spheres, "segment");
        if (parts.empty()) return "none";
        return fmt::format("{}", fmt::join(parts, ", "));
    }

    [[nodiscard]] std::string end() const {
        std::string text;
        if (scene_.run.until)
            text = fmt::format("at time {}", quantity(*scene_.run.until, dimensions::time));
        if (scene_.run.events)
            text += fmt::format("{}after {} strikes{}", text.empty() ? "" : ", or ",
                                *scene_.run.events, text.empty() ? "" : " if that comes first");
        return text;
    }

    [[nodiscard]] std::vector<Row> rows_of_effects() const {
        const motion::Effects<D>& e = effects_;
        const bool loses = e.restitution < 1.0 || e.wall_restitution < 1.0;
        const bool has_walls = (e.box && !e.periodic) || !e.obstacles.empty();
        std::vector<Row> rows = {
            {"gravity", e.gravity != motion::Vector<D>{},
             quantity(e.gravity, dimensions::acceleration),
             e.time_step > 0.0 ? "acts once a step"
                               : "parabolas; all fall alike, so that two balls still meet on lines",
             "flights are straight lines; no term is added"},
            {"restitution", loses,
             has_walls ? fmt::format("{}, of walls {}", e.restitution, e.wall_restitution)
                       : fmt::format("{}", e.restitution),
             "the law of a strike stays rational, and is rounded once",
             "strikes are elastic, and energy stays as it is"},
        };
        motion::Effects<D>::each_field([&]<class Value>(Value motion::Effects<D>::*member,
                                                        const motion::Field& field) {
            if (field.told.empty()) return;
            const Value& value = e.*member;
            Row& row = rows.emplace_back(Row{field.name, false, "", field.costs, field.without});
            fmt::dynamic_format_arg_store<fmt::format_context> numbers;
            if constexpr (motion::DescribedIfOn<Value>) {
                row.is_on = value.has_value();
                if (!value) return;
                Value::value_type::each_field([&](auto inner, const motion::Field& each) {
                    numbers.push_back(quantity((*value).*inner, each.dimension));
                });
            } else if constexpr (std::is_same_v<Value, double>) {
                row.is_on = value != 0.0;
                numbers.push_back(quantity(value, field.dimension));
            }
            row.value = fmt::vformat(field.told, numbers);
        });
        if (loses)
            std::ranges::find(rows, "contact_duration", &Row::name)->without =
                "a ball that comes to rest strikes ever faster, and that collapse ends the run";
        return rows;
    }

    const Scene<D>& scene_;
    const motion::Effects<D>& effects_;
    std::string text_;
};

}  // namespace

template <int D>
std::string explain(const Scene<D>& scene, std::string_view records) {
    return Explanation<D>(scene).text(records);
}

template std::string explain(const Scene<2>&, std::string_view);
template std::string explain(const Scene<3>&, std::string_view);

}  // namespace signum
