#pragma once
/// The questions that an insertion asks, of sites by their places in its order.

#include <array>
#include <cstddef>
#include <span>

#include "../core/index.hpp"
#include "../core/sign.hpp"
#include "../predicates/space/ccw.hpp"
#include "../predicates/space/in_sphere.hpp"
#include "../predicates/space/ties.hpp"

namespace signum::spatial {

/// Exact, ties decided by the rule. `numbers`: those of the sites in the input, which the rule's
/// order ends with.
template <power::PowerSite3 S>
class ExactKernel {
 public:
    ExactKernel(std::span<const S> sites, std::span<const Index> numbers)
        : sites_(sites.data()), numbers_(numbers.data()) {}

    [[nodiscard]] Sign ccw(Index a, Index b, Index c, Index d) const noexcept {
        return ccw_decision(at(a), at(b), at(c), at(d)).sign;
    }
    /// Whether q conflicts with a cell that turns positively.
    [[nodiscard]] bool conflicts(const std::array<Index, 4>& cell, Index q) const noexcept {
        const Sign sign =
            power::in_sphere_decision(at(cell[0]), at(cell[1]), at(cell[2]), at(cell[3]), at(q))
                .sign;
        return sign != 0 ? sign > 0 : tie(cell, q) > 0;
    }
    [[nodiscard]] const S& at(Index v) const noexcept { return sites_[v]; }

 private:
    [[nodiscard, gnu::cold, gnu::noinline]] Sign tie(const std::array<Index, 4>& cell,
                                                     Index q) const noexcept {
        std::array<S, 5> sites;
        std::array<Index, 5> indices;
        for (std::size_t m = 0; m < 5; ++m) {
            const Index v = m < 4 ? cell[m] : q;
            sites[m] = at(v);
            indices[m] = numbers_[v];
        }
        return power::in_sphere_tie(sites, indices);
    }

    const S* sites_;
    const Index* numbers_;
};

}  // namespace signum::spatial
