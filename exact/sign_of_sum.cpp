#include "sign_of_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>

#include "../core/contract.hpp"
#include "../core/error_free.hpp"
#include "floating_environment.hpp"

namespace signum {
namespace exact {
namespace {

constexpr std::uint64_t hidden_bit = std::uint64_t{1} << 52;
constexpr std::uint64_t fraction = hidden_bit - 1;

/// Binades are numbered from that of the least denormal: 2^(binade-1074) <= x < 2^(binade-1073).
constexpr int binades = 2098;

/// What is not finite, against the contract, gets a number as well and no memory is harmed.
[[nodiscard]] int binade_of(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7FF);
    return biased != 0 ? biased + 51 : 63 - std::countl_zero(bits);
}

/// The least power of two that is at least x. Precondition: it is a double.
[[nodiscard]] double power_from(double x) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>(bits >= hidden_bit ? (bits + fraction) & ~fraction
                                                    : std::bit_ceil(bits));
}

/// Whether a >= n·2^F, where gap = E - F >= 0 and n > 0: compares floor(a / 2^F) with n.
[[nodiscard]] bool outweighs(double a, int gap, std::size_t n) noexcept {
    if (gap > 53) return true;  // a / 2^F >= 2^53
    const auto bits = std::bit_cast<std::uint64_t>(a);
    const std::uint64_t significand =
        bits >= hidden_bit ? (bits & fraction) | hidden_bit : bits << (std::countl_zero(bits) - 11);
    return significand >> (53 - gap) >= n;
}

struct Term {
    double magnitude;
    std::uint32_t next;  // in its binade
};

/// The terms of one sign, chained by binade: two levels of bits tell which binades have a term, and
/// what no bit vouches for is never read, so that nothing needs to be cleared beforehand.
class Side {
 public:
    explicit Side(Term* terms) noexcept : terms_(terms) {}

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

    /// Precondition: the magnitude of the term is set.
    void push(std::uint32_t term) noexcept {
        const int binade = binade_of(terms_[term].magnitude);
        const int word = binade >> 6;
        const std::uint64_t others = (words_ & bit(word)) == 0 ? 0 : binades_[word];
        terms_[term].next = (others & bit(binade)) == 0 ? none : first_[binade];
        first_[binade] = term;
        binades_[word] = others | bit(binade);
        words_ |= bit(word);
        ++size_;
    }
    /// The highest binade. Precondition: not empty.
    [[nodiscard]] int top() const noexcept {
        const int word = 63 - std::countl_zero(words_);
        return (word << 6) + 63 - std::countl_zero(binades_[word]);
    }
    /// A term of the binade. Precondition: it has one.
    [[nodiscard]] std::uint32_t first(int binade) const noexcept { return first_[binade]; }
    /// Removes it.
    void pop(int binade) noexcept {
        first_[binade] = terms_[first_[binade]].next;
        const int word = binade >> 6;
        binades_[word] ^= bit(binade, first_[binade] == none);
        words_ ^= bit(word, binades_[word] == 0);
        --size_;
    }

 private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    static constexpr int words = binades / 64 + 1;
    static std::uint64_t bit(int index, bool value = true) noexcept {
        return std::uint64_t{value} << (index & 63);
    }

    Term* terms_;
    std::size_t size_ = 0;
    std::uint64_t words_ = 0;
    std::uint64_t binades_[words];
    std::uint32_t first_[64 * words];
};

/// Both sides are empty. Out of line, for the compiler cannot know that no binade is read unset.
[[gnu::noinline]] SumTrace essa(std::span<const double> input, Term* terms, Side& positive,
                                Side& negative) noexcept {
    const auto keep = [terms](Side& side, std::uint32_t term, double magnitude) {
        if (magnitude == 0.0) return;
        terms[term].magnitude = magnitude;
        side.push(term);
    };
    std::uint32_t count = 0;
    for (const double value : input) {
        SIGNUM_EXPECTS(std::isfinite(value));
        keep(value > 0.0 ? positive : negative, count++, std::fabs(value));
    }

    for (std::size_t steps = 0;; ++steps) {
        if (negative.empty()) return {positive.empty() ? 0 : +1, steps};
        if (positive.empty()) return {-1, steps};
        const int e = positive.top();
        const int f = negative.top();
        Side& larger = e >= f ? positive : negative;
        Side& smaller = e >= f ? negative : positive;
        const std::uint32_t i = larger.first(std::max(e, f));
        const std::uint32_t j = smaller.first(std::min(e, f));
        const double a = terms[i].magnitude;
        const double b = terms[j].magnitude;
        if (outweighs(a, std::abs(e - f), smaller.size())) return {e > f ? +1 : -1, steps};
        larger.pop(std::max(e, f));
        smaller.pop(std::min(e, f));
        const TwoTerms difference = quick_two_sum(a, -b);
        if (difference.low == 0.0) {
            keep(difference.high > 0.0 ? larger : smaller, i, std::fabs(difference.high));
        } else {
            const double u = power_from(b);
            keep(larger, i, a - u);
            keep(larger, j, u - b);
        }
    }
}

SumTrace with_memory(std::span<const double> input) noexcept {
    constexpr std::size_t on_stack = 512;
    Term few[on_stack];
    std::unique_ptr<Term[]> many;
    if (input.size() > on_stack) many = std::make_unique_for_overwrite<Term[]>(input.size());
    Term* terms = many ? many.get() : few;
    Side positive(terms);
    Side negative(terms);
    return essa(input, terms, positive, negative);
}

}  // namespace

SumTrace trace_sign_of_sum(std::span<const double> terms) noexcept {
    SIGNUM_EXPECTS(terms.size() <= std::numeric_limits<std::uint32_t>::max());
    return in_ieee_environment(with_memory, terms);
}

}  // namespace exact

Sign sign_of_sum(std::span<const double> terms) noexcept {
    return exact::trace_sign_of_sum(terms).sign;
}

}  // namespace signum
