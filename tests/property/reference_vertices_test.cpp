// The vertices of whole tessellations, a hundred thousand in each metric, are the reference's
// rounded to nearest-even. The reference is solved from the definition in numbers of 400 bits:
// power by a linear system, Euclidean by a quadratic equation whose root a step of Newton's method
// then judges, Manhattan and supremum by trying the sides of squares. Most of the sets are nearly
// degenerate.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../by_metric.hpp"
#include "../thoroughness.hpp"

namespace signum {
namespace {

const std::size_t sites_of_a_set = is_fast ? 4000 : 1000;
const int rounds = is_fast ? 3 : 1;
const int share = is_fast ? 1 : 50;  // of what is counted in a release build

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Number = mpf_class;
using Triple = std::array<Site, 3>;

/// What the sets keep to: multiples of 2^-140 below 2^30. Sums of a few of them are exact in 400
/// bits. A Euclidean vertex is the root of a quadratic polynomial whose coefficients have the
/// degrees 4, 5 and 6 in them. A number of 2^-200 to 2^150 half way between doubles, put in, gives
/// 0 or more than 2^-1100, and the slope there is below 2^300: so the root is that number, or its
/// conjugate is, which is farther away, or both are more than 2^-1400 from it. The vertices of the
/// power metric, of degree 6 over 4, keep a larger distance.
constexpr int lowest_bit = -140;
constexpr int highest_bit = 30;
constexpr double least_result = 0x1p-200;
constexpr double greatest_result = 0x1p150;
constexpr mp_bitcnt_t reference_bits = 400;
constexpr mp_bitcnt_t separating_bits = 4000;

bool within_bounds(double value) {
    const double units = std::ldexp(value, -lowest_bit);
    return units == std::trunc(units) && std::fabs(value) < std::ldexp(1.0, highest_bit);
}

/// 2^exponent times a number.
Number scaled(const Number& value, long exponent) {
    Number result;
    if (exponent < 0) {
        mpf_div_2exp(result.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(-exponent));
    } else {
        mpf_mul_2exp(result.get_mpf_t(), value.get_mpf_t(), static_cast<mp_bitcnt_t>(exponent));
    }
    return result;
}

/// A number, and how far the true one may lie from it.
struct Approximate {
    Number value;
    Number error;
};

struct Reference {
    Approximate x, y, rho;
};

// Rounding ----------------------------------------------------------------------------------------

struct Rounded {
    double value = nan;
    bool half = false;       // rounded from half way between two doubles
    bool undecided = false;  // the error allows both sides of the half, or of 0
};

/// To nearest; what the error allows to be half way counts as half way, and so to the even side.
Rounded rounded(const Approximate& a) {
    const Number magnitude = abs(a.value);
    Rounded result;
    if (magnitude <= a.error) {
        result.value = 0.0;
        result.undecided = a.error > 0;
        return result;
    }
    // mpf_get_d cuts off.
    const double below = mpf_get_d(magnitude.get_mpf_t());
    const double above = std::nextafter(below, infinity);
    const Number beyond_half = magnitude - (Number(below) + Number(above)) / 2;
    result.half = abs(beyond_half) <= a.error;
    result.undecided = result.half && a.error > 0;
    const bool below_is_even = (std::bit_cast<std::uint64_t>(below) & 1) == 0;
    const bool down = result.half ? below_is_even : beyond_half < 0;
    result.value = std::copysign(down ? below : above, sgn(a.value));
    return result;
}

// Power -------------------------------------------------------------------------------------------

/// Relative to i the point p with 2(c_m - c_i)·p = |c_m - c_i|² - w_m + w_i, by Cramer's rule. The
/// error is bounded by the sizes of what cancels.
Reference power_reference(const Triple& sites, WeightIs weight_is, mp_bitcnt_t bits) {
    const auto weight = [&](std::size_t m) {
        const Number third(sites[m].r);
        return weight_is == WeightIs::weight ? third : Number(third * third);
    };
    struct Row {
        Number x, y, p, size;  // size: of what p was added up from
    };
    const auto row = [&](std::size_t m) {
        Row r;
        r.x = Number(sites[m].x) - Number(sites[0].x);
        r.y = Number(sites[m].y) - Number(sites[0].y);
        const Number square = r.x * r.x + r.y * r.y;
        r.p = (square - weight(m) + weight(0)) / 2;
        r.size = square + abs(weight(m)) + abs(weight(0));
        return r;
    };
    const Row j = row(1);
    const Row k = row(2);
    const Number determinant = j.x * k.y - j.y * k.x;
    EXPECT_GT(determinant, 0) << "not counterclockwise";
    const Number x = (j.p * k.y - k.p * j.y) / determinant;
    const Number y = (j.x * k.p - k.x * j.p) / determinant;

    const Number width_j = abs(j.x) + abs(j.y);
    const Number width_k = abs(k.x) + abs(k.y);
    const Number error = scaled(
        (j.size * width_k + k.size * width_j) * width_j * width_k / (determinant * determinant),
        20 - static_cast<long>(bits));
    const auto rounding = [&](const Number& size) {
        return scaled(abs(size), 20 - static_cast<long>(bits));
    };
    const Number square = x * x + y * y;
    return {{x + sites[0].x, error + rounding(Number(sites[0].x))},
            {y + sites[0].y, error + rounding(Number(sites[0].y))},
            {square - weight(0),
             2 * (abs(x) + abs(y) + error) * error + rounding(square + abs(weight(0)))}};
}

// Euclidean ---------------------------------------------------------------------------------------

/// Centre and radius of circles in the plane that touch three discs, relative to the first.
class Circles {
 public:
    Circles(const Triple& sites, mp_bitcnt_t bits)
        : sites_(sites), bits_(static_cast<long>(bits)), j_(row(1)), k_(row(2)) {}

