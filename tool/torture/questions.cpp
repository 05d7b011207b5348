#include "questions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "../../exact/parts.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"

namespace signum::torture {
namespace {

enum : std::size_t {
    random_points,
    lattice,
    moved_by_ulps,
    tenths,
    nearly_on_circle,
    neighbourhood,
    scaled,
    tiny_beside,
    far,
    extremes,
    raw,
    worst_rounding,
    own
};
constexpr std::array<Family, 13> all_families = {
    {{"random", "uniform in the square or cube: what every test asks"},
     {"lattice", "integers below 2^53, most of them exact ties, with copies and mirror images"},
     {"ulps", "such ties, of which one to three numbers are moved by at most 4 ulps"},
     {"tenths", "multiples of 0.1, a third of them moved by an ulp"},
     {"circles", "the last point where a mirror has it on the circle or sphere, rounded"},
     {"neighbourhood",
      "a point among the doubles next to one on the line of two others (Kettner "
      "et al. 2008), and the same of planes, circles and spheres"},
     {"scaled", "ties moved by ulps, multiplied by a power of two up to 2^60 or down to 2^-60"},
     {"tiny", "one number that is nothing beside the others, about 2^-460", 500, true},
     {"far", "all exponents near 400 or -400: products overflow or underflow", 500, true},
     {"extremes", "magnitudes at both ends of the doubles, and where products leave them", 500,
      true},
     {"raw", "any finite bit patterns", 500, true},
     {"rounding",
      "points for which doubles have the wrong sign by as much as a search finds: a "
      "filter's bound must be greater",
      50},
     {own_points_name, "points of the files given with --sites, most of them neighbours"}}};

Point plane_point(const Question& q, std::size_t m) {
    return {q.point(m)[0], q.point(m)[1]};
}
Point3 space_point(const Question& q, std::size_t m) {
    return {q.point(m)[0], q.point(m)[1], q.point(m)[2]};
}

template <std::size_t d>
bool has_denormal(const std::array<hard::Ball<d>, d + 2>& balls) {
    return std::ranges::any_of(balls, [](const auto& ball) {
        return std::ranges::any_of(ball.centre,
                                   [](double x) { return x != 0.0 && std::fabs(x) < 0x1p-500; });
    });
}
/// 2^-460 times a small integer.
template <std::size_t d>
double tiny_number(hard::Moves<d>& moves) {
    return std::ldexp(static_cast<double>(moves.integer(-1000, 1000)), -460);
}

/// A number in doubles, and its formula with every operand replaced by its magnitude.
struct Rounded {
    double value;
    double magnitude;

    friend Rounded operator*(Rounded a, Rounded b) {
        return {a.value * b.value, a.magnitude * b.magnitude};
    }
    friend Rounded operator+(Rounded a, Rounded b) {
        return {a.value + b.value, a.magnitude + b.magnitude};
    }
    friend Rounded operator-(Rounded a, Rounded b) {
        return {a.value - b.value, a.magnitude + b.magnitude};
    }
};
using Row = std::array<Rounded, 3>;
Rounded minor(const Row& a, const Row& b) {
    return a[0] * b[1] - a[1] * b[0];
}
Rounded minor(const Row& a, const Row& b, const Row& c) {
    return (a[2] * minor(b, c) - b[2] * minor(a, c)) + c[2] * minor(a, b);
}
/// As textbooks have it, from differences to the last point.
Rounded determinant_in_doubles(const Question& question) {
    const std::size_t d = dimension_of(question.asked);
    const std::size_t last = points_of(question.asked) - 1;
    std::array<Row, 4> r{};
    for (std::size_t m = 0; m < last; ++m)
        for (std::size_t k = 0; k < d; ++k) {
            const double x = question.point(m)[k] - question.point(last)[k];
            r[m][k] = {x, std::fabs(x)};
        }
    // In the plane the third number is 0.
    const auto square = [](const Row& a) { return (a[0] * a[0] + a[1] * a[1]) + a[2] * a[2]; };
    switch (question.asked) {
        case Asked::orient2d:
            return minor(r[0], r[1]);
        case Asked::incircle:
            return (square(r[0]) * minor(r[1], r[2]) + square(r[1]) * minor(r[2], r[0])) +
                   square(r[2]) * minor(r[0], r[1]);
        case Asked::orient3d:
            return minor(r[0], r[1], r[2]);
        case Asked::insphere:
            break;
    }
    return (square(r[3]) * minor(r[0], r[1], r[2]) - square(r[2]) * minor(r[3], r[0], r[1])) +
           (square(r[1]) * minor(r[2], r[3], r[0]) - square(r[0]) * minor(r[1], r[2], r[3]));
}
/// By how much of its magnitude the rounded determinant has the wrong sign; where it has the right
/// one, below 0 by as much.
double wrong_by(const Question& question) {
    const Rounded rounded = determinant_in_doubles(question);
    const double share = std::fabs(rounded.value) / rounded.magnitude;
    return exact_sign(question) == sign_of(rounded.value) ? -share : share;
}

/// The first number is moved to a tie, which lies between its neighbours among the doubles; false
/// where there is none nearby.
bool move_to_tie(Question& question) {
    const auto sign_at = [&](double x) {
        question.numbers[0] = x;
        return exact_sign(question);
    };
    double low = question.numbers[0] - 2.0;
    double high = question.numbers[0] + 2.0;
    const Sign below = sign_at(low);
    if (below == 0 || below != -sign_at(high)) return false;
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (!(low < middle && middle < high)) break;
        (sign_at(middle) == below ? low : high) = middle;
    }
    question.numbers[0] = low;
    return true;
}

}  // namespace

