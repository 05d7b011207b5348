include("${CMAKE_CURRENT_LIST_DIR}/HeaderAndLibrary.cmake")
find_header_and_library(MPFR mpfr.h mpfr GMP::GMP)
