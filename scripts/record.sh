#!/usr/bin/env bash
# The record of predicate calls (docs/record.md): builds the program and asks blocks of a million
# calls, each judged by an oracle, until it is stopped; what is done stands in FILE, and the same
# command goes on from there.
#
#   scripts/record.sh FILE [--metric NAME]... [--from BLOCK] [--step BLOCKS] [--blocks N]
#   scripts/record.sh summary FILE...
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -eq 0 ]; then
  sed -n '2,7s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
scripts/build.sh "$PWD/build/record" record --preset=release -DSIGNUM_TEST_LABELS=unit
record=build/record/fuzz/record/record
if [ "$1" = summary ]; then
  exec "$record" "$@"
fi
commit=$(git describe --always --dirty 2>/dev/null || echo unknown)
exec "$record" run "$@" --library "$commit"
