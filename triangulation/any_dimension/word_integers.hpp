#pragma once
/// Signs of determinants of space in integers of as many words as they need, for the judge: in a
/// place between the filters and dyadic numbers, of which it does not share an operation. For
/// sources only.
///
/// The sites' numbers are multiples of a power of two, the unit, and of a few words where they are
/// not of too different sizes: then so are offsets, minors and heights, of more words each, and
/// nothing is rounded, carried in an exponent or allocated. Whoever asks about sites on a rounded
/// sphere asks mostly here.
///
/// Laws:
///  1. every operation is exact: a product has the words of both factors, and who adds has counted;
///  2. no predicate of a construction computes in them.
/// The count, of numbers below 2^(64 w - 3) in units, for w words: an offset is below 2^(64 w - 2),
/// a minor of two rows below 2^(128 w - 3), of three below 2^(192 w - 3); a height below 3
/// 2^(128 w - 4) + 2^(128 w - 4), for a weight is below 2^(128 w - 5) in units squared and a
/// difference of squares of radii below 2^(128 w - 5), too; the determinant of four terms, each
/// below 2^(320 w - 5), below 2^(320 w - 3): a bit for the sign is left everywhere.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "../../core/sign.hpp"
#include "../../core/site.hpp"

namespace signum::any_dimension {

/// In two's complement, the lowest word first.
template <std::size_t n>
struct Words {
    std::array<std::uint64_t, n> word{};

    [[nodiscard]] bool is_negative() const noexcept { return (word[n - 1] >> 63) != 0; }
    [[nodiscard]] Sign sign() const noexcept {
        if (is_negative()) return -1;
        for (const std::uint64_t each : word)
            if (each != 0) return 1;
        return 0;
    }

    friend Words operator+(Words a, const Words& b) noexcept {
        add(a.word.data(), b.word.data(), n);
        return a;
    }
    friend Words operator-(Words a, const Words& b) noexcept {
        subtract(a.word.data(), b.word.data(), n);
        return a;
    }
    template <std::size_t m>
    friend Words<n + m> operator*(const Words& a, const Words<m>& b) noexcept {
        Words<n + m> result;
        for (std::size_t i = 0; i < n; ++i) {
            std::uint64_t carry = 0;
            for (std::size_t k = 0; k < m; ++k) {
                const auto sum =
                    static_cast<Double>(a.word[i]) * b.word[k] + result.word[i + k] + carry;
                result.word[i + k] = static_cast<std::uint64_t>(sum);
                carry = static_cast<std::uint64_t>(sum >> 64);
            }
            result.word[i + m] = carry;
        }
        // As numbers without a sign a negative factor is too great by a power of two.
        if (a.is_negative()) subtract(result.word.data() + n, b.word.data(), m);
        if (b.is_negative()) subtract(result.word.data() + m, a.word.data(), n);
        return result;
    }

 private:
    using Double = unsigned __int128;

    static void add(std::uint64_t* to, const std::uint64_t* from, std::size_t count) noexcept {
        std::uint64_t carry = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto sum = static_cast<Double>(to[k]) + from[k] + carry;
            to[k] = static_cast<std::uint64_t>(sum);
            carry = static_cast<std::uint64_t>(sum >> 64);
        }
    }
    static void subtract(std::uint64_t* to, const std::uint64_t* from, std::size_t count) noexcept {
        std::uint64_t borrow = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const auto difference = static_cast<Double>(to[k]) - from[k] - borrow;
            to[k] = static_cast<std::uint64_t>(difference);
            borrow = static_cast<std::uint64_t>(difference >> 64) & 1;
        }
    }
};

/// The exponents of a number's lowest bit, and of the power of two above it. Of 0 none.
class Bits {
 public:
    void take(double number, int divided_by = 1) noexcept {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        const std::uint64_t fraction = bits & 0xF'FFFF'FFFF'FFFF;
        const auto exponent = static_cast<int>(bits >> 52 & 0x7FF);
        if (exponent == 0 && fraction == 0) return;
        const std::uint64_t significand = exponent == 0 ? fraction : fraction | 1ULL << 52;
        const int last = (exponent == 0 ? -1074 : exponent - 1075);
        // Rounded down and up.
        const int low = last + std::countr_zero(significand);
        const int high = last + static_cast<int>(std::bit_width(significand));
        lowest = std::min(lowest, divided_by == 1 ? low : (low - (low & 1)) / 2);
        highest = std::max(highest, divided_by == 1 ? high : (high + (high & 1)) / 2);
    }
    /// Whether all numbers are below 2^(64 words - 3) times the unit.
    [[nodiscard]] bool fit_in(std::size_t words) const noexcept {
        return highest - lowest <= static_cast<int>(64 * words) - 3;
    }
    [[nodiscard]] bool is_none() const noexcept { return highest < lowest; }

    int lowest = 4000;
    int highest = -4000;
};

