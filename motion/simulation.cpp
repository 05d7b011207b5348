#include "simulation.hpp"

#include <numeric>

#include "loop.hpp"
#include "structures/cells.hpp"
#include "structures/levels.hpp"
#include "structures/lists.hpp"
#include "structures/pairs.hpp"
#include "structures/segments.hpp"
#include "structures/tree.hpp"

namespace signum::motion {
namespace {

template <int D, template <int> class Structure>
std::unique_ptr<typename Simulation<D>::Engine> engine(std::span<const Body<D>> bodies,
                                                       const Effects<D>& effects,
                                                       const Options& options,
                                                       const std::vector<std::int32_t>& order) {
    const bool falls = effects.gravity != Vector<D>{};
    (void)options;
    if (falls) return std::make_unique<Loop<D, true, true, Structure>>(bodies, effects, order);
    return std::make_unique<Loop<D, false, true, Structure>>(bodies, effects, order);
}

}  // namespace

template <int D>
Simulation<D>::Simulation(std::span<const Body<D>> bodies, const Effects<D>& effects,
                          const Options& options) {
    std::vector<std::int32_t> order(bodies.size());
    std::iota(order.begin(), order.end(), 0);
    StructureName structure = options.structure;
    if (effects.periodic && structure != StructureName::lists) {
        double shortest = infinity;
        double widest = 0.0;
        for (int k = 0; k < D; ++k)
            shortest = std::min(shortest, effects.box->high[k] - effects.box->low[k]);
        for (const Body<D>& body : bodies) widest = std::max(widest, 2.0 * body.radius);
        // Whoever is in a neighbouring cell must be so in one image alone.
        if (shortest < 5.01 * widest) structure = StructureName::pairs;
    }
    switch (structure) {
        case StructureName::pairs: engine_ = engine<D, Pairs>(bodies, effects, options, order); break;
        case StructureName::cells: engine_ = engine<D, CellsOfOneSize>(bodies, effects, options, order); break;
        case StructureName::tree: engine_ = engine<D, OccupiedCells>(bodies, effects, options, order); break;
        case StructureName::segments: engine_ = engine<D, Segments>(bodies, effects, options, order); break;
        case StructureName::levels: engine_ = engine<D, Levels>(bodies, effects, options, order); break;
        case StructureName::lists: engine_ = engine<D, Lists>(bodies, effects, options, order); break;
    }
}
template <int D>
Simulation<D>::~Simulation() = default;
template <int D>
Simulation<D>::Simulation(Simulation&&) noexcept = default;
template <int D>
Simulation<D>& Simulation<D>::operator=(Simulation&&) noexcept = default;

template <int D>
Outcome Simulation<D>::run(double until, std::uint64_t most, const Record& record) {
    return engine_->run(until, most, record);
}
template <int D>
std::vector<Ball<D>> Simulation<D>::balls() const {
    return engine_->balls();
}
template <int D>
const Counts& Simulation<D>::counts() const {
    return engine_->counts();
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace signum::motion
