#include "filter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace signum::roots::filter {
namespace {

using filters::epsilon;
using filters::magnitude;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Exact: of a number that has a sign and is no denormal, whose exponent is wrong but harmless: it
/// only scales.
int exponent_of(double value) noexcept {
    return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7FF) - 1023;
}
double power_of_two(int exponent) noexcept {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

template <int N>
using Coefficients = std::array<Approximation, N + 1>;

/// t - origin.
Approximation since(double origin, double t) noexcept {
    return origin == 0.0 ? Approximation(t) : Approximation(t) - Approximation(origin);
}

/// p(t + s) in the powers of s, by Horner's rule again and again.
template <int N>
Coefficients<N> shifted(Coefficients<N> c, const Approximation& by) noexcept {
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = N; j-- > i;) c[j] = c[j] + by * c[j + 1];
    return c;
}

template <int N>
constexpr std::array<double, N + 1> binomials() noexcept {
    std::array<double, N + 1> row{};
    row[0] = 1.0;
    for (std::size_t n = 1; n <= N; ++n)
        for (std::size_t i = n; i > 0; --i) row[i] += row[i - 1];
    return row;
}

/// A number and the bound on its error, for one operation on both.
using Bounded = double __attribute__((vector_size(16)));

/// The roots after a double, piece by piece from the left.
template <int N>
class Bisection {
 public:
    /// c are the coefficients about the origin, q those of p(t + s) in the powers of s.
    /// known is the sign at t, 0 where it is not known.
    Bisection(const Coefficients<N>& c, double origin, double t, const Coefficients<N>& q,
              Sign known) noexcept
        : c_(c), origin_(origin), start_(t), q_(q), known_(known) {}

    /// Calls found(root) with one root after the other until that returns true. Whether it told all
    /// that was asked for, and for certain.
    template <class Callback>
    bool run(const Callback& found) noexcept {
        if (!set_up()) return false;
        int pieces = 1;
        for (int steps = 0; pieces > 0; ++steps) {
            Piece& piece = pieces_[static_cast<std::size_t>(pieces - 1)];
            const int changes = changes_of(piece);
            if (changes == 0) {
                --pieces;
                continue;
            }
            if (changes == 1) {
                const std::optional<Root> root = root_in(piece);
                if (!root) return false;
                if (found(*root)) return true;
                --pieces;
                continue;
            }
            if (steps == most_steps || pieces == most_pieces) return false;
            // The left half is to come first: on top.
            Piece& left = pieces_[static_cast<std::size_t>(pieces++)];
            if (!split<4>(piece, left) && !split<3>(piece, left) && !split<5>(piece, left))
                return false;
        }
        return true;
    }

 private:
    static constexpr int most_steps = 100;
    static constexpr int most_bits = 50;
    /// How often a piece may have been split, the pieces of all splits waiting at once.
    static constexpr int most_splits = 24;
    static constexpr int most_pieces = most_splits + 1;

    /// The Bernstein coefficients between two dyadic places of so many bits. The polynomial is not
    /// 0 at an end, but perhaps at 1. (One bound for all of them would be cheaper, but where roots
    /// are of different sizes so are these.)
    struct Piece {
        std::array<Bounded, N + 1> b;
        double low;
        double high;
        int bits;
        int splits;
    };

    /// The first piece is all of (0, 1). Where the polynomial is exactly 0 at the start, it is
    /// divided by s, which is above 0.
    bool set_up() noexcept {
        zeros_ = 0;
        Coefficients<N> q = q_;
        while (zeros_ <= N && q[0].is_zero()) {
            for (std::size_t i = 0; i < N; ++i) q[i] = q[i + 1];
            q[N] = Approximation();
            ++zeros_;
        }
        if (zeros_ > 0) known_ = 0;
        if (known_ == 0 && !q[0].has_sign()) return false;
        int last = N;
        while (last > 0 && !q[static_cast<std::size_t>(last)].has_sign()) --last;
        // The mean size of the roots, as far as one can know it.
        const double size = q[0].size() + q[0].error;
        exponent_ =
            last == 0
                ? 0
                : (exponent_of(size) - exponent_of(q[static_cast<std::size_t>(last)].value)) / last;
        static constexpr std::array<double, N + 1> shares = [] {
            std::array<double, N + 1> row = binomials<N>();
            for (double& x : row) x = 1.0 / x;
            return row;
        }();
        if (std::abs(exponent_) > 1000) return false;
        Piece& all = pieces_[0];
        // The first and the last coefficient become about 1.
        unit_ = exponent_of(size);
        for (int k = 0; k <= N; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const int exponent = k * exponent_ - unit_;
            if (std::abs(exponent) > 1000) return false;
            const double factor = power_of_two(exponent) * shares[i];
            const double value = q[i].value * factor;
            scaled_[i] = q[i].value * power_of_two(exponent);
            // The factor and the product are rounded, and then what split() says. Beside 2^-500
            // all underflows are nothing, also after means that take a part of 2^-288.
            all.b[i] = Bounded{value, q[i].error * factor +
                                          ((2 * N * most_splits + 3) * epsilon * magnitude(value) +
                                           (q[i].is_zero() ? 0.0 : 0x1p-500))};
        }
        all.low = 0.0;
        all.high = 1.0;
        all.bits = all.splits = 0;
        return known_ != 0 || has_sign(all.b[0]);
    }
    [[nodiscard]] static bool has_sign(const Bounded& b) noexcept { return has_sign(b[0], b[1]); }
    [[nodiscard]] static bool has_sign(double value, double error) noexcept {
        return magnitude(value) > Approximation::slack * error;
    }

