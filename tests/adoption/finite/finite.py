#!/usr/bin/env python3
"""signum validate --finite of every format that it reads, and of what SciPy makes where it is here.

usage: finite.py SIGNUM
"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SIGNUM = sys.argv[1]


def judge(*words):
    run = subprocess.run([SIGNUM, "validate", *map(str, words), "--finite"], capture_output=True,
                         text=True)
    return run.returncode, run.stdout, run.stderr


def expect(code, text, *words):
    got, out, err = judge(*words)
    assert got == code and text in out + err, (words, got, out, err)


def rows(faces, start=0):
    return "\n".join(" ".join(str(i + start) for i in face) for face in faces) + "\n"


def write_all(folder, points, faces):
    """The faces in each format, and how each is asked for."""
    size = len(faces[0])
    what = "face" if size == 3 else "cell"
    files = {
        "rows.txt": rows(faces),
        "rows.csv": "a,b,c\n" + rows(faces).replace(" ", ",") if size == 3 else rows(faces),
        "array.json": json.dumps(faces),
        "object.json": json.dumps({"points": points, "simplices": faces}),
        "zero.ele": f"{len(faces)} {size} 0\n"
        + "".join(f"{k} {rows([face])}" for k, face in enumerate(faces)) + "# made by hand\n",
        "one.ele": f"{len(faces)} {size} 1\n"
        + "".join(f"{k + 1} {rows([face], 1)[:-1]} 7\n" for k, face in enumerate(faces)),
        "mesh.vtk": "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n"
        f"POINTS {len(points)} double\n" + "".join("0 0 0\n" for _ in points)
        + f"{'POLYGONS' if size == 3 else 'CELLS'} {len(faces)} {len(faces) * (size + 1)}\n"
        + "".join(f"{size} {rows([face])}" for face in faces)
        + f"CELL_TYPES {len(faces)}\n" + f"{5 if size == 3 else 10}\n" * len(faces),
    }
    if size == 3:
        files["mesh.ply"] = (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty double x\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
            + "".join("0 0 0\n" for _ in points) + "".join(f"3 {rows([face])}" for face in faces))
        files["mesh.obj"] = "".join("v 0 0 0\n" for _ in points) + "".join(
            f"f {a + 1}//1 {b + 1} {c - len(points)}\n" for a, b, c in faces)
    for name, text in files.items():
        (folder / name).write_text(text)
    np.save(folder / "array.npy", np.array(faces, dtype=np.int32))
    np.save(folder / "columns.npy", np.asfortranarray(np.array(faces, dtype=np.int64)))
    return [folder / name for name in [*files, "array.npy", "columns.npy"]], what


with tempfile.TemporaryDirectory() as scratch:
    scratch = pathlib.Path(scratch)
    plane = [[0, 0], [4, 0], [4, 4], [0, 4], [2, 2], [6, 2]]
    faces = [[0, 1, 4], [2, 4, 1], [3, 2, 4], [0, 4, 3], [1, 5, 2]]
    np.save(scratch / "plane.npy", np.array(plane, dtype=float))
    paths, what = write_all(scratch, plane, faces)
    for path in paths:
        expect(0, "valid", path, scratch / "plane.npy")
    paths, what = write_all(scratch, plane, faces[:3] + [[1, 5, 4]])
    for path in paths:
        expect(1, "not valid: face", path, scratch / "plane.npy")

    space = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3], [3, 3, 3]]
    np.save(scratch / "space.npy", np.array(space, dtype=float))
    paths, what = write_all(scratch, space, [[0, 1, 2, 3], [4, 2, 1, 3]])
    for path in paths:
        expect(0, "valid", path, scratch / "space.npy", "--columns", "1,2,3")
    paths, what = write_all(scratch, space, [[0, 1, 2, 3]])
    for path in paths:
        # Messages count as the file does.
        number = 5 if path.name == "one.ele" else 4
        expect(1, f"site {number} is no vertex of any cell", path, scratch / "space.npy")

    # Wrong files say where.
    bad = scratch / "bad.txt"
    bad.write_text("0 1 2\n0 1 x\n")
    expect(2, "bad.txt:2:5: 'x' is no whole number", bad, scratch / "plane.npy")
    bad.write_text("0 1 2\n0 1\n")
    expect(2, "bad.txt:2:1: a face has three points and a cell four, not 2", bad, scratch / "plane.npy")
    bad.write_text("0 1 2\n0 1 2 3\n")
    expect(2, "faces and cells do not come together", bad, scratch / "plane.npy")
    quads = scratch / "quads.ply"
    quads.write_text("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int i\nend_header\n4 0 1 2 3\n")
    expect(2, "quads.ply:6:1: a face of 4 points; triangles are judged", quads, scratch / "plane.npy")
    quads = scratch / "quads.vtk"
    quads.write_text("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n")
    expect(2, "quads.vtk:4:1: a cell of type 9", quads, scratch / "space.npy", "--columns", "1,2,3")
    bad.write_text(rows(faces, 1))
    expect(1, "--from-one takes them as numbered from 1", bad, scratch / "plane.npy")
    expect(0, "valid", bad, scratch / "plane.npy", "--from-one")
    expect(2, "cannot open it", scratch / "none.txt", scratch / "plane.npy")

    # A picture and a judgement of what is wrong.
    bad.write_text(rows([[0, 1, 2], [0, 2, 3], [1, 5, 2]]))
    expect(1, "site 4 is no vertex", bad, scratch / "plane.npy", "-o", scratch / "faults.svg", "-o",
           scratch / "faults.json")
    assert "<title>site 4</title>" in (scratch / "faults.svg").read_text()
    assert json.loads((scratch / "faults.json").read_text())["missing"] == [4]

    try:
        from scipy.spatial import Delaunay
    except ImportError:
        print("without SciPy")
        sys.exit(0)
    random = np.random.default_rng(1)
    for points in (random.random((3000, 2)), random.random((1000, 3)),
                   np.array([[x, y] for x in range(20) for y in range(20)], dtype=float),
                   np.repeat(random.random((200, 2)), 2, axis=0)):
        np.save(scratch / "points.npy", points)
        np.save(scratch / "simplices.npy", Delaunay(points).simplices)
        code, out, err = judge(scratch / "simplices.npy", scratch / "points.npy", "--columns",
                               ",".join(str(k + 1) for k in range(points.shape[1])))
        assert code == 0, (out, err)
        # Two vertices exchanged for others.
        broken = np.load(scratch / "simplices.npy")
        broken[[3, 7], 0] = broken[[7, 3], 0]
        np.save(scratch / "broken.npy", broken)
        expect(1, "not valid", scratch / "broken.npy", scratch / "points.npy", "--columns",
               ",".join(str(k + 1) for k in range(points.shape[1])))
