// The exact sign of a sum against GMP integers, in every environment; its steps and its memory.

#include "../../exact/sign_of_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include "../thoroughness.hpp"
#include "exact_reference.hpp"

namespace {
std::size_t allocations = 0;
}

// Counts every allocation of the program. Not inlined: the compiler would see malloc and delete
// meet.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

using signum::exact::SumTrace;
using signum::exact::trace_sign_of_sum;
using signum::reference::finest;
using signum::reference::Hostile;
using signum::reference::in_environment;
using signum::reference::Random;

using Terms = std::vector<double>;

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
const int share = signum::is_fast ? 1 : 10;  // of the trials one in so many

/// Sums in GMP integers, with memory that is used again and again.
class Reference {
 public:
    int sign(const Terms& terms) {
        sum_ = 0;
        for (const double value : terms) add(value);
        return sgn(sum_);
    }
    /// Appends doubles that make the sum 0.
    void complete(Terms& terms) {
        sign(terms);
        while (sum_ != 0) {
            // The leading 53 bits, truncated: exact, and they leave less.
            const std::size_t bits = mpz_sizeinbase(sum_.get_mpz_t(), 2);
            const std::size_t dropped = bits > 53 ? bits - 53 : 0;
            mpz_tdiv_q_2exp(leading_.get_mpz_t(), sum_.get_mpz_t(), dropped);
            const double value = -std::ldexp(leading_.get_d(), static_cast<int>(dropped) - finest);
            if (!std::isfinite(value)) return;
            terms.push_back(value);
            add(value);
        }
    }

 private:
    void add(double value) {
        signum::reference::set_scaled(leading_, value, finest);
        sum_ += leading_;
    }

    mpz_class sum_;
    mpz_class leading_;
};

/// The proven bound on the number of steps.
std::size_t most_steps(std::size_t terms) {
    if (terms == 0) return 0;
    const auto k = static_cast<std::size_t>(64 - std::countl_zero(terms - 1));
    return terms - 1 + (2 * terms - 1) * k;
}

SumTrace trace_in(int mode, const Terms& terms) {
    return in_environment(mode, [&] { return trace_sign_of_sum(terms); });
}

/// What the corpus has shown.
struct Summary {
    std::size_t inputs = 0;
    std::size_t zeros = 0;
    double most_steps_per_term = 0.0;
};

class SignOfSum : public testing::Test {
 protected:
    /// Checks the sign in the default environment and in a hostile one, and the steps.
    void check(const Terms& terms) {
        const int expected = reference_.sign(terms);
        const int hostile = 1 + static_cast<int>(summary_.inputs % (Hostile::modes - 1));
        const SumTrace trace = trace_sign_of_sum(terms);
        const SumTrace other = trace_in(hostile, terms);
        if (trace.sign != expected || other.sign != expected || other.steps != trace.steps) {
            ADD_FAILURE() << "expected " << expected << ", got " << trace.sign << ", " << other.sign
                          << " in environment " << hostile << ": " << testing::PrintToString(terms);
        }
        if (trace.steps > most_steps(terms.size())) {
            ADD_FAILURE() << trace.steps << " steps: " << testing::PrintToString(terms);
        }
        ++summary_.inputs;
        summary_.zeros += static_cast<std::size_t>(expected == 0);
        if (!terms.empty()) {
            summary_.most_steps_per_term =
                std::max(summary_.most_steps_per_term,
                         static_cast<double>(trace.steps) / static_cast<double>(terms.size()));
        }
    }
    /// Also the same terms in another order, and with the least perturbations of the sum.
    void check_with_neighbours(Terms& terms) {
        std::shuffle(terms.begin(), terms.end(), random_.engine());
        check(terms);
        terms.push_back(random_.coin() ? least : -least);
        check(terms);
        terms.pop_back();
        if (terms.empty()) return;
        double& one =
            terms[static_cast<std::size_t>(random_.below(static_cast<int>(terms.size())))];
        const double before = one;
        one = std::nextafter(one, random_.coin() ? largest : -largest);
        check(terms);
        one = before;
    }
    void TearDown() override {
        EXPECT_LE(summary_.most_steps_per_term, 4.0);
        RecordProperty("inputs", static_cast<int>(summary_.inputs));
        RecordProperty("zeros", static_cast<int>(summary_.zeros));
        RecordProperty("most_steps_per_term", std::to_string(summary_.most_steps_per_term));
    }
    /// Mostly short, sometimes long.
    int length() {
        return random_.below(50) == 0 ? random_.between(50, 300) : random_.between(1, 14);
    }

