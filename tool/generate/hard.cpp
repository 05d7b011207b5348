#include "hard.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace signum::hard {
namespace {

template <std::size_t d>
using Vector = std::array<std::int64_t, d>;

template <std::size_t d>
[[nodiscard]] std::int64_t square_of(const Vector<d>& v) {
    std::int64_t sum = 0;
    for (const std::int64_t x : v) sum += x * x;
    return sum;
}

/// Calls body(v) for every vector of integers from -most to most.
template <std::size_t d, class Body>
void for_all_vectors(std::int64_t most, Body body) {
    Vector<d> v;
    v.fill(-most);
    for (;;) {
        body(v);
        std::size_t k = 0;
        while (k < d && v[k] == most) v[k++] = -most;
        if (k == d) return;
        ++v[k];
    }
}

/// A vector whose length is an integer.
template <std::size_t d>
struct Arrow {
    Vector<d> v;
    std::int64_t length;
};
/// Those of Pythagoras, those along the axes among them.
template <std::size_t d>
[[nodiscard]] const std::vector<Arrow<d>>& arrows() {
    static const std::vector<Arrow<d>> all = [] {
        std::vector<Arrow<d>> result;
        for_all_vectors<d>(d == 2 ? 60 : 9, [&](const Vector<d>& v) {
            const std::int64_t square = square_of(v);
            const std::int64_t root = std::llround(std::sqrt(static_cast<double>(square)));
            if (square != 0 && root * root == square) result.push_back({v, root});
        });
        return result;
    }();
    return all;
}

/// Integer balls whose |c|² - r² is one number, with radii up to `radii`; a dozen at least.
template <std::size_t d>
using Level = std::vector<Arrow<d>>;
template <std::size_t d>
[[nodiscard]] std::vector<Level<d>> levels_of(std::int64_t most, std::int64_t radii) {
    std::map<std::int64_t, Level<d>> by_power;
    for_all_vectors<d>(most, [&](const Vector<d>& v) {
        for (std::int64_t r = 0; r <= radii; ++r) by_power[square_of(v) - r * r].push_back({v, r});
    });
    std::vector<Level<d>> result;
    for (auto& [power, level] : by_power)
        if (level.size() >= 12) result.push_back(std::move(level));
    return result;
}
template <std::size_t d>
[[nodiscard]] const std::vector<Level<d>>& levels(bool of_points) {
    if (of_points) {
        static const std::vector<Level<d>> points = levels_of<d>(d == 2 ? 85 : 12, 0);
        return points;
    }
    static const std::vector<Level<d>> discs = levels_of<d>(d == 2 ? 20 : 8, d == 2 ? 12 : 8);
    return discs;
}

template <std::size_t d>
[[nodiscard]] std::int64_t norm(Kind kind, const Vector<d>& v) {
    std::int64_t sum = 0;
    std::int64_t most = 0;
    for (const std::int64_t x : v) {
        sum += std::abs(x);
        most = std::max(most, std::abs(x));
    }
    return kind == Kind::manhattan ? sum : most;
}

template <std::size_t d>
[[nodiscard]] Ball<d> ball_at(const Vector<d>& v, std::int64_t size) {
    Ball<d> ball;
    for (std::size_t k = 0; k < d; ++k) ball.centre[k] = static_cast<double>(v[k]);
    ball.size = static_cast<double>(size);
    return ball;
}

[[nodiscard]] bool is_power(Kind kind) noexcept {
    return kind == Kind::points || kind == Kind::weights || kind == Kind::radii;
}

/// Each number is any() one.
template <std::size_t d, class Any>
void fill(Kind kind, std::span<Ball<d>> balls, const Any& any) {
    for (Ball<d>& ball : balls) {
        for (double& x : ball.centre) x = any();
        ball.size = kind == Kind::points ? 0.0 : any();
    }
}

/// The number so many steps away in the order of the doubles.
[[nodiscard]] double stepped(double number, std::int64_t steps) {
    // Of numbers with a sign the bits count from 0 outwards.
    const auto place = std::bit_cast<std::int64_t>(std::abs(number));
    const std::int64_t moved = std::signbit(number) ? -(place - steps) : place + steps;
    const double size = std::bit_cast<double>(std::abs(moved));
    return std::isfinite(size) ? (moved < 0 ? -size : size) : number;
}

/// number · 2^exponent, the largest double where that is none.
[[nodiscard]] double scaled(double number, int exponent) {
    constexpr double largest = std::numeric_limits<double>::max();
    return std::clamp(std::ldexp(number, exponent), -largest, largest);
}

}  // namespace

