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
  --target predicates_benchmark triangulation_benchmark space_benchmark memory_benchmark >&2

source benchmarks/machine.sh
describe_machine "$build"
huge_pages=$(sed -n 's/.*\[\(.*\)\].*/\1/p' /sys/kernel/mm/transparent_hugepage/enabled 2>/dev/null || true)
echo "Transparent huge pages: ${huge_pages:-none}."

for program in predicates_benchmark triangulation_benchmark space_benchmark memory_benchmark; do
  echo
  echo "running $program ..." >&2
  "${pin[@]}" "$build/benchmarks/$program"
done
