/// The stages of the predicates that have some of their own: in_circle, in_sphere, and those of the
/// Euclidean metric.

namespace signum::power {
namespace {

namespace ladder = predicates::ladder;

/// The error of the determinant in double-doubles (predicates/power/in_circle.cpp).
constexpr double refined_in_circle_error = 16 * filters::double_double_epsilon;

// Of rows, so that sites of all kinds share them.

struct Rounded {
    [[nodiscard]] static double difference(double a, double b) noexcept { return a - b; }
    [[nodiscard]] static double difference_of_squares(double a, double b) noexcept {
        return (a - b) * (a + b);
    }
    [[nodiscard]] static double zero() noexcept { return 0.0; }
};

template <class Number>
using CircleRows = std::array<Row<Number>, 3>;
template <class Number, class S>
[[nodiscard]] CircleRows<decltype(Number::zero())> circle_rows(const S& i, const S& j, const S& k,
                                                               const S& q) noexcept {
    return {row<Number>(i, q), row<Number>(j, q), row<Number>(k, q)};
}
template <class Number>
using SphereRows = std::array<LiftedRow<Number>, 4>;
template <class Number, class S>
[[nodiscard]] SphereRows<decltype(Number::zero())> sphere_rows(const S& i, const S& j, const S& k,
                                                               const S& l, const S& q) noexcept {
    return {lifted_row<Number>(i, q), lifted_row<Number>(j, q), lifted_row<Number>(k, q),
            lifted_row<Number>(l, q)};
}

[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(const CircleRows<double>& r) noexcept {
    const auto [value, bound] = compared_in_circle_finely(r[0], r[1], r[2]);
    return ladder::judged(value, bound);
}
[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(
    const CircleRows<filters::DoubleDouble>& r) noexcept {
    const auto high = [&](std::size_t m) -> Row<double> {
        return {r[m].x.high, r[m].y.high, r[m].weight.high};
    };
    return ladder::judged(
        in_circle_determinant(r[0], r[1], r[2]).high,
        refined_in_circle_error * determinant_magnitude(high(0), high(1), high(2)));
}
[[nodiscard, gnu::cold]] Sign sign_of_circle(const CircleRows<exact::Dyadic>& r) noexcept {
    return in_circle_determinant(r[0], r[1], r[2]).sign();
}
#if defined(__SIZEOF_INT128__)
/// Of points, whose ties are those of grids (predicates/power/in_circle.cpp).
[[nodiscard, gnu::noinline]] filters::Verdict judge_circle(
    const exact::IntegerRows<2>& given) noexcept {
    exact::IntegerRows<2> rows = given;
    if (!rows.are_exact()) return filters::Verdict::uncertain();
    const auto determinant = [&](auto square) {
        using Square = decltype(square);
        const auto row = [&](std::size_t m) -> Row<exact::Word<Square>, Square> {
            return {{rows[m].offset[0]}, {rows[m].offset[1]}, Square{rows[m].weight}};
        };
        return in_circle_determinant(row(0), row(1), row(2));
    };
    if (!rows.divide_by_power_of_two(30))
        return filters::Verdict::certain(determinant(exact::Factor{0}).sign());
    const exact::Integer128 narrow = determinant(exact::Integer128{0});
    return filters::Verdict::certain((narrow > 0) - (narrow < 0));
}
#endif
struct CircleBeyond {
    template <class S>
    [[nodiscard, gnu::cold]] static Decision climb(const S& i, const S& j, const S& k,
                                                   const S& q) noexcept {
        return {sign_of_circle(circle_rows<ladder::Exactly>(i, j, k, q)), Stage::multiprecision};
    }
};
struct CircleWithin {
    template <class S>
    [[nodiscard]] static Decision climb(const S& i, const S& j, const S& k, const S& q) noexcept {
        filters::Verdict verdict = judge_circle(circle_rows<Rounded>(i, j, k, q));
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
#if defined(__SIZEOF_INT128__)
        if constexpr (words::same<S, Point>) {
            verdict = judge_circle(exact::IntegerRows<2>({&i, &j, &k}, q));
            if (verdict.is_certain()) return {verdict.sign(), Stage::exact};
        }
#endif
        verdict = judge_circle(circle_rows<ladder::Refined>(i, j, k, q));
        if (verdict.is_certain()) return {verdict.sign(), Stage::refine};
        return CircleBeyond::climb(i, j, k, q);
    }
};

/// In the window (predicates/space/in_sphere.cpp).
[[nodiscard, gnu::noinline]] double size_of_sphere(const SphereRows<double>& r) noexcept {
    const LiftedRow<double> rows[4] = {r[0], r[1], r[2], r[3]};
    return determinant_magnitude(rows);
}
[[nodiscard, gnu::noinline]] double determinant_of_sphere(const SphereRows<double>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]);
}
[[nodiscard, gnu::noinline]] double determinant_of_sphere(
    const SphereRows<filters::DoubleDouble>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]).high;
}
[[nodiscard, gnu::cold]] Sign sign_of_sphere(const SphereRows<exact::Dyadic>& r) noexcept {
    return in_sphere_determinant(r[0], r[1], r[2], r[3]).sign();
}
struct SphereBeyond {
    template <class S>
    [[nodiscard, gnu::cold]] static Decision climb(const S& i, const S& j, const S& k, const S& l,
                                                   const S& q) noexcept {
        return {sign_of_sphere(sphere_rows<ladder::Exactly>(i, j, k, l, q)), Stage::multiprecision};
    }
};
/// Whether five points have no more than two coordinates along each axis: corners of a box, which
/// lie on one sphere.
[[nodiscard, gnu::noinline]] bool are_corners_of_a_box(const Point3& i, const Point3& j,
                                                       const Point3& k, const Point3& l,
                                                       const Point3& q) noexcept {
    const auto are_two = [](double a, double b, double c, double d, double one) {
        double other = one;
        for (const double here : {a, b, c, d}) {
            if (here != one && other != one && here != other) return false;
            if (here != one) other = here;
        }
        return true;
    };
    return are_two(i.x, j.x, k.x, l.x, q.x) && are_two(i.y, j.y, k.y, l.y, q.y) &&
           are_two(i.z, j.z, k.z, l.z, q.z);
}
struct SphereWithin {
    template <class S>
    [[nodiscard]] static Decision climb(const S& i, const S& j, const S& k, const S& l,
                                        const S& q) noexcept {
        const auto rows = sphere_rows<Rounded>(i, j, k, l, q);
        const double size = size_of_sphere(rows);
        const double value = determinant_of_sphere(rows);
        filters::Verdict verdict = ladder::judged(value, in_sphere_error * size);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
        if constexpr (words::same<S, Point3>) {
            if (predicates::are_small_integers(0x1p8, {&i, &j, &k, &l, &q}))
                return {sign_of(value), Stage::exact};
            if (are_corners_of_a_box(i, j, k, l, q)) return {0, Stage::exact};
        }
        verdict = ladder::judged(determinant_of_sphere(sphere_rows<ladder::Refined>(i, j, k, l, q)),
                                 refined_in_sphere_error * size);
        if (verdict.is_certain()) return {verdict.sign(), Stage::refine};
        return SphereBeyond::climb(i, j, k, l, q);
    }
};

}  // namespace

