"""The files that other programs read, read by independent readers, and the pictures that another
program makes.

    check_files.py TOOL SOURCES
"""

import csv
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

from shapely import geometry, wkt

tool, sources = sys.argv[1], pathlib.Path(sys.argv[2])
scratch = tempfile.TemporaryDirectory()
here = pathlib.Path(scratch.name)


def signum(*words, code=0, path=None):
    environment = dict(os.environ) if path is None else {"PATH": str(path)}
    end = subprocess.run([tool, *map(str, words)], cwd=here, env=environment,
                         capture_output=True, text=True)
    assert end.returncode == code, (words, end.returncode, end.stderr)
    return end.stderr


def numbers(text):
    return [float(word) for word in text.split()]


def arrays(name, piece_name):
    """The arrays of a file of VTK by name, and the attributes of its piece."""
    piece = xml.parse(here / name).getroot().find(f".//{piece_name}/Piece")
    found = {}
    for section in piece:
        for array in section:
            found[section.tag, array.get("Name")] = numbers(array.text)
    return found, {key: int(value) for key, value in piece.attrib.items()}


def cells(grid, section):
    """The corners of each cell."""
    corners, start = [], 0
    for end in map(int, grid[section, "offsets"]):
        corners.append([int(c) for c in grid[section, "connectivity"][start:end]])
        start = end
    assert start == len(grid[section, "connectivity"])
    return corners


def table_of_numbers(name):
    return [numbers(line) for line in (here / name).read_text().splitlines()]


def check_plane():
    signum("generate", "random", "-n", 300, "--radius", "1:20", "--seed", 3, "-o", "sites.txt")
    names = [f"plane.{e}" for e in ("json", "vtp", "vtk", "ply", "node", "ele", "neigh")]
    signum("triangulate", "sites.txt", "--metric", "power", *sum((["-o", n] for n in names), []))
    sites = table_of_numbers("sites.txt")
    result = json.loads((here / "plane.json").read_text())
    faces = [face for face in result["faces"] if face[0] >= 0]
    assert faces

    grid, piece = arrays("plane.vtp", "PolyData")
    assert piece["NumberOfPolys"] == len(faces) and piece["NumberOfPoints"] == len(sites)
    assert cells(grid, "Polys") == faces
    points = grid["Points", "Points"]
    assert [points[3 * i:3 * i + 3] for i in range(len(sites))] == [[x, y, 0] for x, y, r in sites]
    assert grid["PointData", "radius"] == [r for x, y, r in sites]
    hidden = [i for i, value in enumerate(grid["PointData", "hidden"]) if value == 1]
    assert hidden == [site for site, by in result["hidden"]] and hidden

    nodes = table_of_numbers("plane.node")
    assert nodes[0] == [len(sites), 2, 1, 0]
    assert [node[1:] for node in nodes[1:]] == sites
    elements = table_of_numbers("plane.ele")
    assert [element[1:] for element in elements[1:]] == faces
    corners = [geometry.Polygon([sites[site][:2] for site in face]) for face in faces]
    hull = geometry.MultiPoint([site[:2] for site in sites]).convex_hull
    assert abs(sum(each.area for each in corners) - hull.area) < 1e-9 * hull.area
    neighbours = table_of_numbers("plane.neigh")
    assert neighbours[0] == [len(faces), 3]
    for face, (number, *across) in enumerate(neighbours[1:]):
        assert number == face
        for k, other in enumerate(map(int, across)):
            edge = set(faces[face]) - {faces[face][k]}
            if other >= 0:
                assert edge < set(faces[other])
            else:
                assert sum(edge < set(each) for each in faces) == 1

    # What was written is read again, and is the same; numbered from 1, too.
    (here / "from_one.node").write_text(f"# from 1\n{len(sites)} 2 1 0\n" + "".join(
        f"{i + 1} {x!r} {y!r} {r!r}\n" for i, (x, y, r) in enumerate(sites)))
    for name in ("plane.node", "from_one.node"):
        signum("triangulate", name, "--columns", "2,3,4", "--metric", "power", "-o", "again.json")
        assert (here / "again.json").read_text() == (here / "plane.json").read_text()
    assert "left out" in signum("triangulate", "plane.node", "-o", "again.json")
    assert "valid, canonical" in subprocess.run(
        [tool, "validate", "plane.json", "plane.node", "--columns", "2,3,4"], cwd=here,
        capture_output=True, text=True).stdout