std::string_view name_of(Asked asked) noexcept {
    constexpr std::array<std::string_view, functions> names = {"orient2d", "incircle", "orient3d",
                                                               "insphere"};
    return names[place_of(asked)];
}

Sign exact_sign(const Question& q) {
    using predicates::decide;
    switch (q.asked) {
        case Asked::orient2d:
            return ccw(plane_point(q, 0), plane_point(q, 1), plane_point(q, 2));
        case Asked::incircle:
            return decide<Arithmetic::exact, power::InCircle>(plane_point(q, 0), plane_point(q, 1),
                                                              plane_point(q, 2), plane_point(q, 3))
                .sign;
        case Asked::orient3d:
            return -ccw(space_point(q, 0), space_point(q, 1), space_point(q, 2), space_point(q, 3));
        case Asked::insphere:
            return -decide<Arithmetic::exact, power::InSphere>(space_point(q, 0), space_point(q, 1),
                                                               space_point(q, 2), space_point(q, 3),
                                                               space_point(q, 4))
                        .sign;
    }
    return 0;
}

Sign exact_turn(const Question& q) {
    return dimension_of(q.asked) == 2
               ? ccw(plane_point(q, 0), plane_point(q, 1), plane_point(q, 2))
               : -ccw(space_point(q, 0), space_point(q, 1), space_point(q, 2), space_point(q, 3));
}

