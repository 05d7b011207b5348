#pragma once
/// A call of signum sign as it was typed, and what is printed.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/index.hpp"
#include "../../filters/tally.hpp"

namespace signum::cli {

struct SignCall {
    std::string predicate;
    std::string metric;
    std::string weight_is;
    std::optional<int> dimension;
    std::optional<int> sphere;  ///< which of several, from 0
    bool json = false;
    std::vector<std::string> numbers;
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
std::vector<double> numbers_of(const SignCall& call, std::size_t needed, std::string_view meaning);

/// Adds who decided, where it was not the filter.
void explain_stage(Answer& answer);

/// Adds what the tie rule makes of a 0: of the sites called `names`, q among them, that called
/// `last` is the last one. `what` is what q touches, "circle of i, j and k"; `order` the rule's.
void explain_tie(Answer& answer, std::string_view what, std::string_view order, char last,
                 bool conflict);

/// Whether the call is one of space: in_sphere, and ccw with --dimension 3 or twelve numbers.
/// Throws CallError where predicate and dimension do not fit.
bool is_in_space(const SignCall& call);
Answer decide_in_space(const SignCall& call);

}  // namespace signum::cli