    /// The circle that sees the three counterclockwise; none where they touch a line instead.
    std::optional<Reference> solve() {
        // Differences of the three squares |u - c_m|² = (R + s_m)² are two linear equations a·u = p
        // for u = (X, Y, R). The unknown whose minor is the largest is left free.
        std::array<Number, 3> minors;
        for (std::size_t f = 0; f < 3; ++f)
            minors[f] = j_.a[next(f)] * k_.a[last(f)] - j_.a[last(f)] * k_.a[next(f)];
        std::size_t f = 0;
        for (std::size_t m = 1; m < 3; ++m)
            if (abs(minors[m]) > abs(minors[f])) f = m;
        const std::size_t g = next(f);
        const std::size_t h = last(f);
        const Number& m = minors[f];
        if (m == 0) return {};
        // m u_g = g_0 + g_1 t and m u_h = h_0 + h_1 t with t = u_f; then X² + Y² = R².
        const Number g_0 = j_.p * k_.a[h] - k_.p * j_.a[h];
        const Number h_0 = k_.p * j_.a[g] - j_.p * k_.a[g];
        const Number& g_1 = minors[g];
        const Number& h_1 = minors[h];
        const auto sign = [](std::size_t unknown) { return unknown == 2 ? -1 : 1; };
        const Number a = sign(g) * g_1 * g_1 + sign(h) * h_1 * h_1 + sign(f) * m * m;
        const Number b = sign(g) * g_0 * g_1 + sign(h) * h_0 * h_1;
        const Number c = sign(g) * g_0 * g_0 + sign(h) * h_0 * h_0;
        common_tangent_ = a == 0;
        const Number discriminant = b * b - a * c;
        if (discriminant < 0) return {};
        // The larger root without cancellation, the other one by their product.
        const Number root = sqrt(discriminant);
        const Number sum = b < 0 ? Number(root - b) : Number(-b - root);
        std::optional<Reference> found;
        const auto attempt = [&](const Number& t) {
            std::array<Number, 3> u;
            u[f] = t;
            u[g] = (g_0 + g_1 * t) / m;
            u[h] = (h_0 + h_1 * t) / m;
            const std::optional<Reference> circle = judged(u);
            if (!circle) return;
            EXPECT_FALSE(found) << "two circles";
            found = circle;
        };
        if (a != 0) attempt(sum / a);
        if (sum != 0) attempt(c / sum);
        return found;
    }

    /// Whether one of the circles is a line.
    [[nodiscard]] bool common_tangent() const { return common_tangent_; }

 private:
    struct Row {
        std::array<Number, 3> a;  // x, y, s
        Number p;
    };

    static std::size_t next(std::size_t unknown) { return (unknown + 1) % 3; }
    static std::size_t last(std::size_t unknown) { return (unknown + 2) % 3; }

