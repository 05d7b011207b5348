#pragma once
/// Polynomials with coefficients above 0 in numbers above 0: magnitudes, and bounds on them.

#include <algorithm>
#include <map>
#include <vector>

namespace signum::proofs {

/// The variables of a product, in order, each as often as it is a factor.
using Monomial = std::vector<int>;
using Polynomial = std::map<Monomial, long double>;

[[nodiscard]] inline Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (const auto& [monomial, coefficient] : b) a[monomial] += coefficient;
    return a;
}

[[nodiscard]] inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial result;
    for (const auto& [of_a, times] : a)
        for (const auto& [of_b, factor] : b) {
            Monomial product;
            std::merge(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                       std::back_inserter(product));
            result[product] += times * factor;
        }
    return result;
}

[[nodiscard]] inline Polynomial operator*(long double factor, Polynomial a) {
    for (auto& [monomial, coefficient] : a) coefficient *= factor;
    return a;
}

/// The least k with a <= k b, monomial by monomial; below 0 where there is none.
[[nodiscard]] inline long double share(const Polynomial& a, const Polynomial& b) {
    long double most = 0;
    for (const auto& [monomial, coefficient] : a) {
        if (coefficient == 0) continue;
        const auto other = b.find(monomial);
        if (other == b.end() || other->second <= 0) return -1;
        most = std::max(most, coefficient / other->second);
    }
    return most;
}

}  // namespace signum::proofs
