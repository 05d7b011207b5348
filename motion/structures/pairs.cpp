#include "pairs.hpp"

#include "../loop.hpp"

namespace signum::motion {

template std::unique_ptr<Simulation<2>::Engine> make_engine<2, Pairs>(
    Structure, const State<2>&, const Effects<2>&, Kernel, const std::vector<std::int32_t>&);
template std::unique_ptr<Simulation<3>::Engine> make_engine<3, Pairs>(
    Structure, const State<3>&, const Effects<3>&, Kernel, const std::vector<std::int32_t>&);

}  // namespace signum::motion
