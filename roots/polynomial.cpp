#include "polynomial.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "../core/contract.hpp"
#include "filter.hpp"
#include "rounded.hpp"

namespace signum::roots {
namespace {

using exact::Dyadic;
using exact::Integer;
using Isolated = exact::Roots::Isolated;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Doubles in their order as consecutive integers.
std::int64_t place_of(double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
double double_at(std::int64_t place) {
    return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
}

/// Infinity counts as 2^1024, where the next double would be.
Dyadic dyadic_of(double x) {
    if (x == infinity) return Dyadic(Integer(1), 1024);
    if (x == -infinity) return Dyadic(Integer(-1), 1024);
    return Dyadic(x);
}

/// A root of p in (low, high], where p has one at most, a simple one.
bool vanishes_in(const exact::Polynomial& p, const Isolated& where) {
    const Sign at_high = p.sign_at(where.high);
    return at_high == 0 || exact::sign_after(p, where.low) != at_high;
}

filters::Verdict sign_of(const Approximations& p, double t) {
    if (filters::magnitude(t) == infinity) return filters::Verdict::uncertain();
    return filter::sign(filter::value_at(p, filters::pinned(t)));
}

/// The double that is the root, or the two neighbours around it.
template <class Compare>
std::pair<double, double> neighbours(double low, double high, const Compare& compare) {
    std::int64_t below = place_of(low);
    std::int64_t above = place_of(high);
    while (below + 1 < above) {
        const std::int64_t middle = std::midpoint(below, above);
        const double x = double_at(middle);
        const Sign sign = compare(x);
        if (sign == 0) return {x, x};
        (sign > 0 ? below : above) = middle;
    }
    return {double_at(below), double_at(above)};
}

}  // namespace

/// Counts a question when it has been answered.
struct Polynomial::Asked {
    Tally* tally;
    bool exact = false;

    ~Asked() {
        if (tally != nullptr) ++(exact ? tally->exact : tally->filtered);
    }
};

/// What is known exactly, each part from its first use on.
struct Polynomial::Exact {
    explicit Exact(exact::Polynomial polynomial)
        : p(std::move(polynomial)), approximate(rounded(p.coefficients(), 0)) {}

    exact::Polynomial p;
    Approximations approximate;  // better than that of the filter, but for a positive factor
    std::vector<exact::Polynomial> factors;
    exact::Polynomial square_free;
    std::optional<exact::Roots> chain;
    Dyadic least;  // all roots are greater, and less than -least

    const exact::Polynomial& simple() {
        if (square_free.degree() < 0) {
            factors = exact::square_free_factors(p);
            square_free = {Dyadic(1.0)};
            for (const exact::Polynomial& factor : factors) square_free = square_free * factor;
        }
        return square_free;
    }
    const exact::Roots& roots() {
        if (!chain) {
            chain.emplace(simple());
            // Cauchy: |root| < 1 + max |c_i| / |c_n|.
            const auto bits = [](const Integer& c) {
                return c.is_zero() ? 0 : static_cast<int>(msb(abs(c))) + 1;
            };
            int most = 0;
            for (const Integer& c : square_free.coefficients()) most = std::max(most, bits(c));
            least = Dyadic(Integer(-1), most - bits(square_free.coefficients().back()) + 2);
        }
        return *chain;
    }

