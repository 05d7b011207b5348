#pragma once
/// What the diagram of one metric has of its own: the curves of its edges, where these end beyond
/// the doubles, and who may share one. Each metric specializes the three templates in sources of
/// its own. For sources only.

#include <optional>
#include <utility>

#include "../exact/floating_environment.hpp"
#include "contacts.hpp"
#include "curve.hpp"
#include "far_end.hpp"

namespace signum {

/// What bisector() is asked for.
struct PairOfSites {
    const NumberedSite& first;
    const NumberedSite& second;
    Site a;  ///< the first, divided by 2^exponent
    Site b;  ///< the second, likewise
    WeightIs weight_is;
    int exponent;
    Point focus;
};

/// Answers bisector().
template <class Metric>
[[nodiscard]] std::optional<Curve> bisector_in(const PairOfSites& pair);

/// Answers far_end().
template <class Metric>
[[nodiscard]] Sign far_end_in(WeightIs weight_is, const Site& a, const Site& b, const Site& apex,
                              EndOfEdge end);

/// Answers contacts_in().
template <class Metric>
[[nodiscard]] Contacts contacts_in(const Canonical& canonical);

/// Contacts that are told in IEEE 754's environment, whatever that of who asks.
[[nodiscard]] inline Contacts in_any_environment(Contacts contacts) {
    return [contacts = std::move(contacts)](Index i, Index j) {
        const exact::IeeeEnvironment environment;
        return contacts(i, j);
    };
}

}  // namespace signum
