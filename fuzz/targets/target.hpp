#pragma once
/// What a fuzzer feeds with bytes: a target is a promise of the library, and bytes for which it
/// does not hold end the program.

#include <cstdint>
#include <span>
#include <string_view>

namespace signum::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// One promise. `run` returns where it holds of the bytes.
struct Target {
    std::string_view name;  ///< that of its folder in fuzz/corpus
    void (*run)(Bytes bytes);
    /// Of a processor, beside 20 µs a byte: some ten times what it takes under a sanitizer.
    double seconds = 0.25;
};

[[nodiscard]] std::span<const Target> all_targets();
/// Ends the program where there is no such target.
[[nodiscard]] const Target& target_named(std::string_view name);

/// Runs the target on the bytes, and ends the program, too, where that takes longer than it may.
void run_in_time(const Target& target, Bytes bytes);

/// Ends the program with the sentence unless the condition holds.
void must(bool condition, std::string_view sentence);

}  // namespace signum::fuzz