    /// The k-th root from the last one, counted from 0. Doubles in their order are halved first:
    /// steps of any length would be too many for roots of every size.
    Isolated from_last(int k) {
        std::int64_t low = place_of(-infinity);
        std::int64_t high = place_of(infinity);
        int after_low = chain->after(dyadic_of(-infinity));
        int after_high = chain->after(dyadic_of(infinity));
        if (after_high > k) return chain->isolate({dyadic_of(infinity), -least}, after_high - k);
        if (after_low <= k)
            return chain->isolate({least, dyadic_of(-infinity)}, chain->after(least) - k);
        while (low + 1 < high && (after_low != k + 1 || after_high != k)) {
            const std::int64_t middle = std::midpoint(low, high);
            const int after_middle = chain->after(Dyadic(double_at(middle)));
            (after_middle > k ? low : high) = middle;
            (after_middle > k ? after_low : after_high) = after_middle;
        }
        const Isolated where{dyadic_of(double_at(low)), dyadic_of(double_at(high))};
        return after_low == k + 1 && after_high == k ? where : chain->isolate(where, after_low - k);
    }
    Isolated isolated(const Root& root) {
        if (root.alone) return {Dyadic(root.low), Dyadic(root.high)};
        roots();
        const double before = root.is_double() ? double_at(place_of(root.low) - 1) : root.low;
        const Isolated where{before == -infinity ? least : Dyadic(before),
                             root.high == infinity ? -least : Dyadic(root.high)};
        const int place = root.is_double() ? chain->between(where.low, where.high) : root.place;
        return chain->isolate(where, place);
    }
    int multiplicity(const Isolated& where) {
        for (std::size_t k = 0; k < factors.size(); ++k)
            if (vanishes_in(factors[k], where)) return static_cast<int>(k) + 1;
        SIGNUM_EXPECTS(false);
        return 0;
    }
    Root root_of(const Isolated& where, int multiplicity) {
        Root root{};
        const auto after = static_cast<std::int8_t>(exact::sign_after(p, where.high));
        // Within the interval the sign of the polynomial tells, if it changes; mostly that of the
        // approximation.
        const auto compare = [&](double x) {
            const Dyadic number = dyadic_of(x);
            if (number <= where.low) return 1;
            if (number > where.high) return -1;
            if (multiplicity % 2 == 0) return chain->compare(where, number);
            const auto verdict = sign_of(approximate, x);
            const Sign sign = verdict.is_certain() ? verdict.sign() : p.sign_at(number);
            return sign == 0 ? 0 : sign == after ? -1 : 1;
        };
        const auto beyond = static_cast<std::int8_t>(compare(infinity));
        // Beyond the doubles: between the last one and infinity.
        constexpr double most = std::numeric_limits<double>::max();
        if (beyond >= 0) {
            std::tie(root.low, root.high) = std::pair(most, infinity);
        } else if (compare(-infinity) <= 0) {
            std::tie(root.low, root.high) = std::pair(-infinity, -most);
        } else {
            std::tie(root.low, root.high) = neighbours(-infinity, infinity, compare);
        }
        root.multiplicity = static_cast<std::int8_t>(multiplicity);
        root.after = after;
        root.place = 1;
        if (root.is_double()) return root;
        const Dyadic low = root.low == -infinity ? least : Dyadic(root.low);
        const int rest = chain->after(low);
        root.place = static_cast<std::int8_t>(rest - chain->after(where.high));
        const bool finite = root.low != -infinity && root.high != infinity;
        root.alone = finite && root.changes_sign() && rest - chain->after(Dyadic(root.high)) == 1 &&
                     p.sign_at(low) != 0 && p.sign_at(Dyadic(root.high)) != 0;
        return root;
    }

    /// Coefficients that are rounded once, at the very place, mostly do, a root at t included.
    std::optional<Root> first(double t) {
        if (p.degree() < 1) return std::nullopt;
        const Approximations at_t = shifted(p, t);
        const filter::Found found = filter::first_root(approximate, t, 0, &at_t);
        return found.certain ? found.root : first(Dyadic(t));
    }
    std::optional<Root> first(const Dyadic& t) {
        if (p.degree() < 1) return std::nullopt;
        const int after = roots().after(t);
        if (after == 0) return std::nullopt;
        const Isolated where = from_last(after - 1);
        return root_of(where, multiplicity(where));
    }
    RealRoots real_roots() {
        RealRoots result;
        result.everywhere = p.degree() < 0;
        if (p.degree() < 1) return result;
        if (const auto found = filter::real_roots(approximate)) return *found;
        roots();
        result.count = chain->after(least);
        for (int i = 0; i < result.count; ++i) {
            const Isolated where = from_last(result.count - 1 - i);
            result.roots[static_cast<std::size_t>(i)] = root_of(where, multiplicity(where));
        }
        return result;
    }

