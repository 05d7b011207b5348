#!/usr/bin/env bash
# clang++ takes the sources of the library and of the tools, too.
#
#   clang.sh BUILD                              exit code 77 where there is no clang++
set -euo pipefail
command -v clang++ >/dev/null || exit 77
sed -nE 's/^ *"command": "(.*)",?$/\1/p' "$1/compile_commands.json" |
  grep -vE '/(tests|fuzz|benchmarks|examples|bindings)/[^ ]*$' |
  sed -E 's/\\"/"/g; s/\\\\/\\/g; s/^([^ ]*ccache )?[^ ]+ //; s/ -[fW][^ ]+//g; s/ -o [^ ]+//' | sort -u |
  while read -r arguments; do printf 'clang++ -fsyntax-only -w %s\0' "$arguments"; done |
  xargs -0 -P "$(nproc)" -I{} bash -c '{}'
