/// The predicates of signum.h: each looks at what it is given, and asks the one of its metric.

#include <algorithm>
#include <array>
#include <span>

#include "../../exact/sign_of_sum.hpp"
#include "../../predicates/batch.hpp"
#include "../../triangulation/kernels/predicates_of.hpp"
#include "boundary.hpp"

namespace signum::c {
namespace {

/// A parameter of a predicate, made of what C has in its place: sites of their numbers, ranks of
/// as many integers; a place that is null, or a number that is not finite, is not to be asked.
template <class Parameter>
struct Taken {
    using S = std::remove_cvref_t<Parameter>;
    static bool is_there(const double* numbers) noexcept {
        return finite<sizeof(S) / sizeof(double)>(numbers);
    }
    static S from(const double* numbers) noexcept { return as<S>(numbers); }
};
template <std::size_t n>
struct Taken<const std::array<Index, n>&> {
    static bool is_there(const std::int32_t* ranks) noexcept { return ranks != nullptr; }
    static std::array<Index, n> from(const std::int32_t* ranks) noexcept {
        return std::to_array(*reinterpret_cast<const Index(*)[n]>(ranks));
    }
};

/// What the predicate answers, or no sign where one cannot ask it.
template <class Answer, class... Parameters, class... Given>
[[nodiscard]] int answer(Answer (*predicate)(Parameters...) noexcept,
                         const Given*... given) noexcept {
    if (!(Taken<Parameters>::is_there(given) && ...)) return SIGNUM_NO_SIGN;
    return static_cast<int>(predicate(Taken<Parameters>::from(given)...));
}

/// What ask(predicates) answers of a metric's, or no sign where there is no such metric.
template <class Ask>
[[nodiscard]] int in_metric(signum_metric metric, const Ask& ask) noexcept {
    if (static_cast<std::size_t>(metric) >= all_metrics.size()) return SIGNUM_NO_SIGN;
    return with_metric(static_cast<Metric>(metric),
                       [&]<class M>(M) -> int { return ask(triangulation::PredicatesOf<M>{}); });
}
static_assert(triangulation::infinitely_many == SIGNUM_INFINITELY_MANY);

constexpr auto ccw_of_the_plane = [](const Point& a, const Point& b, const Point& c) noexcept {
    return ccw(a, b, c);
};
constexpr auto ccw_of_space = [](const Point3& a, const Point3& b, const Point3& c,
                                 const Point3& d) noexcept { return ccw(a, b, c, d); };
constexpr auto nearer_in_space = [](const Point3& p, const Site3& a, const Site3& b) noexcept {
    return power::nearer_decision(p, a, b).sign;
};

[[nodiscard]] bool are_finite(std::span<const double> numbers) noexcept {
    return std::ranges::all_of(numbers, [](double number) { return number - number == 0.0; });
}

/// Of rows of two numbers.
template <std::size_t n, class Ask>
[[nodiscard]] int answer_batch(const Ask& ask, const std::array<const double*, n>& rows,
                               std::size_t count, std::int8_t* signs) noexcept {
    if (count == 0) return 0;
    if (signs == nullptr) return SIGNUM_NO_SIGN;
    std::array<StridedSites, n> sites;
    for (std::size_t m = 0; m < n; ++m) {
        if (rows[m] == nullptr || !are_finite({rows[m], 2 * count})) return SIGNUM_NO_SIGN;
        sites[m] = StridedSites(std::span(reinterpret_cast<const Point*>(rows[m]), count));
    }
    ask(sites, {signs, count});
    return 0;
}

}  // namespace
}  // namespace signum::c

using namespace signum;
using c::answer;
using c::in_metric;

