#pragma once
/// The C interface, called by whoever looks at no comment: numbers of all kinds, words that there
/// are not, handles that are gone, room that is too small.

#include "target.hpp"

namespace signum::fuzz {

/// Predicates answer with a sign, or SIGNUM_NO_SIGN where it has none; turns and sums are those of
/// C++.
void predicates_of_c_target(Bytes bytes);
/// Every call succeeds or says what is wrong, and leaves its results as they were. What is built is
/// valid; balls and sites that come, go and fly are as many as were let in.
void structures_of_c_target(Bytes bytes);

}  // namespace signum::fuzz
