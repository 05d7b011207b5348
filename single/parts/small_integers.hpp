/// Points of space whose coordinates are small integers, as those of many grids: their rounded
/// determinants are exact. Differences of numbers below 2^15 are below 2^16, and the determinant of
/// three below 6·2^48. Of numbers up to 2^8 heights are below 3·2^18, minors of three rows below
/// 6·2^27, and the sum of four products below 72·2^45: all of them integers below 2^53.

#include <initializer_list>

namespace signum::predicates {

[[nodiscard, gnu::noinline]] inline bool are_small_integers(
    double most, std::initializer_list<const Point3*> points) noexcept {
    bool are_small = true;
    for (const Point3* p : points)
        for (const double x : {p->x, p->y, p->z})
            are_small &=
                filters::magnitude(x) <= most && static_cast<double>(static_cast<int>(x)) == x;
    return are_small;
}

namespace ladder {
template <>
struct InExpansions<Ccw3> {
    static constexpr Stage stage = Stage::exact;
    [[nodiscard]] static Verdict ask(const Point3& a, const Point3& b, const Point3& c,
                                     const Point3& d) noexcept {
        if (are_small_integers(0x1p15, {&a, &b, &c, &d}))
            return Verdict::certain(sign_of(Ccw3::value<double>(a, b, c, d)));
        return InExactNumbers<Ccw3>::ask(a, b, c, d);
    }
};
}  // namespace ladder
}  // namespace signum::predicates
