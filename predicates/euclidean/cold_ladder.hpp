#pragma once
/// The ladder of stages that all Euclidean predicates climb: the filter in the caller's
/// environment; where that is not the default one, the filter again in the default one; the exact
/// stages, which use no floating-point operation. Included by sources only.

#include <array>

#include <signum/exact/floating_environment.hpp>
#include <signum/filters/bounds.hpp>
#include <signum/filters/tally.hpp>
#include <signum/filters/verdict.hpp>
#include <signum/predicates/euclidean/cold_discs.hpp>

namespace signum::euclidean {

/// What stands behind the filter. `question` answers for the sites as exact discs.
template <class Filter, class Question, class... Operands>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_uncertain(Filter filter, Question question,
                                                                  const Operands&... operands) {
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, operands...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide_exactly(std::array{operands...}, question);
}

/// The sign and the stage that decided. The filter takes the sites one by one, the question as an
/// array of discs.
template <class Filter, class Question, class... Operands>
[[nodiscard, gnu::always_inline]] inline Decision decide(Filter filter, Question question,
                                                         const Operands&... operands) {
    const filters::Verdict verdict = filter(operands...);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return decide_uncertain(filter, question, operands...);
}

}  // namespace signum::euclidean
