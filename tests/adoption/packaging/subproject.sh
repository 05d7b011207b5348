#!/usr/bin/env bash
# signum as a part of another project, by add_subdirectory and by FetchContent from a local folder: it builds no tool
# and no tests, installs nothing, and leaves the other project's settings alone (tests/consumer/part).
#
#   subproject.sh [--whole]    with it everything is built, which takes minutes; else one object of the user's
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# HOW CMAKE_OPTION...
configure() {
  local how=$1
  shift
  cmake -S "$SOURCES/tests/consumer/part" -B "$scratch/$how" -G Ninja "-DFROM=$SOURCES" "-DHOW=$how" "$@" \
    "-DCMAKE_CXX_COMPILER=$CXX" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
  if grep -rlE 'signum\.(hpp|pc|1)|libsignum' --include=cmake_install.cmake "$scratch/$how"; then
    echo "$how: installs signum, which nobody asked for"
    exit 1
  fi
}

build() {
  cmake --build "$scratch/$1" --target "$2" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
}

configure subdirectory
configure fetch -DBUILD_SHARED_LIBS=ON
if [ "${1:-}" = --whole ]; then
  configure subdirectory -DCMAKE_BUILD_TYPE=Release
  configure fetch -DCMAKE_BUILD_TYPE=Release
  build subdirectory all
  build fetch all
  [ "$("$scratch/subdirectory/whole" | head -n 1)" = "ccw 1" ]
  [ "$("$scratch/fetch/whole" | head -n 1)" = "ccw 1" ]
else
  # How its headers are found; what it links is in the build file.
  build subdirectory own
  grep -q 'LINK_LIBRARIES = .*libsignum\.a.*libmpfr' "$scratch/subdirectory/build.ninja"
  grep -q 'LINK_LIBRARIES = .*libsignum\.so' "$scratch/fetch/build.ninja"
fi
# Asked for, it installs itself.
cmake -S "$SOURCES/tests/consumer/part" -B "$scratch/fetch" -DSIGNUM_INSTALL=ON >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
grep -rqF signum.pc --include=cmake_install.cmake "$scratch/fetch"
