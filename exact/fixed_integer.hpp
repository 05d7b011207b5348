#pragma once
/// Integers of a fixed size, which allocate no memory. For sources only, for Boost comes with it.

#include <boost/multiprecision/cpp_int.hpp>

namespace signum::exact {

/// Below 2^bits; who computes in them has counted that nothing gets there.
template <unsigned bits>
using FixedInteger = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<bits, bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

}  // namespace signum::exact