    [[nodiscard]] Row row(std::size_t m) const {
        Row r;
        r.a = {Number(sites_[m].x) - Number(sites_[0].x), Number(sites_[m].y) - Number(sites_[0].y),
               Number(sites_[m].r) - Number(sites_[0].r)};
        r.p = (r.a[0] * r.a[0] + r.a[1] * r.a[1] - r.a[2] * r.a[2]) / 2;
        return r;
    }

    /// By the definition: |u - c_m| = R + s_m for all three, and counterclockwise. What is missing
    /// to equality, a step of Newton's method turns into a bound on the distance to the solution.
    [[nodiscard]] std::optional<Reference> judged(const std::array<Number, 3>& u) const {
        const Number size = abs(u[0]) + abs(u[1]) + abs(u[2]);
        std::array<std::array<Number, 2>, 3> direction;  // towards the sites
        std::array<Number, 3> missing;
        for (std::size_t m = 0; m < 3; ++m) {
            const Number away = m == 0 ? u[2] : Number(u[2] + (m == 1 ? j_ : k_).a[2]);
            if (away <= 0) return {};
            Number dx = -u[0];
            Number dy = -u[1];
            if (m != 0) {
                dx += (m == 1 ? j_ : k_).a[0];
                dy += (m == 1 ? j_ : k_).a[1];
            }
            const Number length = sqrt(Number(dx * dx + dy * dy));
            missing[m] = length - away;
            EXPECT_LE(abs(missing[m]), scaled(size + length, -bits_ * 3 / 4)) << "solved wrongly";
            direction[m] = {dx / length, dy / length};
        }
        const Number jx = direction[1][0] - direction[0][0];
        const Number jy = direction[1][1] - direction[0][1];
        const Number kx = direction[2][0] - direction[0][0];
        const Number ky = direction[2][1] - direction[0][1];
        const Number turn = jx * ky - jy * kx;
        EXPECT_GT(abs(turn), scaled(Number(1), -bits_ * 3 / 4)) << "seen edge-on";
        if (turn <= 0) return {};
        const Number j = missing[1] - missing[0];
        const Number k = missing[2] - missing[0];
        const Number x = (j * ky - k * jy) / turn;
        const Number y = (jx * k - kx * j) / turn;
        const Number r = missing[0] - direction[0][0] * x - direction[0][1] * y;
        const Number step = abs(x) + abs(y) + abs(r);
        EXPECT_LE(step, scaled(size, -bits_ / 2)) << "solved wrongly";
        const auto sum = [&](double start, const Number& shift, const Number& correction) {
            const Number value = start + shift + correction;
            return Approximate{value, step + scaled(size + abs(Number(start)), 20 - bits_)};
        };
        return Reference{sum(sites_[0].x, u[0], x), sum(sites_[0].y, u[1], y),
                         sum(-sites_[0].r, u[2], r)};
    }

    const Triple& sites_;
    long bits_;
    Row j_;
    Row k_;
    bool common_tangent_ = false;
};

// Squares -----------------------------------------------------------------------------------------

/// The square that three sites touch at three sides in counterclockwise order, and beyond whose
/// sides none reaches. Ties are decided by what the rule says, with numbers: each radius is reduced
/// by its own power of two, below the last bit of the sites and much larger for the later site.
class Squares {
 public:
    Squares(const Triple& sites, Metric metric) {
        std::array<std::size_t, 3> order = {0, 1, 2};
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const Site& p = sites[a];
            const Site& q = sites[b];
            return p.r != q.r ? p.r > q.r : p.x != q.x ? p.x < q.x : p.y < q.y;
        });
        std::array<Number, 3> reduction;
        for (std::size_t place = 0; place < 3; ++place)
            reduction[order[place]] = scaled(Number(1), -350 + 100 * static_cast<long>(place));
        for (std::size_t m = 0; m < 3; ++m) {
            const Number x(sites[m].x);
            const Number y(sites[m].y);
            const Number r(sites[m].r);
            // |x| + |y| is the larger of |x+y| and |y-x|: squares, turned by 45 degrees.
            const bool turned = metric == Metric::manhattan;
            const Number first = turned ? Number(x + y) : x;
            const Number second = turned ? Number(y - x) : y;
            reach_[m] = {first - r, second - r, -first - r, -second - r};
            for (std::size_t d = 0; d < 4; ++d) reduced_[m][d] = reach_[m][d] + reduction[m];
        }
        turned_ = metric == Metric::manhattan;
    }

