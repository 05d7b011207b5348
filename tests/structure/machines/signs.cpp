/// A fixed program that must print the same on every machine, whatever compiles it, whatever the
/// library computes with, in every floating-point environment: signs of all predicates in all
/// metrics, on ordinary and on hostile operands, and tessellations of these. A line a predicate:
/// how often -1, 0 and +1, and a hash of all in their order. Its own arithmetic commits no
/// rounding.
///
///   signs [nearest|upward|downward|zero|flush]     exit code 3: no such environment here

#include <array>
#include <bit>
#include <cfenv>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <signum/exact/sign_of_sum.hpp>
#include <signum/predicates/euclidean.hpp>
#include <signum/predicates/manhattan.hpp>
#include <signum/predicates/power.hpp>
#include <signum/predicates/space.hpp>
#include <signum/predicates/supremum.hpp>
#include <signum/triangulation/construction/construct.hpp>
#include <signum/triangulation/space/triangulate.hpp>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace {

using signum::Index;
using signum::Point;
using signum::Point3;
using signum::Site;
using signum::Site3;

class Random {
 public:
    /// splitmix64.
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }
    /// In [low, high].
    int between(int low, int high) {
        return low + static_cast<int>((bits() >> 20) % static_cast<std::uint64_t>(high - low + 1));
    }

 private:
    std::uint64_t state_ = 1;
};
Random random;

// How a coordinate comes about. Integers of at most 53 bits become doubles without rounding, and so
// do their products with powers of two.

/// Any finite double.
struct Raw {
    static constexpr const char* name = "raw bits";
    static double number() {
        const std::uint64_t bits = random.bits();
        const bool is_finite = (bits >> 52 & 0x7FF) != 0x7FF;
        return std::bit_cast<double>(is_finite ? bits : bits ^ std::uint64_t{1} << 60);
    }
};
struct Ordinary {
    static constexpr const char* name = "53 bits";
    static double number() {
        const auto significand = static_cast<std::int64_t>(random.bits() >> 11);
        return static_cast<double>(significand - (std::int64_t{1} << 52)) * 0x1p-52;
    }
};
/// Ties.
struct Grid {
    static constexpr const char* name = "a grid";
    static double number() { return random.between(-4, 4); }
};
/// Ties, moved by 0 to 4 ulps.
struct Near {
    static constexpr const char* name = "beside a grid";
    static double number() {
        const double number = Grid::number();
        if (number == 0.0 || random.between(0, 2) != 0) return number;
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(number) +
                                     static_cast<std::uint64_t>(random.between(0, 4)));
    }
};
/// Few digits, exponents within 60 of each other.
struct Wide {
    static constexpr const char* name = "many scales";
    static double number() {
        const auto exponent = static_cast<std::uint64_t>(1023 + random.between(-34, 26));
        return random.between(-9, 9) * std::bit_cast<double>(exponent << 52);
    }
};
/// In the expression that asks: a product and a sum, neither of them rounded, to be taken apart by
/// compilers that may.
struct Computed {
    static constexpr const char* name = "computed";
    static double number() {
        const double u = random.between(-5000, 5000);
        const double v = random.between(0, 3);
        const double w = random.between(-3, 3) * 0x1p-20;
        return u * 0x1p-30 * v + w;
    }
};

/// What was answered so far.
class Answers {
 public:
    void note(int sign) {
        ++counts_[static_cast<std::size_t>(sign + 1)];
        mix(static_cast<std::uint64_t>(sign + 2));
    }
    /// FNV-1a, but of whole words.
    void mix(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001B3U; }
    void print(const char* what, const char* numbers) const {
        std::printf("%-36s %-14s %6d %6d %6d  %016llx\n", what, numbers, counts_[0], counts_[1],
                    counts_[2], static_cast<unsigned long long>(hash_));
    }
    [[nodiscard]] std::uint64_t hash() const { return hash_; }

 private:
    std::array<int, 3> counts_{};
    std::uint64_t hash_ = 0xCBF29CE484222325U;
};

/// Raw bits nearly always go on to rationals, which take their time on an emulated machine.
template <class Numbers>
constexpr int rounds = std::same_as<Numbers, Raw> ? 100 : 1000;

/// Asks so often; each question makes up its own operands.
template <class Numbers, class Question>
[[gnu::noinline]] void ask(const char* what, Question question) {
    Answers answers;
    for (int round = 0; round < rounds<Numbers>; ++round) answers.note(question());
    answers.print(what, Numbers::name);
}

