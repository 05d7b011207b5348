#!/usr/bin/env bash
# The manual page and the completions are what the tool's --help says now; bash completes by them, and neither man nor
# zsh, where it is installed, finds anything wrong.
#
#   manual.sh PYTHON TOOL
set -euo pipefail
"$1" "$SOURCES/packaging/manual.py" "$2" --check

# A help that says more is found out.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
printf '#!/bin/sh\n"%s" "$@" | sed "s/^  --quiet  /  --silent /"\n' "$2" >"$scratch/signum"
chmod +x "$scratch/signum"
if "$1" "$SOURCES/packaging/manual.py" "$scratch/signum" --check 2>/dev/null; then
  echo "another --help should have been found out"
  exit 1
fi

# WORD...: what the last of them may become.
complete_() {
  COMP_WORDS=("$@")
  COMP_CWORD=$(($# - 1))
  _signum
  echo "${COMPREPLY[*]}"
}
. "$SOURCES/packaging/completions/signum.bash"
expect() { [ "$1" = "$2" ] || { echo "completes '$1' instead of '$2'"; exit 1; }; }
expect "$(complete_ signum tri)" triangulate
expect "$(complete_ signum triangulate sites.txt --me)" "--metric --method --memory"
expect "$(complete_ signum triangulate --metric s)" supremum
expect "$(complete_ signum sign in_)" "in_circle in_sphere"
expect "$(complete_ signum simulate --wall)" --wall-restitution
for command in $("$2" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'); do
  for option in $("$2" "$command" --help | sed -n 's/^  \(-[a-z],\)\{0,1\}\(--[a-z0-9-]*\).*/\2/p'); do
    expect "$(complete_ signum "$command" "$option" | tr ' ' '\n' | grep -x -e "$option")" "$option"
    grep -q -e "'\*$option\[" "$SOURCES/packaging/completions/_signum" || { echo "zsh: $option"; exit 1; }
    grep -q -F -e "${option//-/\\-}" "$SOURCES/packaging/signum.1" || { echo "signum.1: $option"; exit 1; }
  done
done

if command -v groff >/dev/null; then
  warnings=$(groff -man -Tutf8 -ww "$SOURCES/packaging/signum.1" 2>&1 >/dev/null)
  [ -z "$warnings" ] || { echo "$warnings"; exit 1; }
fi
if command -v zsh >/dev/null; then
  zsh -n "$SOURCES/packaging/completions/_signum"
fi