int cost_of(const Question& question) noexcept {
    int bits = 0;
    int least = 2000;
    int greatest = -2000;
    for (std::size_t k = 0; k < question.size(); ++k) {
        const exact::Parts parts = exact::parts(question.numbers[k]);
        if (parts.significand == 0) continue;
        const int width = static_cast<int>(std::bit_width(parts.significand));
        bits += width;
        least = std::min(least, parts.exponent + width);
        greatest = std::max(greatest, parts.exponent + width);
    }
    // What underflows or overflows comes after what does not.
    const bool is_far = bits > 0 && (least < -200 || greatest > 200);
    return 1 + bits + (greatest > least ? greatest - least : 0) + (is_far ? 10'000 : 0);
}

std::span<const Family> families() noexcept {
    return all_families;
}

bool Maker::has(Asked asked, std::size_t family) const {
    return family != own || std::ranges::any_of(own_, [&](const OwnPoints& each) {
               return each.dimension == dimension_of(asked);
           });
}

Question Maker::make(Asked asked, std::size_t family) {
    if (family == own) return make_own(asked);
    if (family == worst_rounding) return make_worst(asked);
    return dimension_of(asked) == 2 ? made(plane_, asked, family) : made(space_, asked, family);
}

Question Maker::make_clear(Asked asked) {
    Question question{asked, {}};
    std::uniform_int_distribution<int> digit(-1000, 1000);
    do {
        for (std::size_t k = 0; k < question.size(); ++k) question.numbers[k] = digit(random_);
    } while (exact_sign(question) == 0 || exact_turn(question) == 0);
    return question;
}

/// The last point lies on one side of 0 and the others on the other, so that each difference is
/// rounded; then numbers are moved by ulps as long as that does not make it better.
Question Maker::make_worst(Asked asked) {
    constexpr int steps = 1000;
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    Question question{asked, {}};
    const std::size_t last = question.size() - dimension_of(asked);
    const bool is_near = below(3) == 0;
    for (std::size_t k = 0; k < question.size(); ++k) {
        const double beyond = is_near ? 0x1p-52 * static_cast<double>(below(256))
                                      : std::ldexp(uniform(random_), -static_cast<int>(below(40)));
        question.numbers[k] = k < last ? 1.0 + beyond : -1.0 - beyond;
    }
    if (!is_near && !move_to_tie(question)) return question;
    double most = wrong_by(question);
    for (int step = 0; step < steps; ++step) {
        Question moved = question;
        for (std::size_t many = 1 + below(3); many > 0; --many) {
            double& number = moved.numbers[below(moved.size())];
            const std::size_t range = std::size_t{1} << below(6);
            const auto ulps =
                static_cast<std::int64_t>(below(2 * range + 1)) - static_cast<std::int64_t>(range);
            number += std::ldexp(static_cast<double>(ulps), std::ilogb(number) - 52);
        }
        if (const double now = wrong_by(moved); now >= most) {
            most = now;
            question = moved;
        }
    }
    return question;
}

/// Of four questions three have neighbours, in any order, and one has any points.
Question Maker::make_own(Asked asked) {
    const std::size_t d = dimension_of(asked);
    std::size_t n = below(own_.size());
    while (own_[n].dimension != d) n = (n + 1) % own_.size();
    const OwnPoints& own = own_[n];
    std::array<Index, 5> chosen{};
    if (!own.beside.empty() && below(4) != 0)
        chosen = own.beside[below(own.beside.size())];
    else
        for (Index& each : chosen) each = static_cast<Index>(below(own.points.size()));
    for (std::size_t m = d + 1; m > 0; --m) std::swap(chosen[m], chosen[below(m + 1)]);
    Question question{asked, {}};
    for (std::size_t m = 0; m < points_of(asked); ++m)
        std::ranges::copy_n(own.points[static_cast<std::size_t>(chosen[m])].begin(),
                            static_cast<std::ptrdiff_t>(d), &question.numbers[m * d]);
    return question;
}

template <std::size_t d>
Question Maker::made(hard::Moves<d>& moves, Asked asked, std::size_t family) {
    constexpr hard::Kind points = hard::Kind::points;
    std::array<hard::Ball<d>, d + 2> balls;
    const auto shuffle = [&] {
        for (std::size_t m = balls.size() - 1; m > 0; --m)
            std::swap(balls[m],
                      balls[static_cast<std::size_t>(moves.integer(0, static_cast<int>(m)))]);
    };
    const auto move = [&] {
        moves.move_by_ulps(points, balls, static_cast<int>(moves.integer(1, 3)), 4);
    };
    switch (family) {
        case random_points: {
            std::uniform_real_distribution<double> uniform(-1.0, 1.0);
            for (auto& ball : balls)
                for (double& x : ball.centre) x = uniform(random_);
            break;
        }
        case tenths:
            for (auto& ball : balls)
                for (double& x : ball.centre) {
                    x = 0.1 * static_cast<double>(moves.integer(0, 10));
                    if (x != 0.0 && moves.once_in(3))
                        x = std::nextafter(x, moves.once_in(2) ? 2.0 : -2.0);
                }
            break;
        case nearly_on_circle:
            moves.raw(points, balls, static_cast<int>(moves.integer(0, 4)));
            moves.put_on_circle_of_three(balls);
            shuffle();
            break;
        case neighbourhood: {
            // On the diagonal; of the others one is far from it, so that they span plane or space.
            const double along[] = {0.5, 12.0, 24.0, 8.8, 17.3};
            for (std::size_t m = 0; m < balls.size(); ++m)
                balls[m].centre.fill(
                    along[(m + static_cast<std::size_t>(moves.integer(0, 4))) % 5]);
            for (std::size_t m = 3; m < balls.size(); ++m) balls[m].centre[m % d] += 7.0;
            for (double& x : balls[0].centre)
                x = 0.5 + 0x1p-53 * static_cast<double>(moves.integer(0, 255));
            if (asked != Asked::orient2d && moves.once_in(2)) moves.put_on_circle_of_three(balls);
            break;
        }
        case extremes:
            moves.extremes(points, balls);
            break;
        case raw:
            moves.raw(points, balls);
            break;
        default:
            // Of numbers that are all 0 the ulp is a denormal.
            do {
                moves.any_pattern(points, balls);
                shuffle();
                if (family != lattice) move();
            } while (has_denormal(balls));
            if (family == scaled)
                moves.scale(points, balls, static_cast<int>(moves.integer(-60, 60)));
            if (family == tiny_beside)
                balls[static_cast<std::size_t>(moves.integer(0, d))]
                    .centre[static_cast<std::size_t>(moves.integer(0, d - 1))] = tiny_number(moves);
            if (family == far) {
                const auto exponent = static_cast<int>(moves.integer(320, 440));
                moves.scale(points, balls, moves.once_in(2) ? -exponent : exponent);
            }
    }
    Question question{asked, {}};
    for (std::size_t m = 0; m < points_of(asked); ++m)
        for (std::size_t k = 0; k < d; ++k) question.numbers[m * d + k] = balls[m].centre[k];
    return question;
}

}  // namespace signum::torture
