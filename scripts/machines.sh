#!/usr/bin/env bash
# Builds tests/structure/machines/signs.cpp for every machine, compiler and liberty at hand, runs it in
# every floating-point environment and compares with what it must print. Writes docs/machines.md.
#
#   scripts/machines.sh            all cells; those that are there already of these sources are kept
#   scripts/machines.sh NAME       those whose name contains this, and no page
#   scripts/machines.sh page       the page alone, of the cells that are there
#
# A cell takes a minute or so, one after another. JOBS: how many compilers run at a time.
# Exit code 1 where a cell differs or does not build and does not say why in words of ours.
set -uo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root" || exit
pattern=${1:-}
place=$root/build/machines
expected=$root/tests/structure/machines/signs.txt
environments=(nearest upward downward zero flush)
mkdir -p "$place/rows"

# What a row depends on.
sources=$(cat $(git ls-files core exact filters predicates triangulation cmake tests/structure/machines) | sha256sum)
if [ "$pattern" != page ] && [ "$(cat "$place/sources" 2>/dev/null)" != "$sources" ]; then
  rm -f "$place"/rows/*
  echo "$sources" >"$place/sources"
fi

failed=0

# One cell: its row is "TITLE | OUTCOME | OUTCOME | ...". Of the library it takes what library() set.
cell() {
  local name=$1 title=$2 user=$3 row build=$place/$library log sentence output environment outcomes=
  row=$place/rows/$name
  [[ $name == *$pattern* ]] || return
  if [ -s "$row" ]; then
    echo "$name: kept"
    grep -qE 'DIFFERS|does not build' "$row" && failed=1
    return
  fi
  log=$place/$name.log
  # The same for all five environments.
  refuse() {
    printf '%s | %s | | | |\n' "$title" "$1" >"$row"
    echo "$name: $1"
  }
  if ! command -v "$compiler" >/dev/null; then
    refuse "no $compiler here"
    return
  fi
  if ! printf '#include <vector>\nint main() {}\n' |
    "$compiler" $flags $link -x c++ - -o "$place/$name.probe" >"$log" 2>&1; then
    refuse "$compiler $flags: not here"
    return
  fi
  if ! { cmake -S tests/structure/machines -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None $system \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="-DNDEBUG $flags" -DCMAKE_EXE_LINKER_FLAGS="$link" \
    -DSIGNUM_WITH_GMP="$gmp" -DSIGNS_FLAGS="-Wfatal-errors $user" &&
    cmake --build "$build" -j "${JOBS:-$(nproc)}"; } >"$log" 2>&1; then
    sentence=$(sed -n 's/.*error: .*"\(signum needs[^"]*\)".*/\1/p; s/.*error: static assertion failed: \(signum needs.*\)/\1/p; s/^ *\(signum needs [a-z].*\)/\1/p' "$log" | head -n 1)
    if [ -n "$sentence" ]; then
      refuse "refused: $sentence"
    else
      failed=1
      refuse "does not build: $log"
    fi
    return
  fi
  if [ -n "$emulator" ] && ! command -v "$emulator" >/dev/null; then
    refuse "builds; no $emulator here"
    return
  fi
  for environment in "${environments[@]}"; do
    output=$place/$name.$environment.txt
    timeout 3600 $emulator "$build/signs" "$environment" >"$output" 2>>"$log"
    case $? in
      0)
        if cmp -s "$output" "$expected"; then
          outcomes+=' | equal'
        else
          outcomes+=' | DIFFERS'
          failed=1
        fi
        ;;
      3) outcomes+=' | –' ;;
      *)
        outcomes+=' | DIFFERS: it ends before its time'
        failed=1
        ;;
    esac
  done
  printf '%s%s |\n' "$title" "$outcomes" >"$row"
  echo "$name:$outcomes"
}

# NAME COMPILER FLAGS GMP [EMULATOR PROCESSOR]: what the next cells compile the library with.
library() {
  library=$1 compiler=$2 flags=$3 gmp=$4 emulator=${5:-} system=
  link=
  if [ -n "${6:-}" ]; then
    system="-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=$6"
    link=-static
  fi
}

# NAME TITLE COMPILER FLAGS GMP [EMULATOR PROCESSOR]: the caller's flags are the library's.
whole() {
  local name=$1 title=$2
  shift 2
  library "$name" "$@"
  cell "$name" "$title" ""
  machines+=("$name")
}

machines=()
liberties=()

