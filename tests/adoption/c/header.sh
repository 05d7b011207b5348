#!/usr/bin/env bash
# signum.h stands alone in C99 and in C++, and the programs here call every function that it declares.
#
#   header.sh C_COMPILER C++_COMPILER
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
header=$here/../../../bindings/c/signum.h

"$1" -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c "$header"
"$2" -std=c++98 -Wall -Wextra -Wpedantic -Wno-long-long -Wno-variadic-macros -Werror -fsyntax-only -x c++ "$header"
"$2" -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -x c++ "$header"

# The names that are declared, and of them those that a text does not call.
names() { sed -E 's@//.*@@' "$1" | grep -oE '\bsignum_[a-z_]+\(' | sort -u; }
declared=$(names "$header")
called=$(cat "$here"/*.c | grep -oE '\bsignum_[a-z_]+\(' | sort -u)
[ "$(wc -l <<<"$declared")" -ge 60 ] || { echo "only $(wc -l <<<"$declared") functions were found in signum.h" >&2; exit 1; }
uncalled=$(comm -23 <(echo "$declared") <(echo "$called"))
[ -z "$uncalled" ] || { printf 'signum.h declares, and no program here calls:\n%s\n' "$uncalled" >&2; exit 1; }
# The test of the test: a function more would have been found out.
[ -n "$(comm -23 <(printf '%s\nsignum_zzz(\n' "$declared" | sort -u) <(echo "$called"))" ]
