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

// What three or four numbers are, by the name of the type that is asked for.
void take(const double* numbers, Point& point) noexcept {
    point = {numbers[0], numbers[1]};
}
void take(const double* numbers, Point3& point) noexcept {
    point = {numbers[0], numbers[1], numbers[2]};
}
void take(const double* numbers, Site& site) noexcept {
    site = {numbers[0], numbers[1], numbers[2]};
}
void take(const double* numbers, Site3& site) noexcept {
    site = {numbers[0], numbers[1], numbers[2], numbers[3]};
}
void take(const double* numbers, power::Site& site) noexcept {
    site = {numbers[0], numbers[1], numbers[2]};
}
void take(const double* numbers, power::Site3& site) noexcept {
    site = {numbers[0], numbers[1], numbers[2], numbers[3]};
}
template <class S>
[[nodiscard]] S as(const double* numbers) noexcept {
    S site;
    take(numbers, site);
    return site;
}
/// Sites are nothing but their numbers.
template <class S, class... Numbers>
[[nodiscard]] bool are(const Numbers*... numbers) noexcept {
    return (finite<sizeof(S) / sizeof(double)>(numbers) && ...);
}

/// Asks predicate(as<S>(numbers)...), if they are finite.
template <class S, class Predicate, class... Numbers>
[[nodiscard]] int answer(Predicate&& predicate, const Numbers*... numbers) noexcept {
    if (!are<S>(numbers...)) return SIGNUM_NO_SIGN;
    return static_cast<int>(predicate(as<S>(numbers)...));
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

template <std::size_t n>
[[nodiscard]] std::array<Index, n> ranks_from(const std::int32_t* ranks) noexcept {
    std::array<Index, n> copy{};
    std::copy(ranks, ranks + n, copy.begin());
    return copy;
}

}  // namespace
}  // namespace signum::c

using namespace signum;
using c::answer;
using c::are;
using c::as;
using c::is_metric;
using c::of_space;
using c::of_the_plane;

int signum_ccw(const double* a, const double* b, const double* c) {
    return answer<Point>([](auto... s) { return ccw(s...); }, a, b, c);
}
int signum_exists(signum_metric metric, const double* i, const double* j, const double* k) {
    return is_metric(metric) ? answer<Site>(of_the_plane[metric].exists, i, j, k) : SIGNUM_NO_SIGN;
}
int signum_in_circle(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* q) {
    return is_metric(metric) ? answer<Site>(of_the_plane[metric].in_circle, i, j, k, q)
                             : SIGNUM_NO_SIGN;
}
int signum_in_circle_points(const double* i, const double* j, const double* k, const double* q) {
    return answer<Point>(power::in_circle<Point>, i, j, k, q);
}
int signum_in_circle_weights(const double* i, const double* j, const double* k, const double* q) {
    return answer<power::Site>(power::in_circle<power::Site>, i, j, k, q);
}
int signum_in_circle_infinite(signum_metric metric, const double* a, const double* b,
                              const double* q) {
    return is_metric(metric) ? answer<Site>(of_the_plane[metric].in_circle_infinite, a, b, q)
                             : SIGNUM_NO_SIGN;
}
int signum_in_circle_infinite_points(const double* a, const double* b, const double* q) {
    return answer<Point>(power::in_circle_infinite<Point>, a, b, q);
}
int signum_in_circle_infinite_weights(const double* a, const double* b, const double* q) {
    return answer<power::Site>(power::in_circle_infinite<power::Site>, a, b, q);
}
int signum_in_circle_perturbed(signum_metric metric, const double* i, const double* j,
                               const double* k, const double* q, const int32_t* ranks) {
    if (!is_metric(metric) || ranks == nullptr || !are<Site>(i, j, k, q)) return SIGNUM_NO_SIGN;
    return of_the_plane[metric].in_circle_perturbed(as<Site>(i), as<Site>(j), as<Site>(k),
                                                    as<Site>(q), c::ranks_from<4>(ranks));
}
int signum_in_circle_infinite_perturbed(signum_metric metric, const double* a, const double* b,
                                        const double* q, const int32_t* ranks) {
    if (!is_metric(metric) || ranks == nullptr || !are<Site>(a, b, q)) return SIGNUM_NO_SIGN;
    return of_the_plane[metric].in_circle_infinite_perturbed(as<Site>(a), as<Site>(b), as<Site>(q),
                                                             c::ranks_from<3>(ranks));
}
int signum_hidden(signum_metric metric, const double* q, const double* i) {
    return is_metric(metric) ? answer<Site>(of_the_plane[metric].hidden, q, i) : SIGNUM_NO_SIGN;
}
int signum_hidden_weights(const double* q, const double* i) {
    return answer<power::Site>(power::hidden<power::Site>, q, i);
}
int signum_nearer(signum_metric metric, const double* p, const double* a, const double* b) {
    if (!is_metric(metric) || !are<Point>(p) || !are<Site>(a, b)) return SIGNUM_NO_SIGN;
    return of_the_plane[metric].nearer(as<Point>(p), as<Site>(a), as<Site>(b));
}
int signum_nearer_weights(const double* p, const double* a, const double* b) {
    if (!are<Point>(p) || !are<power::Site>(a, b)) return SIGNUM_NO_SIGN;
    return power::nearer(as<Point>(p), as<power::Site>(a), as<power::Site>(b));
}

int signum_ccw_space(const double* a, const double* b, const double* c, const double* d) {
    return answer<Point3>([](auto... s) { return ccw(s...); }, a, b, c, d);
}
int signum_spheres(signum_metric metric, const double* i, const double* j, const double* k,
                   const double* l) {
    return is_metric(metric) ? answer<Site3>(of_space[metric].spheres, i, j, k, l) : SIGNUM_NO_SIGN;
}
int signum_in_sphere(signum_metric metric, const double* i, const double* j, const double* k,
                     const double* l, const double* q, int n) {
    const int spheres = signum_spheres(metric, i, j, k, l);
    if (spheres == SIGNUM_INFINITELY_MANY || n < 0 || n >= spheres || !are<Site3>(q))
        return SIGNUM_NO_SIGN;
    return of_space[metric].in_sphere(as<Site3>(i), as<Site3>(j), as<Site3>(k), as<Site3>(l),
                                      as<Site3>(q), static_cast<std::uint8_t>(n));
}
int signum_in_sphere_points(const double* i, const double* j, const double* k, const double* l,
                            const double* q) {
    return answer<Point3>(power::in_sphere<Point3>, i, j, k, l, q);
}
int signum_in_sphere_weights(const double* i, const double* j, const double* k, const double* l,
                             const double* q) {
    return answer<power::Site3>(power::in_sphere<power::Site3>, i, j, k, l, q);
}
int signum_hidden_space(signum_metric metric, const double* q, const double* i) {
    return is_metric(metric) ? answer<Site3>(of_space[metric].hidden, q, i) : SIGNUM_NO_SIGN;
}
int signum_nearer_space(const double* p, const double* a, const double* b) {
    if (!are<Point3>(p) || !are<Site3>(a, b)) return SIGNUM_NO_SIGN;
    return power::nearer_decision(as<Point3>(p), as<Site3>(a), as<Site3>(b)).sign;
}

int signum_sign_of_sum(const double* terms, size_t count) {
    if (count == 0) return 0;
    if (terms == nullptr || count >= std::size_t{1} << 32) return SIGNUM_NO_SIGN;
    const std::span<const double> all(terms, count);
    if (!std::ranges::all_of(all, [](double term) { return term - term == 0.0; }))
        return SIGNUM_NO_SIGN;
    return sign_of_sum(all);
}
