#!/usr/bin/env bash
# signum-mpi on 1 to 7 ranks: the bytes are those of signum where that writes the same, and equal for
# every number of ranks; what is wrong is said once, with rank and place, and leaves no file.
#
#   ranks.sh SIGNUM SIGNUM_MPI PYTHON EXAMPLE
set -euo pipefail
signum=$1
signum_mpi=$2
python=$3
example=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
failures=0

fail() {
  printf 'FAILED: %s\n' "$*"
  failures=$((failures + 1))
}
# More ranks than cores, as root in a container, and on a machine without a network.
on_ranks() {
  local count=$1
  shift
  OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 OMPI_ALLOW_RUN_AS_ROOT=1 \
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl=self,vader OMPI_MCA_plm_rsh_agent=false \
    timeout 120 mpirun --quiet -n "$count" "$@"
}
ranks() {
  on_ranks "$1" "$signum_mpi" "${@:2}"
}

# judged NAME COUNT ARGUMENTS...: the tessellation is valid and canonical.
judged() {
  local name=$1 count=$2
  shift 2
  [ "$(ranks "$count" validate "$@" --quiet)" = "valid, canonical" ] ||
    fail "$name: $count ranks do not find $* valid"
}

# same NAME SITES METRIC RANKS...: of the plane, and with dimension=3 of space.
dimension=2
same() {
  local name=$1 sites=$2 metric=$3
  local kind=(--metric "$metric" --dimension "$dimension" --quiet)
  shift 3
  "$signum" triangulate "$sites" "${kind[@]}" -o whole.json -o whole.npy 2>/dev/null
  for count in "$@"; do
    ranks "$count" triangulate "$sites" "${kind[@]}" -o found.json -o found.npy -o "found$count.h5" ||
      { fail "$name, $metric, $count ranks: it does not end well"; continue; }
    cmp -s whole.json found.json || fail "$name, $metric, $count ranks: another JSON"
    cmp -s whole.npy found.npy || fail "$name, $metric, $count ranks: other faces"
    cmp -s "found$1.h5" "found$count.h5" || fail "$name, $metric, $count ranks: another HDF5"
  done
  judged "$name" "$count" "found$count.h5" "$sites"
}
# The same of tables of cells: areas or volumes, and neighbours.
same_cells() {
  local name=$1 sites=$2 metric=$3
  local kind=(--metric "$metric" --dimension "$dimension" --quiet)
  shift 3
  "$signum" voronoi "$sites" "${kind[@]}" -o whole.csv 2>/dev/null
  for count in "$@"; do
    ranks "$count" voronoi "$sites" "${kind[@]}" -o found.csv -o found.pvtu ||
      { fail "$name, $metric, $count ranks: voronoi does not end well"; continue; }
    cmp -s whole.csv found.csv || fail "$name, $metric, $count ranks: another table"
  done
}

for metric in power euclidean manhattan supremum; do
  for kind in random grid rings; do
    "$signum" generate "$kind" -n 3000 --radius 0:9 -o sites.txt
    same "$kind" sites.txt "$metric" 1 3
    same_cells "$kind" sites.txt "$metric" 4
  done
done
dimension=3
for kind in random sphere grid; do
  "$signum" generate "$kind" -n 1500 --radius 0:40 --dimension 3 -o space.txt
  same "$kind of space" space.txt power 1 3 7
  same_cells "$kind of space" space.txt power 1 4
done
"$signum" generate random -n 5000 --dimension 3 -o space.npy
same "an array of space" space.npy power 1 2 4
same_cells "an array of space" space.npy power 2
cp whole.npy whole_space.npy
printf 'x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n1,1,1\n' >few.csv
same "few of space" few.csv power 1 2 7
dimension=2
"$signum" generate random -n 20000 --radius 0:3 -o sites.npy
same "an array" sites.npy euclidean 1 2 4
# Headers and remarks; lines that end in CR LF; more ranks than sites.
printf 'x y r\n0 0 1\n4 0 1\n0 3 0.5\n' >names.txt
same "names" names.txt euclidean 2
printf 'x,y,r\r\n0,0,1\r\n# here\r\n\r\n4,0,1\r\n0,3,0.5\r\n' >few.csv
same "few sites" few.csv euclidean 1 2 7
printf '0 0\n1 0\n0 1\n1 1\n' >square.txt
same "a square" square.txt power 1 4 7
printf "0 0\n1 0\n0 1\n1 1" >square.txt
same "no end of the last line" square.txt supremum 1 4 7