    std::optional<Reference> solve() const {
        std::optional<std::array<Number, 4>> found;
        for (std::size_t open = 0; open < 4; ++open)
            for (std::size_t first = 0; first < 3; ++first) {
                if (!holds(sides(reduced_, open, first))) continue;
                EXPECT_FALSE(found) << "two squares";
                found = sides(reach_, open, first);
            }
        if (!found) return {};
        const auto& [right, top, left, bottom] = *found;
        const Number first = (right - left) / 2;
        const Number second = (top - bottom) / 2;
        const Number rho = (right + left) / 2;
        // The definition, on the square itself.
        for (const auto& reach : reach_) {
            const Number away = std::max({Number(reach[0] - first), Number(reach[1] - second),
                                          Number(reach[2] + first), Number(reach[3] + second)});
            EXPECT_EQ(away, rho) << "not at this distance";
        }
        const Number none = 0;
        if (!turned_) return Reference{{first, none}, {second, none}, {rho, none}};
        return Reference{{(first - second) / 2, none}, {(first + second) / 2, none}, {rho, none}};
    }

 private:
    /// How far the three reach to the right, up, left and down.
    using Reaches = std::array<std::array<Number, 4>, 3>;

    /// The sides of the square whose side `open` none touches, the next one `first`.
    static std::array<Number, 4> sides(const Reaches& reach, std::size_t open, std::size_t first) {
        std::array<Number, 4> side;
        for (std::size_t turn = 1; turn < 4; ++turn)
            side[(open + turn) % 4] = reach[(first + turn - 1) % 3][(open + turn) % 4];
        side[open] = side[(open + 1) % 4] + side[(open + 3) % 4] - side[(open + 2) % 4];
        return side;
    }

    [[nodiscard]] bool holds(const std::array<Number, 4>& side) const {
        for (const auto& reach : reduced_)
            for (std::size_t d = 0; d < 4; ++d)
                if (reach[d] > side[d]) return false;
        return true;
    }

    Reaches reach_;
    Reaches reduced_;
    bool turned_ = false;
};

// Sets --------------------------------------------------------------------------------------------

class Sets {
 public:
    static constexpr int families = 15;

    Sets(Metric metric, std::uint64_t seed) : metric_(metric), random_(seed) {}

