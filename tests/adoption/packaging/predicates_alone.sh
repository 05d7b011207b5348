#!/usr/bin/env bash
# The component `predicates`: a project that asks for it alone links neither MPFR nor the rest; and a build of it alone
# looks for no MPFR and compiles no tessellation.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
cat >CMakeLists.txt <<'PROJECT'
cmake_minimum_required(VERSION 3.25)
project(asks_for_signs LANGUAGES CXX)
find_package(signum REQUIRED COMPONENTS predicates)
if(TARGET signum::signum OR TARGET MPFR::MPFR)
  message(FATAL_ERROR "more than what was asked for")
endif()
add_executable(signs signs.cpp)
target_link_libraries(signs PRIVATE signum::predicates)
PROJECT
cat >signs.cpp <<'PROGRAM'
#include <cstdio>
#include <signum/predicates/ccw.hpp>
#include <signum/predicates/euclidean.hpp>
int main() {
    const double tiny = 0x1p-53;
    std::printf("%d %d\n", signum::ccw({0, 0}, {1, 1}, {0.5, 0.5 + tiny}),
                signum::euclidean::in_circle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}));
}
PROGRAM
cmake -S . -B build -G Ninja "-DCMAKE_CXX_COMPILER=$CXX" "-DCMAKE_PREFIX_PATH=$PREFIX" >log 2>&1 || { cat log; exit 1; }
cmake --build build >log 2>&1 || { cat log; exit 1; }
[ "$(build/signs)" = '1 0' ] || { build/signs; exit 1; }
if readelf -d build/signs | grep -E 'NEEDED.*(mpfr|signum)'; then exit 1; fi

cmake -S "$SOURCES" -B alone -G Ninja "-DCMAKE_CXX_COMPILER=$CXX" -DSIGNUM_ONLY_PREDICATES=ON >log 2>&1 || { cat log; exit 1; }
if grep -E '^(MPFR|CLI11|fmt)_' alone/CMakeCache.txt; then exit 1; fi
ninja -C alone -t targets all | sed -n 's/: CXX_COMPILER.*//p' >compiled
grep -q 'predicates/euclidean' compiled
if grep -vE 'signum_signs\.dir/((exact|filters|predicates)/|cmake_pch)' compiled; then exit 1; fi
wc -l <compiled
