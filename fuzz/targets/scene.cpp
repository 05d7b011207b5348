#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>

#include "../../tool/io/motion_state.hpp"
#include "../../tool/io/program.hpp"
#include "../../tool/scenes/document.hpp"
#include "../../tool/scenes/explain.hpp"
#include "../../tool/scenes/read_scene.hpp"

#include "memory_file.hpp"
#include "parsers.hpp"
#include "reading.hpp"

namespace signum::fuzz {
namespace {

/// A scene, and files of balls that it may name.
class SceneFolder {
 public:
    SceneFolder() : folder_("fuzz") {
        write("balls.txt", "1 1 0.5 1 0\n3 1 0.5 -1 0\n");
        write("space.txt", "1 1 1 0.5 1 0 0\n3 1 1 0.5 -1 0 0 2\n");
        write("frame.xyz",
              "1\nProperties=species:S:1:pos:R:3:velo:R:3:radius:R:1:id:I:1\n"
              "A 1 1 0 1 0 0 0.5 0\n");
        write("state.json",
              R"({"format": "signum.simulation", "version": 1, "dimension": 2, "time": 0, )"
              R"("restitution": 1, "wall_restitution": 1, "periodic": false, "gravity": [0, 0], )"
              R"("balls": [[[1, 2], [3, 4], 1, 0, 1, 0]], "passed": []})");
    }
    std::string with(Bytes scene) const {
        write("scene.toml", {reinterpret_cast<const char*>(scene.data()), scene.size()});
        return folder_.file("scene.toml");
    }

 private:
    void write(std::string_view name, std::string_view text) const {
        std::ofstream out(folder_.file(name), std::ios::binary);
        out << text;
        must(out.flush().good(), "no place for a scene");
    }
    ScratchFolder folder_;
};

/// Whether a group of balls takes long to be placed, and may: it is many, or as many as fill a
/// share; or it is read from a file that is not the target's own.
bool takes_long(const toml::table& group) {
    constexpr std::int64_t many = 12;
    if (const auto file = group["file"].value<std::string_view>())
        return file->find('/') != std::string_view::npos;
    const auto number = group["number"].value<std::int64_t>();
    return number ? *number > many : group.contains("packing");
}
bool takes_long(const Document& scene) {
    const auto balls = scene.root()["balls"];
    if (const toml::table* const group = balls.as_table()) return takes_long(*group);
    if (const toml::array* const groups = balls.as_array())
        for (const toml::node& each : *groups)
            if (const toml::table* const group = each.as_table(); group && takes_long(*group))
                return true;
    return false;
}

/// What was placed is a state from which a run can begin.
template <int D>
void judge_scene(const Scene<D>& scene) {
    const std::string explanation = explain(scene, "");
    must(!explanation.empty(), "a scene that says nothing of itself");
    for (const char letter : explanation)
        must(letter == '\n' || !has_control_character({&letter, 1}),
             "an explanation with a control character");
    std::ostringstream text;
    write_motion_state<D>(text, {scene.start, scene.effects});
    const MemoryFile copy(text.str());
    const MotionState<D> again = checked_motion_state<D>(copy.path());
    must(again.state.balls.size() == scene.start.balls.size(), "a start that loses balls");
}

/// What `read` gives, or nothing where it throws as a scene may.
template <class Read>
auto scene_of(const std::string& path, std::string_view option, const Read& read)
    -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const OverrideError& error) {
        must(!option.empty(), "an error of an option that is not there");
        judge_message(error.what(), option);
    } catch (const InputError& error) {
        const std::string_view message = error.what();
        // Of a file of balls that the scene names.
        const std::string_view folder = std::string_view(path).substr(0, path.rfind('/') + 1);
        must(message.starts_with(folder), "a message that does not begin with the file");
        judge_message(message, message.substr(0, message.find(':', folder.size())));
    }
    return std::nullopt;
}

void read_scene_with(const std::string& path, std::span<const Override> overrides) {
    const std::string option = overrides.empty() ? "" : overrides.front().option;
    const auto document = scene_of(path, option, [&] {
        const Document scene(path, overrides);
        return takes_long(scene);
    });
    if (!document || *document) return;
    const auto scene = scene_of(path, option, [&] { return read_scene(path, overrides); });
    if (scene) std::visit([](const auto& each) { judge_scene(each); }, *scene);
}

}  // namespace

void read_scene_target(Bytes bytes) {
    static const SceneFolder folder;
    read_scene_with(folder.with(bytes), {});
}

/// A line is what --set says.
void read_override_target(Bytes bytes) {
    static const SceneFolder folder;
    constexpr std::string_view scene =
        "[box]\nlow = [0, 0]\nhigh = [10, 10]\n[effects]\ngravity = [0, -1]\n"
        "[[balls]]\nlist = [[5, 5, 1, 1, 0]]\n[[balls]]\nnumber = 3\nradius = [0.5, 1]\n"
        "[run]\nuntil = 1\n";
    const std::string path =
        folder.with({reinterpret_cast<const std::uint8_t*>(scene.data()), scene.size()});
    std::string_view rest(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    constexpr int most = 20;
    for (int i = 0; i < most && !rest.empty(); ++i) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const std::array<Override, 1> overrides = {{{"--set", std::string(line)}}};
        read_scene_with(path, overrides);
    }
}

}  // namespace signum::fuzz
