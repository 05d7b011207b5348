#!/usr/bin/env bash
# Builds the benchmarks and prints the tables of the README (Markdown) to standard output:
#
#   benchmarks/run.sh > tables.md
#
# BUILD_DIR  where to build (build/benchmark)
# JOBS       compilers at a time (one per core)
# CORE       the core to stay on (the last that this process may use)
# Best on an idle machine; the last line of each table says how much of the time went to others.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=${BUILD_DIR:-build/benchmark}
cmake --preset benchmark -B "$build" >&2
cmake --build "$build" --parallel ${JOBS:+"$JOBS"} \
  --target predicates_benchmark triangulation_benchmark memory_benchmark >&2

pin=()
pinned="not pinned"
if command -v taskset >/dev/null; then
  core=${CORE:-$(taskset -cp $$ | sed 's/.*[ ,-]//')}
  pin=(taskset -c "$core")
  pinned="pinned to one core"
fi

cpu=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo 2>/dev/null | sort -u | head -n 1)
cpu=${cpu:-$(sysctl -n machdep.cpu.brand_string 2>/dev/null || uname -m)}
compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$build/CMakeCache.txt")
huge_pages=$(sed -n 's/.*\[\(.*\)\].*/\1/p' /sys/kernel/mm/transparent_hugepage/enabled 2>/dev/null || true)
echo "$cpu, $(getconf _NPROCESSORS_ONLN) cores, $pinned; $(uname -sr);" \
  "transparent huge pages: ${huge_pages:-none}; $("$compiler" --version | head -n 1)."

for program in predicates_benchmark triangulation_benchmark memory_benchmark; do
  echo
  echo "running $program ..." >&2
  "${pin[@]}" "$build/benchmarks/$program"
done
