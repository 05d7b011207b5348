#!/usr/bin/env bash
# Every link of a page to a place of this project leads somewhere: the file is there, and where the link
# names a heading, so is the heading.
#
#   tests/structure/links.sh [PAGE...]     all pages by default
set -uo pipefail
sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$sources" || exit
pages=("$@")
[ ${#pages[@]} -gt 0 ] || pages=(*.md docs/*.md docs/*/*.md examples/*.md)
links=0
failures=0

# The headings of a page as links name them: small letters, blanks to hyphens, nothing else but
# letters, digits, hyphens and underscores.
headings() {
  awk '/^```/ { fenced = !fenced } !fenced && /^#+ / { sub(/^#+ /, ""); print tolower($0) }' "$1" |
    sed 's/`//g; s/[^[:alnum:] _-]//g; s/ /-/g'
}

for page in "${pages[@]}"; do
  folder=$(dirname "$page")
  while IFS= read -r link; do
    links=$((links + 1))
    path=${link%%#*}
    target=$page
    [ -n "$path" ] && target=$folder/$path
    if [ ! -e "$target" ]; then
      echo "$page: $link: there is no $target" >&2
      failures=$((failures + 1))
    elif [[ $link == *'#'* && $target == *.md ]] && ! headings "$target" | grep -qxF -- "${link#*#}"; then
      echo "$page: $link: no such heading" >&2
      failures=$((failures + 1))
    fi
  done < <(awk '/^```/ { fenced = !fenced } !fenced' "$page" | grep -oE '\]\([^)[:space:]]+\)|src="[^"]+"' |
    sed -E 's/^\]\(|\)$|^src="|"$//g' | grep -vE '^(https?|mailto):')
done
echo "$links links, $failures of them lead nowhere"
[ "$failures" -eq 0 ] && { [ $# -gt 0 ] || [ "$links" -gt 100 ]; }
