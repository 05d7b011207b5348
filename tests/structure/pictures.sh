#!/usr/bin/env bash
# The pictures of docs/pictures/ are those that the commands of the pages make.
#
#   tests/structure/pictures.sh TOOL
#
# Exit code 1 where one of them is not; scripts/draw_pictures.sh draws them again. Every picture of a page
# is drawn by a command there, or by a program of examples/.
set -euo pipefail
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
drawn=$(mktemp -d)
trap 'rm -rf "$drawn"' EXIT
"$sources/scripts/draw_pictures.sh" "$1" "$drawn"
failures=0
for picture in "$sources"/docs/pictures/*.svg; do
  name=$(basename "$picture")
  [ -f "$sources/examples/${name%.svg}_animation.cpp" ] && continue
  [[ $name == neighbourhood_* ]] && continue  # those have a test of their own
  if ! cmp -s "$picture" "$drawn/$name"; then
    echo "docs/pictures/$name is not what its page's command draws" >&2
    failures=$((failures + 1))
  fi
done
for name in $(grep -ohE 'pictures/[a-z_]+\.svg' "$sources"/README.md "$sources"/docs/*.md "$sources"/docs/scenes/*.md | sort -u); do
  if [ ! -f "$sources/docs/$name" ]; then
    echo "docs/$name is shown and not there" >&2
    failures=$((failures + 1))
  fi
done
count=$(ls "$drawn" | wc -l)
echo "$count pictures drawn, $failures of them not those of docs/pictures"
[ "$count" -ge 20 ] && [ "$failures" -eq 0 ]
