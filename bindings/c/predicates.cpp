/// The predicates of signum.h: each looks at what it is given, and asks the one of its metric.

#include <algorithm>
#include <span>

#include "../../exact/sign_of_sum.hpp"
#include "../../predicates/ccw.hpp"
#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/supremum.hpp"
#include "boundary.hpp"

namespace signum::c {
namespace {

[[nodiscard]] bool is_metric(signum_metric metric) noexcept {
    return metric >= SIGNUM_POWER && metric <= SIGNUM_SUPREMUM;
}

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
    if (predicate == nullptr || !(Taken<Parameters>::is_there(given) && ...)) return SIGNUM_NO_SIGN;
    return static_cast<int>(predicate(Taken<Parameters>::from(given)...));
}
/// That of a metric in a table; null where there is no such metric.
template <class Row, class Predicate>
[[nodiscard]] Predicate of(const Row (&table)[4], signum_metric metric,
                           Predicate Row::*column) noexcept {
    return is_metric(metric) ? table[metric].*column : nullptr;
}

/// The predicates of the plane, a row for every metric, in the order of the enumerators.
struct OfThePlane {
    bool (*exists)(const Site&, const Site&, const Site&) noexcept;
    Sign (*in_circle)(const Site&, const Site&, const Site&, const Site&) noexcept;
    Sign (*in_circle_infinite)(const Site&, const Site&, const Site&) noexcept;
    Sign (*in_circle_perturbed)(const Site&, const Site&, const Site&, const Site&,
                                const std::array<Index, 4>&) noexcept;
    Sign (*in_circle_infinite_perturbed)(const Site&, const Site&, const Site&,
                                         const std::array<Index, 3>&) noexcept;
    bool (*hidden)(const Site&, const Site&) noexcept;
    Sign (*nearer)(Point, const Site&, const Site&) noexcept;
};
constexpr OfThePlane of_the_plane[] = {
    {power::exists<Site>, power::in_circle<Site>, power::in_circle_infinite<Site>,
     power::in_circle_perturbed<Site>, power::in_circle_infinite_perturbed<Site>,
     power::hidden<Site>, power::nearer<Site>},
    {euclidean::exists, euclidean::in_circle, euclidean::in_circle_infinite,
     euclidean::in_circle_perturbed, euclidean::in_circle_infinite_perturbed, euclidean::hidden,
     euclidean::nearer},
    {manhattan::exists, manhattan::in_circle, manhattan::in_circle_infinite,
     manhattan::in_circle_perturbed, manhattan::in_circle_infinite_perturbed, manhattan::hidden,
     manhattan::nearer},
    {supremum::exists, supremum::in_circle, supremum::in_circle_infinite,
     supremum::in_circle_perturbed, supremum::in_circle_infinite_perturbed, supremum::hidden,
     supremum::nearer},
};

static_assert(std::size(of_the_plane) == all_metrics.size());

/// Those of space. Spheres that touch i, j, k, l; the sign of q in number n of them, which is
/// there; whether i hides q.
struct OfSpace {
    int (*spheres)(const Site3&, const Site3&, const Site3&, const Site3&) noexcept;
    Sign (*in_sphere)(const Site3&, const Site3&, const Site3&, const Site3&, const Site3&,
                      std::uint8_t n) noexcept;
    bool (*hidden)(const Site3& q, const Site3& i) noexcept;
};
template <auto spheres>
int count_of(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept {
    const rectangular::Spheres all = spheres(i, j, k, l);
    return all.infinitely_many ? SIGNUM_INFINITELY_MANY : all.count;
}
constexpr OfSpace of_space[] = {
    {[](const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept -> int {
         return ccw(i, j, k, l) > 0;
     },
     [](const Site3& i, const Site3& j, const Site3& k, const Site3& l, const Site3& q,
        std::uint8_t) noexcept { return power::in_sphere(i, j, k, l, q); },
     // Only where the centres agree and i weighs no less.
     [](const Site3& q, const Site3& i) noexcept {
         return filters::same_number(q.x, i.x) && filters::same_number(q.y, i.y) &&
                filters::same_number(q.z, i.z) &&
                power::nearer_decision(Point3{q.x, q.y, q.z}, q, i).sign <= 0;
     }},
    {[](const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept -> int {
         return euclidean::exists(i, j, k, l);
     },
     [](const Site3& i, const Site3& j, const Site3& k, const Site3& l, const Site3& q,
        std::uint8_t) noexcept { return euclidean::in_sphere(i, j, k, l, q); },
     euclidean::hidden<Site3>},
    {count_of<manhattan::spheres>, manhattan::in_sphere, manhattan::hidden<Site3>},
    {count_of<supremum::spheres>, supremum::in_sphere, supremum::hidden<Site3>},
};

constexpr auto ccw_of_the_plane = [](const Point& a, const Point& b, const Point& c) noexcept {
    return ccw(a, b, c);
};
constexpr auto ccw_of_space = [](const Point3& a, const Point3& b, const Point3& c,
                                 const Point3& d) noexcept { return ccw(a, b, c, d); };
constexpr auto nearer_in_space = [](const Point3& p, const Site3& a, const Site3& b) noexcept {
    return power::nearer_decision(p, a, b).sign;
};

}  // namespace
}  // namespace signum::c

using namespace signum;
using c::answer;
using c::of;
using c::of_space;
using c::of_the_plane;
using c::OfSpace;
using c::OfThePlane;

int signum_ccw(const double* a, const double* b, const double* c) {
    return answer(+c::ccw_of_the_plane, a, b, c);
}
int signum_exists(signum_metric metric, const double* i, const double* j, const double* k) {
    return answer(of(of_the_plane, metric, &OfThePlane::exists), i, j, k);
}
int signum_in_circle(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* q) {
    return answer(of(of_the_plane, metric, &OfThePlane::in_circle), i, j, k, q);
}
int signum_in_circle_points(const double* i, const double* j, const double* k, const double* q) {
    return answer(power::in_circle<Point>, i, j, k, q);
}
int signum_in_circle_weights(const double* i, const double* j, const double* k, const double* q) {
    return answer(power::in_circle<power::Site>, i, j, k, q);
}
int signum_in_circle_infinite(signum_metric metric, const double* a, const double* b,
                              const double* q) {
    return answer(of(of_the_plane, metric, &OfThePlane::in_circle_infinite), a, b, q);
}
int signum_in_circle_infinite_points(const double* a, const double* b, const double* q) {
    return answer(power::in_circle_infinite<Point>, a, b, q);
}
int signum_in_circle_infinite_weights(const double* a, const double* b, const double* q) {
    return answer(power::in_circle_infinite<power::Site>, a, b, q);
}
int signum_in_circle_perturbed(signum_metric metric, const double* i, const double* j,
                               const double* k, const double* q, const int32_t* ranks) {
    return answer(of(of_the_plane, metric, &OfThePlane::in_circle_perturbed), i, j, k, q, ranks);
}
int signum_in_circle_infinite_perturbed(signum_metric metric, const double* a, const double* b,
                                        const double* q, const int32_t* ranks) {
    return answer(of(of_the_plane, metric, &OfThePlane::in_circle_infinite_perturbed), a, b, q,
                  ranks);
}
int signum_hidden(signum_metric metric, const double* q, const double* i) {
    return answer(of(of_the_plane, metric, &OfThePlane::hidden), q, i);
}
int signum_hidden_weights(const double* q, const double* i) {
    return answer(power::hidden<power::Site>, q, i);
}
int signum_nearer(signum_metric metric, const double* p, const double* a, const double* b) {
    return answer(of(of_the_plane, metric, &OfThePlane::nearer), p, a, b);
}
int signum_nearer_weights(const double* p, const double* a, const double* b) {
    return answer(power::nearer<power::Site>, p, a, b);
}

int signum_ccw_space(const double* a, const double* b, const double* c, const double* d) {
    return answer(+c::ccw_of_space, a, b, c, d);
}
int signum_spheres(signum_metric metric, const double* i, const double* j, const double* k,
                   const double* l) {
    return answer(of(of_space, metric, &OfSpace::spheres), i, j, k, l);
}
int signum_in_sphere(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* l, const double* q, int n) {
    const int spheres = signum_spheres(metric, i, j, k, l);
    if (spheres == SIGNUM_INFINITELY_MANY || n < 0 || n >= spheres || !c::finite<4>(q))
        return SIGNUM_NO_SIGN;
    return of_space[metric].in_sphere(c::as<Site3>(i), c::as<Site3>(j), c::as<Site3>(k),
                                      c::as<Site3>(l), c::as<Site3>(q),
                                      static_cast<std::uint8_t>(n));
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
    return answer(of(of_space, metric, &OfSpace::hidden), q, i);
}
int signum_nearer_space(const double* p, const double* a, const double* b) {
    return answer(+c::nearer_in_space, p, a, b);
}

int signum_sign_of_sum(const double* terms, size_t count) {
    if (count == 0) return 0;
    if (terms == nullptr || count >= std::size_t{1} << 32) return SIGNUM_NO_SIGN;
    const std::span<const double> all(terms, count);
    if (!std::ranges::all_of(all, [](double term) { return term - term == 0.0; }))
        return SIGNUM_NO_SIGN;
    return sign_of_sum(all);
}
