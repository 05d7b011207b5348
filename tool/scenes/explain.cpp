#include "explain.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

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

    [[nodiscard]] std::string quantity(double value, const Dimension& dimension) const {
        const std::string unit = scene_.units.name_of(dimension);
        return unit.empty() ? fmt::format("{}", value) : fmt::format("{} {}", value, unit);
    }
    [[nodiscard]] std::string vector(const motion::Vector<D>& v, const Dimension& dimension) const {
        return fmt::format("({}) {}", fmt::join(v.begin(), v.end(), ", "),
                           scene_.units.name_of(dimension));
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
        std::string text =
            fmt::format("{} in {}, radius {}", scene_.start.balls.size(),
                        D == 2 ? "the plane" : "space", quantity(largest, dimensions::length));
        if (least < largest)
            text = fmt::format("{} in {}, radii {:.4g} to {:.4g} {}", scene_.start.balls.size(),
                               D == 2 ? "the plane" : "space", least, largest,
                               scene_.units.name_of(dimensions::length));
        if (!effects_.box) return text;
        for (int k = 0; k < D; ++k) filled /= effects_.box->high[k] - effects_.box->low[k];
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
        return {
            {"gravity", e.gravity != motion::Vector<D>{},
             vector(e.gravity, dimensions::acceleration),
             e.time_step > 0.0 ? "acts once a step"
                               : "parabolas; all fall alike, so that two balls still meet on lines",
             "flights are straight lines; no term is added"},
            {"restitution", loses,
             has_walls ? fmt::format("{}, of walls {}", e.restitution, e.wall_restitution)
                       : fmt::format("{}", e.restitution),
             "the law of a strike stays rational, and is rounded once",
             "strikes are elastic, and energy stays as it is"},
            {"speed_law", e.speed_law.has_value(),
             e.speed_law
                 ? fmt::format("that restitution at {}; 1 - e goes as speed^{}",
                               quantity(e.speed_law->speed, dimensions::speed), e.speed_law->power)
                 : "",
             "a power a strike, in doubles in a fixed order",
             "restitution is the same at all speeds; slow strikes would lose less"},
            {"contact_duration", e.contact_duration > 0.0,
             fmt::format("elastic within {} of the last strike",
                         quantity(e.contact_duration, dimensions::time)),
             "the time of each ball's last strike",
             loses ? "a ball that comes to rest strikes ever faster, and that collapse ends the run"
                   : "elastic balls come to no rest"},
            {"friction", e.friction.has_value(),
             e.friction ? fmt::format("{}, at walls {}; tangential restitution {}, inertia {} m r²",
                                      e.friction->coefficient, e.friction->wall_coefficient,
                                      e.friction->tangential_restitution, e.friction->inertia)
                        : "",
             "a spin a ball; strikes exchange momentum along surfaces, too",
             "balls are smooth and have no spin; what slides would be slowed, and roll"},
            {"shake", e.shake.has_value(),
             e.shake ? fmt::format("by {}, {}", vector(e.shake->amplitude, dimensions::length),
                                   quantity(e.shake->frequency, dimensions::angular_speed))
                     : "",
             "meetings with sides are roots of a sine, each told exactly",
             "the box stands still; meetings with its sides are roots of polynomials"},
            {"growth", e.growth.has_value(),
             e.growth ? fmt::format("radii grow by {} until {}",
                                    quantity(e.growth->rate, dimensions::rate),
                                    quantity(e.growth->until, dimensions::time))
                      : "",
             "a radius is a line in time; pairs still meet at roots of quadratics",
             "radii are as given"},
            {"fluid", e.fluid.has_value(),
             e.fluid ? fmt::format("flows by {}; linear {}, quadratic {}",
                                   vector(e.fluid->velocity, dimensions::speed), e.fluid->linear,
                                   e.fluid->quadratic)
                     : "",
             "time steps: velocities change at each",
             "nothing drags; a flight has a formula and needs no steps"},
            {"contacts", e.contacts.has_value(),
             e.contacts ? fmt::format("below {} after a strike",
                                      quantity(e.contacts->speed, dimensions::speed))
                        : "",
             "time steps: at each the reactions of all who touch are solved for",
             "strikes are instants; nothing rests on anything"},
        };
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
