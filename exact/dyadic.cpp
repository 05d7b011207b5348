#include "dyadic.hpp"

namespace signum::exact {

Integer Dyadic::significand() const {
    if (large_) return *large_;
    Integer result = static_cast<std::int64_t>(small_ >> 64);
    result <<= 64;
    result += static_cast<std::uint64_t>(small_);
    return result;
}

Dyadic Dyadic::sum_of_large(const Dyadic& coarse, const Dyadic& fine) {
    Integer sum = coarse.significand();
    sum <<= coarse.exponent_ - fine.exponent_;
    sum += fine.significand();
    return {std::move(sum), fine.exponent_};
}

Dyadic Dyadic::product_of_large(const Dyadic& a, const Dyadic& b) {
    return {Integer(a.significand() * b.significand()), a.exponent_ + b.exponent_};
}

Rational to_rational(const Dyadic& number) {
    const Integer significand = number.significand();
    return number.exponent() < 0 ? Rational(significand, Integer(1) << -number.exponent())
                                 : Rational(Integer(significand << number.exponent()));
}

}  // namespace signum::exact