    /// One half of the interval.
    void halve(Isolated& where, const Root& root) {
        if (!root.alone) return roots().halve(where);
        const Dyadic middle = Dyadic(0.5) * (where.low + where.high);
        (p.sign_at(middle) == root.before() ? where.low : where.high) = middle;
    }

    /// At a root of another polynomial, and right after it. Where that root is a simple one of the
    /// other polynomial it is none but a simple one of a common divisor.
    std::pair<Sign, Sign> signs_at(Exact& other, const Root& root) {
        if (p.degree() < 1) return {p.sign_at_infinity(), p.sign_at_infinity()};
        Isolated where = other.isolated(root);
        const bool simple_one = root.alone && root.multiplicity == 1;
        const exact::Polynomial common = simple_one
                                             ? exact::common_divisor(p, other.p)
                                             : exact::common_divisor(simple(), other.simple());
        const bool vanishes = common.degree() > 0 && vanishes_in(common, where);
        if (root.alone) {
            const auto verdict = vanishes ? filter::sign_between(slope(), root.low, root.high)
                                          : filter::sign_between(approximate, root.low, root.high);
            // Where it vanishes the sign right after it is that of the slope, if there is one.
            if (verdict.is_certain() && verdict.sign() != 0)
                return {vanishes ? 0 : verdict.sign(), verdict.sign()};
        }
        const int at_most = vanishes ? 1 : 0;
        while (roots().between(where.low, where.high) > at_most) other.halve(where, root);
        const Sign after = exact::sign_after(p, where.high);
        return {vanishes ? 0 : after, after};
    }
    [[nodiscard]] Approximations slope() const {
        Approximations result;
        result.degree = approximate.degree - 1;
        for (int i = 0; i <= result.degree; ++i)
            result.c[static_cast<std::size_t>(i)] =
                (i + 1) * approximate.c[static_cast<std::size_t>(i) + 1];
        return result;
    }

