/// What a call of in_circle costs, by the stage that decides it. The calls are those of a finished
/// tessellation: the three sites of a face, and the one across an edge.

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "../predicates/power/multiprecision.hpp"
#include "../triangulation/kernels/predicates_of.hpp"

#include "contestants.hpp"
#include "inner_edges.hpp"
#include "work.hpp"

namespace signum::study {
namespace {

struct RankedCall {
    std::array<Site, 4> sites;
    std::array<Index, 4> ranks;
};

template <class M>
Decision decide(const RankedCall& call) noexcept {
    const auto& [i, j, k, q] = call.sites;
    return triangulation::PredicatesOf<M>::in_circle(i, j, k, q, call.ranks);
}

template <class M>
Decision decide_in_rationals(const RankedCall& call) noexcept {
    const auto& [i, j, k, q] = call.sites;
    if constexpr (M::traits.edges_are_straight) {
        return {power::multiprecision::in_circle(i, j, k, q), Stage::multiprecision};
    } else {
        using Predicates =
            typename triangulation::PredicatesOf<M>::template Perturbed<Arithmetic::multiprecision>;
        return Predicates::in_circle(i, j, k, q, call.ranks);
    }
}

std::vector<RankedCall> calls_of(const Tessellation& tessellation) {
    std::vector<RankedCall> calls;
    for (const std::array<Index, 4>& numbers : inner_edges(tessellation)) {
        RankedCall call;
        for (std::size_t m = 0; m < 4; ++m)
            call.sites[m] = tessellation.sites()[static_cast<std::size_t>(numbers[m])];
        const auto& [i, j, k, q] = call.sites;
        call.ranks = additive::ranks_of<4>({&i, &j, &k, &q}, numbers);
        calls.push_back(call);
    }
    return calls;
}

using Decide = Decision (*)(const RankedCall&) noexcept;

/// Nanoseconds a call, in a loop of two milliseconds or more.
template <Decide question>
double ns_per_call(std::span<const RankedCall> calls) {
    constexpr double long_enough = 2e-3;
    Sign sum = 0;
    std::size_t passes = 0;
    double seconds = 0.0;
    while (seconds < long_enough) {
        seconds += seconds_of([&] {
            for (const RankedCall& call : calls) sum += question(call).sign;
        });
        ++passes;
    }
    volatile Sign sink = sum;
    static_cast<void>(sink);
    return 1e9 * seconds / (static_cast<double>(passes) * static_cast<double>(calls.size()));
}

template <class M>
std::vector<Row> measure_in(const Cell& cell, const Pass& pass,
                            const std::vector<RankedCall>& calls) {
    constexpr std::size_t few = 16;
    constexpr std::array stages = {Stage::filter, Stage::refine, Stage::exact, Stage::essa,
                                   Stage::multiprecision};
    std::array<std::vector<RankedCall>, stage_count> decided;
    for (const RankedCall& call : calls)
        decided[static_cast<std::size_t>(decide<M>(call).stage)].push_back(call);
    std::vector<Contestant> contestants;
    std::vector<std::pair<Stage, const char*>> names;
    for (const Stage stage : stages) {
        const std::vector<RankedCall>& group = decided[static_cast<std::size_t>(stage)];
        if (group.size() < few) continue;
        names.emplace_back(stage, "ns_per_call");
        contestants.emplace_back([&group] { return ns_per_call<decide<M>>(group); });
    }
    std::vector<Row> rows;
    if (contestants.empty()) return rows;
    if (names.back().first != Stage::multiprecision) {
        // The calls of the last stage that has any, as they are nearest to what needs rationals.
        constexpr std::size_t enough = 100;
        const std::vector<RankedCall>& last = decided[static_cast<std::size_t>(names.back().first)];
        const std::span<const RankedCall> group(last.data(), std::min(last.size(), enough));
        names.emplace_back(Stage::multiprecision, "ns_per_call_forced");
        contestants.emplace_back([group] { return ns_per_call<decide_in_rationals<M>>(group); });
    }
    const Race race = race_of(contestants, cell, pass);
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({cell.setting, name_of(names[i].first), names[i].second, race.seconds[i]});
    return rows;
}

}  // namespace

std::vector<Row> measure_stage_cost(const Cell& cell, const Pass& pass) {
    const Metric metric = metric_named(cell.setting.metric).value();
    const std::vector<RankedCall> calls = calls_of(triangulate(sites_of(cell.setting, 1), metric));
    return with_metric(metric, [&]<class M>(M) { return measure_in<M>(cell, pass, calls); });
}

}  // namespace signum::study
