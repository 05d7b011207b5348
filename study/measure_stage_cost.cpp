/// What a call of in_circle costs, by the stage that decides it. The calls are those of a finished
/// tessellation: the three sites of a face, and the one across an edge.

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "../predicates/euclidean.hpp"
#include "../predicates/manhattan.hpp"
#include "../predicates/power.hpp"
#include "../predicates/power/multiprecision.hpp"
#include "../predicates/supremum.hpp"

#include "contestants.hpp"
#include "work.hpp"

namespace signum::study {
namespace {

struct Call {
    std::array<Site, 4> sites;
    std::array<Index, 4> ranks;
};

struct InPower {
    static Decision decide(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return power::in_circle_decision(i, j, k, q);
    }
    static Decision in_rationals(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return {power::multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
    }
};
struct InEuclidean {
    static Decision decide(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return euclidean::in_circle_decision(i, j, k, q, call.ranks);
    }
    static Decision in_rationals(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return euclidean::Perturbed<Arithmetic::multiprecision>::in_circle(i, j, k, q, call.ranks);
    }
};
template <class Directions>
struct InSquares {
    static Decision decide(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return rectangular::in_circle_decision<Directions>(i, j, k, q, call.ranks);
    }
    static Decision in_rationals(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return rectangular::Perturbed<Directions, Arithmetic::multiprecision>::in_circle(
            i, j, k, q, call.ranks);
    }
};

std::vector<Call> calls_of(const Tessellation& tessellation) {
    std::vector<Call> calls;
    const auto faces = tessellation.faces();
    const auto is_finite = [](const Face& face) { return face[0] >= 0; };
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (!is_finite(faces[f])) continue;
        for (const Index neighbour : tessellation.neighbours()[f]) {
            const auto g = static_cast<std::size_t>(neighbour);
            if (!is_finite(faces[g]) || g < f) continue;
            const auto* across = std::find_if(faces[g].begin(), faces[g].end(), [&](Index site) {
                return std::find(faces[f].begin(), faces[f].end(), site) == faces[f].end();
            });
            if (across == faces[g].end()) continue;  // the same three sites the other way round
            const std::array<Index, 4> numbers = {faces[f][0], faces[f][1], faces[f][2], *across};
            Call call;
            for (std::size_t m = 0; m < 4; ++m)
                call.sites[m] = tessellation.sites()[static_cast<std::size_t>(numbers[m])];
            const auto& [i, j, k, q] = call.sites;
            call.ranks = additive::ranks_of<4>({&i, &j, &k, &q}, numbers);
            calls.push_back(call);
        }
    }
    return calls;
}

using Decide = Decision (*)(const Call&) noexcept;

/// Nanoseconds a call, in a loop of two milliseconds or more.
template <Decide decide>
double ns_per_call(std::span<const Call> calls) {
    constexpr double long_enough = 2e-3;
    Sign sum = 0;
    std::size_t passes = 0;
    double seconds = 0.0;
    while (seconds < long_enough) {
        seconds += seconds_of([&] {
            for (const Call& call : calls) sum += decide(call).sign;
        });
        ++passes;
    }
    volatile Sign sink = sum;
    static_cast<void>(sink);
    return 1e9 * seconds / (static_cast<double>(passes) * static_cast<double>(calls.size()));
}

template <class Metric>
std::vector<Row> measure_in(const Cell& cell, const Pass& pass, const std::vector<Call>& calls) {
    constexpr std::size_t few = 16;
    constexpr std::array stages = {Stage::filter, Stage::refine, Stage::exact, Stage::essa,
                                   Stage::multiprecision};
    std::array<std::vector<Call>, stage_count> decided;
    for (const Call& call : calls)
        decided[static_cast<std::size_t>(Metric::decide(call).stage)].push_back(call);
    std::vector<Contestant> contestants;
    std::vector<std::pair<Stage, const char*>> names;
    for (const Stage stage : stages) {
        const std::vector<Call>& group = decided[static_cast<std::size_t>(stage)];
        if (group.size() < few) continue;
        names.emplace_back(stage, "ns_per_call");
        contestants.emplace_back([&group] { return ns_per_call<Metric::decide>(group); });
    }
    std::vector<Row> rows;
    if (contestants.empty()) return rows;
    if (names.back().first != Stage::multiprecision) {
        // The calls of the last stage that has any, as they are nearest to what needs rationals.
        constexpr std::size_t enough = 100;
        const std::vector<Call>& last = decided[static_cast<std::size_t>(names.back().first)];
        const std::span<const Call> group(last.data(), std::min(last.size(), enough));
        names.emplace_back(Stage::multiprecision, "ns_per_call_forced");
        contestants.emplace_back([group] { return ns_per_call<Metric::in_rationals>(group); });
    }
    const Race race = race_of(contestants, cell, pass);
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({cell.setting, name_of(names[i].first), names[i].second, race.seconds[i]});
    return rows;
}

}  // namespace

std::vector<Row> measure_stage_cost(const Cell& cell, const Pass& pass) {
    const Metric metric = metric_named(cell.setting.metric).value();
    const std::vector<Call> calls = calls_of(triangulate(sites_of(cell.setting, 1), metric));
    switch (metric) {
        case Metric::power:
            return measure_in<InPower>(cell, pass, calls);
        case Metric::euclidean:
            return measure_in<InEuclidean>(cell, pass, calls);
        case Metric::manhattan:
            return measure_in<InSquares<rectangular::Manhattan>>(cell, pass, calls);
        case Metric::supremum:
            return measure_in<InSquares<rectangular::Supremum>>(cell, pass, calls);
    }
    return {};
}

}  // namespace signum::study