    /// Roots that are alone are of odd multiplicity, so that in a common divisor they are, too.
    Sign compare(const Root& root, Exact& other, const Root& its_root) {
        Isolated a = isolated(root);
        Isolated b = other.isolated(its_root);
        const auto order = [&] { return a.high <= b.low ? -1 : static_cast<int>(b.high <= a.low); };
        if (order() != 0) return order();
        const exact::Polynomial common = root.alone && its_root.alone
                                             ? exact::common_divisor(p, other.p)
                                             : exact::common_divisor(simple(), other.simple());
        if (common.degree() > 0 &&
            vanishes_in(common, {a.low < b.low ? b.low : a.low, a.high < b.high ? a.high : b.high}))
            return 0;
        while (order() == 0) {
            halve(a, root);
            other.halve(b, its_root);
        }
        return order();
    }
};

void Polynomial::Forget::operator()(Exact* known) const noexcept {
    delete known;
}

Polynomial::Exact& Polynomial::exact() const {
    if (!known_) {
        known_.reset(new Exact(exact_(form_)));
    }
    return *known_;
}

bool Polynomial::is_zero(Tally* tally) const {
    Asked asked{tally};
    for (int i = 0; i <= approximate_.degree; ++i) {
        const auto verdict = filter::sign(approximate_.c[static_cast<std::size_t>(i)]);
        if (verdict.is_certain() && verdict.sign() != 0) return false;
    }
    if (approximate_.degree < 0) return true;
    asked.exact = true;
    return exact().p.degree() < 0;
}

/// About the origin, which a root's polynomial has beside the root: there the powers of t - origin
/// are small, and what the coefficient of the 0th lost counts alone.
filters::Verdict Polynomial::refined_sign(double t) const {
    if (filters::magnitude(t) == infinity || !filters::environment_is_default())
        return filters::Verdict::uncertain();
    if (!better_known_) {
        better_known_ = std::make_unique<RefinedCoefficients>();
        refined_(form_, filters::pinned(approximate_.origin), *better_known_);
    }
    const RefinedCoefficients& c = *better_known_;
    const Refined s(filters::exact_difference(filters::pinned(t), approximate_.origin), 0.0);
    auto i = static_cast<std::size_t>(approximate_.degree);
    Refined value = c[i];
    while (i-- > 0) value = value * s + c[i];
    if (!value.has_sign()) return filters::Verdict::uncertain();
    return filters::Verdict::certain(filters::sign_of_nonzero(value.value.high));
}

Sign Polynomial::sign_at(double t, Asked& asked) const {
    const auto verdict = sign_of(approximate_, t);
    if (verdict.is_certain()) return verdict.sign();
    const auto refined = refined_sign(t);
    if (refined.is_certain()) return refined.sign();
    asked.exact = true;
    return exact().p.sign_at(Dyadic(t));
}
Sign Polynomial::sign_at(double t, Tally* tally) const {
    Asked asked{tally};
    return sign_at(t, asked);
}

Sign Polynomial::sign_after(double t, Tally* tally) const {
    Asked asked{tally};
    const Sign sign = sign_at(t, asked);
    if (sign != 0 || approximate_.degree < 0) return sign;
    asked.exact = true;
    return exact::sign_after(exact().p, Dyadic(t));
}

Sign Polynomial::sign_at(const RootOf& t, Tally* tally) const {
    if (t.root.is_double()) return sign_at(t.root.low, tally);
    Asked asked{tally};
    if (&t.polynomial == this) return 0;
    const auto verdict = filter::sign_between(approximate_, t.root.low, t.root.high);
    if (verdict.is_certain()) return verdict.sign();
    asked.exact = true;
    return exact().signs_at(t.polynomial.exact(), t.root).first;
}

Sign Polynomial::sign_after(const RootOf& t, Tally* tally) const {
    Asked asked{tally};
    if (&t.polynomial == this) return Sign{t.root.after};
    if (t.root.is_double()) return sign_after(t.root.low, tally);
    const auto verdict = filter::sign_between(approximate_, t.root.low, t.root.high);
    if (verdict.is_certain() && verdict.sign() != 0) return verdict.sign();
    asked.exact = true;
    return exact().signs_at(t.polynomial.exact(), t.root).second;
}

std::optional<Root> Polynomial::first(double t, Asked& asked) const {
    const filter::Found found = filter::first_root(approximate_, filters::pinned(t));
    if (found.certain) return found.root;
    asked.exact = true;
    return exact().first(t);
}

/// Between a root that is alone and the upper end of its interval there is no other.
std::optional<Root> Polynomial::first(const Root& mine, Asked& asked) const {
    if (mine.alone || mine.is_double()) {
        const filter::Found found = filter::first_root(approximate_, filters::pinned(mine.high),
                                                       mine.alone ? Sign{mine.after} : 0);
        if (found.certain) return found.root;
    }
    asked.exact = true;
    if (mine.alone || mine.is_double()) return exact().first(mine.high);
    return exact().first(exact().isolated(mine).high);
}

std::optional<Root> Polynomial::first(const RootOf& t, Asked& asked) const {
    if (&t.polynomial == this) return first(t.root, asked);
    if (t.root.is_double()) return first(t.root.low, asked);
    std::optional<Root> root;
    if (t.root.low != -infinity) {
        root = first(t.root.low, asked);
    } else {
        asked.exact = true;
        if (exact().p.degree() < 1) return root;
        exact().roots();
        root = exact().first(exact().least);
    }
    while (root && compare({*this, *root}, t, asked) <= 0) root = first(*root, asked);
    return root;
}

std::optional<Root> Polynomial::first_root(double t, Tally* tally) const {
    SIGNUM_EXPECTS(filters::magnitude(t) <= std::numeric_limits<double>::max());
    Asked asked{tally};
    return first(t, asked);
}
std::optional<Root> Polynomial::first_root(const RootOf& t, Tally* tally) const {
    Asked asked{tally};
    return first(t, asked);
}

RealRoots Polynomial::real_roots(Tally* tally) const {
    Asked asked{tally};
    if (const std::optional<RealRoots> roots = filter::real_roots(approximate_)) return *roots;
    asked.exact = true;
    return exact().real_roots();
}

Root Polynomial::narrowed(const Root& root, Asked& asked) const {
    if (!root.alone) return root;
    Root result = root;
    std::tie(result.low, result.high) = neighbours(root.low, root.high, [&](double x) {
        const Sign sign = sign_at(x, asked);
        return sign == 0 ? 0 : sign == root.before() ? 1 : -1;
    });
    result.alone = !result.is_double();
    return result;
}
Root Polynomial::narrowed(const Root& root, Tally* tally) const {
    Asked asked{tally};
    return narrowed(root, asked);
}

double Polynomial::nearest_double(const Root& root, Tally* tally) const {
    Asked asked{tally};
    const Root near = narrowed(root, asked);
    if (near.is_double()) return near.low;
    asked.exact = true;
    const Dyadic half = Dyadic(0.5) * (dyadic_of(near.low) + dyadic_of(near.high));
    Sign sign = 0;
    if (near.alone) {
        const Sign at_half = exact().p.sign_at(half);
        sign = at_half == 0 ? 0 : at_half == near.before() ? 1 : -1;
    } else {
        sign = exact().roots().compare(exact().isolated(near), half);
    }
    const bool low_is_even = std::bit_cast<std::uint64_t>(near.low) % 2 == 0;
    return sign < 0 || (sign == 0 && low_is_even) ? near.low : near.high;
}

Sign Polynomial::compare(const RootOf& a, double x, Asked& asked) {
    if (a.root.is_double()) return filters::compare_numbers(a.root.low, x);
    if (filters::compare_numbers(x, a.root.low) <= 0) return 1;
    if (filters::compare_numbers(x, a.root.high) >= 0) return -1;
    // Not between neighbours, so that the root is alone.
    const Sign sign = a.polynomial.sign_at(x, asked);
    return sign == 0 ? 0 : sign == a.root.before() ? 1 : -1;
}

Sign Polynomial::compare(const RootOf& a, const RootOf& b, Asked& asked) {
    if (b.root.is_double()) return compare(a, b.root.low, asked);
    if (a.root.is_double()) return -compare(b, a.root.low, asked);
    if (filters::compare_numbers(a.root.high, b.root.low) <= 0) return -1;
    if (filters::compare_numbers(b.root.high, a.root.low) <= 0) return 1;
    // Two roots of one polynomial, each alone in its interval, are one where the first is in both.
    if (&a.polynomial == &b.polynomial && a.root.alone && b.root.alone) {
        if (compare(a, b.root.low, asked) < 0) return -1;
        return compare(a, b.root.high, asked) > 0 ? 1 : 0;
    }
    asked.exact = true;
    return a.polynomial.exact().compare(a.root, b.polynomial.exact(), b.root);
}

Sign compare(const RootOf& a, double x, Tally* tally) {
    SIGNUM_EXPECTS(filters::magnitude(x) <= std::numeric_limits<double>::max());
    Polynomial::Asked asked{tally};
    return Polynomial::compare(a, x, asked);
}
Sign compare(const RootOf& a, const RootOf& b, Tally* tally) {
    Polynomial::Asked asked{tally};
    return Polynomial::compare(a, b, asked);
}

}  // namespace signum::roots
