#!/bin/sh
# TetGen of Debian's sources, built with its own predicates and with libsignum_classic in their place: both on the
# same inputs, whether their output is the same, and how long they take. Needs a network, and Debian's keys.
#
#     scripts/drop_in.sh        # the libraries are built in build/drop-in/signum, static
#
# Exit code 1 where the two do not agree, or either of them builds nothing.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
"$root/scripts/build.sh" "$root/build/drop-in/signum" signum_classic -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
    -DSIGNUM_BUILD_TOOL=OFF -DSIGNUM_BUILD_TESTS=OFF
build=$root/build/drop-in/signum
mkdir -p build/drop-in/lists/partial
cd build/drop-in

# A list of sources of its own, from where the system has its packages: nothing is written where it keeps its own.
if [ ! -d tetgen ]; then
    . /etc/os-release
    apt-get indextargets --format '$(CREATED_BY) $(CODENAME) $(COMPONENT) $(REPO_URI)' |
        sed -n "s#^Packages $VERSION_CODENAME main \(.*\)#deb-src \1 $VERSION_CODENAME main#p" | sort -u > sources.list
    apt="-o Dir::Etc::sourcelist=$PWD/sources.list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$PWD/lists -o Dir::Cache=$PWD"
    # shellcheck disable=SC2086
    apt-get $apt -q update > apt.log
    # shellcheck disable=SC2086
    apt-get $apt -q source --download-only tetgen=1.5.0-5 >> apt.log 2>&1
    dpkg-source -x tetgen_*.dsc tetgen >> apt.log 2>&1
fi

compiled() { [ -f "$1" ] || g++ -w "$3" -DTETLIBRARY -c "$2" -o "$1"; }
compiled tetgen.o tetgen/tetgen.cxx -O1
compiled main.o tetgen/tetgen_main.cxx -O1
# As TetGen's makefile has it, for its predicates do not bear optimization by every compiler.
compiled predicates.o tetgen/predicates.cxx -O0
g++ -o own main.o tetgen.o predicates.o
g++ -o ours main.o tetgen.o "$build/bindings/classic/libsignum_classic.a" "$build/libsignum.a" -lmpfr -lgmp -lpthread

python3 - <<'PYTHON'
import math, random
random.seed(1)
def write(name, points, weights=None):
    with open(name + ".node", "w") as file:
        file.write(f"{len(points)} 3 {1 if weights else 0} 0\n")
        for n, p in enumerate(points):
            weight = f" {weights[n]!r}" if weights else ""
            file.write(f"{n} {p[0]!r} {p[1]!r} {p[2]!r}{weight}\n")
def uniform(count):
    return [[random.random() for _ in range(3)] for _ in range(count)]
write("random", uniform(50000))
write("grid", [[x, y, z] for x in range(25) for y in range(25) for z in range(25)])
write("grid-of-tenths", [[x / 10, y / 10, z / 10] for x in range(25) for y in range(25) for z in range(25)])
sphere = []
while len(sphere) < 3000:
    p = [random.gauss(0, 1) for _ in range(3)]
    r = math.sqrt(sum(x * x for x in p))
    sphere.append([x / r for x in p])
write("sphere", sphere)
write("weighted", uniform(20000), [random.random() * 1e-3 for _ in range(20000)])
PYTHON
cp tetgen/example.poly .

# Name of the input, switches, file.
failed=0
compare() {
    for program in own ours; do
        rm -rf "$program.d"
        mkdir "$program.d"
        cp "$3" "$program.d/"
        status=ok
        (cd "$program.d" && /usr/bin/time -f %U -o time timeout 300 "../$program" "-$2Q" "$3" > log 2>&1) || status="fails"
        echo "$status" > "$program.status"
    done
    same=same
    for program in own ours; do
        [ "$(cat "$program.status")" = ok ] && [ -n "$(find "$program.d" -name '*.ele')" ] || same="nothing built"
    done
    for file in own.d/*.ele own.d/*.node own.d/*.face; do
        grep -v '^#' "$file" > own.text 2> /dev/null || true
        grep -v '^#' "ours.d/${file#own.d/}" > ours.text 2> /dev/null || true
        cmp -s own.text ours.text || same=different
    done
    [ "$same" = same ] || failed=1
    elements=$(cat own.d/*.ele 2> /dev/null | head -1 | cut -d' ' -f1)
    echo "| $1 | \`-$2\` | ${elements:--} | $(cat own.status), $(tail -1 own.d/time) s | $(cat ours.status), $(tail -1 ours.d/time) s | $same |"
}
echo "| input | switches | tetrahedra | its own predicates | signum's | output |"
echo "| --- | --- | --- | --- | --- | --- |"
compare "its example" p example.poly
compare "its example, refined" pq1.414a0.1 example.poly
compare "50 000 random points" "" random.node
compare "25³ grid" "" grid.node
compare "25³ grid of tenths" "" grid-of-tenths.node
compare "3000 points on a sphere, rounded" "" sphere.node
compare "20 000 weighted points" w weighted.node
exit $failed
