#include "read_effects.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace signum {
namespace {

template <int D>
const std::string_view example_of_vector = D == 2 ? "[0, 0]" : "[0, 0, 0]";

template <int D>
motion::Shake<D> read_shake(const Section& shake) {
    motion::Shake<D> result;
    result.amplitude =
        shake.vector<D>("amplitude", {dimensions::length},
                        "say how far the box goes along each axis, as in amplitude = [0, 5]");
    if (result.amplitude == motion::Vector<D>{})
        shake.fail_at("amplitude",
                      "all 0, and the box would stand still; give one that is not 0, "
                      "or leave [box.shake] out");
    result.frequency = shake.quantity("frequency",
                                      {dimensions::angular_speed,
                                       {.least = 0.0,
                                        .is_open = true,
                                        .words = "a frequency above 0, as in "
                                                 "\"20 Hz\""}},
                                      "say how often, as in frequency = \"20 Hz\"");
    result.phase = shake.optional_quantity("phase", {dimensions::angle}).value_or(0.0);
    return result;
}

/// Refuses keys that the kind of wall does not have.
void refuse_others(const Section& wall, std::string_view kind,
                   std::initializer_list<std::string_view> known) {
    for (const std::string_view key : {"normal", "offset", "point", "speed", "centre", "radius",
                                       "side", "velocity", "points", "closed"})
        if (wall.has(key) && std::ranges::find(known, key) == known.end())
            wall.fail_at(key,
                         fmt::format("is no key of a {}; it has {}", kind, fmt::join(known, ", ")));
}

template <int D>
motion::HalfSpace<D> read_half_space(const Section& wall) {
    refuse_others(wall, "half-space", {"normal", "offset", "point", "speed"});
    motion::HalfSpace<D> result;
    result.normal = wall.vector<D>("normal", {dimensions::number},
                                   "give the direction in which the balls are, as in [0, 1]");
    if (result.normal == motion::Vector<D>{})
        wall.fail_at("normal", "has no direction; give a vector that is not 0");
    if (wall.has("offset") && wall.has("point"))
        wall.fail_at("point", "says the same as offset; leave one of the two out");
    if (const auto point = wall.optional_vector<D>("point", {dimensions::length})) {
        result.offset = motion::dot<D>(result.normal, *point);
    } else {
        result.offset = wall.quantity("offset", {dimensions::length},
                                      "give the offset along the normal, or a point of the wall");
    }
    result.speed = wall.optional_quantity("speed", {dimensions::speed}).value_or(0.0);
    return result;
}

template <int D>
motion::Sphere<D> read_sphere(const Section& wall, std::string_view kind) {
    refuse_others(wall, kind, {"centre", "radius", "side", "velocity"});
    motion::Sphere<D> result;
    result.centre = wall.vector<D>("centre", {dimensions::length},
                                   fmt::format("give it, as in {}", example_of_vector<D>));
    result.radius = wall.quantity("radius", {dimensions::length, above_0}, "give a length above 0");
    const std::array<std::string, 2> sides = {"inside", "outside"};
    const auto side = wall.optional_word("side", sides);
    if (!side)
        wall.fail("side is missing; say where the balls are: side = \"inside\" or \"outside\"");
    result.side =
        *side == "inside" ? motion::Sphere<D>::Side::inside : motion::Sphere<D>::Side::outside;
    result.velocity =
        wall.optional_vector<D>("velocity", {dimensions::speed}).value_or(motion::Vector<D>{});
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
        const auto point = read_vector<2>(wall.document(), each, "points", {dimensions::length});
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

template <int D>
motion::Friction read_friction(const Section& friction) {
    if (!friction.has("coefficient") && !friction.has("wall_coefficient"))
        friction.fail("neither coefficient nor wall_coefficient; give one, or leave the table out");
    motion::Friction result;
    const auto between = friction.optional_quantity("coefficient", {dimensions::number, from_0});
    const auto at_walls =
        friction.optional_quantity("wall_coefficient", {dimensions::number, from_0});
    result.coefficient = between.value_or(0.0);
    result.wall_coefficient = at_walls.value_or(result.coefficient);
    if (result.coefficient == 0.0 && result.wall_coefficient == 0.0)
        friction.fail("no coefficient above 0; give one, or leave the table out");
    result.tangential_restitution =
        friction
            .optional_quantity("tangential_restitution",
                               {dimensions::number, {-1.0, 1.0, false, "a number from -1 to 1"}})
            .value_or(0.0);
    result.inertia =
        friction
            .optional_quantity(
                "inertia", {dimensions::number, {0.0, 1.0, true, "a number above 0, at most 1"}})
            .value_or(D == 2 ? 0.5 : 0.4);
    return result;
}

motion::SpeedLaw read_speed_law(const Section& law, const Section& effects, double restitution,
                                double wall_restitution) {
    if (restitution == 1.0 && wall_restitution == 1.0)
        effects.fail_at("speed_law",
                        "with a restitution of 1 it would change nothing; give a "
                        "restitution below 1, which is that at speed_law.speed");
    motion::SpeedLaw result;
    result.speed = law.quantity("speed", {dimensions::speed, above_0},
                                "give the speed at which restitution is as given");
    result.power = law.optional_quantity("power", {dimensions::number,
                                                   {0.0, 8.0, true, "a number above 0, at most 8"}})
                       .value_or(result.power);
    return result;
}

template <int D>
motion::Fluid<D> read_fluid(const Section& fluid) {
    motion::Fluid<D> result;
    result.velocity =
        fluid.optional_vector<D>("velocity", {dimensions::speed}).value_or(motion::Vector<D>{});
    if (const toml::node* const gradient = fluid.find("gradient")) {
        const toml::array* const rows = gradient->as_array();
        if (rows == nullptr || rows->size() != D)
            fluid.fail_at(
                "gradient",
                fmt::format("no matrix of {0} rows; write a row an axis, as "
                            "in {1}",
                            D, D == 2 ? "[[0, 1], [0, 0]]" : "[[0, 1, 0], [0, 0, 0], [0, 0, 0]]"));
        for (int k = 0; k < D; ++k)
            result.gradient[k] =
                read_vector<D>(fluid.document(), (*rows)[static_cast<std::size_t>(k)], "gradient",
                               {dimensions::rate});
    }
    constexpr Dimension linear{.length = -1, .time = -1, .mass = 1};
    constexpr Dimension quadratic{.length = -D, .mass = 1};
    result.linear = fluid.optional_quantity("linear", {linear, from_0}).value_or(0.0);
    result.quadratic = fluid.optional_quantity("quadratic", {quadratic, from_0}).value_or(0.0);
    if (result.linear == 0.0 && result.quadratic == 0.0)
        fluid.fail(
            "a fluid that pulls at nothing; give linear or quadratic above 0, or leave the "
            "table out");
    return result;
}

motion::LastingContacts read_contacts(const Section& contacts) {
    motion::LastingContacts result;
    result.speed = contacts.quantity("speed", {dimensions::speed, above_0},
                                     "give the speed below which balls stay in contact");
    result.tolerance =
        contacts
            .optional_quantity(
                "tolerance",
                {dimensions::number, {0.0, 1.0 - 0x1p-53, true, "a number above 0, below 1"}})
            .value_or(result.tolerance);
    result.sweeps = static_cast<int>(contacts.optional_whole("sweeps", 2, 1'000'000)
                                         .value_or(static_cast<std::uint64_t>(result.sweeps)));
    return result;
}

template <int D>
void read_box_of_scene(const Section& file, motion::Effects<D>& effects) {
    const auto box = file.optional_section("box");
    if (!box) return;
    effects.box = read_box<D>(*box);
    effects.periodic = box->flag("periodic", false);
    const auto shake = box->optional_section("shake");
    if (!shake) return;
    if (effects.periodic)
        box->fail_at("shake",
                     "a periodic box has no sides that could shake; leave shake out, or "
                     "periodic");
    effects.shake = read_shake<D>(*shake);
}

}  // namespace

template <int D>
motion::Box<D> read_box(const Section& section) {
    motion::Box<D> box;
    const std::string advice = fmt::format(
        "give the lower corner and the upper one, as in low = "
        "{}",
        example_of_vector<D>);
    box.low = section.vector<D>("low", {dimensions::length}, advice);
    box.high = section.vector<D>("high", {dimensions::length}, advice);
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
    read_box_of_scene<D>(file, result);
    for (const Section& wall : file.sections("wall")) {
        if (result.periodic)
            wall.fail("a periodic box has no walls beside; leave the wall out, or periodic");
        add_wall<D>(wall, result.obstacles);
    }
    if (const auto run = file.optional_section("run"))
        result.time_step =
            run->optional_quantity("time_step", {dimensions::time, above_0}).value_or(0.0);
    const auto effects = file.optional_section("effects");
    if (!effects) return result;
    result.gravity = effects->optional_vector<D>("gravity", {dimensions::acceleration})
                         .value_or(motion::Vector<D>{});
    result.restitution =
        effects->optional_quantity("restitution", {dimensions::number, from_0_to_1}).value_or(1.0);
    result.wall_restitution =
        effects->optional_quantity("wall_restitution", {dimensions::number, from_0_to_1})
            .value_or(result.restitution);
    result.contact_duration =
        effects->optional_quantity("contact_duration", {dimensions::time, from_0}).value_or(0.0);
    if (const auto law = effects->optional_section("speed_law"))
        result.speed_law =
            read_speed_law(*law, *effects, result.restitution, result.wall_restitution);
    if (const auto friction = effects->optional_section("friction"))
        result.friction = read_friction<D>(*friction);
    if (const auto growth = effects->optional_section("growth"))
        result.growth = motion::Growth{growth->quantity("rate", {dimensions::rate, above_0},
                                                        "give the share of its radius by which a "
                                                        "ball grows in a unit of time"),
                                       growth->quantity("until", {dimensions::time, above_0},
                                                        "give the time at which radii stay")};
    const auto needs_steps = [&](std::string_view key, std::string_view what) {
        if (result.time_step == 0.0)
            effects->fail_at(key, fmt::format("{} is computed in steps of time; add time_step to "
                                              "[run], or leave {} out",
                                              what, key));
    };
    if (const auto fluid = effects->optional_section("fluid")) {
        needs_steps("fluid", "what a fluid does");
        result.fluid = read_fluid<D>(*fluid);
    }
    if (const auto contacts = effects->optional_section("contacts")) {
        needs_steps("contacts", "contact that lasts");
        if (result.growth)
            effects->fail_at("contacts",
                             "balls that grow do not rest on one another; leave "
                             "contacts out, or growth");
        result.contacts = read_contacts(*contacts);
    }
    return result;
}

template motion::Box<2> read_box<2>(const Section&);
template motion::Box<3> read_box<3>(const Section&);
template motion::Effects<2> read_effects<2>(const Section&);
template motion::Effects<3> read_effects<3>(const Section&);

}  // namespace signum