std::string_view name_of(Kind kind) noexcept {
    constexpr std::string_view names[] = {"points",    "weights",  "radii",
                                          "euclidean", "supremum", "manhattan"};
    return names[static_cast<int>(kind)];
}

// No distribution of the standard library: they differ.
template <std::size_t d>
std::int64_t Moves<d>::integer(std::int64_t least, std::int64_t most) {
    return least +
           static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(most - least + 1));
}

template <std::size_t d>
template <class Many>
auto& Moves<d>::any_of(Many& many) {
    return many[static_cast<std::size_t>(integer(0, std::ssize(many) - 1))];
}

template <std::size_t d>
void Moves<d>::lattice(Kind kind, Balls balls) {
    const std::int64_t wide = integer(1, 6);
    const std::int64_t sizes = kind == Kind::points || once_in(3) ? 0 : integer(1, 4);
    for (Ball<d>& ball : balls) {
        Vector<d> v;
        for (std::int64_t& x : v) x = integer(0, wide);
        ball = ball_at(v, integer(0, sizes));
    }
}

template <std::size_t d>
void Moves<d>::tangent(Kind kind, Balls balls) {
    if (kind == Kind::points || kind == Kind::radii) {
        const Level<d>& level = any_of(levels<d>(kind == Kind::points));
        for (Ball<d>& ball : balls) {
            const Arrow<d>& arrow = any_of(level);
            ball = ball_at(arrow.v, arrow.length);
        }
        return;
    }
    const std::int64_t wide = integer(2, 60);
    const std::int64_t radius = integer(0, kind == Kind::weights ? 4000 : 60);
    for (Ball<d>& ball : balls) {
        if (kind == Kind::euclidean) {
            const Arrow<d>& arrow = any_of(arrows<d>());
            const std::int64_t times = integer(1, 4);
            Vector<d> v = arrow.v;
            for (std::int64_t& x : v) x *= times;
            ball = ball_at(v, times * arrow.length - radius);
        } else {
            Vector<d> v;
            for (std::int64_t& x : v) x = integer(-wide, wide);
            ball = ball_at(v, (kind == Kind::weights ? square_of(v) : norm(kind, v)) - radius);
        }
    }
}

/// Whose heights along an arrow are what they stand above a line, or a plane, across it.
template <std::size_t d>
void Moves<d>::in_line(Kind kind, Balls balls) {
    const Arrow<d>& up = any_of(arrows<d>());
    const Vector<d>& v = up.v;
    std::array<Vector<d>, d - 1> across;
    if constexpr (d == 2)
        across = {{{-v[1], v[0]}}};
    else if (v[0] == 0 && v[1] == 0)
        across = {{{1, 0, 0}, {0, 1, 0}}};
    else
        across = {{{v[1], -v[0], 0}, {v[0] * v[2], v[1] * v[2], -v[0] * v[0] - v[1] * v[1]}}};
    const bool centres = is_power(kind) || once_in(4);
    for (Ball<d>& ball : balls) {
        const std::int64_t height = centres ? 0 : integer(-20, 20);
        Vector<d> place;
        for (std::size_t k = 0; k < d; ++k) place[k] = height * v[k];
        for (const Vector<d>& along : across) {
            const std::int64_t times = integer(-8, 8);
            for (std::size_t k = 0; k < d; ++k) place[k] += times * along[k];
        }
        std::int64_t size = height * up.length;
        if (centres && kind != Kind::points && once_in(2)) size = integer(0, 3);
        ball = ball_at(place, size);
    }
}

template <std::size_t d>
void Moves<d>::nest(Kind kind, Balls balls) {
    if (is_power(kind)) {
        lattice(kind, balls);
        for (Ball<d>& ball : balls)
            if (once_in(2)) ball.centre = balls[0].centre;
        return;
    }
    Vector<d> place = {};
    std::int64_t size = integer(0, 400);
    for (Ball<d>& ball : balls) {
        ball = ball_at(place, size);
        const Arrow<d>& arrow = any_of(arrows<d>());
        const std::int64_t length = kind == Kind::euclidean ? arrow.length : norm(kind, arrow.v);
        for (std::size_t k = 0; k < d; ++k) place[k] += arrow.v[k];
        size -= length;
    }
}