# wrong NAME CODE PATTERN ARGUMENTS...: the exit code, one line that says why, and no file.
wrong() {
  local name=$1 code=$2 pattern=$3
  shift 3
  rm -f out.h5
  local result=0
  ranks 3 "${command:-triangulate}" "$@" ${output--o out.h5} >said 2>&1 || result=$?
  [ "$result" -eq "$code" ] || fail "$name: exit code $result, not $code: $(cat said)"
  [ "$(grep -c 'signum-mpi: ' said)" -eq 1 ] || fail "$name: said $(grep -c 'signum-mpi: ' said) times: $(cat said)"
  grep --quiet "$pattern" said || fail "$name: $(cat said)"
  [ -z "$(ls out.h5* 2>/dev/null)" ] || fail "$name: leaves $(ls out.h5*)"
}
wrong "no file" 2 'none.txt' none.txt
for i in $(seq 400); do echo "$i $((i * i))"; done >lines.txt
sed '333s/.*/7 seven/' lines.txt >words.txt
wrong "a word" 2 'words.txt:333:1: ' words.txt
sed '250s/.*/7 nan/' lines.txt >nan.txt
wrong "no number" 2 'nan.txt:250:1: ' nan.txt
for i in $(seq 40); do echo "$i $i"; done >line.txt
wrong "a line" 2 'signum triangulate takes them' line.txt --metric power
wrong "no array named" 2 'which array' some.h5
wrong "a metric" 2 'none of power' lines.txt --metric manhatan
wrong "a metric of space" 2 'power metric alone' lines.txt --dimension 3 --metric euclidean
wrong "sites of the plane" 2 'x, y, z and perhaps r' line.txt --dimension 3
for ending in npy h5 json pvtu; do
  wrong "no folder for .$ending" 2 'none/out.*directory that is there' square.txt -o "none/out.$ending"
done
for name in - out out.d/out ''; do
  wrong "a name without an ending" 2 'ends as nothing that is written' square.txt -o "$name"
done
cp sites.npy same.npy
wrong "the input for an output" 2 'would overwrite the input' same.npy -o ./same.npy
cmp -s sites.npy same.npy || fail "the input is another one"
wrong "radii and weights" 2 'not both' in.h5:/points --radii /a --weights /b
# Where it can be made: a small disk.
mkdir small
if mount -t tmpfs -o size=200k tmpfs small 2>/dev/null; then
  for ending in h5 npy; do
    wrong "a full disk for .$ending" 3 "cannot write small/out.$ending: " sites.npy -o "small/out.$ending"
    [ -z "$(ls small)" ] || fail "a full disk for .$ending: leaves $(ls small)"
  done
  umount small
fi
head -c 5000 sites.npy >short.npy
head -c 100000 /dev/zero | tr '\0' 1 >long.txt
wrong "a line without end" 2 'more than 65536 bytes' long.txt
wrong "an array cut short" 2 'short.npy' short.npy

if "$python" -c 'import h5py, numpy' 2>/dev/null; then
  "$python" - <<'E' || fail "h5py: arrays of HDF5"
import h5py, numpy
random = numpy.random.default_rng(1)
sites = random.random((5000, 2))
radii = random.random(5000) * 0.01
with h5py.File("in.h5", "w") as file:
    file["points"] = sites
    file["single"] = sites.astype("f4")
    file["radii"] = radii
numpy.save("in.npy", numpy.column_stack([sites, radii]))
numpy.save("single.npy", sites.astype("f4"))
E
  ranks 3 triangulate in.h5:/points --radii /radii --metric euclidean --quiet -o by_h5.npy
  ranks 2 triangulate in.npy --metric euclidean --quiet -o by_npy.npy
  cmp -s by_h5.npy by_npy.npy || fail "points and radii of HDF5"
  ranks 3 triangulate in.h5:/single --quiet -o by_h5.npy -o out.h5
  "$signum" triangulate single.npy --quiet -o by_npy.npy 2>/dev/null
  cmp -s by_h5.npy by_npy.npy || fail "floats of HDF5"
  "$python" - <<'E' || fail "h5py: what is written"
import h5py, numpy
with h5py.File("out.h5") as file:
    grid, own = file["VTKHDF"], file["signum"]
    faces = own["faces"][:]
    assert (faces == numpy.load("by_npy.npy")).all()
    finite = faces[faces[:, 0] >= 0]
    assert (grid["Connectivity"][:].reshape(-1, 3) == finite).all()
    assert grid["NumberOfCells"][0] == len(finite) and grid["Offsets"][-1] == 3 * len(finite)
    across = own["neighbours"][:]
    for corner in range(3):
        # The two other corners of a face are on the face across.
        for k in (1, 2):
            assert (faces[across[:, corner]] == faces[:, [(corner + k) % 3]]).any(axis=1).all()