    std::vector<Site> sites(int family, std::size_t count) {
        std::vector<Site> result(count);
        const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(count)));
        const double angle = between(0, 2 * std::numbers::pi);
        // How far the nearly degenerate sets are from degenerate.
        const double noise = std::pow(10.0, -between(9, 15));
        std::vector<Site> centres(40);
        for (Site& s : centres) s = {between(0, 1), between(0, 1), between(2, 12)};
        for (std::size_t n = 0; n < count; ++n) {
            Site& s = result[n];
            const auto column = static_cast<double>(n % side);
            const std::size_t rows = n / side;
            const auto row = static_cast<double>(rows);
            switch (family) {
                case 0:  // discs apart, most of them
                    s = {between(0, 700), between(0, 700), between(0, 5)};
                    break;
                case 1:  // overlapping discs
                    s = {between(0, 1), between(0, 1), between(-0.05, 0.05)};
                    break;
                case 2:  // touching a common circle of the metric, nearly: the vertices crowd
                case 3:
                    s = touching_circle(family == 2 ? between(0, 0.5) : 0.25, noise);
                    break;
                case 4:  // the same far from the origin
                    s = touching_circle(between(0, 0.01), noise);
                    s.x += 1e6;
                    s.y -= 1e6;
                    break;
                case 5:  // touching a common line, nearly: vertices lie far away
                case 6: {
                    const double along = between(0, 1);
                    const double r = family == 5 ? between(0, 1e-4) : 0.0;
                    const double beyond = noise_of(1e3 * noise) + (power() ? 0.0 : r);
                    s = {along * std::cos(angle) - beyond * std::sin(angle),
                         along * std::sin(angle) + beyond * std::cos(angle), r};
                    break;
                }
                case 7:  // a grid, nearly
                case 8:
                    s = {column + noise_of(1e-12), row + noise_of(1e-12),
                         0.25 + (family == 7 ? noise_of(1e-12) : 0.0)};
                    break;
                case 9:  // a grid: ties everywhere
                    s = {column, row, 0.0};
                    break;
                case 10:  // a grid of discs of few sizes
                    s = {column, row, 0.125 * std::floor(between(0, 4))};
                    break;
                case 11:  // a small set beside large offsets
                    s = {1e6 + between(0, 1e-3), -3e6 + between(0, 1e-3), between(0, 1e-5)};
                    break;
                case 12: {  // clusters over many scales
                    const Site& c = centres[random_() % centres.size()];
                    const double scale = std::pow(10.0, -between(0, c.r));
                    s = {c.x + noise_of(scale), c.y + noise_of(scale), between(0, 0.01) * scale};
                    break;
                }
                case 13: {  // discs that touch a common line from above, among others
                    const double r = std::floor(between(1, 9));
                    s = {std::floor(between(0, 1e5)), r, r};
                    if (n % 4 != 0) s.y += std::floor(between(0, 1e5));
                    break;
                }
                default: {  // a few units in the last place apart: halves of them are half way
                    const auto units = [&](double most) { return std::floor(between(0, most)); };
                    s = {1.0 + 0x1p-52 * units(200), 1.0 + 0x1p-52 * units(200),
                         0x1p-52 * units(2)};
                }
            }
        }
        return result;
    }

 private:
    [[nodiscard]] bool power() const { return metric_ == Metric::power; }
    double between(double least, double most) {
        return least + (most - least) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    double noise_of(double size) { return between(-size, size); }

    /// At distance 1 from the origin, in the metric and but for the noise.
    Site touching_circle(double r, double noise) {
        const double turn = between(0, 2 * std::numbers::pi);
        double x = std::cos(turn);
        double y = std::sin(turn);
        const double norm = traits_of(metric_).site == "disc"
                                ? 1.0
                                : by_metric::length_or_square(metric_, std::fabs(x), std::fabs(y));
        const double away = (power() ? std::sqrt(1.0 + r * r) : 1.0 + r) / norm + noise_of(noise);
        x *= away;
        y *= away;
        return {x, y, r};
    }

    Metric metric_;
    std::mt19937_64 random_;
};

// Comparison --------------------------------------------------------------------------------------

bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || a == b;
}

class ReferenceVertices : public testing::TestWithParam<Metric> {
 protected:
    int compared_ = 0;
    int crowded_ = 0;  // another vertex lies within 10^-9 of the set's size, but not in its place
    int coincident_ = 0;  // another vertex lies in its place
    int far_ = 0;         // a thousand times the set's size away
    int halves_ = 0;      // numbers half way between two doubles
    int at_infinity_ = 0;

    /// None for the faces that only the tie rule makes, on a common tangent line.
    static std::optional<Reference> reference(const Triple& sites, WeightIs weight_is,
                                              mp_bitcnt_t bits) {
        mpf_set_default_prec(bits);
        if (GetParam() == Metric::power) return power_reference(sites, weight_is, bits);
        if (GetParam() != Metric::euclidean) return Squares(sites, GetParam()).solve();
        Circles circles(sites, bits);
        std::optional<Reference> found = circles.solve();
        EXPECT_TRUE(found || circles.common_tangent()) << "no circle";
        return found;
    }

    static std::array<Rounded, 3> rounded_reference(const Triple& sites, WeightIs weight_is,
                                                    mp_bitcnt_t bits) {
        const std::optional<Reference> r = reference(sites, weight_is, bits);
        if (!r) return {};
        const Number largest = scaled(Number(1), 80 - static_cast<long>(bits) / 2);
        for (const Approximate* a : {&r->x, &r->y, &r->rho}) EXPECT_LE(a->error, largest);
        return {rounded(r->x), rounded(r->y), rounded(r->rho)};
    }

