// Batches against the predicates for one question, sign by sign: with every set of instructions
// that the processor has, in every environment, whatever the sites and however they lie.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../../predicates/batch.hpp"
#include "../../predicates/batch/lanes.hpp"
#include "../../predicates/power.hpp"
#include "environments.hpp"
#include "raw_doubles.hpp"

namespace signum {
namespace {

namespace batch = predicates::batch;

template <class S>
S made(double x, double y, double third) {
    if constexpr (std::is_same_v<S, Point>)
        return {x, y};
    else
        return {x, y, third};
}
template <class S>
double third(const S& site) {
    if constexpr (std::is_same_v<S, Site>)
        return site.r;
    else if constexpr (std::is_same_v<S, power::Site>)
        return site.w;
    else
        return 0.0;
}

/// Four sites a question, the first three of which turn left.
template <class S>
using Question = std::array<S, 4>;
template <class S>
struct Columns {
    std::array<std::vector<S>, 4> sites;

    explicit Columns(const std::vector<Question<S>>& questions) {
        for (const Question<S>& question : questions)
            for (std::size_t m = 0; m < 4; ++m) sites[m].push_back(question[m]);
    }
};

// ---- the sites --------------------------------------------------------------------------------

enum class Kind { uniform, grid, line, circle, huge, tiny, mixed };
constexpr Kind kinds[] = {Kind::uniform, Kind::grid, Kind::line, Kind::circle,
                          Kind::huge,    Kind::tiny, Kind::mixed};

template <class S>
S random_site(Random& random, Kind kind) {
    const auto number = [&]() -> double {
        switch (kind) {
            case Kind::grid:
                return random.below(5);
            case Kind::huge:
                return random.sign() * random.significand() *
                       std::ldexp(1.0, random.between(980, 1023));
            case Kind::tiny:
                return random.sign() * random.below(4) * std::numeric_limits<double>::denorm_min();
            case Kind::mixed:
                return random.sign() * random.significand() *
                       std::ldexp(1.0, random.any({-1070, -300, -20, 0, 1, 20, 300, 1000}));
            default:
                return random.real();
        }
    };
    return made<S>(number(), number(), number());
}

template <class S>
Question<S> random_question(Random& random, Kind kind) {
    for (;;) {
        Question<S> q;
        for (S& site : q) site = random_site<S>(random, kind);
        if (kind == Kind::line) {
            // Nearly on one line, and q nearly at one of them.
            q[2] = made<S>(moved(random, (q[0].x + q[1].x) / 2),
                           moved(random, (q[0].y + q[1].y) / 2), third(q[0]));
            q[3] =
                made<S>(moved(random, q[0].x), moved(random, q[0].y), moved(random, third(q[0])));
        }
        if (kind == Kind::circle) {
            // The corners of a rectangle, one of them a rounding off.
            const double r = third(q[0]);
            q = {made<S>(q[0].x, q[0].y, r), made<S>(q[1].x, q[0].y, r), made<S>(q[1].x, q[1].y, r),
                 made<S>(moved(random, q[0].x), moved(random, q[1].y), r)};
        }
        const Sign turn = ccw(q[0], q[1], q[2]);
        if (turn == 0) continue;
        if (turn < 0) std::swap(q[0], q[1]);
        return q;
    }
}
template <class S>
std::vector<Question<S>> random_questions(Random& random, Kind kind, int count) {
    std::vector<Question<S>> result;
    for (int i = 0; i < count; ++i) result.push_back(random_question<S>(random, kind));
    return result;
}
/// All kinds side by side, so that vectors hold what is decided and what is not.
template <class S>
std::vector<Question<S>> all_kinds(Random& random, int count) {
    std::vector<Question<S>> result;
    for (int i = 0; i < count; ++i) result.push_back(random_question<S>(random, random.any(kinds)));
    return result;
}

// ---- the comparison -----------------------------------------------------------------------------

template <class S>
std::vector<std::int8_t> ccw_one_by_one(const std::vector<Question<S>>& questions) {
    std::vector<std::int8_t> signs;
    for (const Question<S>& q : questions)
        signs.push_back(static_cast<std::int8_t>(ccw(q[0], q[1], q[3])));
    return signs;
}
template <class S>
std::vector<std::int8_t> in_circle_one_by_one(const std::vector<Question<S>>& questions) {
    std::vector<std::int8_t> signs;
    for (const Question<S>& q : questions)
        signs.push_back(static_cast<std::int8_t>(power::in_circle(q[0], q[1], q[2], q[3])));
    return signs;
}

/// Signs that no predicate tells, so that one that is left out is seen; one more than is asked for,
/// which must stay.
std::vector<std::int8_t> unknown(std::size_t count) {
    return std::vector<std::int8_t>(count + 1, 7);
}
void expect_same(std::vector<std::int8_t> found, std::vector<std::int8_t> expected,
                 const std::string& what) {
    expected.push_back(7);
    EXPECT_EQ(found, expected) << what;
}

template <class S>
void expect_all_instructions_right(const std::vector<Question<S>>& questions,
                                   const std::string& what) {
    const Columns<S> columns(questions);
    const std::array<StridedSites, 4> views = {columns.sites[0], columns.sites[1], columns.sites[2],
                                               columns.sites[3]};
    const std::vector<std::int8_t> turns = ccw_one_by_one(questions);
    const std::vector<std::int8_t> circles = in_circle_one_by_one(questions);
    const batch::Questions<3> of_ccw = {
        {&views[0], &views[1], &views[3]}, nullptr, questions.size()};
    const batch::Questions<4> of_in_circle = {
        {&views[0], &views[1], &views[2], &views[3]}, nullptr, questions.size()};
    std::vector<const batch::Instructions*> all = {nullptr};
    for (const batch::Instructions& each : batch::instructions()) all.push_back(&each);
    for (const batch::Instructions* with : all) {
        const std::string name = what + (with == nullptr ? "" : std::string(", ") + with->name);
        std::vector<std::int8_t> signs = unknown(questions.size());
        batch::ccw(with, of_ccw, signs.data());
        expect_same(signs, turns, "ccw " + name);
        signs = unknown(questions.size());
        batch::in_circle(with, of_in_circle, signs.data());
        expect_same(signs, circles, "in_circle " + name);
    }
}

template <class S>
class Batch : public testing::Test {};
using Kinds = testing::Types<Point, Site, power::Site>;
TYPED_TEST_SUITE(Batch, Kinds);

TYPED_TEST(Batch, TellsWhatIsToldOneByOne) {
    Random random(1);
    const int count = static_cast<int>(4000 * effort);
    for (const Kind kind : kinds)
        expect_all_instructions_right(random_questions<TypeParam>(random, kind, count),
                                      "kind " + std::to_string(static_cast<int>(kind)));
    expect_all_instructions_right(all_kinds<TypeParam>(random, 4 * count), "all kinds");
}

// Vectors that are not full, parts of a batch that are not.
TYPED_TEST(Batch, OfAnyLength) {
    Random random(2);
    for (int length = 0; length <= 40; ++length)
        expect_all_instructions_right(all_kinds<TypeParam>(random, length),
                                      std::to_string(length) + " questions");
    for (const int length : {127, 128, 129, 255, 257, 263})
        expect_all_instructions_right(all_kinds<TypeParam>(random, length),
                                      std::to_string(length) + " questions");
}

TYPED_TEST(Batch, InAnyEnvironment) {
    Random random(3);
    const std::vector<Question<TypeParam>> questions = all_kinds<TypeParam>(random, 300);
    const Columns<TypeParam> columns(questions);
    const auto& [i, j, k, q] = columns.sites;
    const std::vector<std::int8_t> turns = ccw_one_by_one(questions);
    const std::vector<std::int8_t> circles = in_circle_one_by_one(questions);
    for (int environment = 0; environment < environments; ++environment) {
        std::vector<std::int8_t> signs(questions.size());
        within(environment, [&] {
            ccw_batch(i, j, q, signs);
            return 0;
        });
        EXPECT_EQ(signs, turns) << name_of_environment(environment);
        within(environment, [&] {
            power::in_circle_batch(i, j, k, q, signs);
            return 0;
        });
        EXPECT_EQ(signs, circles) << name_of_environment(environment);
    }
}

// Columns, rows of a matrix, an odd place in memory: all the same signs.
TYPED_TEST(Batch, OfSitesThatLieAnyhow) {
    Random random(4);
    const std::vector<Question<TypeParam>> questions = all_kinds<TypeParam>(random, 300);
    const std::vector<std::int8_t> turns = ccw_one_by_one(questions);
    const std::vector<std::int8_t> circles = in_circle_one_by_one(questions);
    const std::size_t n = questions.size();
    constexpr bool has_third = !std::is_same_v<TypeParam, Point>;
    constexpr bool is_weight = std::is_same_v<TypeParam, power::Site>;
    // Where a question's numbers stand: how far apart those of one site, those of two sites.
    for (const auto& [apart, step] :
         {std::array<std::size_t, 2>{n, 1}, {1, 4}, {1, 3}, {1, 5}, {2, 7}})
        for (const std::size_t offset : {0U, 1U, 3U}) {
            std::array<std::vector<double>, 4> numbers;
            std::array<StridedSites, 4> views;
            for (std::size_t m = 0; m < 4; ++m) {
                numbers[m].assign(offset + 3 * n + step * n + 8, std::nan(""));
                double* const first = numbers[m].data() + offset;
                for (std::size_t i = 0; i < n; ++i) {
                    const TypeParam& site = questions[i][m];
                    first[i * step] = site.x;
                    first[i * step + apart] = site.y;
                    if (has_third) first[i * step + 2 * apart] = third(site);
                }
                views[m] =
                    StridedSites(n, static_cast<std::ptrdiff_t>(step * sizeof(double)), first,
                                 first + apart, has_third ? first + 2 * apart : nullptr, is_weight);
            }
            std::vector<std::int8_t> signs(n + 1, 7);
            const std::span<std::int8_t> odd = std::span(signs).subspan(1);
            ccw_batch(views[0], views[1], views[3], odd);
            EXPECT_EQ(std::vector<std::int8_t>(odd.begin(), odd.end()), turns)
                << apart << ' ' << step;
            power::in_circle_batch(views[0], views[1], views[2], views[3], odd);
            EXPECT_EQ(std::vector<std::int8_t>(odd.begin(), odd.end()), circles)
                << apart << ' ' << step;
            EXPECT_EQ(signs.front(), 7);
        }
}

TYPED_TEST(Batch, OfOneFaceAndManySites) {
    Random random(5);
    for (const int length : {1, 7, 8, 130, 300}) {
        std::vector<Question<TypeParam>> questions = all_kinds<TypeParam>(random, length);
        for (Question<TypeParam>& each : questions)
            std::copy_n(questions.front().begin(), 3, each.begin());
        const std::span<const TypeParam> face(questions.front());
        const Columns<TypeParam> columns(questions);
        std::vector<std::int8_t> signs(questions.size());
        ccw_batch(face.subspan(0, 1), face.subspan(1, 1), columns.sites[3], signs);
        EXPECT_EQ(signs, ccw_one_by_one(questions));
        power::in_circle_batch(face.subspan(0, 1), face.subspan(1, 1), face.subspan(2, 1),
                               columns.sites[3], signs);
        EXPECT_EQ(signs, in_circle_one_by_one(questions));
    }
}

TYPED_TEST(Batch, OfSitesNamedByPlaces) {
    Random random(6);
    for (const int length : {0, 1, 9, 300}) {
        const std::vector<Question<TypeParam>> questions = all_kinds<TypeParam>(random, length);
        std::vector<TypeParam> sites;
        std::vector<std::array<Index, 3>> triples;
        std::vector<std::array<Index, 4>> quadruples;
        for (auto each = questions.rbegin(); each != questions.rend(); ++each)
            sites.insert(sites.end(), each->begin(), each->end());
        for (Index i = length; i-- > 0;) {
            triples.push_back({4 * i, 4 * i + 1, 4 * i + 3});
            quadruples.push_back({4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
        }
        std::vector<std::int8_t> signs(questions.size());
        ccw_batch(sites, triples, signs);
        EXPECT_EQ(signs, ccw_one_by_one(questions));
        power::in_circle_batch(sites, quadruples, signs);
        EXPECT_EQ(signs, in_circle_one_by_one(questions));
    }
}

// A batch that asks one question after another would pass all tests above.
TYPED_TEST(Batch, IsDecidedByVectors) {
    if (batch::instructions().empty()) GTEST_SKIP() << "batches are built without vectors";
    Random random(7);
    const std::vector<Question<TypeParam>> questions =
        random_questions<TypeParam>(random, Kind::uniform, 10000);
    const Columns<TypeParam> columns(questions);
    const std::array<StridedSites, 4> views = {columns.sites[0], columns.sites[1], columns.sites[2],
                                               columns.sites[3]};
    std::vector<std::int8_t> signs(questions.size());
    for (const batch::Instructions& with : batch::instructions()) {
        EXPECT_LT(batch::ccw(&with, {{&views[0], &views[1], &views[3]}, nullptr, questions.size()},
                             signs.data()),
                  questions.size() / 100)
            << with.name;
        EXPECT_LT(
            batch::in_circle(
                &with, {{&views[0], &views[1], &views[2], &views[3]}, nullptr, questions.size()},
                signs.data()),
            questions.size() / 100)
            << with.name;
    }
}

#if defined(SIGNUM_WITH_HIGHWAY) && defined(__x86_64__)
TEST(BatchInstructions, AreThoseOfTheProcessor) {
    EXPECT_EQ(batch::instructions().empty(), !__builtin_cpu_supports("sse4.2"));
}
#endif

}  // namespace
}  // namespace signum
