/// signum sign in space.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "../predicates/space.hpp"
#include "../predicates/space/ties.hpp"

#include "commands.hpp"
#include "sign_call.hpp"

namespace signum::cli {
namespace {

constexpr std::size_t numbers_of_four_points = 12;

Answer decide_ccw_in_space(const SignCall& call) {
    const std::vector<double> v =
        numbers_of(call, numbers_of_four_points, "x y z of each of four points");
    std::array<Point3, 4> p;
    for (std::size_t m = 0; m < 4; ++m) p[m] = {v[3 * m], v[3 * m + 1], v[3 * m + 2]};
    Answer answer = {ccw_decision(p[0], p[1], p[2], p[3]), {}, {}};
    if (answer.decision.sign == 0)
        answer.words.emplace_back("tie      the points lie in a plane; ccw has no tie rule");
    explain_stage(answer);
    return answer;
}

/// i, j, k, l and q.
template <class S>
std::array<S, 5> sites_in_space_of(const SignCall& call) {
    const std::vector<double> v =
        numbers_of(call, 20, "x y z r of each of the sites i, j, k, l and of the query");
    std::array<S, 5> sites;
    for (std::size_t m = 0; m < 5; ++m)
        sites[m] = {v[4 * m], v[4 * m + 1], v[4 * m + 2], v[4 * m + 3]};
    return sites;
}
constexpr std::string_view names_in_space = "ijklq";

template <class S>
Answer decide_in_sphere_of(const SignCall& call) {
    const auto sites = sites_in_space_of<S>(call);
    const auto& [i, j, k, l, q] = sites;
    const Sign turn = ccw_decision(i, j, k, l).sign;
    if (turn < 0) {
        throw CallError(
            "sign in_sphere: i, j, k, l must turn positively, as sign ccw --dimension 3 says, and "
            "turn negatively; exchange two of them");
    }
    if (turn == 0) {
        throw CallError(
            "sign in_sphere: i, j, k, l must turn positively and lie in a plane: no sphere touches "
            "them; give four centres that do not");
    }
    Answer answer = {power::in_sphere_decision(i, j, k, l, q), {}, {}};
    if (answer.decision.sign == 0) {
        constexpr std::array<Index, 5> indices = {0, 1, 2, 3, 4};
        const auto last = std::ranges::max_element(indices, [&](Index a, Index b) {
            return power::precedes(sites[static_cast<std::size_t>(a)], a,
                                   sites[static_cast<std::size_t>(b)], b);
        });
        explain_tie(answer, "sphere of i, j, k and l", "weight, rising x, y, z",
                    names_in_space[static_cast<std::size_t>(last - indices.begin())],
                    power::in_sphere_tie(sites, indices) > 0);
    }
    explain_stage(answer);
    return answer;
}

Answer decide_in_power_sphere(const SignCall& call) {
    return call.weight_is == name_of(WeightIs::weight) ? decide_in_sphere_of<power::Site3>(call)
                                                       : decide_in_sphere_of<Site3>(call);
}

/// Throws CallError where no sphere touches i, j, k and l with points of contact that turn
/// positively, and says why.
void check_sphere_exists(const std::array<Site3, 5>& sites) {
    const auto& [i, j, k, l, q] = sites;
    if (euclidean::exists(i, j, k, l)) return;
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            if (a == b || !euclidean::hidden(sites[b], sites[a])) continue;
            throw CallError(
                fmt::format("sign in_sphere: {0} hides {1}, so that no sphere touches i, j, k and "
                            "l; leave {1} out",
                            names_in_space[a], names_in_space[b]));
        }
    }
    throw CallError(
        fmt::format("sign in_sphere: no sphere touches i, j, k and l in points that turn "
                    "positively; {}",
                    euclidean::exists(j, i, k, l)
                        ? "one touches them in points that turn negatively: exchange two of them"
                        : "none touches them in points that turn negatively either: give four "
                          "other sites"));
}

/// The metric has no tie rule in space.
Answer decide_in_euclidean_sphere(const SignCall& call) {
    const auto sites = sites_in_space_of<Site3>(call);
    const auto& [i, j, k, l, q] = sites;
    check_sphere_exists(sites);
    Answer answer = {euclidean::in_sphere_decision(i, j, k, l, q), {}, {}};
    for (std::size_t m = 0; m < 4; ++m) {
        if (euclidean::hidden(q, sites[m]))
            answer.words.push_back(fmt::format("hidden   {} hides q", names_in_space[m]));
        if (euclidean::hidden(sites[m], q))
            answer.words.push_back(fmt::format("hidden   q hides {}", names_in_space[m]));
    }
    if (answer.decision.sign == 0) {
        answer.words.emplace_back(
            "tie      q touches the sphere of i, j, k and l; the metric has no tie rule in space");
    }
    explain_stage(answer);
    return answer;
}

/// The metrics that have in_sphere. That of another one is added here.
struct SpheresOfMetric {
    Metric metric;
    Answer (*decide)(const SignCall& call);
};
constexpr std::array spheres = {SpheresOfMetric{Metric::power, decide_in_power_sphere},
                                SpheresOfMetric{Metric::euclidean, decide_in_euclidean_sphere}};

}  // namespace

bool is_in_space(const SignCall& call) {
    if (call.predicate == "ccw")
        return call.dimension ? *call.dimension == 3
                              : call.numbers.size() == numbers_of_four_points;
    const int dimension = call.predicate == "in_sphere" ? 3 : 2;
    if (call.dimension.value_or(dimension) != dimension) {
        throw CallError(
            fmt::format("sign {}: it is asked in {}; leave --dimension {} out, or ask {}",
                        call.predicate, dimension == 3 ? "space" : "the plane", *call.dimension,
                        dimension == 3 ? "in_circle" : "in_sphere"));
    }
    return dimension == 3;
}

Answer decide_in_space(const SignCall& call) {
    if (call.predicate == "ccw") return decide_ccw_in_space(call);
    const Metric metric = metric_of(call.metric);
    check_weight_is(call.weight_is, metric);
    const auto found = std::ranges::find(spheres, metric, &SpheresOfMetric::metric);
    if (found != spheres.end()) return found->decide(call);
    std::vector<std::string_view> metrics;
    for (const SpheresOfMetric& each : spheres) metrics.push_back(name_of(each.metric));
    throw CallError(
        fmt::format("sign in_sphere: there are --metric {} alone, and this is --metric {}; name "
                    "one of them",
                    fmt::join(metrics, " and "), call.metric));
}

}  // namespace signum::cli