E
  ranks 3 triangulate in.h5:/points --radii /radii --metric power --quiet -o out.h5 -o out.i32
  judged "arrays of HDF5" 2 out.h5 in.h5:/points --radii /radii
  # Faces alone do not say who is hidden, and in the power metric need not.
  judged "faces alone" 2 out.i32 in.h5:/points --radii /radii --metric power
  mkdir judged
  printf '#!/usr/bin/env bash\n%s\nsignum_mpi=%q\nranks "$@"\n' "$(declare -f on_ranks ranks)" "$signum_mpi" >judged/ranks
  chmod +x judged/ranks
  (cd judged && "$python" "$here/judged.py" "$signum" ./ranks) || fail "tessellations made wrong"
  rm -f out.h5
  wrong "no such array" 2 'there is no array /none' in.h5:/none
  wrong "radii beside no sites" 2 'an array of 1 axes\|rows of 1 numbers' in.h5:/radii
fi
if "$python" -c 'import vtkmodules.vtkIOHDF' 2>/dev/null; then
  ranks 2 triangulate square.txt --quiet -o square.vtkhdf
  "$python" - <<'E' || fail "VTK does not read it"
from vtkmodules.vtkIOHDF import vtkHDFReader
reader = vtkHDFReader()
reader.SetFileName("square.vtkhdf")
reader.Update()
grid = reader.GetOutput()
assert grid.GetNumberOfPoints() == 4 and grid.GetNumberOfCells() == 2, grid
assert grid.GetPointData().GetArray("radius").GetNumberOfTuples() == 4
E
fi
if "$python" -c 'import numpy, vtkmodules.vtkIOXML' 2>/dev/null; then
  ranks 3 triangulate space.npy --dimension 3 --quiet -o space.pvtu
  ranks 3 voronoi space.npy --dimension 3 --quiet -o cells.pvtu -o cells.csv
  "$python" - <<'E' || fail "VTK does not read pieces"
import csv, numpy
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader
def grid(name):
    reader = vtkXMLPUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()
found = numpy.load("whole_space.npy")
assert grid("space.pvtu").GetNumberOfCells() == (found[:, 0] >= 0).sum()
cells = grid("cells.pvtu")
def column(name):
    values = cells.GetCellData().GetArray(name)
    return [values.GetValue(i) for i in range(cells.GetNumberOfCells())]
rows = {int(row["site"]): float(row["volume"]) for row in csv.DictReader(open("cells.csv"))}
assert dict(zip(column("site"), column("volume"))) == {site: v for site, v in rows.items() if v > 0}
E
fi
command=validate output=
ranks 2 triangulate square.txt --quiet -o square.h5 -o square.i32
wrong "other sites" 1 'square.h5 is not a valid tessellation of names.txt' square.h5 names.txt
wrong "another metric" 2 'says that it is of the euclidean' square.h5 square.txt --metric power
cp square.txt text.h5
wrong "no tessellation" 2 'no file of HDF5' text.h5 square.txt
wrong "JSON" 2 'signum validate judges JSON' square.json square.txt
head -c 50 square.i32 >cut.i32
wrong "faces cut short" 2 '50 bytes are no rows of 3 numbers' cut.i32 square.txt
unset command output
# A rank that dies ends all of them, and leaves no result.
"$signum" generate random -n 2000000 -o big.npy
on_ranks 3 "$signum_mpi" triangulate big.npy --quiet -o killed.npy >said 2>&1 &
job=$!
for _ in $(seq 100); do
  one=$(pgrep -n -f "^$signum_mpi triangulate big.npy") && break
  sleep 0.05
done
kill -KILL "$one"
if wait "$job"; then fail "a rank that was killed: exit code 0"; fi
[ ! -e killed.npy ] || fail "a rank that was killed: there is a result"
if pgrep -f "^$signum_mpi triangulate big.npy" >said; then fail "a rank that was killed: others go on"; fi
# Of n sites there are at most 3n - 6 edges, and these are all but those that a hull of some corners lacks.
on_ranks 3 "$example" 2000 >said
grep -q '^6000 sites, 5\.9[0-9]* neighbours each$' said || fail "the example: $(cat said)"
[ "$failures" -eq 0 ] || exit 1
echo "all as it should be"
