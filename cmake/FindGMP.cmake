include("${CMAKE_CURRENT_LIST_DIR}/HeaderAndLibrary.cmake")
find_header_and_library(GMP gmp.h gmp)
