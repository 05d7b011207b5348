/// Imports point one way only: reads every include of the project and compares it with the arrows
/// that are drawn in ARCHITECTURE.md.

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

const fs::path root = SIGNUM_SOURCES;

using Arrows = std::map<std::string, Layers>;

/// The arrows of a drawing of ARCHITECTURE.md, counted from 0: to each room from those that it may
/// include, at once or by way of others.
Arrows drawn(std::size_t number) {
    std::ifstream page(root / "ARCHITECTURE.md");
    Arrows arrows;
    std::string line;
    for (std::size_t skipped = 0; skipped <= number && std::getline(page, line);)
        skipped += static_cast<std::size_t>(line == "```mermaid");
    std::getline(page, line);  // flowchart BT
    while (std::getline(page, line) && line != "```") {
        std::istringstream words(line);
        std::string from, arrow, to;
        words >> from >> arrow >> to;
        arrows[from];
        if (arrow == "-->") arrows[to].insert(from);
    }
    for (std::size_t steps = 0; steps < arrows.size(); ++steps)
        for (auto& [room, targets] : arrows)
            for (const std::string& target : Layers(targets))
                targets.insert(arrows[target].begin(), arrows[target].end());
    return arrows;
}

/// Which layers each layer may include beside itself.
const Arrows& allowed() {
    static const Arrows arrows = [] {
        Arrows table = drawn(0);
        // What these two see are results.
        for (const char* layer : {"io", "draw"})
            for (const char* hidden : {"exact", "filters", "roots", "predicates"})
                table.at(layer).erase(hidden);
        return table;
    }();
    return arrows;
}

