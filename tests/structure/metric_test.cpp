/// The table of metrics, and the names under which it is found.

#include "../../triangulation/metric.hpp"
#include "sources.hpp"

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace signum {
namespace {

/// Of the sources above the predicates, by path from the root, what is neither comment nor string.
std::map<std::string, std::string> code() {
    static const std::regex words_for_readers("//[^\n]*|\"[^\"\n]*\"");
    std::map<std::string, std::string> result;
    for (const char* room : {"triangulation", "voronoi", "tool", "bindings"})
        for (const auto& entry : fs::recursive_directory_iterator(root / room))
            if (entry.path().extension() == ".hpp" || entry.path().extension() == ".cpp")
                result[entry.path().lexically_relative(root).string()] =
                    std::regex_replace(text_of(entry.path()), words_for_readers, "");
    return result;
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

TEST(Metric, IsToldApartInOneFile) {
    for (const auto& [file, text] : code())
        EXPECT_EQ(distinctions(text), file == "triangulation/metric.hpp" ? all_metrics.size() : 0)
            << file;
}

TEST(Metric, DistinctionsAreFound) {
    EXPECT_EQ(distinctions("switch (m) { case Metric::power: return 1; }"), 1);
    EXPECT_EQ(distinctions("if (metric == Metric::power || Metric::euclidean != metric) f();"), 2);
    EXPECT_EQ(distinctions("if constexpr (std::is_same_v<D, rectangular::Supremum>) f();"), 1);
    EXPECT_EQ(distinctions("Metric metric = Metric::power; f(Metric::euclidean);"), 0);
}

/// The recipe for another metric in CONTRIBUTING.md names every file that has code for one alone:
/// those that name the type of the Euclidean metric, or its predicates. The diagram of balls in
/// space has that metric alone.
TEST(Metric, RecipeNamesEveryPlace) {
    static const std::regex type(
        "[(<]Euclidean\\b|struct Euclidean\\b|Euclidean\\{|\\beuclidean::");
    std::set<std::string> places;
    for (const auto& [file, text] : code())
        if (!file.starts_with("voronoi/balls/") && std::regex_search(text, type))
            places.insert(file);

    const std::string page = text_of(root / "CONTRIBUTING.md");
    const std::size_t begin = page.find("## Add a metric");
    ASSERT_NE(begin, std::string::npos);
    const std::string recipe = page.substr(begin, page.find("\n## ", begin) - begin);
    static const std::regex path("`((?:triangulation|voronoi|tool|bindings)/[a-z_/]+\\.[ch]pp)`");
    std::set<std::string> named;
    for (std::sregex_iterator match(recipe.begin(), recipe.end(), path), end; match != end; ++match)
        named.insert((*match)[1]);
    EXPECT_EQ(named, places);
}

}  // namespace
}  // namespace signum
