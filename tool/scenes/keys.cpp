#include "keys.hpp"

#include <algorithm>

namespace signum {

std::span<const SectionKeys> all_sections() {
    static const std::vector<SectionKeys> sections = {
        {"", {"title", "dimension", "units", "box", "wall", "balls", "effects", "run", "record"}},
        {"units", {"length", "time", "mass"}},
        {"box", {"low", "high", "periodic", "shake"}},
        {"box.shake", {"amplitude", "frequency", "phase"}},
        {"wall",
         {"kind", "normal", "offset", "point", "speed", "centre", "radius", "side", "velocity",
          "points", "closed"}},
        {"balls",
         {"file", "list", "number", "radius", "sizes", "packing", "density", "speed", "temperature",
          "seed", "arrangement", "region"}},
        {"balls.region", {"low", "high"}},
        {"effects",
         {"gravity", "restitution", "wall_restitution", "contact_duration", "speed_law", "friction",
          "growth", "fluid", "contacts"}},
        {"effects.speed_law", {"speed", "power"}},
        {"effects.friction",
         {"coefficient", "wall_coefficient", "tangential_restitution", "inertia"}},
        {"effects.growth", {"rate", "until"}},
        {"effects.fluid", {"velocity", "gradient", "linear", "quadratic"}},
        {"effects.contacts", {"speed", "tolerance", "sweeps"}},
        {"run", {"until", "events", "time_step", "structure", "arithmetic"}},
        {"record",
         {"every", "log", "frames", "film", "energies", "pair_correlation", "images", "video",
          "page", "state"}},
    };
    return sections;
}

std::span<const std::string_view> keys_of(std::string_view section) {
    return std::ranges::find(all_sections(), section, &SectionKeys::section)->keys;
}

}  // namespace signum
