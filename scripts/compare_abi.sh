#!/usr/bin/env bash
# What changed between two revisions in the shared library's interface, layouts of types included: builds both with
# debugging information, which takes minutes, and has abidiff compare them (Debian: abigail-tools).
#
#   scripts/compare_abi.sh OLD [NEW]    NEW is HEAD
#
# Exit code 0: nothing, or only additions; 1: something changed that programs may depend on, or a name is gone.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [ $# -lt 1 ] || [ $# -gt 2 ]; then
  sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
command -v abidiff >/dev/null || { echo "signum: abidiff is missing: apt-get install abigail-tools" >&2; exit 3; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# NAME REVISION: scratch/NAME has the sources, scratch/NAME/built the library, scratch/NAME/prefix its headers.
build() {
  mkdir "$scratch/$1"
  git -C "$root" archive "$2" | tar -x -C "$scratch/$1"
  cmake -S "$scratch/$1" -B "$scratch/$1/built" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS=-g -DBUILD_SHARED_LIBS=ON \
    -DSIGNUM_BUILD_TOOL=OFF -DSIGNUM_BUILD_TESTS=OFF >"$scratch/log" 2>&1 &&
    cmake --build "$scratch/$1/built" >"$scratch/log" 2>&1 &&
    cmake --install "$scratch/$1/built" --prefix "$scratch/$1/prefix" >"$scratch/log" 2>&1 || {
    cat "$scratch/log" >&2
    exit 3
  }
}
build old "$1"
build new "${2:-HEAD}"
outcome=0
abidiff --no-added-syms --drop-private-types --headers-dir1 "$scratch/old/prefix/include" --headers-dir2 "$scratch/new/prefix/include" \
  "$scratch/old/prefix/lib/libsignum.so" "$scratch/new/prefix/lib/libsignum.so" || outcome=$?
# Its exit code is a sum: 1 it failed, 2 wrong call, 4 something changed, 8 incompatibly.
[ $((outcome & 3)) -eq 0 ] || exit 3
[ "$outcome" -eq 0 ] || exit 1
