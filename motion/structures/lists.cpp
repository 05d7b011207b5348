#include "lists.hpp"

#include "../loop.hpp"

namespace signum::motion {

SIGNUM_LOOPS_OVER(Lists)

}  // namespace signum::motion
