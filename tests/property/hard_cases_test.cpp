// The hard cases of tests/hard/: what the library says of each is what the oracles have written
// there, whatever builds the tessellation and in every floating-point environment.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../../predicates/euclidean.hpp"
#include "../../predicates/manhattan.hpp"
#include "../../predicates/power.hpp"
#include "../../predicates/supremum.hpp"
#include "../../triangulation/triangulate.hpp"
#include "../hard/plane_case.hpp"
#include "../thoroughness.hpp"
#include "environments.hpp"

namespace signum {
namespace {

using Case = hard::Case;
using hard::Lines;

/// Of the environments one in so many: there each case takes long.
constexpr int share = is_fast ? 1 : environments;

/// How the library is asked.
struct Way {
    Options options;
    int environment = 0;
};

/// The predicates of a metric on sites S, whose third number is a radius or a weight.
template <class S>
struct PowerPredicates {
    static bool hidden(const S& q, const S& i) { return power::hidden(q, i); }
    static bool exists(const S& i, const S& j, const S& k) { return power::exists(i, j, k); }
    static Sign in_circle(const S& i, const S& j, const S& k, const S& q) {
        return power::in_circle(i, j, k, q);
    }
    static Sign in_circle_perturbed(const S& i, const S& j, const S& k, const S& q,
                                    const std::array<Index, 4>& ranks) {
        return power::in_circle_perturbed(i, j, k, q, ranks);
    }
    static Sign in_circle_infinite_perturbed(const S& a, const S& b, const S& q,
                                             const std::array<Index, 3>& ranks) {
        return power::in_circle_infinite_perturbed(a, b, q, ranks);
    }
};
#define SIGNUM_PREDICATES_OF(NAME, SPACE)                                                          \
    struct NAME {                                                                                  \
        static constexpr auto& exists = SPACE::exists;                                             \
        static constexpr auto& in_circle = SPACE::in_circle;                                       \
        static constexpr auto& in_circle_perturbed = SPACE::in_circle_perturbed;                   \
        static constexpr auto& in_circle_infinite_perturbed = SPACE::in_circle_infinite_perturbed; \
        static bool hidden(const Site& q, const Site& i) { return SPACE::hidden(q, i); }           \
    }
SIGNUM_PREDICATES_OF(EuclideanPredicates, euclidean);
SIGNUM_PREDICATES_OF(ManhattanPredicates, manhattan);
SIGNUM_PREDICATES_OF(SupremumPredicates, supremum);
#undef SIGNUM_PREDICATES_OF

double size_of(const Site& site) {
    return site.r;
}
double size_of(const power::Site& site) {
    return site.w;
}

template <class Predicates, class S>
class LibraryAnswers : public hard::PlaneAnswers {
 public:
    LibraryAnswers(Metric metric, std::vector<S> sites, const Way& way)
        : metric_(metric), sites_(std::move(sites)), way_(way) {}

    bool hides(Number i, Number q) const override {
        return ask([&] { return Predicates::hidden(sites_[q], sites_[i]); });
    }
    bool exists(Number i, Number j, Number k) const override {
        return ask([&] { return Predicates::exists(sites_[i], sites_[j], sites_[k]); });
    }
    char in_circle(Number i, Number j, Number k, Number q) const override {
        return hard::letter(ask([&]() -> int {
            return Predicates::in_circle(sites_[i], sites_[j], sites_[k], sites_[q]);
        }));
    }
    bool conflicts(Number i, Number j, Number k, Number q) const override {
        const auto ranks = ranks_of<4>({i, j, k, q});
        return ask([&] {
            return Predicates::in_circle_perturbed(sites_[i], sites_[j], sites_[k], sites_[q],
                                                   ranks) > 0;
        });
    }
    bool conflicts_at_infinity(Number a, Number b, Number q) const override {
        const auto ranks = ranks_of<3>({a, b, q});
        return ask([&] {
            return Predicates::in_circle_infinite_perturbed(sites_[a], sites_[b], sites_[q],
                                                            ranks) > 0;
        });
    }
    std::vector<std::array<std::int32_t, 3>> faces() const override {
        return {whole().faces().begin(), whole().faces().end()};
    }
    std::vector<std::array<std::int32_t, 2>> hidden() const override {
        std::vector<std::array<std::int32_t, 2>> result;
        for (const Hidden& h : whole().hidden()) result.push_back({h.site, h.by});
        return result;
    }

 private:
    template <class Question>
    auto ask(const Question& question) const {
        return within(way_.environment, question);
    }
    /// Places in the order of the tie rule: falling weight or radius, rising x, y, index.
    template <std::size_t n>
    std::array<Index, n> ranks_of(const std::array<Number, n>& numbers) const {
        const auto size = [&](const S& site) {
            return std::is_same_v<S, Site> && metric_ == Metric::power ? std::abs(size_of(site))
                                                                       : size_of(site);
        };
        const auto key = [&](std::size_t m) {
            const S& site = sites_[numbers[m]];
            return std::tuple(-size(site), site.x, site.y, m);
        };
        std::array<Index, n> ranks{};
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b) ranks[a] += static_cast<Index>(key(b) < key(a));
        return ranks;
    }
    const Tessellation& whole() const {
        if (whole_ == nullptr) {
            Options options = way_.options;
            if (!builds(options.method, metric_)) options.method = Method::incremental;
            whole_ = std::make_unique<Tessellation>(
                ask([&] { return triangulate(sites_, metric_, options); }));
        }
        return *whole_;
    }

