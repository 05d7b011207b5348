#!/usr/bin/env bash
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

usage() {
  cat <<'USAGE'
Draws the pictures of docs/pictures/ again.

  scripts/draw_pictures.sh          builds the tool and draws with it
  scripts/draw_pictures.sh TOOL     draws with this one

The animation of docs/flips.md comes from examples/path_animation.cpp, which is built in either case.
The same tool draws the same bytes. Only docs/pictures/ changes.
USAGE
}

case ${1:-} in
  -h | --help) usage && exit 0 ;;
esac
tool=$(readlink -f "${1:-$root/run}")
cd "$root"
out=docs/pictures
sites=$(mktemp -d)
trap 'rm -rf "$sites"' EXIT

# draw NAME METRIC FILE: every picture is checked from scratch before it counts.
draw() {
  "$tool" triangulate "$3" --metric "$2" --check --quiet -o "$out/$1.svg"
}

"$tool" generate random -n 18 --radius 10:110 --seed 148 -o "$sites/few.txt"
"$tool" generate random -n 60 --radius 5:60 --seed 6 -o "$sites/sixty.txt"
# diagram NAME METRIC FILE OPTION...
diagram() {
  "$tool" voronoi "$3" --metric "$2" --quiet -o "$out/$1.svg" "${@:4}"
}
"$tool" generate grid -n 36 --radius 20 -o "$sites/grid.txt"
"$tool" generate random -n 20000 --radius 0:4 --seed 3 -o "$sites/many.txt"

for metric in power euclidean manhattan supremum; do
  draw "few_$metric" "$metric" "$sites/few.txt"
  draw "sixty_$metric" "$metric" "$sites/sixty.txt"
  diagram "diagram_$metric" "$metric" "$sites/sixty.txt"
done

draw nested euclidean examples/nested.txt

# The thousand most populous cities, and all of the 4000 around India; the header comes along.
awk -F, '/^(#|x,)/ || n++ < 1000' examples/cities.csv > "$sites/world.csv"
draw cities euclidean "$sites/world.csv"
awk -F, '/^(#|x,)/ || (5800 < $1 && $1 < 9800 && 800 < $2 && $2 < 4200)' examples/cities.csv \
  > "$sites/india.csv"
draw cities_of_india euclidean "$sites/india.csv"

diagram diagram_nested euclidean examples/nested.txt
diagram diagram_chains euclidean examples/chains.txt
diagram diagram_grid supremum "$sites/grid.txt" --merge
diagram diagram_many euclidean "$sites/many.txt" --clip 300 300 380 360
diagram diagram_cities euclidean "$sites/india.csv"

"$tool" generate circle -n 300 -o "$sites/circle.txt"
"$tool" compare "$sites/circle.txt" --metric power --seconds 0 --quiet -o "$out/wrong_edges.svg" > "$sites/table.txt"

"$tool" generate random -n 80 --radius 5:70 --seed 3 -o "$sites/eighty.txt"
"$tool" triangulate "$sites/eighty.txt" --metric power --method flips --check --quiet -o "$out/flips.svg"

scripts/build.sh build/run examples -DSIGNUM_BUILD_TESTS=OFF
build/run/examples/path_animation > "$out/path.svg"
build/run/examples/sweep_animation > "$out/sweep.svg"
build/run/examples/dynamic_animation > "$out/dynamic.svg"
