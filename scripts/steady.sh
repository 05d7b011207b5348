#!/usr/bin/env bash
# Runs a command without random addresses, where the system allows it: a sanitizer needs its shadow where the kernel
# may have put something else.
#
#   scripts/steady.sh COMMAND [ARGUMENT...]
set -euo pipefail
steady=(setarch "$(uname -m)" -R)
"${steady[@]}" true 2>/dev/null || steady=()
exec "${steady[@]}" "$@"