whole gcc_O2 'g++ -O2' g++ -O2 ON
whole gcc_boost 'g++ -O2, without GMP' g++ -O2 OFF
whole gcc_O0 'g++ -O0' g++ -O0 ON
whole gcc_native 'g++ -O3 -march=native' g++ '-O3 -march=native' ON
whole clang_O2 'clang++ -O2' clang++-14 -O2 ON
whole clang_O0 'clang++ -O0' clang++-14 -O0 ON
whole clang_native 'clang++ -O3 -march=native' clang++-14 '-O3 -march=native' ON
whole clang_libcxx 'clang++ -O2 -stdlib=libc++, without GMP' clang++-14 '-O2 -stdlib=libc++' OFF
whole aarch64 'ARM, 64 bits (g++ -O2, without GMP)' aarch64-linux-gnu-g++ -O2 OFF qemu-aarch64-static aarch64
whole riscv64 'RISC-V, 64 bits (g++ -O2, without GMP)' riscv64-linux-gnu-g++ -O2 OFF qemu-riscv64-static riscv64
whole s390x 's390x, whose bytes go from the greatest to the least (g++ -O2, without GMP)' s390x-linux-gnu-g++ -O2 OFF qemu-s390x-static s390x
whole x87 'x86-64, x87 (g++ -O2 -mfpmath=387)' g++ '-O2 -mfpmath=387' ON
whole i686_sse 'x86, 32 bits, SSE2 (g++ -O2, without GMP)' i686-linux-gnu-g++ '-O2 -msse2 -mfpmath=sse' OFF '' i686
whole i686_x87 'x86, 32 bits, x87 (g++ -O2, without GMP)' i686-linux-gnu-g++ -O2 OFF '' i686

# What a user may do, while the library is compiled as it should be.
for compiler_name in gcc clang; do
  if [ $compiler_name = gcc ]; then
    library gcc_O2 g++ -O2 ON
    shown=g++
  else
    library clang_O2 clang++-14 -O2 ON
    shown=clang++
  fi
  while read -r user; do
    name=${compiler_name}_user$(tr -c 'a-zA-Z0-9\n' _ <<<"$user")
    cell "$name" "$shown ${user/#-f/-O2 -f}" "$user"
    liberties+=("$name")
  done <<'FLAGS'
-O0
-O3 -march=native
-march=native -ffp-contract=fast
-O3 -fno-signed-zeros -fno-trapping-math -freciprocal-math -fno-math-errno -ffp-contract=fast -march=native
-fno-signed-zeros
-fno-trapping-math
-fno-math-errno
-freciprocal-math
-frounding-math
-fassociative-math -fno-signed-zeros -fno-trapping-math
-ffinite-math-only
-funsafe-math-optimizations
-ffast-math
-Ofast
-fsingle-precision-constant
FLAGS
done

[ -n "$pattern" ] && [ "$pattern" != page ] && exit $failed

table() {
  echo "| | ${environments[*]} |" | sed 's/ / | /g; s/| | | |/| |/; s/| |$/|/'
  echo '| --- | --- | --- | --- | --- | --- |'
  local name
  for name in "$@"; do echo "| $(cat "$place/rows/$name" 2>/dev/null || echo "$name | not asked | | | |")"; done
}
{
  cat <<'PAGE'
# Machines, compilers, flags

A sign is the same wherever it is asked for, or the compiler refuses in a sentence of ours. `tests/structure/machines/signs.cpp` asks all
predicates of all metrics, in the plane and in space, some 240 000 signs and 30 tessellations: of raw bit patterns, of numbers with all
their digits, of grids, beside grids by up to 4 ulps, of many scales, of operands that are computed where the question is asked. It prints how often
-1, 0 and +1 come and a hash of them all; `tests/structure/machines/signs.txt` is what it must print.

This page is written by

    scripts/machines.sh

which builds the program for whatever compilers and emulators are here. It goes on where it was cut off, and begins anew after a change of the sources.
PAGE
  echo "The last of these cells was asked on $(date -u '+%-d %B %Y'), of commit $(git describe --always --dirty)."
  cat <<'PAGE'

The columns are floating-point environments that the caller set before asking: to nearest, upward, downward, toward zero,
and denormals flushed; – where the processor has no such thing.

## Library and caller compiled alike

PAGE
  table "${machines[@]}"
  cat <<'PAGE'

Without GMP the multiprecision stages compute with Boost's integers (`-DSIGNUM_WITH_GMP=OFF`). Machines other than this one are emulated by
QEMU's user mode.

## The caller's flags, with the library as it should be

PAGE
  table "${liberties[@]}"
} >docs/machines.md
exit $failed
