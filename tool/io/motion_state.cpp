#include "motion_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "input_file.hpp"
#include "text_writer.hpp"

namespace signum {
namespace {

using nlohmann::json;

/// A state that is JSON, but not ours: caught as what the library throws for one that lacks a name.
struct OutOfPlace : json::exception {
    OutOfPlace() : json::exception(501, "out of place") {}
};

/// No true, which the library's get_value() takes for 1; and no integer that does not fit, which it
/// leaves to chance.
template <class Number>
Number number_of(const json& value) {
    if constexpr (std::is_same_v<Number, double>) {
        if (value.is_number()) return value.get<double>();
    } else {
        const bool fits =
            value.is_number_unsigned()
                ? std::in_range<Number>(value.get<std::uint64_t>())
                : value.is_number_integer() && std::in_range<Number>(value.get<std::int64_t>());
        if (fits) return value.get<Number>();
    }
    throw OutOfPlace();
}

/// For loops, which would take null for an empty list, and a table for one of its values.
const json& list_of(const json& value) {
    if (!value.is_array()) throw OutOfPlace();
    return value;
}

/// A key that is not the format's, misspelt for one: where it may be missing nobody would notice.
struct UnknownKey : json::exception {
    explicit UnknownKey(const std::string& key) : json::exception(501, "unknown key"), name(key) {}
    std::string name;
};
void refuse_others(const json& table, const std::vector<std::string_view>& keys) {
    if (!table.is_object()) throw OutOfPlace();
    for (const auto& [key, value] : table.items())
        if (std::ranges::find(keys, key) == keys.end()) throw UnknownKey(key);
}

json parsed(const std::string& path) {
    InputFile file(path, "a state of a simulation");
    std::string text;
    for (std::string_view block = file.next_block(); !block.empty(); block = file.next_block())
        text += block;
    constexpr std::string_view wanted = "no state of a simulation; give a file that --save wrote";
    try {
        json state = json::parse(text);
        const bool is_known = state.at("version") == 1 || state.at("version") == 2;
        if (state.at("format") != "signum.simulation" || !is_known) throw InputError(path, wanted);
        return state;
    } catch (const json::parse_error& error) {
        const std::string_view before = std::string_view(text).substr(0, error.byte - 1);
        const auto lines = std::ranges::count(before, '\n');
        const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
        throw InputError(path, {lines + 1, std::ssize(before.substr(begin)) + 1},
                         fmt::format("here it ceases to be JSON: {}", wanted));
    } catch (const json::exception&) {
        throw InputError(path, wanted);
    }
}

/// A meeting, a contact, a ball: what each of its places in a list holds.
template <class Each>
auto row_of(Each& each) {
    if constexpr (requires { each.rub; })
        return std::tie(each.a, each.b, each.push, each.rub);
    else if constexpr (requires { each.by_wall; })
        return std::tie(each.ball, each.strikes, each.by_wall, each.half, each.quarter, each.last);
    else
        return std::tie(each.a, each.b, each.time);
}
template <class Ball, class Mass, class InPlace>
auto row_of(Ball& ball, Mass& mass, InPlace& in_place) {
    return std::tie(ball.x, ball.v, ball.radius, ball.time, mass, in_place);
}

/// Names of 0 and 1: on which side of a sphere balls are.
constexpr std::array<std::string_view, 2> sides = {"outside", "inside"};

// ---- written

template <class Value>
void put_members(TextWriter& text, const Value& value);

template <class Value>
void put_value(TextWriter& text, const Value& value) {
    if constexpr (std::is_same_v<Value, double>) {
        text.put(FMT_COMPILE("{}"), JsonNumber{value});
    } else if constexpr (std::is_arithmetic_v<Value>) {
        text.put(FMT_COMPILE("{}"), value);
    } else if constexpr (std::is_enum_v<Value>) {
        text.put(FMT_COMPILE("\"{}\""), sides[static_cast<std::size_t>(value)]);
    } else if constexpr (motion::Described<Value>) {
        text.put("{");
        put_members(text, value);
        text.put("}");
    } else {
        std::string_view before = "[";
        for (const auto& each : value) {
            text.put(std::exchange(before, ", "));
            put_value(text, each);
        }
        text.put("]");
    }
}
template <class Value>
void put_members(TextWriter& text, const Value& value) {
    std::string_view before = "";
    Value::each_field([&](auto member, const motion::Field& field) {
        text.put(FMT_COMPILE("{}\"{}\": "), std::exchange(before, ", "), field.name);
        put_value(text, value.*member);
    });
}
template <class... Values>
void put_row(TextWriter& text, const std::tuple<Values...>& row) {
    std::string_view before = "[";
    const auto put_next = [&](const auto& value) {
        text.put(std::exchange(before, ", "));
        put_value(text, value);
    };
    std::apply([&](const auto&... values) { (put_next(values), ...); }, row);
    text.put("]");
}

/// Of an effect that is off nothing is written.
template <int D>
void put_effects(TextWriter& text, const motion::Effects<D>& effects) {
    std::string_view before = ",\n";
    motion::Effects<D>::each_field(
        [&]<class Value>(Value motion::Effects<D>::*member, const motion::Field& field) {
            const Value& value = effects.*member;
            if constexpr (std::is_same_v<Value, std::vector<motion::Obstacle<D>>>) {
                if (value.empty()) return;
                text.put_array(field.name, value, [&](const motion::Obstacle<D>& obstacle) {
                    std::visit(
                        [&](const auto& wall) {
                            text.put(FMT_COMPILE("{{\"kind\": \"{}\", "), wall.kind);
                            put_members(text, wall);
                            text.put("}");
                        },
                        obstacle);
                });
            } else if constexpr (std::is_same_v<Value, std::optional<motion::Box<D>>>) {
                if (!value) return;
                text.put(", ");
                put_members(text, *value);
            } else if constexpr (motion::DescribedIfOn<Value>) {
                if (!value) return;
                text.put(FMT_COMPILE(", \"{}\": "), field.name);
                put_value(text, *value);
            } else if (field.is_always_kept || value != Value{}) {
                text.put(FMT_COMPILE("{}\"{}\": "), std::exchange(before, ", "), field.name);
                put_value(text, value);
            }
        });
}

// ---- read

template <class Value>
void get_value(const json& given, Value& value);

/// The names of what describes itself.
template <class Value>
void add_names(std::vector<std::string_view>& names) {
    Value::each_field([&](auto, const motion::Field& field) { names.push_back(field.name); });
}
template <class Value>
void get_members(const json& table, Value& value) {
    Value::each_field([&](auto member, const motion::Field& field) {
        get_value(table.at(field.name), value.*member);
    });
}

template <class Value>
void get_value(const json& given, Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
        value = given.get<bool>();
    } else if constexpr (std::is_arithmetic_v<Value>) {
        value = number_of<Value>(given);
    } else if constexpr (std::is_enum_v<Value>) {
        const auto* const side = std::ranges::find(sides, given.get<std::string>());
        if (side == sides.end()) throw OutOfPlace();
        value = static_cast<Value>(side - sides.begin());
    } else if constexpr (motion::DescribedIfOn<Value>) {
        std::vector<std::string_view> names;
        add_names<typename Value::value_type>(names);
        refuse_others(given, names);
        get_members(given, value.emplace());
    } else {
        if (given.size() != static_cast<std::size_t>(value.end() - value.begin()))
            throw OutOfPlace();
        std::size_t k = 0;
        for (auto& each : value) get_value(given.at(k++), each);
    }
}
template <class... Values>
void get_row(const json& list, const std::tuple<Values&...>& row) {
    std::size_t k = 0;
    std::apply([&](auto&... values) { (get_value(list.at(k++), values), ...); }, row);
}

template <int D>
motion::Obstacle<D> obstacle_of(const json& wall) {
    const std::string kind = wall.at("kind").get<std::string>();
    std::optional<motion::Obstacle<D>> found;
    const auto try_kind = [&]<class Wall>(Wall result) {
        if (kind != Wall::kind) return;
        std::vector<std::string_view> names = {"kind"};
        add_names<Wall>(names);
        refuse_others(wall, names);
        get_members(wall, result);
        found = result;
    };
    try_kind(motion::HalfSpace<D>{});
    try_kind(motion::Sphere<D>{});
    if constexpr (D == 2) try_kind(motion::Segment{});
    if (!found) throw OutOfPlace();
    return *found;
}

/// Version 1 had those that are kept always, and a box.
template <int D>
void get_effects(const json& file, motion::Effects<D>& effects) {
    motion::Effects<D>::each_field(
        [&]<class Value>(Value motion::Effects<D>::*member, const motion::Field& field) {
            Value& value = effects.*member;
            if constexpr (std::is_same_v<Value, std::optional<motion::Box<D>>>) {
                if (file.contains("low") || file.contains("high"))
                    get_members(file, value.emplace());
            } else if (field.is_always_kept || file.contains(field.name)) {
                const json& given = file.at(field.name);
                if constexpr (std::is_same_v<Value, std::vector<motion::Obstacle<D>>>)
                    for (const json& wall : list_of(given)) value.push_back(obstacle_of<D>(wall));
                else
                    get_value(given, value);
            }
        });
}

/// What effects keep of balls; check() says whether it is what they need.
template <int D>
void read_rest_of_state(const json& file, motion::State<D>& state) {
    // By reference: json's own value() copies what is there, which takes a stack as deep as that.
    static const json none = json::array();
    const auto list = [&](const char* name) -> const json& {
        return file.contains(name) ? list_of(file.at(name)) : none;
    };
    for (const json& spin : list("spins")) get_value(spin, state.spins.emplace_back());
    for (const json& time : list("last_strikes"))
        state.last_strikes.push_back(time.is_null() ? -std::numeric_limits<double>::infinity()
                                                    : number_of<double>(time));
    for (const json& contact : list("standing"))
        get_row(contact, row_of(state.contacts.emplace_back()));
    for (const json& ball : list("pressed")) get_row(ball, row_of(state.pressed.emplace_back()));
    if (file.contains("half_steps")) get_value(file.at("half_steps"), state.half_steps);
}

}  // namespace

