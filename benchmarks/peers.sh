#!/usr/bin/env bash
# Builds the peers' benchmark and prints the tables of docs/peers.md (Markdown) to standard output:
#
#   benchmarks/peers.sh > tables.md
#
# Arguments go to peers_benchmark: --sites N, --rounds N.
# BUILD_DIR  where to build (build/benchmark)
# JOBS       compilers at a time (one per core)
# CORE       the core to stay on (the last that this process may use)
# Peers are those that the machine has (Debian: libcgal-dev, libtet1.5-dev, libqhull-dev; node and
# npm, which bring Delaunator). Best on an idle machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

delaunator_version=5.1.0
build=${BUILD_DIR:-build/benchmark}
cmake --preset benchmark -B "$build" >&2
cmake --build "$build" --parallel ${JOBS:+"$JOBS"} --target peers_benchmark >&2

versions=()
for package in libcgal-dev libtet1.5-dev libqhull-dev; do
  version=$(dpkg-query -W -f '${Version}' "$package" 2>/dev/null) && versions+=("$package $version")
done
options=()
if command -v node >/dev/null && command -v npm >/dev/null; then
  npm install --prefix "$build/npm" --no-audit --no-fund --silent \
    "delaunator@$delaunator_version" >&2
  robust=$(node -p "require('$(realpath "$build")/npm/node_modules/robust-predicates/package.json').version")
  options=(--delaunator "node benchmarks/peer_delaunator.mjs '$(realpath "$build")/npm'")
  versions+=("delaunator $delaunator_version" "robust-predicates $robust" "node $(node --version)")
fi

source benchmarks/machine.sh
describe_machine "$build"
[ ${#versions[@]} -eq 0 ] || printf 'Peers: %s.\n' "$(printf '%s, ' "${versions[@]}" | sed 's/, $//')"
echo
exec "${pin[@]}" "$build/benchmarks/peers_benchmark" ${options[@]+"${options[@]}"} "$@"
