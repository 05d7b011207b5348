#!/usr/bin/env bash
# The results of 200 sets in four metrics, as hashes of the tool's JSON with vertices: whoever
# changes the house must not move a byte of them.
#
#   tests/structure/results.sh TOOL          compares with results.sha256; exit 1 where they differ
#   tests/structure/results.sh TOOL --write  writes the table anew
set -euo pipefail
tool=$(readlink -f "$1")
table=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/results.sha256
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# 120 sets of the tool's own distributions.
for distribution in random circle square grid lattice rings offset tangent; do
  for n in 12 100 600; do
    for radius in 0 0.5:9; do
      for seed in 1 2; do
        "$tool" generate "$distribution" -n "$n" --radius "$radius" --seed "$seed" \
          -o "$distribution-$n-$radius-$seed.txt"
      done
    done
    "$tool" generate "$distribution" -n "$n" --radius 3:3 --perturb 1e-9 \
      -o "$distribution-$n-perturbed.txt"
  done
done

# 80 sets full of ties: small integers, some of them scaled far up or down, shifted far away, or
# with one giant in the middle.
for set in $(seq 80); do
  awk -v set="$set" '
    function next_number(limit) { state = (state * 16807) % 2147483647; return state % limit }
    BEGIN {
      state = 7919 * set + 1
      for (i = 0; i < 5; ++i) next_number(2)
      count = 4 + next_number(set % 4 == 0 ? 60 : 11)
      span = 2 + next_number(set % 4 == 0 ? 20 : 5)
      most = 1 + next_number(4)
      scale = set % 5 == 1 ? 2^300 : set % 5 == 2 ? 2^-500 : set % 5 == 3 ? 0.1 : 1
      shift = set % 7 == 3 ? 2^40 : 0
      for (i = 0; i < count; ++i)
        printf "%.17g %.17g %.17g\n", (shift + next_number(span)) * scale,
               (shift + next_number(span)) * scale, next_number(most) * scale
      if (set % 3 == 0)
        printf "%.17g %.17g %.17g\n", (shift + 100 * span) * scale, shift * scale, 99 * span * scale
    }' >"ties-$set.txt"
done

for sites in *.txt; do
  for metric in power euclidean manhattan supremum; do
    sum=$("$tool" triangulate "$sites" --metric "$metric" --vertices --quiet | sha256sum)
    echo "${sum%% *} ${sites%.txt} $metric"
  done
done >results

if [ "${2:-}" = --write ]; then
  cp results "$table"
elif ! diff "$table" results; then
  echo "the results differ from those of $table" >&2
  exit 1
fi
echo "$(wc -l <results) results"
