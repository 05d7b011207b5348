#!/usr/bin/env bash
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

usage() {
  cat <<'USAGE'
Draws the pictures of docs/pictures/ again.

  scripts/draw_pictures.sh              builds the tool and draws with it
  scripts/draw_pictures.sh TOOL         draws with this one
  scripts/draw_pictures.sh TOOL DIR     the same into DIR, without the animations

The pictures of the tool are drawn by the commands of the pages, as they stand there: the lines that
write files, which later lines read. The animations and the neighbourhoods come from examples/, which is built for them.
The same tool draws the same bytes. Only docs/pictures/, or DIR, changes.
USAGE
}

case ${1:-} in
  -h | --help) usage && exit 0 ;;
esac
tool=$(readlink -f "${1:-$root/run}")
out=$(readlink -f "${2:-$root/docs/pictures}")
cd "$root"
pages=(README.md docs/gallery.md docs/metrics.md docs/compare.md docs/flips.md docs/motion.md docs/space.md docs/scenes/*.md)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin"
ln -s "$tool" "$scratch/bin/signum"

# Every page in a directory of its own: names of files are those of the page.
for page in "${pages[@]}"; do
  directory=$(mktemp -d "$scratch/page.XXXXXX")
  ln -s "$root/examples" "$directory/examples"
  grep -E '^    (\$ )?(signum (generate|triangulate|voronoi|compare|simulate) .*-o |awk .* > )' "$page" |
    sed -E 's/^    (\$ )?//' > "$directory/commands.sh" || continue
  (cd "$directory" && PATH=$scratch/bin:$PATH bash -euo pipefail commands.sh > printed.txt 2>&1) ||
    { cat "$directory/printed.txt" >&2 && exit 1; }
  for picture in $(grep -oE 'pictures/[a-z_]+\.svg' "$page" | sort -u); do
    name=${picture#pictures/}
    if [ -f "$directory/$name" ]; then cp "$directory/$name" "$out/$name"; fi
  done
done
[ $# -lt 2 ] || exit 0

scripts/build.sh build/run examples -DSIGNUM_BUILD_TESTS=OFF
for name in path sweep dynamic; do
  "build/run/examples/${name}_animation" > "$out/$name.svg"
done
for predicate in ccw in_circle; do
  build/run/examples/neighbourhood_pictures "$predicate" > "$out/neighbourhood_$predicate.svg"
done
