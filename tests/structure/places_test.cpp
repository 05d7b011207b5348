/// At how many places a format, a subcommand, an effect or a structure is known: at those that
/// CONTRIBUTING.md names.

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "../../motion/simulation.hpp"
#include "../../tool/cli/formats.hpp"
#include "../../tool/io/read_sites.hpp"
#include "sources.hpp"

namespace signum {
namespace {

using Files = std::set<std::string>;

std::string section_under(const std::string& heading) {
    const std::string page = text_of(root / "CONTRIBUTING.md");
    const std::size_t from = page.find("\n## " + heading + "\n");
    if (from == std::string::npos) return {};
    return page.substr(from + 1, page.find("\n## ", from + 1) - from - 1);
}

/// The files that a section of CONTRIBUTING.md names, but for those with NAME in their names; and
/// the folders, which end in /.
Files named_under(const std::string& heading, bool with_folders = false) {
    const std::string section = section_under(heading);
    static const std::regex path("`((tool|motion|bindings)/([a-z_/]+\\.[a-z]+|([a-z_]+/)*))`");
    Files files;
    for (std::sregex_iterator each(section.begin(), section.end(), path), end; each != end; ++each)
        if (with_folders || !(*each)[1].str().ends_with("/")) files.insert((*each)[1]);
    return files;
}

/// Those of a folder whose text matches, but for those that match `own`.
Files that_match(const std::string& pattern, const std::string& own = "^$",
                 const std::string& folder = "tool") {
    const std::regex wanted(pattern), left_out(own);
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        static const std::set<std::string> endings = {".hpp", ".cpp", ".h", ".py"};
        if (!endings.contains(entry.path().extension().string())) continue;
        const std::string text = text_of(entry.path());
        if (std::regex_search(text, wanted) && !std::regex_search(text, left_out))
            files.insert(entry.path().lexically_relative(root).string());
    }
    return files;
}

TEST(Places, OfAnInputFormat) {
    const Files places = named_under("Add an input format");
    EXPECT_EQ(places.size(), 2U);  // and the reader, a source and its header
    for (const SitesInputKind& kind : sites_input_kinds()) {
        // text is what all others are not, and node the last one, of which a check speaks.
        if (kind.input == SitesInput::text || kind.input == SitesInput::node) continue;
        const std::string name(kind.name);
        Files found = that_match(
            "SitesInput::" + name + "\\b|read_" + name + "_sites|\\b" + name + ",? *///<",
            "SitesFile read_" + name +
                "_sites\\(InputFile& file(, const ReadOptions& options)?\\) \\{");
        for (const std::string& place : places) EXPECT_EQ(found.erase(place), 1U) << name << place;
        ASSERT_EQ(found.size(), 1U) << name;
        EXPECT_TRUE(found.begin()->ends_with(".hpp")) << name;
    }
}

TEST(Places, OfAnOutputFormat) {
    // And the subcommands that write it.
    Files places = named_under("Add an output format");
    EXPECT_EQ(places.size(), 1U);
    places.merge(that_match("outputs\\.write\\("));
    std::size_t seen = 0;
    const auto expect_places = [&](const auto& formats) {
        for (const cli::Format& format : formats) {
            // Others speak of these, too: what stands for the default, pictures and numbers.
            if (std::set<std::string_view>{"json", "csv", "svg", "png", "pdf"}.contains(
                    format.name))
                continue;
            for (const std::string& file : that_match('"' + std::string(format.name) + '"')) {
                if (file.ends_with("_sites.cpp") || file.ends_with("read_faces.cpp"))
                    continue;  // readers
                EXPECT_TRUE(places.contains(file)) << format.name << ' ' << file;
                ++seen;
            }
        }
    };
    expect_places(cli::triangulate_formats);
    expect_places(cli::voronoi_formats);
    EXPECT_GT(seen, 20U);
}

TEST(Places, OfASubcommand) {
    const Files places = named_under("Add a subcommand");
    EXPECT_EQ(places.size(), 2U);  // and its own file
    for (const std::string name : {"triangulate", "voronoi", "compare", "validate", "simulate"})
        EXPECT_EQ(
            that_match("\\badd_" + name + "\\(", "void add_" + name + "\\(CLI::App& tool\\) \\{"),
            places)
            << name;
}

/// Nothing else names them; a path that ends in / is a folder whose files may.
void expect_named_at(const Files& places, const std::string& pattern) {
    std::size_t seen = 0;
    for (const std::string folder : {"motion", "tool", "bindings"})
        for (const std::string& file : that_match(pattern, "^$", folder)) {
            if (file.starts_with("bindings/python/tests/")) continue;
            const bool is_place = std::any_of(places.begin(), places.end(), [&](const auto& each) {
                return file == each || (each.ends_with("/") && file.starts_with(each));
            });
            EXPECT_TRUE(is_place) << pattern << ' ' << file;
            ++seen;
        }
    EXPECT_GT(seen, 1U) << pattern;
}

TEST(Places, OfAnEffect) {
    const Files places = named_under("Add an effect", true);
    EXPECT_EQ(section_under("Add an effect").find("\n7. "), std::string::npos);
    for (const std::string& place : places) EXPECT_TRUE(fs::exists(root / place)) << place;
    motion::Effects<2>::each_field([&](auto, const motion::Field& field) {
        const std::string name(field.name);
        if (field.without.empty()) return;  // gravity, restitution and boxes are everywhere
        expect_named_at(places, "\\b(effects_?|e)(\\.|->)" + name + "\\b|\"" + name + "\"");
    });
}

TEST(Places, OfAStructure) {
    const Files places = named_under("Add a structure", true);
    EXPECT_EQ(section_under("Add a structure").find("\n4. "), std::string::npos);
    for (const motion::Structure each : motion::all_structures)
        if (each != motion::Structure::automatic)
            expect_named_at(places, "Structure::" + std::string(motion::name_of(each)) + "\\b");
}

}  // namespace
}  // namespace signum