/// A number in units of 2^unit, of which it is a multiple that fits.
template <std::size_t n>
[[nodiscard]] Words<n> words_of(double number, int unit) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    std::uint64_t significand = bits & 0xF'FFFF'FFFF'FFFF;
    const auto exponent = static_cast<int>(bits >> 52 & 0x7FF);
    Words<n> result;
    if (exponent == 0 && significand == 0) return result;
    if (exponent != 0) significand |= 1ULL << 52;
    int shift = (exponent == 0 ? -1074 : exponent - 1075) - unit;
    if (shift < 0) {
        significand >>= -shift;
        shift = 0;
    }
    const auto place = static_cast<std::size_t>(shift / 64);
    const int within = shift % 64;
    result.word[place] = significand << within;
    if (within > 11 && place + 1 < n) result.word[place + 1] = significand >> (64 - within);
    return (bits >> 63) != 0 ? Words<n>() - result : result;
}

/// What `site` has above or below another one, in units.
template <std::size_t w>
struct WordRow {
    std::array<Words<w>, 3> offset;
    Words<2 * w> height;
};
template <std::size_t w>
using WordMatrix = std::array<std::array<Words<w>, 3>, 3>;

template <std::size_t w>
[[nodiscard]] Words<3 * w> word_determinant(const std::array<Words<w>, 3>& a,
                                            const std::array<Words<w>, 3>& b,
                                            const std::array<Words<w>, 3>& c) noexcept {
    return (b[1] * c[2] - b[2] * c[1]) * a[0] + (b[2] * c[0] - b[0] * c[2]) * a[1] +
           (b[0] * c[1] - b[1] * c[0]) * a[2];
}

template <std::size_t w, class S>
[[nodiscard]] std::array<Words<w>, 3> word_centre(const S& s, int unit) noexcept {
    return {words_of<w>(s.x, unit), words_of<w>(s.y, unit), words_of<w>(s.z, unit)};
}
template <std::size_t w>
[[nodiscard]] std::array<Words<w>, 3> operator-(const std::array<Words<w>, 3>& a,
                                                const std::array<Words<w>, 3>& b) noexcept {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// det[b - a, c - a, d - a].
template <std::size_t w, class S>
[[nodiscard]] Sign orientation_in_words(const S& a, const S& b, const S& c, const S& d,
                                        int unit) noexcept {
    const auto origin = word_centre<w>(a, unit);
    return word_determinant<w>(word_centre<w>(b, unit) - origin, word_centre<w>(c, unit) - origin,
                               word_centre<w>(d, unit) - origin)
        .sign();
}
/// det[v_i - q, |v_i - q|² - (w_i - w_q)].
template <std::size_t w, class S>
[[nodiscard]] Sign in_sphere_in_words(const std::array<S, 4>& v, const S& q, int unit) noexcept {
    const auto origin = word_centre<w>(q, unit);
    std::array<WordRow<w>, 4> rows;
    for (std::size_t i = 0; i < 4; ++i) {
        auto& [offset, height] = rows[i];
        offset = word_centre<w>(v[i], unit) - origin;
        height = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
        if constexpr (requires { q.w; }) {
            height = height - (words_of<2 * w>(v[i].w, 2 * unit) - words_of<2 * w>(q.w, 2 * unit));
        } else if constexpr (requires { q.r; }) {
            const Words<w> r = words_of<w>(v[i].r, unit), of_q = words_of<w>(q.r, unit);
            height = height - (r * r - of_q * of_q);
        }
    }
    const auto minor = [&rows](std::size_t i, std::size_t k, std::size_t l) {
        return word_determinant<w>(rows[i].offset, rows[k].offset, rows[l].offset);
    };
    return ((minor(0, 1, 2) * rows[3].height - minor(0, 1, 3) * rows[2].height) +
            (minor(0, 2, 3) * rows[1].height - minor(1, 2, 3) * rows[0].height))
        .sign();
}

/// Both where the numbers fit; otherwise nothing.
template <class S>
[[nodiscard]] std::optional<Sign> orientation_in_words(const S& a, const S& b, const S& c,
                                                       const S& d) noexcept {
    Bits bits;
    for (const S* s : {&a, &b, &c, &d})
        for (const double x : {s->x, s->y, s->z}) bits.take(x);
    if (bits.is_none()) return 0;
    if (bits.fit_in(1)) return orientation_in_words<1>(a, b, c, d, bits.lowest);
    if (bits.fit_in(2)) return orientation_in_words<2>(a, b, c, d, bits.lowest);
    return {};
}
template <class S>
[[nodiscard]] std::optional<Sign> in_sphere_in_words(const std::array<S, 4>& v,
                                                     const S& q) noexcept {
    Bits bits;
    for (const S* s : {&v[0], &v[1], &v[2], &v[3], &q}) {
        for (const double x : {s->x, s->y, s->z}) bits.take(x);
        if constexpr (requires { s->w; })
            bits.take(s->w, 2);
        else if constexpr (requires { s->r; })
            bits.take(s->r);
    }
    if (bits.is_none()) return 0;
    if (bits.fit_in(1)) return in_sphere_in_words<1>(v, q, bits.lowest);
    if (bits.fit_in(2)) return in_sphere_in_words<2>(v, q, bits.lowest);
    return {};
}

}  // namespace signum::any_dimension
