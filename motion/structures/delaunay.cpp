#include "delaunay.hpp"

#include "../loop.hpp"

namespace signum::motion {

SIGNUM_LOOPS_IN(2, Delaunay)

}  // namespace signum::motion
