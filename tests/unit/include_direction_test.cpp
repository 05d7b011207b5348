/// Imports point one way only: reads every include of the project and compares it with the arrows
/// that ARCHITECTURE.md allows.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using Layers = std::set<std::string>;

/// Which layers each layer may include beside itself.
const std::map<std::string, Layers>& allowed() {
    static const std::map<std::string, Layers> arrows = [] {
        std::map<std::string, Layers> table;
        table["core"] = {};
        table["exact"] = {"core"};
        table["filters"] = {"core"};
        table["predicates"] = {"core", "exact", "filters"};
        table["triangulation"] = {"core", "exact", "filters", "predicates"};
        table["voronoi"] = {"core", "exact", "filters", "predicates", "triangulation"};
        table["generate"] = {"core", "triangulation"};
        for (const char* layer : {"io", "draw"}) {
            table[layer] = {"core", "triangulation", "voronoi"};
        }
        table["study"] = {"core",          "exact",   "filters", "predicates",
                          "triangulation", "voronoi", "draw",    "generate"};
        table["cli"] = {"core",    "exact", "filters", "predicates", "triangulation",
                        "voronoi", "io",    "draw",    "generate",   "study"};
        return table;
    }();
    return arrows;
}

struct Include {
    std::string path;
    bool quoted = false;
};

/// The file that a line includes, if it includes one.
std::optional<Include> included(std::string_view line) {
    const auto skip_blanks = [&line] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    };
    const auto skip = [&line](std::string_view word) {
        if (!line.starts_with(word)) return false;
        line.remove_prefix(word.size());
        return true;
    };
    skip_blanks();
    if (!skip("#")) return {};
    skip_blanks();
    if (!skip("include")) return {};
    skip_blanks();
    if (line.empty() || (line.front() != '<' && line.front() != '"')) return {};
    const bool quoted = line.front() == '"';
    const std::size_t end = line.find(quoted ? '"' : '>', 1);
    if (end == std::string_view::npos) return {};
    return Include{std::string(line.substr(1, end - 1)), quoted};
}

/// What is wrong with the includes of a file of a layer. `exists` says which files the layer has.
template <class Exists>
std::vector<std::string> complaints(const std::string& layer, std::istream& text, Exists exists) {
    std::vector<std::string> result;
    std::string line;
    while (std::getline(text, line)) {
        const std::optional<Include> include = included(line);
        if (!include) continue;
        const std::string& path = include->path;
        if (include->quoted) {
            // In quotes stand neighbours in the same layer.
            if (path.find("..") != std::string::npos || !exists(path)) {
                result.push_back("\"" + path + "\": no file of " + layer);
            }
            continue;
        }
        constexpr std::string_view prefix = "signum/";
        if (!path.starts_with(prefix)) continue;
        const std::string target =
            path.substr(prefix.size(), path.find('/', prefix.size()) - prefix.size());
        if (!allowed().contains(target)) {
            result.push_back("<" + path + ">: " + target + " is no layer");
        } else if (target != layer && !allowed().at(layer).contains(target)) {
            result.push_back("<" + path + ">: no arrow from " + layer + " to " + target);
        }
    }
    return result;
}

bool is_source(const fs::path& path) {
    return path.extension() == ".hpp" || path.extension() == ".cpp";
}

std::vector<fs::path> sources_in(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && is_source(entry.path())) result.push_back(entry.path());
    }
    return result;
}

const fs::path root = SIGNUM_SOURCES;

TEST(IncludeDirection, OfEveryLayerFollowsTheTable) {
    for (const auto& [layer, targets] : allowed()) {
        const std::vector<fs::path> sources = sources_in(root / layer);
        EXPECT_FALSE(sources.empty()) << layer;
        for (const fs::path& source : sources) {
            std::ifstream text(source);
            const auto exists = [&](const std::string& path) {
                return fs::exists(source.parent_path() / path);
            };
            for (const std::string& complaint : complaints(layer, text, exists)) {
                ADD_FAILURE() << source.lexically_relative(root).string() << ": " << complaint;
            }
        }
    }
}

TEST(IncludeDirection, TableIsTransitive) {
    for (const auto& [layer, targets] : allowed()) {
        EXPECT_FALSE(targets.contains(layer)) << layer;
        for (const std::string& target : targets) {
            EXPECT_FALSE(allowed().at(target).contains(layer)) << layer << " and " << target;
            // What io, draw and generate see of these two are results, not predicates.
            if (target == "triangulation" || target == "voronoi") continue;
            for (const std::string& next : allowed().at(target)) {
                EXPECT_TRUE(targets.contains(next)) << layer << " to " << next;
            }
        }
    }
}

TEST(IncludeDirection, EveryFolderWithAHeaderIsKnown) {
    const Layers others = {"tests",    "fuzz",    "proofs", "benchmarks",
                           "examples", "scripts", "docs",   "bindings"};
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() || name.starts_with('.') || name.starts_with("build")) continue;
        if (sources_in(entry.path()).empty()) continue;
        EXPECT_TRUE(allowed().contains(name) || others.contains(name)) << name;
    }
}

TEST(IncludeDirection, OracleSharesOnlyThePlainTypes) {
    for (const fs::path& source : sources_in(root / "tests" / "oracle")) {
        std::ifstream text(source);
        std::string line;
        while (std::getline(text, line)) {
            const std::optional<Include> include = included(line);
            if (!include || !include->path.starts_with("signum/")) continue;
            EXPECT_TRUE(include->path.starts_with("signum/core/"))
                << source.filename().string() << ": " << include->path;
        }
    }
}

TEST(IncludeDirection, TopologyKnowsNoCoordinate) {
    std::ifstream text(root / "triangulation" / "topology.hpp");
    std::string line;
    while (std::getline(text, line)) {
        const std::optional<Include> include = included(line);
        if (!include) continue;
        EXPECT_FALSE(include->path.starts_with("signum/predicates/") ||
                     include->path.starts_with("signum/core/site"))
            << include->path;
    }
}

// The test of the test.
TEST(IncludeDirection, WrongArrowsAreFound) {
    const auto count = [](const std::string& layer, const std::string& line) {
        std::istringstream text(line);
        return complaints(layer, text, [](const std::string& path) { return path == "near.hpp"; })
            .size();
    };
    EXPECT_EQ(count("core", "#include <signum/exact/expansion.hpp>"), 1);
    EXPECT_EQ(count("filters", "  #  include <signum/exact/expansion.hpp>  // why"), 1);
    EXPECT_EQ(count("exact", "#include <signum/filters/verdict.hpp>"), 1);
    EXPECT_EQ(count("io", "#include <signum/predicates/ccw.hpp>"), 1);
    EXPECT_EQ(count("io", "#include <signum/draw/svg.hpp>"), 1);
    EXPECT_EQ(count("triangulation", "#include <signum/cli/commands.hpp>"), 1);
    EXPECT_EQ(count("core", "#include <signum/utils/all.hpp>"), 1);
    EXPECT_EQ(count("core", "#include \"../exact/expansion.hpp\""), 1);
    EXPECT_EQ(count("core", "#include \"far.hpp\""), 1);
    EXPECT_EQ(count("core",
                    "#include \"near.hpp\"\n#include <signum/core/sign.hpp>\n"
                    "#include <vector>\n// #include <signum/io/number.hpp>\n"),
              0);
}

}  // namespace
