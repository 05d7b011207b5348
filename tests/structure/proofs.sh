#!/usr/bin/env bash
# Writes the proofs of the filters' bounds and has gappa check each. Without gappa it is skipped (77). The
# table of docs/proofs.md must say what the program prints.
#
#   proofs.sh PROGRAM [DIRECTORY]     (proofs/proofs.cpp); with a directory the scripts stay there
set -euo pipefail
proofs=$1
if ! command -v gappa >/dev/null; then
  echo "gappa is not installed: no bound is proved here"
  exit 77
fi
if [ $# -gt 1 ]; then
  scratch=$2
  mkdir -p "$scratch"
  rm -f "$scratch"/*.g
else
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
fi

table=$("$proofs" "$scratch")
echo "$table"
failed=0
count=0
for script in "$scratch"/*.g; do
  count=$((count + 1))
  # What it finds it finds at once. A warning, of a hint that gappa cannot follow for one, is no proof either.
  if ! words=$(timeout 60 gappa "$script" 2>&1) || [ -n "$words" ]; then
    failed=$((failed + 1))
    echo "not proved:"
    cat "$script"
    head -n 5 <<<"$words"
  fi
done
echo "$((count - failed)) of $count propositions are proved"
# A row of the page may have several names, of which all but the first are their last words, and a number for
# each or one for all.
page=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../../docs/proofs.md
if ! diff <(tail -n +2 <<<"$table" | awk '{ printf "%s %d %.2f\n", $1, $2, $3 }' | sort) \
  <(sed -n '/^| filter | where |/,/^$/p' "$page" | awk -F '|' 'NR > 2 && NF > 4 {
      gsub(/[` ]/, "")
      sub(/:.*/, "", $2)
      names = split($2, name, ",")
      roundings = split($4, rounding, ",")
      margins = split($5, margin, ",")
      stem = name[1]
      sub(/_[^_]*$/, "", stem)
      for (i = 1; i <= names; ++i)
        print (i == 1 ? name[1] : stem name[i]), rounding[roundings == 1 ? 1 : i], margin[margins == 1 ? 1 : i]
    }' | sort); then
  failed=$((failed + 1))
  echo "docs/proofs.md says otherwise than the program (<)"
fi
# What is false must not be provable: nor must an error that is greater than its bound.
echo '{ |S| <= 1 /\ |s| <= 2 -> |S + s| <= 2 }' >"$scratch/false.g"
if gappa "$scratch/false.g" >/dev/null 2>&1; then
  echo "gappa proves what is false"
  failed=1
fi
rm "$scratch/false.g"
[ "$failed" -eq 0 ]
