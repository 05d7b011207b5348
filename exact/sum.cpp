#include "sum.hpp"

#include <span>
#include <utility>

#include "../core/error_free.hpp"
#include "expansion.hpp"
#include "sign_of_sum.hpp"

namespace signum::exact {

Sum::Sum(double number) {
    append(number);
}

void Sum::append(double term) {
    if (term != 0.0) terms_.push_back(term);
}

Sum operator+(Sum a, const Sum& b) {
    if (a.terms_.size() == 1 && b.terms_.size() == 1) {
        const TwoTerms sum = two_sum(a.terms_.front(), b.terms_.front());
        a.terms_.clear();
        a.append(sum.high);
        a.append(sum.low);
    } else {
        a.terms_.insert(a.terms_.end(), b.terms_.begin(), b.terms_.end());
    }
    return a;
}

Sum operator-(Sum a) {
    for (double& term : a.terms_) term = -term;
    return a;
}

Sum operator*(const Sum& a, const Sum& b) {
    if (2 * a.terms_.size() * b.terms_.size() > Sum::most_terms) {
        const Sum short_a = a.added_up();
        const Sum short_b = b.added_up();
        if (short_a.terms_.size() < a.terms_.size() || short_b.terms_.size() < b.terms_.size())
            return short_a * short_b;
    }
    Sum product;
    product.terms_.reserve(2 * a.terms_.size() * b.terms_.size());
    for (const double of_a : a.terms_)
        for (const double of_b : b.terms_) {
            const TwoTerms two = two_product(of_a, of_b);
            product.append(two.high);
            product.append(two.low);
        }
    return product;
}

Sign Sum::sign() const noexcept {
    return sign_of_sum(terms_);
}

/// The same number as an expansion.
Sum Sum::added_up() const {
    std::vector<double> sum;
    std::vector<double> next;
    for (const double& term : terms_) {
        next.resize(sum.size() + 1);
        const int size = terms::sum(sum, std::span(&term, 1), next.data());
        next.resize(static_cast<std::size_t>(size));
        std::swap(sum, next);
    }
    Sum result;
    result.terms_ = std::move(sum);
    return result;
}

}  // namespace signum::exact
