#!/usr/bin/env bash
# The two files of single/ as users compile them: no flag of ours, every compiler that is here.
#
# usage: single.sh SINGLE_CALLS CALLS
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
single="$root/single"
calls=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
fail() {
  echo "$*" >&2
  exit 1
}

lines=$(cat "$single"/signum_predicates.?pp | wc -l)
[ "$lines" -le 5000 ] || fail "the two files have $lines lines, more than 5000"
grep -hE '^#include <' "$single"/signum_predicates.?pp | sort -u > includes
grep -qE 'boost|gmp|mpfr|signum/' includes && fail "the two files need a library: $(cat includes)"

libraries=()
for compiler in g++ clang++; do
  command -v $compiler > /dev/null || continue
  # Warnings that come with -Wall and -Wextra are ours to mend.
  number=0
  all_flags=("" "-O2 -Wall -Wextra -Werror" "-O3 -march=native -ffp-contract=fast")
  # Clang does not tell that it may reassociate; g++ does, and is refused.
  [ $compiler = clang++ ] && all_flags+=("-O2 -funsafe-math-optimizations")
  for flags in "${all_flags[@]}"; do
    library="$scratch/$compiler-$((number += 1)).so"
    # shellcheck disable=SC2086
    $compiler -std=c++17 $flags -shared -fPIC "$single/signum_predicates.cpp" -o "$library" \
      || fail "$compiler $flags does not compile"
    libraries+=("$library")
  done
  for refused in -Ofast -ffast-math; do
    $compiler -std=c++17 $refused -c "$single/signum_predicates.cpp" -o refused.o 2> refused.txt \
      && fail "$compiler $refused compiles"
    grep -q 'signum needs IEEE arithmetic' refused.txt || fail "$compiler $refused: $(cat refused.txt)"
  done
  $compiler -std=c++17 -O2 -I "$single" "$here/points.cpp" "$single/signum_predicates.cpp" -o points
  ./points
done
[ ${#libraries[@]} -gt 0 ] || fail "no compiler"

# 32 bits with SSE2, where the compiler has libraries for them; the processor's old unit is refused.
echo 'int main() {}' > nothing.cpp
if g++ -m32 nothing.cpp -o nothing 2> /dev/null; then
  g++ -std=c++17 -m32 -msse2 -mfpmath=sse -O2 -I "$single" "$here/points.cpp" \
    "$single/signum_predicates.cpp" -o points32
  if ./nothing 2> /dev/null; then ./points32; fi
  g++ -std=c++17 -m32 -c "$single/signum_predicates.cpp" -o refused.o 2> refused.txt && fail "x87 compiles"
  grep -q 'signum needs SSE2' refused.txt || fail "x87: $(cat refused.txt)"
fi
if command -v x86_64-w64-mingw32-g++ > /dev/null; then
  x86_64-w64-mingw32-g++ -std=c++17 -O2 -static -I "$single" "$here/points.cpp" \
    "$single/signum_predicates.cpp" -o points.exe
  # Debian keeps it out of the path.
  wine=$(command -v wine64 || ls /usr/lib/wine/wine64 2> /dev/null || true)
  if [ -n "$wine" ]; then
    WINEPREFIX="$scratch/wine" WINEDEBUG=-all "$wine" points.exe 2> wine.txt || fail "under wine: $(cat wine.txt)"
  fi
fi

g++ -std=c++17 -O2 -c "$single/signum_predicates.cpp" -o predicates.o
if [ "$(uname -m)" = x86_64 ]; then
  size=$(size predicates.o | awk 'NR == 2 { print $1 + $2 }')
  [ "$size" -le $((120 * 1024)) ] || fail "the predicates have $size bytes, more than 120 KiB"
fi
gcc -std=c99 -Wall -Wextra -Werror -x c -I "$single" -c "$here/names.c" -o names.o
gcc names.o predicates.o -lstdc++ -o names
[ "$(./names)" = "0 1 1 -2
0 1
0 1" ] || fail "from C: $(./names)"
if command -v gfortran > /dev/null; then
  gfortran "$here/names.f90" predicates.o -lstdc++ -o fortran
  [ "$(./fortran)" = "0 1" ] || fail "from Fortran: $(./fortran)"
fi
if command -v rustc > /dev/null; then
  rustc "$here/names.rs" -C link-args="predicates.o -lstdc++" -o rust
  [ "$(./rust)" = "0 1" ] || fail "from Rust: $(./rust)"
fi

# The program of the page, by the line of the page: it prints what its comments say.
page="$root/docs/backend.md"
mkdir page
awk '/^```c\+\+$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$page" > page/mine.cpp
sed -n 's/.*\/\/ prints //p' page/mine.cpp > page/expected
line=$(grep -E '^    g\+\+ .*signum_predicates.cpp$' "$page")
(cd page && cp "$single"/signum_predicates.?pp . && $line && ./a.out > said && diff expected said) \
  || fail "the program of docs/backend.md does not print what it says"

# What cannot be right does not compile, and says why.
refuse() {
  printf '#include <signum_predicates.hpp>\n#include <array>\nstruct Mine { int a; };\nint main() { %s }\n' "$1" > bad.cpp
  g++ -std=c++17 -I "$single" -c bad.cpp -o bad.o 2> bad.txt && fail "compiles: $1"
  grep -q "$2" bad.txt || fail "$1: $(cat bad.txt)"
}
refuse 'std::array<long, 2> p{}; return signum::ccw(p, p, p);' 'integers of 64 bits may be no doubles'
refuse 'std::array<long double, 2> p{}; return signum::ccw(p, p, p);' 'a long double would be rounded'
refuse 'std::array<__float128, 2> p{}; return signum::ccw(p, p, p);' 'signum: a'
refuse 'Mine p{}; return signum::ccw(p, p, p);' 'a point needs members x and y'
refuse 'signum::Point p{}; return signum::Euclidean::hidden(p, p);' 'a site needs a member r'

"$calls" "$2" 1 "${libraries[@]}"
