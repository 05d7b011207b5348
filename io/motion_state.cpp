#include "motion_state.hpp"

#include <ostream>

#include <nlohmann/json.hpp>

#include "input_file.hpp"
#include "text_writer.hpp"

namespace signum {
namespace {

using nlohmann::json;

json parsed(const std::string& path) {
    InputFile file(path, "a state of a simulation");
    std::string text;
    for (std::string_view block = file.next_block(); !block.empty(); block = file.next_block())
        text += block;
    try {
        json state = json::parse(text);
        if (state.at("format") != "signum.simulation" || state.at("version") != 1)
            throw InputError(path, "no state of a simulation; give a file that --save wrote");
        return state;
    } catch (const json::exception&) {
        throw InputError(path, "no state of a simulation; give a file that --save wrote");
    }
}

template <int D>
void put_vector(TextWriter& text, const motion::Vector<D>& v) {
    text.put("[");
    for (int k = 0; k < D; ++k) text.put(FMT_COMPILE("{}{}"), k > 0 ? ", " : "", v[k]);
    text.put("]");
}

template <int D>
motion::Vector<D> vector_of(const json& numbers) {
    motion::Vector<D> v{};
    if (numbers.size() != D) throw json::other_error::create(501, "length", nullptr);
    for (int k = 0; k < D; ++k) v[k] = numbers.at(static_cast<std::size_t>(k)).get<double>();
    return v;
}

}  // namespace

template <int D>
void write_motion_state(std::ostream& out, const MotionState<D>& state) {
    const motion::State<D>& balls_state = state.state;
    const motion::Effects<D>& effects = state.effects;
    TextWriter text(out);
    text.put(FMT_COMPILE("{{\"format\": \"signum.simulation\", \"version\": 1, \"dimension\": {}, "
                         "\"time\": {},\n\"restitution\": {}, \"wall_restitution\": {}, "
                         "\"periodic\": {}, \"gravity\": "),
             D, balls_state.time, effects.restitution, effects.wall_restitution, effects.periodic);
    put_vector<D>(text, effects.gravity);
    if (effects.box) {
        text.put(", \"low\": ");
        put_vector<D>(text, effects.box->low);
        text.put(", \"high\": ");
        put_vector<D>(text, effects.box->high);
    }
    std::size_t i = 0;
    text.put_array("balls", balls_state.balls, [&](const motion::Ball<D>& ball) {
        text.put("[");
        put_vector<D>(text, ball.x);
        text.put(", ");
        put_vector<D>(text, ball.v);
        text.put(FMT_COMPILE(", {}, {}, {}, {}]"), ball.radius, ball.time, balls_state.masses[i],
                 balls_state.in_place[i]);
        ++i;
    });
    text.put_array("passed", balls_state.passed, [&](const motion::Passed& passed) {
        text.put(FMT_COMPILE("[{}, {}, {}]"), passed.a, passed.b, passed.time);
    });
    text.put("}\n");
    text.flush();
}

int dimension_of_motion_state(const std::string& path) {
    try {
        const int dimension = parsed(path).at("dimension").get<int>();
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
        state.time = file.at("time").get<double>();
        effects.restitution = file.at("restitution").get<double>();
        effects.wall_restitution = file.at("wall_restitution").get<double>();
        effects.periodic = file.at("periodic").get<bool>();
        effects.gravity = vector_of<D>(file.at("gravity"));
        if (file.contains("low"))
            effects.box =
                motion::Box<D>{vector_of<D>(file.at("low")), vector_of<D>(file.at("high"))};
        for (const json& ball : file.at("balls")) {
            state.balls.push_back({vector_of<D>(ball.at(0)), vector_of<D>(ball.at(1)),
                                   ball.at(2).get<double>(), ball.at(3).get<double>()});
            state.masses.push_back(ball.at(4).get<double>());
            state.in_place.push_back(ball.at(5).get<std::uint32_t>());
        }
        const auto balls = static_cast<std::int32_t>(state.balls.size());
        for (const json& passed : file.at("passed")) {
            const motion::Passed each{passed.at(0).get<std::int32_t>(),
                                      passed.at(1).get<std::int32_t>(), passed.at(2).get<double>()};
            if (each.a < 0 || each.a >= balls || each.b < -2 * D || each.b >= balls)
                throw InputError(path, "a state of a simulation that names a ball it has not");
            state.passed.push_back(each);
        }
    } catch (const json::exception&) {
        throw InputError(path,
                         "a state of a simulation with something missing or out of place; give a "
                         "file as --save wrote it");
    }
    return result;
}

template void write_motion_state(std::ostream&, const MotionState<2>&);
template void write_motion_state(std::ostream&, const MotionState<3>&);
template MotionState<2> read_motion_state(const std::string&);
template MotionState<3> read_motion_state(const std::string&);

}  // namespace signum