template <class S, class Numbers>
S some() {
    if constexpr (std::same_as<S, Point>) {
        const double x = Numbers::number();
        return {x, Numbers::number()};
    } else if constexpr (std::same_as<S, Site3> || std::same_as<S, signum::power::Site3>) {
        const double x = Numbers::number();
        const double y = Numbers::number();
        const double z = Numbers::number();
        return {x, y, z, Numbers::number()};
    } else {
        const double x = Numbers::number();
        const double y = Numbers::number();
        return {x, y, Numbers::number()};
    }
}

template <class S, class Numbers>
void ask_power(const char* what_in_circle, const char* what_infinite, const char* what_nearer,
               const char* what_hidden) {
    using namespace signum::power;
    ask<Numbers>(what_in_circle, [] {
        const S i = some<S, Numbers>();
        const S j = some<S, Numbers>();
        const S k = some<S, Numbers>();
        const S q = some<S, Numbers>();
        const signum::Sign side = signum::ccw(i, j, k);
        if (side == 0) return 0;
        return side > 0 ? in_circle(i, j, k, q) : in_circle(i, k, j, q);
    });
    ask<Numbers>(what_infinite, [] {
        const S a = some<S, Numbers>();
        const S b = some<S, Numbers>();
        using signum::filters::same_number;
        if (same_number(a.x, b.x) && same_number(a.y, b.y)) return 0;
        return in_circle_infinite(a, b, some<S, Numbers>());
    });
    ask<Numbers>(what_nearer, [] {
        const Point p = some<Point, Numbers>();
        const S a = some<S, Numbers>();
        return nearer(p, a, some<S, Numbers>());
    });
    ask<Numbers>(what_hidden, [] {
        const S a = some<S, Numbers>();
        S b = some<S, Numbers>();
        b.x = a.x;
        b.y = a.y;
        return hidden(a, b) ? 1 : -1;
    });
}

template <class Metric, class Numbers>
struct Additive {
    static Site site() { return some<Site, Numbers>(); }

    static void ask(const std::array<const char*, 7>& what) {
        const auto one = [](auto perturbed) { return perturbed.sign; };
        ::ask<Numbers>(what[0], [&] {
            const Site i = site();
            return one(Metric::hides(i, site(), {0, 1}));
        });
        ::ask<Numbers>(what[1], [&] {
            const Point p = some<Point, Numbers>();
            const Site a = site();
            return one(Metric::nearer(p, a, site(), {0, 1}));
        });
        ::ask<Numbers>(what[2], [&] {
            const Site i = site();
            const Site j = site();
            return one(Metric::exists(i, j, site(), {0, 1, 2}));
        });
        ::ask<Numbers>(what[3], [&] {
            const Site i = site();
            const Site j = site();
            return one(Metric::exists_twice(i, j, site(), {0, 1, 2}));
        });
        ::ask<Numbers>(what[4], [&] {
            const Site i = site();
            const Site j = site();
            const Site k = site();
            const Site q = site();
            const auto ranks = signum::additive::ranks_of<4>({&i, &j, &k, &q});
            if (!is(Metric::exists_twice(i, j, q, {ranks[0], ranks[1], ranks[3]})) ||
                !is(Metric::exists_twice(i, j, k, {ranks[0], ranks[1], ranks[2]})))
                return 0;
            return one(Metric::precedes_on_bisector(i, j, q, k, ranks));
        });
        ::ask<Numbers>(what[5], [&] {
            Site i = site();
            Site j = site();
            const Site k = site();
            const Site q = site();
            auto ranks = signum::additive::ranks_of<4>({&i, &j, &k, &q});
            if (!is(Metric::exists(i, j, k, {ranks[0], ranks[1], ranks[2]}))) {
                std::swap(i, j);
                std::swap(ranks[0], ranks[1]);
                if (!is(Metric::exists(i, j, k, {ranks[0], ranks[1], ranks[2]}))) return 0;
            }
            return one(Metric::in_circle(i, j, k, q, ranks));
        });
        ::ask<Numbers>(what[6], [&] {
            const Site a = site();
            const Site b = site();
            const Site q = site();
            const auto ranks = signum::additive::ranks_of<3>({&a, &b, &q});
            if (is(Metric::hides(a, b, {ranks[0], ranks[1]})) ||
                is(Metric::hides(b, a, {ranks[1], ranks[0]})))
                return 0;
            return one(Metric::in_circle_infinite(a, b, q, ranks));
        });
    }

 private:
    static bool is(const signum::Decision& decision) { return decision.sign > 0; }
};

