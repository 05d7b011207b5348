#pragma once
/// From what a filter computes to the proof that its bound covers the error of its value.

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "../../../filters/bounds.hpp"
#include "script.hpp"

namespace signum::proofs {

using Compared = filters::Compared<Expression>;

/// That a polynomial, which covers the magnitude of a value, is at most so many times another one,
/// which is covered by the bound without what that adds for underflow.
struct Lemma {
    std::function<Expression()> lesser;
    std::function<Expression()> greater;
    long double times;
    void (*prove)(Scripts& scripts);
};

/// What one filter compares, and what is known of its numbers.
///
/// Sizes are products of some variables, which stand for numbers above 0. Where there is a window
/// each of them is at least 2^-window, and a bound's size, in which each sum counts its terms, is
/// at most `terms` to the power of the degree times the bound.
struct Filter {
    const char* name;
    std::function<Compared()> evaluate;
    /// The size of an atom.
    Monomial (*size_of)(const std::string& atom);
    /// Where atoms are bounded by the greatest of a kind.
    std::string (*kind_of)(const std::string& atom) = nullptr;
    /// Where nothing underflows.
    bool in_range = false;
    int window = 0;
    int terms = 0;
    /// Where the magnitude of the value is not covered by the bound monomial by monomial.
    std::optional<Lemma> lemma{};
};

struct Margin {
    double roundings;
    double spare;
};

/// With t t in place of each p q.
[[nodiscard]] inline Polynomial without_pairs(const Polynomial& all) {
    Polynomial result;
    for (const auto& [with_pairs, coefficient] : all) {
        Monomial monomial = with_pairs;
        const auto replace = [&monomial](int variable) {
            const auto place = std::find(monomial.begin(), monomial.end(), variable);
            if (place == monomial.end()) return false;
            *place = 't';
            return true;
        };
        while (replace('p') && replace('q')) continue;
        std::sort(monomial.begin(), monomial.end());
        result[monomial] += coefficient;
    }
    return result;
}

/// The monomials of the highest degree. Degrees are those of sizes.
[[nodiscard]] inline Polynomial main_part(const Polynomial& all,
                                          const std::function<std::size_t(int)>& degree_of) {
    const auto degree = [&degree_of](const Monomial& monomial) {
        std::size_t sum = 0;
        for (const int variable : monomial) sum += degree_of(variable);
        return sum;
    };
    std::size_t highest = 0;
    for (const auto& [monomial, coefficient] : all) highest = std::max(highest, degree(monomial));
    Polynomial result;
    for (const auto& [monomial, coefficient] : all)
        if (degree(monomial) == highest) result[monomial] = coefficient;
    return result;
}

/// Without a window: what the bound adds for underflow, in sizes; of one size the least.
[[nodiscard]] inline Polynomial spare_for_underflow(const Polynomial& bound,
                                                    const Polynomial& main_part,
                                                    const Notes& atoms) {
    Polynomial result;
    for (const auto& [monomial, coefficient] : bound) {
        if (main_part.contains(monomial)) continue;
        Monomial product;
        for (const int atom : monomial) {
            const Monomial& size = atoms.sizes.at(atom);
            product.insert(product.end(), size.begin(), size.end());
        }
        std::sort(product.begin(), product.end());
        const Monomial size = without_pairs({{product, 1.0L}}).begin()->first;
        const auto [place, is_first] = result.try_emplace(size, coefficient);
        if (!is_first) place->second = std::min(place->second, coefficient);
    }
    return result;
}

/// Weights and radii of the power metric may be of any size.
[[nodiscard]] inline bool is_outside_window(int variable) {
    return variable == 'r' || variable == 'w';
}

/// In a window: how many times the bound all underflow is, of which each term is multiplied by
/// sizes, which are at least 2^-window, until it is one of the bound's.
[[nodiscard]] inline long double underflow_in_window(const Filter& filter,
                                                     const Polynomial& underflow,
                                                     const Polynomial& bound) {
    Polynomial sum;
    for (const auto& [monomial, coefficient] : underflow) {
        const Monomial* covers = nullptr;
        for (const auto& [product, times] : bound) {
            Monomial missing;
            std::set_difference(product.begin(), product.end(), monomial.begin(), monomial.end(),
                                std::back_inserter(missing));
            if (product.size() == monomial.size() + missing.size() &&
                std::none_of(missing.begin(), missing.end(), is_outside_window))
                covers = &product;
        }
        if (covers == nullptr) throw std::logic_error("a term of underflow is not covered");
        const std::size_t missing = covers->size() - monomial.size();
        sum[*covers] +=
            coefficient * std::ldexp(1.0L, filter.window * static_cast<int>(missing) - 1074);
    }
    const std::size_t degree = bound.begin()->first.size();
    return share(sum, bound) *
           std::pow(static_cast<long double>(filter.terms), static_cast<long double>(degree));
}

/// What a formula comes to, each step of it proved; with its atoms.
template <class Evaluate>
[[nodiscard]] auto evaluated(Scripts& scripts, Notes& atoms, const Evaluate& evaluate) {
    notes = &atoms;
    const auto result = evaluate();
    notes = nullptr;
    for (const Step& step : atoms.steps) scripts.write(step);
    return result;
}

inline Margin prove(Scripts& scripts, const Filter& filter) {
    Notes of_this;
    of_this.size_of_atom = filter.size_of;
    of_this.kind_of_atom = filter.kind_of;
    const auto [value, bound] = evaluated(scripts, of_this, filter.evaluate);

    const std::string name = filter.name;
    const Polynomial main_bound = main_part(
        bound.magnitude(), [&of_this](int atom) { return of_this.sizes.at(atom).size(); });
    long double times = 0;
    if (filter.lemma) {
        filter.lemma->prove(scripts);
        const Polynomial lesser = evaluated(scripts, of_this, filter.lemma->lesser).magnitude();
        const Polynomial greater = evaluated(scripts, of_this, filter.lemma->greater).magnitude();
        const long double of_lesser = share(value.magnitude(), lesser);
        const long double of_greater = share(greater, main_bound);
        if (of_lesser > 0 && of_greater > 0) times = of_lesser * filter.lemma->times * of_greater;
    } else {
        times = share(value.magnitude(), main_bound);
    }
    if (times <= 0) throw std::logic_error(name + ": the bound lacks a term");

    // The bound as it is computed is at least (1 - error) times what it means.
    const Polynomial underflow = without_pairs(value.underflow() + bound.underflow());
    long double of_underflow = 0;
    if (filter.in_range) {
    } else if (filter.window != 0) {
        of_underflow = underflow_in_window(
            filter, underflow, main_part(bound.size(), [](int) { return std::size_t{1}; }));
    } else {
        const Polynomial spares = spare_for_underflow(bound.magnitude(), main_bound, of_this);
        for (const auto& [monomial, coefficient] : underflow) {
            const auto spare = spares.find(monomial);
            if (spare == spares.end())
                throw std::logic_error(name + ": a term of underflow is not covered");
            scripts.write(
                name + "-underflow-" + std::to_string(monomial.size()),
                "What underflows is less than what the bound adds for it.",
                {written_upwards(coefficient) + " * 1b-1074 - (1 - " + written(bound.error()) +
                 ") * " + written_upwards(spare->second) + " <= 0"});
        }
    }
    scripts.write(name, "The error, in multiples of the bound, is less than the bound as computed.",
                  {written(value.error()) + " * " + written_upwards(times) + " + " +
                   written_upwards(of_underflow) + " - (1 - " + written(bound.error()) + ") <= 0"});

    const long double error = unit * static_cast<long double>(value.error());
    return {static_cast<double>(error * 0x1p52L),
            static_cast<double>((1 - unit * static_cast<long double>(bound.error())) /
                                (error * times + of_underflow))};
}

}  // namespace signum::proofs
