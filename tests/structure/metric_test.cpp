/// The table of metrics, and the names under which it is found.

#include "../../triangulation/metric.hpp"
#include "sources.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace signum {
namespace {

/// Of the sources above the predicates, and of the tests, by path from the root, what is no
/// comment.
std::map<std::string, std::string> code() {
    static const std::regex comment("//[^\n]*");
    std::map<std::string, std::string> result;
    const auto read = [&](const fs::path& file) {
        static const std::set<std::string> endings = {".hpp", ".cpp", ".h", ".py"};
        if (endings.contains(file.extension().string()))
            result[file.lexically_relative(root).string()] =
                std::regex_replace(text_of(file), comment, "");
    };
    for (const char* room : {"triangulation", "voronoi", "tool", "bindings", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(root / room)) read(entry.path());
    read(root / "signum.hpp");
    return result;
}

bool is_test(const std::string& file) {
    return file.find("tests/") != std::string::npos;
}

/// The places at which metrics are told apart by their enumerators.
std::size_t distinctions(const std::string& text) {
    static const std::regex distinction(
        "case Metric::|[!=]= ?Metric::|Metric::[a-z]+ ?[!=]=|"
        "is_same_v<[^;{]*(Perturbed|Manhattan|Supremum|Euclidean)");
    return static_cast<std::size_t>(std::distance(
        std::sregex_iterator(text.begin(), text.end(), distinction), std::sregex_iterator()));
}

TEST(Metric, IsFoundByItsNamesHoweverWritten) {
    EXPECT_EQ(metric_named("power"), Metric::power);
    EXPECT_EQ(metric_named("Laguerre"), Metric::power);
    EXPECT_EQ(metric_named("EUCLIDEAN"), Metric::euclidean);
    EXPECT_EQ(metric_named("L1"), Metric::manhattan);
    EXPECT_EQ(metric_named("city-block"), Metric::manhattan);
    EXPECT_EQ(metric_named("L_inf"), Metric::supremum);
    EXPECT_EQ(metric_named("l-inf"), Metric::supremum);
    EXPECT_EQ(metric_named("Chebyshev"), Metric::supremum);
    EXPECT_EQ(metric_named("l3"), std::nullopt);
    EXPECT_EQ(metric_named("euclid"), std::nullopt);
    EXPECT_EQ(metric_named(""), std::nullopt);
    EXPECT_EQ(metric_named("-"), std::nullopt);
}

TEST(Metric, NamesAreDifferent) {
    std::set<std::string_view> names;
    for (const MetricTraits& traits : metric_table) {
        EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
        EXPECT_EQ(metric_named(traits.name), traits.metric);
        for (const std::string_view alias : traits.aliases) {
            if (alias.empty()) continue;
            EXPECT_TRUE(names.insert(alias).second) << alias;
            EXPECT_EQ(metric_named(alias), traits.metric) << alias;
        }
    }
}

TEST(Metric, BecomesTheTypeOfItsRow) {
    for (const Metric metric : all_metrics)
        with_metric(metric, [&]<class M>(M) {
            EXPECT_EQ(M::metric, metric);
            EXPECT_EQ(M::traits.name, name_of(metric));
        });
    EXPECT_THROW(with_metric(static_cast<Metric>(all_metrics.size()), [](auto) {}),
                 std::invalid_argument);
}

TEST(Metric, IsToldApartInNoFile) {
    for (const auto& [file, text] : code())
        EXPECT_TRUE(is_test(file) || distinctions(text) == 0) << file;
}

TEST(Metric, DistinctionsAreFound) {
    EXPECT_EQ(distinctions("switch (m) { case Metric::power: return 1; }"), 1);
    EXPECT_EQ(distinctions("if (metric == Metric::power || Metric::euclidean != metric) f();"), 2);
    EXPECT_EQ(distinctions("if constexpr (std::is_same_v<D, rectangular::Supremum>) f();"), 1);
    EXPECT_EQ(distinctions("Metric metric = Metric::power; f(Metric::euclidean);"), 0);
}

/// The recipe for another metric in CONTRIBUTING.md names every file that has code for one alone:
/// those that name the type of the Euclidean metric, its predicates, their header or its number, or
/// the corners of a diamond; and the tests that a compiler refuses. They are the metric's own,
/// which have its name, or are to be edited: eight at most. The diagram of balls in space has that
/// metric alone.
TEST(Metric, RecipeNamesEveryPlace) {
    static const std::regex of_one(
        "([(<]|struct )(Euclidean|Manhattan|Supremum)\\b|\\b(euclidean|manhattan|supremum)::|"
        "\\brectangular::(Manhattan|Supremum)\\b|SIGNUM_EUCLIDEAN|predicates/euclidean\\.hpp\"|"
        "\"manhattan\":");
    static const std::regex own_name("euclidean|rectangular");
    static const std::regex of_one_in_tests("case Metric::euclidean:");
    std::set<std::string> places;
    for (const auto& [file, text] : code())
        if (!file.starts_with("voronoi/balls/") && file != "tests/structure/metric_test.cpp" &&
            std::regex_search(text, is_test(file) ? of_one_in_tests : of_one))
            places.insert(std::regex_replace(file, own_name, "NAME"));

    const std::string page = text_of(root / "CONTRIBUTING.md");
    const std::size_t begin = page.find("## Add a metric");
    ASSERT_NE(begin, std::string::npos);
    const std::string recipe = page.substr(begin, page.find("\n## ", begin) - begin);
    static const std::regex path(
        "(\n- )?`((?:triangulation|voronoi)/[a-z/]*NAME[a-z_]*\\.cpp|"
        "[a-z_/]+\\.(?:hpp|cpp|h|py))`");
    std::set<std::string> named;
    std::size_t edited = 0;
    for (std::sregex_iterator match(recipe.begin(), recipe.end(), path), end; match != end;
         ++match) {
        if ((*match)[2] == "tests/structure/metric_test.cpp") continue;
        named.insert((*match)[2]);
        edited += (*match)[1].matched;
    }
    EXPECT_EQ(named, places);
    EXPECT_LE(edited, 8);
}

/// The numbers of C are those of C++.
TEST(Metric, HasItsNumberInC) {
    const std::string header = text_of(root / "bindings/c/signum.h");
    for (const Metric metric : all_metrics) {
        std::string name(name_of(metric));
        std::ranges::transform(name, name.begin(),
                               [](char c) { return static_cast<char>(c - 'a' + 'A'); });
        EXPECT_NE(header.find("SIGNUM_" + name + " = " + std::to_string(static_cast<int>(metric))),
                  std::string::npos)
            << name;
    }
}

}  // namespace
}  // namespace signum
