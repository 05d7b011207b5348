// Highway compiles this file once for each set of instructions.
#if defined(SIGNUM_WITH_HIGHWAY)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "signum/predicates/batch/lanes.cpp"
// SSSE3 alone: processors older than those with SSE4, from 2006 and 2007.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS HWY_SSSE3
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#endif

#include "lanes.hpp"

#include <algorithm>
#include <utility>

#include "../ccw.hpp"
#include "../power/in_circle.hpp"

// What has two doubles a vector at least, and vectors of a size that the compiler knows.
#if defined(SIGNUM_WITH_HIGHWAY) && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && \
    HWY_HAVE_FLOAT64 && !HWY_HAVE_SCALABLE
HWY_BEFORE_NAMESPACE();
namespace signum::predicates::batch::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
constexpr Doubles doubles;
constexpr std::size_t lanes = hn::MaxLanes(Doubles());
static_assert(lanes <= 8, "answers of a vector are the bits of a byte");

/// A number of the formulas. Its operations are functions outside the struct, and not inlined
/// always: only so g++ 12 takes them for ones with the instructions of this pass, and lets formulas
/// call them that are compiled without. What the formulas are inlined into inlines them.
struct Number {
    hn::Vec<Doubles> v;

    Number() = default;
    Number(const hn::Vec<Doubles>& vector) noexcept : v(vector) {}
    explicit Number(double value) noexcept : v(hn::Set(doubles, value)) {}
};
inline Number operator+(const Number& a, const Number& b) noexcept {
    return a.v + b.v;
}
inline Number operator-(const Number& a, const Number& b) noexcept {
    return a.v - b.v;
}
inline Number operator*(const Number& a, const Number& b) noexcept {
    return a.v * b.v;
}
inline Number operator+(const Number& a, double b) noexcept {
    return a.v + hn::Set(doubles, b);
}
inline Number operator*(double a, const Number& b) noexcept {
    return hn::Set(doubles, a) * b.v;
}
inline Number magnitude(const Number& a) noexcept {
    return hn::Abs(a.v);
}

/// A site in every lane.
template <class S>
struct Sites;
template <>
struct Sites<Point> {
    Number x;
    Number y;

    explicit Sites(const double* first) noexcept { hn::LoadInterleaved2(doubles, first, x.v, y.v); }
};
template <>
struct Sites<Site> {
    Number x;
    Number y;
    Number r;

    explicit Sites(const double* first) noexcept {
        hn::LoadInterleaved3(doubles, first, x.v, y.v, r.v);
    }
};
template <>
struct Sites<power::Site> {
    Number x;
    Number y;
    Number w;

    explicit Sites(const double* first) noexcept {
        hn::LoadInterleaved3(doubles, first, x.v, y.v, w.v);
    }
};

struct Ccw {
    static constexpr std::size_t operands = 3;
    template <class S>
    static inline filters::Compared<Number> compared(const Sites<S>& a, const Sites<S>& b,
                                                     const Sites<S>& c) noexcept {
        return compared_ccw<Number>(a.x - c.x, a.y - c.y, b.x - c.x, b.y - c.y);
    }
};
struct InCircle {
    static constexpr std::size_t operands = 4;
    template <class S>
    static inline filters::Compared<Number> compared(const Sites<S>& i, const Sites<S>& j,
                                                     const Sites<S>& k,
                                                     const Sites<S>& q) noexcept {
        return power::compared_in_circle<Number>(power::row<Number>(i, q), power::row<Number>(j, q),
                                                 power::row<Number>(k, q));
    }
};

/// How many doubles ahead memory is asked for, a KiB: at the pace of a batch the processor does not
/// foresee it in time by itself.
constexpr std::size_t ahead = 128;

