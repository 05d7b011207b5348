#!/usr/bin/env bash
# The reference of the public headers, by Doxygen: those that cmake/Install.cmake installs for users.
#
#   scripts/reference.sh [DIRECTORY]     build/reference by default; open DIRECTORY/html/index.html
#
# Exit code 1 where Doxygen warns: a public name without a comment, a reference to what is not there.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
place=${1:-$root/build/reference}
command -v doxygen >/dev/null || { echo "signum: this needs doxygen (apt-get install doxygen)" >&2; exit 3; }

# Users' headers, and those behind them that hold names of theirs.
mapfile -t headers < <(sed -n '/^set(public_headers/,/)/p; /^set(headers_behind/,/)/p' "$root/cmake/Install.cmake" |
  sed 's/set([a-z_]*//; s/)//' | tr -s ' \n' '\n' | grep -E '\.hpp$|\.h$' |
  grep -vE '^(filters|core/contract|core/handle|motion/meeting.hpp|predicates/(additive|power/|euclidean/|rectangular/|formulas/|ladder/)|triangulation/structure)')
[ ${#headers[@]} -gt 30 ] || { echo "signum: found only ${#headers[@]} headers in cmake/Install.cmake" >&2; exit 1; }
rm -rf "$place"
mkdir -p "$place"
cd "$root"
version=$(sed -n 's/^project(signum VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
# What stands in front of a comment of ours is what it says of others; comparisons by == say themselves.
doxygen - >"$place/log" 2>&1 <<DOXYFILE
PROJECT_NAME = signum
PROJECT_NUMBER = $version
PROJECT_BRIEF = "Exact signs, and the tessellations built on them"
OUTPUT_DIRECTORY = "$place"
INPUT = docs/reference.md ${headers[*]}
USE_MDFILE_AS_MAINPAGE = docs/reference.md
STRIP_FROM_PATH = .
FULL_PATH_NAMES = YES
JAVADOC_AUTOBRIEF = YES
MARKDOWN_SUPPORT = YES
EXCLUDE_SYMBOLS = *::cold *::additive *::balls operator== signum::predicates signum::filters signum::triangulation \
  signum::centre3 *lifted_row signum::power::InSphere signum::power::Nearer3
EXTRACT_ALL = NO
HIDE_UNDOC_MEMBERS = NO
SORT_MEMBER_DOCS = NO
GENERATE_LATEX = NO
GENERATE_TREEVIEW = YES
HAVE_DOT = NO
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = SIGNUM_IEEE_BEGIN= SIGNUM_IEEE_END= SIGNUM_API=
QUIET = YES
WARN_IF_UNDOCUMENTED = YES
WARN_AS_ERROR = NO
DOXYFILE
warnings=$(grep -c 'warning:\|error:' "$place/log" || true)
if [ "$warnings" -gt 0 ]; then
  sed "s#$root/##" "$place/log" >&2
  echo "signum: $warnings warnings" >&2
  exit 1
fi
[ -s "$place/html/index.html" ]
