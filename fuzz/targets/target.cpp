#include "target.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "interface.hpp"
#include "parsers.hpp"
#include "structures.hpp"

namespace signum::fuzz {
namespace {

constexpr std::array targets = {
    Target{"text", read_sites_target},
    Target{"json", read_sites_target},
    Target{"xyz", read_xyz_target},
    Target{"pdb", read_pdb_target},
    Target{"pqr", read_pqr_target},
    Target{"cif", read_cif_target},
    Target{"gro", read_gro_target},
    Target{"lammpstrj", read_lammpstrj_target},
    Target{"off", read_off_target},
    Target{"ply", read_ply_target},
    Target{"node", read_node_target},
    Target{"npy", read_array_target},
    Target{"balls", read_balls_target},
    Target{"frames", read_frames_target},
    Target{"tessellation", read_tessellation_target},
    Target{"state", read_state_target},
    Target{"words", read_words_target},
    Target{"scene", read_scene_target, 10.0},
    Target{"override", read_override_target, 10.0},
    Target{"triangulate", triangulate_target, 10.0},
    Target{"dynamic", dynamic_target, 10.0},
    Target{"kinetic", kinetic_target, 10.0},
    Target{"space", space_target, 10.0},
    Target{"c_predicates", predicates_of_c_target, 10.0},
    Target{"c_structures", structures_of_c_target, 10.0},
};

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

std::span<const Target> all_targets() {
    return targets;
}

const Target& target_named(std::string_view name) {
    const auto* const found = std::ranges::find(targets, name, &Target::name);
    must(found != targets.end(), "there is no target of that name");
    return *found;
}

void run_in_time(const Target& target, Bytes bytes) {
    const double allowed = target.seconds + 20e-6 * static_cast<double>(bytes.size());
    // A second time, for the first may pay for what the system has taken away.
    for (const bool is_last : {false, true}) {
        const double start = processor_seconds();
        target.run(bytes);
        if (processor_seconds() - start <= allowed) return;
        must(!is_last, "it takes far longer than is linear");
    }
}

void must(bool condition, std::string_view sentence) {
    if (condition) return;
    std::fprintf(stderr, "fuzz: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
    std::abort();
}

}  // namespace signum::fuzz
