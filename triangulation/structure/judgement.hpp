#pragma once
/// How a check of a tessellation comes to its judgement.

#include <cstddef>
#include <string>

#include "../../core/index.hpp"
#include "../validate.hpp"
#include "watch.hpp"

namespace signum::triangulation {

[[nodiscard]] inline std::size_t at(Index i) noexcept {
    return static_cast<std::size_t>(i);
}

[[nodiscard]] inline std::string name(Index vertex) {
    return vertex == infinite ? "infinity" : "site " + std::to_string(vertex);
}

/// Why the arrays are no valid tessellation.
struct Invalid {
    std::string why;
};

/// What is wrong is thrown as Invalid; what is right but not the canonical choice is noted.
class Judgement {
 protected:
    /// `all`: how often advance() will be called.
    Judgement(const ValidationOptions& options, std::size_t all)
        : watch_(options.stop, options.progress, all) {}

    /// One more face, cell or hidden site is done.
    void advance() { watch_.at(++done_); }
    void note(const std::string& why) {
        if (not_canonical_.empty()) not_canonical_ = why;
    }
    [[nodiscard]] bool is_canonical() const noexcept { return not_canonical_.empty(); }

    /// The judgement of the checks that `all` makes.
    template <class Checks>
    [[nodiscard]] Validation judgement(Checks all) {
        Validation result;
        try {
            all();
            result.valid = true;
            result.canonical = is_canonical();
            result.message = not_canonical_;
        } catch (const Invalid& invalid) {
            result.message = invalid.why;
        }
        return result;
    }

 private:
    Watch watch_;
    std::size_t done_ = 0;
    std::string not_canonical_;
};

}  // namespace signum::triangulation
