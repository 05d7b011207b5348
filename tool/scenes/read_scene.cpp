#include "read_scene.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "../io/nearest_word.hpp"
#include "document.hpp"
#include "read_effects.hpp"
#include "read_groups.hpp"
#include "section.hpp"

namespace signum {
namespace {

void read_units(const Section& file, Document& document) {
    const auto units = file.optional_section("units");
    if (!units) return;
    constexpr std::array<std::pair<std::string_view, Dimension>, 3> each = {
        {{"length", dimensions::length}, {"time", dimensions::time}, {"mass", dimensions::mass}}};
    Units result;
    for (const auto& [key, dimension] : each) {
        const std::string text = units->optional_text(key);
        if (text.empty()) continue;
        const auto parsed = parse_unit(text);
        if (const auto* const wrong = std::get_if<std::string>(&parsed))
            units->fail_at(key, *wrong);
        const Unit& unit = std::get<Unit>(parsed);
        if (unit.dimension != dimension)
            units->fail_at(
                key, fmt::format("{} is {}; give a unit of {}, such as \"{}\"", in_quotes(text),
                                 in_words(unit.dimension), key, Units().name_of(dimension)));
        result.take(unit, text);
    }
    document.units = result;
}

/// The number of entries of an array, or 0.
int size_of(const toml::node* node) {
    const toml::array* const array = node == nullptr ? nullptr : node->as_array();
    return array == nullptr ? 0 : static_cast<int>(std::min<std::size_t>(array->size(), 9));
}

/// By the key, by the box, by the balls, by gravity, by the walls: by the first that tells it.
int dimension_of(const Section& file) {
    if (const auto said = file.optional_whole("dimension", 2, 3)) return static_cast<int>(*said);
    const auto tells = [](int size) { return size == 2 || size == 3; };
    if (const auto box = file.optional_section("box"))
        for (const std::string_view key : {"low", "high"})
            if (const int size = size_of(box->find(key)); tells(size)) return size;
    if (const int size = dimension_of_groups(file); size != 0) return size;
    if (const auto effects = file.optional_section("effects"))
        if (const int size = size_of(effects->find("gravity")); tells(size)) return size;
    for (const Section& wall : file.sections("wall"))
        for (const std::string_view key : {"normal", "centre"})
            if (const int size = size_of(wall.find(key)); tells(size)) return size;
    file.fail("nothing tells whether this is the plane or space; add dimension = 2, or 3");
}

SceneRun read_run(const Section& file) {
    SceneRun result;
    const auto run = file.optional_section("run");
    if (run) {
        // As far as --until goes.
        result.until = run->optional<double>(
            "until", {dimensions::time, {0.0, 1e150, false, "a number from 0 to 1e+150"}});
        result.events = run->optional_whole("events", 0, std::uint64_t{1} << 62);
        std::vector<std::string> structures;
        for (const motion::Structure each : motion::all_structures)
            structures.emplace_back(motion::name_of(each));
        if (const auto name = run->optional_word("structure", structures))
            result.structure = *motion::structure_named(*name);
        const std::array<std::string, 2> kernels = {"exact", "naive"};
        if (const auto name = run->optional_word("arithmetic", kernels))
            result.kernel = *name == "naive" ? motion::Kernel::naive : motion::Kernel::exact;
    }
    if (!result.until && !result.events) {
        const std::string_view message =
            "nothing says when to end; give until, a time, or events, a number of strikes";
        if (run) run->fail(message);
        file.fail(fmt::format("{}, below [run]", message));
    }
    return result;
}

/// A run of so many steps would take weeks, and of 2^53 and more they would not be told apart.
void refuse_too_many_steps(const Section& file, double time_step, const SceneRun& run) {
    constexpr double most_steps = 1e12;
    if (!run.until || !(time_step > 0.0) || *run.until / time_step <= most_steps) return;
    file.optional_section("run")->fail_at(
        "time_step", fmt::format("{:.2g} steps until the end, and 1e12 are the most; give a longer "
                                 "time_step, or an earlier end",
                                 *run.until / time_step));
}

/// A file of the record: what it is for, where its name goes, and how the name ends.
struct RecordFile {
    std::string_view key;
    std::string SceneRecord::*name;
    std::string_view ending;
    bool is_of_frames;
};
constexpr std::array<RecordFile, 9> record_files = {{
    {"log", &SceneRecord::log, "csv", false},
    {"frames", &SceneRecord::frames, "xyz", true},
    {"film", &SceneRecord::film, "svg", true},
    {"energies", &SceneRecord::energies, "csv", true},
    {"pair_correlation", &SceneRecord::pair_correlation, "csv", true},
    {"images", &SceneRecord::images, "png", true},
    {"video", &SceneRecord::video, "mp4", true},
    {"page", &SceneRecord::page, "html", true},
    {"state", &SceneRecord::state, "json", false},
}};

bool ends_with(const std::string& name, std::string_view ending) {
    return in_small_letters(name).ends_with(fmt::format(".{}", ending));
}

/// Whether a name has one place for the number of an image, and nothing else after %.
bool has_number(const std::string& name) {
    const std::size_t sign = name.find('%');
    if (sign == std::string::npos || name.find('%', sign + 1) != std::string::npos) return false;
    std::size_t i = sign + 1;
    if (i < name.size() && name[i] == '0') ++i;
    if (i < name.size() && name[i] >= '1' && name[i] <= '9') ++i;
    return i < name.size() && name[i] == 'd';
}

void refuse_same_file(const Section& record, std::string_view key, const std::string& name,
                      std::string_view other_key, const std::string& other) {
    std::error_code ignored;
    const auto full = [&](const std::string& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
    };
    if (full(name) == full(other))
        record.fail_at(key,
                       fmt::format("{} is where {} goes, too; give another name", name, other_key));
}

SceneRecord read_record(const Section& file, const SceneRun& run,
                        const std::vector<std::string>& inputs) {
    SceneRecord result;
    const auto record = file.optional_section("record");
    if (!record) return result;
    for (const auto& [key, name, ending, is_of_frames] : record_files) {
        result.*name = record->optional_text(key);
        const std::string& path = result.*name;
        if (path.empty()) continue;
        if (!ends_with(path, ending))
            record->fail_at(key, fmt::format("{} does not end in .{}; give it that ending",
                                             in_quotes(path), ending));
        if (key == "images" && !has_number(path))
            record->fail_at(key, fmt::format("{} has no place for the number of an image; write it "
                                             "like \"image-%04d.png\"",
                                             in_quotes(path)));
        for (const RecordFile& before : record_files) {
            if (before.key == key) break;
            if (!(result.*before.name).empty())
                refuse_same_file(*record, key, path, before.key, result.*before.name);
        }
        for (const std::string& input : inputs)
            refuse_same_file(*record, key, path, "the input", input);
        if (!is_of_frames) continue;
        if (!run.until) record->fail_at(key, "frames need to know the end; add until to [run]");
    }
    result.every = record->optional<double>("every", {dimensions::time, above_0});
    if (!result.every || !run.until) return result;
    constexpr double most_frames = 1e7;
    if (*run.until / *result.every > most_frames)
        record->fail_at("every", "more than 10 million frames; give a longer time");
    return result;
}

template <int D>
Scene<D> scene_of(const Section& file) {
    Scene<D> scene;
    scene.title = file.optional_text("title");
    scene.units = file.document().units;
    scene.effects = read_effects<D>(file);
    const BallsOfScene<D> balls = read_groups<D>(file, scene.effects);
    scene.files = {file.document().path()};
    scene.files.insert(scene.files.end(), balls.files.begin(), balls.files.end());
    scene.notes = balls.notes;
    scene.run = read_run(file);
    refuse_too_many_steps(file, scene.effects.time_step, scene.run);
    scene.record = read_record(file, scene.run, scene.files);
    if (!scene.record.pair_correlation.empty() && !scene.effects.box)
        file.optional_section("record")->fail_at(
            "pair_correlation", "is told beside the mean density, which needs a box; add [box]");
    try {
        scene.start = motion::start<D>(balls.bodies, scene.effects);
    } catch (const motion::BallError& error) {
        balls.fail(static_cast<std::size_t>(error.ball()), error.what());
    } catch (const std::invalid_argument& error) {
        file.fail(error.what());
    }
    return scene;
}

}  // namespace

bool is_name_of_scene(std::string_view path) {
    return in_small_letters(path).ends_with(".toml");
}

AnyScene read_scene(const std::string& path, std::span<const Override> overrides) {
    Document document(path, overrides);
    const Section file(document, document.root(), "");
    read_units(file, document);
    if (dimension_of(file) == 2) return scene_of<2>(file);
    return scene_of<3>(file);
}

}  // namespace signum