template <std::size_t d>
void Moves<d>::parabola(Kind kind, Balls balls) {
    for (Ball<d>& ball : balls) {
        Vector<d> v;
        std::int64_t square = 0;
        for (std::size_t k = 0; k + 1 < d; ++k) {
            v[k] = integer(-40, 40);
            square += v[k] * v[k];
        }
        v[d - 1] = square;
        ball = ball_at(v, kind == Kind::points ? 0 : square);
    }
}

template <std::size_t d>
void Moves<d>::copy(Balls balls) {
    any_of(balls) = Ball<d>(any_of(balls));
}

template <std::size_t d>
void Moves<d>::mirror(Balls balls) {
    const std::array<double, d> at = any_of(balls).centre;
    Ball<d> image = any_of(balls);
    const auto k = static_cast<std::size_t>(integer(0, d - 1));
    if (once_in(2)) {
        image.centre[k] = at[k] - (image.centre[k] - at[k]);
    } else {
        const std::size_t l = (k + 1) % d;
        const double x = image.centre[k] - at[k];
        image.centre[k] = at[k] + (image.centre[l] - at[l]);
        image.centre[l] = at[l] + x;
    }
    any_of(balls) = image;
}

template <std::size_t d>
void Moves<d>::put_on_circle_of_three(Balls balls) {
    if (balls.size() < 4) return;
    const auto& [i, j, k] = std::tie(balls[0].centre, balls[1].centre, balls[2].centre);
    double inner = 0.0;
    double square = 0.0;
    for (std::size_t n = 0; n < d; ++n) {
        const double along = j[n] - i[n];
        inner += along * ((i[n] - k[n]) + (j[n] - k[n]));
        square += along * along;
    }
    if (square == 0.0) return;
    const double times = inner / square;
    Ball<d>& last = balls.back();
    for (std::size_t n = 0; n < d; ++n) last.centre[n] = k[n] + times * (j[n] - i[n]);
    last.size = balls[2].size;
}

template <std::size_t d>
void Moves<d>::enlarge(Kind kind, Balls balls, int bits) {
    const auto times = static_cast<double>(integer(1, (std::int64_t{1} << integer(0, bits))));
    for (Ball<d>& ball : balls) {
        for (double& x : ball.centre) x *= times;
        ball.size *= kind == Kind::weights ? times * times : times;
    }
}

template <std::size_t d>
void Moves<d>::shift(Kind kind, Balls balls, int bits) {
    const auto any = [&] {
        const std::int64_t most = std::int64_t{1} << integer(0, bits);
        return static_cast<double>(integer(-most, most));
    };
    std::array<double, d> by;
    for (double& x : by) x = any();
    const double size = is_power(kind) || once_in(2) ? 0.0 : any();
    for (Ball<d>& ball : balls) {
        for (std::size_t k = 0; k < d; ++k) ball.centre[k] += by[k];
        ball.size += size;
    }
}

template <std::size_t d>
void Moves<d>::scale(Kind kind, Balls balls, int exponent) {
    for (Ball<d>& ball : balls) {
        for (double& x : ball.centre) x = std::ldexp(x, exponent);
        ball.size = std::ldexp(ball.size, kind == Kind::weights ? 2 * exponent : exponent);
    }
}

template <std::size_t d>
void Moves<d>::move_by_ulps(Kind kind, Balls balls, int numbers, int most) {
    double largest = 0.0;
    double largest_size = 0.0;
    for (const Ball<d>& ball : balls) {
        for (const double x : ball.centre) largest = std::max(largest, std::abs(x));
        largest_size = std::max(largest_size, std::abs(ball.size));
    }
    if (kind != Kind::weights) largest = largest_size = std::max(largest, largest_size);
    for (; numbers > 0; --numbers) {
        Ball<d>& ball = any_of(balls);
        const auto at = static_cast<std::size_t>(integer(0, kind == Kind::points ? d - 1 : d));
        double& number = at < d ? ball.centre[at] : ball.size;
        const std::int64_t steps = integer(-most, most);
        if (number == 0.0) {
            const double unit = at < d ? largest : largest_size;
            number = static_cast<double>(steps) * (stepped(unit, 1) - unit);
        } else {
            number = stepped(number, steps);
        }
    }
}

