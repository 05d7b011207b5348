#pragma once
/// Random numbers that are the same on every machine.

#include <cstdint>
#include <random>

namespace signum {

/// Uniform doubles from [0, 1), multiples of 2^-53: the upper bits of the generator.
class Uniform {
 public:
    explicit Uniform(std::uint64_t seed) : bits_(seed) {}
    double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
    std::mt19937_64 bits_;
};

}  // namespace signum