    /// The sign at the lower end of a piece.
    [[nodiscard]] bool is_positive_at_low(const Piece& piece) const noexcept {
        return known_ != 0 && piece.low == 0.0 ? known_ > 0 : piece.b[0][0] > 0.0;
    }

    /// 0 and 1 where the number of changes is that, for whatever the coefficients are; 2 where it
    /// may be greater. A single unknown between different signs makes no difference.
    [[nodiscard]] int changes_of(const Piece& piece) const noexcept {
        int changes = 0;
        int unknown = 0;
        bool last = is_positive_at_low(piece);
        for (std::size_t i = 1; i <= N; ++i) {
            if (!has_sign(piece.b[i])) {
                // An exact 0 is no change and hides none.
                if (piece.b[i][0] != 0.0 || piece.b[i][1] != 0.0) ++unknown;
                continue;
            }
            const bool next = piece.b[i][0] > 0.0;
            if (unknown > 1 || (unknown == 1 && next == last)) return 2;
            unknown = 0;
            changes += static_cast<int>(next != last);
            last = next;
        }
        return unknown > 0 || changes > 1 ? 2 : changes;
    }

    /// De Casteljau's rule: in place of the whole the right part, and the left one apart. Weights
    /// are exact, so that w a + (1 - w) b errs by u(|wa| + |(1-w)b| + |sum|), at most by epsilon
    /// times the same mean of what their sizes may be. So errors, which begin with 2N epsilon of
    /// the sizes for every split that may come, go on as means of errors.
    template <int Eighths>
    static bool split(Piece& piece, Piece& left) noexcept {
        constexpr double of_next = Eighths / 8.0;
        constexpr double of_this = 1.0 - of_next;
        Piece right = piece;
        right.bits += Eighths == 4 ? 1 : 3;
        if (right.bits > most_bits || ++right.splits > most_splits) return false;
        left.b[0] = piece.b[0];
        for (std::size_t level = 1; level <= N; ++level) {
            for (std::size_t i = 0; i + level <= N; ++i)
                right.b[i] = of_this * right.b[i] + of_next * right.b[i + 1];
            left.b[level] = right.b[0];
        }
        if (!has_sign(right.b[0])) return false;
        left.bits = right.bits;
        left.splits = right.splits;
        left.low = piece.low;
        right.low = left.high = of_this * piece.low + of_next * piece.high;
        piece = right;
        return true;
    }

    /// s / 2^exponent_ where x is.
    [[nodiscard]] static double scaled(double x) noexcept { return x / (1.0 - x); }

