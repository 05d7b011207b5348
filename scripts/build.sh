#!/usr/bin/env bash
# Configures where necessary and builds, quietly unless something fails.
#
#   scripts/build.sh DIRECTORY TARGET [CMAKE_OPTION...]
#
# An option may be a preset, such as --preset=sanitize. Exit code 3 when the build fails.
# CXX chooses the compiler, JOBS how many of them run at a time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$1
target=$2
shift 2

say() { printf 'signum: %s\n' "$*" >&2; }

# One compiler per core, but no more than fit into memory at 1.5 GiB each.
jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1572864)}' /proc/meminfo 2>/dev/null || true)
  [ -n "$memory" ] && [ "$memory" -lt "$cores" ] && cores=$memory
  [ "$cores" -ge 1 ] || cores=1
  echo "$cores"
}

if [ -z "${CXX:-}" ]; then
  CXX=g++
  command -v g++ >/dev/null || CXX=clang++
fi
export CXX
options=(-G Ninja "-DCMAKE_CXX_COMPILER=$CXX" -DSIGNUM_UNITY_BUILD=ON "$@")

mkdir -p "$build"
# Two callers at once would build over each other.
if command -v flock >/dev/null; then
  exec 9>"$build/.lock"
  flock 9
fi

# The value of a name in the directory's cache.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt" 2>/dev/null || true; }

# Configured anew when the wish has changed; from nothing when CMake could not follow: the sources
# lie elsewhere now, the compiler or the generator is another.
asked=$build/.configured
wish=$(printf '%s\n' "CXX=$CXX" "$root" "${options[@]}")
log=$build/build.log
if [ ! -f "$build/build.ninja" ] || [ "$(cat "$asked" 2>/dev/null)" != "$wish" ]; then
  if [ "$(cached CMAKE_HOME_DIRECTORY)" != "$root" ] || [ "$(cached CMAKE_GENERATOR)" != Ninja ] ||
    { [ -f "$asked" ] && [ "$(head -n 1 "$asked")" != "CXX=$CXX" ]; }; then
    rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  fi
  rm -f "$asked"
  if ! cmake -S "$root" -B "$build" "${options[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    say "the build could not be configured"
    exit 3
  fi
  printf '%s\n' "$wish" >"$asked"
  say "building in $build (the first time this takes minutes)"
fi

# Keeps what is said, and says how far it is at every tenth of long work: a terminal has Ninja's own line.
follow() {
  local line tenths=0
  while IFS= read -r line; do
    printf '%s\n' "$line"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && ((BASH_REMATCH[2] >= 20)) || continue
    ((10 * BASH_REMATCH[1] / BASH_REMATCH[2] > tenths)) || continue
    tenths=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    say "$target: ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]} steps after $SECONDS s"
  done >"$log"
}

build=(cmake --build "$build" --target "$target" --parallel "${JOBS:-$(jobs)}")
if [ -t 2 ]; then
  "${build[@]}" >&2 || exit 3
elif ! "${build[@]}" 2>&1 | follow; then
  cat "$log" >&2
  say "the build failed"
  exit 3
fi
