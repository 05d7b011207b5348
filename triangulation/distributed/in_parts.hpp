#pragma once
/// A tessellation from parts that are settled one after the other, or by several threads, in one
/// process: how many is the caller's choice, and nothing depends on it. For tests, and for who has
/// more sites than fit.

#include <cstddef>
#include <span>
#include <vector>

#include "../arrays.hpp"
#include "exchange.hpp"
#include "part.hpp"
#include "site_store.hpp"

namespace signum::distributed {

/// Parts whose sites can all be looked at.
class SharedExchange final : public Exchange {
 public:
    /// Nothing is copied.
    explicit SharedExchange(std::span<const SiteStore> stores) : stores_(stores) {}
    [[nodiscard]] std::vector<Answers> ask(std::vector<Questions> questions) override;
    [[nodiscard]] bool is_for_any(bool own) override { return own; }

 private:
    std::span<const SiteStore> stores_;
};

/// What the whole is put together from (Part), in no order, each face once.
struct WholeParts {
    std::vector<WholeFace> faces;
    std::vector<Adjacency> adjacencies;
    std::vector<WholeHidden> hidden;
    Part::Told told;
};

/// In so many parts. Throws NoStructure, std::invalid_argument and Stopped.
[[nodiscard]] WholeParts settle_in_parts(std::span<const Placed> sites, Metric metric,
                                         WeightIs weight_is, std::size_t parts);

/// The arrays of sites that are numbered from 0.
[[nodiscard]] TessellationArrays arrays_of(const WholeParts& whole, std::int64_t sites,
                                           Metric metric, WeightIs weight_is);

}  // namespace signum::distributed
