/// How many files of predicates/ a call of a public predicate goes through: three at most, those
/// that docs/exactness.md names.

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sources.hpp"

namespace signum {
namespace {

const fs::path predicates = root / "predicates";

/// A row of the table: what its first column says, and its files.
struct Path {
    std::string names;
    std::set<std::string> files;
};

std::vector<Path> paths_of_the_page() {
    const std::string page = text_of(root / "docs" / "exactness.md");
    std::istringstream lines(page.substr(page.find("| predicate | header | source | ladder |")));
    std::vector<Path> paths;
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    static const std::regex file("`([a-z_/]+\\.[ch]pp)`");
    while (std::getline(lines, line) && line.starts_with("| ")) {
        Path path{line.substr(2, line.find(" |") - 2), {}};
        for (std::sregex_iterator each(line.begin(), line.end(), file), end; each != end; ++each)
            path.files.insert((*each)[1]);
        paths.push_back(path);
    }
    return paths;
}

/// What a file of predicates/ includes of it, by its path there.
std::set<std::string> included_by(const std::string& file) {
    const std::string text = text_of(predicates / file);
    static const std::regex include("#include \"([^\"]+)\"");
    std::set<std::string> files;
    for (std::sregex_iterator each(text.begin(), text.end(), include), end; each != end; ++each) {
        const fs::path found =
            (predicates / file).parent_path().append((*each)[1].str()).lexically_normal();
        const std::string path = found.lexically_relative(predicates).string();
        if (!path.starts_with("..")) files.insert(path);
    }
    return files;
}

/// What takes no part in a decision: formulas, names of arithmetics and of stages, kinds of sites,
/// ties, and the lists of names that users include.
bool is_beside(const std::string& file) {
    static const std::set<std::string> beside = {"arithmetic.hpp",
                                                 "ladder/decision.hpp",
                                                 "ladder/doubted.hpp",
                                                 "ladder/exact_number.hpp",
                                                 "ladder/with_arithmetic.hpp",
                                                 "additive.hpp",
                                                 "power/weight.hpp",
                                                 "power/ties.hpp",
                                                 "euclidean.hpp",
                                                 "space/euclidean.hpp",
                                                 "space/rectangular.hpp"};
    return file.starts_with("formulas/") || beside.contains(file);
}

TEST(Paths, AreOfThreeFilesAtMost) {
    const std::vector<Path> paths = paths_of_the_page();
    ASSERT_GE(paths.size(), 11U);
    std::set<std::string> headers;
    for (const Path& path : paths)
        for (const std::string& file : path.files)
            if (file.ends_with(".hpp")) headers.insert(file);
    for (const Path& path : paths) {
        EXPECT_LE(path.files.size(), 3U) << path.names;
        EXPECT_GE(path.files.size(), 2U) << path.names;
        for (const std::string& file : path.files) {
            ASSERT_TRUE(fs::exists(predicates / file)) << file;
            for (const std::string& other : included_by(file)) {
                if (path.files.contains(other) || is_beside(other)) continue;
                // Another predicate, which is asked as anybody asks it, has a row of its own; its
                // ladder it has to itself.
                EXPECT_TRUE(headers.contains(other) && !other.starts_with("ladder/"))
                    << path.names << ": " << file << " includes " << other;
            }
        }
    }
}

TEST(Paths, AreThoseOfEveryPredicate) {
    std::string all;
    for (const Path& path : paths_of_the_page()) all += path.names + '\n';
    static const std::regex function(
        "inline (?:Sign|bool) ([a-z_]+)\\(|constexpr auto& ([a-z_]+) =");
    for (const std::string header :
         {"ccw.hpp", "power.hpp", "euclidean.hpp", "supremum.hpp", "manhattan.hpp", "space/ccw.hpp",
          "space/in_sphere.hpp", "space/nearer.hpp", "space/euclidean.hpp",
          "space/rectangular.hpp"}) {
        const std::string text = text_of(predicates / header);
        std::size_t seen = 0;
        for (std::sregex_iterator each(text.begin(), text.end(), function), end; each != end;
             ++each) {
            const std::string name = (*each)[1].matched ? (*each)[1] : (*each)[2];
            // The same with the stage that decided, or under the tie rule.
            if (name.ends_with("_decision") || name.ends_with("_perturbed")) continue;
            // Helpers of filters.
            if (name.starts_with("in_filter") || name == "same_radius") continue;
            ++seen;
            // They ask ccw and nearer.
            if (header == "power.hpp" && (name == "exists" || name == "hidden")) continue;
            EXPECT_TRUE(all.find("`" + name + "`") != std::string::npos ||
                        all.find("::" + name + "`") != std::string::npos)
                << header << ' ' << name;
        }
        EXPECT_TRUE(seen > 0 || header == "space/nearer.hpp") << header;
    }
}

}  // namespace
}  // namespace signum