    void expect(const Triple& sites, WeightIs weight_is, const DiagramVertex& v) {
        std::array<Rounded, 3> e = rounded_reference(sites, weight_is, reference_bits);
        if (std::any_of(e.begin(), e.end(), [](const Rounded& r) { return r.undecided; }))
            e = rounded_reference(sites, weight_is, separating_bits);
        if (HasFailure() || !same(v.x, e[0].value) || !same(v.y, e[1].value) ||
            !same(v.rho, e[2].value)) {
            for (const Site& s : sites)
                ADD_FAILURE() << std::hexfloat << s.x << ", " << s.y << ", " << s.r;
            FAIL() << std::hexfloat << v.x << ", " << v.y << ", " << v.rho << ", not " << e[0].value
                   << ", " << e[1].value << ", " << e[2].value;
        }
        if (std::isnan(v.x)) {
            ++at_infinity_;
            return;
        }
        ++compared_;
        for (const Rounded& r : e) {
            const double size = std::fabs(r.value);
            ASSERT_TRUE(size == 0.0 || (size > least_result && size < greatest_result));
            halves_ += static_cast<int>(r.half);
        }
    }

    template <class S>
    void expect(const std::vector<S>& given) {
        const Tessellation t = triangulate(given, GetParam());
        for (const Site& s : t.sites())
            ASSERT_TRUE(within_bounds(s.x) && within_bounds(s.y) && within_bounds(s.r));
        const double size = extent(t);
        const std::vector<DiagramVertex> v = vertices(t);
        ASSERT_EQ(v.size(), t.faces().size());
        for (std::size_t f = 0; f < v.size(); ++f) {
            const Face& face = t.faces()[f];
            if (face[0] == infinite) continue;
            const auto site = [&](std::size_t m) {
                return t.sites()[static_cast<std::size_t>(face[m])];
            };
            ASSERT_NO_FATAL_FAILURE(expect({site(0), site(1), site(2)}, t.weight_is(), v[f]));
            note(t, v, f, size);
        }
    }

    static double extent(const Tessellation& t) {
        const auto [left, right] = std::ranges::minmax(t.sites(), {}, &Site::x);
        const auto [low, high] = std::ranges::minmax(t.sites(), {}, &Site::y);
        return std::max(right.x - left.x, high.y - low.y);
    }

    void note(const Tessellation& t, const std::vector<DiagramVertex>& v, std::size_t f,
              double size) {
        double nearest = infinity;
        for (const Index g : t.neighbours()[f]) {
            const DiagramVertex& w = v[static_cast<std::size_t>(g)];
            const double distance = std::hypot(w.x - v[f].x, w.y - v[f].y);
            if (distance < nearest) nearest = distance;
        }
        crowded_ += static_cast<int>(nearest > 0.0 && nearest < 1e-9 * size);
        coincident_ += static_cast<int>(nearest == 0.0);
        const Site& s = t.sites().front();
        far_ += static_cast<int>(std::hypot(v[f].x - s.x, v[f].y - s.y) > 1e3 * size);
    }
};

TEST_P(ReferenceVertices, OfManySets) {
    Sets sets(GetParam(), 5);
    for (int round = 0; round < rounds; ++round)
        for (int family = 0; family < Sets::families; ++family) {
            const std::vector<Site> sites = sets.sites(family, sites_of_a_set);
            expect(sites);
            ASSERT_FALSE(HasFailure()) << "family " << family;
            if (GetParam() != Metric::power || round % 2 != 0) continue;
            // In place of radii, weights of both signs.
            std::vector<power::Site> weighted;
            weighted.reserve(sites.size());
            for (const Site& s : sites) weighted.push_back({s.x, s.y, s.r * s.r - 1e-3 * s.r});
            expect(weighted);
            ASSERT_FALSE(HasFailure()) << "family " << family << " with weights";
        }
    RecordProperty("compared", compared_);
    RecordProperty("crowded", crowded_);
    RecordProperty("coincident", coincident_);
    RecordProperty("far", far_);
    RecordProperty("halves", halves_);
    RecordProperty("at_infinity", at_infinity_);
    EXPECT_GE(compared_, 200000 / share);
    EXPECT_GE(crowded_, 40000 / share);
    EXPECT_GE(coincident_, 25000 / share);
    EXPECT_GE(halves_, 5000 / share);
    // Squares are no larger than the set, and every three have one.
    const bool squares = GetParam() == Metric::manhattan || GetParam() == Metric::supremum;
    EXPECT_GE(far_, squares ? 0 : 5000 / share);
    EXPECT_EQ(at_infinity_ > 0, GetParam() == Metric::euclidean);
}

INSTANTIATE_TEST_SUITE_P(Metrics, ReferenceVertices, testing::ValuesIn(all_metrics),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

}  // namespace
}  // namespace signum
