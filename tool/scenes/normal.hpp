#pragma once
/// Normal deviates that are the same on every machine: no logarithm and no cosine, which differ
/// from library to library, but comparisons of uniform ones.
///
/// Source: C. F. F. Karney, Sampling exactly from the normal distribution, ACM Trans. Math. Softw.
/// 42:3 (2016), algorithm N, with deviates of 53 bits.

#include "../generate/uniform.hpp"

namespace signum {

/// With mean 0 and variance 1.
class Normal {
 public:
    explicit Normal(std::uint64_t seed) : uniform_(seed) {}

    double operator()() {
        for (;;) {
            int k = 0;
            while (happens(0.5)) ++k;
            if (!all_happen(0.5, k * (k - 1))) continue;
            const double x = uniform_();
            if (!all_happen(x * (2.0 * k + x) / (2.0 * k + 2.0), k + 1)) continue;
            const double y = k + x;
            return uniform_() < 0.5 ? y : -y;
        }
    }

 private:
    /// With probability exp(-p), 0 <= p <= 1 (von Neumann): whether a falling run has even length.
    bool happens(double p) {
        bool is_even = true;
        for (double last = p;;) {
            const double next = uniform_();
            if (next >= last) return is_even;
            last = next;
            is_even = !is_even;
        }
    }
    bool all_happen(double p, int times) {
        for (int i = 0; i < times; ++i)
            if (!happens(p)) return false;
        return true;
    }

    Uniform uniform_;
};

}  // namespace signum
