#!/usr/bin/env bash
# Configures where necessary and builds, quietly unless something fails.
#
#   scripts/build.sh DIRECTORY TARGET [CMAKE_OPTION...]
#
# The build is a Release build unless an option says otherwise. Exit code 3 when it fails.
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
options=(-G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_COMPILER=$CXX" "$@")

mkdir -p "$build"
# Two callers at once would build over each other.
if command -v flock >/dev/null; then
  exec 9>"$build/.lock"
  flock 9
fi

# A directory that was configured for other options, or lies elsewhere now, is configured anew.
asked=$build/.configured
wish=$(printf '%s\n' "$root" "${options[@]}")
log=$build/build.log
if [ ! -f "$build/build.ninja" ] || [ "$(cat "$asked" 2>/dev/null)" != "$wish" ]; then
  rm -rf "$asked" "$build/CMakeCache.txt" "$build/CMakeFiles"
  if ! cmake -S "$root" -B "$build" "${options[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    say "the build could not be configured"
    exit 3
  fi
  printf '%s\n' "$wish" >"$asked"
  say "building in $build (the first time takes a few minutes)"
fi

if [ -t 2 ]; then
  cmake --build "$build" --target "$target" --parallel "${JOBS:-$(jobs)}" >&2 || exit 3
elif ! cmake --build "$build" --target "$target" --parallel "${JOBS:-$(jobs)}" >"$log" 2>&1; then
  cat "$log" >&2
  say "the build failed"
  exit 3
fi
