#include "euclidean.hpp"

#include "../../exact/floating_environment.hpp"
#include "ball_filter.hpp"
#include "ball_numbers.hpp"
#include "in_sphere.hpp"

namespace signum::euclidean {
namespace balls {
namespace {

[[nodiscard]] Ball<2, double> ball(const Site& s) noexcept {
    return {s.x, s.y, s.r};
}
[[nodiscard]] Ball<3, double> ball(const Site3& s) noexcept {
    return {s.x, s.y, s.z, s.r};
}
template <class... S>
[[nodiscard]] auto balls_of(const S&... sites) noexcept {
    return std::array{ball(sites)...};
}

/// A question of ball_polynomials.hpp in numbers of one kind.
struct Hides {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, 2>& b) {
        return hides<d>(row<d, typename Numbers::Number>(b[1], b[0]));
    }
};
struct Exists {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, d + 1>& b) {
        return exists<d, typename Numbers::Product>(b);
    }
};
struct InSphere {
    template <std::size_t d, class Numbers>
    [[nodiscard]] static Sign ask(const std::array<Ball<d, typename Numbers::Number>, d + 2>& b) {
        return in_sphere<d, typename Numbers::Product>(b);
    }
};

/// In rationals, or a judge's dyadic numbers.
template <class Question, Arithmetic arithmetic, std::size_t d, std::size_t n>
[[nodiscard]] Sign ask_exactly(const std::array<Ball<d, double>, n>& balls) noexcept {
    return Question::template ask<d, Numbers<predicates::ExactNumber<arithmetic>>>(
        exact_balls<arithmetic, d>(balls));
}

/// In long doubles that carry a bound; in the default environment.
template <class Question, std::size_t d, std::size_t n>
[[nodiscard]] filters::Verdict ask_bounded(const std::array<Ball<d, double>, n>& balls) noexcept {
    bool doubt = false;
    const Sign sign = Question::template ask<d, Numbers<Doubtful>>(
        made<d>(n > 2 ? based_on_least<d>(balls) : balls,
                [&](double number) { return Doubtful(number, doubt); }));
    return doubt ? filters::Verdict::uncertain() : filters::Verdict::certain(sign);
}

/// In the narrowest numbers that hold the balls.
template <class Question, std::size_t d, std::size_t n>
[[nodiscard]] Decision decide(const std::array<Ball<d, double>, n>& balls) noexcept {
    const exact::Apart<n, d + 1> apart(balls);
    if (apart.span() <= 62) {
        auto small = apart.template values<__int128>();
        if (narrowed<d>(small)) return {Question::template ask<d, Narrow>(small), Stage::exact};
    }
    if (apart.span() <= wide_bits)
        return {Question::template ask<d, Wide>(apart.template values<Wide::Number>()),
                Stage::exact};
    const filters::Verdict verdict = exact::in_ieee_environment(ask_bounded<Question, d, n>, balls);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    if (apart.span() <= integer_bits)
        return {Question::template ask<d, Widest>(apart.template values<Widest::Number>()),
                Stage::exact};
    return {ask_exactly<Question, Arithmetic::multiprecision, d>(balls), Stage::multiprecision};
}

/// Behind a filter: in an environment in which it declined it is asked again in the default one.
template <class Question, std::size_t d, class Filter, class... S>
[[nodiscard, gnu::cold, gnu::noinline]] Decision decide_cold(Filter filter,
                                                             const S&... sites) noexcept {
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide<Question, d>(balls_of(sites...));
}

template <class Question, std::size_t d, class Filter, class... S>
[[nodiscard, gnu::always_inline]] inline Decision filtered(Filter filter,
                                                           const S&... sites) noexcept {
    const filters::Verdict verdict = filter(sites...);
    if (verdict.is_certain()) [[likely]]
        return {verdict.sign(), Stage::filter};
    return decide_cold<Question, d>(filter, sites...);
}

}  // namespace

Decision exists_decision(const Site& i, const Site& j, const Site& k) noexcept {
    return filtered<Exists, 2>(filter::exists<2, Site, Site, Site>, i, j, k);
}
Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q) noexcept {
    const auto ask = [](const Site& a, const Site& b, const Site& c, const Site& query) {
        return filter::in_sphere<2>(query, a, b, c);
    };
    return filtered<InSphere, 2>(ask, i, j, k, q);
}
Decision hides_decision(const Site& i, const Site& q) noexcept {
    return filtered<Hides, 2>(filter::hides<2, Site>, i, q);
}

}  // namespace balls

namespace {

/// Whether all radii are the same number: then the predicates are those of points, of lower degree.
template <class... Others>
[[nodiscard]] bool same_radius(const Site3& first, const Others&... others) noexcept {
    return (filters::same_number(first.r, others.r) && ...);
}

}  // namespace

Decision exists_decision(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept {
    using namespace balls;
    if (same_radius(i, j, k, l)) {
        const Decision turn = ccw_decision(i, j, k, l);
        return {turn.sign > 0 ? 1 : -1, turn.stage};
    }
    return filtered<Exists, 3>(balls::filter::exists<3, Site3, Site3, Site3, Site3>, i, j, k, l);
}
Decision in_sphere_decision(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
                            const Site3& q) noexcept {
    using namespace balls;
    SIGNUM_EXPECTS(exists(i, j, k, l));
    if (same_radius(i, j, k, l, q))
        return power::in_sphere_decision(centre3(i), centre3(j), centre3(k), centre3(l),
                                         centre3(q));
    const auto ask = [](const Site3& a, const Site3& b, const Site3& c, const Site3& e,
                        const Site3& query) {
        return balls::filter::in_sphere<3>(query, a, b, c, e);
    };
    return filtered<InSphere, 3>(ask, i, j, k, l, q);
}
Decision hides_decision(const Site3& i, const Site3& q) noexcept {
    using namespace balls;
    return filtered<Hides, 3>(balls::filter::hides<3, Site3>, i, q);
}

namespace multiprecision {

template <Arithmetic arithmetic>
Sign in_sphere(const Site3& i, const Site3& j, const Site3& k, const Site3& l,
               const Site3& q) noexcept {
    using namespace balls;
    return ask_exactly<InSphere, arithmetic, 3>(balls_of(i, j, k, l, q));
}
template <Arithmetic arithmetic>
Sign exists(const Site3& i, const Site3& j, const Site3& k, const Site3& l) noexcept {
    using namespace balls;
    return ask_exactly<Exists, arithmetic, 3>(balls_of(i, j, k, l));
}
template <Arithmetic arithmetic>
Sign hides(const Site3& i, const Site3& q) noexcept {
    using namespace balls;
    return ask_exactly<Hides, arithmetic, 3>(balls_of(i, q));
}

#define SIGNUM_INSTANTIATE(arithmetic)                                                          \
    template Sign in_sphere<arithmetic>(const Site3&, const Site3&, const Site3&, const Site3&, \
                                        const Site3&) noexcept;                                 \
    template Sign exists<arithmetic>(const Site3&, const Site3&, const Site3&,                  \
                                     const Site3&) noexcept;                                    \
    template Sign hides<arithmetic>(const Site3&, const Site3&) noexcept;
SIGNUM_INSTANTIATE(Arithmetic::multiprecision)
SIGNUM_INSTANTIATE(predicates::judging)
#undef SIGNUM_INSTANTIATE

}  // namespace multiprecision
}  // namespace signum::euclidean
