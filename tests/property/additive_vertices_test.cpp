// The vertices of the diagrams with additive weights are the exact ones, rounded once: against
// squares found by trying every side for every site, and circles solved with thousands of bits and
// then measured.

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "../../triangulation/triangulate.hpp"
#include "../../triangulation/vertices.hpp"
#include "../thoroughness.hpp"

#include "rounded.hpp"

namespace signum {
namespace {

using Triple = std::array<Site, 3>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const int share = is_fast ? 1 : 10;  // of the trials one in so many

// Squares -----------------------------------------------------------------------------------------

/// Places among the three in the tie rule's order.
std::array<int, 3> ranks_of(const Triple& sites) {
    std::array<int, 3> order = {0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        const Site& p = sites[static_cast<std::size_t>(a)];
        const Site& q = sites[static_cast<std::size_t>(b)];
        return p.r != q.r ? p.r > q.r : p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    std::array<int, 3> ranks{};
    for (int place = 0; place < 3; ++place)
        ranks[static_cast<std::size_t>(order[static_cast<std::size_t>(place)])] = place;
    return ranks;
}

/// A number and behind it multiples of infinitesimals, the last site's first.
struct Form {
    mpq_class value;
    std::array<int, 3> tiny{};

    friend Form operator+(Form a, const Form& b) {
        a.value += b.value;
        for (std::size_t m = 0; m < 3; ++m) a.tiny[m] += b.tiny[m];
        return a;
    }
    friend Form operator-(Form a, const Form& b) {
        a.value -= b.value;
        for (std::size_t m = 0; m < 3; ++m) a.tiny[m] -= b.tiny[m];
        return a;
    }
    friend bool operator<=(const Form& a, const Form& b) {
        return a.value != b.value ? a.value < b.value : a.tiny <= b.tiny;
    }
};

struct Square {
    mpq_class first, second, rho;
};

/// The square with three sites on three sides in counterclockwise order, beyond which none reaches.
std::optional<Square> square_of(const Triple& sites, Metric metric) {
    const std::array<int, 3> ranks = ranks_of(sites);
    std::array<std::array<Form, 4>, 3> forms;
    for (std::size_t m = 0; m < 3; ++m) {
        mpq_class first(sites[m].x);
        mpq_class second(sites[m].y);
        if (metric == Metric::manhattan) {
            const mpq_class u = first + second;
            second -= first;
            first = u;
        }
        Form less;
        less.tiny[static_cast<std::size_t>(2 - ranks[m])] = 1;
        const mpq_class signs[4] = {first, second, -first, -second};
        for (std::size_t d = 0; d < 4; ++d)
            forms[m][d] = Form{mpq_class(signs[d] - mpq_class(sites[m].r))} + less;
    }
    std::optional<Square> found;
    for (std::size_t open = 0; open < 4; ++open)
        for (std::size_t start = 0; start < 3; ++start) {
            std::array<Form, 4> g;
            for (std::size_t turn = 1; turn < 4; ++turn)
                g[(open + turn) % 4] = forms[(start + turn) % 3][(open + turn) % 4];
            g[open] = g[(open + 1) % 4] + g[(open + 3) % 4] - g[(open + 2) % 4];
            bool inside = true;
            for (const auto& form : forms)
                for (std::size_t d = 0; d < 4; ++d) inside = inside && form[d] <= g[d];
            if (!inside) continue;
            EXPECT_FALSE(found);
            found = Square{(g[0].value - g[2].value) / 2, (g[1].value - g[3].value) / 2,
                           (g[0].value + g[2].value) / 2};
        }
    return found;
}

DiagramVertex expected_square(const Triple& sites, Metric metric) {
    const std::optional<Square> s = square_of(sites, metric);
    if (!s) return {nan, nan, nan};
    if (metric == Metric::supremum) return {rounded(s->first), rounded(s->second), rounded(s->rho)};
    return {rounded((s->first - s->second) / 2), rounded((s->first + s->second) / 2),
            rounded(s->rho)};
}

// Circles -----------------------------------------------------------------------------------------

/// The double nearest to start + shift, where the shift was computed with an error far below
/// 2^-(bits/2). Of two doubles that this error allows the number lies half way between, as no
/// irrational number of this degree comes so near to there: then the even one. Between the two
/// signs of an error that is all lies 0.
double rounded_sum(const mpq_class& start, const mpf_class& shift, mp_bitcnt_t bits) {
    const mpq_class moved(shift);
    mpq_class error = abs(start) + abs(moved);
    mpq_div_2exp(error.get_mpq_t(), error.get_mpq_t(), bits / 2);
    const mpq_class sum = start + moved;
    const double below = rounded(sum - error);
    const double above = rounded(sum + error);
    if (below == above || std::isnan(below)) return below;
    if (std::isnan(above)) return above;
    if (below < 0.0 && above > 0.0) return 0.0;
    int exponent = 0;
    const double odd = std::ldexp(std::frexp(below, &exponent), 53);
    return std::fmod(odd, 2.0) == 0.0 ? below : above;
}

/// Finds centre and distance by cutting the line of points (X, Y, R) that have equal tangents to
/// the three with the cone R = |(X, Y)|.
class Solver {
 public:
    /// Numbers without a precision of their own get this one, too.
    explicit Solver(mp_bitcnt_t bits) : bits_(bits) { mpf_set_default_prec(bits); }

    /// NaN where no circle touches the three counterclockwise from outside, or one hides another.
    [[nodiscard]] DiagramVertex solve(const Triple& sites) const {
        const Row j(sites[1], sites[0]);
        const Row k(sites[2], sites[0]);
        if (j.p <= 0 || k.p <= 0 || Row(sites[2], sites[1]).p <= 0) return {nan, nan, nan};
        const Vector n = cross(j.v, k.v);
        const mpq_class square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        if (square == 0) return {nan, nan, nan};
        const Vector to_k = cross(k.v, n);
        const Vector to_j = cross(n, j.v);
        Vector foot;
        for (std::size_t d = 0; d < 3; ++d)
            foot[d] = (j.p * to_k[d] + k.p * to_j[d]) / (2 * square);
        const mpq_class a = form(n, n);
        const mpq_class b = form(n, foot);
        const mpq_class c = form(foot, foot);
        const mpq_class discriminant = b * b - a * c;
        if (discriminant < 0) return {nan, nan, nan};
        // The root without cancellation, and by the product of the roots the other one.
        const mpf_class root = sqrt(mpf_class(discriminant, bits_));
        const mpf_class sum =
            b > 0 ? mpf_class(-mpf_class(b, bits_) - root) : mpf_class(root - mpf_class(b, bits_));
        std::optional<DiagramVertex> found;
        const auto attempt = [&](const mpf_class& t) {
            std::array<mpf_class, 3> point;
            for (std::size_t d = 0; d < 3; ++d)
                point[d] = mpf_class(foot[d], bits_) + t * mpf_class(n[d], bits_);
            if (!touches(point, j, k)) return;
            EXPECT_FALSE(found);
            found = DiagramVertex{rounded_sum(mpq_class(sites[0].x), point[0], bits_),
                                  rounded_sum(mpq_class(sites[0].y), point[1], bits_),
                                  rounded_sum(-mpq_class(sites[0].r), point[2], bits_)};
        };
        if (a != 0) attempt(mpf_class(sum / mpf_class(a, bits_)));
        if (sum != 0) attempt(mpf_class(mpf_class(c, bits_) / sum));
        return found.value_or(DiagramVertex{nan, nan, nan});
    }

 private:
    using Vector = std::array<mpq_class, 3>;
    struct Row {
        Vector v;  // x, y, r
        mpq_class p;
        Row(const Site& m, const Site& origin)
            : v{mpq_class(m.x) - mpq_class(origin.x), mpq_class(m.y) - mpq_class(origin.y),
                mpq_class(m.r) - mpq_class(origin.r)},
              p(v[0] * v[0] + v[1] * v[1] - v[2] * v[2]) {}
    };
    static Vector cross(const Vector& a, const Vector& b) {
        return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
    static mpq_class form(const Vector& a, const Vector& b) {
        return a[0] * b[0] + a[1] * b[1] - a[2] * b[2];
    }

    /// The definition: the point is R + r_m away from each centre, and sees the three
    /// counterclockwise.
    [[nodiscard]] bool touches(const std::array<mpf_class, 3>& point, const Row& j,
                               const Row& k) const {
        std::array<std::array<mpf_class, 2>, 3> directions;
        for (std::size_t m = 0; m < 3; ++m) {
            const auto relative = [&](std::size_t d) {
                return m == 0 ? mpq_class(0) : m == 1 ? j.v[d] : k.v[d];
            };
            const mpf_class dx = mpf_class(relative(0), bits_) - point[0];
            const mpf_class dy = mpf_class(relative(1), bits_) - point[1];
            const mpf_class away = point[2] + mpf_class(relative(2), bits_);
            if (away <= 0) return false;
            const mpf_class length = sqrt(mpf_class(dx * dx + dy * dy));
            mpf_class error = abs(length - away);
            mpf_mul_2exp(error.get_mpf_t(), error.get_mpf_t(), bits_ / 2);
            EXPECT_LT(error, abs(point[2]) + abs(length)) << "solved wrongly";
            directions[m] = {dx / length, dy / length};
        }
        const auto turn = [&](std::size_t a, std::size_t b) {
            return mpf_class(directions[a][0] * directions[b][1] -
                             directions[a][1] * directions[b][0]);
        };
        return turn(0, 1) + turn(1, 2) + turn(2, 0) > 0;
    }

    mp_bitcnt_t bits_;
};

// Comparison --------------------------------------------------------------------------------------

bool same(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) || a == b;
}

class AdditiveVertices : public testing::TestWithParam<Metric> {
 protected:
    std::mt19937_64 random_{11};
    mp_bitcnt_t bits_ = 1500;
    int found_ = 0;
    int not_finite_ = 0;
    int denormals_ = 0;

    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
    double real() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

    [[nodiscard]] DiagramVertex expected(const Triple& sites) const {
        return GetParam() == Metric::euclidean ? Solver(bits_).solve(sites)
                                               : expected_square(sites, GetParam());
    }

    void check(const Triple& sites, const DiagramVertex& v) {
        const DiagramVertex e = expected(sites);
        if (!same(v.x, e.x) || !same(v.y, e.y) || !same(v.rho, e.rho)) {
            for (const Site& s : sites)
                ADD_FAILURE() << std::hexfloat << s.x << ", " << s.y << ", " << s.r;
            FAIL() << std::hexfloat << v.x << ", " << v.y << ", " << v.rho << ", not " << e.x
                   << ", " << e.y << ", " << e.rho;
        }
        const bool all = std::isnan(v.x) && std::isnan(v.y) && std::isnan(v.rho);
        found_ += static_cast<int>(!all);
        for (const double value : {v.x, v.y, v.rho}) {
            not_finite_ += static_cast<int>(!all && std::isnan(value));
            denormals_ += static_cast<int>(value != 0.0 && std::fabs(value) < 0x1p-1022);
        }
    }

    /// Three sites in both orientations.
    void check(const Triple& sites) {
        const std::vector<Site> all(sites.begin(), sites.end());
        TessellationArrays arrays;
        arrays.metric = GetParam();
        arrays.sites = 3;
        arrays.faces = {{0, 1, 2}, {0, 2, 1}};
        arrays.neighbours = {{1, 1, 1}, {0, 0, 0}};
        const auto v = vertices(Tessellation(arrays, all, {}));
        ASSERT_EQ(v.size(), 2U);
        ASSERT_NO_FATAL_FAILURE(check(sites, v[0]));
        // The rule's order goes by index in the end: equal sites hide each other.
        ASSERT_NO_FATAL_FAILURE(check({sites[0], sites[2], sites[1]}, v[1]));
    }
};

TEST_P(AdditiveVertices, Random) {
    for (int round = 0; round < 3000 / share; ++round) {
        Triple sites;
        for (Site& s : sites) s = {700 * real(), 700 * real(), 200 * real() - 50};
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 1500 / share);
}

TEST_P(AdditiveVertices, Integers) {
    bits_ = 4000;
    for (int round = 0; round < 6000 / share; ++round) {
        const int size = 2 + below(12);
        const double scale = round % 3 == 0 ? 0x1p50 : 1.0;
        Triple sites;
        for (Site& s : sites)
            s = {scale * below(size) + below(2), scale * below(size) + below(2),
                 scale * below(size) / 2};
        // Equal sites have no place in a face together.
        if (sites[0] == sites[1] || sites[0] == sites[2] || sites[1] == sites[2]) continue;
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 2000 / share);
}

/// Sites a few units in the last place apart: the sums and the circles of right triangles have
/// their last bit half way between doubles.
TEST_P(AdditiveVertices, ExactHalves) {
    bits_ = 4000;
    for (int round = 0; round < 2000 / share; ++round) {
        const double base = std::ldexp(1.0, below(100) - 50);
        const auto at = [&](int steps) { return base * (1.0 + 0x1p-52 * steps); };
        const auto few = [&] { return base * 0x1p-52 * below(4); };
        const int x = below(20);
        const int y = below(20);
        const double r = few();
        ASSERT_NO_FATAL_FAILURE(check({{{at(x), at(y), r},
                                        {at(x + 1 + below(9)), at(y), r},
                                        {at(x), at(y + 1 + below(9)), r}}}));
        Triple sites;
        for (Site& s : sites) s = {at(below(20)), at(below(20)), few()};
        if (sites[0] == sites[1] || sites[0] == sites[2] || sites[1] == sites[2]) continue;
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 1000 / share);
}

TEST_P(AdditiveVertices, NearlyDegenerate) {
    bits_ = 6000;
    for (int round = 0; round < 3000 / share; ++round) {
        const double angle = 7 * real();
        Triple sites;
        for (Site& s : sites) {
            const double t = real();
            const double r = std::ldexp(real(), -below(60));
            switch (round % 5) {
                case 0:  // along a line
                    s = {t * std::cos(angle), t * std::sin(angle), 0.01 * below(2)};
                    break;
                case 1:  // touching a common line
                    s = {t * std::cos(angle) - r * std::sin(angle),
                         t * std::sin(angle) + r * std::cos(angle), r};
                    break;
                case 2:  // nearly touching from inside
                    s = {std::ldexp(real(), -below(60)), t * 0x1p-50, 1.0 - t};
                    break;
                case 3:  // touching a common circle
                    s = {(1 + r) * std::cos(7 * t), (1 + r) * std::sin(7 * t), r};
                    break;
                default:  // slivers over a wide range
                    s = {t, std::ldexp(real(), -below(60)), r};
            }
        }
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 500 / share);
}

/// Three discs on a common line, exactly: Q = 0 in the Euclidean metric, and 45° lines in the
/// others.
TEST_P(AdditiveVertices, CommonTangentLine) {
    bits_ = 4000;
    for (int round = 0; round < 2000 / share; ++round) {
        Triple sites;
        const int along = below(4);
        for (Site& s : sites) {
            const double t = below(40);
            const double r = below(8);
            // The normal (3, 4) / 5 makes slanted lines of integers.
            if (along == 0) s = {t, r, r};
            if (along == 1) s = {-r, t, r};
            if (along == 2) s = {4 * t + 3 * r, -3 * t + 4 * r, 5 * r};
            if (along == 3) s = {t + r, t - r, r};
        }
        if (sites[0] == sites[1] || sites[0] == sites[2] || sites[1] == sites[2]) continue;
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 500 / share);
}

TEST_P(AdditiveVertices, HugeAndTiny) {
    bits_ = 3000;
    for (int round = 0; round < 1200 / share; ++round) {
        Triple sites;
        const auto number = [&]() -> double {
            switch (round % 6) {
                case 0:
                    return std::ldexp(2 * real() - 1, 1024);
                case 1:
                    return 0x1p-1074 * (below(41) - 20);
                case 2:
                    return std::ldexp(2 * real() - 1, -1022 + below(40));
                case 3:
                    return std::ldexp(2 * real() - 1, 165 + below(20));
                case 4:
                    return std::ldexp(2 * real() - 1, -165 - below(20));
                default:
                    return std::ldexp(2 * real() - 1, -300);
            }
        };
        for (Site& s : sites) s = {number(), number(), 0.25 * number()};
        if (sites[0] == sites[1] || sites[0] == sites[2] || sites[1] == sites[2]) continue;
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 500 / share);
    EXPECT_GT(denormals_, 100 / share);
    EXPECT_GT(not_finite_, 3 / share);
}

TEST_P(AdditiveVertices, MixedExponents) {
    bits_ = 30000;
    static constexpr int places[] = {-1060, -900, -300, -160, -60, 0, 60, 160, 300, 900, 1020};
    for (int round = 0; round < 150 / share; ++round) {
        Triple sites;
        const auto number = [&] { return std::ldexp(2 * real() - 1, places[below(11)]); };
        for (Site& s : sites) s = {number(), number(), below(2) * 1e-3 * number()};
        ASSERT_NO_FATAL_FAILURE(check(sites));
    }
    EXPECT_GT(found_, 40 / share);
}

TEST_P(AdditiveVertices, OfATessellation) {
    for (const double radius : {0.0, 3.0, 60.0}) {
        std::vector<Site> sites(400);
        for (Site& s : sites)
            s = {std::floor(100 * real()), std::floor(100 * real()), std::floor(radius * real())};
        const Tessellation t = triangulate(sites, GetParam());
        const auto v = vertices(t);
        ASSERT_EQ(v.size(), t.faces().size());
        for (std::size_t f = 0; f < v.size(); ++f) {
            const Face& face = t.faces()[f];
            if (face[0] == infinite) {
                ASSERT_TRUE(std::isnan(v[f].x) && std::isnan(v[f].y) && std::isnan(v[f].rho));
                continue;
            }
            const auto site = [&](std::size_t n) {
                return sites[static_cast<std::size_t>(face[n])];
            };
            ASSERT_NO_FATAL_FAILURE(check({site(0), site(1), site(2)}, v[f]));
            ASSERT_FALSE(std::isnan(v[f].x));
        }
    }
    EXPECT_GT(found_, 1000);
}

INSTANTIATE_TEST_SUITE_P(Metrics, AdditiveVertices,
                         testing::Values(Metric::euclidean, Metric::manhattan, Metric::supremum),
                         [](const auto& metric) { return std::string(name_of(metric.param)); });

/// Three discs on a common line whose last lies between the others have a face by the tie rule
/// alone: its vertex is at infinity.
TEST(EuclideanVertices, OfTheTieRuleAloneAreAtInfinity) {
    const std::vector<Site> sites = {{0, 2, 2}, {10, 2, 2}, {5, 1, 1}};
    TessellationArrays arrays;
    arrays.metric = Metric::euclidean;
    arrays.sites = 3;
    arrays.faces = {{0, 1, 2}, {0, 2, 1}};
    arrays.neighbours = {{1, 1, 1}, {0, 0, 0}};
    const auto v = vertices(Tessellation(arrays, sites, {}));
    EXPECT_TRUE(std::isnan(v[0].x) && std::isnan(v[0].y) && std::isnan(v[0].rho));
    EXPECT_EQ(v[1].x, 5.0);
    EXPECT_GT(v[1].y, 2.0);
}

}  // namespace
}  // namespace signum