template <class S, class Numbers>
void ask_power_in_space(const char* what_in_sphere, const char* what_nearer) {
    using namespace signum::power;
    ask<Numbers>(what_in_sphere, [] {
        const S i = some<S, Numbers>();
        const S j = some<S, Numbers>();
        const S k = some<S, Numbers>();
        const S l = some<S, Numbers>();
        const S q = some<S, Numbers>();
        const signum::Sign side = signum::ccw(i, j, k, l);
        if (side == 0) return 0;
        return side > 0 ? in_sphere(i, j, k, l, q) : in_sphere(j, i, k, l, q);
    });
    ask<Numbers>(what_nearer, [] {
        const Point3 p = some<Point3, Numbers>();
        const S a = some<S, Numbers>();
        return nearer_decision(p, a, some<S, Numbers>()).sign;
    });
}

template <class Shape, class Numbers>
void ask_rectangular_in_space(const char* what_hides, const char* what_spheres,
                              const char* what_in_sphere) {
    using namespace signum::rectangular;
    ask<Numbers>(what_hides, [] {
        const Site3 i = some<Site3, Numbers>();
        return hides_decision<Shape>(i, some<Site3, Numbers>()).sign;
    });
    Answers of_spheres;
    Answers of_queries;
    for (int round = 0; round < rounds<Numbers> / 3; ++round) {
        std::array<Site3, 4> s;
        for (Site3& each : s) each = some<Site3, Numbers>();
        const Site3 q = some<Site3, Numbers>();
        const Spheres all = spheres<Shape>(s[0], s[1], s[2], s[3]);
        of_spheres.note(all.infinitely_many ? -1 : all.count > 0 ? 1 : 0);
        for (int n = 0; n < all.count; ++n) {
            for (const std::uint8_t facet : all.spheres[static_cast<std::size_t>(n)].facets)
                of_spheres.mix(facet);
            of_queries.note(
                in_sphere<Shape>(s[0], s[1], s[2], s[3], q, static_cast<std::uint8_t>(n)));
        }
    }
    of_spheres.print(what_spheres, Numbers::name);
    of_queries.print(what_in_sphere, Numbers::name);
}

template <class Rows>
void mix_rows(Answers& answers, const Rows& rows) {
    for (const auto& row : rows)
        for (const Index each : row)
            answers.mix(static_cast<std::uint64_t>(static_cast<std::uint32_t>(each)));
}
void mix_hidden(Answers& answers, std::span<const signum::Hidden> hidden) {
    for (const signum::Hidden& each : hidden) {
        answers.mix(static_cast<std::uint64_t>(each.site));
        answers.mix(static_cast<std::uint64_t>(each.by));
    }
}

/// By insertion in exact arithmetic, which triangulate() chooses among others.
template <class Numbers>
void tessellate() {
    for (const signum::Metric metric : signum::all_metrics) {
        std::vector<Site> sites;
        for (int n = 0; n < 150; ++n) {
            Site site = some<Site, Numbers>();
            site.r = std::bit_cast<double>(std::bit_cast<std::uint64_t>(site.r) << 1 >> 1);
            sites.push_back(site);
        }
        const signum::Tessellation t = signum::triangulation::construct(metric, sites, {});
        Answers answers;
        mix_rows(answers, t.faces());
        mix_rows(answers, t.neighbours());
        mix_hidden(answers, t.hidden());
        std::printf("%-20s %-14s %4d faces %3d hidden  %016llx\n", name_of(metric).data(),
                    Numbers::name, static_cast<int>(t.faces().size()),
                    static_cast<int>(t.hidden().size()),
                    static_cast<unsigned long long>(answers.hash()));
    }
    std::vector<Site3> sites;
    for (int n = 0; n < 100; ++n) sites.push_back(some<Site3, Numbers>());
    const signum::SpaceTessellation t = signum::triangulate(sites);
    Answers answers;
    mix_rows(answers, t.cells);
    mix_rows(answers, t.neighbours);
    mix_hidden(answers, t.hidden);
    std::printf("%-20s %-14s %4d cells %3d hidden  %016llx\n", "power, in space", Numbers::name,
                static_cast<int>(t.cells.size()), static_cast<int>(t.hidden.size()),
                static_cast<unsigned long long>(answers.hash()));
}