template <class Formula, class S>
std::size_t filter(const Questions<Formula::operands>& questions, std::int8_t* signs,
                   Ask<Formula::operands> ask) noexcept {
    constexpr std::size_t n = Formula::operands;
    const hn::Rebind<std::int32_t, Doubles> integers;
    const hn::Rebind<std::int8_t, Doubles> bytes;
    std::array<Copies<S>, n> copies;
    std::array<const double*, n> sites;
    std::size_t asked = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < questions.count; i += count) {
        // Whole vectors; what is less than one is the last part.
        count = questions.count - i < part_of_batch ? questions.count - i : part_of_batch;
        if (count > lanes) count -= count % lanes;
        for (std::size_t m = 0; m < n; ++m)
            sites[m] = array_of<S>(questions, m, i, count, lanes, copies[m]);
        // The lanes that the filter leaves open, a bit each.
        std::array<std::uint8_t, part_of_batch / lanes> open;
        unsigned any_open = 0;
        std::array<std::int8_t, lanes> last;
        std::int8_t* const results = count < lanes ? last.data() : signs + i;
        for (std::size_t k = 0; k < count; k += lanes) {
            for (std::size_t m = 0; m < n; ++m)
                for (std::size_t number = 0; number < numbers<S> * lanes; number += 8)
                    __builtin_prefetch(sites[m] + numbers<S> * k + number + ahead);
            const auto [value, bound] = [&]<std::size_t... m>(std::index_sequence<m...>) {
                return Formula::template compared<S>(Sites<S>(sites[m] + numbers<S> * k)...);
            }
            (std::make_index_sequence<n>());
            const auto decided = hn::Gt(hn::Abs(value.v), bound.v);
            std::uint8_t bits[8];
            hn::StoreMaskBits(doubles, hn::Not(decided), bits);
            open[k / lanes] = bits[0];
            any_open |= bits[0];
            const auto sign = hn::CopySign(hn::Set(doubles, 1.0), value.v);
            hn::StoreU(hn::DemoteTo(bytes, hn::DemoteTo(integers, sign)), bytes, results + k);
        }
        if (count < lanes) std::copy_n(last.data(), count, signs + i);
        if (any_open == 0) continue;
        for (std::size_t k = 0; k < count; ++k) {
            if ((open[k / lanes] >> k % lanes & 1) == 0) continue;
            signs[i + k] = ask(questions, i + k);
            ++asked;
        }
    }
    return asked;
}

inline Instructions instructions() noexcept {
    return {hwy::TargetName(HWY_TARGET),
            {filter<Ccw, Point>, filter<Ccw, Site>},
            {filter<InCircle, Point>, filter<InCircle, Site>, filter<InCircle, power::Site>}};
}

}  // namespace signum::predicates::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#define SIGNUM_HAS_LANES 1
#else
#define SIGNUM_HAS_LANES 0
#endif

#if !defined(SIGNUM_WITH_HIGHWAY) || HWY_ONCE
namespace signum::predicates::batch {

#if defined(SIGNUM_WITH_HIGHWAY) && defined(__x86_64__)
namespace {

// What Highway takes these sets for: set_macros-inl.h there, but for f16c, which every processor
// with AVX2 has. Its own function that tells is in a library, and that would be one more to link;
// all else that is used here stands in its headers.
[[maybe_unused]] bool has_sse4() noexcept {
    return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
           __builtin_cpu_supports("aes");
}
[[maybe_unused]] bool has_avx2() noexcept {
    return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
           __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
}
[[maybe_unused]] bool has_avx3() noexcept {
    return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}

}  // namespace
#endif

std::span<const Instructions> instructions() noexcept {
    static std::array<Instructions, 4> all;
    static const std::size_t count = [] {
        std::size_t next = 0;
#if defined(SIGNUM_WITH_HIGHWAY)
#if (HWY_TARGETS & HWY_AVX3) != 0 && HWY_STATIC_TARGET != HWY_AVX3
        if (has_avx3()) all[next++] = N_AVX3::instructions();
#endif
#if (HWY_TARGETS & HWY_AVX2) != 0 && HWY_STATIC_TARGET != HWY_AVX2
        if (has_avx2()) all[next++] = N_AVX2::instructions();
#endif
#if (HWY_TARGETS & HWY_SSE4) != 0 && HWY_STATIC_TARGET != HWY_SSE4
        if (has_sse4()) all[next++] = N_SSE4::instructions();
#endif
#endif
#if SIGNUM_HAS_LANES  // what the compiler was told of, the processor has
        all[next++] = HWY_NAMESPACE::instructions();
#endif
        return next;
    }();
    return {all.data(), count};
}

}  // namespace signum::predicates::batch
#endif
#undef SIGNUM_HAS_LANES
