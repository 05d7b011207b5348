/// The classic names as C links them, and C++ programs that say extern "C".

#include "classic.h"
#include "rounded.hpp"

void exactinit() {}

#define SIGNUM_POINT const double*
extern "C" {
#include "names.hpp"
}
