/// signum sign in space.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "../../predicates/space.hpp"
#include "../../predicates/space/ties.hpp"
#include "../../voronoi/balls/touching_rectangular.hpp"

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

/// Throws CallError where the call says which sphere is meant, and need not.
void refuse_number(const SignCall& call, std::string_view spheres) {
    if (!call.sphere) return;
    throw CallError(fmt::format("--sphere: in the {} metric four sites have {}; leave it out",
                                call.metric, spheres));
}

Answer decide_in_sphere(const SignCall& call, Power) {
    refuse_number(call, "one sphere");
    return call.weight_is == name_of(WeightIs::weight) ? decide_in_sphere_of<power::Site3>(call)
                                                       : decide_in_sphere_of<Site3>(call);
}

using Sites3 = std::array<Site3, 5>;
using Hides = Decision (*)(const Site3& i, const Site3& q) noexcept;

/// Throws CallError where one of i, j, k and l hides another one.
void refuse_hidden(const Sites3& sites, Hides hides, std::string_view shape) {
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            if (a == b || hides(sites[a], sites[b]).sign < 0) continue;
            throw CallError(
                fmt::format("sign in_sphere: {0} hides {1}, so that no {2} touches i, j, k and "
                            "l; leave {1} out",
                            names_in_space[a], names_in_space[b], shape));
        }
    }
}

/// The answer of a metric with additive weights, which has no tie rule in space.
Answer explained(const Decision& decision, const Sites3& sites, Hides hides,
                 std::string_view shape) {
    Answer answer = {decision, {}, {}};
    const Site3& q = sites[4];
    for (std::size_t m = 0; m < 4; ++m) {
        if (hides(sites[m], q).sign > 0)
            answer.words.push_back(fmt::format("hidden   {} hides q", names_in_space[m]));
        if (hides(q, sites[m]).sign > 0)
            answer.words.push_back(fmt::format("hidden   q hides {}", names_in_space[m]));
    }
    if (decision.sign == 0) {
        answer.words.push_back(fmt::format(
            "tie      q touches the {} of i, j, k and l; the metric has no tie rule in space",
            shape));
    }
    explain_stage(answer);
    return answer;
}

/// Throws CallError where no sphere touches i, j, k and l with points of contact that turn
/// positively, and says why.
void check_sphere_exists(const Sites3& sites) {
    const auto& [i, j, k, l, q] = sites;
    if (euclidean::exists(i, j, k, l)) return;
    refuse_hidden(sites, euclidean::hides_decision, "sphere");
    throw CallError(
        fmt::format("sign in_sphere: no sphere touches i, j, k and l in points that turn "
                    "positively; {}",
                    euclidean::exists(j, i, k, l)
                        ? "one touches them in points that turn negatively: exchange two of them"
                        : "none touches them in points that turn negatively either: give four "
                          "other sites"));
}

Answer decide_in_sphere(const SignCall& call, Euclidean) {
    refuse_number(call, "two spheres at most, which their order tells apart");
    const auto sites = sites_in_space_of<Site3>(call);
    const auto& [i, j, k, l, q] = sites;
    check_sphere_exists(sites);
    return explained(euclidean::in_sphere_decision(i, j, k, l, q), sites, euclidean::hides_decision,
                     "sphere");
}

/// What the spheres of a metric are called.
struct ShapeWords {
    std::string_view one;
    std::string_view several;
};

/// Of several spheres, what to say for each.
template <class M>
std::string choices(const Sites3& sites, M metric) {
    std::string text;
    std::size_t number = 0;
    for (const auto& [x, y, z, r] :
         touching_spheres(std::span<const Site3>(sites).first(4), metric).spheres) {
        text += fmt::format("{}--sphere {} is that around {} {} {} with radius {}",
                            number > 0 ? ", " : "", number, x, y, z, r);
        ++number;
    }
    return text;
}

/// The number of the sphere that is meant. Throws CallError where there is none.
template <class M>
std::uint8_t sphere_of(const SignCall& call, const rectangular::Spheres& all, const Sites3& sites,
                       Hides hides, const ShapeWords& shape, M metric) {
    if (all.infinitely_many) {
        throw CallError(
            fmt::format("sign in_sphere: infinitely many {} touch i, j, k and l; give four other "
                        "sites",
                        shape.several));
    }
    if (all.count == 0) {
        refuse_hidden(sites, hides, shape.one);
        throw CallError(fmt::format(
            "sign in_sphere: no {} touches i, j, k and l; give four other sites", shape.one));
    }
    const int number = call.sphere.value_or(0);
    const bool is_said = call.sphere || all.count == 1;
    if (is_said && number < all.count) return static_cast<std::uint8_t>(number);
    if (all.count == 1) {
        throw CallError(
            fmt::format("--sphere {}: one {} alone touches i, j, k and l; leave --sphere out",
                        number, shape.one));
    }
    throw CallError(fmt::format("{}: {} {} touch i, j, k and l; say which is meant: {}",
                                is_said ? fmt::format("--sphere {}", number) : "sign in_sphere",
                                int{all.count}, shape.several, choices(sites, metric)));
}

template <class Shape, class M>
Answer decide_by_facets(const SignCall& call, M metric, const ShapeWords& shape) {
    constexpr Hides hides = rectangular::hides_decision<Shape>;
    const auto sites = sites_in_space_of<Site3>(call);
    const auto& [i, j, k, l, q] = sites;
    const rectangular::Spheres all = rectangular::spheres<Shape>(i, j, k, l);
    const std::uint8_t number = sphere_of(call, all, sites, hides, shape, metric);
    return explained(rectangular::in_sphere_decision<Shape>(i, j, k, l, all.spheres[number], q),
                     sites, hides, shape.one);
}
Answer decide_in_sphere(const SignCall& call, Supremum metric) {
    return decide_by_facets<rectangular::Cube>(call, metric, {"cube", "cubes"});
}
Answer decide_in_sphere(const SignCall& call, Manhattan metric) {
    return decide_by_facets<rectangular::Octahedron>(call, metric, {"octahedron", "octahedra"});
}

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
    return with_metric(metric, [&](auto each) { return decide_in_sphere(call, each); });
}

}  // namespace signum::cli
