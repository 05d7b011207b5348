#!/usr/bin/env bash
# Whether two runs of the same study agree: of what is counted, how much is equal; of what is timed,
# how many intervals have a number in common.
#
#   scripts/compare_studies.sh DIR DIR
#
# Ends with 1 where a count differs or fewer than 95 % of the times, or of the ratios, agree.
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: scripts/compare_studies.sh DIR DIR" >&2
  exit 2
fi
for directory in "$@"; do
  [ -r "$directory/results.csv" ] || {
    echo "compare_studies.sh: $directory has no results.csv; signum study -o makes one" >&2
    exit 2
  }
done

awk -F, '
  FNR == 1 || $9 == "cell_seconds" { next }
  { key = $1 FS $2 FS $3 FS $4 FS $5 FS $6 FS $7 FS $8 FS $9 }
  NR == FNR { value[key] = $10; low[key] = $11; high[key] = $12; next }
  !(key in value) { missing++; next }
  { common++ }
  $9 ~ /^(seconds|ratio|ns_)/ {
    timed[$9]++
    agree[$9] += $11 <= high[key] && low[key] <= $12
    next
  }
  { counted++ }
  $10 != value[key] { differ++; print "differs: " key ": " value[key] ", " $10 }
  END {
    bad = differ > 0 || !common
    for (quantity in timed) {
      share = 100 * agree[quantity] / timed[quantity]
      printf "%s: %d of %d agree (%.1f %%)\n", quantity, agree[quantity], timed[quantity], share
      bad = bad || share < 95
    }
    printf "counts: %d of %d equal\n", counted - differ, counted
    if (missing || length(value) > common)
      printf "only in one of the two: %d\n", missing + length(value) - common
    exit bad
  }' "$1/results.csv" "$2/results.csv"
