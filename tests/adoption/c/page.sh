#!/usr/bin/env bash
# The C of docs/c.md is programs: every ```c block compiles without a warning as C99, links, runs, and
# prints what its comments say: what stands behind the word "prints", commas apart, are the lines.
#
#   page.sh C_COMPILER BUILD_DIRECTORY LINKER_AND_FLAGS LIBRARY...
set -euo pipefail
compiler=$1 build=$2
shift 2
page=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/../../../docs/c.md
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# What is wrong with a program; nothing when nothing is.
complaint() {
  "$compiler" -std=c99 -Wall -Wextra -Wpedantic -Werror "-I$build/include" -c "$1" -o "$scratch/example.o" 2>&1 ||
    { echo "does not compile"; return; }
  "${linker[@]}" "$scratch/example.o" "${libraries[@]}" -o "$scratch/example" 2>&1 || { echo "does not link"; return; }
  "$scratch/example" >"$scratch/printed" || { echo "ends with $?"; return; }
  { grep -oE '//.*prints .*' "$1" || true; } | sed -E 's/.*prints //; s/, /\n/g' >"$scratch/promised"
  diff "$scratch/promised" "$scratch/printed" || true
}
read -ra linker <<<"$1"
shift
libraries=("$@" -pthread -lm "-Wl,-rpath,$(dirname "$1")")

awk -v into="$scratch/block" '/^```c$/ {file = into (++n) ".c"; next} /^```/ {file = ""} file {print > file}' "$page"
count=0
for block in "$scratch"/block*.c; do
  wrong=$(complaint "$block")
  [ -z "$wrong" ] || { printf 'docs/c.md: an example\n%s\nIt is\n' "$wrong" >&2; cat "$block" >&2; exit 1; }
  count=$((count + 1))
done

# The test of the test: what does not compile, what fails, and what prints something else.
for wrong in 'int main(void) { return nothing; }' 'int main(void) { return 1; }' 'int main(void) { return 0; } // prints 2'; do
  echo "$wrong" >"$scratch/wrong.c"
  [ -n "$(complaint "$scratch/wrong.c")" ] || { echo "should have been found out: $wrong" >&2; exit 1; }
done
echo "$count examples compile, and print what they promise"
