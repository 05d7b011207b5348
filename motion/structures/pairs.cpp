#include "pairs.hpp"

#include "../loop.hpp"

namespace signum::motion {

SIGNUM_LOOPS_OVER(Pairs)

}  // namespace signum::motion
