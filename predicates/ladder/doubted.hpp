#pragma once
/// Numbers that may not know their sign, for formulas that ask for it. For sources only.

#include "../../core/sign.hpp"
#include "../../exact/sum.hpp"
#include "../../filters/bounded.hpp"
#include "../../filters/interval.hpp"

namespace signum::euclidean {

/// An interval, or a double-double or long double that carries a bound, that compares as a number
/// does. Where it cannot tell it says anything, and that the answer is in doubt.
template <class Number>
class Doubted : public exact::ComparedBySign<Doubted<Number>> {
 public:
    Doubted() = default;
    Doubted(double number, bool& doubt) noexcept : number_(exactly(number)), doubt_(&doubt) {}

    friend Doubted operator+(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ + b.number_, a.doubt_};
    }
    friend Doubted operator-(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ - b.number_, a.doubt_};
    }
    friend Doubted operator*(const Doubted& a, const Doubted& b) noexcept {
        return {a.number_ * b.number_, a.doubt_};
    }
    friend Doubted operator*(int a, const Doubted& b) noexcept {
        return {exactly(a) * b.number_, b.doubt_};
    }
    [[nodiscard]] Sign sign() const noexcept {
        const filters::Verdict verdict = sign_of_number(number_);
        *doubt_ |= !verdict.is_certain();
        return verdict.is_certain() ? verdict.sign() : 0;
    }

 private:
    Doubted(const Number& number, bool* doubt) noexcept : number_(number), doubt_(doubt) {}

    [[nodiscard]] static Number exactly(double number) noexcept {
        if constexpr (requires { Number::exactly(number); })
            return Number::exactly(number);
        else
            return Number(number);
    }
    template <class Any>
    [[nodiscard]] static filters::Verdict sign_of_number(const Any& number) noexcept {
        return number.sign();
    }
    [[nodiscard]] static filters::Verdict sign_of_number(const filters::Interval& number) noexcept {
        const Sign least = sign_of(number.low);
        return least == sign_of(number.high) ? filters::Verdict::certain(least)
                                             : filters::Verdict::uncertain();
    }

    Number number_ = exactly(0.0);
    bool* doubt_ = nullptr;
};

}  // namespace signum::euclidean
