#pragma once
/// The questions that an insertion asks, of sites by their places in its order.

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "../../core/index.hpp"
#include "../../core/sign.hpp"
#include "../../predicates/space/ties.hpp"
#include "cells.hpp"
#include "lattice.hpp"
#include "view.hpp"

SIGNUM_IEEE_BEGIN

namespace signum::spatial {

[[nodiscard]] inline Sign sign_of(double number) noexcept {
    return (number > 0.0) - (number < 0.0);
}

/// Exact, ties decided by the rule. `numbers`: those of the sites in the input, which the rule's
/// order ends with.
template <power::PowerSite3 S>
class ExactKernel : public View<S> {
 public:
    static constexpr bool is_exact = true;

    ExactKernel(std::span<const S> sites, std::span<const Index> numbers)
        : View<S>(sites.data()),
          numbers_(numbers.data()),
          lattice_(sites),
          can_refine_(are_in_window(sites)) {}
    /// More sites, after the same ones, which may lie elsewhere in memory. Not between look_from()
    /// and an answer.
    void extend(std::span<const S> sites, std::span<const Index> numbers) noexcept {
        this->move_to(sites.data());
        numbers_ = numbers.data();
        lattice_ = Lattice(sites);
        can_refine_ = are_in_window(sites);
    }

    /// The orientation of four sites.
    [[nodiscard]] Sign ccw(Index a, Index b, Index c, Index d) const noexcept {
        const filters::Verdict verdict =
            predicates::ccw_filter(this->at(a), this->at(b), this->at(c), this->at(d));
        if (verdict.is_certain()) [[likely]]
            return verdict.sign();
        return ccw_closely(centre3(this->at(a)), centre3(this->at(b)), centre3(this->at(c)),
                           centre3(this->at(d)));
    }
    /// That of the site that sees them and three others.
    [[nodiscard]] Sign side(Seen b, Seen c, Seen d) const noexcept {
        if (6.0 * this->volume() <= lattice_.exact_below_3())
            return sign_of(predicates::ccw_determinant(this->row(b).offset, this->row(c).offset,
                                                       this->row(d).offset));
        return ccw(this->eye(), this->name(b), this->name(c), this->name(d));
    }
    /// The determinants in the cells beyond the facets of one, as in_spheres_beyond() has them, and
    /// what they are in error by; 0 of a lattice's points, where ties are decided but for zeros.
    [[nodiscard]] double in_spheres(const std::array<Seen, 4>& cell,
                                    const std::array<Seen, 4>& beyond,
                                    std::array<double, 4>& determinants) const noexcept {
        if constexpr (std::same_as<S, Point3>) {
            if (is_on_lattice()) {
                // A step along an axis counts more than all steps along later ones come to; all
                // together less than 24 / height of what is exact.
                const auto& [x, y, z] = this->largest();
                const double along_y = 4.0 * z * lattice_.per_unit();
                const double along_x = 4.0 * (y * along_y + z) * lattice_.per_unit();
                in_spheres_beyond_by_rule(this->rows(cell), this->rows(beyond), along_x, along_y,
                                          determinants);
                return 0.0;
            }
        }
        in_spheres_beyond(this->rows(cell), this->rows(beyond), determinants);
        return this->bound();
    }
    /// Determinants of which not all are certain, as in_spheres_beyond() has them, and what they
    /// are in error by then. With the vertex at infinity they stay if they are certain.
    [[nodiscard]] double refine(const std::array<Seen, 4>& cell, const std::array<Seen, 4>& beyond,
                                std::array<double, 4>& determinants) const noexcept {
        if (!can_refine_ || is_on_lattice() || !(this->magnitude() < 0x1p900)) return this->bound();
        // In the place of infinity any site will do.
        const S& any = site(cell[0] != seen_infinity ? cell[0] : cell[1]);
        const auto sites = [&](const std::array<Seen, 4>& v) -> std::array<const S*, 4> {
            const auto of = [&](Seen each) { return each != seen_infinity ? &site(each) : &any; };
            return {of(v[0]), of(v[1]), of(v[2]), of(v[3])};
        };
        std::array<double, 4> refined;
        refined_in_spheres_beyond(this->at(this->eye()), sites(cell), sites(beyond), refined);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 4; ++k) {
            bool is_finite = beyond[k] != seen_infinity;
            for (std::size_t m = 0; m < 4; ++m) is_finite &= m == k || cell[m] != seen_infinity;
            const bool was_certain = filters::magnitude(determinants[k]) > this->bound();
            determinants[k] = is_finite     ? refined[k]
                              : was_certain ? std::copysign(infinity, determinants[k])
                                            : 0.0;
        }
        return 24.0 * refined_error * this->magnitude();
    }
    /// Whether the site that sees them conflicts with a cell that turns positively, without the
    /// vertex at infinity; its determinant is not certain, for it is not greater than its error may
    /// be.
    [[nodiscard]] bool conflicts(const std::array<Seen, 4>& cell, double determinant,
                                 double error) const noexcept {
        Sign sign = 0;
        if (is_on_lattice()) {
            sign = sign_of(determinant);
        } else if (!(error < lattice_.zero_below_5())) {
            sign = power::in_sphere_decision(site(cell[0]), site(cell[1]), site(cell[2]),
                                             site(cell[3]), this->at(this->eye()))
                       .sign;
        }
        return sign != 0 ? sign > 0 : conflicts_by_rule(cell);
    }

