/// signum sign: one predicate on numbers from the command line, in the plane or in space.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../core/index.hpp"
#include "../../predicates/space/ties.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "../../voronoi/balls/touching_rectangular.hpp"
#include "../io/errors.hpp"
#include "../io/number.hpp"

#include "commands.hpp"
#include "outputs.hpp"

namespace signum::cli {
namespace {

constexpr std::string_view standard_input = "-";

/// The call as it was typed.
struct SignCall {
    std::string predicate;
    std::string metric;
    bool has_metric = false;  ///< it was typed
    std::string weight_is;
    std::optional<int> dimension;
    std::optional<int> sphere;  ///< which of several, from 0
    bool json = false;
    bool explain = false;
    std::vector<std::string> numbers;
    std::string_view place = " after --";  ///< of the numbers
};

/// What the tie rule makes of a sign that is 0.
struct Tie {
    char last;  ///< of the sites i, j, k, in space l, and q, in the rule's order
    bool conflict;
};

struct Answer {
    Decision decision;
    std::optional<Tie> tie;
    /// What there is to say about it, a line each.
    std::vector<std::string> words;
};

/// The numbers of the call. Throws CallError where there are not as many as needed, and says what
/// they mean.
std::vector<double> numbers_of(const SignCall& call, std::size_t needed, std::string_view meaning) {
    if (call.numbers.size() != needed) {
        throw CallError(fmt::format("sign {} needs {} numbers{}, {}; {} {} given", call.predicate,
                                    needed, call.place, meaning, call.numbers.size(),
                                    call.numbers.size() == 1 ? "is" : "are"));
    }
    std::vector<double> values;
    for (const std::string& text : call.numbers) {
        const Number number = parse_number(text);
        if (number.fault != NumberFault::none) {
            throw CallError(fmt::format("number {} of {}: {}", values.size() + 1, needed,
                                        explain(number.fault, text)));
        }
        values.push_back(number.value);
    }
    return values;
}

/// Adds who decided, where it was not the filter.
void explain_stage(Answer& answer) {
    const auto decided_by = [&](std::string_view what) {
        answer.words.push_back(fmt::format("decided  not by the filter, but by {}", what));
    };
    switch (answer.decision.stage) {
        case Stage::filter:
            return;
        case Stage::refine:
            return decided_by("a finer bound or double-doubles");
        case Stage::exact:
            return decided_by("integers, expansions or sums that commit no rounding");
        case Stage::essa:
            return decided_by("the exact sign of a sum (ESSA)");
        case Stage::multiprecision:
            return decided_by("rationals");
    }
}

/// Adds what the tie rule makes of a 0: of the sites, q among them, that called `last` is the last
/// one. `what` is what q touches, "circle of i, j and k"; `order` the rule's.
void explain_tie(Answer& answer, std::string_view what, std::string_view order, char last,
                 bool conflict) {
    answer.tie = {last, conflict};
    answer.words.push_back(fmt::format("tie      q touches the {}", what));
    answer.words.push_back(
        fmt::format("rule     by falling {} and place {} is the last of them: q {}", order, last,
                    conflict ? "conflicts" : "does not conflict"));
}

// ---- what plane and space share ----------------------------------------------------------------

constexpr std::size_t numbers_of_four_points = 12;

Answer decide_ccw(const SignCall& call, bool in_space) {
    const std::vector<double> v =
        in_space ? numbers_of(call, numbers_of_four_points, "x y z of each of four points")
                 : numbers_of(call, 6, "x y of each of three points");
    Answer answer;
    if (in_space) {
        std::array<Point3, 4> p;
        for (std::size_t m = 0; m < 4; ++m) p[m] = {v[3 * m], v[3 * m + 1], v[3 * m + 2]};
        answer.decision = ccw_decision(p[0], p[1], p[2], p[3]);
    } else {
        answer.decision = ccw_decision({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]});
    }
    if (answer.decision.sign == 0)
        answer.words.push_back(fmt::format("tie      the points lie {}; ccw has no tie rule",
                                           in_space ? "in a plane" : "on a line"));
    explain_stage(answer);
    return answer;
}

/// i, j, k, in space l, and q: by how many they are, their names, ...
template <std::size_t N>
constexpr std::string_view names = N == 4 ? "ijkq" : "ijklq";
/// ... those of all but q, and what is asked.
template <std::size_t N>
constexpr std::string_view touched = N == 4 ? "i, j and k" : "i, j, k and l";
template <std::size_t N>
constexpr std::string_view predicate = N == 4 ? "in_circle" : "in_sphere";

template <class S, std::size_t N>
std::array<S, N> sites_of(const SignCall& call) {
    const std::vector<double> v =
        numbers_of(call, N * (N - 1),
                   N == 4 ? "x y r of each of the sites i, j, k and of the query"
                          : "x y z r of each of the sites i, j, k, l and of the query");
    std::array<S, N> sites;
    for (std::size_t m = 0; m < N; ++m) {
        const double* const numbers = &v[(N - 1) * m];
        if constexpr (N == 4)
            sites[m] = {numbers[0], numbers[1], numbers[2]};
        else
            sites[m] = {numbers[0], numbers[1], numbers[2], numbers[3]};
    }
    return sites;
}

/// Throws CallError where one of the sites but q hides another one; `hides` takes the places of
/// two.
template <std::size_t N, class Hides>
void refuse_hidden(const Hides& hides, std::string_view shape) {
    for (std::size_t a = 0; a + 1 < N; ++a) {
        for (std::size_t b = 0; b + 1 < N; ++b) {
            if (a == b || hides(a, b) < 0) continue;
            throw CallError(
                fmt::format("sign {3}: {0} hides {1}, so that no {2} touches {4}; leave {1} out",
                            names<N>[a], names<N>[b], shape, predicate<N>, touched<N>));
        }
    }
}

/// Adds which of them hides q, or is hidden by it.
template <std::size_t N, class Hides>
void explain_hidden(Answer& answer, const Hides& hides) {
    for (std::size_t m = 0; m + 1 < N; ++m) {
        if (hides(m, N - 1) > 0)
            answer.words.push_back(fmt::format("hidden   {} hides q", names<N>[m]));
        if (hides(N - 1, m) > 0)
            answer.words.push_back(fmt::format("hidden   q hides {}", names<N>[m]));
    }
}

// ---- in the plane ------------------------------------------------------------------------------

/// `ranks` are the places of i, j, k and q in the rule's order.
void explain_tie_on_circle(Answer& answer, std::string_view circle, std::string_view third,
                           const std::array<Index, 4>& ranks, Sign perturbed) {
    const auto last =
        static_cast<std::size_t>(std::max_element(ranks.begin(), ranks.end()) - ranks.begin());
    explain_tie(answer, fmt::format("{} of i, j and k", circle),
                fmt::format("{}, rising x, y", third), names<4>[last], perturbed > 0);
}

template <class S>
Answer decide_in_power(const SignCall& call) {
    const auto sites = sites_of<S, 4>(call);
    const auto& [i, j, k, q] = sites;
    const Sign turn = ccw_decision(i, j, k).sign;
    if (turn < 0) {
        throw CallError(
            "sign in_circle: i, j, k must be counterclockwise and are clockwise; exchange "
            "two of them");
    }
    if (turn == 0) {
        throw CallError(
            "sign in_circle: i, j, k must be counterclockwise and are collinear: no circle "
            "touches them; give three centres that are not on one line");
    }
    Answer answer = {power::in_circle_decision(i, j, k, q), {}, {}};
    if (answer.decision.sign == 0) {
        std::array<Index, 4> ranks{};
        for (Index a = 0; a < 4; ++a)
            for (Index b = 0; b < a; ++b) {
                const bool a_first = power::precedes(sites[static_cast<std::size_t>(a)], a,
                                                     sites[static_cast<std::size_t>(b)], b);
                ++ranks[static_cast<std::size_t>(a_first ? b : a)];
            }
        explain_tie_on_circle(answer, "circle", "weight", ranks,
                              power::in_circle_perturbed(i, j, k, q, ranks));
    }
    explain_stage(answer);
    return answer;
}

/// Throws CallError where nothing touches i, j and k counterclockwise, and says why.
template <class M>
void check_existence(const std::array<Site, 4>& sites, const std::array<Index, 4>& ranks) {
    using Rule = typename triangulation::PredicatesOf<M>::template Perturbed<>;
    const auto& [i, j, k, q] = sites;
    const Decision forth = Rule::exists(i, j, k, {ranks[0], ranks[1], ranks[2]});
    if (forth.sign > 0) return;
    const Decision back = Rule::exists(j, i, k, {ranks[1], ranks[0], ranks[2]});
    throw CallError(
        fmt::format("sign in_circle: {}no {} touches i, j and k counterclockwise; {}",
                    forth.tied || back.tied ? "under the tie rule " : "", M::traits.circle,
                    back.sign > 0 ? "one touches them clockwise: exchange two of them"
                                  : "none touches them clockwise either: give three other sites"));
}

/// In a metric with additive weights. All but in_circle_of_any follow the tie rule and are never 0;
/// `ranks` are places in its order.
template <class M>
Answer decide_additively(const SignCall& call) {
    using Predicates = triangulation::PredicatesOf<M>;
    using Rule = typename Predicates::template Perturbed<>;
    const auto sites = sites_of<Site, 4>(call);
    const auto& [i, j, k, q] = sites;
    const auto ranks = additive::ranks_of<4>({&i, &j, &k, &q});
    const auto hides = [&](std::size_t a, std::size_t b) {
        return Rule::hides(sites[a], sites[b], {ranks[a], ranks[b]}).sign;
    };
    refuse_hidden<4>(hides, M::traits.circle);
    check_existence<M>(sites, ranks);
    Answer answer = {Predicates::in_circle_of_any(i, j, k, q, ranks), {}, {}};
    explain_hidden<4>(answer, hides);
    if (answer.decision.sign == 0) {
        explain_tie_on_circle(answer, M::traits.circle, "radius", ranks,
                              Rule::in_circle(i, j, k, q, ranks).sign);
    }
    explain_stage(answer);
    return answer;
}

// ---- in space ----------------------------------------------------------------------------------

template <class S>
Answer decide_in_sphere_of(const SignCall& call) {
    const auto sites = sites_of<S, 5>(call);
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
                    names<5>[static_cast<std::size_t>(last - indices.begin())],
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

using Sites3 = std::array<Site3, 5>;
using Hides = Decision (*)(const Site3& i, const Site3& q) noexcept;

/// Whether one of the sites, by their places, hides another one.
auto hiding(const Sites3& sites, Hides hides) {
    return [&sites, hides](std::size_t a, std::size_t b) { return hides(sites[a], sites[b]).sign; };
}

/// The answer of a metric with additive weights, which has no tie rule in space.
Answer explained(const Decision& decision, const Sites3& sites, Hides hides,
                 std::string_view shape) {
    Answer answer = {decision, {}, {}};
    explain_hidden<5>(answer, hiding(sites, hides));
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
template <class InSpace>
void check_sphere_exists(const Sites3& sites, std::string_view sphere) {
    const auto& [i, j, k, l, q] = sites;
    if (InSpace::spheres(i, j, k, l) > 0) return;
    refuse_hidden<5>(hiding(sites, InSpace::hides_decision), sphere);
    throw CallError(
        fmt::format("sign in_sphere: no {} touches i, j, k and l in points that turn "
                    "positively; {}",
                    sphere,
                    InSpace::spheres(j, i, k, l) > 0
                        ? "one touches them in points that turn negatively: exchange two of them"
                        : "none touches them in points that turn negatively either: give four "
                          "other sites"));
}

/// Of several spheres, what to say for each.
std::string choices(const Sites3& sites, Metric metric) {
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

/// The number of the sphere that is meant, of so many. Throws CallError where there is none.
std::uint8_t sphere_of(const SignCall& call, int spheres, const Sites3& sites, Hides hides,
                       Metric metric) {
    const std::string_view one = traits_of(metric).sphere;
    const std::string_view several = traits_of(metric).spheres;
    if (spheres == triangulation::infinitely_many) {
        throw CallError(fmt::format(
            "sign in_sphere: infinitely many {} touch i, j, k and l; give four other sites",
            several));
    }
    if (spheres == 0) {
        refuse_hidden<5>(hiding(sites, hides), one);
        throw CallError(
            fmt::format("sign in_sphere: no {} touches i, j, k and l; give four other sites", one));
    }
    const int number = call.sphere.value_or(0);
    const bool is_said = call.sphere || spheres == 1;
    if (is_said && number < spheres) return static_cast<std::uint8_t>(number);
    if (spheres == 1) {
        throw CallError(fmt::format(
            "--sphere {}: one {} alone touches i, j, k and l; leave --sphere out", number, one));
    }
    throw CallError(fmt::format("{}: {} {} touch i, j, k and l; say which is meant: {}",
                                is_said ? fmt::format("--sphere {}", number) : "sign in_sphere",
                                spheres, several, choices(sites, metric)));
}

template <class M>
Answer decide_in_sphere(const SignCall& call, M metric) {
    using InSpace = typename triangulation::PredicatesOf<M>::InSpace;
    if constexpr (M::traits.edges_are_straight) {
        refuse_number(call, "one sphere");
        return call.weight_is == name_of(WeightIs::weight) ? decide_in_sphere_of<power::Site3>(call)
                                                           : decide_in_sphere_of<Site3>(call);
    } else {
        if constexpr (!InSpace::are_numbered)
            refuse_number(call, "two spheres at most, which their order tells apart");
        const auto sites = sites_of<Site3, 5>(call);
        const auto& [i, j, k, l, q] = sites;
        std::uint8_t number = 0;
        if constexpr (InSpace::are_numbered)
            number = sphere_of(call, InSpace::spheres(i, j, k, l), sites, InSpace::hides_decision,
                               metric);
        else
            check_sphere_exists<InSpace>(sites, M::traits.sphere);
        return explained(InSpace::in_sphere_decision(i, j, k, l, q, number), sites,
                         InSpace::hides_decision, M::traits.sphere);
    }
}

// ---- Shewchuk's names --------------------------------------------------------------------------

/// One of his functions, whose points are given one after the other.
struct Classic {
    std::string_view name;
    std::size_t dimension;
    std::size_t points;
    Decision (*decide)(const double* numbers) noexcept;
};
template <std::size_t d>
auto point_at(const double* numbers, std::size_t m) noexcept {
    const double* const p = numbers + d * m;
    if constexpr (d == 2)
        return Point{p[0], p[1]};
    else
        return Point3{p[0], p[1], p[2]};
}
/// In space his signs are the opposite ones.
Decision opposite(Decision decision) noexcept {
    decision.sign = -decision.sign;
    return decision;
}
constexpr std::array<Classic, 4> classics = {
    {{"orient2d", 2, 3,
      [](const double* n) noexcept {
          return ccw_decision(point_at<2>(n, 0), point_at<2>(n, 1), point_at<2>(n, 2));
      }},
     {"incircle", 2, 4,
      [](const double* n) noexcept {
          return predicates::decide<Arithmetic::exact, power::InCircle>(
              point_at<2>(n, 0), point_at<2>(n, 1), point_at<2>(n, 2), point_at<2>(n, 3));
      }},
     {"orient3d", 3, 4,
      [](const double* n) noexcept {
          return opposite(ccw_decision(point_at<3>(n, 0), point_at<3>(n, 1), point_at<3>(n, 2),
                                       point_at<3>(n, 3)));
      }},
     {"insphere", 3, 5, [](const double* n) noexcept {
          return opposite(predicates::decide<Arithmetic::exact, power::InSphere>(
              point_at<3>(n, 0), point_at<3>(n, 1), point_at<3>(n, 2), point_at<3>(n, 3),
              point_at<3>(n, 4)));
      }}}};

Answer decide_classic(const SignCall& call, const Classic& classic) {
    const std::vector<double> numbers =
        numbers_of(call, classic.dimension * classic.points,
                   fmt::format("{} of each of {} points", classic.dimension == 2 ? "x y" : "x y z",
                               classic.points));
    Answer answer;
    answer.decision = classic.decide(numbers.data());
    explain_stage(answer);
    return answer;
}

// ---- the call ----------------------------------------------------------------------------------

/// Whether the call is one of space: in_sphere, and ccw with --dimension 3 or twelve numbers.
/// Throws CallError where predicate and dimension do not fit.
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

Answer decide(const SignCall& call) {
    if (call.sphere && call.predicate != "in_sphere")
        throw CallError(fmt::format("--sphere is of in_sphere alone, and this is {}; leave it out",
                                    call.predicate));
    const auto* const classic = std::ranges::find(classics, call.predicate, &Classic::name);
    if (classic != classics.end()) {
        if (call.has_metric || !call.weight_is.empty() || call.dimension)
            throw CallError(fmt::format(
                "sign {}: it asks of points; leave --metric, --weight-is and --dimension out",
                call.predicate));
        return decide_classic(call, *classic);
    }
    const bool in_space = is_in_space(call);
    // ccw is the same in every metric.
    if (call.predicate == "ccw") return decide_ccw(call, in_space);
    const Metric metric = metric_of(call.metric);
    check_weight_is(call.weight_is, metric);
    return with_metric(metric, [&]<class M>(M each) {
        if (in_space) return decide_in_sphere(call, each);
        if constexpr (M::traits.edges_are_straight) {
            return call.weight_is == name_of(WeightIs::weight) ? decide_in_power<power::Site>(call)
                                                               : decide_in_power<Site>(call);
        } else {
            return decide_additively<M>(call);
        }
    });
}

/// The sign and the stage, a line.
std::string line_of(const Answer& answer, bool json) {
    const auto& [decision, tie, words] = answer;
    if (!json) return fmt::format("{} {}\n", decision.sign, name_of(decision.stage));
    return fmt::format("{{\"sign\": {}, \"stage\": \"{}\"{}}}\n", decision.sign,
                       name_of(decision.stage),
                       tie ? fmt::format(", \"tie\": {{\"last\": \"{}\", \"conflict\": {}}}",
                                         tie->last, tie->conflict)
                           : "");
}
/// Words about an answer to standard error.
void print_words(const Answer& answer, bool explain, const std::string& before = {}) {
    if (explain && answer.decision.stage == Stage::filter)
        std::fprintf(stderr, "%sdecided  by the filter\n", before.c_str());
    for (const std::string& line : answer.words)
        std::fprintf(stderr, "%s%s\n", before.c_str(), line.c_str());
}

/// The predicates that a call may name.
std::vector<std::string> names_of_predicates() {
    std::vector<std::string> names = {"ccw", "in_circle", "in_sphere"};
    for (const Classic& each : classics) names.emplace_back(each.name);
    return names;
}

/// A question a line from standard input: its numbers, after the name of a predicate where the call
/// has none, parted by blanks, commas, semicolons or brackets. What follows # is none. Throws
/// InputError for the first one that cannot be asked; those before are answered.
void answer_lines(const SignCall& call) {
    std::string line;
    std::int64_t number = 1;
    for (; std::getline(std::cin, line); ++number) {
        SignCall of_line = call;
        of_line.numbers.clear();
        of_line.place = {};
        line.resize(std::min(line.find('#'), line.size()));
        for (char& c : line)
            if (std::string_view(",;()[]").find(c) != std::string_view::npos) c = ' ';
        std::istringstream words(line);
        std::string word;
        if (!(words >> word)) continue;
        if (call.predicate == standard_input) {
            const std::vector<std::string> names = names_of_predicates();
            if (std::ranges::find(names, word) == names.end())
                throw InputError("standard input", {number, 1},
                                 fmt::format("{} is no predicate; they are {}", in_quotes(word),
                                             fmt::join(names, ", ")));
            of_line.predicate = word;
        } else {
            of_line.numbers.push_back(word);
        }
        while (words >> word) of_line.numbers.push_back(word);
        try {
            const Answer answer = decide(of_line);
            print(line_of(answer, call.json));
            if (call.explain) print_words(answer, true, fmt::format("line {}: ", number));
        } catch (const CallError& error) {
            throw InputError("standard input", {number, 1}, error.what());
        }
    }
    if (std::cin.bad()) throw InputError("standard input", {number, 1}, "it cannot be read");
}

void run(const SignCall& call) {
    if (call.predicate == standard_input || call.numbers == std::vector<std::string>{"-"}) {
        if (call.predicate == standard_input && !call.numbers.empty())
            throw CallError("sign -: questions come from standard input; leave the numbers out");
        return answer_lines(call);
    }
    const Answer answer = decide(call);
    print(line_of(answer, call.json));
    // As JSON the answer alone, unless it is asked for.
    if (!call.json || call.explain) print_words(answer, call.explain);
}

}  // namespace

void add_sign(CLI::App& tool) {
    auto call = std::make_shared<SignCall>();
    CLI::App* command = tool.add_subcommand(
        "sign", "Prints the exact sign of a predicate, and the stage that decided it");
    add_checked(*command, "PREDICATE", call->predicate, "", one_of([] {
        std::vector<std::string> names = names_of_predicates();
        names.emplace_back(standard_input);
        return names;
    }()),
                "ccw        three points turn left (1), right (-1)\n"
                "           or lie on a line (0)\n"
                "           in space: the fourth lies on the side from\n"
                "           which the others turn counterclockwise (1)\n"
                "in_circle  the last site is inside (1), outside (-1)\n"
                "           or on (0) the circle (diamond, square) that\n"
                "           touches the others counterclockwise\n"
                "in_sphere  the same of a sphere in space that touches\n"
                "           four others, in the power metric centres\n"
                "           that turn positively, in the Euclidean one\n"
                "           in points that do; in the supremum and the\n"
                "           Manhattan metric of a cube or an octahedron\n"
                "orient2d, incircle, orient3d, insphere\n"
                "           of points, with the signs of Shewchuk's functions\n"
                "-          the first word of each line of standard input")
        ->required();
    command
        ->add_option("NUMBER", call->numbers,
                     "After --: x y of each point for ccw, in space x y z;\n"
                     "x y r of each site for in_circle, x y z r for\nin_sphere. "
                     "- reads a question a line from standard\ninput")
        ->type_name("");
    command
        ->add_option_function<int>(
            "--dimension", [call](int dimension) { call->dimension = dimension; },
            "ccw: 2 or 3. Default: 3 for twelve numbers, else 2")
        ->check(one_of({"2", "3"}))
        ->type_name("2|3");
    command
        ->add_option_function<int>(
            "--sphere", [call](int sphere) { call->sphere = sphere; },
            "in_sphere, supremum and Manhattan: which one is meant\n"
            "where two cubes or up to six octahedra touch the\n"
            "others, from 0; a call without it lists them")
        ->check(one_of({"0", "1", "2", "3", "4", "5"}))
        ->type_name("N");
    add_metric(*command, call->metric);
    add_weight_is(*command, call->weight_is, "radius");
    command->add_flag("--json", call->json,
                      "Prints {\"sign\": S, \"stage\": NAME}; where in_circle\n"
                      "or in_sphere is 0, and there is a tie rule, also\n\"tie\": {\"last\": SITE, "
                      "\"conflict\": BOOL}");
    command->add_flag("--explain", call->explain,
                      "Shows how a tie is broken and which stage decided, on\nstandard error; also "
                      "for lines of input and with --json");
    command->footer(
        "Prints the sign and the stage; words about ties, hidden sites and stages behind\n"
        "the filter go to standard error.\n\n"
        "Examples:\n"
        "  signum sign ccw -- 0 0  1 0  0 1\n"
        "  signum sign orient3d -- 0 0 0  1 0 0  0 1 0  0 0 1\n"
        "  signum sign incircle - < questions.txt\n"
        "  signum sign in_circle --metric power -- 0 0 1  1 0 1  0 1 1  1 1 1\n"
        "  signum sign in_circle --metric supremum -- 0 0 0  4 1 0  1 4 0  2 2 0\n"
        "  signum sign ccw --dimension 3 -- 0 0 0  1 0 0  0 1 0  0 0 1\n"
        "  signum sign in_sphere --metric power -- 0 0 0 1  1 0 0 1  0 1 0 1  0 0 1 1  1 1 1 1\n"
        "  signum sign in_sphere -- 0 0 0 1  4 0 0 1  0 4 0 1  0 0 4 0.5  1 1 1 0\n"
        "  signum sign in_sphere --metric supremum -- 0 0 0 1  6 1 2 1  1 7 3 1  2 3 8 1  4 4 4 0");
    command->callback([call, command] {
        call->has_metric = command->count("--metric") > 0;
        run(*call);
    });
}

}  // namespace signum::cli
