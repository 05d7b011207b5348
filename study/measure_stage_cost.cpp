/// What a call of in_circle costs, by the stage that decides it. The calls are those of a finished
/// tessellation: the three sites of a face, and the one across an edge.

#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include <signum/predicates/euclidean.hpp>
#include <signum/predicates/manhattan.hpp>
#include <signum/predicates/power.hpp>
#include <signum/predicates/supremum.hpp>

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
};
struct InEuclidean {
    static Decision decide(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return euclidean::in_circle_decision(i, j, k, q, call.ranks);
    }
};
template <class Directions>
struct InSquares {
    static Decision decide(const Call& call) noexcept {
        const auto& [i, j, k, q] = call.sites;
        return rectangular::in_circle_decision<Directions>(i, j, k, q, call.ranks);
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

/// Nanoseconds a call, in a loop of a millisecond or more.
template <class Metric>
double ns_per_call(const std::vector<Call>& calls) {
    constexpr double long_enough = 1e-3;
    Sign sum = 0;
    std::size_t passes = 0;
    double seconds = 0.0;
    while (seconds < long_enough) {
        seconds += seconds_of([&] {
            for (const Call& call : calls) sum += Metric::decide(call).sign;
        });
        ++passes;
    }
    volatile Sign sink = sum;
    static_cast<void>(sink);
    return 1e9 * seconds / (static_cast<double>(passes) * static_cast<double>(calls.size()));
}

template <class Metric>
std::vector<Row> measure_in(const Cell& cell, const std::vector<Call>& calls) {
    constexpr std::size_t few = 16;
    constexpr std::array stages = {Stage::filter, Stage::refine, Stage::exact,
                                   Stage::multiprecision};
    std::array<std::vector<Call>, 4> decided;
    for (const Call& call : calls)
        decided[static_cast<std::size_t>(Metric::decide(call).stage)].push_back(call);
    std::vector<Contestant> contestants;
    std::vector<Stage> names;
    for (const Stage stage : stages) {
        const std::vector<Call>& group = decided[static_cast<std::size_t>(stage)];
        if (group.size() < few) continue;
        names.push_back(stage);
        contestants.emplace_back([&group] { return ns_per_call<Metric>(group); });
    }
    std::vector<Row> rows;
    if (contestants.empty()) return rows;
    const Race race = study::race(contestants, cell.budget);
    for (std::size_t i = 0; i < names.size(); ++i)
        rows.push_back({cell.setting, name_of(names[i]), "ns_per_call", race.seconds[i]});
    return rows;
}

}  // namespace

std::vector<Row> measure_stage_cost(const Cell& cell) {
    const Metric metric = metric_named(cell.setting.metric);
    const std::vector<Call> calls = calls_of(triangulate(sites_of(cell.setting, 1), metric));
    switch (metric) {
        case Metric::power:
            return measure_in<InPower>(cell, calls);
        case Metric::euclidean:
            return measure_in<InEuclidean>(cell, calls);
        case Metric::manhattan:
            return measure_in<InSquares<rectangular::Manhattan>>(cell, calls);
        case Metric::supremum:
            return measure_in<InSquares<rectangular::Supremum>>(cell, calls);
    }
    return {};
}

}  // namespace signum::study
