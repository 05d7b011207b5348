# The warnings that every file of the project is clean under.
add_library(signum_warnings INTERFACE)
target_compile_options(signum_warnings INTERFACE -Wall -Wextra -Wconversion
                       $<$<BOOL:${SIGNUM_WERROR}>:-Werror>)
# g++ 12 warns of overlaps inside its own std::string (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(signum_warnings INTERFACE -Wno-restrict)
endif()
