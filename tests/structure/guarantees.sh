#!/usr/bin/env bash
# Every test that docs/guarantees.md names is there.
#
#   guarantees.sh BUILD_DIRECTORY
set -euo pipefail
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
page=$tests/../docs/guarantees.md
known=$(ctest --test-dir "$1" --show-only=human)

missing=0
named=0
file=
fail() {
  echo "docs/guarantees.md names $1" >&2
  missing=$((missing + 1))
}
# A word in backticks is a file, a case in the file before it, or a test of CTest.
while read -r word; do
  case $word in
    unit/* | property/* | oracle/* | slow/*)
      file=$tests/$word.cpp
      [ -f "$file" ] || fail "$word, and there is no such file"
      ;;
    structure.* | adoption.* | fuzz.* | make_*)
      named=$((named + 1))
      grep -q ": $word\$" <<<"$known" || fail "$word, which CTest does not know"
      ;;
    scripts/* | tests/*)
      [ -e "$tests/../$word" ] || fail "$word, and it is not there"
      ;;
    signum.h | */) ;;
    [A-Z]*.[A-Z]*)
      named=$((named + 1))
      grep -qE "^(TYPED_)?TEST(_[A-Z]+)?\(${word%.*}, ${word#*.}\)" "$file" || fail "$word, which is not in ${file#"$tests"/}"
      ;;
    *[./]*)
      fail "$word, and nobody knows what that is"
      ;;
  esac
done < <(grep '^| ' "$page" | grep -o '`[^`]*`' | tr -d '`')

if [ "$named" -lt 50 ]; then
  echo "only $named tests were found in docs/guarantees.md" >&2
  exit 1
fi
[ "$missing" -eq 0 ]
