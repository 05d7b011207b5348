#!/usr/bin/env bash
# Programs of a user's own against the installed copy at PREFIX, without CMake: by pkg-config, shared and static, in
# C++ and, where the C header is installed, in C. (With CMake: structure.consumer.)
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
export PKG_CONFIG_PATH=$PREFIX/lib/pkgconfig
expected='ccw 1
in_circle 1
face -1 0 2
face -1 1 0
face -1 2 1
face 0 1 2
hidden 3 by 0'

# PROGRAM yes|no: whether it needs libsignum.so, and prints what it must.
check() {
  local needs=no
  readelf -d "$1" | grep -q 'NEEDED.*libsignum\.so' && needs=yes
  [ "$needs" = "$2" ] || { echo "$1: needs libsignum.so: $needs"; exit 1; }
  [ "$("./$1")" = "$expected" ] || { echo "$1 prints"; "./$1"; exit 1; }
}

[ "$(pkg-config --modversion signum)" = "$(sed -n 's/^project(signum VERSION \([0-9.]*\).*/\1/p' "$SOURCES/CMakeLists.txt")" ]
"$CXX" -std=c++20 $(pkg-config --cflags signum) -c "$SOURCES/tests/consumer/main.cpp" -o main.o
kinds=static
if [ -e "$PREFIX/lib/libsignum.so" ]; then
  kinds='shared static'
  # A shared library brings its own: its users name it alone.
  [ "$(pkg-config --libs-only-l signum | xargs)" = -lsignum ] || { pkg-config --libs signum; exit 1; }
  "$CXX" main.o -o shared $(pkg-config --libs signum) -Wl,-rpath,"$PREFIX/lib" -Wl,--no-undefined
  check shared yes
fi
libraries=$(pkg-config --static --libs signum)
"$CXX" main.o -o static ${libraries/-lsignum/-l:libsignum.a}
check static no
# Nothing from outside but the C library; and oneTBB, where it is, for distributions have it shared alone.
alone=-static
[[ $libraries == *-ltbb* ]] && alone='-static-libstdc++ -static-libgcc'
"$CXX" $alone main.o -o alone -Wl,-Bstatic ${libraries//-ltbb/} -Wl,-Bdynamic \
  $(grep -o -e -ltbb <<<"$libraries" || true) 2>log || { cat log; exit 1; }
check alone no
! readelf -d alone | grep -E 'NEEDED.*(gmp|mpfr|stdc)' || exit 1

if [ -e "$PREFIX/include/signum/signum.h" ]; then
  kinds+=', C'
  printf '#include <signum/signum.h>\nint main(void) { return 0; }\n' >header.c
  for standard in c99 c17; do
    "${CC:-cc}" -std=$standard -Wall -Wextra -Wpedantic -Werror $(pkg-config --cflags signum) -fsyntax-only header.c
  done
fi
echo "$kinds"
