#!/usr/bin/env bash
# How the predicates of others fare under `signum torture`: a table in Markdown.
#
#   scripts/torture_peers.sh SIGNUM [SECONDS] [FOLDER]
#
# Those of the system's packages that are here (libgeos-dev, libboost-dev, libcgal-dev, libtet1.5-dev)
# and those of which FOLDER holds clones under their own names (CDT, poly2tri, delaunator-cpp,
# libigl-predicates). Nothing of them is kept.
set -euo pipefail
cd "$(dirname "$0")/.."
if [ $# -eq 0 ]; then
  sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
signum=$(realpath "$1")
[ -x "$signum" ] || { echo "$1 is no program" >&2; exit 2; }
[[ "${2:-60}" =~ ^[0-9]+$ ]] || { echo "'$2' is no number of seconds" >&2; exit 2; }
seconds=${2:-60}
clones=${3:-}
peers=tests/adoption/torture/peers
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
g++ -std=c++17 -O2 -fPIC -c single/signum_predicates.cpp -o "$scratch/predicates.o"

printf '| | function | ordinary numbers | points of the museum | where products over- or underflow | the simplest of the wrong answers |\n|---|---|--:|--:|--:|---|\n'
# row NAME LIBRARY OPTION...
row() {
  local name=$1 library=$2
  shift 2
  # Exit 1 is a verdict; a report is written with it, and never one of the peer before.
  rm -f "$scratch/report.json"
  "$signum" torture "$library" "$@" --sites tests/hard/museum/*.txt --seconds "$seconds" --quiet -o "$scratch/report.json" 2> "$scratch/messages" || [ $? = 1 ] || { cat "$scratch/messages" >&2; return; }
  python3 - "$name" "$scratch/report.json" << 'P'
import json, sys
name, path = sys.argv[1:]
for function, said in json.load(open(path))["functions"].items():
    if not said["found"]:
        continue
    def share(which):
        asked = sum(f["asked"] for n, f in said["families"].items() if which(n, f))
        wrong = sum(f["wrong"] for n, f in said["families"].items() if which(n, f))
        return f"{wrong} of {asked} wrong" if wrong else f"none of {asked}"
    smallest = said.get("smallest")
    example = "" if smallest is None else (
        f"`{' '.join(smallest['numbers'])}` is {smallest['right']}, not {smallest['said']}")
    lost = f", {len(said['lost'])} calls lost" if said["lost"] else ""
    print(f"| {name} | {function} | {share(lambda n, f: n != 'own' and not f['far'])}{lost} "
          f"| {share(lambda n, f: n == 'own')} | {share(lambda n, f: f['far'])} | {example} |")
P
}
# build NAME COMMAND...: false where it does not compile.
build() {
  "${@:2}" -O2 -fPIC -shared -o "$scratch/$1.so" 2> "$scratch/$1.txt"
}
version() {
  dpkg-query -W -f '${Version}' "$1" 2> /dev/null | sed 's/-.*//'
}
if build geos gcc "$peers/geos.c" -lgeos_c; then row "GEOS $(version libgeos-dev)" "$scratch/geos.so" --returns int; fi
if build boost g++ -w "$peers/boost_geometry.cpp"; then row "Boost.Geometry $(version libboost-dev)" "$scratch/boost.so" --returns int; fi
if build cgal g++ -std=c++17 -w "$peers/cgal.cpp" -lgmp -lmpfr; then row "CGAL $(version libcgal-dev)" "$scratch/cgal.so" --returns int; fi
tetgen=$(ldconfig -p | sed -n 's/.*libtet\.so .*=> //p' | head -1)
if [ -n "$tetgen" ]; then
  row "TetGen $(version libtet1.5-dev)" "$tetgen" --orient3d _Z8orient3dPdS_S_S_ --insphere _Z8inspherePdS_S_S_S_ --init _Z9exactinitiiiddd
fi
if [ -n "$clones" ]; then
  commit() {
    git -C "$clones/$1" log -1 --format=%h 2> /dev/null || echo "?"
  }
  if build cdt g++ -std=c++17 -I "$clones" "$peers/cdt.cpp"; then row "CDT $(commit CDT)" "$scratch/cdt.so"; fi
  if build poly2tri g++ -std=c++14 -I "$clones" -I "$clones/poly2tri" "$peers/poly2tri.cpp"; then row "poly2tri $(commit poly2tri)" "$scratch/poly2tri.so" --returns int; fi
  if build delaunator g++ -std=c++17 -I "$clones" -I single "$peers/delaunator.cpp" "$scratch/predicates.o"; then row "delaunator-cpp $(commit delaunator-cpp)" "$scratch/delaunator.so" --returns int; fi
  if build igl gcc -w "$clones/libigl-predicates/predicates.c" -lm; then row "libigl-predicates (Shewchuk) $(commit libigl-predicates)" "$scratch/igl.so"; fi
fi