template <int D>
void write_motion_state(std::ostream& out, const MotionState<D>& state) {
    const motion::State<D>& balls_state = state.state;
    TextWriter text(out);
    text.put(FMT_COMPILE("{{\"format\": \"signum.simulation\", \"version\": 2, \"dimension\": {}, "
                         "\"time\": {}"),
             D, JsonNumber{balls_state.time});
    put_effects(text, state.effects);
    std::size_t i = 0;
    text.put_array("balls", balls_state.balls, [&](const motion::Ball<D>& ball) {
        put_row(text, row_of(ball, balls_state.masses[i], balls_state.in_place[i]));
        ++i;
    });
    const auto put_rows = [&](const auto& each) { put_row(text, row_of(each)); };
    text.put_array("passed", balls_state.passed, put_rows);
    if (!balls_state.spins.empty())
        text.put_array("spins", balls_state.spins,
                       [&](const motion::Spin<D>& spin) { put_value(text, spin); });
    // Who has never struck has null: JSON has no infinity.
    if (!balls_state.last_strikes.empty())
        text.put_array("last_strikes", balls_state.last_strikes, [&](double time) {
            if (std::isfinite(time))
                text.put(FMT_COMPILE("{}"), JsonNumber{time});
            else
                text.put("null");
        });
    if (!balls_state.contacts.empty()) text.put_array("standing", balls_state.contacts, put_rows);
    if (!balls_state.pressed.empty()) text.put_array("pressed", balls_state.pressed, put_rows);
    if (balls_state.half_steps != 0)
        text.put(FMT_COMPILE(",\n\"half_steps\": {}"), balls_state.half_steps);
    text.put("}\n");
    text.flush();
}

