#!/usr/bin/env bash
# signum torture: it finds planted faults, and none where there is none.
#
# usage: torture.sh SIGNUM SECONDS FAULT...
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
single=$(cd "$here/../../../single" && pwd)
signum=$1
seconds=$2
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
fail() {
  echo "$*" >&2
  exit 1
}
# The exit code of a trial, whose report is report.json and whose page is report.html.
trial() {
  code=0
  "$signum" torture "$@" --quiet -o report.json -o report.html 2> messages || code=$?
}
says() {
  python3 -c "import json, sys; r = json.load(open('report.json')); sys.exit(not ($1))" \
    || fail "$1 does not hold: $(cat report.json)"
}

g++ -std=c++17 -O2 -fPIC -c "$single/signum_predicates.cpp" -o predicates.o
plugin() {
  g++ -std=c++17 -O2 -fPIC -shared -DFAULT="$1" -I "$single" "$here/faulty.cpp" predicates.o -o "fault$1.so"
}

plugin -1
trial ./fault-1.so --seconds "$seconds"
[ $code = 0 ] || fail "without a fault: exit $code, $(cat report.json messages)"
says "r['faultless'] and all(f['asked'] > 1000 for f in r['functions'].values())"
cp report.html faultless.html

names=(orient2d incircle orient3d insphere)
for fault in "$@"; do
  plugin "$fault"
  trial "fault$fault.so" --seconds "$seconds"
  [ $code = 1 ] || fail "fault $fault is not found: exit $code"
  # Of that function alone, with an example that the library itself answers otherwise.
  says "all((f['wrong'] > 0) == (name == '${names[fault / 8]}') for name, f in r['functions'].items())"
  grep -q 'The simplest of the wrong answers' report.html || fail "no example on the page"
  name=${names[fault / 8]}
  read -r right numbers < <(python3 -c "
import json
smallest = json.load(open('report.json'))['functions']['$name']['smallest']
print(smallest['right'], *smallest['numbers'])")
  # shellcheck disable=SC2086
  [ "$("$signum" sign "$name" -- $numbers 2> /dev/null | cut -d ' ' -f 1)" = "$right" ] \
    || fail "fault $fault: its example is answered otherwise by signum sign: $right, $numbers"
done

# What it cannot be blamed for: crashes, endless loops, changed rounding modes, the rest goes on.
gcc -O1 -fPIC -shared "$here/broken.c" -o broken.so -lm
trial broken.so --seconds 8
[ $code = 1 ] || fail "broken: exit $code"
says "r['functions']['incircle']['found'] is False"
says "any(c['signal'] != 0 for c in r['functions']['orient2d']['lost'])"
says "any(c['signal'] == 0 for c in r['functions']['orient3d']['lost'])"
says "r['functions']['orient2d']['wrong'] > 0"
# A magnitude is no orientation, whatever is found out about signs.
printf '#include <signum_predicates.hpp>\n
extern "C" double orient2d(const double* a, const double* b, const double* c) {\n
  return signum::ccw(a, b, c) == 0 ? 0 : 1; }\n' > magnitude.cpp
g++ -std=c++17 -O2 -fPIC -shared -I "$single" magnitude.cpp predicates.o -o magnitude.so
trial magnitude.so --seconds 1
[ $code = 1 ] || fail "magnitude: exit $code, $(cat report.json)"

# Other names, other signs, other languages.
printf 'extern "C" double turn(const double* a, const double* b, const double* c);\n
extern "C" int in(const double*, const double*, const double*, const double*);\n
#include <signum_predicates.hpp>\n
double turn(const double* a, const double* b, const double* c) { return -signum::ccw(a, b, c); }\n
int in(const double* a, const double* b, const double* c, const double* d) {\n
  return signum::in_circle(a, b, c, d); }\n' > other.cpp
g++ -std=c++17 -O2 -fPIC -shared -I "$single" other.cpp predicates.o -o other.so
trial other.so --orient2d turn --seconds 1
[ $code = 0 ] || fail "other: exit $code, $(cat report.json)"
says "r['functions']['orient2d']['convention'] == 'Shewchuk\\'s with the opposite sign'"
trial other.so --incircle in --returns int --seconds 1
[ $code = 0 ] || fail "other: exit $code, $(cat report.json)"
says "r['functions']['incircle']['convention'].startswith('positive inside')"
if command -v gfortran > /dev/null; then
  gfortran -O2 -fPIC -shared "$here/naive.f90" -o naive.so
  trial naive.so --orient2d turn --returns int --seconds 2
  [ $code = 1 ] || fail "naive Fortran: exit $code"
  says "r['functions']['orient2d']['families']['neighbourhood']['wrong'] > 0"
fi

# Somebody's own points: wrong for one of them alone, which no family has.
printf '#include <signum_predicates.hpp>\n
extern "C" double orient2d(const double* a, const double* b, const double* c) {\n
  return signum::ccw(a, b, c) * (a[0] == 1.3717421248 ? -1 : 1); }\n' > one.cpp
g++ -std=c++17 -O2 -fPIC -shared -I "$single" one.cpp predicates.o -o one.so
trial one.so --seconds 1
[ $code = 0 ] || fail "one: exit $code, $(cat report.json)"
printf '0 0\n1.3717421248 0.125\n0.25 1\n' > mine.txt
printf 'x y z\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n' > solid.txt
trial one.so --seconds 1 --sites mine.txt --sites solid.txt
[ $code = 1 ] || fail "one with its points: exit $code"
says "[n for n, f in r['functions']['orient2d']['families'].items() if f['wrong'] > 0] == ['own']"
plugin -1
trial ./fault-1.so --seconds 1 --sites mine.txt solid.txt
[ $code = 0 ] || fail "own points without a fault: exit $code, $(cat report.json)"
says "all(f['families']['own']['asked'] > 0 for f in r['functions'].values())"

# A wrong call says what would be right.
refuse() {
  trial "${@:2}"
  [ $code = 2 ] || fail "${*:2}: exit $code"
  grep -q "$1" messages || fail "${*:2}: $(cat messages)"
}
refuse 'is no shared library' other.cpp
refuse 'none of the C functions' other.so
refuse 'has no function' other.so --orient2d nothing
