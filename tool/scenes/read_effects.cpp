#include "read_effects.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "keys.hpp"

namespace signum {
namespace {

template <int D>
const std::string_view example_of_vector = D == 2 ? "[0, 0]" : "[0, 0, 0]";

/// Refuses effects that would change nothing, and fills in what one number says of another.
template <int D>
void complete(const Section& section, const motion::Shake<D>& shake) {
    if (shake.amplitude == motion::Vector<D>{})
        section.fail_at("amplitude",
                        "all 0, and the box would stand still; give one that is not 0, "
                        "or leave [box.shake] out");
}
void complete(const Section& section, motion::Friction& friction) {
    if (!section.has("coefficient") && !section.has("wall_coefficient"))
        section.fail("neither coefficient nor wall_coefficient; give one, or leave the table out");
    if (!section.has("wall_coefficient")) friction.wall_coefficient = friction.coefficient;
    if (friction.coefficient == 0.0 && friction.wall_coefficient == 0.0)
        section.fail("no coefficient above 0; give one, or leave the table out");
}
template <int D>
void complete(const Section& section, const motion::Fluid<D>& fluid) {
    if (fluid.linear == 0.0 && fluid.quadratic == 0.0)
        section.fail(
            "a fluid that pulls at nothing; give linear or quadratic above 0, or leave the "
            "table out");
}
template <class Effect>
void complete(const Section&, const Effect&) {}

/// What a key says, or what is there already where there is no such key and need not be.
template <int D, class Value>
void read(const Section& section, const motion::Field& field, Value& value) {
    const std::string_view key = field.name;
    if (field.advice.empty() && !section.has(key)) return;
    const Quantity quantity{field.dimension, field.written};
    if constexpr (std::is_same_v<Value, bool>) {
        value = section.flag(key, value);
    } else if constexpr (std::is_same_v<Value, int>) {
        const auto least = static_cast<std::uint64_t>(field.written.least);
        const auto most = static_cast<std::uint64_t>(field.written.most);
        value = static_cast<int>(*section.optional_whole(key, least, most));
    } else if constexpr (std::is_same_v<Value, double> ||
                         std::is_same_v<Value, motion::Vector<D>>) {
        value = section.required<Value>(key, quantity, field.advice);
    } else if constexpr (std::is_same_v<Value, motion::PerAxis<motion::Vector<D>, D>>) {
        const toml::array* const rows = section.find(key)->as_array();
        if (rows == nullptr || rows->size() != D)
            section.fail_at(
                key,
                fmt::format("no matrix of {} rows; write a row an axis, as in {}", D,
                            D == 2 ? "[[0, 1], [0, 0]]" : "[[0, 1, 0], [0, 0, 0], [0, 0, 0]]"));
        for (int k = 0; k < D; ++k)
            value[k] = read_value<motion::Vector<D>>(
                section.document(), (*rows)[static_cast<std::size_t>(k)], key, quantity);
    } else if constexpr (motion::DescribedIfOn<Value>) {
        using Effect = typename Value::value_type;
        const Section table = *section.optional_section(key);
        value = motion::by_default<Effect, D>();
        Effect::each_field([&](auto member, const motion::Field& each) {
            read<D>(table, each, (*value).*member);
        });
        complete(table, *value);
    }
}

/// Refuses keys that the kind of wall does not have.
void refuse_others(const Section& wall, std::string_view kind,
                   std::initializer_list<std::string_view> known) {
    for (const std::string_view key : keys_of("wall"))
        if (key != "kind" && wall.has(key) && std::ranges::find(known, key) == known.end())
            wall.fail_at(key,
                         fmt::format("is no key of a {}; it has {}", kind, fmt::join(known, ", ")));
}

template <int D>
motion::HalfSpace<D> read_half_space(const Section& wall) {
    refuse_others(wall, "half-space", {"normal", "offset", "point", "speed"});
    motion::HalfSpace<D> result;
    result.normal = wall.required<motion::Vector<D>>(
        "normal", {dimensions::number}, "give the direction in which the balls are, as in [0, 1]");
    if (result.normal == motion::Vector<D>{})
        wall.fail_at("normal", "has no direction; give a vector that is not 0");
    if (wall.has("offset") && wall.has("point"))
        wall.fail_at("point", "says the same as offset; leave one of the two out");
    if (const auto point = wall.optional<motion::Vector<D>>("point", {dimensions::length})) {
        result.offset = motion::dot<D>(result.normal, *point);
    } else {
        result.offset =
            wall.required<double>("offset", {dimensions::length},
                                  "give the offset along the normal, or a point of the wall");
    }
    result.speed = wall.optional<double>("speed", {dimensions::speed}).value_or(0.0);
    return result;
}

template <int D>
motion::Sphere<D> read_sphere(const Section& wall, std::string_view kind) {
    refuse_others(wall, kind, {"centre", "radius", "side", "velocity"});
    motion::Sphere<D> result;
    result.centre = wall.required<motion::Vector<D>>(
        "centre", {dimensions::length}, fmt::format("give it, as in {}", example_of_vector<D>));
    result.radius =
        wall.required<double>("radius", {dimensions::length, above_0}, "give a length above 0");
    const std::array<std::string, 2> sides = {"inside", "outside"};
    const auto side = wall.optional_word("side", sides);
    if (!side)
        wall.fail("side is missing; say where the balls are: side = \"inside\" or \"outside\"");
    result.side =
        *side == "inside" ? motion::Sphere<D>::Side::inside : motion::Sphere<D>::Side::outside;
    result.velocity = wall.optional<motion::Vector<D>>("velocity", {dimensions::speed})
                          .value_or(motion::Vector<D>{});
    return result;
}

void add_polyline(const Section& wall, std::vector<motion::Obstacle<2>>& walls) {
    refuse_others(wall, "polyline", {"points", "closed"});
    const toml::node& node =
        wall.get("points", "give the corners, as in points = [[0, 0], [5, 0], [5, 3]]");
    const toml::array* const array = node.as_array();
    if (array == nullptr)
        wall.fail_at("points", fmt::format("{} where points are meant; write [[x, y], [x, y]]",
                                           kind_of(node)));
    const bool closed = wall.flag("closed", false);
    const std::size_t least = closed ? 3 : 2;
    if (array->size() < least)
        wall.fail_at("points", fmt::format("{} of them; {} needs {} at least", array->size(),
                                           closed ? "a closed polyline" : "a polyline", least));
    std::vector<motion::Vector<2>> points;
    for (const toml::node& each : *array) {
        const auto point =
            read_value<motion::Vector<2>>(wall.document(), each, "points", {dimensions::length});
        if (!points.empty() && points.back() == point)
            wall.document().fail(each.source(),
                                 "points: a point that is the one before it; leave it out");
        points.push_back(point);
    }
    if (closed && points.front() == points.back())
        wall.document().fail((*array)[array->size() - 1].source(),
                             "points: the last point is the first one; closed = true joins them, "
                             "leave the last one out");
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        walls.push_back(motion::Segment{points[i], points[i + 1]});
    if (closed) walls.push_back(motion::Segment{points.back(), points.front()});
}

template <int D>
void add_wall(const Section& wall, std::vector<motion::Obstacle<D>>& walls) {
    static const std::array<std::string, 4> kinds = {"half-space", "circle", "sphere", "polyline"};
    const auto kind = wall.optional_word("kind", kinds);
    if (!kind) wall.fail(fmt::format("kind is missing; it is one of {}", fmt::join(kinds, ", ")));
    if (D == 2 && *kind == "sphere")
        wall.fail_at("kind",
                     "\"sphere\" is a wall of space, and the scene lies in the plane; give "
                     "\"circle\"");
    if (D == 3 && *kind == "circle")
        wall.fail_at("kind",
                     "\"circle\" is a wall of the plane, and the scene lies in space; give "
                     "\"sphere\"");
    if (D == 3 && *kind == "polyline")
        wall.fail_at("kind",
                     "\"polyline\" is a wall of the plane, and the scene lies in space; "
                     "give half-spaces or spheres");
    if (*kind == "half-space") {
        walls.push_back(read_half_space<D>(wall));
    } else if (*kind == "polyline") {
        if constexpr (D == 2) add_polyline(wall, walls);
    } else {
        walls.push_back(read_sphere<D>(wall, *kind));
    }
}

}  // namespace

template <int D>
motion::Box<D> read_box(const Section& section) {
    motion::Box<D> box;
    const std::string advice = fmt::format(
        "give the lower corner and the upper one, as in low = "
        "{}",
        example_of_vector<D>);
    box.low = section.required<motion::Vector<D>>("low", {dimensions::length}, advice);
    box.high = section.required<motion::Vector<D>>("high", {dimensions::length}, advice);
    for (int k = 0; k < D; ++k)
        if (!(box.low[k] < box.high[k]))
            section.fail_at("high", fmt::format("{} along {} is not above low, {}; give the lower "
                                                "corner as low and the upper one as high",
                                                box.high[k], "xyz"[k], box.low[k]));
    return box;
}

template <int D>
motion::Effects<D> read_effects(const Section& file) {
    motion::Effects<D> result;
    const auto box = file.optional_section("box");
    if (box) result.box = read_box<D>(*box);
    const auto effects = file.optional_section("effects");
    motion::Effects<D>::each_field([&](auto member, const motion::Field& field) {
        if (field.section.empty()) return;
        const auto section = file.optional_section(field.section);
        if (section) read<D>(*section, field, result.*member);
    });
    if (result.periodic && result.shake)
        box->fail_at("shake",
                     "a periodic box has no sides that could shake; leave shake out, or "
                     "periodic");
    for (const Section& wall : file.sections("wall")) {
        if (result.periodic)
            wall.fail("a periodic box has no walls beside; leave the wall out, or periodic");
        add_wall<D>(wall, result.obstacles);
    }
    if (!effects) return result;
    if (!effects->has("wall_restitution")) result.wall_restitution = result.restitution;
    if (result.speed_law && result.restitution == 1.0 && result.wall_restitution == 1.0)
        effects->fail_at("speed_law",
                         "with a restitution of 1 it would change nothing; give a "
                         "restitution below 1, which is that at speed_law.speed");
    motion::Effects<D>::each_field([&](auto, const motion::Field& field) {
        if (result.time_step == 0.0 && !field.stepped.empty() && effects->has(field.name))
            effects->fail_at(field.name,
                             fmt::format("{} is computed in steps of time; add time_step to [run], "
                                         "or leave {} out",
                                         field.stepped, field.name));
    });
    if (result.growth && result.contacts)
        effects->fail_at("contacts",
                         "balls that grow do not rest on one another; leave "
                         "contacts out, or growth");
    return result;
}

template motion::Box<2> read_box<2>(const Section&);
template motion::Box<3> read_box<3>(const Section&);
template motion::Effects<2> read_effects<2>(const Section&);
template motion::Effects<3> read_effects<3>(const Section&);

}  // namespace signum