template <std::size_t d>
void Moves<d>::raw(Kind kind, Balls balls) {
    const auto any = [this] {
        for (;;) {
            const double number = std::bit_cast<double>(bits_());
            if (std::isfinite(number)) return number;
        }
    };
    fill(kind, balls, any);
}

template <std::size_t d>
void Moves<d>::raw(Kind kind, Balls balls, int exponents) {
    const auto any = [&](int times) {
        const std::uint64_t bits = bits_();
        const double significand = 1.0 + static_cast<double>(bits >> 12) * 0x1p-52;
        const auto exponent = static_cast<int>(integer(0, exponents)) - exponents / 2;
        return std::ldexp((bits & 1U) != 0 ? -significand : significand, times * exponent);
    };
    for (Ball<d>& ball : balls) {
        for (double& x : ball.centre) x = any(1);
        ball.size = kind == Kind::points ? 0.0 : any(kind == Kind::weights ? 2 : 1);
    }
}

template <std::size_t d>
void Moves<d>::any_pattern(Kind kind, Balls balls) {
    const std::int64_t which = integer(0, 15);
    if (which < 7)
        tangent(kind, balls);
    else if (which < 10)
        lattice(kind, balls);
    else if (which < 12)
        in_line(kind, balls);
    else if (which < 14)
        nest(kind, balls);
    else if (which < 15)
        parabola(kind, balls);
    else {
        lattice(kind, balls);
        put_on_circle_of_three(balls);
    }
    if (once_in(8)) copy(balls);
    if (once_in(8)) mirror(balls);
    // A line in space has the longest vectors, below 2^14; a weight is a square.
    if (once_in(2)) enlarge(kind, balls, kind == Kind::weights ? 12 : 20);
    if (once_in(2)) shift(kind, balls, 44);
}

/// Where numbers, their squares, products of three to five, and their sums overflow, underflow or
/// leave a filter's window; and ordinary ones.
template <std::size_t d>
int Moves<d>::extreme_exponent() {
    constexpr std::array about = {-1074, -1022, -970, -600, -537, -511, -400, -340,
                                  -270,  -200,  -60,  0,    0,    60,   200,  250,
                                  300,   340,   400,  490,  511,  600,  997,  1022};
    return any_of(about) + static_cast<int>(integer(-3, 3));
}

template <std::size_t d>
void Moves<d>::extremes(Kind kind, Balls balls) {
    const std::int64_t which = integer(0, 3);
    if (which < 3) any_pattern(kind, balls);
    if (which == 0) {
        for (std::size_t k = 0; k <= d; ++k) {
            const int exponent = once_in(2) ? 0 : extreme_exponent();
            for (Ball<d>& ball : balls) {
                double& number = k < d ? ball.centre[k] : ball.size;
                number = scaled(number, exponent);
            }
        }
    } else if (which == 1) {
        const int common = once_in(2) ? 0 : extreme_exponent();
        for (Ball<d>& ball : balls) {
            const int exponent = once_in(2) ? common : extreme_exponent();
            for (double& x : ball.centre) x = scaled(x, exponent);
            const int degree = kind == Kind::weights && once_in(2) ? 2 : 1;
            ball.size = scaled(ball.size, degree * exponent);
        }
    } else if (which == 2) {
        const int exponent = extreme_exponent();
        for (Ball<d>& ball : balls)
            if (!once_in(3)) ball.size = scaled(ball.size, exponent);
    } else {
        constexpr std::array significands = {0.0, 1.0,  1.0, 0x1.0000000000001p0,
                                             1.5, 1.75, 3.0, 0x1.fffffffffffffp0};
        const std::array exponents = {extreme_exponent(), extreme_exponent(), extreme_exponent()};
        const auto any = [&] {
            const double number = scaled(any_of(significands), any_of(exponents));
            return once_in(2) ? -number : number;
        };
        fill(kind, balls, any);
    }
    if (once_in(4)) copy(balls);
    if (once_in(2)) move_by_ulps(kind, balls, static_cast<int>(integer(1, 3)), 2);
}

template class Moves<2>;
template class Moves<3>;

}  // namespace signum::hard
