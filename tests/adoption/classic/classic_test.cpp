/// The classic determinants against integers of any size: 0 where these are 0, the same sign, and
/// one of the two doubles beside them, for operands of every size, in every rounding mode, with
/// denormals flushed.

#include <signum/classic.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>
#include <thread>

#include <gtest/gtest.h>

#include "../../property/environments.hpp"
#include "../../property/raw_doubles.hpp"

namespace signum {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Up to five points of space and their heights; in the plane z is not looked at.
using Points = std::array<std::array<double, 3>, 5>;
struct Operands {
    Points p;
    std::array<double, 5> h;
};

/// A determinant by both ways. The integer is the determinant · 2^(degree · scale) where
/// coordinates are multiples of 2^-scale.
struct Classic {
    const char* name;
    int degree;
    double (*value)(const Operands&);
    mpz_class (*exact)(const std::array<std::array<mpz_class, 4>, 5>&);
};

/// The determinant of the first n rows and columns, by its first column.
template <std::size_t n>
mpz_class determinant(const std::array<std::array<mpz_class, n>, n>& m) {
    if constexpr (n == 1) {
        return m[0][0];
    } else {
        mpz_class sum = 0;
        for (std::size_t row = 0; row < n; ++row) {
            std::array<std::array<mpz_class, n - 1>, n - 1> minor;
            for (std::size_t i = 0, k = 0; i < n; ++i) {
                if (i == row) continue;
                for (std::size_t j = 1; j < n; ++j) minor[k][j - 1] = m[i][j];
                ++k;
            }
            const mpz_class term = m[row][0] * determinant<n - 1>(minor);
            sum += row % 2 == 0 ? term : mpz_class(-term);
        }
        return sum;
    }
}

using Integers = std::array<std::array<mpz_class, 4>, 5>;

/// The rows (x, y, z of the space's dimension, and the lift) of the points but the last, relative
/// to it.
template <std::size_t n, int dimension>
mpz_class lifted(const Integers& p, bool by_height) {
    std::array<std::array<mpz_class, n>, n> m;
    for (std::size_t i = 0; i < n; ++i) {
        mpz_class squares = 0;
        for (std::size_t k = 0; k < dimension; ++k) {
            const mpz_class difference = p[i][k] - p[n][k];
            m[i][k] = difference;
            squares += difference * difference;
        }
        if constexpr (n > dimension)
            m[i][n - 1] = by_height ? mpz_class(p[i][3] - p[n][3]) : squares;
    }
    return determinant<n>(m);
}

const Classic all[] = {
    {"orient2d", 2,
     [](const Operands& o) { return orient2d(o.p[0].data(), o.p[1].data(), o.p[2].data()); },
     [](const Integers& p) { return lifted<2, 2>(p, false); }},
    {"orient3d", 3,
     [](const Operands& o) {
         return orient3d(o.p[0].data(), o.p[1].data(), o.p[2].data(), o.p[3].data());
     },
     [](const Integers& p) { return lifted<3, 3>(p, false); }},
    {"incircle", 4,
     [](const Operands& o) {
         return incircle(o.p[0].data(), o.p[1].data(), o.p[2].data(), o.p[3].data());
     },
     [](const Integers& p) { return lifted<3, 2>(p, false); }},
    {"insphere", 5,
     [](const Operands& o) {
         return insphere(o.p[0].data(), o.p[1].data(), o.p[2].data(), o.p[3].data(), o.p[4].data());
     },
     [](const Integers& p) { return lifted<4, 3>(p, false); }},
    {"orient4d", 4,
     [](const Operands& o) {
         return orient4d(o.p[0].data(), o.p[1].data(), o.p[2].data(), o.p[3].data(), o.p[4].data(),
                         o.h[0], o.h[1], o.h[2], o.h[3], o.h[4]);
     },
     [](const Integers& p) { return lifted<4, 3>(p, true); }},
};

std::string text_of(const Operands& o) {
    std::ostringstream text;
    text << std::hexfloat;
    for (std::size_t i = 0; i < 5; ++i)
        text << "(" << o.p[i][0] << ", " << o.p[i][1] << ", " << o.p[i][2] << "; " << o.h[i]
             << ") ";
    return text.str();
}

/// The doubles beside a magnitude; that beyond the largest one is 2^1024.
mpz_class magnitude_of(double value, int scale) {
    if (std::isinf(value)) {
        mpz_class result = 1;
        mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(),
                     static_cast<mp_bitcnt_t>(1024 + scale));
        return result;
    }
    return scaled(std::fabs(value), scale);
}

