#pragma once
/// How a check of a tessellation comes to its judgement.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

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

/// What is said of a site.
enum class Seen : std::uint8_t { nowhere, as_vertex, as_hidden };

/// Notes who is said to be hidden. Vertices have been noted.
inline void see_hidden(std::span<const Hidden> hidden, std::vector<Seen>& seen) {
    const auto n = static_cast<std::int64_t>(seen.size());
    for (const auto& [site, by] : hidden) {
        for (const Index each : {site, by})
            if (each < 0 || each >= n)
                throw Invalid{"hidden: there is no site " + std::to_string(each)};
        if (seen[at(site)] != Seen::nowhere)
            throw Invalid{name(site) + (seen[at(site)] == Seen::as_vertex
                                            ? " is both visible and hidden"
                                            : " is hidden twice")};
        seen[at(site)] = Seen::as_hidden;
    }
}
/// Every site is a vertex or hidden by one.
inline void check_seen(std::span<const Hidden> hidden, const std::vector<Seen>& seen) {
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i] == Seen::nowhere)
            throw Invalid{name(static_cast<Index>(i)) + " is neither visible nor hidden"};
    for (const auto& [site, by] : hidden)
        if (seen[at(by)] != Seen::as_vertex)
            throw Invalid{name(site) + " is hidden by " + name(by) + ", which is hidden itself"};
}

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