/// The same within triangulation/, whose rooms stand between two halves of the folder itself: they
/// all may include its headers, which include none of them; its sources include what they like.
const Arrows& allowed_in_triangulation() {
    static const Arrows arrows = drawn(1);
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

/// The layer of a file: the folder that it lies in at the root, but in tool/ the folder there.
std::string layer_of(const fs::path& file) {
    auto folder = file.begin();
    if (*folder == "tool") ++folder;
    return folder->string();
}

/// What is wrong with an include from one file of triangulation/ to another; empty when nothing is.
std::string complaint_within_triangulation(const fs::path& file, const fs::path& target) {
    const auto room_of = [](const fs::path& path) {
        return path.parent_path().filename().string();
    };
    const std::string from = room_of(file);
    const std::string to = room_of(target);
    if (from == to || to == "triangulation") return {};
    if (from == "triangulation")
        return file.extension() == ".cpp" ? ""
                                          : "a header of the folder includes none of its rooms";
    const auto arrows = allowed_in_triangulation().find(from);
    if (arrows == allowed_in_triangulation().end()) return from + " is no room";
    return arrows->second.contains(to) ? "" : "no arrow from " + from + " to " + to;
}

/// The same in motion/: structures stand on the folder's headers, which know none of them; its
/// sources may.
std::string complaint_within_motion(const fs::path& file, const fs::path& target) {
    const bool to_structure = target.parent_path() == "motion/structures";
    if (!to_structure || file.parent_path() == "motion/structures" || file.extension() == ".cpp")
        return {};
    return "a header of the folder knows no structure";
}

/// What is wrong with the includes of a file; its path is relative to the root, as are those that
/// `exists` knows. Inside the project files name one another by relative paths, so that whoever
/// reads them, human or tool, follows an arrow without configuring anything; <signum/...> is for
/// programs that use the library.
template <class Exists>
std::vector<std::string> complaints(const fs::path& file, std::istream& text, Exists exists) {
    const std::string layer = layer_of(file);
    // Its headers are installed elsewhere than they lie.
    const bool is_for_users = file.string().starts_with("bindings/interop/");
    std::vector<std::string> result;
    std::string line;
    while (std::getline(text, line)) {
        const std::optional<Include> include = included(line);
        if (!include) continue;
        const std::string& path = include->path;
        if (!include->quoted) {
            if (path.starts_with("signum/") && !is_for_users)
                result.push_back("<" + path + ">: within the project the path is relative");
            continue;
        }
        const fs::path target = (file.parent_path() / path).lexically_normal();
        const std::string to = layer_of(target);
        if (!exists(target)) {
            result.push_back("\"" + path + "\": there is no " + target.string());
        } else if (!allowed().contains(to)) {
            result.push_back("\"" + path + "\": " + to + " is no layer");
        } else if (to != layer && !allowed().at(layer).contains(to)) {
            result.push_back("\"" + path + "\": no arrow from " + layer + " to " + to);
        } else if (to == "triangulation" && layer == to) {
            const std::string complaint = complaint_within_triangulation(file, target);
            if (!complaint.empty()) result.push_back("\"" + path + "\": " + complaint);
        } else if (to == "motion" && layer == to) {
            const std::string complaint = complaint_within_motion(file, target);
            if (!complaint.empty()) result.push_back("\"" + path + "\": " + complaint);
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

TEST(IncludeDirection, OfEveryLayerFollowsTheTable) {
    const auto exists = [](const fs::path& path) { return fs::exists(root / path); };
    for (const auto& [layer, targets] : allowed()) {
        const fs::path folder = root / layer;
        const std::vector<fs::path> sources =
            sources_in(fs::exists(folder) ? folder : root / "tool" / layer);
        EXPECT_FALSE(sources.empty()) << layer;
        for (const fs::path& source : sources) {
            std::ifstream text(source);
            const fs::path file = source.lexically_relative(root);
            for (const std::string& complaint : complaints(file, text, exists))
                ADD_FAILURE() << file.string() << ": " << complaint;
        }
    }
}

TEST(IncludeDirection, DrawingsHaveNoCircle) {
    for (const Arrows* arrows : {&allowed(), &allowed_in_triangulation()}) {
        EXPECT_GT(arrows->size(), 5);
        for (const auto& [room, targets] : *arrows) EXPECT_FALSE(targets.contains(room)) << room;
    }
}

TEST(IncludeDirection, EveryRoomOfTriangulationIsDrawn) {
    for (const auto& entry : fs::directory_iterator(root / "triangulation"))
        if (entry.is_directory()) {
            EXPECT_TRUE(allowed_in_triangulation().contains(entry.path().filename().string()))
                << entry.path();
        }
}

TEST(IncludeDirection, EveryFolderWithAHeaderIsKnown) {
    const Layers others = {"tests",    "fuzz",    "proofs", "benchmarks",
                           "examples", "scripts", "docs",   "packaging"};
    for (const auto& entry : fs::directory_iterator(root / "tool"))
        if (entry.is_directory()) {
            EXPECT_TRUE(allowed().contains(entry.path().filename().string())) << entry.path();
        }
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() || name.starts_with('.') || name.starts_with("build")) continue;
        if (name == "tool" || sources_in(entry.path()).empty()) continue;
        EXPECT_TRUE(allowed().contains(name) || others.contains(name)) << name;
    }
}

/// The files of the project that a file includes, relative to the root.
std::vector<fs::path> own_includes(const fs::path& source) {
    std::vector<fs::path> result;
    std::ifstream text(source);
    std::string line;
    while (std::getline(text, line)) {
        const std::optional<Include> include = included(line);
        if (!include || !include->quoted) continue;
        result.push_back(
            (source.parent_path() / include->path).lexically_normal().lexically_relative(root));
    }
    return result;
}

TEST(IncludeDirection, OracleSharesOnlyThePlainTypes) {
    std::size_t seen = 0;
    for (const fs::path& source : sources_in(root / "tests" / "oracle"))
        for (const fs::path& include : own_includes(source)) {
            ++seen;
            EXPECT_TRUE(*include.begin() == "core" || include.parent_path() == "tests/oracle")
                << source.filename().string() << ": " << include.string();
        }
    EXPECT_GT(seen, 0);
}

TEST(IncludeDirection, TopologyKnowsNoCoordinate) {
    const std::vector<fs::path> includes =
        own_includes(root / "triangulation" / "structure" / "topology.hpp");
    EXPECT_FALSE(includes.empty());
    for (const fs::path& include : includes)
        EXPECT_FALSE(*include.begin() == "predicates" || include == "core/site.hpp") << include;
}

// The test of the test.
TEST(IncludeDirection, WrongArrowsAreFound) {
    const auto count = [](const fs::path& file, const std::string& line) {
        std::istringstream text(line);
        return complaints(file, text, [](const fs::path& path) { return path != "core/far.hpp"; })
            .size();
    };
    EXPECT_EQ(count("core/a.hpp", "#include \"../exact/expansion.hpp\""), 1);
    EXPECT_EQ(count("filters/a.hpp", "  #  include \"../exact/expansion.hpp\"  // why"), 1);
    EXPECT_EQ(count("exact/a.cpp", "#include \"../filters/verdict.hpp\""), 1);
    EXPECT_EQ(count("tool/io/a.cpp", "#include \"../../predicates/ccw.hpp\""), 1);
    EXPECT_EQ(count("tool/io/a.cpp", "#include \"../draw/svg.hpp\""), 1);
    EXPECT_EQ(count("triangulation/flips/a.cpp", "#include \"../../tool/cli/commands.hpp\""), 1);
    EXPECT_EQ(count("core/a.hpp", "#include \"../utils/all.hpp\""), 1);
    EXPECT_EQ(count("core/a.hpp", "#include <signum/core/sign.hpp>"), 1);
    EXPECT_EQ(count("core/a.hpp", "#include \"far.hpp\""), 1);
    EXPECT_EQ(count("triangulation/flips/a.cpp",
                    "#include \"near.hpp\"\n#include \"../../core/sign.hpp\"\n"
                    "#include \"../structure/topology.hpp\"\n"
                    "#include <vector>\n// #include \"../../tool/io/number.hpp\"\n"),
              0);
    EXPECT_EQ(count("triangulation/structure/a.hpp", "#include \"../flips/b.hpp\""), 1);
    EXPECT_EQ(count("triangulation/arrays.hpp", "#include \"structure/topology.hpp\""), 1);
    EXPECT_EQ(count("triangulation/attic/a.hpp", "#include \"../flips/b.hpp\""), 1);
    EXPECT_EQ(count("triangulation/validate.cpp", "#include \"check/power_check.hpp\""), 0);
    EXPECT_EQ(count("triangulation/structure/a.hpp", "#include \"../arrays.hpp\""), 0);
    EXPECT_EQ(count("motion/loop.hpp", "#include \"structures/lists.hpp\""), 1);
    EXPECT_EQ(count("motion/start.cpp", "#include \"structures/grid.hpp\""), 0);
    EXPECT_EQ(count("motion/structures/lists.hpp", "#include \"../world.hpp\""), 0);
}

}  // namespace
