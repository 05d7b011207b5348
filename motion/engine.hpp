#pragma once
/// The loop over one structure, behind one interface; each structure's is compiled in a source of
/// its own (structures/*.cpp).

#include <cstdint>
#include <memory>
#include <vector>

#include "simulation.hpp"

namespace signum::motion {

template <int D>
class Simulation<D>::Engine {
 public:
    virtual ~Engine() = default;
    virtual Outcome run(const Limits& limits, const Record& record) = 0;
    [[nodiscard]] virtual State<D> state() const = 0;
    [[nodiscard]] virtual const Counts& counts() const = 0;
    [[nodiscard]] virtual Sketch<D> sketch() const = 0;
};

template <int D, template <int> class StructureOf>
[[nodiscard]] std::unique_ptr<typename Simulation<D>::Engine> make_engine(
    Structure structure, const State<D>& state, const Effects<D>& effects, Kernel kernel,
    const std::vector<std::int32_t>& order);

}  // namespace signum::motion
