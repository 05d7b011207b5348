// What C sees (parts/header.hpp): each function looks at what it is given.

namespace {

struct Given {
    const double* numbers;
    std::size_t size;
};
/// Whether none is null or has a number that is not finite.
[[gnu::noinline]] bool are_there(std::initializer_list<Given> all) noexcept {
    bool finite = true;
    for (const Given& each : all) {
        if (each.numbers == nullptr) return false;
        for (std::size_t k = 0; k < each.size; ++k)
            finite &= each.numbers[k] - each.numbers[k] == 0.0;
    }
    return finite;
}
template <class S>
struct Of;
template <>
struct Of<rooms::Point> {
    static constexpr std::size_t size = 2;
    static rooms::Point from(const double* n) noexcept { return {n[0], n[1]}; }
};
template <>
struct Of<rooms::Point3> {
    static constexpr std::size_t size = 3;
    static rooms::Point3 from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::Site> {
    static constexpr std::size_t size = 3;
    static rooms::Site from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::power::Site> {
    static constexpr std::size_t size = 3;
    static rooms::power::Site from(const double* n) noexcept { return {n[0], n[1], n[2]}; }
};
template <>
struct Of<rooms::Site3> {
    static constexpr std::size_t size = 4;
    static rooms::Site3 from(const double* n) noexcept { return {n[0], n[1], n[2], n[3]}; }
};
template <>
struct Of<rooms::power::Site3> {
    static constexpr std::size_t size = 4;
    static rooms::power::Site3 from(const double* n) noexcept { return {n[0], n[1], n[2], n[3]}; }
};

/// What a predicate of sites of the kinds S answers, or no sign where one cannot ask it.
template <class... S, class Predicate, class... Numbers>
int answer(const Predicate& predicate, const Numbers*... numbers) noexcept {
    if (!are_there({{numbers, Of<S>::size}...})) return SIGNUM_NO_SIGN;
    return static_cast<int>(predicate(Of<S>::from(numbers)...));
}

/// The same behind a filter, which numbers that are not finite leave uncertain.
template <class... S, class Predicate, class... Numbers>
[[gnu::cold, gnu::noinline]] int answer_behind(const Predicate& predicate,
                                               const Numbers*... numbers) noexcept {
    return answer<S...>(predicate, numbers...);
}
template <class... S, class Filter, class Predicate, class... Numbers>
[[gnu::always_inline]] inline int answer_filtered(const Filter& filter, const Predicate& predicate,
                                                  const Numbers*... numbers) noexcept {
    if (!((numbers != nullptr) && ...)) return SIGNUM_NO_SIGN;
    const rooms::filters::Verdict verdict = filter(Of<S>::from(numbers)...);
    if (verdict.is_certain()) return verdict.sign();
    return answer_behind<S...>(predicate, numbers...);
}

/// The answers for rows of two numbers, one after the other.
template <class Ask>
int answer_batch(std::initializer_list<const double*> rows, std::size_t count, int8_t* signs,
                 const Ask& ask) noexcept {
    if (count == 0) return 0;
    if (signs == nullptr) return SIGNUM_NO_SIGN;
    const double* at[4] = {};
    std::size_t operands = 0;
    for (const double* each : rows) {
        if (!are_there({{each, 2 * count}})) return SIGNUM_NO_SIGN;
        at[operands++] = each;
    }
    for (std::size_t m = 0; m < count; ++m) {
        signs[m] = static_cast<int8_t>(ask(at));
        for (std::size_t o = 0; o < operands; ++o) at[o] += 2;
    }
    return 0;
}

// The functions of a metric, by their names.
#define SIGNUM_IN_METRIC(metric, call)       \
    switch (metric) {                        \
        case SIGNUM_POWER: {                 \
            namespace in = rooms::power;     \
            return call;                     \
        }                                    \
        case SIGNUM_EUCLIDEAN: {             \
            namespace in = rooms::euclidean; \
            return call;                     \
        }                                    \
        case SIGNUM_MANHATTAN: {             \
            namespace in = rooms::manhattan; \
            return call;                     \
        }                                    \
        case SIGNUM_SUPREMUM: {              \
            namespace in = rooms::supremum;  \
            return call;                     \
        }                                    \
        default:                             \
            return SIGNUM_NO_SIGN;           \
    }

using rooms::predicates::Ccw;
using rooms::predicates::Ccw3;
using P = rooms::Point;
using S = rooms::Site;
using W = rooms::power::Site;
using P3 = rooms::Point3;
using S3 = rooms::Site3;
using W3 = rooms::power::Site3;

template <std::size_t n>
std::array<rooms::Index, n> ranks_from(const int32_t* ranks) noexcept {
    std::array<rooms::Index, n> result;
    for (std::size_t k = 0; k < n; ++k) result[k] = ranks[k];
    return result;
}

}  // namespace

extern "C" {

int signum_ccw(const double* a, const double* b, const double* c) {
    return answer_filtered<P, P, P>(
        [](const P& x, const P& y, const P& z) { return rooms::predicates::ccw_filter(x, y, z); },
        [](const P& x, const P& y, const P& z) {
            return Ccw::behind<rooms::Arithmetic::exact>(x, y, z).sign;
        },
        a, b, c);
}
int signum_exists(signum_metric metric, const double* i, const double* j, const double* k) {
    SIGNUM_IN_METRIC(
        metric,
        (answer<S, S, S>([](const S& x, const S& y, const S& z) { return in::exists(x, y, z); }, i,
                         j, k)))
}
int signum_in_circle(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* q) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S, S, S>([](const S& x, const S& y, const S& z,
                                            const S& t) { return in::in_circle(x, y, z, t); },
                                         i, j, k, q)))
}
int signum_in_circle_points(const double* i, const double* j, const double* k, const double* q) {
    return answer_filtered<P, P, P, P>(
        [](const P& x, const P& y, const P& z, const P& t) {
            return rooms::power::in_circle_filter(x, y, z, t);
        },
        [](const P& x, const P& y, const P& z, const P& t) {
            return rooms::power::InCircle::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        i, j, k, q);
}
int signum_in_circle_weights(const double* i, const double* j, const double* k, const double* q) {
    return answer_filtered<W, W, W, W>(
        [](const W& x, const W& y, const W& z, const W& t) {
            return rooms::power::in_circle_filter(x, y, z, t);
        },
        [](const W& x, const W& y, const W& z, const W& t) {
            return rooms::power::InCircle::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        i, j, k, q);
}
int signum_in_circle_infinite(signum_metric metric, const double* a, const double* b,
                              const double* q) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S, S>([](const S& x, const S& y,
                                         const S& z) { return in::in_circle_infinite(x, y, z); },
                                      a, b, q)))
}
int signum_in_circle_infinite_points(const double* a, const double* b, const double* q) {
    return answer<P, P, P>(rooms::power::in_circle_infinite<P>, a, b, q);
}
int signum_in_circle_infinite_weights(const double* a, const double* b, const double* q) {
    return answer<W, W, W>(rooms::power::in_circle_infinite<W>, a, b, q);
}
int signum_in_circle_perturbed(signum_metric metric, const double* i, const double* j,
                               const double* k, const double* q, const int32_t* ranks) {
    if (ranks == nullptr) return SIGNUM_NO_SIGN;
    SIGNUM_IN_METRIC(metric, (answer<S, S, S, S>(
                                 [&](const S& x, const S& y, const S& z, const S& t) {
                                     return in::in_circle_perturbed(x, y, z, t,
                                                                    ranks_from<4>(ranks));
                                 },
                                 i, j, k, q)))
}
int signum_in_circle_infinite_perturbed(signum_metric metric, const double* a, const double* b,
                                        const double* q, const int32_t* ranks) {
    if (ranks == nullptr) return SIGNUM_NO_SIGN;
    SIGNUM_IN_METRIC(metric, (answer<S, S, S>(
                                 [&](const S& x, const S& y, const S& z) {
                                     return in::in_circle_infinite_perturbed(x, y, z,
                                                                             ranks_from<3>(ranks));
                                 },
                                 a, b, q)))
}
int signum_hidden(signum_metric metric, const double* q, const double* i) {
    SIGNUM_IN_METRIC(metric,
                     (answer<S, S>([](const S& x, const S& y) { return in::hidden(x, y); }, q, i)))
}
int signum_hidden_weights(const double* q, const double* i) {
    return answer<W, W>(rooms::power::hidden<W>, q, i);
}
int signum_nearer(signum_metric metric, const double* p, const double* a, const double* b) {
    SIGNUM_IN_METRIC(
        metric,
        (answer<P, S, S>([](const P& x, const S& y, const S& z) { return in::nearer(x, y, z); }, p,
                         a, b)))
}
int signum_nearer_weights(const double* p, const double* a, const double* b) {
    return answer<P, W, W>(rooms::power::nearer<W>, p, a, b);
}

