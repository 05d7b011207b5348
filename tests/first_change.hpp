#pragma once
/// The first root of a polynomial at which its sign changes, by way of all roots.

#include <optional>

#include "../roots/polynomial.hpp"

namespace signum::roots {

/// The least root greater than t, a double or a root, of odd multiplicity.
template <class Time>
[[nodiscard]] std::optional<Root> first_change(const Polynomial& p, const Time& t,
                                               Tally* tally = nullptr) {
    std::optional<Root> root = p.first_root(t, tally);
    while (root && !root->changes_sign()) root = p.first_root(RootOf{p, *root}, tally);
    return root;
}

}  // namespace signum::roots
