"""What becomes of the files of tests/hard/cases: where the sites are, what the tool says of them, or why it refuses.

  tables.py SIGNUM FOLDER
"""
import os
import subprocess
import sys

program, folder = sys.argv[1:]
complaints = []
tried = set()


def run(name, command, *words):
    tried.add(name)
    return subprocess.run([program, command, os.path.join(folder, name), "--quiet", *words], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True)


def require(holds, name, what, done):
    if not holds:
        complaints.append(f"{name}: {what}; code {done.returncode}, {done.stderr}{done.stdout[:400]}")


def check_said(name, said, done):
    for words in said:
        require(words in done.stderr, name, f"does not say {words!r}", done)
    require(said or not done.stderr, name, "says something", done)


def plane(name, expected, said, *words):
    """The sites of the cells, x and y, in their order."""
    done = run(name, "voronoi", "--format", "csv", *words)
    found = [tuple(map(float, line.split(",")[1:3])) for line in done.stdout.splitlines()[1:]]
    require(done.returncode == 0 and found == expected, name, f"sites {found}, not {expected}", done)
    check_said(name, said, done)
    return done.stdout


def space(name, sites, said, *words):
    """So many sites."""
    done = run(name, "triangulate", "--metric", "power", "--format", "json", *words)
    require(done.returncode == 0 and f'"sites": {sites},' in done.stdout, name, f"not {sites} sites", done)
    check_said(name, said, done)


def refused(name, words, *call):
    done = run(name, *(call or ("triangulate",)))
    require(done.returncode == 2 and words in done.stderr and not done.stdout, name, f"not refused with {words!r}", done)


degrees = "degrees that are taken for a plane's"
left_out = "left out: no radius"

# Columns by the names that programs give them; degrees stay on the globe.
plane("g03_arcgis_export.csv", [(512345.25, 4512345.5), (512845.75, 4512045.0), (511945.5, 4511845.25), (512645.0, 4511545.75)],
      ["'POINT_X' is x and 'POINT_Y' is y"])
plane("g06_hash_in_header.csv", [(1000, 2000), (1500, 2100), (1200, 2600)],
      ["'Easting' is x and 'Northing' is y", "'Well #', 'Depth' are left out"])
plane("g27_lat_lon_two_columns.csv", [(2.17, 49.07), (2.1, 49.05), (2.09, 49.01)], ["'Longitude' is x", degrees])
table = plane("g15_world.csv", [(-179.5, 10), (179.5, 10), (0, 85), (0, -80)], [degrees, left_out])
for text in table.replace("(", " ").replace(")", " ").split('"')[1::2]:
    for corner in text.split("POLYGON")[1].split(","):
        x, y = map(float, corner.split())
        if abs(x) > 180 or abs(y) > 90:
            complaints.append(f"g15_world.csv: a cell reaches to {x} {y}")
plane("g09_points.geojson", [(-1.5, 52.25), (-1.25, 52.5), (-1.75, 52.75)], [degrees])

# A comment begins at the start of a line.
carried = run("g19_hash_cuts_attribute.csv", "voronoi", "--format", "csv", "--carry")
require("Station #2" in carried.stdout, "g19_hash_cuts_attribute.csv", "'Station #2' is cut", carried)

# Numbers as people write them.
refused("g01_decimal_comma_semicolon.csv", "has a decimal comma; write a point in its place, or say --decimal ,")
plane("g01_decimal_comma_semicolon.csv", [(2.1747, 49.0717), (2.1008, 49.051), (2.0913, 49.0172), (2.06, 49.0354)],
      [degrees, left_out], "--decimal", ",")
refused("g13_dms.csv", "'19°15'27")
refused("g13_dms.csv", "is in degrees, minutes and seconds, which are not read")
space("m33_fortran_exponents.xyz", 3, ["no atom has a radius"])

# What three numbers a line are.
plane("m23_neper_seeds.txt", [(0.1, 0.2), (0.4, 0.9), (0.7, 0.6)], ["three numbers a line are x, y and r"])
space("m23_neper_seeds.txt", 4, [], "--dimension", "3")
space("m13_charges_in_fifth_column.xyz", 5, ["a fifth word is no radius"])

# Elements and radii.
space("m01_charmm_ions_no_element.pdb", 7, ["for one: 1 Ca, 1 Cl, 2 H, 1 K, 1 Na, 1 O"])
space("m30_left_justified_names.pdb", 7, ["for one: 3 C, 2 H, 1 N, 1 O"])
space("m03_metals.pdb", 5, [])
space("m03_metals.pdb", 5, [], "--radius", "Mo=2.1")
refused("m03_metals.pdb", "--radius Mo: give an element and its radius", "triangulate", "--metric", "power", "--radius", "Mo")

# Formats.
refused("m06_shifted_columns.pdb", ":3:31: x, y and z are to stand in columns 31 to 38", "triangulate", "--metric", "power")
space("m07_merged_numbers.pqr", 3, [])
space("m16_scaled.lammpstrj", 4, ["scaled coordinates are placed in the box"])
space("m18_water.gro", 6, ["lengths, radii among them, are nanometres"])
space("m27_scanner_binary.ply", 4, [])
space("m37_tetrahedron.off", 4, [])
refused("g11_places.kml", "this is KML, which is not read; save the points as CSV")
done = run("m20_alternates.cif", "triangulate", "--metric", "power")
if "made without gemmi" not in done.stderr:
    space("m20_alternates.cif", 3, ["1 alternate place of atoms left out"])

# The twins of some, with other names, in the same files.
here = subprocess.run([program, "triangulate", "-", "--metric", "power", "--quiet", "--read-as", "gro"], text=True,
                      input=open(os.path.join(folder, "m18_water.gro")).read(), capture_output=True)
require(here.returncode == 0, "m18_water.gro", "not read from standard input", here)
plane("g04_antimeridian.csv", [tuple(map(float, line.split(",")[:0:-1])) for line in
                               open(os.path.join(folder, "g04_antimeridian.csv")).read().split()[1:]], [degrees])

for name in sorted(set(os.listdir(folder)) - tried):
    complaints.append(f"{name}: is not tried")
if complaints:
    sys.exit("\n".join(complaints))
print(f"{len(tried)} files")
