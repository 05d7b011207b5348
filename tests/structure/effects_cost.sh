#!/usr/bin/env bash
# An effect that is off: the same log, and at most 2 % more instructions than a loop that does not
# know it. Instructions are counted, by callgrind, for these are the same each time.
#
#   effects_cost.sh PROGRAM     (effects_cost/gas.cpp)
set -euo pipefail
gas=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# NAME: its log goes to NAME.log, the number of instructions is printed.
count() {
  "$gas" "$1" "$scratch/$1.log" >/dev/null
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$gas" "$1" >/dev/null 2>"$scratch/$1.txt"
  sed -n 's/^.*Collected : \([0-9]*\)$/\1/p' "$scratch/$1.txt"
}

failed=false
knows=$(count none)
lines=$(wc -l <"$scratch/none.log")
[ "$lines" -eq 6000 ] || { echo "the gas made $lines strikes, not 6000"; failed=true; }
for name in walls speed_law contact_duration friction growth time_steps contacts all; do
  does_not=$(count "$name")
  awk -v a="$knows" -v b="$does_not" -v name="$name" \
    'BEGIN { printf "%-18s %10d instructions without, %10d with: %+.2f %%\n", name, b, a, 100 * (a / b - 1) }'
  if [ $((100 * knows)) -gt $((102 * does_not)) ]; then
    echo "$name: more than 2 % more"
    failed=true
  fi
  cmp "$scratch/none.log" "$scratch/$name.log" || failed=true
done
! $failed
