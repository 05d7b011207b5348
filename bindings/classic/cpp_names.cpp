/// The classic names as C++ links them where a program declares them without extern "C", as TetGen
/// does, with points that are `double*` or `const double*`. Nobody includes a declaration.

#include "rounded.hpp"

void exactinit();
void exactinit(int, int, int, double, double, double);
void exactinit() {}
void exactinit(int, int, int, double, double, double) {}

#define SIGNUM_POINT double*
#include "names.hpp"
#undef SIGNUM_POINT
#define SIGNUM_POINT const double*
#include "names.hpp"