def check_space():
    signum("generate", "random", "--dimension", 3, "-n", 200, "--radius", "10:60", "-o",
           "balls.csv")
    names = [f"space.{e}" for e in ("json", "vtu", "ply", "node", "ele", "neigh")]
    signum("triangulate", "balls.csv", "--metric", "power", *sum((["-o", n] for n in names), []))
    result = json.loads((here / "space.json").read_text())
    finite = [cell for cell in result["cells"] if cell[0] >= 0]
    grid, piece = arrays("space.vtu", "UnstructuredGrid")
    assert piece == {"NumberOfPoints": 200, "NumberOfCells": len(finite)}
    assert cells(grid, "Cells") == finite
    assert set(grid["Cells", "types"]) == {10}
    assert [line[1:] for line in table_of_numbers("space.ele")[1:]] == finite
    for name in ("space.ply", "space.node"):
        columns = ["--columns", "2,3,4,5"] if name == "space.node" else []
        signum("triangulate", name, *columns, "--metric", "power", "-o", "again.json")
        assert (here / "again.json").read_text() == (here / "space.json").read_text()

    signum("voronoi", "balls.csv", "--metric", "power", "-o", "cells.vtu", "-o", "cells.csv")
    grid, piece = arrays("cells.vtu", "UnstructuredGrid")
    shown = cells(grid, "Cells")
    faces = [int(number) for number in grid["Cells", "faces"]]
    start = 0
    for corners, end in zip(shown, map(int, grid["Cells", "faceoffsets"])):
        stream, used, edges = faces[start:end], set(), 0
        place = 1
        for _ in range(stream[0]):
            loop = stream[place + 1:place + 1 + stream[place]]
            place += 1 + stream[place]
            used |= set(loop)
            edges += len(loop)
        assert place == len(stream) and used == set(corners)
        assert len(used) - edges // 2 + stream[0] == 2
        start = end
    assert start == len(faces)
    with open(here / "cells.csv") as table:
        volumes = {int(row["site"]): float(row["volume"]) for row in csv.DictReader(table)}
    for site, volume in zip(grid["CellData", "site"], grid["CellData", "volume"]):
        assert volumes[int(site)] == volume


def check_cities():
    lines = (sources / "examples/cities.csv").read_text().splitlines()
    lines = [line for line in lines if not line.startswith("#")][:401]
    (here / "cities.csv").write_text("\n".join(lines) + "\n")
    names = [f"cells.{e}" for e in ("geojson", "csv", "wkt", "vtp")]
    signum("voronoi", "cities.csv", "--carry", *sum((["-o", n] for n in names), []))
    rows = list(csv.DictReader(lines))
    collection = json.loads((here / "cells.geojson").read_text())
    x0, y0, x1, y1 = collection["bbox"]
    box = geometry.box(x0, y0, x1, y1)
    areas = {}
    for feature in collection["features"]:
        told = feature["properties"]
        row = rows[told["site"]]
        assert told["name"] == row["name"] and told["population"] == int(row["population"])
        shape = geometry.shape(feature["geometry"])
        assert shape.is_valid and box.buffer(1e-6).contains(shape)
        areas[told["site"]] = shape.area
    assert abs(sum(areas.values()) - box.area) < 1e-3 * box.area
    shapes = [wkt.loads(line) for line in (here / "cells.wkt").read_text().splitlines()]
    assert len(shapes) == len(rows)
    for site, shape in enumerate(shapes):
        assert shape.is_valid and shape.area == areas.get(site, 0)
    with open(here / "cells.csv") as table:
        for row in csv.DictReader(table):
            assert row["name"] == rows[int(row["site"])]["name"]
            assert wkt.loads(row["WKT"]).area == areas[int(row["site"])]
    grid, piece = arrays("cells.vtp", "PolyData")
    points = grid["Points", "Points"]
    for site, corners in zip(map(int, grid["CellData", "site"]), cells(grid, "Polys")):
        polygon = geometry.Polygon([points[3 * c:3 * c + 2] for c in corners])
        assert abs(polygon.area - areas[site]) <= 1e-9 * areas[site]


def check_pictures():
    bin = here / "bin"
    bin.mkdir()
    old = "as it was"
    picture = here / "picture.png"
    picture.write_text(old)
    before = sorted(here.iterdir())
    said = signum("triangulate", "sites.txt", "-o", "picture.png", "-o", "a.json", code=3, path=bin)
    assert "apt-get install librsvg2-bin" in said, said
    # One that is there and fails, and one that says nothing.
    for script in ("exit 7", "exit 0"):
        broken = bin / "rsvg-convert"
        broken.write_text(f'#!/bin/sh\ntest "$1" = --version && exit 0\n{script}\n')
        broken.chmod(0o755)
        said = signum("voronoi", "sites.txt", "-o", "picture.png", "-o", "a.json", code=3, path=bin)
        assert "rsvg-convert failed at a png; write svg" in said, said
    assert picture.read_text() == old and sorted(here.iterdir()) == before
    # The other program, where it is the only one.
    broken.unlink()
    (bin / "inkscape").write_text('#!/bin/sh\necho "$@"\n')
    (bin / "inkscape").chmod(0o755)
    signum("triangulate", "sites.txt", "-o", "picture.pdf", path=bin)
    assert (here / "picture.pdf").read_text().startswith("--export-type=pdf --export-filename=- /")

    for subcommand in ("triangulate", "voronoi"):
        for sites in ("sites.txt", "balls.csv"):
            signum(subcommand, sites, "--metric", "power", "-o", "picture.png", "-o",
                   "picture.pdf", "-o", "picture.svg")
            png = picture.read_bytes()
            assert png[:8] == b"\x89PNG\r\n\x1a\n" and png[12:16] == b"IHDR"
            width, height = struct.unpack(">II", png[16:24])
            svg = xml.parse(here / "picture.svg").getroot()
            assert abs(width - float(svg.get("width").removesuffix("px"))) <= 1
            assert abs(height - float(svg.get("height").removesuffix("px"))) <= 1
            assert (here / "picture.pdf").read_bytes()[:5] == b"%PDF-"


check_plane()
check_space()
check_cities()
check_pictures()
print("well")
