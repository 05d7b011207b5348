#include <signum/predicates/euclidean/hidden.hpp>

#include <signum/predicates/euclidean/cold_ladder.hpp>
#include <signum/predicates/euclidean/filter.hpp>

namespace signum::euclidean {
namespace {

[[nodiscard]] filters::Verdict filtered(const Site& i, const Site& q) noexcept {
    if (!filters::environment_is_default()) [[unlikely]]
        return filters::Verdict::uncertain();
    return filter::hides(i, q);
}

}  // namespace

Decision hides_decision(const Site& i, const Site& q) noexcept {
    return hides_perturbed_decision(i, q, true);
}

Decision hides_perturbed_decision(const Site& i, const Site& q, bool i_precedes_q) noexcept {
    const auto question = [i_precedes_q](const auto& d) {
        return hides(d[0], d[1], i_precedes_q) ? 1 : -1;
    };
    return decide(filtered, question, i, q);
}

}  // namespace signum::euclidean
