#include "segments.hpp"

#include "../loop.hpp"

namespace signum::motion {

SIGNUM_LOOPS_OVER(Segments)

}  // namespace signum::motion
