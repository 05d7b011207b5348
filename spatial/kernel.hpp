#pragma once
/// The questions that an insertion asks, of sites by their places in its order.

#include <array>
#include <cstddef>
#include <span>

#include "../core/index.hpp"
#include "../core/sign.hpp"
#include "../predicates/space/ties.hpp"
#include "lattice.hpp"
#include "view.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::spatial {

/// Exact, ties decided by the rule. `numbers`: those of the sites in the input, which the rule's
/// order ends with.
template <power::PowerSite3 S>
class ExactKernel : public View<S> {
 public:
    ExactKernel(std::span<const S> sites, std::span<const Index> numbers)
        : View<S>(sites.data()), numbers_(numbers.data()), lattice_(sites) {}

    /// The orientation of four sites.
    [[nodiscard]] Sign ccw(Index a, Index b, Index c, Index d) const noexcept {
        return ccw_decision(this->at(a), this->at(b), this->at(c), this->at(d)).sign;
    }
    /// That of the site that sees them and three others.
    [[nodiscard]] Sign side(Seen b, Seen c, Seen d) const noexcept {
        if (6.0 * this->volume() <= lattice_.exact_below_3())
            return sign_of(predicates::ccw_determinant(this->row(b).offset, this->row(c).offset,
                                                       this->row(d).offset));
        return ccw(this->eye(), this->name(b), this->name(c), this->name(d));
    }
    /// Whether the site that sees them conflicts with a cell that turns positively, without the
    /// vertex at infinity.
    [[nodiscard]] bool conflicts(const std::array<Seen, 4>& cell) const noexcept {
        const Sign sign =
            24.0 * this->magnitude() <= lattice_.exact_below_5()
                ? sign_of(this->in_sphere(cell))
                : power::in_sphere_decision(site(cell[0]), site(cell[1]), site(cell[2]),
                                            site(cell[3]), this->at(this->eye()))
                      .sign;
        return sign != 0 ? sign > 0 : conflicts_by_rule(cell);
    }

 private:
    [[nodiscard]] static Sign sign_of(double exact) noexcept {
        return (exact > 0.0) - (exact < 0.0);
    }
    [[nodiscard]] const S& site(Seen v) const noexcept { return this->at(this->name(v)); }
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        return power::precedes(this->at(a), numbers_[a], this->at(b), numbers_[b]);
    }

    /// power::in_sphere_tie, with orientations by what is seen.
    [[nodiscard]] bool conflicts_by_rule(const std::array<Seen, 4>& cell) const noexcept {
        constexpr std::size_t facet_of[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        std::array<bool, 4> has_no_say{};
        for (;;) {
            // The last one in the order, of those that may have a say.
            std::size_t last = 4;
            for (std::size_t m = 0; m < 4; ++m)
                if (!has_no_say[m] &&
                    precedes(last == 4 ? this->eye() : this->name(cell[last]), this->name(cell[m])))
                    last = m;
            if (last == 4) return false;
            const auto& facet = facet_of[last];
            const Sign sign = side(cell[facet[0]], cell[facet[1]], cell[facet[2]]);
            if (sign != 0) return sign > 0;
            has_no_say[last] = true;
        }
    }

    const Index* numbers_;
    Lattice lattice_;
};

}  // namespace signum::spatial

SIGNUM_IEEE_END