 private:
    [[nodiscard, gnu::cold, gnu::noinline]] Sign ccw_closely(const Point3& a, const Point3& b,
                                                             const Point3& c,
                                                             const Point3& d) const noexcept {
        const auto u = predicates::offset(b, a);
        const auto v = predicates::offset(c, a);
        const auto w = predicates::offset(d, a);
        const auto [x, y, z] = predicates::reach(u, v, w);
        if (lattice_.exact_below_3() > 0.0) {
            if (!(x > 0.0 && y > 0.0 && z > 0.0)) return 0;
            if (6.0 * (x * y * z) <= lattice_.exact_below_3())
                return sign_of(predicates::ccw_determinant(u, v, w));
        }
        return predicates::Ccw3::of_points<Arithmetic::exact>(a, b, c, d).sign;
    }
    [[nodiscard]] const S& site(Seen v) const noexcept { return this->at(this->name(v)); }
    [[nodiscard]] bool precedes(Index a, Index b) const noexcept {
        return power::precedes(this->at(a), numbers_[a], this->at(b), numbers_[b]);
    }
    [[nodiscard]] bool is_on_lattice() const noexcept {
        return 24.0 * this->magnitude() <= lattice_.exact_below_5();
    }
    /// Three of the vertices, so that with another site in the place of the fourth, and first, they
    /// turn as the cell did.
    [[nodiscard]] Sign side_without(const std::array<Seen, 4>& cell, std::size_t m) const noexcept {
        const auto& [a, b, c] = facet_of[m];
        return side(cell[a], cell[b], cell[c]);
    }

    /// power::in_sphere_tie, with orientations by what is seen.
    [[nodiscard]] bool conflicts_by_rule(const std::array<Seen, 4>& cell) const noexcept {
        std::array<bool, 4> has_no_say{};
        for (;;) {
            // The last one in the order, of those that may have a say.
            std::size_t last = 4;
            for (std::size_t m = 0; m < 4; ++m)
                if (!has_no_say[m] &&
                    precedes(last == 4 ? this->eye() : this->name(cell[last]), this->name(cell[m])))
                    last = m;
            if (last == 4) return false;
            if (const Sign sign = side_without(cell, last); sign != 0) return sign > 0;
            has_no_say[last] = true;
        }
    }

    const Index* numbers_;
    Lattice lattice_;
    bool can_refine_;
};

/// The same in doubles, whose word is taken for the truth, and a zero for no conflict, wherever the
/// orthospheres, which are right, tell nothing: what exactness is measured against.
template <power::PowerSite3 S>
class NaiveKernel : public View<S> {
 public:
    static constexpr bool is_exact = false;

    NaiveKernel(std::span<const S> sites, std::span<const Index> /*numbers*/)
        : View<S>(sites.data()) {}

    [[nodiscard]] static constexpr double bound() noexcept { return 0.0; }
    [[nodiscard]] double in_spheres(const std::array<Seen, 4>& cell,
                                    const std::array<Seen, 4>& beyond,
                                    std::array<double, 4>& determinants) const noexcept {
        in_spheres_beyond(this->rows(cell), this->rows(beyond), determinants);
        return bound();
    }
    [[nodiscard]] Sign ccw(Index a, Index b, Index c, Index d) const noexcept {
        const S& origin = this->at(a);
        return sign_of(predicates::ccw_determinant(predicates::offset(this->at(b), origin),
                                                   predicates::offset(this->at(c), origin),
                                                   predicates::offset(this->at(d), origin)));
    }
    [[nodiscard]] Sign side(Seen b, Seen c, Seen d) const noexcept {
        return sign_of(predicates::ccw_determinant(this->row(b).offset, this->row(c).offset,
                                                   this->row(d).offset));
    }
    [[nodiscard]] static bool conflicts(const std::array<Seen, 4>& /*cell*/, double determinant,
                                        double /*error*/) noexcept {
        return determinant > 0.0;
    }
};

}  // namespace signum::spatial

SIGNUM_IEEE_END