template <class Numbers>
void ask_all() {
    ask<Numbers>("sign_of_sum", [] {
        std::array<double, 12> terms;
        for (double& each : terms) each = Numbers::number();
        for (std::size_t k = 6; k < 12; ++k)
            if (random.between(0, 3) != 0) terms[k] = -terms[k - 6];
        return signum::sign_of_sum(terms);
    });
    ask<Numbers>("ccw", [] {
        const Point a = some<Point, Numbers>();
        const Point b = some<Point, Numbers>();
        return signum::ccw(a, b, some<Point, Numbers>());
    });
    ask_power<Point, Numbers>("power in_circle, points", "power in_circle_infinite, points",
                              "power nearer, points", "power hidden, points");
    ask_power<signum::power::Site, Numbers>("power in_circle, weights",
                                            "power in_circle_infinite, weights",
                                            "power nearer, weights", "power hidden, weights");
    ask_power<Site, Numbers>("power in_circle, radii", "power in_circle_infinite, radii",
                             "power nearer, radii", "power hidden, radii");
    Additive<signum::euclidean::Perturbed<>, Numbers>::ask(
        {"Euclidean hides", "Euclidean nearer", "Euclidean exists", "Euclidean exists_twice",
         "Euclidean precedes_on_bisector", "Euclidean in_circle", "Euclidean in_circle_infinite"});
    Additive<signum::supremum::Perturbed<>, Numbers>::ask(
        {"supremum hides", "supremum nearer", "supremum exists", "supremum exists_twice",
         "supremum precedes_on_bisector", "supremum in_circle", "supremum in_circle_infinite"});
    Additive<signum::manhattan::Perturbed<>, Numbers>::ask(
        {"Manhattan hides", "Manhattan nearer", "Manhattan exists", "Manhattan exists_twice",
         "Manhattan precedes_on_bisector", "Manhattan in_circle", "Manhattan in_circle_infinite"});
    ask<Numbers>("ccw, space", [] {
        const Point3 a = some<Point3, Numbers>();
        const Point3 b = some<Point3, Numbers>();
        const Point3 c = some<Point3, Numbers>();
        return signum::ccw(a, b, c, some<Point3, Numbers>());
    });
    ask_power_in_space<Point3, Numbers>("power in_sphere, points", "power nearer, points of space");
    ask_power_in_space<signum::power::Site3, Numbers>("power in_sphere, weights",
                                                      "power nearer, weights of space");
    ask_power_in_space<Site3, Numbers>("power in_sphere, radii", "power nearer, radii of space");
    ask<Numbers>("Euclidean hides, space", [] {
        const Site3 i = some<Site3, Numbers>();
        return signum::euclidean::hides_decision(i, some<Site3, Numbers>()).sign;
    });
    ask<Numbers>("Euclidean in_sphere", [] {
        const Site3 i = some<Site3, Numbers>();
        const Site3 j = some<Site3, Numbers>();
        const Site3 k = some<Site3, Numbers>();
        const Site3 l = some<Site3, Numbers>();
        const Site3 q = some<Site3, Numbers>();
        if (signum::euclidean::exists(i, j, k, l))
            return signum::euclidean::in_sphere(i, j, k, l, q);
        if (signum::euclidean::exists(j, i, k, l))
            return signum::euclidean::in_sphere(j, i, k, l, q);
        return 0;
    });
    ask_rectangular_in_space<signum::rectangular::Cube, Numbers>(
        "supremum hides, space", "supremum spheres", "supremum in_sphere");
    ask_rectangular_in_space<signum::rectangular::Octahedron, Numbers>(
        "Manhattan hides, space", "Manhattan spheres", "Manhattan in_sphere");
    tessellate<Numbers>();
}

bool enter(std::string_view environment) {
    if (environment == "nearest") return true;
    if (environment == "upward") return std::fesetround(FE_UPWARD) == 0;
    if (environment == "downward") return std::fesetround(FE_DOWNWARD) == 0;
    if (environment == "zero") return std::fesetround(FE_TOWARDZERO) == 0;
#if defined(__SSE2__)
    if (environment == "flush") {
        _mm_setcsr(_mm_getcsr() | 0x8040);
        return true;
    }
#elif defined(__aarch64__)
    if (environment == "flush") {
        std::uint64_t control = 0;
        asm volatile("mrs %0, fpcr" : "=r"(control));
        asm volatile("msr fpcr, %0" : : "r"(control | std::uint64_t{1} << 24));
        return true;
    }
#endif
    return false;
}

}  // namespace

int main(int count, char** words) {
    if (!enter(count > 1 ? words[1] : "nearest")) return 3;
    ask_all<Raw>();
    ask_all<Ordinary>();
    ask_all<Grid>();
    ask_all<Near>();
    ask_all<Wide>();
    ask_all<Computed>();
}
