#!/usr/bin/env bash
# What small fixed work costs the tool on one thread, in instructions, which are the same each time: a
# change that makes any of it dearer by more than 2 % is seen here. Callgrind counts.
#
#   tests/structure/instructions.sh TOOL          compares with instructions.txt; exit 1 where one costs more
#   tests/structure/instructions.sh TOOL --write  writes the table anew
#
# Counts are those of one compiler, which the table names; with another one nothing is compared.
set -euo pipefail
tool=$(readlink -f "$1")
table=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/instructions.txt
compiler=$("${CXX:-c++}" --version | head -n 1)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

if [ "${2:-}" != --write ]; then
  known=$(sed -n 's/^# //p' "$table")
  if [ "$known" != "$compiler" ]; then
    echo "the table is of $known, this is $compiler: nothing is compared"
    exit 0
  fi
fi

# Below 16384 sites one thread works, whatever the machine has.
"$tool" generate random -n 3000 --radius 0:6 -o random.txt
"$tool" generate random -n 500 --radius 0:10 -o few.txt
"$tool" generate grid -n 3000 -o grid.txt
"$tool" generate circle -n 1500 --radius 0:4 -o circle.txt
"$tool" generate random -n 1000 --dimension 3 --radius 0:30 -o space.txt

# NAME ARGUMENT...
count() {
  local name=$1 instructions
  shift
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$tool" "$@" --quiet >/dev/null 2>log ||
    { echo "signum $*:"; cat log; exit 1; } >&2
  instructions=$(sed -n 's/^.*Collected : \([0-9]*\)$/\1/p' log)
  echo "$name $instructions"
}

{
  for metric in power euclidean manhattan supremum; do
    for sites in random grid circle; do
      count "triangulate-$metric-$sites" triangulate $sites.txt --metric $metric -o $metric-$sites.json
    done
    "$tool" triangulate few.txt --metric $metric -o few.json --quiet
    count "validate-$metric" validate few.json few.txt
    count "voronoi-$metric" voronoi few.txt --metric $metric -o cells.json
  done
  count triangulate-space triangulate space.txt --dimension 3 --metric power -o space.json
  count validate-space validate space.json space.txt
} >counts

if [ "${2:-}" = --write ]; then
  { echo "# $compiler"; cat counts; } >"$table"
  exit
fi
# To be equal, but for what a rebuilt system library does otherwise; less is well, and tells to write the table anew.
awk 'NR == FNR { if ($1 != "#") before[$1] = $2; next }
  !($1 in before) { print $1 ": not in the table"; bad = 1; next }
  {
    ratio = $2 / before[$1]
    seen[$1]
    if (ratio > 1.02 || ratio < 0.9) { printf "%s: %d instructions, %d before: %.3f\n", $1, $2, before[$1], ratio; bad = 1 }
  }
  END {
    for (name in before) if (!(name in seen)) { print name ": not counted"; bad = 1 }
    if (bad) print "where that is meant: tests/structure/instructions.sh TOOL --write"
    exit bad
  }' "$table" counts
echo "$(wc -l <counts) counts, none above its bound"
