#include "forms.hpp"

#include <algorithm>
#include <span>

#include "../../core/contract.hpp"
#include "../../core/error_free.hpp"
#include "../../exact/floating_environment.hpp"
#include "../../exact/sign_of_sum.hpp"
#include "exact_number.hpp"

namespace signum::rectangular {
namespace {

constexpr std::size_t most_addends = 8;

/// The doubles of a sum of forms; those past `count` are not set.
struct Terms {
    std::array<double, 3 * most_addends> values;
    std::size_t count;
};

/// An addend with a site of its own: what has to be read inside the default environment.
struct Operand {
    Site site;
    int side;
    int factor;
};
struct Operands {
    std::array<Operand, most_addends> addends;
    std::size_t count;
};

template <class Directions>
void add(Terms& terms, const Site& site, int side, int factor) noexcept {
    const double times = factor;
    if (Directions::x[side] != 0)
        terms.values[terms.count++] = times * Directions::x[side] * site.x;
    if (Directions::y[side] != 0)
        terms.values[terms.count++] = times * Directions::y[side] * site.y;
    terms.values[terms.count++] = -times * site.r;
}

/// ESSA; in the arithmetic `exact` the rounded sum where it is the sum, as on grids, where every
/// partial sum is a double.
template <Arithmetic arithmetic>
Decision decide_terms(const Terms& terms) noexcept {
    const auto by_essa = [&]() -> Decision {
        return {sign_of_sum({terms.values.data(), terms.count}), Stage::essa};
    };
    if constexpr (arithmetic != Arithmetic::exact) return by_essa();
    double sum = 0.0;
    bool rounded = false;
    for (std::size_t i = 0; i < terms.count; ++i) {
        const double next = sum + terms.values[i];
        const double shared = next - sum;
        // The two errors of TwoSum (Knuth); NaN where something overflowed.
        rounded |= !((sum - (next - shared)) + (terms.values[i] - shared) == 0.0);
        sum = next;
    }
    return rounded ? by_essa() : Decision{sign_of(sum), Stage::exact};
}

template <class Directions, Arithmetic arithmetic>
Sign sign_of_exact_numbers(const Addend* first, std::size_t count) noexcept {
    predicates::ExactNumber<arithmetic> sum;
    for (const Addend* addend = first; addend != first + count; ++addend) {
        const auto add = [&](int factor, double value) {
            if (factor != 0) sum += factor * predicates::exactly<arithmetic>(value);
        };
        add(addend->factor * static_cast<int>(Directions::x[addend->side]), addend->site->x);
        add(addend->factor * static_cast<int>(Directions::y[addend->side]), addend->site->y);
        add(-addend->factor, addend->site->r);
    }
    return sum.sign();
}

}  // namespace

template <class Directions, Arithmetic arithmetic>
Decision decide_forms(const Addend* first, std::size_t count) noexcept {
    SIGNUM_EXPECTS(count <= most_addends);
    if constexpr (arithmetic == Arithmetic::multiprecision || arithmetic == Arithmetic::judging)
        return {sign_of_exact_numbers<Directions, arithmetic>(first, count), Stage::multiprecision};
    if (filters::environment_is_default()) [[likely]] {
        Terms terms;
        terms.count = 0;
        for (std::size_t i = 0; i < count; ++i)
            add<Directions>(terms, *first[i].site, first[i].side, first[i].factor);
        return decide_terms<arithmetic>(terms);
    }
    Operands operands;
    operands.count = count;
    for (std::size_t i = 0; i < count; ++i)
        operands.addends[i] = {*first[i].site, first[i].side, first[i].factor};
    return exact::in_ieee_environment(
        [](const Operands& given) {
            Terms terms;
            terms.count = 0;
            for (std::size_t i = 0; i < given.count; ++i)
                add<Directions>(terms, given.addends[i].site, given.addends[i].side,
                                given.addends[i].factor);
            return decide_terms<arithmetic>(terms);
        },
        operands);
}

template <class Directions, Arithmetic arithmetic>
Decision compare_distances(const Point& p, const Site& a, const Site& b) noexcept {
    const Site point{p.x, p.y, 0.0};
    Stage stage = Stage::exact;
    // (direction s)·(m - p) less (direction t)·(m' - p), radii included where the sites differ.
    const auto compare = [&](const Site& m, int s, const Site& other, int t) {
        const Addend addends[4] = {
            {&m, 0, s, 1}, {&point, 0, s, -1}, {&other, 0, t, -1}, {&point, 0, t, 1}};
        const Decision decision = decide_forms<Directions, arithmetic>(addends, 4);
        stage = std::max(stage, decision.stage);
        return decision.sign;
    };
    const auto farthest = [&](const Site& m) {
        int side = 0;
        for (int other = 1; other < 4; ++other)
            if (compare(m, other, m, side) > 0) side = other;
        return side;
    };
    const int farthest_of_b = farthest(b);
    const Sign sign = compare(b, farthest_of_b, a, farthest(a));
    return {sign, stage};
}

Sign sign_of_infinitesimals(const Addend* first, std::size_t count) noexcept {
    // From the last site in the order to the first.
    Index below = std::numeric_limits<Index>::max();
    for (;;) {
        Index last = std::numeric_limits<Index>::min();
        for (std::size_t i = 0; i < count; ++i)
            if (first[i].rank < below) last = std::max(last, first[i].rank);
        if (last == std::numeric_limits<Index>::min()) return 0;
        int factor = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (first[i].rank == last) factor += first[i].factor;
        if (factor != 0) return factor > 0 ? 1 : -1;
        below = last;
    }
}

#define SIGNUM_INSTANTIATE(Directions, arithmetic)                                               \
    template Decision decide_forms<Directions, arithmetic>(const Addend*, std::size_t) noexcept; \
    template Decision compare_distances<Directions, arithmetic>(const Point&, const Site&,       \
                                                                const Site&) noexcept;
SIGNUM_INSTANTIATE(Supremum, Arithmetic::exact)
SIGNUM_INSTANTIATE(Supremum, Arithmetic::interval)
SIGNUM_INSTANTIATE(Supremum, Arithmetic::sum)
SIGNUM_INSTANTIATE(Supremum, Arithmetic::multiprecision)
SIGNUM_INSTANTIATE(Supremum, Arithmetic::judging)
SIGNUM_INSTANTIATE(Manhattan, Arithmetic::exact)
SIGNUM_INSTANTIATE(Manhattan, Arithmetic::interval)
SIGNUM_INSTANTIATE(Manhattan, Arithmetic::sum)
SIGNUM_INSTANTIATE(Manhattan, Arithmetic::multiprecision)
SIGNUM_INSTANTIATE(Manhattan, Arithmetic::judging)
#undef SIGNUM_INSTANTIATE

}  // namespace signum::rectangular