int dimension_of_motion_state(const std::string& path) {
    try {
        const int dimension = number_of<int>(parsed(path).at("dimension"));
        if (dimension == 2 || dimension == 3) return dimension;
    } catch (const json::exception&) {
    }
    throw InputError(path, "a state of a simulation of neither the plane nor space");
}

template <int D>
MotionState<D> read_motion_state(const std::string& path) {
    const json file = parsed(path);
    MotionState<D> result;
    try {
        auto& [state, effects] = result;
        std::vector<std::string_view> names = {
            "format", "version",      "dimension", "time",       "balls",  "passed",
            "spins",  "last_strikes", "standing",  "half_steps", "pressed"};
        add_names<motion::Effects<D>>(names);
        std::erase(names, "box");
        add_names<motion::Box<D>>(names);
        refuse_others(file, names);
        get_value(file.at("time"), state.time);
        get_effects(file, effects);
        for (const json& ball : list_of(file.at("balls")))
            get_row(ball, row_of(state.balls.emplace_back(), state.masses.emplace_back(),
                                 state.in_place.emplace_back()));
        const auto balls = static_cast<std::int32_t>(state.balls.size());
        const auto walls = static_cast<std::int32_t>(2 * D + effects.obstacles.size());
        for (const json& passed : list_of(file.at("passed"))) {
            motion::Passed& each = state.passed.emplace_back();
            get_row(passed, row_of(each));
            if (each.a < 0 || each.a >= balls || each.b < -walls || each.b >= balls)
                throw InputError(path, "a state of a simulation that names a ball it has not");
        }
        read_rest_of_state(file, state);
    } catch (const UnknownKey& key) {
        throw InputError(path, fmt::format("a state of a simulation has no key {}; give a file as "
                                           "--save wrote it",
                                           in_quotes(key.name)));
    } catch (const json::exception&) {
        throw InputError(path,
                         "a state of a simulation with something missing or out of place; give a "
                         "file as --save wrote it");
    }
    return result;
}

template <int D>
MotionState<D> checked_motion_state(const std::string& path) {
    MotionState<D> result = read_motion_state<D>(path);
    try {
        motion::check(result.state, result.effects);
    } catch (const motion::BallError& error) {
        throw InputError(path,
                         fmt::format("a damaged state; ball {}: {}", error.ball(), error.what()));
    } catch (const std::invalid_argument& error) {
        throw InputError(path, fmt::format("a damaged state; {}", error.what()));
    }
    return result;
}

template void write_motion_state(std::ostream&, const MotionState<2>&);
template void write_motion_state(std::ostream&, const MotionState<3>&);
template MotionState<2> read_motion_state(const std::string&);
template MotionState<3> read_motion_state(const std::string&);
template MotionState<2> checked_motion_state(const std::string&);
template MotionState<3> checked_motion_state(const std::string&);

}  // namespace signum
