#include "keys.hpp"

#include <algorithm>
#include <string>
#include <type_traits>

#include "../../motion/effects.hpp"

namespace signum {
namespace {

/// Those of the effects are as these describe themselves.
std::vector<SectionKeys> sections_of_scenes() {
    std::vector<SectionKeys> sections = {
        {"", {"title", "dimension", "units", "box", "wall", "balls", "effects", "run", "record"}},
        {"units", {"length", "time", "mass"}},
        {"box", {"low", "high"}},
        {"wall",
         {"kind", "normal", "offset", "point", "speed", "centre", "radius", "side", "velocity",
          "points", "closed"}},
        {"balls",
         {"file", "list", "number", "radius", "sizes", "packing", "density", "speed", "temperature",
          "seed", "arrangement", "region"}},
        {"balls.region", {"low", "high"}},
        {"effects", {}},
        {"run", {"until", "events", "structure", "arithmetic"}},
        {"record",
         {"every", "log", "frames", "film", "energies", "pair_correlation", "images", "video",
          "page", "state"}},
    };
    using Effects = motion::Effects<2>;
    Effects::each_field([&]<class Value>(Value Effects::*, const motion::Field& effect) {
        if (effect.section.empty()) return;
        std::ranges::find(sections, effect.section, &SectionKeys::section)
            ->keys.push_back(effect.name);
        if constexpr (motion::DescribedIfOn<Value>) {
            SectionKeys& inner = sections.emplace_back(
                SectionKeys{std::string(effect.section) + "." + std::string(effect.name), {}});
            Value::value_type::each_field(
                [&](auto, const motion::Field& field) { inner.keys.push_back(field.name); });
        }
    });
    return sections;
}

}  // namespace

std::span<const SectionKeys> all_sections() {
    static const std::vector<SectionKeys> sections = sections_of_scenes();
    return sections;
}

std::span<const std::string_view> keys_of(std::string_view section) {
    return std::ranges::find(all_sections(), section, &SectionKeys::section)->keys;
}

}  // namespace signum
