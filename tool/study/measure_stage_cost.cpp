/// What a call of in_circle costs, by the stage that decides it. The calls are those of a finished
/// tessellation: the three sites of a face, and the one across an edge. In space the same of
/// in_sphere, cells and facets; and how many calls each stage decides.

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "../../predicates/space.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"

#include "contestants.hpp"
#include "margin.hpp"
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
    return triangulation::PredicatesOf<M>::in_circle_decision(i, j, k, q, call.ranks);
}

template <class M>
Decision decide_in_rationals(const RankedCall& call) noexcept {
    const auto& [i, j, k, q] = call.sites;
    if constexpr (M::traits.edges_are_straight) {
        return predicates::decide<Arithmetic::multiprecision, power::InCircle>(i, j, k, q);
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

using CallInSpace = std::array<Site3, 5>;

Decision decide_call_in_space(const CallInSpace& call) noexcept {
    const auto& [i, j, k, l, q] = call;
    return power::in_sphere_decision(i, j, k, l, q);
}
Decision decide_in_space_in_rationals(const CallInSpace& call) noexcept {
    const auto& [i, j, k, l, q] = call;
    return predicates::decide<Arithmetic::multiprecision, power::InSphere>(i, j, k, l, q);
}

std::vector<CallInSpace> calls_in_space(const std::vector<Site3>& sites) {
    std::vector<CallInSpace> calls;
    for (const std::array<Index, 5>& numbers :
         inner_facets(triangulate(std::span<const Site3>(sites)))) {
        CallInSpace call;
        for (std::size_t m = 0; m < 5; ++m) call[m] = sites[static_cast<std::size_t>(numbers[m])];
        calls.push_back(call);
    }
    return calls;
}

template <class Call>
using Decide = Decision (*)(const Call&) noexcept;

/// Nanoseconds a call, in a loop of two milliseconds or more.
template <class Call, Decide<Call> question>
double ns_per_call(std::span<const Call> calls) {
    constexpr double long_enough = 2e-3;
    Sign sum = 0;
    std::size_t passes = 0;
    double seconds = 0.0;
    while (seconds < long_enough) {
        seconds += seconds_of([&] {
            for (const Call& call : calls) sum += question(call).sign;
        });
        ++passes;
    }
    volatile Sign sink = sum;
    static_cast<void>(sink);
    return 1e9 * seconds / (static_cast<double>(passes) * static_cast<double>(calls.size()));
}

constexpr std::array all_stages = {Stage::filter, Stage::refine, Stage::exact, Stage::essa,
                                   Stage::multiprecision};

/// Of calls that `decide` answers; in_rationals answers any.
template <class Call, Decide<Call> decide, Decide<Call> in_rationals>
std::vector<Row> costs_of(const Cell& cell, const Pass& pass, const std::vector<Call>& calls) {
    constexpr std::size_t few = 16;
    std::array<std::vector<Call>, stage_count> decided;
    for (const Call& call : calls)
        decided[static_cast<std::size_t>(decide(call).stage)].push_back(call);
    std::vector<Contestant> contestants;
    std::vector<std::pair<Stage, const char*>> names;
    for (const Stage stage : all_stages) {
        const std::vector<Call>& group = decided[static_cast<std::size_t>(stage)];
        if (group.size() < few) continue;
        names.emplace_back(stage, "ns_per_call");
        contestants.emplace_back([&group] { return ns_per_call<Call, decide>(group); });
    }
    std::vector<Row> rows;
    if (contestants.empty()) return rows;
    if (names.back().first != Stage::multiprecision) {
        // The calls of the last stage that has any, as they are nearest to what needs rationals.
        constexpr std::size_t enough = 100;
        const std::vector<Call>& last = decided[static_cast<std::size_t>(names.back().first)];
        const std::span<const Call> group(last.data(), std::min(last.size(), enough));
        names.emplace_back(Stage::multiprecision, "ns_per_call_forced");
        contestants.emplace_back([group] { return ns_per_call<Call, in_rationals>(group); });
    }
    const Race race = race_of(contestants, cell, pass);
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({cell.setting, name_of(names[i].first), names[i].second, race.seconds[i]});
    return rows;
}

/// How many calls each stage decides, and how many of them are ties.
std::vector<Row> shares_of(const Cell& cell, const std::vector<CallInSpace>& calls) {
    std::array<std::size_t, stage_count> decided{};
    std::size_t ties = 0;
    for (const CallInSpace& call : calls) {
        const Decision decision = decide_call_in_space(call);
        ++decided[static_cast<std::size_t>(decision.stage)];
        ties += decision.sign == 0;
    }
    std::vector<Row> rows;
    const auto put = [&](const std::string& quantity, std::size_t count) {
        rows.push_back({cell.setting, "exact", quantity, exactly(static_cast<double>(count))});
    };
    put("in_sphere", calls.size());
    for (const Stage stage : all_stages)
        put(std::string("calls_") + name_of(stage), decided[static_cast<std::size_t>(stage)]);
    put("ties", ties);
    return rows;
}

std::vector<Row> measure_in_space(const Cell& cell, const Pass& pass) {
    const std::vector<CallInSpace> calls = calls_in_space(sites_in_space_of(cell.setting, 1));
    std::vector<Row> rows = pass.number == 1 ? shares_of(cell, calls) : std::vector<Row>{};
    const std::vector<Row> costs =
        costs_of<CallInSpace, decide_call_in_space, decide_in_space_in_rationals>(cell, pass,
                                                                                  calls);
    rows.insert(rows.end(), costs.begin(), costs.end());
    return rows;
}

}  // namespace

std::vector<Row> measure_stage_cost(const Cell& cell, const Pass& pass) {
    if (cell.dimension == 3) return measure_in_space(cell, pass);
    const Metric metric = metric_named(cell.setting.metric).value();
    const std::vector<RankedCall> calls = calls_of(triangulate(sites_of(cell.setting, 1), metric));
    return with_metric(metric, [&]<class M>(M) {
        return costs_of<RankedCall, decide<M>, decide_in_rationals<M>>(cell, pass, calls);
    });
}

}  // namespace signum::study