    /// The only root in a piece: found in doubles by Halley's method, which proves nothing, and
    /// then enclosed between two doubles with different signs, which does.
    std::optional<Root> root_in(const Piece& piece) const noexcept {
        const bool from_start = piece.low == 0.0;
        const bool to_infinity = piece.high == 1.0;
        const double unit = power_of_two(exponent_);
        double below = from_start ? 0.0 : scaled(piece.low);
        double above = to_infinity ? infinity : scaled(piece.high);
        const double least = unit * below;
        const double most = unit * above;
        const bool positive = is_positive_at_low(piece);
        // Outside of this range the quotient's relative error would not be what it is.
        const auto usual = [](double s) { return 0x1p-1000 < s && s < 0x1p1000; };
        if ((!from_start && !usual(least)) || (!to_infinity && !usual(most))) return std::nullopt;

        // Where the control polygon crosses 0.
        std::size_t i = 0;
        while (i + 1 < N && (piece.b[i + 1][0] > 0.0) == positive) ++i;
        double part = piece.b[i][0] / (piece.b[i][0] - piece.b[i + 1][0]);
        if (!(part >= 0.0 && part <= 1.0)) part = 0.5;
        double z =
            scaled(piece.low + (piece.high - piece.low) * (static_cast<double>(i) + part) / N);
        double slope = 0.0;
        for (int steps = 0; steps < 60; ++steps) {
            double value = scaled_[N];
            double bend = 0.0;  // half of the second derivative
            slope = 0.0;
            for (std::size_t k = N; k-- > 0;) {
                bend = bend * z + slope;
                slope = slope * z + value;
                value = value * z + scaled_[k];
            }
            const double step = value * slope / (slope * slope - value * bend);
            // Errors are cubed: after this step no other is worth while.
            if (magnitude(step) < 0x1p-20 * z) {
                z -= step;
                break;
            }
            ((value > 0.0) == positive ? below : above) = z;
            z -= step;
            if (!(z > below && z < above))
                z = above == infinity ? 2.0 * below : below + 0.5 * (above - below);
        }

        double t = start_ + unit * z;
        slope *= power_of_two(unit_) / unit;
        // Away from the origin the coefficients about it are better known.
        if (start_ != origin_) {
            const double since_origin = t - origin_;
            slope = 0.0;
            double value = c_[N].value;
            for (std::size_t k = N; k-- > 0;) {
                slope = slope * since_origin + value;
                value = value * since_origin + c_[k].value;
            }
            const double step = value / slope;
            if (magnitude(step) < 0x1p-20 * unit * z) t -= step;
        }
        // An error at the root and a little farther.
        double since_origin = 1.0001 * magnitude(t - origin_);
        double error = error_at(since_origin);
        double width = 2.0 * error / magnitude(slope) + 0x1p-51 * magnitude(t);
        for (int trial = 0; trial < 6; ++trial, width *= 8.0) {
            double low = t - width;
            double high = t + width;
            if (!(low < high && magnitude(low) < 0x1p1000 && magnitude(high) < 0x1p1000))
                return std::nullopt;
            bool at_start = false;
            if (low <= start_ && from_start) {
                if (zeros_ > 0) return std::nullopt;
                low = start_;
                at_start = true;
            }
            // The differences and distances err by less than 4 ulps in all.
            if (!from_start && !(low - start_ > least * (1.0 + 8.0 * epsilon))) return std::nullopt;
            if (!(high > start_) ||
                (!to_infinity && !(high - start_ < most * (1.0 - 8.0 * epsilon))))
                return std::nullopt;
            if (!(magnitude(low - origin_) <= since_origin &&
                  magnitude(high - origin_) <= since_origin))
                error = error_at(since_origin =
                                     std::max(magnitude(low - origin_), magnitude(high - origin_)));
            const double at_high = value_at(high);
            if (!has_sign(at_high, error) || (at_high > 0.0) == positive) continue;
            if (!at_start) {
                const double at_low = value_at(low);
                if (!has_sign(at_low, error) || (at_low > 0.0) != positive) continue;
            }
            return Root{low, high, 1, 1, static_cast<std::int8_t>(positive ? -1 : 1), true};
        }
        return std::nullopt;
    }

    /// By Horner's rule at a double; off by slack · error_at() of its distance from the origin, or
    /// of a greater one, at most. In c_i s^i there are 2i + 1 roundings, and i of the distance.
    [[nodiscard]] double value_at(double t) const noexcept {
        const double s = t - origin_;
        double value = c_[N].value;
        for (std::size_t k = N; k-- > 0;) value = value * s + c_[k].value;
        return value;
    }
    [[nodiscard]] double error_at(double distance) const noexcept {
        double error = 0.0;
        for (std::size_t k = N + 1; k-- > 0;)
            error =
                error * distance +
                (c_[k].error + ((3 * N + 3) * epsilon * c_[k].size() + Approximation::underflow));
        return error;
    }

    Coefficients<N> c_;
    double origin_;
    double start_;
    Coefficients<N> q_;
    std::array<double, N + 1> scaled_;  ///< q in s / 2^exponent_, all about 1
    Sign known_;
    int zeros_ = 0;
    int exponent_ = 0;
    int unit_ = 0;  ///< scaled_ times 2^unit_ is q
    std::array<Piece, most_pieces + 1> pieces_;
};

