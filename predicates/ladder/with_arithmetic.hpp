#pragma once
/// From an arithmetic that is known when a program runs to one that its compiler knows. For sources
/// only.

#include <stdexcept>

#include "../arithmetic.hpp"

namespace signum::predicates {

/// Calls visit<arithmetic>() with one of constructions. Throws std::invalid_argument for any other.
template <class Visit>
auto with_arithmetic(Arithmetic arithmetic, Visit visit) {
    switch (arithmetic) {
        case Arithmetic::exact:
            return visit.template operator()<Arithmetic::exact>();
        case Arithmetic::naive:
            return visit.template operator()<Arithmetic::naive>();
        case Arithmetic::single:
            return visit.template operator()<Arithmetic::single>();
        case Arithmetic::interval:
            return visit.template operator()<Arithmetic::interval>();
        case Arithmetic::sum:
            return visit.template operator()<Arithmetic::sum>();
        case Arithmetic::multiprecision:
            return visit.template operator()<Arithmetic::multiprecision>();
        case Arithmetic::judging:
            break;
    }
    throw std::invalid_argument("the arithmetic is none of constructions");
}

}  // namespace signum::predicates
