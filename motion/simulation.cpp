#include "simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "../exact/floating_environment.hpp"
#include "../exact/kept_environment.hpp"
#include "engine.hpp"

namespace signum::motion {

template <int D>
class Pairs;
template <int D>
class Grid;
template <int D>
class Segments;
template <int D>
class Lists;
template <int D>
class Delaunay;

namespace {

/// How to make a structure's engine.
template <int D>
struct Row {
    Structure structure;
    std::unique_ptr<typename Simulation<D>::Engine> (*make)(Structure, const State<D>&,
                                                            const Effects<D>&, Kernel,
                                                            const std::vector<std::int32_t>&);
};
/// All structures but automatic.
template <int D>
std::vector<Row<D>> rows() {
    std::vector<Row<D>> result = {
        {Structure::pairs, make_engine<D, Pairs>},  {Structure::cells, make_engine<D, Grid>},
        {Structure::tree, make_engine<D, Grid>},    {Structure::segments, make_engine<D, Segments>},
        {Structure::levels, make_engine<D, Lists>}, {Structure::lists, make_engine<D, Lists>},
    };
    if constexpr (D == 2) result.push_back({Structure::delaunay, make_engine<2, Delaunay>});
    return result;
}

constexpr const char* thin_box = "the periodic box is thin beside its coordinates";

/// What the choice depends on.
struct Sizes {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0.0;
    double shortest_box = std::numeric_limits<double>::infinity();
    double packing = 0.0;   ///< the share of the box that balls fill
    double around = 0.0;    ///< so many balls are in a cube of it as wide as the largest one
    double farthest = 0.0;  ///< the largest coordinate
};
template <int D>
Sizes sizes_of(const State<D>& state, const Effects<D>& effects) {
    Sizes sizes;
    for (const Ball<D>& ball : state.balls) {
        sizes.smallest = std::min(sizes.smallest, ball.radius);
        sizes.largest = std::max(sizes.largest, ball.radius);
        sizes.packing += ball_volume<D>(ball.radius);
        for (const double x : ball.x) sizes.farthest = std::max(sizes.farthest, std::fabs(x));
    }
    if (effects.growth && state.time < effects.growth->until) {
        // What they become.
        const double factor = 1.0 + effects.growth->rate * effects.growth->until;
        sizes.smallest *= factor;
        sizes.largest *= factor;
        sizes.packing *= std::pow(factor, D);
    }
    if (!effects.box) return sizes;
    sizes.around = static_cast<double>(state.balls.size());
    for (int k = 0; k < D; ++k) {
        const double length = effects.box->lengths()[k];
        sizes.shortest_box = std::min(sizes.shortest_box, length);
        sizes.packing /= length;
        sizes.around *= 2.0 * sizes.largest / length;
        sizes.farthest = std::max(
            {sizes.farthest, std::fabs(effects.box->low[k]), std::fabs(effects.box->high[k])});
    }
    return sizes;
}

/// The balls along a curve through their places, so that neighbours lie near in memory.
template <int D>
std::vector<std::int32_t> along_a_curve(const State<D>& state, const Effects<D>& effects) {
    constexpr int bits = 62 / D;
    Vector<D> low;
    double extent = 0.0;
    std::vector<Vector<D>> places;
    places.reserve(state.balls.size());
    low.fill(std::numeric_limits<double>::infinity());
    for (const Ball<D>& ball : state.balls) {
        const Vector<D>& x = places.emplace_back(centre(ball, state.time, effects));
        for (int k = 0; k < D; ++k) low[k] = std::min(low[k], x[k]);
    }
    for (const Vector<D>& x : places)
        for (int k = 0; k < D; ++k) extent = std::max(extent, x[k] - low[k]);
    const double scale = std::ldexp(1.0 - 0x1p-40, bits) / (extent > 0.0 ? extent : 1.0);
    std::vector<std::pair<std::uint64_t, std::int32_t>> keys;
    keys.reserve(places.size());
    for (const Vector<D>& x : places) {
        std::uint64_t key = 0;
        for (int k = 0; k < D; ++k) {
            const auto number = static_cast<std::uint64_t>((x[k] - low[k]) * scale);
            for (int bit = 0; bit < bits; ++bit) key |= (number >> bit & 1) << (bit * D + k);
        }
        keys.emplace_back(key, static_cast<std::int32_t>(keys.size()));
    }
    std::ranges::sort(keys);
    std::vector<std::int32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, number] : keys) order.push_back(number);
    return order;
}

}  // namespace