template <Arithmetic arithmetic, class S>
Decision InCircle::behind(const S& i, const S& j, const S& k, const S& q) noexcept {
    return ladder::climb<arithmetic, InCircle, CircleWithin, CircleBeyond>(i, j, k, q);
}
template <Arithmetic arithmetic, class S>
Decision InSphere::behind(const S& i, const S& j, const S& k, const S& l, const S& q) noexcept {
    return ladder::climb<arithmetic, InSphere, SphereWithin, SphereBeyond>(i, j, k, l, q);
}

}  // namespace signum::power

namespace signum::euclidean {
namespace {

template <class Number, std::size_t n, class Make>
[[nodiscard]] std::array<Disc<Uniform<Number>>, n> discs_of(const std::array<Site, n>& sites,
                                                            const Make& make) {
    std::array<Disc<Uniform<Number>>, n> result;
    for (std::size_t m = 0; m < n; ++m)
        result[m] = {make(sites[m].x), make(sites[m].y), make(sites[m].r)};
    return result;
}

template <std::size_t n, class Question>
[[nodiscard, gnu::cold]] Decision decide_exactly(const std::array<Site, n>& sites,
                                                 const Question& question) {
    const auto answer = question(
        discs_of<exact::Dyadic>(sites, [](double number) { return exact::Dyadic(number); }));
    return {answer.sign, Stage::multiprecision, answer.tied};
}

/// The answer to a question of formulas/discs.hpp, in double-doubles that carry a bound, and where
/// these leave a sign open in dyadic numbers.
template <std::size_t n, class Question>
[[nodiscard]] Decision decide_discs(const std::array<Site, n>& sites, const Question& question) {
    const Decision refined = exact::in_ieee_environment(
        [&](const std::array<Site, n>& given) -> Decision {
            using Number = Doubted<filters::Bounded>;
            bool doubt = false;
            const auto answer = question(
                discs_of<Number>(given, [&](double number) { return Number(number, doubt); }));
            return doubt ? Decision{} : Decision{answer.sign, Stage::refine, answer.tied};
        },
        sites);
    return refined.stage == Stage::refine ? refined : decide_exactly(sites, question);
}

/// Behind a filter; in an environment in which it declined it is asked again in the default one.
template <class Filter, class Question, class... Sites>
[[nodiscard]] Decision decide(Filter filter, Question question, const Sites&... sites) noexcept {
    if (!filters::environment_is_default()) {
        const filters::Verdict verdict = exact::in_ieee_environment(filter, sites...);
        if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    }
    return decide_discs(std::array<Site, sizeof...(Sites)>{sites...}, question);
}

}  // namespace

namespace cold {

Decision hides(Arithmetic, const Site& i, const Site& q, const Ranks<2>& ranks) noexcept {
    return decide([](const Site& m, const Site& other) { return filter::hides(m, other); },
                  [&](const auto& d) { return polynomials::hides(d, ranks); }, i, q);
}
Decision nearer(Arithmetic, const Point& p, const Site& a, const Site& b,
                const Ranks<2>& ranks) noexcept {
    return decide(
        [](const Site& point, const Site& first, const Site& second) {
            return filter::nearer({point.x, point.y}, first, second);
        },
        [&](const auto& d) { return polynomials::nearer(d, ranks); }, Site{p.x, p.y, a.r}, a, b);
}
Decision exists(Arithmetic, const Site& i, const Site& j, const Site& k,
                const Ranks<3>& ranks) noexcept {
    return decide(
        filter::exists, [&](const auto& d) { return polynomials::exists(d, ranks); }, i, j, k);
}
Decision in_circle(Arithmetic, const Site& i, const Site& j, const Site& k, const Site& q,
                   const Ranks<4>& ranks) noexcept {
    return decide(
        filter::in_circle, [&](const auto& d) { return polynomials::in_circle(d, ranks); }, i, j, k,
        q);
}
Decision in_circle_infinite(Arithmetic, const Site& a, const Site& b, const Site& q,
                            const Ranks<3>& ranks) noexcept {
    return decide(
        filter::in_circle_infinite,
        [&](const auto& d) { return polynomials::in_circle_infinite(d, ranks); }, a, b, q);
}

}  // namespace cold

Decision in_circle_decision(const Site& i, const Site& j, const Site& k, const Site& q,
                            const std::array<Index, 4>& ranks) noexcept {
    const filters::Verdict verdict = filter::in_circle(i, j, k, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        filter::in_circle,
        [&](const auto& d) { return polynomials::Answer{polynomials::in_circle_touch(d, ranks)}; },
        i, j, k, q);
}
Decision in_circle_infinite_decision(const Site& a, const Site& b, const Site& q) noexcept {
    const filters::Verdict verdict = filter::in_circle_infinite(a, b, q);
    if (verdict.is_certain()) return {verdict.sign(), Stage::filter};
    return decide(
        filter::in_circle_infinite,
        [](const auto& d) { return polynomials::Answer{polynomials::in_circle_infinite_touch(d)}; },
        a, b, q);
}

}  // namespace signum::euclidean
