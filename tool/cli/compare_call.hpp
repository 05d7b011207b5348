#pragma once
/// A call of signum compare as it was typed, and the words that it answers with.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "outputs.hpp"
#include "sites_call.hpp"

namespace signum::cli {

/// SitesCall::arithmetic is the one that is judged.
struct CompareCall : SitesCall, OutputsCall {
    std::string against = "exact";
    double seconds = 1.0;
    bool json = false;
};

/// How many edges (in space cells) of a tessellation there are, and how they were judged.
struct Counts {
    std::int64_t all = 0;
    std::size_t wrong = 0;
    std::size_t different = 0;

    [[nodiscard]] double percent(std::size_t count) const {
        return all == 0 ? 0.0 : 100.0 * static_cast<double>(count) / static_cast<double>(all);
    }
};

/// Whether sites need exactness, in one sentence, where the structure did not break. `kind` is edge
/// or cell; `near` says how near the sites are to ties, with its comma or semicolon.
std::string answer_by(const Counts& counts, std::string_view arithmetic, std::string_view kind,
                      std::string_view near);
/// The same where it did.
std::string answer_of_broken(std::string_view arithmetic, std::string_view near);

/// For JSON; words without quotation marks of their own.
inline std::string quoted_or_null(const std::string& words) {
    return words.empty() ? "null" : fmt::format("\"{}\"", words);
}

}  // namespace signum::cli
