#!/usr/bin/env bash
# The gas and the shaker beside LAMMPS (soft grains), the pile beside Box2D: time for the same simulated seconds, what becomes
# of the energy, and how deep grains lie in one another. All start from the very same balls.
#
#   motion_peers.sh [ROUNDS] > table.md      Debian: lammps, libbox2d-dev
#
# One core, in turn, medians of ROUNDS (3).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
rounds=${1:-3}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$root/scripts/build.sh" "$root/build/run" signum_tool -DSIGNUM_BUILD_TESTS=OFF
signum=$root/build/run/cli/signum
command -v lmp >/dev/null || { echo "motion_peers.sh: LAMMPS is missing (Debian: lammps)" >&2; exit 3; }
c++ -O2 -std=c++20 -o "$scratch/box2d" "$here/box2d_pile.cpp" -lbox2d
cd "$scratch"
export OMP_NUM_THREADS=1
core=$(($(nproc) - 1))
one_core() { taskset -c "$core" "$@"; }

# SCENE: its balls at the start, as LAMMPS reads atoms of style sphere: number, type, diameter, density, place; then velocities. In
# its two dimensions masses are those of discs: density 1/pi makes them r^2, those of the scenes.
atoms() {
  "$signum" simulate "$root/examples/scenes/$1.toml" --quiet --set run.until=0 --set 'record.every=1' -o start.xyz >/dev/null
  awk -v wall="$2" '
    NR == 1 { n = $1 }
    NR == 2 { match($0, /Lattice="[^"]*"/); split(substr($0, RSTART + 9, RLENGTH - 10), box, " ") }
    NR > 2 { x[++k] = $2; y[k] = $3; u[k] = $5; v[k] = $6; r[k] = $8 }
    END {
      print "balls\n\n" n " atoms\n1 atom types\n"
      printf "%.17g %.17g xlo xhi\n%.17g %.17g ylo yhi\n-1 1 zlo zhi\n\nAtoms\n\n", -wall, box[1] + wall, -wall, box[5] + wall
      for (i = 1; i <= n; ++i) printf "%d 1 %.17g %.17g %.17g %.17g 0\n", i, 2 * r[i], 1 / 3.14159265358979324, x[i], y[i]
      print "\nVelocities\n"
      for (i = 1; i <= n; ++i) printf "%d %.17g %.17g 0 0 0 0\n", i, u[i], v[i]
    }' start.xyz >"$1.data"
}
median() { sort -g | awk '{ a[NR] = $1 } END { print a[int((NR + 1) / 2)] }'; }
energy() { awk -F, 'NR == 2 { first = $NF } { last = $NF } END { printf "%.4f", last / first }' "$1"; }

echo "| scene | by | seconds a simulated second | / signum | energy, end / start | deepest overlap, radii | strikes |"
echo "|:--|:--|--:|--:|--:|--:|--:|"

# NAME SECONDS STEPS...: the scene, by signum and by LAMMPS at some time steps.
beside_lammps() {
  local name=$1 seconds=$2 wall=$3
  shift 3
  atoms "$name" "$wall"
  : >ours
  local -A theirs=()
  for ((round = 0; round < rounds; ++round)); do
    one_core "$signum" simulate "$root/examples/scenes/$name.toml" --quiet --until "$seconds" --every "$seconds" \
      --set 'record.energies="energies.csv"' -o log.csv --stats >stats.json
    sed -n 's/.*"seconds": \([0-9.e-]*\).*/\1/p' stats.json >>ours
    for step in "$@"; do
      one_core lmp -in "$here/lammps_$name.in" -var data "$name.data" -var step "$step" -var seconds "$seconds" \
        -log "lammps_$step.log" -screen none
      awk '/^Loop time of/ { all += $4 } END { print all }' "lammps_$step.log" >>"theirs_$step"
    done
  done
  local own strikes
  own=$(median <ours)
  strikes=$(sed -n 's/.*"strikes": \([0-9]*\).*/\1/p' stats.json)
  awk -v t="$own" -v s="$seconds" -v name="$name" -v e="$(energy energies.csv)" -v k="$strikes" \
    'BEGIN { printf "| %s | signum | %.3g | 1.00 | %s | 0 | %d |\n", name, t / s, e, k }'
  for step in "$@"; do
    awk -v t="$(median <"theirs_$step")" -v own="$own" -v s="$seconds" -v name="$name" -v step="$step" \
      -v e="$(awk '/^Step/ { on = 1; next } /^Loop/ { on = 0 } on { if (!n++) a = $2; b = $2 } END { printf "%.4f", b / a }' "lammps_$step.log")" \
      -v deep="$(awk '/^Step/ { on = /v_overlap/; next } /^Loop/ { on = 0 } on { if ($3 > d) d = $3 } END { if (d) printf "%.2g", d }' "lammps_$step.log")" \
      'BEGIN { printf "| %s | LAMMPS, steps of %s | %.3g | %.1f | %s | %s | |\n", name, step, t / s, t / own, e, deep }'
  done
  rm -f theirs_*
}
beside_lammps gas 5 0 0.0002 0.0005
beside_lammps shaker 10 15 0.0001 0.0002

# The pile: time to the end, speed and overlap then.
: >ours
: >theirs
"$signum" simulate "$root/examples/scenes/sand.toml" --quiet --set run.until=0 --set 'record.every=1' -o start.xyz >/dev/null
for ((round = 0; round < rounds; ++round)); do
  one_core "$signum" simulate "$root/examples/scenes/sand.toml" --quiet --every 20 --set 'record.energies="energies.csv"' -o end.xyz \
    --stats >stats.json
  sed -n 's/.*"seconds": \([0-9.e-]*\).*/\1/p' stats.json >>ours
  one_core ./box2d start.xyz 20 >box2d.txt
  awk '{ print $1 }' box2d.txt >>theirs
done
./box2d end.xyz 0 >judged.txt
own=$(median <ours)
awk -v t="$own" -v e="$(awk -F, 'END { print $2 }' energies.csv)" -v d="$(awk '{ print $3 }' judged.txt)" \
  'BEGIN { printf "\n| pile | by | seconds a simulated second | / signum | kinetic energy at the end | deepest overlap then, radii |\n|:--|:--|--:|--:|--:|--:|\n| sand | signum | %.3g | 1.00 | %.2g | %s |\n", t / 20, e, d }'
awk -v t="$(median <theirs)" -v own="$own" -v e="$(awk '{ print $2 }' box2d.txt)" -v d="$(awk '{ print $3 }' box2d.txt)" \
  'BEGIN { printf "| sand | Box2D, steps of 1/60 | %.3g | %.2f | %.2g | %s |\n", t / 20, t / own, e, d }'
