/// A state comes back from its file as it was, with every effect.

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "../../tool/io/errors.hpp"
#include "../../tool/io/motion_state.hpp"
#include "io_scratch.hpp"

namespace signum {
namespace {

using test::Scratch;

template <int D>
std::string written(const MotionState<D>& state) {
    std::ostringstream text;
    write_motion_state(text, state);
    return text.str();
}

template <int D>
MotionState<D> ball() {
    MotionState<D> state;
    state.state.time = 2.5;
    motion::Ball<D> each;
    each.x[0] = 0.1;
    each.v[1] = -1.0 / 3.0;
    each.radius = 0.7;
    each.time = 1.25;
    state.state.balls = {each};
    state.state.masses = {3.0};
    state.state.in_place = {2};
    return state;
}

TEST(MotionState, WithoutEffectsNamesNone) {
    const std::string text = written(ball<2>());
    for (const std::string name : {"speed_law", "contact_duration", "friction", "low", "shake",
                                   "obstacles", "growth", "fluid", "contacts", "time_step"})
        EXPECT_EQ(text.find(name), std::string::npos) << name;
}

/// Every number of every effect is another one.
template <int D>
MotionState<D> with_all_effects() {
    MotionState<D> state = ball<D>();
    motion::Effects<D>& effects = state.effects;
    double next = 1.0 / 7.0;
    const auto number = [&next] { return next += 0.1; };
    const auto vector = [&] {
        motion::Vector<D> v;
        for (double& each : v) each = number();
        return v;
    };
    effects.gravity = vector();
    effects.restitution = 0.9;
    effects.wall_restitution = 0.8;
    effects.speed_law = motion::SpeedLaw{number(), number()};
    effects.contact_duration = number();
    effects.friction = motion::Friction{number(), number(), number(), number()};
    effects.box = motion::Box<D>{vector(), vector()};
    effects.shake = motion::Shake<D>{vector(), number(), number()};
    effects.obstacles.push_back(motion::HalfSpace<D>{vector(), number(), number()});
    using Sphere = motion::Sphere<D>;
    effects.obstacles.push_back(Sphere{vector(), vector(), number(), Sphere::Side::inside});
    effects.obstacles.push_back(Sphere{vector(), vector(), number(), Sphere::Side::outside});
    if constexpr (D == 2) effects.obstacles.push_back(motion::Segment{vector(), vector()});
    effects.growth = motion::Growth{number(), number()};
    effects.fluid = motion::Fluid<D>{};
    effects.fluid->velocity = vector();
    for (int k = 0; k < D; ++k) effects.fluid->gradient[k] = vector();
    effects.fluid->linear = number();
    effects.fluid->quadratic = number();
    effects.contacts = motion::LastingContacts{number(), number(), 17};
    effects.time_step = number();
    motion::Spin<D> spin;
    for (double& each : spin) each = number();
    state.state.spins = {spin};
    state.state.last_strikes = {-std::numeric_limits<double>::infinity()};
    state.state.pressed = {{0, 4711, true, number(), number(), number()}};
    state.state.contacts = {{0, -2, number(), vector()}};
    state.state.half_steps = 41;
    return state;
}

template <int D>
void expect_same(const MotionState<D>& a, const MotionState<D>& b) {
    EXPECT_EQ(a.state.time, b.state.time);
    EXPECT_EQ(a.state.balls[0].v, b.state.balls[0].v);
    EXPECT_EQ(a.state.spins, b.state.spins);
    EXPECT_EQ(a.state.last_strikes, b.state.last_strikes);
    EXPECT_EQ(a.state.pressed, b.state.pressed);
    EXPECT_EQ(a.state.contacts, b.state.contacts);
    EXPECT_EQ(a.state.half_steps, b.state.half_steps);
    const motion::Effects<D>& e = a.effects;
    const motion::Effects<D>& f = b.effects;
    EXPECT_EQ(e.gravity, f.gravity);
    EXPECT_EQ(e.speed_law->speed, f.speed_law->speed);
    EXPECT_EQ(e.speed_law->power, f.speed_law->power);
    EXPECT_EQ(e.contact_duration, f.contact_duration);
    EXPECT_EQ(e.friction->coefficient, f.friction->coefficient);
    EXPECT_EQ(e.friction->wall_coefficient, f.friction->wall_coefficient);
    EXPECT_EQ(e.friction->tangential_restitution, f.friction->tangential_restitution);
    EXPECT_EQ(e.friction->inertia, f.friction->inertia);
    EXPECT_EQ(*e.shake, *f.shake);
    EXPECT_EQ(e.growth->rate, f.growth->rate);
    EXPECT_EQ(e.growth->until, f.growth->until);
    EXPECT_EQ(e.fluid->velocity, f.fluid->velocity);
    EXPECT_EQ(e.fluid->gradient, f.fluid->gradient);
    EXPECT_EQ(e.fluid->linear, f.fluid->linear);
    EXPECT_EQ(e.fluid->quadratic, f.fluid->quadratic);
    EXPECT_EQ(e.contacts->speed, f.contacts->speed);
    EXPECT_EQ(e.contacts->tolerance, f.contacts->tolerance);
    EXPECT_EQ(e.contacts->sweeps, f.contacts->sweeps);
    EXPECT_EQ(e.time_step, f.time_step);
    ASSERT_EQ(e.obstacles.size(), f.obstacles.size());
    const auto& plane = std::get<motion::HalfSpace<D>>(f.obstacles[0]);
    EXPECT_EQ(std::get<motion::HalfSpace<D>>(e.obstacles[0]).normal, plane.normal);
    EXPECT_EQ(std::get<motion::HalfSpace<D>>(e.obstacles[0]).offset, plane.offset);
    EXPECT_EQ(std::get<motion::HalfSpace<D>>(e.obstacles[0]).speed, plane.speed);
    for (const std::size_t i : {1U, 2U}) {
        const auto& sphere = std::get<motion::Sphere<D>>(f.obstacles[i]);
        EXPECT_EQ(std::get<motion::Sphere<D>>(e.obstacles[i]).centre, sphere.centre);
        EXPECT_EQ(std::get<motion::Sphere<D>>(e.obstacles[i]).velocity, sphere.velocity);
        EXPECT_EQ(std::get<motion::Sphere<D>>(e.obstacles[i]).radius, sphere.radius);
        EXPECT_EQ(std::get<motion::Sphere<D>>(e.obstacles[i]).side, sphere.side);
    }
    if constexpr (D == 2) {
        EXPECT_EQ(std::get<motion::Segment>(e.obstacles[3]).from,
                  std::get<motion::Segment>(f.obstacles[3]).from);
        EXPECT_EQ(std::get<motion::Segment>(e.obstacles[3]).to,
                  std::get<motion::Segment>(f.obstacles[3]).to);
    }
}

template <int D>
void goes_and_comes() {
    const Scratch scratch;
    const MotionState<D> state = with_all_effects<D>();
    const std::string path = scratch.file("state.json", written(state));
    EXPECT_EQ(dimension_of_motion_state(path), D);
    const MotionState<D> back = read_motion_state<D>(path);
    expect_same(state, back);
    EXPECT_EQ(written(back), written(state));
}

TEST(MotionState, WithAllEffectsComesBack) {
    goes_and_comes<2>();
    goes_and_comes<3>();
}

TEST(MotionState, ZerosKeepTheirSign) {
    const Scratch scratch;
    MotionState<2> state = with_all_effects<2>();
    state.effects.gravity[1] = -0.0;
    state.state.balls[0].v[0] = -0.0;
    state.state.spins[0][0] = -0.0;
    state.state.last_strikes[0] = -0.0;
    state.state.contacts[0].push = -0.0;
    const MotionState<2> back = read_motion_state<2>(scratch.file("state.json", written(state)));
    EXPECT_TRUE(std::signbit(back.effects.gravity[1]));
    EXPECT_TRUE(std::signbit(back.state.balls[0].v[0]));
    EXPECT_TRUE(std::signbit(back.state.spins[0][0]));
    EXPECT_TRUE(std::signbit(back.state.last_strikes[0]));
    EXPECT_TRUE(std::signbit(back.state.contacts[0].push));
}

TEST(MotionState, OfVersion1IsRead) {
    const Scratch scratch;
    const std::string path = scratch.file(
        "state.json",
        "{\"format\": \"signum.simulation\", \"version\": 1, \"dimension\": 2, \"time\": 2,\n"
        "\"restitution\": 0.5, \"wall_restitution\": 0.25, \"periodic\": false, \"gravity\": [0, "
        "-1], \"low\": [0, 0], \"high\": [9, 9],\n\"balls\": [\n[[1, 2], [3, 4], 0.5, 1, 7, 0]],\n"
        "\"passed\": [\n[0, -4, 1.5]]}\n");
    const MotionState<2> state = read_motion_state<2>(path);
    EXPECT_EQ(state.effects.restitution, 0.5);
    EXPECT_EQ(state.effects.box->high[1], 9.0);
    EXPECT_EQ(state.state.masses[0], 7.0);
    EXPECT_FALSE(state.effects.friction);
    EXPECT_TRUE(state.effects.obstacles.empty());
}

TEST(MotionState, HasNoOtherKeys) {
    const Scratch scratch;
    const std::string text = written(with_all_effects<2>());
    for (const auto& [name, other] :
         {std::pair("\"friction\"", "\"fricton\""), std::pair("\"half_steps\"", "\"half_step\""),
          std::pair("\"sweeps\"", "\"sweps\""), std::pair("\"low\"", "\"lower\"")}) {
        std::string changed = text;
        changed.replace(changed.find(name), std::string(name).size(), other);
        const std::string path = scratch.file("state.json", changed);
        try {
            static_cast<void>(read_motion_state<2>(path));
            ADD_FAILURE() << other;
        } catch (const InputError& error) {
            const std::string key(other);
            EXPECT_EQ(error.what(), path + ": a state of a simulation has no key '" +
                                        key.substr(1, key.size() - 2) +
                                        "'; give a file as --save wrote it");
        }
    }
}

/// The state with all effects, with other text in one place.
class DamagedStates : public testing::Test {
 protected:
    std::string with(const std::string& word, const std::string& by) {
        std::string other = written(with_all_effects<2>());
        EXPECT_NE(other.find(word), std::string::npos) << word;
        return scratch.file("state.json", other.replace(other.find(word), word.size(), by));
    }
    void refused(const std::string& word, const std::string& by) {
        const std::string path = with(word, by);
        EXPECT_THROW(static_cast<void>(read_motion_state<2>(path)), InputError) << by;
    }

