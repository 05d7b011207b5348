#include "motion_state.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <type_traits>
#include <utility>
#include <variant>

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

/// No true, which the library's get() takes for 1; and no integer that does not fit, which it
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
void refuse_others(const json& table, std::initializer_list<std::string_view> keys) {
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

template <int D>
void put_vector(TextWriter& text, const motion::Vector<D>& v) {
    text.put("[");
    for (int k = 0; k < D; ++k) text.put(FMT_COMPILE("{}{}"), k > 0 ? ", " : "", JsonNumber{v[k]});
    text.put("]");
}

/// What of an effect is numbers, by name; of an effect that is off nothing is written.
void put_numbers(TextWriter& text, std::initializer_list<std::pair<std::string_view, double>> all) {
    bool first = true;
    for (const auto& [name, value] : all) {
        text.put(FMT_COMPILE("{}\"{}\": {}"), first ? "" : ", ", name, JsonNumber{value});
        first = false;
    }
}

template <int D>
void put_named(TextWriter& text, std::string_view name, const motion::Vector<D>& v) {
    text.put(FMT_COMPILE("\"{}\": "), name);
    put_vector<D>(text, v);
}

template <int D>
void put_obstacle(TextWriter& text, const motion::HalfSpace<D>& wall) {
    text.put("{\"kind\": \"half-space\", ");
    put_named<D>(text, "normal", wall.normal);
    text.put(", ");
    put_numbers(text, {{"offset", wall.offset}, {"speed", wall.speed}});
    text.put("}");
}
template <int D>
void put_obstacle(TextWriter& text, const motion::Sphere<D>& wall) {
    const bool is_inside = wall.side == motion::Sphere<D>::Side::inside;
    text.put(FMT_COMPILE("{{\"kind\": \"sphere\", \"side\": \"{}\", \"radius\": {}, "),
             is_inside ? "inside" : "outside", JsonNumber{wall.radius});
    put_named<D>(text, "centre", wall.centre);
    text.put(", ");
    put_named<D>(text, "velocity", wall.velocity);
    text.put("}");
}
void put_obstacle(TextWriter& text, const motion::Segment& wall) {
    text.put("{\"kind\": \"segment\", ");
    put_named<2>(text, "from", wall.from);
    text.put(", ");
    put_named<2>(text, "to", wall.to);
    text.put("}");
}

template <int D>
void put_effects(TextWriter& text, const motion::Effects<D>& effects) {
    if (effects.speed_law) {
        text.put(", \"speed_law\": {");
        put_numbers(text,
                    {{"speed", effects.speed_law->speed}, {"power", effects.speed_law->power}});
        text.put("}");
    }
    if (effects.contact_duration != 0.0)
        text.put(FMT_COMPILE(", \"contact_duration\": {}"), JsonNumber{effects.contact_duration});
    if (effects.friction) {
        text.put(", \"friction\": {");
        put_numbers(text, {{"coefficient", effects.friction->coefficient},
                           {"wall_coefficient", effects.friction->wall_coefficient},
                           {"tangential_restitution", effects.friction->tangential_restitution},
                           {"inertia", effects.friction->inertia}});
        text.put("}");
    }
    if (effects.shake) {
        text.put(", \"shake\": {");
        put_named<D>(text, "amplitude", effects.shake->amplitude);
        text.put(", ");
        put_numbers(text,
                    {{"frequency", effects.shake->frequency}, {"phase", effects.shake->phase}});
        text.put("}");
    }
    if (effects.growth) {
        text.put(", \"growth\": {");
        put_numbers(text, {{"rate", effects.growth->rate}, {"until", effects.growth->until}});
        text.put("}");
    }
    if (effects.fluid) {
        text.put(", \"fluid\": {");
        put_named<D>(text, "velocity", effects.fluid->velocity);
        text.put(", \"gradient\": [");
        for (int k = 0; k < D; ++k) {
            if (k > 0) text.put(", ");
            put_vector<D>(text, effects.fluid->gradient[k]);
        }
        text.put("], ");
        put_numbers(text,
                    {{"linear", effects.fluid->linear}, {"quadratic", effects.fluid->quadratic}});
        text.put("}");
    }
    if (effects.contacts) {
        text.put(", \"contacts\": {");
        put_numbers(
            text, {{"speed", effects.contacts->speed}, {"tolerance", effects.contacts->tolerance}});
        text.put(FMT_COMPILE(", \"sweeps\": {}}}"), effects.contacts->sweeps);
    }
    if (effects.time_step != 0.0) text.put(FMT_COMPILE(", \"time_step\": {}"), effects.time_step);
    if (effects.obstacles.empty()) return;
    text.put_array("obstacles", effects.obstacles, [&](const motion::Obstacle<D>& obstacle) {
        std::visit(
            [&]<class Wall>(const Wall& wall) {
                if constexpr (std::is_same_v<Wall, motion::Segment>)
                    put_obstacle(text, wall);
                else
                    put_obstacle<D>(text, wall);
            },
            obstacle);
    });
}

template <int D>
motion::Vector<D> vector_of(const json& numbers) {
    motion::Vector<D> v{};
    if (numbers.size() != D) throw OutOfPlace();
    for (int k = 0; k < D; ++k) v[k] = number_of<double>(numbers.at(static_cast<std::size_t>(k)));
    return v;
}

template <int D>
motion::Obstacle<D> obstacle_of(const json& wall) {
    const std::string kind = wall.at("kind").get<std::string>();
    refuse_others(wall, {"kind", "normal", "offset", "speed", "centre", "velocity", "radius",
                         "side", "from", "to"});
    if (kind == "half-space")
        return motion::HalfSpace<D>{vector_of<D>(wall.at("normal")),
                                    number_of<double>(wall.at("offset")),
                                    number_of<double>(wall.at("speed"))};
    if (kind == "sphere") {
        using Side = typename motion::Sphere<D>::Side;
        const std::string side = wall.at("side").get<std::string>();
        if (side != "inside" && side != "outside") throw OutOfPlace();
        return motion::Sphere<D>{vector_of<D>(wall.at("centre")), vector_of<D>(wall.at("velocity")),
                                 number_of<double>(wall.at("radius")),
                                 side == "inside" ? Side::inside : Side::outside};
    }
    if constexpr (D == 2) {
        if (kind == "segment")
            return motion::Segment{vector_of<2>(wall.at("from")), vector_of<2>(wall.at("to"))};
    }
    throw OutOfPlace();
}

/// Those that version 1 did not have.
template <int D>
void read_effects_of_state(const json& file, motion::Effects<D>& effects) {
    const auto with = [&](const char* name, const auto& use) {
        if (file.contains(name)) use(file.at(name));
    };
    const auto number = [](const json& table, const char* name) {
        return number_of<double>(table.at(name));
    };
    with("speed_law", [&](const json& law) {
        refuse_others(law, {"speed", "power"});
        effects.speed_law = motion::SpeedLaw{number(law, "speed"), number(law, "power")};
    });
    with("contact_duration",
         [&](const json& value) { effects.contact_duration = number_of<double>(value); });
    with("friction", [&](const json& friction) {
        refuse_others(friction,
                      {"coefficient", "wall_coefficient", "tangential_restitution", "inertia"});
        effects.friction = motion::Friction{
            number(friction, "coefficient"), number(friction, "wall_coefficient"),
            number(friction, "tangential_restitution"), number(friction, "inertia")};
    });
    with("shake", [&](const json& shake) {
        refuse_others(shake, {"amplitude", "frequency", "phase"});
        effects.shake = motion::Shake<D>{vector_of<D>(shake.at("amplitude")),
                                         number(shake, "frequency"), number(shake, "phase")};
    });
    with("growth", [&](const json& growth) {
        refuse_others(growth, {"rate", "until"});
        effects.growth = motion::Growth{number(growth, "rate"), number(growth, "until")};
    });
    with("fluid", [&](const json& fluid) {
        refuse_others(fluid, {"velocity", "gradient", "linear", "quadratic"});
        motion::Fluid<D> result;
        result.velocity = vector_of<D>(fluid.at("velocity"));
        for (int k = 0; k < D; ++k)
            result.gradient[k] = vector_of<D>(fluid.at("gradient").at(static_cast<std::size_t>(k)));
        result.linear = number(fluid, "linear");
        result.quadratic = number(fluid, "quadratic");
        effects.fluid = result;
    });
    with("contacts", [&](const json& contacts) {
        refuse_others(contacts, {"speed", "tolerance", "sweeps"});
        effects.contacts =
            motion::LastingContacts{number(contacts, "speed"), number(contacts, "tolerance"),
                                    number_of<int>(contacts.at("sweeps"))};
    });
    with("time_step", [&](const json& value) { effects.time_step = number_of<double>(value); });
    with("obstacles", [&](const json& walls) {
        for (const json& wall : list_of(walls)) effects.obstacles.push_back(obstacle_of<D>(wall));
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
    for (const json& spin : list("spins")) {
        motion::Spin<D> result;
        if (spin.size() != static_cast<std::size_t>(result.end() - result.begin()))
            throw OutOfPlace();
        std::size_t k = 0;
        for (double& each : result) each = number_of<double>(spin.at(k++));
        state.spins.push_back(result);
    }
    for (const json& time : list("last_strikes"))
        state.last_strikes.push_back(time.is_null() ? -std::numeric_limits<double>::infinity()
                                                    : number_of<double>(time));
    for (const json& contact : list("standing"))
        state.contacts.push_back({number_of<std::int32_t>(contact.at(0)),
                                  number_of<std::int32_t>(contact.at(1)),
                                  number_of<double>(contact.at(2)), vector_of<D>(contact.at(3))});
    for (const json& ball : list("pressed"))
        state.pressed.push_back({number_of<std::int32_t>(ball.at(0)),
                                 number_of<std::uint32_t>(ball.at(1)), ball.at(2).get<bool>(),
                                 number_of<double>(ball.at(3)), number_of<double>(ball.at(4)),
                                 number_of<double>(ball.at(5))});
    if (file.contains("half_steps"))
        state.half_steps = number_of<std::uint64_t>(file.at("half_steps"));
}

}  // namespace

template <int D>
void write_motion_state(std::ostream& out, const MotionState<D>& state) {
    const motion::State<D>& balls_state = state.state;
    const motion::Effects<D>& effects = state.effects;
    TextWriter text(out);
    text.put(FMT_COMPILE("{{\"format\": \"signum.simulation\", \"version\": 2, \"dimension\": {}, "
                         "\"time\": {},\n\"restitution\": {}, \"wall_restitution\": {}, "
                         "\"periodic\": {}, \"gravity\": "),
             D, JsonNumber{balls_state.time}, JsonNumber{effects.restitution},
             JsonNumber{effects.wall_restitution}, effects.periodic);
    put_vector<D>(text, effects.gravity);
    if (effects.box) {
        text.put(", \"low\": ");
        put_vector<D>(text, effects.box->low);
        text.put(", \"high\": ");
        put_vector<D>(text, effects.box->high);
    }
    put_effects(text, effects);
    std::size_t i = 0;
    text.put_array("balls", balls_state.balls, [&](const motion::Ball<D>& ball) {
        text.put("[");
        put_vector<D>(text, ball.x);
        text.put(", ");
        put_vector<D>(text, ball.v);
        text.put(FMT_COMPILE(", {}, {}, {}, {}]"), JsonNumber{ball.radius}, JsonNumber{ball.time},
                 JsonNumber{balls_state.masses[i]}, balls_state.in_place[i]);
        ++i;
    });
    text.put_array("passed", balls_state.passed, [&](const motion::Passed& passed) {
        text.put(FMT_COMPILE("[{}, {}, {}]"), passed.a, passed.b, JsonNumber{passed.time});
    });
    if (!balls_state.spins.empty()) {
        text.put_array("spins", balls_state.spins, [&](const motion::Spin<D>& spin) {
            text.put("[");
            for (const double& each : spin)
                text.put(FMT_COMPILE("{}{}"), &each == spin.begin() ? "" : ", ", JsonNumber{each});
            text.put("]");
        });
    }
    // Who has never struck has null: JSON has no infinity.
    if (!balls_state.last_strikes.empty())
        text.put_array("last_strikes", balls_state.last_strikes, [&](double time) {
            if (std::isfinite(time))
                text.put(FMT_COMPILE("{}"), JsonNumber{time});
            else
                text.put("null");
        });
    if (!balls_state.contacts.empty()) {
        text.put_array("standing", balls_state.contacts,
                       [&](const motion::StandingContact<D>& contact) {
                           text.put(FMT_COMPILE("[{}, {}, {}, "), contact.a, contact.b,
                                    JsonNumber{contact.push});
                           put_vector<D>(text, contact.rub);
                           text.put("]");
                       });
    }
    if (!balls_state.pressed.empty())
        text.put_array("pressed", balls_state.pressed, [&](const motion::Pressed& ball) {
            text.put(FMT_COMPILE("[{}, {}, {}, {}, {}, {}]"), ball.ball, ball.strikes, ball.by_wall,
                     JsonNumber{ball.half}, JsonNumber{ball.quarter}, JsonNumber{ball.last});
        });
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
        refuse_others(
            file,
            {"format",     "version", "dimension", "time",  "restitution",  "wall_restitution",
             "periodic",   "gravity", "low",       "high",  "speed_law",    "contact_duration",
             "friction",   "shake",   "growth",    "fluid", "contacts",     "time_step",
             "obstacles",  "balls",   "passed",    "spins", "last_strikes", "standing",
             "half_steps", "pressed"});
        state.time = number_of<double>(file.at("time"));
        effects.restitution = number_of<double>(file.at("restitution"));
        effects.wall_restitution = number_of<double>(file.at("wall_restitution"));
        effects.periodic = file.at("periodic").get<bool>();
        effects.gravity = vector_of<D>(file.at("gravity"));
        if (file.contains("low") || file.contains("high"))
            effects.box =
                motion::Box<D>{vector_of<D>(file.at("low")), vector_of<D>(file.at("high"))};
        read_effects_of_state(file, effects);
        for (const json& ball : list_of(file.at("balls"))) {
            state.balls.push_back({vector_of<D>(ball.at(0)), vector_of<D>(ball.at(1)),
                                   number_of<double>(ball.at(2)), number_of<double>(ball.at(3))});
            state.masses.push_back(number_of<double>(ball.at(4)));
            state.in_place.push_back(number_of<std::uint32_t>(ball.at(5)));
        }
        const auto balls = static_cast<std::int32_t>(state.balls.size());
        const auto walls = static_cast<std::int32_t>(2 * D + effects.obstacles.size());
        for (const json& passed : list_of(file.at("passed"))) {
            const motion::Passed each{number_of<std::int32_t>(passed.at(0)),
                                      number_of<std::int32_t>(passed.at(1)),
                                      number_of<double>(passed.at(2))};
            if (each.a < 0 || each.a >= balls || each.b < -walls || each.b >= balls)
                throw InputError(path, "a state of a simulation that names a ball it has not");
            state.passed.push_back(each);
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
