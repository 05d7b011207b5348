#include "touched_sides.hpp"

#include "../core/contract.hpp"
#include "../predicates/additive.hpp"
#include "../predicates/rectangular/forms.hpp"

namespace signum {
namespace {

template <class Directions>
std::array<bool, 4> sides(const Site& a, const Site& b, const std::array<Index, 2>& ranks) {
    rectangular::Forms<Directions, Arithmetic::exact, 2> forms({&a, &b}, ranks);
    std::array<bool, 4> second{};
    for (int side = 0; side < 4; ++side)
        second[static_cast<std::size_t>(side)] = forms.compare(side, 1, 0) > 0;
    return second;
}

}  // namespace

std::array<bool, 4> sides_touched_by_second(Metric metric, const Site& a, Index a_index,
                                            const Site& b, Index b_index) {
    SIGNUM_EXPECTS(metric == Metric::supremum || metric == Metric::manhattan);
    const auto ranks = additive::ranks_of<2>({&a, &b}, {a_index, b_index});
    return metric == Metric::supremum ? sides<rectangular::Supremum>(a, b, ranks)
                                      : sides<rectangular::Manhattan>(a, b, ranks);
}

}  // namespace signum
