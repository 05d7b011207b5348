# Error-free transforms are written out: the compiler must not fuse what the proof keeps apart, nor
# take sums in another order. These come after CMAKE_CXX_FLAGS and undo what those may allow.
# A root is one instruction, and nobody asks errno about it.
set(SIGNUM_IEEE_OPTIONS -fno-fast-math -fno-unsafe-math-optimizations -fno-associative-math
    -fno-reciprocal-math -fno-finite-math-only -fsigned-zeros -ffp-contract=off
    -fno-math-errno)
