#include "grid.hpp"

#include "../loop.hpp"

namespace signum::motion {

SIGNUM_LOOPS_OVER(Grid)

}  // namespace signum::motion