    Metric metric_;
    std::vector<S> sites_;
    Way way_;
    mutable std::unique_ptr<Tessellation> whole_;
};

std::unique_ptr<hard::PlaneAnswers> answers_of(const std::string& metric,
                                               const std::vector<Site>& sites, const Way& way) {
    if (metric == "weights") {
        std::vector<power::Site> weighted;
        for (const Site& site : sites) weighted.push_back({site.x, site.y, site.r});
        return std::make_unique<LibraryAnswers<PowerPredicates<power::Site>, power::Site>>(
            Metric::power, weighted, way);
    }
    if (metric == "power")
        return std::make_unique<LibraryAnswers<PowerPredicates<Site>, Site>>(Metric::power, sites,
                                                                             way);
    if (metric == "euclidean")
        return std::make_unique<LibraryAnswers<EuclideanPredicates, Site>>(Metric::euclidean, sites,
                                                                           way);
    if (metric == "manhattan")
        return std::make_unique<LibraryAnswers<ManhattanPredicates, Site>>(Metric::manhattan, sites,
                                                                           way);
    return std::make_unique<LibraryAnswers<SupremumPredicates, Site>>(Metric::supremum, sites, way);
}

Lines answers_of(const Case& given, const Way& way) {
    return hard::plane_answers(
        given,
        [&](const char* metric, const std::vector<Site>& sites) {
            return answers_of(metric, sites, way);
        },
        [&](const Site& a, const Site& b, const Site& c) {
            return within(way.environment, [&]() -> int { return ccw(a, b, c); });
        });
}

std::vector<std::string> files() {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(SIGNUM_SOURCES "/tests/hard"))
        if (entry.path().extension() == ".txt") result.push_back(entry.path().string());
    std::ranges::sort(result);
    return result;
}

TEST(HardCases, AreThere) {
    EXPECT_GT(files().size(), 20);
}

TEST(HardCases, ADifferenceIsFound) {
    using hard::agrees;
    EXPECT_EQ(hard::shortened("--0++++"), "-*2 0 +*4");
    EXPECT_TRUE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - - 0 +*3 +"));
    EXPECT_TRUE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - ? 0 ?*4"));
    EXPECT_FALSE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: -*2 0 +*5"));
    EXPECT_FALSE(agrees("ccw 0 1 2: -*2 0 +*4", "ccw 0 1 2: - 0*2 +*4"));
    EXPECT_FALSE(agrees("ccw 0 1 2: - ?", "ccw 0 1 2: - 0"));
    EXPECT_FALSE(agrees("  a 0 1 2, 0 2 3", "  a 0 1 2, 0 2 4"));
}

TEST(HardCases, MoveByUlpsAcrossZeroAndToTheEnds) {
    EXPECT_EQ(hard::moved_by_ulps(1.0, 1), 0x1.0000000000001p0);
    EXPECT_EQ(hard::moved_by_ulps(1.0, -1), 0x1.fffffffffffffp-1);
    EXPECT_EQ(hard::moved_by_ulps(0x1p-1074, -2), -0x1p-1074);
    EXPECT_EQ(hard::moved_by_ulps(-0.0, 3), 0x3p-1074);
    EXPECT_THROW(static_cast<void>(hard::moved_by_ulps(0x1.fffffffffffffp1023, 1)),
                 std::out_of_range);
}

class HardCase : public testing::TestWithParam<std::string> {};

TEST_P(HardCase, IsWhatTheOraclesSay) {
    const Case given = hard::read_case(GetParam());
    ASSERT_FALSE(given.expected.empty()) << "run make_hard_cases";
    std::vector<Way> ways;
    for (int environment = 0; environment < environments; environment += share)
        ways.push_back({{.seed = static_cast<std::uint64_t>(environment)}, environment});
    for (const Method method : {Method::flips, Method::sweep}) ways.push_back({{.method = method}});
    for (const Arithmetic arithmetic : all_arithmetics)
        if (is_exact(arithmetic)) ways.push_back({{.arithmetic = arithmetic}});
    for (const Way& way : ways) {
        SCOPED_TRACE(name_of_environment(way.environment) + ", " +
                     std::string(name_of(way.options.method)) + ", " +
                     std::string(name_of(way.options.arithmetic)));
        const Lines answered = answers_of(given, way);
        ASSERT_EQ(answered.size(), given.expected.size());
        for (std::size_t i = 0; i < answered.size(); ++i)
            ASSERT_TRUE(hard::agrees(answered[i], given.expected[i]))
                << "the library says " << answered[i] << "\n     the oracle says "
                << given.expected[i];
    }
}

INSTANTIATE_TEST_SUITE_P(Files, HardCase, testing::ValuesIn(files()), [](const auto& file) {
    return std::filesystem::path(file.param).stem().string();
});

}  // namespace
}  // namespace signum
