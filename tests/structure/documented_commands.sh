#!/usr/bin/env bash
# The commands of the pages are typed as they stand, page by page, each page in a directory of its own
# beside examples/. In indented blocks
#
#   signum ...     must end well;
#   awk ...        the same: what pages prepare files with;
#   $ COMMAND      must print, on both streams, the lines that follow it up to the next $ or the end of
#                  the block; a line ... stands for any lines, ... at the end of one for its rest.
#
#   tests/structure/documented_commands.sh TOOL [PAGE...]     all pages of the project by default
#
# Exit code 1 where one of them does not. `signum study` takes minutes and has a test of its own.
set -uo pipefail
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tool=$(readlink -f "$1")
shift
pages=("$@")
[ ${#pages[@]} -gt 0 ] || pages=("$sources"/README.md "$sources"/docs/*.md "$sources"/docs/*/*.md "$sources"/examples/*.md)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin"
ln -s "$tool" "$scratch/bin/signum"
PATH=$scratch/bin:$PATH
commands=0
failures=0

fail() {
  failures=$((failures + 1))
  printf '%s: %s\n' "$page" "$1" >&2
}

# Compares what was printed with what the page shows, where ... stands for any rest.
agrees() {
  awk 'NR == FNR { shown[++m] = $0; next } { printed[++n] = $0 }
    function same(shown, printed,    length_shown) {
      length_shown = length(shown) - 3
      if (length_shown > 0 && substr(shown, length_shown + 1) == "...")
        return substr(shown, 1, length_shown) == substr(printed, 1, length_shown)
      return shown == printed
    }
    function match_from(i, j,    k) {
      if (i > m) return j > n
      if (shown[i] == "...") {
        for (k = j; k <= n + 1; ++k) if (match_from(i + 1, k)) return 1
        return 0
      }
      return j <= n && same(shown[i], printed[j]) && match_from(i + 1, j + 1)
    }
    END { exit !match_from(1, 1) }' "$1" "$2"
}

# Runs the command that was read with the lines shown below it.
settle() {
  [ -n "$command" ] || return 0
  commands=$((commands + 1))
  if $shows; then
    bash -c "$command" >printed.out 2>&1 </dev/null
    if ! agrees shown.txt printed.out; then
      fail "$command
prints
$(cat printed.out)
and the page shows
$(cat shown.txt)"
    fi
  else
    bash -c "set -o pipefail; $command" >printed.out 2>&1 </dev/null ||
      fail "$command
ends with exit code $?:
$(cat printed.out)"
  fi
  command=
}

for page in "${pages[@]}"; do
  directory=$(mktemp -d "$scratch/page.XXXXXX")
  cd "$directory"
  ln -s "$sources/examples" examples
  command=
  shows=false
  fenced=false
  while IFS= read -r line || [ -n "$line" ]; do
    case $line in
      '```'*)
        settle
        if $fenced; then fenced=false; else fenced=true; fi
        continue
        ;;
    esac
    $fenced && continue
    case $line in
      '    signum study'* | '    $ signum study'*) settle ;;
      '    signum '* | '    awk '*)
        settle
        shows=false
        command=${line#    }
        ;;
      '    $ '*)
        settle
        shows=true
        command=${line#    \$ }
        : >shown.txt
        ;;
      '    '*)
        if [ -n "$command" ] && $shows; then printf '%s\n' "${line#    }" >>shown.txt; else settle; fi
        ;;
      *) settle ;;
    esac
  done <"$page"
  settle
done

if [ ${#pages[@]} -gt 5 ] && [ "$commands" -lt 30 ]; then
  echo "found only $commands commands" >&2
  exit 1
fi
echo "$commands commands, $failures of them not as the pages say"
[ "$failures" -eq 0 ]