    Random random_{20240607};
    Reference reference_;
    Summary summary_;
};

TEST_F(SignOfSum, OfNoTermAndOfZerosIsZero) {
    check({});
    check({0.0});
    check({-0.0, 0.0, -0.0});
    EXPECT_EQ(signum::sign_of_sum({}), 0);
    EXPECT_EQ(summary_.zeros, 3U);
}

TEST_F(SignOfSum, OfOneTermIsItsSign) {
    for (const double magnitude : {least, 0x1p-1022, 1.0, largest}) {
        const Terms positive{magnitude};
        const Terms negative{-magnitude};
        for (int mode = 0; mode < Hostile::modes; ++mode) {
            EXPECT_EQ(trace_in(mode, positive).sign, 1);
            EXPECT_EQ(trace_in(mode, negative).sign, -1);
        }
    }
}

TEST_F(SignOfSum, IsExactForAnyFiniteDoubles) {
    Terms terms;
    for (int trial = 0; trial < 100'000 / share; ++trial) {
        terms.clear();
        for (int i = length(); i > 0; --i) terms.push_back(random_.finite());
        check(terms);
    }
}

TEST_F(SignOfSum, IsExactForOppositePairsAndTheirNeighbours) {
    Terms terms;
    for (int trial = 0; trial < 70'000 / share; ++trial) {
        terms.clear();
        for (int i = length(); i > 0; --i) {
            terms.push_back(random_.finite());
            terms.push_back(-terms.back());
        }
        check_with_neighbours(terms);
    }
    EXPECT_GT(summary_.zeros, 70'000U / share);
}

TEST_F(SignOfSum, IsExactForEqualTermsAndTheirMultiples) {
    Terms terms;
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        const double x = random_.in_binades(-1050, 1000);
        const int copies = length();
        terms.assign(static_cast<std::size_t>(copies), x);
        reference_.complete(terms);
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForSumsCompletedToZero) {
    // Random numbers within some binades of each other, completed by what cancels them exactly.
    Terms terms;
    for (int trial = 0; trial < 70'000 / share; ++trial) {
        terms.clear();
        const int spread = 1 << random_.between(0, 8);
        const int low = random_.between(-1074, 1020 - spread);
        for (int i = length(); i > 0; --i) terms.push_back(random_.in_binades(low, low + spread));
        reference_.complete(terms);
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForPowersOfTwoThatTelescope) {
    // 2^k - 2^(k-1) - ... - 2^l - 2^l = 0, in steps of one binade or several.
    Terms terms;
    for (int trial = 0; trial < 30'000 / share; ++trial) {
        terms.clear();
        const int low = random_.between(-1074, 1020);
        const int high = std::min(1023, low + random_.between(0, 30));
        const double sign = random_.coin() ? 1.0 : -1.0;
        terms.push_back(sign * std::ldexp(1.0, high));
        for (int k = high - 1; k >= low; --k) terms.push_back(-sign * std::ldexp(1.0, k));
        terms.push_back(-sign * std::ldexp(1.0, low));
        check_with_neighbours(terms);
    }
    // The whole range of doubles.
    terms = {0x1p1023};
    for (int k = 1022; k >= -1074; --k) terms.push_back(-std::ldexp(1.0, k));
    terms.push_back(-least);
    check_with_neighbours(terms);
    EXPECT_EQ(trace_sign_of_sum(terms).sign, 0);
}

TEST_F(SignOfSum, IsExactAtTheVergeOfTheStoppingRule) {
    // n·2^F against n numbers of the binade below 2^F, and a whisker beside.
    Terms terms;
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        terms.clear();
        const int n = length();
        const int f = random_.between(-1073, 1010);
        const double top = std::ldexp(1.0, f);
        terms.push_back(n * top);
        for (int i = 0; i < n; ++i) {
            double b = std::nextafter(top, 0.0);
            if (random_.below(4) == 0) b = top * random_.significand() / 2.0;
            if (random_.below(8) == 0) b = top;
            terms.push_back(-b);
        }
        check_with_neighbours(terms);
        reference_.complete(terms);
        check(terms);
    }
}

TEST_F(SignOfSum, IsExactBesideTheLargestDouble) {
    Terms terms;
    for (int trial = 0; trial < 40'000 / share; ++trial) {
        terms.clear();
        for (int i = length(); i > 0; --i) {
            const double x = random_.below(3) == 0 ? largest : random_.in_binades(1021, 1023);
            terms.push_back(x);
            terms.push_back(random_.coin() ? -x : -x / 2.0);
            if (terms.back() != -x) terms.push_back(-x / 2.0);
        }
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForDenormals) {
    Terms terms;
    for (int trial = 0; trial < 40'000 / share; ++trial) {
        terms.clear();
        for (int i = length(); i > 0; --i) terms.push_back(random_.in_binades(-1074, -1020));
        check(terms);
        reference_.complete(terms);
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForDeterminantsOfNeighbouringProducts) {
    // a·d - b·c with c/a nearly d/b, each product as its two terms; several of them.
    Terms terms;
    const auto add_product = [&terms](double a, double b) {
        const double high = a * b;
        terms.push_back(high);
        terms.push_back(std::fma(a, b, -high));
    };
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        terms.clear();
        for (int i = random_.between(1, 6); i > 0; --i) {
            const double a = random_.in_binades(-5, 5);
            const double b = random_.coin() ? a : random_.in_binades(-5, 5);
            const double k = random_.coin() ? std::ldexp(1.0, random_.between(-9, 9)) : 3.0;
            add_product(a, random_.coin() ? b * k : std::nextafter(b * k, 0.0));
            add_product(-b, a * k);
        }
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForNumbersThatLoseOneBitAStep) {
    // u - b is barely shorter than b if the bits of b alternate.
    Terms terms;
    for (int trial = 0; trial < 60'000 / share; ++trial) {
        terms.clear();
        for (int i = length(); i > 0; --i) {
            const double b = random_.coin() ? 0x1.5555555555555p0 : 0x1.aaaaaaaaaaaaap0;
            const double x = std::ldexp(b, random_.between(-4, 4));
            terms.push_back(random_.coin() ? x : -x);
        }
        reference_.complete(terms);
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, IsExactForThousandsOfTerms) {
    Terms terms;
    for (int trial = 0; trial < 60 / share; ++trial) {
        terms.clear();
        const int spread = trial % 3 == 0 ? 2000 : trial % 3 == 1 ? 100 : 2;
        const int low = trial % 3 == 0 ? -1000 : random_.between(-1074, 800);
        for (int i = random_.between(1000, 5000); i > 0; --i)
            terms.push_back(random_.in_binades(low, low + spread));
        check(terms);
        reference_.complete(terms);
        check_with_neighbours(terms);
    }
}

TEST_F(SignOfSum, DoesNotAllocateUpTo512Terms) {
    Terms terms;
    for (const int length : {1, 8, 63, 64, 512}) {
        terms.clear();
        while (static_cast<int>(terms.size()) < length) terms.push_back(random_.in_binades(-9, 9));
        const std::size_t before = allocations;
        const int sign = signum::sign_of_sum(terms);
        EXPECT_EQ(allocations, before);
        EXPECT_EQ(sign, reference_.sign(terms));
    }
}

TEST_F(SignOfSum, AllocatesOnceAbove512Terms) {
    Terms terms(5000, 1.0);
    terms.resize(10'000, -1.0);
    const std::size_t before = allocations;
    const int sign = signum::sign_of_sum(terms);
    EXPECT_LE(allocations, before + 1);
    EXPECT_EQ(sign, 0);
}

}  // namespace