/// Empty, or what is wrong with a value as the integer · 2^-scale, scale at least 1074.
std::string wrong(double value, const mpz_class& exact, int scale) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const bool is_zero = bits << 1 == 0;
    if (std::isnan(value)) return "NaN";
    if (is_zero != (exact == 0)) return "0 on one side alone";
    if (is_zero) return "";
    if (std::signbit(value) != (exact < 0)) return "the sign";
    const mpz_class truth = abs(exact);
    if (std::isinf(value))
        return truth > magnitude_of(largest, scale) ? "" : "infinity for what is a double";
    const double magnitude = std::fabs(value);
    const mpz_class here = magnitude_of(value, scale);
    const mpz_class above = magnitude_of(std::nextafter(magnitude, infinity), scale);
    const mpz_class below = magnitude_of(std::nextafter(magnitude, 0.0), scale);
    if (!(below < truth && truth < above)) return "not beside the determinant";
    // As pair.hpp proves it: half a unit and an eighth; the least double stands for 0, too.
    const mpz_class off = abs(mpz_class(truth - here));
    if (magnitude != least && 8 * off > 5 * (above - here)) return "off by more than 5/8 of a unit";
    return "";
}

void expect_right(const Classic& classic, const Operands& o) {
    // Numbers as multiples of the last bit of any of them.
    int scale = 0;
    for (std::size_t i = 0; i < 5; ++i)
        for (const double number : {o.p[i][0], o.p[i][1], o.p[i][2], o.h[i]})
            scale = std::max(scale, -last_bit(number));
    Integers integers;
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            integers[i][k] = scaled(k < 3 ? o.p[i][k] : o.h[i], scale);
    mpz_class exact = classic.exact(integers);
    int of_exact = classic.degree * scale;
    if (of_exact < 1074) {
        mpz_mul_2exp(exact.get_mpz_t(), exact.get_mpz_t(),
                     static_cast<mp_bitcnt_t>(1074 - of_exact));
        of_exact = 1074;
    }
    for (int environment = 0; environment < environments; ++environment) {
        const double value = within(environment, [&] { return classic.value(o); });
        const std::string fault = wrong(value, exact, of_exact);
        ASSERT_TRUE(fault.empty())
            << classic.name << ": " << fault << ", " << std::hexfloat << value << " of "
            << text_of(o) << ", " << name_of_environment(environment);
    }
}

/// Every determinant of operands, which are made anew for each.
template <class Make>
void expect_all_right(int trials, const Make& make) {
    for (int trial = 0; trial < static_cast<int>(trials * effort) + 1; ++trial)
        for (const Classic& classic : all) {
            expect_right(classic, make());
            if (testing::Test::HasFatalFailure()) return;
        }
}

template <class Number>
Operands of(const Number& number) {
    Operands o;
    for (auto& point : o.p)
        for (double& coordinate : point) coordinate = number();
    for (double& height : o.h) height = number();
    return o;
}

TEST(Classic, OfRandomPoints) {
    Random random(1);
    expect_all_right(1500, [&] { return of([&] { return random.real(); }); });
}

TEST(Classic, OfPointsCloseTogetherFarAway) {
    Random random(2);
    expect_all_right(800, [&] { return of([&] { return 1000.0 / 3 + 1e-9 * random.real(); }); });
}

TEST(Classic, OnGridsWhereTiesAbound) {
    Random random(3);
    expect_all_right(1500, [&] {
        const double step = random.any({1.0, 0.1, 1e-300, 1e100});
        const int size = random.between(1, 6);
        return of([&] { return step * random.below(size + 1); });
    });
}

/// On a line, on a plane, on a circle, on a sphere, each coordinate rounded and moved by a few
/// units.
TEST(Classic, NearTies) {
    Random random(4);
    const auto near = [&](double value) { return moved(random, value); };
    expect_all_right(800, [&] {
        Operands o{};
        const bool straight = random.coin();
        for (std::size_t i = 0; i < 5; ++i) {
            const double t = random.real();
            const double s = random.real();
            if (straight) {
                o.p[i] = {near(t), near(t / 3), near(t / 7 + (random.coin() ? s : 0))};
                o.h[i] = near(t / 5 + s);
            } else {
                const double z = random.coin() ? 2 * s - 1 : 0.0;
                const double r = std::sqrt(1 - z * z);
                o.p[i] = {near(r * std::cos(7 * t)), near(r * std::sin(7 * t)), near(z)};
                o.h[i] = near(1.0);
            }
        }
        return o;
    });
}