    const Scratch scratch;
};

TEST_F(DamagedStates, OfALaterVersionOrAnUnknownWallAreRefused) {
    refused("\"version\": 2", "\"version\": 3");
    refused("\"segment\"", "\"polygon\"");
    refused("\"inertia\"", "\"inert\"");
    refused("\"inside\"", "\"aside\"");
    refused("\"low\"", "\"below\"");
    refused("\"high\"", "\"above\"");
    for (const std::string list :
         {"balls", "passed", "spins", "last_strikes", "standing", "pressed"}) {
        const std::string deep = std::string(200000, '[') + std::string(200000, ']');
        for (const std::string& other : {std::string("null"), std::string("{\"x\": 1}"), deep})
            refused("\"" + list + "\": ", "\"" + list + "\": " + other + ", \"rest\": ");
    }
}

TEST(MotionState, ThatIsNoJsonIsRefusedAtItsPlace) {
    const Scratch scratch;
    const std::string path = scratch.file("state.json", "{\"version\": 2,\n  \"time\": tru}\n");
    try {
        static_cast<void>(read_motion_state<2>(path));
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(), path +
                                    ":2:14: here it ceases to be JSON: no state of a "
                                    "simulation; give a file that --save wrote");
    }
}

/// An index that does not fit would come to be that of another ball.
TEST_F(DamagedStates, OfNumbersThatAreNoneOrDoNotFitAreRefused) {
    refused("\"time\": 2.5", "\"time\": true");
    for (const std::string many : {"1.5", "true", "-2147483649", "2147483648", "4294967296",
                                   "4294967313", "18446744073709551615", "1e300"}) {
        refused("\"sweeps\": 17", "\"sweeps\": " + many);
        refused("[0, -2, ", "[" + many + ", -2, ");
    }
    for (const std::string many : {"-1", "1.5", "4294967298", "18446744073709551615"})
        refused("1.25, 3, 2]", "1.25, 3, " + many + "]");
    for (const std::string many : {"-1", "1.5", "18446744073709551616"})
        refused("\"half_steps\": 41", "\"half_steps\": " + many);
    for (const std::string many : {"2.5", "4294967298", "18446744073709551618", "-2", "true"}) {
        const std::string path = with("\"dimension\": 2", "\"dimension\": " + many);
        EXPECT_THROW(static_cast<void>(dimension_of_motion_state(path)), InputError) << many;
    }
}

}  // namespace
}  // namespace signum
