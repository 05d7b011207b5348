#include "in_circle.hpp"

#include "../../exact/integer_rows.hpp"
#include "../ladder/ladder.hpp"

namespace signum::power {
namespace {

namespace ladder = predicates::ladder;
using filters::DoubleDouble;
using filters::Verdict;

/// Differences to q are below 2^60: squares are below 2^120, weights below 2^122, heights below
/// 2^123, minors below 2^121 and the sum of their three products below 2^246. Divided by 2^30,
/// heights are below 2^63, minors below 2^61, and the sum below 2^126.
struct InIntegers {
    static constexpr Stage stage = Stage::exact;

    template <class Square>
    [[nodiscard]] static auto determinant(const exact::IntegerRows<2>& rows) noexcept {
        const auto row = [&](std::size_t m) -> Row<exact::Word<Square>, Square> {
            return {{rows[m].offset[0]}, {rows[m].offset[1]}, Square{rows[m].weight}};
        };
        return in_circle_determinant(row(0), row(1), row(2));
    }

    template <PowerSite S>
    [[nodiscard]] static Verdict ask(const S& i, const S& j, const S& k, const S& q) noexcept {
        exact::IntegerRows<2> rows({&i, &j, &k}, q);
        if (!rows.are_exact()) return Verdict::uncertain();
        if (!rows.divide_by_power_of_two(30))
            return Verdict::certain(determinant<exact::Factor>(rows).sign());
        const exact::Integer128 narrow = determinant<exact::Integer128>(rows);
        return Verdict::certain((narrow > 0) - (narrow < 0));
    }
};

/// The error of the determinant in double-doubles as a multiple of its magnitude: the lemma of
/// rounding_count.hpp gives (1+d)^8 - 1; twice that covers the magnitude, rounded in doubles.
constexpr double refined_error = 16 * filters::double_double_epsilon;
constexpr Row<filters::RoundingCount> refined_row{
    filters::RoundingCount(), filters::RoundingCount(), filters::RoundingCount::of(1)};
static_assert(in_circle_determinant(refined_row, refined_row, refined_row).roundings == 8);
static_assert(refined_error >= 2 * 8 * filters::double_double_epsilon);

struct InDoubleDoubles {
    static constexpr Stage stage = Stage::refine;

    template <PowerSite S>
    [[nodiscard]] static Verdict ask(const S& i, const S& j, const S& k, const S& q) noexcept {
        const auto a = row<ladder::Refined>(i, q);
        const auto b = row<ladder::Refined>(j, q);
        const auto c = row<ladder::Refined>(k, q);
        const auto high = [](const Row<DoubleDouble>& row) -> Row<double> {
            return {row.x.high, row.y.high, row.weight.high};
        };
        return ladder::judged(in_circle_determinant(a, b, c).high,
                              refined_error * determinant_magnitude(high(a), high(b), high(c)));
    }
};

}  // namespace

template <Arithmetic arithmetic, PowerSite S>
Decision InCircle::behind(const S& i, const S& j, const S& k, const S& q) noexcept {
    using Within = ladder::Steps<ladder::Bounded<InCircle>, InIntegers, InDoubleDoubles,
                                 ladder::InExpansions<InCircle>>;
    return ladder::climb<arithmetic, InCircle, Within, ladder::Beyond<InCircle>>(i, j, k, q);
}

#define SIGNUM_INSTANTIATE(arithmetic, S) \
    template Decision InCircle::behind<arithmetic>(const S&, const S&, const S&, const S&) noexcept;
SIGNUM_FOR_POWER_SITES(SIGNUM_INSTANTIATE)

}  // namespace signum::power