TEST(Classic, OfSizesFarApart) {
    Random random(5);
    expect_all_right(500, [&] {
        const int reach = random.any({3, 60, 149, 151, 210, 1000});
        return of([&] {
            return random.below(6) == 0 ? 0.0
                                        : random.sign() * std::ldexp(random.significand(),
                                                                     random.between(-reach, reach));
        });
    });
}

TEST(Classic, OfTheLargestAndTheLeastDoubles) {
    Random random(6);
    const double numbers[] = {0.0,       largest,  -largest, largest / 2, 0x1p1023,
                              0x1p-1022, -least,   least,    1.0,         3 * least,
                              -0x1p512,  0x1p-512, 0x1p341,  0x1p-358};
    expect_all_right(800, [&] { return of([&] { return random.any(numbers); }); });
}

TEST(Classic, OfAnyBits) {
    std::mt19937_64 bits(7);
    expect_all_right(200, [&] {
        return of([&] {
            for (;;)
                if (const auto number = std::bit_cast<double>(bits()); std::isfinite(number))
                    return number;
        });
    });
}

TEST(Classic, BeyondTheDoublesAndBelow) {
    const double o[] = {0, 0};
    const double x[] = {largest, 0};
    const double y[] = {0, largest};
    EXPECT_EQ(orient2d(x, y, o), infinity);
    EXPECT_EQ(orient2d(y, x, o), -infinity);
    const double a[] = {least, 0};
    const double b[] = {0, least};
    EXPECT_EQ(orient2d(a, b, o), least);
    EXPECT_EQ(orient2d(b, a, o), -least);
}

TEST(Classic, OfWhatIsNoNumber) {
    const double good[] = {0, 1, 2};
    for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
        for (int place = 0; place < 3; ++place) {
            double point[] = {1, 2, 3};
            point[place] = bad;
            const double other[] = {4, 1, 1};
            EXPECT_TRUE(std::isnan(orient3d(good, point, other, good)));
            EXPECT_TRUE(std::isnan(insphere(good, good, other, good, point)));
            if (place == 2) continue;
            EXPECT_TRUE(std::isnan(orient2d(point, good, other)));
            EXPECT_TRUE(std::isnan(incircle(good, good, other, point)));
        }
}

TEST(Classic, FastOnesArePlainDoubles) {
    const double a[] = {0.1, 0.3, 0.9};
    const double b[] = {0.7, 0.2, 0.4};
    const double c[] = {0.5, 0.8, 0.1};
    const double d[] = {0.6, 0.9, 0.2};
    const double e[] = {0.3, 0.1, 0.6};
    EXPECT_NEAR(orient2dfast(a, b, c), orient2d(a, b, c), 1e-15);
    EXPECT_NEAR(orient3dfast(a, b, c, d), orient3d(a, b, c, d), 1e-15);
    EXPECT_NEAR(incirclefast(a, b, c, d), incircle(a, b, c, d), 1e-15);
    EXPECT_NEAR(inspherefast(a, b, c, d, e), insphere(a, b, c, d, e), 1e-15);
    // And so 0 where they underflow.
    const double tiny[] = {1e-200, 0};
    const double other[] = {0, 1e-200};
    const double origin[] = {0, 0};
    EXPECT_EQ(orient2dfast(tiny, other, origin), 0.0);
}

TEST(Classic, FromManyThreadsAtOnce) {
    std::array<int, 4> wrong_ones{};
    {
        std::array<std::jthread, 4> threads;
        for (std::size_t t = 0; t < threads.size(); ++t)
            threads[t] = std::jthread([&wrong_ones, t] {
                enter(static_cast<int>(t));
                for (int n = 1; n < 2000; ++n) {
                    const double a[] = {0.0, 0.0};
                    const double b[] = {n * 1.0, n * 2.0};
                    const double c[] = {n * 3.0, n * 6.0};
                    const double d[] = {n * 3.0, n * 6.0 + 0x1p-30};
                    wrong_ones[t] += static_cast<int>(orient2d(a, b, c) != 0.0) +
                                     static_cast<int>(orient2d(a, b, d) != n * 0x1p-30);
                }
                leave();
            });
    }
    for (const int count : wrong_ones) EXPECT_EQ(count, 0);
}

}  // namespace
}  // namespace signum