std::string_view name_of(Structure structure) noexcept {
    return structure_table[static_cast<std::size_t>(structure)].name;
}

template <int D>
Choice choose(Structure wish, const State<D>& state, const Effects<D>& effects) {
    const Sizes sizes = sizes_of(state, effects);
    // Cells are as wide as the largest ball, and by three margins (Grid): 15 in five of them.
    const bool few_cells =
        effects.periodic && sizes.shortest_box * (1.0 - 0x1p-14) <
                                5.01 * 2.0 * sizes.largest + 0x1p-42 * sizes.farthest;
    // There the margins that structures allow for are no longer little beside the box (Spread).
    const bool thin = effects.periodic && sizes.shortest_box < 0x1p-36 * sizes.farthest;
    if (thin && wish != Structure::pairs) return {Structure::pairs, thin_box};
    if (wish == Structure::automatic) {
        if (state.balls.size() <= 16) return {Structure::pairs, "few balls"};
        if (few_cells) return {Structure::lists, "the periodic box is small"};
        if (sizes.around > 2.0)
            return {Structure::levels, "a cell as wide as the largest ball would hold several"};
        if (!effects.box && sizes.largest > 4.0 * sizes.smallest)
            return {Structure::levels, "the largest radius is more than four times the smallest"};
        if (!effects.box) return {Structure::tree, "no bounds are known"};
        if (D == 2 && sizes.packing < 0.6)
            return {Structure::cells, "discs fill less than three fifths of the box"};
        if (sizes.packing < 0.05)
            return {Structure::cells, "balls fill less than a twentieth of the box"};
        return {Structure::lists, "many balls of like sizes"};
    }
    const bool in_cells =
        wish == Structure::cells || wish == Structure::tree || wish == Structure::levels;
    if (few_cells && in_cells)
        return {Structure::pairs, "the periodic box has fewer than five cells along an axis"};
    if (wish == Structure::delaunay) {
        const Structure instead = few_cells ? Structure::lists : Structure::levels;
        if (D != 2) return {instead, "delaunay is a structure of the plane"};
        if (effects.growth && state.time < effects.growth->until)
            return {instead, "delaunay is for discs whose radii do not grow"};
        if (sizes.smallest == 0.0)
            return {instead,
                    "delaunay needs radii above 0: what it allows for rounding is a part of the "
                    "least one"};
        if (sizes.smallest < 0x1p-12 * sizes.largest)
            return {instead, "delaunay is for discs whose radii are within a factor of 4096"};
        // Its margin is more than places are rounded by.
        if (sizes.smallest * (sizes.smallest / sizes.largest) < 0x1p-40 * sizes.farthest)
            return {instead, "delaunay is for discs that are not tiny beside their coordinates"};
    }
    return {wish, "asked for"};
}

template <int D>
Simulation<D>::Simulation(const State<D>& state, const Effects<D>& effects,
                          const Options& options) {
    check(state, effects);
    const exact::IeeeEnvironment environment;
    const Structure structure = choose(options.structure, state, effects).structure;
    const std::vector<Row<D>> all = rows<D>();
    const auto row = std::ranges::find(all, structure, &Row<D>::structure);
    engine_ = row->make(structure, state, effects, options.kernel, along_a_curve(state, effects));
}
template <int D>
Simulation<D>::~Simulation() = default;
template <int D>
Simulation<D>::Simulation(Simulation&&) noexcept = default;
template <int D>
Simulation<D>& Simulation<D>::operator=(Simulation&&) noexcept = default;

template <int D>
Outcome Simulation<D>::run(const Limits& limits, const Record& record) {
    if (std::isnan(limits.until)) throw std::invalid_argument("until: a time that is no number");
    const exact::IeeeEnvironment environment;
    if (!record) return engine_->run(limits, record);
    return engine_->run(limits, [&record](const Strike& strike) {
        const exact::KeptEnvironment kept;
        record(strike);
    });
}
template <int D>
State<D> Simulation<D>::state() const {
    const exact::IeeeEnvironment environment;
    return engine_->state();
}
template <int D>
const Counts& Simulation<D>::counts() const {
    return engine_->counts();
}
template <int D>
Sketch<D> Simulation<D>::sketch() const {
    const exact::IeeeEnvironment environment;
    return engine_->sketch();
}

template Choice choose(Structure, const State<2>&, const Effects<2>&);
template Choice choose(Structure, const State<3>&, const Effects<3>&);
template class Simulation<2>;
template class Simulation<3>;

}  // namespace signum::motion