int signum_ccw(const double* a, const double* b, const double* c) {
    return answer(+c::ccw_of_the_plane, a, b, c);
}
int signum_exists(signum_metric metric, const double* i, const double* j, const double* k) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::exists, i, j, k); });
}
int signum_in_circle(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* q) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::in_circle, i, j, k, q); });
}
int signum_in_circle_points(const double* i, const double* j, const double* k, const double* q) {
    return answer(power::in_circle<Point>, i, j, k, q);
}
int signum_in_circle_weights(const double* i, const double* j, const double* k, const double* q) {
    return answer(power::in_circle<power::Site>, i, j, k, q);
}
int signum_in_circle_infinite(signum_metric metric, const double* a, const double* b,
                              const double* q) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::in_circle_infinite, a, b, q); });
}
int signum_in_circle_infinite_points(const double* a, const double* b, const double* q) {
    return answer(power::in_circle_infinite<Point>, a, b, q);
}
int signum_in_circle_infinite_weights(const double* a, const double* b, const double* q) {
    return answer(power::in_circle_infinite<power::Site>, a, b, q);
}
int signum_in_circle_perturbed(signum_metric metric, const double* i, const double* j,
                               const double* k, const double* q, const int32_t* ranks) {
    return in_metric(metric,
                     [&]<class P>(P) { return answer(P::in_circle_perturbed, i, j, k, q, ranks); });
}
int signum_in_circle_infinite_perturbed(signum_metric metric, const double* a, const double* b,
                                        const double* q, const int32_t* ranks) {
    return in_metric(metric, [&]<class P>(P) {
        return answer(P::in_circle_infinite_perturbed, a, b, q, ranks);
    });
}
int signum_hidden(signum_metric metric, const double* q, const double* i) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::hidden, q, i); });
}
int signum_hidden_weights(const double* q, const double* i) {
    return answer(power::hidden<power::Site>, q, i);
}
int signum_nearer(signum_metric metric, const double* p, const double* a, const double* b) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::nearer, p, a, b); });
}
int signum_nearer_weights(const double* p, const double* a, const double* b) {
    return answer(power::nearer<power::Site>, p, a, b);
}

int signum_ccw_space(const double* a, const double* b, const double* c, const double* d) {
    return answer(+c::ccw_of_space, a, b, c, d);
}
int signum_spheres(signum_metric metric, const double* i, const double* j, const double* k,
                   const double* l) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::InSpace::spheres, i, j, k, l); });
}
int signum_in_sphere(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* l, const double* q, int n) {
    const int spheres = signum_spheres(metric, i, j, k, l);
    if (spheres == SIGNUM_INFINITELY_MANY || n < 0 || n >= spheres || !c::finite<4>(q))
        return SIGNUM_NO_SIGN;
    return in_metric(metric, [&]<class P>(P) {
        return P::InSpace::in_sphere_decision(c::as<Site3>(i), c::as<Site3>(j), c::as<Site3>(k),
                                              c::as<Site3>(l), c::as<Site3>(q),
                                              static_cast<std::uint8_t>(n))
            .sign;
    });
}
int signum_in_sphere_points(const double* i, const double* j, const double* k, const double* l,
                            const double* q) {
    return answer(power::in_sphere<Point3>, i, j, k, l, q);
}
int signum_in_sphere_weights(const double* i, const double* j, const double* k, const double* l,
                             const double* q) {
    return answer(power::in_sphere<power::Site3>, i, j, k, l, q);
}
int signum_hidden_space(signum_metric metric, const double* q, const double* i) {
    return in_metric(metric, [&]<class P>(P) { return answer(P::InSpace::hidden, q, i); });
}
int signum_nearer_space(const double* p, const double* a, const double* b) {
    return answer(+c::nearer_in_space, p, a, b);
}

int signum_ccw_batch(const double* a, const double* b, const double* c, size_t count,
                     int8_t* signs) {
    return c::answer_batch(
        [](const auto& sites, std::span<std::int8_t> to) {
            ccw_batch(sites[0], sites[1], sites[2], to);
        },
        std::array{a, b, c}, count, signs);
}
int signum_in_circle_points_batch(const double* i, const double* j, const double* k,
                                  const double* q, size_t count, int8_t* signs) {
    return c::answer_batch(
        [](const auto& sites, std::span<std::int8_t> to) {
            power::in_circle_batch(sites[0], sites[1], sites[2], sites[3], to);
        },
        std::array{i, j, k, q}, count, signs);
}

int signum_sign_of_sum(const double* terms, size_t count) {
    if (count == 0) return 0;
    if (terms == nullptr || count >= std::size_t{1} << 32) return SIGNUM_NO_SIGN;
    const std::span<const double> all(terms, count);
    if (!c::are_finite(all)) return SIGNUM_NO_SIGN;
    return sign_of_sum(all);
}
