#include "motion_summary.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "../scenes/energy.hpp"

namespace signum::cli {
template <int D>
std::optional<double> compressibility(const Summary<D>& summary) {
    const Energy<D> before(summary.start.state, summary.start.effects, summary.start.state.time);
    const Energy<D> after(summary.end.state, summary.end.effects, summary.end.state.time);
    const double time = summary.end.state.time - summary.start.state.time;
    const double kinetic = before.kinetic + after.kinetic;
    if (summary.start.effects.gravity != motion::Vector<D>{} || !(time > 0.0) || !(kinetic > 0.0))
        return std::nullopt;
    return 1.0 + summary.counts.virial / (kinetic * time);
}

template <int D>
std::string statistics_of(const Summary<D>& summary) {
    const Energy<D> before(summary.start.state, summary.start.effects, summary.start.state.time);
    const Energy<D> after(summary.end.state, summary.end.effects, summary.end.state.time);
    const motion::Counts& counts = summary.counts;
    const std::optional<double> z = compressibility(summary);
    return fmt::format(
        "{{\"balls\": {}, \"strikes\": {}, \"checks\": {}, \"own\": {}, \"stale\": {}, \"stages\": "
        "{{\"filter\": {}, \"exact\": {}, \"multiprecision\": {}}}, \"seconds\": {}, "
        "\"structure\": \"{}\", \"why\": \"{}\", \"time\": {}, \"energy_start\": {}, "
        "\"energy_end\": {}, \"pressure\": {}}}\n",
        summary.end.state.balls.size(), counts.strikes, counts.checks, counts.own, counts.stale,
        counts.checks - std::min(counts.checks, counts.exact), counts.refined, counts.exact,
        summary.seconds, motion::name_of(summary.choice.structure), summary.choice.why,
        summary.end.state.time, before.total, after.total,
        z ? fmt::format("{}", *z) : std::string("null"));
}

std::string_view in_words(motion::Ending ending) {
    constexpr std::string_view words[] = {"the time came", "the strikes are done",
                                          "nothing meets any more", "interrupted", "a collapse"};
    static_assert(std::size(words) == static_cast<int>(motion::Ending::collapse) + 1);
    return words[static_cast<int>(ending)];
}

template <int D>
std::string describe_collapse(const motion::Strike& last, const motion::Effects<D>& effects) {
    const bool loses =
        effects.restitution < 1.0 || effects.wall_restitution < 1.0 || effects.speed_law;
    std::string_view remedy;
    if (effects.growth)
        remedy = "; let effects.growth end earlier";
    else if (effects.contacts)
        remedy = "";
    else if (loses && effects.contact_duration == 0.0)
        remedy =
            "; with effects.contact_duration, or effects.contacts and run.time_step, such balls go "
            "on";
    else if (loses || effects.gravity != motion::Vector<D>{})
        remedy = "; with effects.contacts and run.time_step balls may lie still";
    return fmt::format(
        "at time {} ball {} and {} {} strike without end: an inelastic collapse, a jam, a gap "
        "that walls close, or a ball that lies still; the log up to there is complete{}",
        last.time, last.a, last.wall ? "wall" : "ball", last.b, remedy);
}

template std::string describe_collapse(const motion::Strike&, const motion::Effects<2>&);
template std::string describe_collapse(const motion::Strike&, const motion::Effects<3>&);
template std::optional<double> compressibility(const Summary<2>&);
template std::optional<double> compressibility(const Summary<3>&);
template std::string statistics_of(const Summary<2>&);
template std::string statistics_of(const Summary<3>&);

}  // namespace signum::cli
