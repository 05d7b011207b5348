/// signum sign: one predicate on numbers from the command line.

#include <cstdio>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include <signum/io/number.hpp>
#include <signum/io/output_file.hpp>
#include <signum/predicates/ccw.hpp>
#include <signum/predicates/power.hpp>

#include "commands.hpp"

namespace signum::cli {
namespace {

/// The call as it was typed.
struct Call {
    std::string predicate;
    std::string metric;
    std::string weight_is;
    bool json = false;
    std::vector<std::string> numbers;
};

std::vector<double> numbers_of(const Call& call, std::size_t needed, std::string_view meaning) {
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

Decision decide_ccw(const Call& call) {
    const std::vector<double> v = numbers_of(call, 6, "x y of each of three points");
    return ccw_decision({v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]});
}

Decision decide_in_circle(const Call& call) {
    const std::vector<double> v =
        numbers_of(call, 12, "x y r of each of the sites i, j, k and of the query");
    const Sign turn = ccw_decision({v[0], v[1]}, {v[3], v[4]}, {v[6], v[7]}).sign;
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
    const auto decide = [&]<typename S>(S) {
        const auto site = [&](std::size_t i) { return S{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
        return power::in_circle_decision(site(0), site(1), site(2), site(3));
    };
    return call.weight_is == "weight" ? decide(power::Site{}) : decide(Site{});
}

void print(const Decision& decision, bool json) {
    DescriptorStream out(1, "standard output");
    if (json) {
        out << fmt::format("{{\"sign\": {}, \"stage\": \"{}\"}}\n", decision.sign,
                           name_of(decision.stage));
    } else {
        out << fmt::format("{} {}\n", decision.sign, name_of(decision.stage));
    }
    out.flush();
}

}  // namespace

void add_sign(CLI::App& tool) {
    auto call = std::make_shared<Call>();
    CLI::App* command = tool.add_subcommand(
        "sign", "Prints the exact sign of a predicate, and the stage that decided it");
    command
        ->add_option("PREDICATE", call->predicate,
                     "ccw        three points turn left (1), right (-1)\n"
                     "           or lie on a line (0)\n"
                     "in_circle  the last site is inside (1), outside (-1)\n"
                     "           or on (0) the circle that touches the\n"
                     "           others, which turn left")
        ->required()
        ->check(one_of({"ccw", "in_circle"}))
        ->type_name("");
    command
        ->add_option("NUMBER", call->numbers,
                     "After --: x y of each point for ccw, x y r of each\nsite for in_circle")
        ->type_name("");
    const CLI::Option* metric = add_metric(*command, call->metric);
    add_weight_is(*command, call->weight_is);
    command->add_flag("--json", call->json, "Prints {\"sign\": S, \"stage\": NAME}");
    command->footer(
        "Examples:\n"
        "  signum sign ccw -- 0 0  1 0  0 1\n"
        "  signum sign in_circle --metric power -- 0 0 1  1 0 1  0 1 1  1 1 1");
    command->callback([call, metric] {
        // ccw is the same in every metric.
        if (call->predicate == "in_circle") require_power(call->metric, *metric);
        print(call->predicate == "ccw" ? decide_ccw(*call) : decide_in_circle(*call), call->json);
    });
}

}  // namespace signum::cli
