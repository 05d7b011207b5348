// The stages below multiprecision allocate no memory: every predicate is asked of sites that drive
// it into each of its stages, and whatever allocates is counted.

#include <gmp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <new>
#include <random>
#include <tuple>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/space.hpp"
#include "../../predicates/formulas/facets.hpp"
#include "../../predicates/supremum.hpp"

namespace {

/// By operator new, GMP and MPFR, which asks GMP for its functions.
long allocations = 0;

/// Calls between two of these stay there, though many predicates are called pure.
long allocations_so_far() {
    asm volatile("" ::: "memory");
    return allocations;
}

void* counted_for_gmp(std::size_t size) {
    ++allocations;
    return std::malloc(size);
}
void* counted_again_for_gmp(void* memory, std::size_t, std::size_t size) {
    ++allocations;
    return std::realloc(memory, size);
}
void free_for_gmp(void* memory, std::size_t) {
    std::free(memory);
}

}  // namespace

[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace signum {
namespace {

/// Numbers near ties: small integers, of which some are moved by an ulp or, where they are 0, by a
/// power of two; all multiplied by the same one.
class TiedNumbers {
 public:
    /// For other sites than before.
    void next() {
        constexpr int farthest[] = {1, 60, 100, 180, 1000};
        farthest_ = farthest[below(5)];
        grid_ = below(2) == 0 ? 3 : 9;
        scale_ = below(4) == 0 ? below(600) - 300 : 0;
    }
    [[nodiscard]] double number() {
        double result = below(grid_);
        if (farthest_ > 1 && below(4) == 0)
            result = result != 0.0 ? std::nextafter(result, below(2) == 0 ? 0.0 : HUGE_VAL)
                                   : std::ldexp(below(3) - 1, -below(farthest_));
        return std::ldexp(result, scale_);
    }
    template <class S>
    [[nodiscard]] S site() {
        S result{number(), number()};
        if constexpr (requires { result.z; }) result.z = number();
        if constexpr (requires { result.w; }) result.w = number();
        if constexpr (requires { result.r; }) result.r = number();
        return result;
    }
    template <class S, std::size_t n>
    [[nodiscard]] std::array<S, n> sites() {
        std::array<S, n> result;
        for (S& s : result) s = site<S>();
        return result;
    }

 private:
    [[nodiscard]] int below(int count) {
        return static_cast<int>(bits_() % static_cast<unsigned>(count));
    }

    std::mt19937 bits_{20};
    int farthest_ = 1;
    int grid_ = 3;
    int scale_ = 0;
};

class Allocations : public testing::Test {
 protected:
    void SetUp() override {
        mp_get_memory_functions(&allocate_, &reallocate_, &free_);
        mp_set_memory_functions(counted_for_gmp, counted_again_for_gmp, free_for_gmp);
    }
    void TearDown() override { mp_set_memory_functions(allocate_, reallocate_, free_); }

    /// Asks a predicate of n sites of a kind; `stages` are those that must have answered.
    template <class S, std::size_t n, class Predicate>
    void ask(const char* name, std::initializer_list<Stage> stages, const Predicate& predicate) {
        long calls[stage_count] = {};
        long allocated[stage_count] = {};
        for (int trial = 0; trial < 5000; ++trial) {
            numbers_.next();
            const std::array<S, n> sites = numbers_.sites<S, n>();
            const long before = allocations_so_far();
            const auto stage = static_cast<std::size_t>(std::apply(predicate, sites).stage);
            allocated[stage] += allocations_so_far() - before;
            ++calls[stage];
        }
        for (const Stage stage : stages)
            EXPECT_GT(calls[static_cast<std::size_t>(stage)], 0)
                << name << " by " << name_of(stage);
        for (const Stage stage : {Stage::filter, Stage::refine, Stage::exact, Stage::essa})
            EXPECT_EQ(allocated[static_cast<std::size_t>(stage)], 0)
                << name << " by " << name_of(stage);
#if !defined(SIGNUM_WITHOUT_GMP)
        constexpr auto last = static_cast<std::size_t>(Stage::multiprecision);
        EXPECT_EQ(allocated[last] > 0, calls[last] > 0) << name;
#endif
    }

    TiedNumbers numbers_;

 private:
    void* (*allocate_)(std::size_t) = nullptr;
    void* (*reallocate_)(void*, std::size_t, std::size_t) = nullptr;
    void (*free_)(void*, std::size_t) = nullptr;
};

/// The last answer, by the dearest of the stages: of one question that needs another one's answer.
template <class... Decisions>
[[nodiscard]] Decision after(const Decision& first, const Decisions&... more) {
    if constexpr (sizeof...(more) == 0) {
        return first;
    } else {
        const Decision last = after(more...);
        return {last.sign, std::max(first.stage, last.stage)};
    }
}

constexpr auto filter = Stage::filter;
constexpr auto refine = Stage::refine;
constexpr auto exact = Stage::exact;
constexpr auto essa = Stage::essa;
constexpr auto multiprecision = Stage::multiprecision;

/// The stages of the predicates of points, of sites that carry a weight and of circles.
template <class S>
class AllocationsOfPower : public Allocations {};
using KindsOfSites = testing::Types<Point, power::Site, Site>;
TYPED_TEST_SUITE(AllocationsOfPower, KindsOfSites);

TYPED_TEST(AllocationsOfPower, OfThePlane) {
    using S = TypeParam;
    this->template ask<S, 3>(
        "ccw", {filter, exact, multiprecision},
        [](const S& a, const S& b, const S& c) { return ccw_decision(a, b, c); });
    this->template ask<S, 4>("in_circle", {filter, refine, exact, multiprecision},
                             [](const S& i, const S& j, const S& k, const S& q) {
                                 const Decision turn = ccw_decision(i, j, k);
                                 if (turn.sign <= 0) return turn;
                                 return after(turn, power::in_circle_decision(i, j, k, q));
                             });
    this->template ask<S, 3>("in_segment", {filter, exact, multiprecision},
                             [](const S& a, S b, S q) {
                                 b.y = q.y = a.y;
                                 if (a.x == b.x) return Decision{0, filter};
                                 return power::in_segment_decision(a, b, q);
                             });
    this->template ask<S, 3>("nearer", {filter, exact, multiprecision},
                             [](const S& p, const S& a, const S& b) {
                                 return power::nearer_decision(power::centre(p), a, b);
                             });
}

/// The stages of the predicates of a metric.
template <class>
constexpr std::initializer_list<Stage> stages_of = {filter, exact, essa};
template <>
constexpr std::initializer_list<Stage> stages_of<euclidean::Perturbed<>> = {filter, exact,
                                                                            multiprecision};
template <>
constexpr std::initializer_list<Stage> stages_of<supremum::Perturbed<Arithmetic::sum>> = {essa};
template <>
constexpr std::initializer_list<Stage> stages_of<supremum::Perturbed<Arithmetic::interval>> = {
    filter, essa};

template <class Perturbed>
class AllocationsOfAdditive : public Allocations {};
using AdditivePredicates =
    testing::Types<euclidean::Perturbed<>, supremum::Perturbed<>, manhattan::Perturbed<>,
                   supremum::Perturbed<Arithmetic::sum>, supremum::Perturbed<Arithmetic::interval>>;
TYPED_TEST_SUITE(AllocationsOfAdditive, AdditivePredicates);

TYPED_TEST(AllocationsOfAdditive, OfThePlane) {
    using P = TypeParam;
    const auto two = [](const Site& a, const Site& b) { return additive::ranks_of<2>({&a, &b}); };
    const auto three = [](const Site& a, const Site& b, const Site& c) {
        return additive::ranks_of<3>({&a, &b, &c});
    };
    const auto four = [](const Site& a, const Site& b, const Site& c, const Site& d) {
        return additive::ranks_of<4>({&a, &b, &c, &d});
    };
    this->template ask<Site, 2>("hides", stages_of<P>, [&](const Site& i, const Site& q) {
        return P::hides(i, q, two(i, q));
    });
    this->template ask<Site, 3>("nearer", stages_of<P>,
                                [&](const Site& p, const Site& a, const Site& b) {
                                    return P::nearer({p.x, p.y}, a, b, two(a, b));
                                });
    this->template ask<Site, 3>("exists", stages_of<P>,
                                [&](const Site& i, const Site& j, const Site& k) {
                                    return P::exists(i, j, k, three(i, j, k));
                                });
    this->template ask<Site, 3>("exists_twice", stages_of<P>,
                                [&](const Site& i, const Site& j, const Site& k) {
                                    return P::exists_twice(i, j, k, three(i, j, k));
                                });
    this->template ask<Site, 4>(
        "in_circle", stages_of<P>, [&](const Site& i, const Site& j, const Site& k, const Site& q) {
            const Decision exists = P::exists(i, j, k, three(i, j, k));
            if (exists.sign < 0) return exists;
            return after(exists, P::in_circle(i, j, k, q, four(i, j, k, q)));
        });
    this->template ask<Site, 4>(
        "precedes_on_bisector", stages_of<P>,
        [&](const Site& i, const Site& j, const Site& q, const Site& k) {
            const Decision of_q = P::exists_twice(i, j, q, three(i, j, q));
            const Decision of_k = P::exists_twice(i, j, k, three(i, j, k));
            if (of_q.sign < 0 || of_k.sign < 0) return after(of_q, of_k);
            return after(of_q, of_k, P::precedes_on_bisector(i, j, q, k, four(i, j, q, k)));
        });
    // The sign is +1 where one of the two hides the other.
    const auto covers = [&](const Site& a, const Site& b) {
        const Decision there = P::hides(a, b, two(a, b));
        return there.sign > 0 ? there : after(there, P::hides(b, a, two(b, a)));
    };
    this->template ask<Site, 3>(
        "in_circle_infinite", stages_of<P>, [&](const Site& a, const Site& b, const Site& q) {
            const Decision covered = covers(a, b);
            if (covered.sign > 0) return covered;
            return after(covered, P::in_circle_infinite(a, b, q, three(a, b, q)));
        });
    this->template ask<Site, 3>(
        "holds_first_direction", stages_of<P>, [&](const Site& k, const Site& s, const Site& l) {
            const Decision of_k = covers(k, s);
            const Decision of_l = covers(l, s);
            if (of_k.sign > 0 || of_l.sign > 0) return after(of_k, of_l);
            return after(of_k, of_l, P::holds_first_direction(k, s, l, three(k, s, l)));
        });
    this->template ask<Site, 4>(
        "in_order_at_infinity", stages_of<P>,
        [&](const Site& s, const Site& k, const Site& q, const Site& l) {
            const Decision of_k = covers(k, s);
            const Decision of_q = covers(q, s);
            const Decision of_l = covers(l, s);
            if (of_k.sign > 0 || of_q.sign > 0 || of_l.sign > 0) return after(of_k, of_q, of_l);
            return after(of_k, of_q, of_l,
                         P::in_order_at_infinity(s, k, q, l, false, four(s, k, q, l)));
        });
}

template <class S>
class AllocationsOfSpace : public Allocations {};
using KindsOfSites3 = testing::Types<Point3, power::Site3, Site3>;
TYPED_TEST_SUITE(AllocationsOfSpace, KindsOfSites3);

TYPED_TEST(AllocationsOfSpace, OfPower) {
    using S = TypeParam;
    this->template ask<S, 4>(
        "ccw", {filter, exact, multiprecision},
        [](const S& a, const S& b, const S& c, const S& d) { return ccw_decision(a, b, c, d); });
    this->template ask<S, 5>("in_sphere", {filter, refine, exact, multiprecision},
                             [](const S& i, const S& j, const S& k, const S& l, const S& q) {
                                 const Decision turn = ccw_decision(i, j, k, l);
                                 if (turn.sign <= 0) return turn;
                                 return after(turn, power::in_sphere_decision(i, j, k, l, q));
                             });
    this->template ask<S, 3>("nearer", {filter, multiprecision},
                             [](const S& p, const S& a, const S& b) {
                                 return power::nearer_decision({p.x, p.y, p.z}, a, b);
                             });
}

TEST_F(Allocations, OfBalls) {
    ask<Site3, 2>("hides", {filter, exact, multiprecision}, euclidean::hides_decision);
    ask<Site3, 4>("exists", {filter, exact, multiprecision},
                  [](const Site3& i, const Site3& j, const Site3& k, const Site3& l) {
                      return euclidean::exists_decision(i, j, k, l);
                  });
    ask<Site3, 5>(
        "in_sphere", {filter, exact, multiprecision},
        [](const Site3& i, const Site3& j, const Site3& k, const Site3& l, const Site3& q) {
            const Decision exists = euclidean::exists_decision(i, j, k, l);
            if (exists.sign < 0) return exists;
            return after(exists, euclidean::in_sphere_decision(i, j, k, l, q));
        });
    ask<Site, 3>("exists", {filter, exact, multiprecision}, euclidean::balls::exists_decision);
    ask<Site, 4>("in_circle", {filter, exact, multiprecision},
                 [](const Site& i, const Site& j, const Site& k, const Site& q) {
                     const Decision exists = euclidean::balls::exists_decision(i, j, k);
                     if (exists.sign < 0) return exists;
                     return after(exists, euclidean::balls::in_circle_decision(i, j, k, q));
                 });
}

template <class Shape>
class AllocationsOfFacets : public Allocations {};
using Shapes = testing::Types<rectangular::Cube, rectangular::Octahedron>;
TYPED_TEST_SUITE(AllocationsOfFacets, Shapes);

TYPED_TEST(AllocationsOfFacets, OfSpace) {
    using Shape = TypeParam;
    this->template ask<Site3, 2>("hides", {filter, exact, essa},
                                 rectangular::hides_decision<Shape>);
    this->template ask<Site3, 5>(
        "spheres, in_sphere", {filter, exact, essa},
        [](const Site3& i, const Site3& j, const Site3& k, const Site3& l, const Site3& q) {
            const rectangular::Spheres spheres = rectangular::spheres<Shape>(i, j, k, l);
            const Decision found = {0, spheres.stage};
            if (spheres.infinitely_many || spheres.count == 0) return found;
            return after(found,
                         rectangular::in_sphere_decision<Shape>(i, j, k, l, spheres.spheres[0], q));
        });
}

}  // namespace
}  // namespace signum
