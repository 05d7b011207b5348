#include "in_sphere.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include "../../core/processor.hpp"
#include "../../exact/integer_rows.hpp"
#include "../ladder/ladder.hpp"

namespace signum::power {
namespace {

namespace ladder = predicates::ladder;
using filters::Verdict;

/// Whether five sites of equal weights are corners of a box along the axes: no more than two
/// coordinates along each. They lie on one sphere then, however these were rounded: all of a grid.
template <PowerSite3 S>
[[nodiscard]] bool are_corners_of_a_box(const S& i, const S& j, const S& k, const S& l,
                                        const S& q) noexcept {
    const auto are_two = [&](double S::*const axis) {
        const double one = q.*axis;
        double other = one;
        for (const S* site : {&i, &j, &k, &l}) {
            const double here = site->*axis;
            if (here != one && other != one && here != other) return false;
            if (here != one) other = here;
        }
        return true;
    };
    const auto is_one = [&](double S::*const number) {
        return i.*number == q.*number && j.*number == q.*number && k.*number == q.*number &&
               l.*number == q.*number;
    };
    if constexpr (requires { q.r; }) {
        if (!is_one(&S::r)) return false;
    }
    if constexpr (requires { q.w; }) {
        if (!is_one(&S::w)) return false;
    }
    return are_two(&S::x) && are_two(&S::y) && are_two(&S::z);
}

static_assert(refined_in_sphere_error >= 2 * 12 * filters::double_double_epsilon);

/// All stages, which share rows and magnitude. Differences to q are below 2^60: heights are below
/// 2^123, minors of two rows below 2^121 and of three below 2^183, and the sum of four products
/// below 2^308. Divided by 2^40 all is below 2^108. Divided by 2^12, as most sites of a grid that
/// was rounded can be, heights are below 2^99, minors below 2^97 and 2^147, and the sum is below
/// 2^248. Either takes less time than double-doubles, and these less than wider integers.
struct Within {
    template <class Offset, class Weight>
    [[nodiscard]] static auto determinant(const exact::IntegerRows<3>& rows) noexcept {
        const auto row = [&](std::size_t m) -> LiftedRow<Offset, Weight> {
            const auto& [x, y, z] = rows[m].offset;
            return {{Offset{x}, Offset{y}, Offset{z}}, Weight{rows[m].weight}};
        };
        return in_sphere_determinant(row(0), row(1), row(2), row(3));
    }

    template <PowerSite3 S>
    [[nodiscard, gnu::always_inline]] static inline Decision climb(const S& i, const S& j,
                                                                   const S& k, const S& l,
                                                                   const S& q) noexcept {
        const LiftedRow<double> rounded[4] = {lifted_row(i, q), lifted_row(j, q), lifted_row(k, q),
                                              lifted_row(l, q)};
        const double value = in_sphere_determinant(rounded[0], rounded[1], rounded[2], rounded[3]);
        const double size = determinant_magnitude(rounded);
        if (const Verdict verdict = ladder::judged(value, in_sphere_error * size);
            verdict.is_certain())
            return {verdict.sign(), Stage::filter};
        if (are_corners_of_a_box(i, j, k, l, q)) return {0, Stage::exact};
        exact::IntegerRows<3> rows({&i, &j, &k, &l}, q);
        using exact::Integer128;
        if (rows.are_exact() && rows.divide_by_power_of_two(40)) {
            const auto narrow = determinant<exact::Word<Integer128>, Integer128>(rows);
            return {(narrow > 0) - (narrow < 0), Stage::exact};
        }
        if (rows.are_exact() && rows.divide_by_power_of_two(12)) {
            using Offset = exact::Word<Integer128, exact::Integer256>;
            return {determinant<Offset, Integer128>(rows).sign(), Stage::exact};
        }
        filters::DoubleDouble refined;
        as_wide_as_possible([&]() __attribute__((always_inline)) {
            refined = InSphere::value<ladder::Refined>(i, j, k, l, q);
        });
        if (const Verdict verdict = ladder::judged(refined.high, refined_in_sphere_error * size);
            verdict.is_certain())
            return {verdict.sign(), Stage::refine};
        using Integer = boost::multiprecision::int512_t;
        if (rows.are_exact())
            return {Integer(determinant<Integer, Integer>(rows)).sign(), Stage::exact};
        return ladder::Steps<ladder::InExactNumbers<InSphere>>::climb(i, j, k, l, q);
    }
};

}  // namespace

template <Arithmetic arithmetic, PowerSite3 S>
Decision InSphere::behind(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
    return ladder::climb<arithmetic, InSphere, Within, ladder::Beyond<InSphere>>(i, j, k, l, q);
}

#define SIGNUM_INSTANTIATE(arithmetic, S)                                                  \
    template Decision InSphere::behind<arithmetic>(const S&, const S&, const S&, const S&, \
                                                   const S&) noexcept;
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Point3)
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, Site3)
SIGNUM_FOR_ARITHMETICS(SIGNUM_INSTANTIATE, signum::Site3)

}  // namespace signum::power