int signum_ccw_space(const double* a, const double* b, const double* c, const double* d) {
    return answer_filtered<P3, P3, P3, P3>(
        [](const P3& x, const P3& y, const P3& z, const P3& t) {
            return rooms::predicates::ccw_filter(x, y, z, t);
        },
        [](const P3& x, const P3& y, const P3& z, const P3& t) {
            return Ccw3::behind<rooms::Arithmetic::exact>(x, y, z, t).sign;
        },
        a, b, c, d);
}
int signum_in_sphere_points(const double* i, const double* j, const double* k, const double* l,
                            const double* q) {
    return answer_filtered<P3, P3, P3, P3, P3>(
        [](const P3& x, const P3& y, const P3& z, const P3& t, const P3& u) {
            return rooms::power::in_sphere_filter(x, y, z, t, u);
        },
        [](const P3& x, const P3& y, const P3& z, const P3& t, const P3& u) {
            return rooms::power::InSphere::behind<rooms::Arithmetic::exact>(x, y, z, t, u).sign;
        },
        i, j, k, l, q);
}
int signum_in_sphere_weights(const double* i, const double* j, const double* k, const double* l,
                             const double* q) {
    return answer_filtered<W3, W3, W3, W3, W3>(
        [](const W3& x, const W3& y, const W3& z, const W3& t, const W3& u) {
            return rooms::power::in_sphere_filter(x, y, z, t, u);
        },
        [](const W3& x, const W3& y, const W3& z, const W3& t, const W3& u) {
            return rooms::power::InSphere::behind<rooms::Arithmetic::exact>(x, y, z, t, u).sign;
        },
        i, j, k, l, q);
}
int signum_nearer_space(const double* p, const double* a, const double* b) {
    return answer<P3, S3, S3>(
        [](const P3& x, const S3& y, const S3& z) {
            return rooms::power::nearer_decision(x, y, z).sign;
        },
        p, a, b);
}

int signum_ccw_batch(const double* a, const double* b, const double* c, size_t count,
                     int8_t* signs) {
    return answer_batch({a, b, c}, count, signs,
                        [](const double* const* p) { return signum_ccw(p[0], p[1], p[2]); });
}
int signum_in_circle_points_batch(const double* i, const double* j, const double* k,
                                  const double* q, size_t count, int8_t* signs) {
    return answer_batch({i, j, k, q}, count, signs, [](const double* const* p) {
        return signum_in_circle_points(p[0], p[1], p[2], p[3]);
    });
}

int signum_sign_of_sum(const double* terms, size_t count) {
    if (count == 0) return 0;
    if (terms == nullptr || static_cast<std::uint64_t>(count) >> 32 != 0) return SIGNUM_NO_SIGN;
    for (std::size_t k = 0; k < count; ++k)
        if (!(terms[k] - terms[k] == 0.0)) return SIGNUM_NO_SIGN;
    return rooms::sign_of_sum({terms, count});
}

}  // extern "C"
