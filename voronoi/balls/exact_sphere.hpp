#pragma once
/// Spheres that touch three or four balls, as exact numbers a + b √g, and the curves of those that
/// touch three: what the diagram of balls asks where the predicates of four and five balls do not
/// suffice. For sources only.
///
/// A sphere (c, rho) and a ball m make the vector w = (c - c_0, rho + r_0) and the row y_m = (c_m -
/// c_0, r_m - r_0), relative to a ball 0 that the sphere touches: <w, w> = 0 with <,> = x·x - h h.
/// It touches m where 2 y_m·w = p_m = <y_m, y_m>, and m conflicts where this is more than p_m, so
/// long as no ball is hidden: then w_h >= 0 is all that is left to ask.
///
/// Laws:
///  1. relative to a, points of contact of a, b, c, l turn as det[w', y_b, y_c, y_l] says, with w'
///  =
///     (c - c_a, -(rho + r_a)): this is the opposite of det[(c_m - c, rho + r_m)], which is the
///     opposite of their ccw;
///  2. the cofactors of y_l in it are a tangent of the curve of a, b, c, in what is called its
///     forward direction: there 2 y_l·w grows where l turns positively, and l begins to conflict;
///  3. the curve lies in the plane y_b·w = p_b / 2, y_c·w = p_c / 2. With W = p_b p_c - <y_b, y_c>²
///     it is an ellipse where W < 0, else one branch of a hyperbola or a parabola. Then the height
///     n·x, n = X_b × X_c, rises forward all along: its change is det[w', y_b, y_c, (n, 0)] = <w,
///     t> for the cofactors t of w'. These lie in the plane's directions, which have no more than
///     one sign of <,> beside that of (n, 0), orthogonal to it, so that <t, t> <= 0; and t's last
///     number is -n·n, so that t and w lie in opposite halves of the cone.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "../../core/sign.hpp"
#include "../../core/site.hpp"
#include "exact_vector.hpp"

namespace signum::balls {

using Vector4 = Vector<4>;

class ExactSphere {
 public:
    /// Those that touch four balls, none of which hides another. None where infinitely many do.
    [[nodiscard]] static std::vector<ExactSphere> touching(const std::array<Site3, 4>& balls);
    /// A sphere that touches three balls, none of which hides another, if infinitely many do.
    [[nodiscard]] static std::optional<ExactSphere> on_curve(const std::array<Site3, 3>& balls);

    /// +1 where a ball conflicts with it, 0 where it touches. Precondition: it is not hidden.
    [[nodiscard]] Sign conflict(const Site3& q) const;
    /// How the points of contact turn, as ccw has it.
    [[nodiscard]] Sign turn(const Site3& a, const Site3& b, const Site3& c, const Site3& l) const;
    /// Of a ball l that touches it, and nowhere else the curve of three others: whether it
    /// conflicts with all other spheres of the curve.
    [[nodiscard]] bool is_only_one_free_of(const std::array<Site3, 3>& curve, const Site3& l) const;

 private:
    friend std::vector<std::size_t> forward_order(const std::array<Site3, 3>& curve,
                                                  std::span<const ExactSphere> spheres);
    struct Surd {
        Rational a, b;  // a + b √g
    };
    [[nodiscard]] Sign sign(const Surd& number) const;
    [[nodiscard]] Surd product(const Vector4& row, const Vector4& from) const;
    /// det[w', b, c, row], relative to `from`.
    [[nodiscard]] Surd turned(const Vector4& from, const Vector4& b, const Vector4& c,
                              const Vector4& row) const;
    /// Of the equations of w.
    [[nodiscard]] static std::vector<ExactSphere> solve(const Vector4& first,
                                                        const System<4>& system);

    // c and rho: middle + step √g.
    Vector4 middle_;
    Vector4 step_;
    Rational g_;
};

/// Whether infinitely many spheres touch four balls: the rows of the others relative to the first
/// depend on one another. Precondition: some sphere touches all, and none hides another.
[[nodiscard]] bool touch_along_a_curve(const std::array<Site3, 4>& balls);

/// Whether the curve of three balls is an ellipse. Precondition: none hides another.
[[nodiscard]] bool is_loop(const std::array<Site3, 3>& curve);

/// The numbers of different spheres on a curve as they follow one another along it, forward (law
/// 2); on a loop from any of them.
[[nodiscard]] std::vector<std::size_t> forward_order(const std::array<Site3, 3>& curve,
                                                     std::span<const ExactSphere> spheres);

}  // namespace signum::balls
