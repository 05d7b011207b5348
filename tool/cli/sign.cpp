/// signum sign: one predicate on numbers from the command line.

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "../../predicates/ccw.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "../io/number.hpp"
#include "../io/output_file.hpp"

#include "commands.hpp"
#include "sign_call.hpp"

namespace signum::cli {

std::vector<double> numbers_of(const SignCall& call, std::size_t needed, std::string_view meaning) {
    if (call.numbers.size() != needed) {
        throw CallError(fmt::format("sign {} needs {} numbers after --, {}; {} {} given",
                                    call.predicate, needed, meaning, call.numbers.size(),
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

void explain_tie(Answer& answer, std::string_view what, std::string_view order, char last,
                 bool conflict) {
    answer.tie = {last, conflict};
    answer.words.push_back(fmt::format("tie      q touches the {}", what));
    answer.words.push_back(
        fmt::format("rule     by falling {} and place {} is the last of them: q {}", order, last,
                    conflict ? "conflicts" : "does not conflict"));
}

namespace {

/// What a metric with additive weights is asked. All but in_circle follow the tie rule and are
/// never 0; `ranks` are places in its order.
struct Predicates {
    std::string_view circle;  ///< what its circles are
    Decision (*hides)(const Site& i, const Site& q, const std::array<Index, 2>& ranks) noexcept;
    Decision (*exists)(const Site& i, const Site& j, const Site& k,
                       const std::array<Index, 3>& ranks) noexcept;
    Decision (*in_circle)(const Site& i, const Site& j, const Site& k, const Site& q,
                          const std::array<Index, 4>& ranks) noexcept;
    Decision (*in_circle_perturbed)(const Site& i, const Site& j, const Site& k, const Site& q,
                                    const std::array<Index, 4>& ranks) noexcept;
};

template <class Directions>
Predicates rectangular_predicates(std::string_view circle) {
    using Perturbed = rectangular::Perturbed<Directions>;
    return {circle, Perturbed::hides, Perturbed::exists,
            rectangular::in_circle_decision<Directions>, Perturbed::in_circle};
}

/// in_circle of discs for every q: one that i, j or k hides conflicts nowhere.
Decision in_circle_of_discs(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    using Perturbed = euclidean::Perturbed<>;
    const bool is_hidden = Perturbed::hides(i, q, {ranks[0], ranks[3]}).sign > 0 ||
                           Perturbed::hides(j, q, {ranks[1], ranks[3]}).sign > 0 ||
                           Perturbed::hides(k, q, {ranks[2], ranks[3]}).sign > 0;
    return is_hidden ? Perturbed::in_circle(i, j, k, q, ranks)
                     : euclidean::in_circle_decision(i, j, k, q, ranks);
}

Predicates predicates_in(Euclidean metric) {
    using Discs = euclidean::Perturbed<>;
    return {metric.traits.circle, Discs::hides, Discs::exists, in_circle_of_discs,
            Discs::in_circle};
}

template <triangulation::Rectangular M>
Predicates predicates_in(M metric) {
    using Directions = typename triangulation::PredicatesOf<M>::Directions;
    return rectangular_predicates<Directions>(metric.traits.circle);
}

/// The names of the four sites of in_circle.
constexpr std::string_view names = "ijkq";

/// `ranks` are the places of i, j, k and q in the rule's order.
void explain_tie_on_circle(Answer& answer, std::string_view circle, std::string_view third,
                           const std::array<Index, 4>& ranks, Sign perturbed) {
    const auto last =
        static_cast<std::size_t>(std::max_element(ranks.begin(), ranks.end()) - ranks.begin());
    explain_tie(answer, fmt::format("{} of i, j and k", circle),
                fmt::format("{}, rising x, y", third), names[last], perturbed > 0);
}

Answer decide_ccw(const SignCall& call) {
    const std::vector<double> v = numbers_of(call, 6, "x y of each of three points");
    Answer answer = {ccw_decision({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}), {}, {}};
    if (answer.decision.sign == 0) {
        answer.words.emplace_back("tie      the points lie on a line; ccw has no tie rule");
    }
    explain_stage(answer);
    return answer;
}

/// i, j, k and q.
template <class S>
using Sites = std::array<S, 4>;

template <class S>
Sites<S> sites_of(const SignCall& call) {
    const std::vector<double> v =
        numbers_of(call, 12, "x y r of each of the sites i, j, k and of the query");
    Sites<S> sites;
    for (std::size_t m = 0; m < 4; ++m) sites[m] = {v[3 * m], v[3 * m + 1], v[3 * m + 2]};
    return sites;
}

template <class S>
Answer decide_in_power(const SignCall& call) {
    const auto sites = sites_of<S>(call);
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
void check_existence(const Predicates& metric, const Sites<Site>& sites,
                     const std::array<Index, 4>& ranks) {
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            if (a == b || metric.hides(sites[a], sites[b], {ranks[a], ranks[b]}).sign < 0) continue;
            throw CallError(
                fmt::format("sign in_circle: {0} hides {1}, so that no {2} touches i, j and k; "
                            "leave {1} out",
                            names[a], names[b], metric.circle));
        }
    }
    const auto& [i, j, k, q] = sites;
    const Decision forth = metric.exists(i, j, k, {ranks[0], ranks[1], ranks[2]});
    if (forth.sign > 0) return;
    const Decision back = metric.exists(j, i, k, {ranks[1], ranks[0], ranks[2]});
    throw CallError(
        fmt::format("sign in_circle: {}no {} touches i, j and k counterclockwise; {}",
                    forth.tied || back.tied ? "under the tie rule " : "", metric.circle,
                    back.sign > 0 ? "one touches them clockwise: exchange two of them"
                                  : "none touches them clockwise either: give three other sites"));
}

Answer decide_additively(const SignCall& call, const Predicates& metric) {
    const auto sites = sites_of<Site>(call);
    const auto& [i, j, k, q] = sites;
    const auto ranks = additive::ranks_of<4>({&i, &j, &k, &q});
    check_existence(metric, sites, ranks);
    Answer answer = {metric.in_circle(i, j, k, q, ranks), {}, {}};
    for (std::size_t m = 0; m < 3; ++m) {
        if (metric.hides(sites[m], q, {ranks[m], ranks[3]}).sign > 0)
            answer.words.push_back(fmt::format("hidden   {} hides q", names[m]));
        if (metric.hides(q, sites[m], {ranks[3], ranks[m]}).sign > 0)
            answer.words.push_back(fmt::format("hidden   q hides {}", names[m]));
    }
    if (answer.decision.sign == 0) {
        explain_tie_on_circle(answer, metric.circle, "radius", ranks,
                              metric.in_circle_perturbed(i, j, k, q, ranks).sign);
    }
    explain_stage(answer);
    return answer;
}

Answer decide(const SignCall& call) {
    if (call.sphere && call.predicate != "in_sphere")
        throw CallError(fmt::format("--sphere is of in_sphere alone, and this is {}; leave it out",
                                    call.predicate));
    if (is_in_space(call)) return decide_in_space(call);
    // ccw is the same in every metric.
    if (call.predicate == "ccw") return decide_ccw(call);
    const Metric metric = metric_of(call.metric);
    check_weight_is(call.weight_is, metric);
    return with_metric(metric, [&]<class M>(M each) {
        if constexpr (M::traits.edges_are_straight) {
            return call.weight_is == name_of(WeightIs::weight) ? decide_in_power<power::Site>(call)
                                                               : decide_in_power<Site>(call);
        } else {
            return decide_additively(call, predicates_in(each));
        }
    });
}

/// The sign and the stage to standard output, words about them to standard error.
void print(const Answer& answer, bool json) {
    DescriptorStream out(1, "standard output");
    const auto& [decision, tie, words] = answer;
    if (!json) {
        out << fmt::format("{} {}\n", decision.sign, name_of(decision.stage));
        out.flush();
        for (const std::string& line : words) std::fprintf(stderr, "%s\n", line.c_str());
        return;
    }
    out << fmt::format("{{\"sign\": {}, \"stage\": \"{}\"", decision.sign, name_of(decision.stage));
    if (tie) {
        out << fmt::format(", \"tie\": {{\"last\": \"{}\", \"conflict\": {}}}", tie->last,
                           tie->conflict);
    }
    out << "}\n";
    out.flush();
}

}  // namespace

void add_sign(CLI::App& tool) {
    auto call = std::make_shared<SignCall>();
    CLI::App* command = tool.add_subcommand(
        "sign", "Prints the exact sign of a predicate, and the stage that decided it");
    command
        ->add_option("PREDICATE", call->predicate,
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
                     "           Manhattan metric of a cube or an octahedron")
        ->required()
        ->transform(one_of({"ccw", "in_circle", "in_sphere"}))
        ->type_name("");
    command
        ->add_option("NUMBER", call->numbers,
                     "After --: x y of each point for ccw, in space x y z;\n"
                     "x y r of each site for in_circle, x y z r for\nin_sphere")
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
    command->footer(
        "Prints the sign and the stage; words about ties, hidden sites and stages behind\n"
        "the filter go to standard error.\n\n"
        "Examples:\n"
        "  signum sign ccw -- 0 0  1 0  0 1\n"
        "  signum sign in_circle --metric power -- 0 0 1  1 0 1  0 1 1  1 1 1\n"
        "  signum sign in_circle --metric supremum -- 0 0 0  4 1 0  1 4 0  2 2 0\n"
        "  signum sign ccw --dimension 3 -- 0 0 0  1 0 0  0 1 0  0 0 1\n"
        "  signum sign in_sphere --metric power -- 0 0 0 1  1 0 0 1  0 1 0 1  0 0 1 1  1 1 1 1\n"
        "  signum sign in_sphere -- 0 0 0 1  4 0 0 1  0 4 0 1  0 0 4 0.5  1 1 1 0\n"
        "  signum sign in_sphere --metric supremum -- 0 0 0 1  6 1 2 1  1 7 3 1  2 3 8 1  4 4 4 0");
    command->callback([call] { print(decide(*call), call->json); });
}

}  // namespace signum::cli
