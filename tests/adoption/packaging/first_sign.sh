#!/usr/bin/env bash
# From an empty folder to a first exact sign: each script of examples/first_sign is ten lines at most, and prints the
# sign that rounding gets wrong.
set -euo pipefail
done_=()
for script in "$SOURCES"/examples/first_sign/*.sh; do
  name=$(basename "$script" .sh)
  [ "$(wc -l <"$script")" -le 10 ] || { echo "$name has more than ten lines"; exit 1; }
  environment=()
  case $name in
    c) [ -e "$PREFIX/include/signum/signum.h" ] || continue ;;
    python)
      [ -e "$BUILD/bindings/python/signum" ] || continue
      interpreter=$(sed -n 's/^\(_\?Python_EXECUTABLE\|SIGNUM_PYTHON\):[A-Z]*=\(.\+\)/\2/p' "$BUILD/CMakeCache.txt" | head -n 1)
      environment=(PYTHONPATH="$BUILD/bindings/python" PYTHON="${interpreter:-python3}") ;;
  esac
  folder=$(mktemp -d)
  sign=$(cd "$folder" && env "${environment[@]}" "$script" 2>"$folder/errors") || { cat "$folder/errors"; echo "$name failed"; exit 1; }
  rm -rf "$folder"
  [ "$sign" = -1 ] || { echo "$name says $sign instead of -1"; exit 1; }
  done_+=("$name")
done
[ ${#done_[@]} -ge 2 ]
echo "${done_[*]}"