template <int N>
Coefficients<N> coefficients_of(const Approximations& p) noexcept {
    Coefficients<N> c;
    for (std::size_t i = 0; i <= N; ++i) c[i] = p.c[i];
    return c;
}

/// Of a polynomial of degree N at most; p(t + s) is `better` known from another one, if there is
/// one.
template <int N = most_degree, class Callback>
bool roots_after(const Approximations& p, const Approximations* better, double t, Sign known,
                 const Callback& found) noexcept {
    if constexpr (N == 0) {
        return p.degree < 0 || p.c[0].has_sign();
    } else {
        if (p.degree < N) return roots_after<N - 1>(p, better, t, known, found);
        const Coefficients<N> c = coefficients_of<N>(p);
        const Coefficients<N> q = better != nullptr ? coefficients_of<N>(*better)
                                  : t == p.origin   ? c
                                                    : shifted<N>(c, since(p.origin, t));
        return Bisection<N>(c, p.origin, t, q, known).run(found);
    }
}

}  // namespace

filters::Verdict sign(const Approximation& value) noexcept {
    using filters::Verdict;
    if (!filters::environment_is_default()) return Verdict::uncertain();
    if (value.has_sign()) return Verdict::certain(value.value > 0.0 ? 1 : -1);
    return value.is_zero() ? Verdict::certain(0) : Verdict::uncertain();
}

Approximation value_since(const Approximations& p, const Approximation& s) noexcept {
    if (p.degree < 0) return Approximation();
    auto i = static_cast<std::size_t>(p.degree);
    Approximation value = p.c[i];
    while (i-- > 0) value = value * s + p.c[i];
    return value;
}

Approximation value_at(const Approximations& p, double t) noexcept {
    return value_since(p, since(p.origin, t));
}

filters::Verdict sign_between(const Approximations& p, double low, double high) noexcept {
    // The middle may err by an ulp, for which there is one in the radius.
    const double middle = 0.5 * low + 0.5 * high;
    const double radius = high - middle > middle - low ? high - middle : middle - low;
    const double more =
        4.0 * epsilon * (magnitude(low) + magnitude(high)) + Approximation::underflow;
    Approximation s = since(p.origin, middle);
    s.error += radius + more;
    return sign(value_since(p, s));
}

Found first_root(const Approximations& p, double t, Sign known,
                 const Approximations* shifted) noexcept {
    Found result{false, std::nullopt};
    if (!filters::environment_is_default()) return result;
    result.certain = roots_after(p, shifted, t, known, [&](const Root& root) {
        result.root = root;
        return true;
    });
    return result;
}

std::optional<RealRoots> real_roots(const Approximations& p) noexcept {
    if (!filters::environment_is_default() || p.origin != 0.0) return std::nullopt;
    RealRoots result;
    result.everywhere = p.degree < 0;
    if (p.degree <= 0) {
        if (p.degree == 0 && !p.c[0].has_sign()) return std::nullopt;
        return result;
    }
    // Those below 0 are those of p(-t) above 0, in the opposite order.
    Approximations reflected = p;
    for (std::size_t i = 1; i < reflected.c.size(); i += 2) reflected.c[i] = -reflected.c[i];
    std::array<Root, most_degree> below;
    int count = 0;
    const bool told = roots_after(reflected, nullptr, 0.0, 0, [&](const Root& root) {
        Root mirrored = root.of_negative();
        mirrored.low = -root.high;
        mirrored.high = -root.low;
        below[static_cast<std::size_t>(count++)] = mirrored;
        return false;
    });
    if (!told) return std::nullopt;
    while (count > 0)
        result.roots[static_cast<std::size_t>(result.count++)] =
            below[static_cast<std::size_t>(--count)];
    std::int8_t zeros = 0;
    while (p.c[static_cast<std::size_t>(zeros)].is_zero()) ++zeros;
    if (zeros > 0) {
        const bool positive = p.c[static_cast<std::size_t>(zeros)].value > 0.0;
        result.roots[static_cast<std::size_t>(result.count++)] =
            Root{0.0, 0.0, zeros, 1, static_cast<std::int8_t>(positive ? 1 : -1), false};
    }
    const bool all = roots_after(p, nullptr, 0.0, 0, [&](const Root& root) {
        result.roots[static_cast<std::size_t>(result.count++)] = root;
        return false;
    });
    if (!all) return std::nullopt;
    return result;
}

}  // namespace signum::roots::filter
