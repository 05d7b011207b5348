# Installs into a scratch prefix, moves it, and builds and runs a program of a user's own against it.
# Every installed header must compile alone, without anything of Boost or GMP.
set(scratch "${BUILD}/Testing/consumer")
file(REMOVE_RECURSE "${scratch}")

include("${CMAKE_CURRENT_LIST_DIR}/must.cmake")

must("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${scratch}/first")
# A package says where it lies relative to itself.
file(RENAME "${scratch}/first" "${scratch}/prefix")

list(JOIN FLAGS " " flags)
must("${CMAKE_COMMAND}" -S "${SOURCES}/tests/consumer" -B "${scratch}/build" -G "${GENERATOR}"
     "-DCMAKE_PREFIX_PATH=${scratch}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}"
     "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=${flags}")
file(STRINGS "${scratch}/build/CMakeCache.txt" found REGEX "^signum_DIR:")
if(NOT found MATCHES "${scratch}/prefix")
  message(FATAL_ERROR "found another signum: ${found}")
endif()
must("${CMAKE_COMMAND}" --build "${scratch}/build")
must("${scratch}/build/consumer")
set(expected "ccw 1
in_circle 1
face -1 0 2
face -1 1 0
face -1 2 1
face 0 1 2
hidden 3 by 0
")
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the consumer said\n${output}instead of\n${expected}")
endif()

file(GLOB_RECURSE headers RELATIVE "${scratch}/prefix/include" "${scratch}/prefix/include/*.hpp")
# Those of interop/ are for who has Eigen, Boost or CGAL: tests/adoption/interop compiles them.
list(FILTER headers EXCLUDE REGEX "^signum/interop/")
list(LENGTH headers count)
if(count LESS 20)
  message(FATAL_ERROR "only ${count} headers are installed")
endif()
foreach(header IN LISTS headers)
  set(source "${scratch}/header.cpp")
  file(WRITE "${source}" "#include <${header}>\n#include <${header}>\n")
  must(${COMPILER} ${FLAGS} -std=c++20 -Wall -Wextra -Werror "-I${scratch}/prefix/include"
       -fsyntax-only -MD -MF "${scratch}/header.d" "${source}")
  file(STRINGS "${scratch}/header.d" foreign REGEX "/boost/|/gmp[^/]*\\.h|/mpfr[^/]*\\.h|/Eigen/")
  if(foreign)
    message(FATAL_ERROR "<${header}> is installed, but reaches ${foreign}")
  endif()
endforeach()
if(EXISTS "${scratch}/prefix/bin/signum")
  must("${scratch}/prefix/bin/signum" --version)
endif()
message(STATUS "${count} headers stand alone")
