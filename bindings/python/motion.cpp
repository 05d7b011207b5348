/// Balls that move and strike, in the plane and in space.

#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../../motion/queries.hpp"
#include "../../motion/simulation.hpp"
#include "names.hpp"
#include "parts.hpp"
#include "results.hpp"
#include "watched.hpp"

namespace signum::python {
namespace {

using namespace py::literals;

template <int D>
motion::Vector<D> vector_of(const py::object& object, const char* what) {
    const py::array array = doubles(object);
    if (array.ndim() != 1 || array.size() != D)
        throw py::value_error(std::string(what) + ": " + std::to_string(D) + " numbers are needed");
    const auto numbers = array.unchecked<double, 1>();
    motion::Vector<D> result;
    for (int k = 0; k < D; ++k) result[k] = numbers(k);
    return result;
}
template <int D>
motion::Box<D> box_of_corners(const py::object& object) {
    const Rows rows(object, "box", D, D);
    if (rows.size() != 2) throw py::value_error("box: two corners are needed");
    motion::Box<D> box;
    for (int k = 0; k < D; ++k) {
        box.low[k] = rows.at(0, k);
        box.high[k] = rows.at(1, k);
    }
    return box;
}

/// Names of a field that a keyword of Python forbids, or that says it by true and false.
const char* python_name(const std::string& name) {
    return name == "from"   ? "start"
           : name == "to"   ? "end"
           : name == "side" ? "inside"
                            : name.c_str();
}

template <int D>
motion::Obstacle<D> obstacle_of(const py::object& object);

/// Gives a value what an object of a class of signum.effects has by the field's name. None leaves
/// it as it is, where the class has None by default.
template <int D, class Value>
void read(const py::object& object, const motion::Field& field, Value& value) {
    const std::string field_name(field.name);
    const char* const name = python_name(field_name);
    const py::type type = py::type::of(object);
    if (!py::hasattr(object, name))
        throw py::type_error(std::string(name) + ": a '" +
                             std::string(py::str(type.attr("__name__"))) +
                             "' has none; an object of a class of signum.effects is needed");
    const py::object given = object.attr(name);
    if (given.is_none() && py::getattr(type, name, py::str()).is_none()) return;
    if constexpr (std::is_same_v<Value, bool> || std::is_enum_v<Value>) {
        const int truth = PyObject_IsTrue(given.ptr());
        if (truth < 0) throw py::error_already_set();
        value = static_cast<Value>(truth != 0);
    } else if constexpr (std::is_same_v<Value, double>) {
        value = number_of(given, name);
    } else if constexpr (std::is_same_v<Value, int>) {
        try {
            value = given.cast<int>();
        } catch (const py::cast_error&) {
            throw py::type_error(std::string(name) + ": a whole number of 32 bits is needed");
        }
    } else if constexpr (std::is_same_v<Value, motion::Vector<D>>) {
        value = vector_of<D>(given, name);
    } else if constexpr (std::is_same_v<Value, motion::PerAxis<motion::Vector<D>, D>>) {
        const Rows rows(given, name, D, D);
        if (rows.size() != D)
            throw py::value_error(std::string(name) + ": a row an axis is needed");
        for (int i = 0; i < D; ++i)
            for (int k = 0; k < D; ++k) value[i][k] = rows.at(static_cast<std::size_t>(i), k);
    } else if constexpr (std::is_same_v<Value, std::optional<motion::Box<D>>>) {
        value = box_of_corners<D>(given);
    } else if constexpr (motion::DescribedIfOn<Value>) {
        value = motion::by_default<typename Value::value_type, D>();
        Value::value_type::each_field([&](auto member, const motion::Field& each) {
            read<D>(given, each, (*value).*member);
        });
    } else {
        for (const py::handle each : given)
            value.push_back(obstacle_of<D>(py::reinterpret_borrow<py::object>(each)));
    }
}

/// An obstacle by the class of signum.effects that it is of.
template <int D>
motion::Obstacle<D> obstacle_of(const py::object& object) {
    const std::string kind = py::str(py::type::of(object).attr("__name__"));
    const auto of = [&]<class Wall>(Wall wall) {
        Wall::each_field(
            [&](auto member, const motion::Field& field) { read<D>(object, field, wall.*member); });
        return wall;
    };
    if (kind == "HalfSpace") return of(motion::HalfSpace<D>{});
    if (kind == "Sphere") return of(motion::Sphere<D>{});
    if constexpr (D == 2)
        if (kind == "Segment") return of(motion::Segment{});
    throw py::value_error("obstacles: " + kind + " is none of the classes of signum.effects" +
                          (D == 3 ? " for space" : ""));
}

/// The fields of a signum.effects.Effects.
template <int D>
motion::Effects<D> effects_of(const py::object& given) {
    motion::Effects<D> effects;
    motion::Effects<D>::each_field(
        [&](auto member, const motion::Field& field) { read<D>(given, field, effects.*member); });
    return effects;
}

template <int D>
std::vector<motion::Body<D>> bodies_of(const Rows& rows) {
    std::vector<motion::Body<D>> bodies(rows.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        motion::Body<D>& body = bodies[i];
        for (int k = 0; k < D; ++k) {
            body.x[k] = rows.at(i, k);
            body.v[k] = rows.at(i, D + 1 + k);
        }
        body.radius = rows.at(i, D);
        const double r = body.radius;
        body.mass = rows.columns() > 2 * D + 1 ? rows.at(i, 2 * D + 1) : D == 2 ? r * r : r * r * r;
    }
    return bodies;
}

/// A state and the effects that places at other times depend on.
template <int D>
struct StateAndEffects {
    motion::State<D> state;
    motion::Effects<D> effects;
};
template <int D>
struct Running {
    motion::Effects<D> effects;
    motion::Simulation<D> simulation;
};
using State = std::variant<StateAndEffects<2>, StateAndEffects<3>>;
using Simulation = Exclusive<std::variant<Running<2>, Running<3>>>;

template <int D>
Running<D> started(const Rows& rows, const py::object& effects, const motion::Options& options) {
    const motion::Effects<D> acting = effects_of<D>(effects);
    const std::vector<motion::Body<D>> bodies = bodies_of<D>(rows);
    try {
        return watched([&](Watch&) {
            const motion::State<D> state =
                motion::start(std::span<const motion::Body<D>>(bodies), acting);
            return Running<D>{acting, motion::Simulation<D>(state, acting, options)};
        });
    } catch (const motion::BallError& error) {
        throw py::value_error("balls: row " + std::to_string(error.ball()) + ": " + error.what());
    }
}

std::unique_ptr<Simulation> simulation(const py::object& balls, const py::object& effects,
                                       const std::string& structure,
                                       const std::string& arithmetic) {
    const exact::IeeeEnvironment environment;
    const Rows rows(balls, "balls", 5, 8);
    motion::Options options;
    options.structure = named(structure, "structure", motion::all_structures);
    if (arithmetic != "exact" && arithmetic != "naive")
        throw py::value_error("arithmetic '" + arithmetic + "' is none of exact, naive");
    options.kernel = arithmetic == "naive" ? motion::Kernel::naive : motion::Kernel::exact;
    if (rows.columns() <= 6)
        return std::make_unique<Simulation>(started<2>(rows, effects, options));
    return std::make_unique<Simulation>(started<3>(rows, effects, options));
}

/// visit(running) of the simulation, with the interpreter free.
template <class Visit>
auto with_running(Simulation& simulation, const py::object& progress, Visit visit) {
    return watched(progress, [&](Watch& watch) {
        return simulation.use([&](auto& either) {
            return std::visit([&](auto& running) { return visit(running, watch); }, either);
        });
    });
}

/// In the order of motion::Ending.
constexpr const char* names_of_endings[] = {"until", "strikes", "nothing", "stopped", "collapse"};
static_assert(std::size(names_of_endings) == static_cast<int>(motion::Ending::collapse) + 1);

/// How it ended, and its log; where a signal ended it that is raised, and the log is lost.
py::tuple run(Simulation& simulation, double until, const py::object& strikes, bool log,
              const py::object& progress) {
    motion::Limits limits;
    limits.until = until;
    if (!strikes.is_none()) {
        try {
            limits.strikes = strikes.cast<std::uint64_t>();
        } catch (const py::cast_error&) {
            throw py::value_error("strikes: a whole number from 0 to 2**64 - 1 is needed");
        }
    }
    std::vector<motion::Strike> all;
    motion::Simulation<2>::Record record;
    if (log) record = [&all](const motion::Strike& strike) { all.push_back(strike); };
    const motion::Outcome outcome =
        with_running(simulation, progress, [&](auto& running, Watch& watch) {
            limits.stop = watch.stop();
            return running.simulation.run(limits, record);
        });
    return py::make_tuple(names_of_endings[static_cast<int>(outcome.ending)],
                          column(std::move(all)));
}

State state_of(Simulation& simulation) {
    return with_running(simulation, py::none(), [](auto& running, Watch&) -> State {
        return StateAndEffects{running.simulation.state(), running.effects};
    });
}

py::dict counts(Simulation& simulation) {
    const motion::Counts all = with_running(
        simulation, py::none(), [](auto& running, Watch&) { return running.simulation.counts(); });
    return py::dict("strikes"_a = all.strikes, "checks"_a = all.checks, "own"_a = all.own,
                    "stale"_a = all.stale, "refined"_a = all.refined, "exact"_a = all.exact,
                    "joins"_a = all.joins, "breaks"_a = all.breaks, "virial"_a = all.virial);
}

/// Numbers of the balls in place: from `offset` numbers on.
py::array part_of_balls(const py::object& self, int which) {
    return std::visit(
        [&](const auto& with_effects) {
            using Balls = std::decay_t<decltype(with_effects.state.balls)>;
            using Ball = typename Balls::value_type;
            constexpr std::size_t d = sizeof(Ball::x) / sizeof(double);
            constexpr std::size_t offsets[] = {0, d, 2 * d, 2 * d + 1};
            return part<double>(std::span<const Ball>(with_effects.state.balls),
                                offsets[static_cast<std::size_t>(which)], which < 2 ? d : 1, self);
        },
        self.cast<const State&>());
}

template <int D>
py::array centres_at(const StateAndEffects<D>& with_effects, double time) {
    const exact::IeeeEnvironment environment;
    std::vector<motion::Vector<D>> centres;
    centres.reserve(with_effects.state.balls.size());
    for (const motion::Ball<D>& ball : with_effects.state.balls)
        centres.push_back(motion::centre(ball, time, with_effects.effects));
    return table<double>(std::move(centres));
}
double time_of(const State& state) {
    return std::visit([](const auto& with_effects) { return with_effects.state.time; }, state);
}

py::object closest_pair(const State& state) {
    const auto pair = watched([&](Watch&) {
        return std::visit(
            [](const auto& with_effects) {
                return motion::closest_pair(with_effects.state, with_effects.effects);
            },
            state);
    });
    if (!pair) return py::none();
    return py::make_tuple(pair->a, pair->b, pair->gap);
}

void bind_simulation(py::module_& module) {
    py::class_<Simulation> bound(module, "_Simulation");
    complete(bound);
    bound
        .def(py::init(&simulation), py::arg("balls"), py::arg("effects"), py::arg("structure"),
             py::arg("arithmetic"))
        .def("run", &run, py::arg("until"), py::arg("strikes"), py::arg("log"), py::arg("progress"))
        .def("state", &state_of)
        .def("counts", &counts);
}

void bind_state(py::module_& module) {
    py::class_<State> bound(module, "State", R"(Balls at one time: what Simulation.state() gives.

Each ball's x and v are those at its own time, of its last strike, and exact; until its next strike it
flies on. The arrays are read-only views of the state's memory.)");
    complete(bound);
    bound.def_property_readonly("time", &time_of, "Nothing is left to do before it.")
        .def_property_readonly(
            "dimension", [](const State& state) { return state.index() == 0 ? 2 : 3; }, "2 or 3.")
        .def_property_readonly(
            "x", [](const py::object& self) { return part_of_balls(self, 0); },
            "Centres at the balls' own times, float64 (n, dimension).")
        .def_property_readonly(
            "v", [](const py::object& self) { return part_of_balls(self, 1); },
            "Velocities at the balls' own times, float64 (n, dimension).")
        .def_property_readonly(
            "radius", [](const py::object& self) { return part_of_balls(self, 2); },
            "Radii at time 0, or at the end of a growth: float64 (n,).")
        .def_property_readonly(
            "own_time", [](const py::object& self) { return part_of_balls(self, 3); },
            "The balls' own times, float64 (n,).")
        .def_property_readonly(
            "mass",
            [](const py::object& self) {
                return std::visit(
                    [&](const auto& with_effects) {
                        return column(std::span<const double>(with_effects.state.masses), self);
                    },
                    self.cast<const State&>());
            },
            "Masses, float64 (n,).")
        .def(
            "centres",
            [](const State& state, const py::object& time) {
                const double at = time.is_none() ? time_of(state) : number_of(time, "time");
                return std::visit(
                    [at](const auto& with_effects) { return centres_at(with_effects, at); }, state);
            },
            py::arg("time") = py::none(),
            R"(All centres at one time, that of the state unless it is given: float64 (n, dimension).

Rounded. What strikes after the state's time it does not know.)")
        .def(
            "closest_pair", &closest_pair,
            R"((a, b, gap) of the two balls whose surfaces are nearest to each other; None of fewer than two.

Which pair it is is exact, gap the nearest double. Raises ValueError where balls grow or there are time
steps.)")
        .def(
            "__len__",
            [](const State& state) {
                return std::visit(
                    [](const auto& with_effects) { return with_effects.state.balls.size(); },
                    state);
            },
            "How many balls there are.");
}

}  // namespace

void bind_motion(py::module_& module) {
    using motion::Strike;
    PYBIND11_NUMPY_DTYPE(Strike, time, wall, a, b, impulse);
    bind_state(module);
    bind_simulation(module);
}

}  // namespace signum::python
