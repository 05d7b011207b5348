#!/usr/bin/env python3
"""The museum of failures: public inputs on which geometry libraries crashed, looped or erred.

    scripts/museum.py SIGNUM                    judges signum on every input of tests/hard/museum
    scripts/museum.py SIGNUM --page FILE        and says whether FILE is the page of these inputs
    scripts/museum.py SIGNUM --peers --page FILE    asks the peers that are installed, and writes it

The judge shares nothing with signum: integers, Delaunay's lemma, and a point that lies in one face
alone. Peers are programs of their own with ten seconds each (tests/adoption/museum): SciPy, VTK,
Shapely (python3-scipy, -vtk9, -shapely), CGAL, TetGen (libcgal-dev, libtet1.5-dev), JTS
(libjts-java), delaunator (npm). --only NAME,... asks some of them.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INPUTS = ROOT / "tests/hard/museum"
PEERS = ROOT / "tests/adoption/museum"
SECONDS = 10


# ---- inputs ------------------------------------------------------------------------------------


class Input:
    """A file: comments with title, source, failed; a line of names; a site a line."""

    def __init__(self, path):
        self.path = path
        self.name = path.stem
        said = {}
        rows = []
        columns = []
        for line in path.read_text(encoding="ascii").splitlines():
            if line.startswith("#"):
                key, _, value = line[1:].strip().partition(": ")
                said[key] = value
            elif not columns:
                columns = line.split()
            elif line.strip():
                rows.append([float(word) for word in line.split()])
        for key in ("title", "source", "failed"):
            if key not in said:
                sys.exit(f"{path}: no line '# {key}: ...' at its head")
        self.title, self.source, self.failed = said["title"], said["source"], said["failed"]
        self.dimension = 3 if "z" in columns else 2
        self.has_weights = columns[-1] == "weight"
        self.rows = rows
        if any(len(row) != len(columns) for row in rows):
            sys.exit(f"{path}: a line does not have {len(columns)} numbers")
        self.sites = in_integers(rows, self.dimension)

    @property
    def distinct(self):
        return len(set(self.sites))


def in_integers(rows, dimension):
    """Sites as integers: coordinates, and their square less the weight."""
    exact = [[Fraction(x) for x in row] for row in rows]
    unit = max(x.denominator for row in exact for x in row)
    sites = []
    for row in exact:
        place = [int(x * unit) for x in row[:dimension]]
        weight = sum(int(x * unit) * unit for x in row[dimension:])
        sites.append((*place, sum(x * x for x in place) - weight))
    return sites


# ---- the judge ---------------------------------------------------------------------------------


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    result = 0
    for k, row in enumerate(rows):
        if row[0]:
            minor = determinant([other[1:] for m, other in enumerate(rows) if m != k])
            result += minor * row[0] * (-1 if k % 2 else 1)
    return result


def sign(x):
    return (x > 0) - (x < 0)


def turn(points):
    """Of d + 1 points, by their first d coordinates."""
    d = len(points) - 1
    last = points[-1]
    return sign(determinant([[p[k] - last[k] for k in range(d)] for p in points[:-1]]))


def conflict(points, q):
    """+1 where q lies in the circle (sphere) of d + 1 points in positive turn, 0 on it."""
    d = len(points) - 1
    return sign(determinant([[p[k] - q[k] for k in range(d + 1)] for p in points]))


def spans(sites, d):
    """Whether the sites do not all lie on a line (in a plane)."""
    basis = [sites[0]]
    for site in sites[1:]:
        trial = [*basis, site]
        vectors = [[p[k] - trial[0][k] for k in range(d)] for p in trial[1:]]
        if rank(vectors) == len(vectors):
            basis = trial
            if len(basis) == d + 1:
                return True
    return False


def rank(vectors):
    rows = [[Fraction(x) for x in row] for row in vectors]
    found = 0
    for column in range(len(rows[0])):
        pivot = next((r for r in rows[found:] if r[column]), None)
        if pivot is None:
            continue
        rows.remove(pivot)
        rows.insert(found, pivot)
        for row in rows[found + 1 :]:
            if row[column]:
                share = row[column] / pivot[column]
                for k, x in enumerate(pivot):
                    row[k] -= share * x
        found += 1
        if found == len(rows):
            break
    return found


def judge(sites, d, faces):
    """None where the faces, of any orientation, are a regular triangulation; else what is wrong.
    And the facets that a tie leaves open: beyond them lies a site on the circle (sphere)."""
    turned = []
    for face in faces:
        points = [sites[i] for i in face]
        way = turn(points) if len(set(face)) == d + 1 else 0
        if way == 0:
            return "a flat face", 0
        turned.append(face if way > 0 else [face[1], face[0], *face[2:]])
    if not turned:
        return ("no face", 0) if spans(sites, d) else (None, 0)
    beside = {}
    for number, face in enumerate(turned):
        for apex in range(d + 1):
            facet = [face[k] for k in range(d + 1) if k != apex]
            beside.setdefault(tuple(sorted(facet)), []).append((number, face[apex], facet))
    ties = 0
    for facet in beside.values():
        if len(facet) > 2:
            return "three faces at a facet", 0
        number, apex, ends = facet[0]
        side = turn([sites[i] for i in ends] + [sites[apex]])
        if len(facet) == 2:
            beyond = facet[1][1]
            if turn([sites[i] for i in ends] + [sites[beyond]]) == side:
                return "faces that overlap", 0
            on = conflict([sites[i] for i in turned[number]], sites[beyond])
            if on > 0:
                return "a site in a circle", 0
            ties += on == 0
        elif any(turn([sites[i] for i in ends] + [site]) == -side for site in sites):
            return "a gap at the hull", 0
    # Each place is covered as often as any other: so is the middle of the first face.
    middle = [sum(sites[i][k] for i in turned[0]) for k in range(d)]
    larger = [[x * (d + 1) for x in site[:d]] for site in sites]
    covers = [
        face
        for face in turned
        if all(turn([larger[i] if i != face[m] else middle for i in face]) >= 0 for m in range(d + 1))
    ]
    if len(covers) != 1:
        return "faces that overlap", 0
    used = {i for face in turned for i in face}
    places = {sites[i] for i in used}
    for number, site in enumerate(sites):
        if number in used or site in places:
            continue
        for face in turned:
            points = [sites[i] for i in face]
            inside = all(
                turn([site if k == m else p for k, p in enumerate(points)]) >= 0
                for m in range(d + 1)
            )
            if inside and conflict(points, site) > 0:
                return "a site that is missing", 0
            if inside:
                break
    return None, ties


# ---- signum ------------------------------------------------------------------------------------


def of_signum(signum, given):
    """Its finite faces; of points in a plane of space no cells."""
    said = subprocess.run(
        [signum, "triangulate", given.path, "--metric", "power", "-o", "-", "--format", "json",
         "--quiet"],
        capture_output=True, text=True, check=True,
    )
    read = json.loads(said.stdout)
    faces = read["cells" if given.dimension == 3 else "faces"]
    return [face for face in faces if min(face) >= 0 and len(face) == given.dimension + 1]


def right_of(signum, given):
    """What is right, in words; exits where signum is not."""
    faces = of_signum(signum, given)
    wrong, ties = judge(given.sites, given.dimension, faces)
    if wrong:
        sys.exit(f"{given.name}: signum is wrong: {wrong}")
    if not faces:
        return f"none: {'flat' if given.dimension == 3 else 'on a line'}"
    words = counted(len(faces), "cell" if given.dimension == 3 else "triangle")
    return words + (f", {counted(ties, 'tie')}" if ties else "")


def counted(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


# ---- peers -------------------------------------------------------------------------------------


def version_of(package):
    said = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True
    )
    return re.sub(r"[-+].*", "", said.stdout) if said.returncode == 0 else ""


def all_peers(scratch, only):
    """Those that are here: their names, dimensions, whether they know weights, and commands."""
    found = []

    def add(name, version, dimensions, weights, command, *builds):
        if not version or (only and name not in only):
            return
        for build in builds:
            if subprocess.run(build, capture_output=True, cwd=scratch).returncode != 0:
                return
        # One that does not even answer this is not here.
        easy = scratch / "easy.txt"
        easy.write_text("0 0\n3 0\n1 2\n" if 2 in dimensions else "0 0 0\n3 0 0\n1 2 0\n1 1 1\n")
        said = subprocess.run([*command, easy, str(min(dimensions))], capture_output=True,
                              text=True)
        if sorted(said.stdout.split()) != ["0", "1", "2", "3"][: min(dimensions) + 1]:
            sys.exit(f"{name} {version}: {said.stdout}{said.stderr}")
        found.append((f"{name} {version}", dimensions, weights, command))

    # Debian's packages are of Debian's Python.
    python = ["/usr/bin/python3", PEERS / "peers.py"]
    compile_ = ["g++", "-std=c++17", "-O2", "-w"]
    add("SciPy", version_of("python3-scipy"), (2, 3), False, [*python, "scipy"])
    add("CGAL", version_of("libcgal-dev"), (2, 3), True, [scratch / "cgal"],
        [*compile_, PEERS / "cgal.cpp", "-o", "cgal", "-lgmp", "-lmpfr"])
    add("Shapely (GEOS)", version_of("libgeos-dev"), (2,), False, [*python, "shapely"])
    add("JTS", version_of("libjts-java"), (2,), False,
        ["java", "-cp", f"{scratch}:/usr/share/java/jts-core.jar", "Jts"],
        ["javac", "-cp", "/usr/share/java/jts-core.jar", "-d", ".", PEERS / "Jts.java"])
    add("VTK", version_of("python3-vtk9"), (2, 3), False, [*python, "vtk"])
    add("TetGen", version_of("libtet1.5-dev"), (3,), False, [scratch / "tetgen"],
        [*compile_, PEERS / "tetgen.cpp", "-o", "tetgen", "-ltet"])
    if not only or "delaunator" in only:
        npm = subprocess.run(["npm", "install", "--prefix", scratch, "--silent", "delaunator@5"],
                             capture_output=True)
        if npm.returncode == 0:
            package = json.loads(
                (scratch / "node_modules/delaunator/package.json").read_text())
            add("delaunator", package["version"], (2,), False,
                ["node", PEERS / "delaunator.mjs", scratch])
    return found


def said_by(signum, peer, given, scratch):
    """What a peer makes of an input, in a word or two."""
    name, dimensions, weights, command = peer
    if given.dimension not in dimensions or (given.has_weights and not weights):
        return ""
    numbers = scratch / "sites.txt"
    with numbers.open("w") as out:
        for row in given.rows:
            print(*map(repr, row), file=out)
    try:
        said = subprocess.run([*command, numbers, str(given.dimension)], capture_output=True,
                              text=True, timeout=SECONDS, errors="replace")
    except subprocess.TimeoutExpired:
        return f"does not end in {SECONDS} s"
    if said.returncode < 0 or said.returncode == 134:
        return "crashes"
    if said.returncode != 0:
        return "refuses"
    faces = [[int(word) for word in line.split()] for line in said.stdout.splitlines()]
    wrong, _ = judge(given.sites, given.dimension, faces)
    if not faces:
        return "right" if wrong is None else "no face at all"
    table = scratch / "faces.csv"
    table.write_text("".join(",".join(map(str, face)) + "\n" for face in faces))
    verdict = scratch / "verdict.json"
    verdict.unlink(missing_ok=True)
    weight = ["--weight-is", "weight"] if given.has_weights else []
    judged = subprocess.run([signum, "validate", table, given.path, "--finite", *weight, "-o",
                             verdict, "--quiet"], capture_output=True, text=True)
    read = json.loads(verdict.read_text())
    if read["valid"] != (wrong is None):
        sys.exit(f"{given.name}, {name}: signum validate says {judged.stdout!r}, the judge {wrong}")
    if read["valid"]:
        return "right"
    words = []
    for fault in dict.fromkeys(each["fault"] for each in read["faults"]):
        words.append(f"{sum(each['fault'] == fault for each in read['faults'])} {fault}")
    if read["missing"]:
        words.append(f"{counted(len(read['missing']), 'point')} missing")
    if read["open"]:
        words.append(counted(len(read["open"]), "open edge"))
    return ", ".join(words) or wrong


# ---- the page ----------------------------------------------------------------------------------

HEAD = """# The museum of failures

Public inputs on which geometry libraries crashed, did not end, or answered wrongly, from their users' reports. Each stands in `tests/hard/museum/`
with its source and with what failed then. `./test` judges signum on every one: by integers, Delaunay's lemma and no code of signum.
[hard.md](hard.md) has the sets that were made to be hard.

**right** is what the judge counts; a tie is an edge (in space a triangle) beyond which a site lies on the circle (sphere), so that other
triangulations are right, too. A peer's answer is right where it is any Delaunay triangulation of the points; of points at one place one is enough.
What is wrong is counted by `signum validate --finite`: faces that are flat, overlapping, or in conflict (a point lies in their circle).
A peer that refuses, with an error, is not wrong; some of them promise less than the definition, and say so.

This page is written by `scripts/museum.py build/release/cli/signum --peers --page docs/museum.md`, with the peers of Debian 12 and npm. An empty
place: the peer does not do this, or is not packaged.
"""


def rows_of(inputs, rights):
    rows = []
    for given, right in zip(inputs, rights):
        doubled = f" ({given.distinct} distinct)" if given.distinct < len(given.sites) else ""
        rows.append(f"| [{given.name}](../tests/hard/museum/{given.name}.txt) | {given.title} "
                    f"| [{given.failed}]({given.source}) | {len(given.sites)}{doubled} | {right} |")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("signum", help="the tool, such as build/release/cli/signum")
    parser.add_argument("--page", type=Path, help="the page that is checked, or written")
    parser.add_argument("--peers", action="store_true", help="ask the peers")
    parser.add_argument("--only", default="", help="those alone: SciPy,CGAL,...")
    parser.add_argument("--inputs", type=Path, default=INPUTS, help="another folder of inputs")
    call = parser.parse_args()
    if not os.access(call.signum, os.X_OK):
        parser.error(f"{call.signum} is no program")
    if call.page and not call.peers and not call.page.exists():
        parser.error(f"there is no {call.page}; --peers writes it")
    signum = os.path.abspath(call.signum)
    inputs = [Input(path) for path in sorted(call.inputs.glob("*.txt"))]
    if not inputs:
        parser.error(f"no input in {call.inputs}")
    rights = [right_of(signum, given) for given in inputs]
    print(f"signum is right on {len(inputs)} inputs")
    rows = rows_of(inputs, rights)
    if call.peers:
        with tempfile.TemporaryDirectory() as folder:
            scratch = Path(folder)
            peers = all_peers(scratch, [name for name in call.only.split(",") if name])
            answers = []
            for number, given in enumerate(inputs):
                answers.append([said_by(signum, peer, given, scratch) for peer in peers])
                if sys.stderr.isatty():
                    print(f"\r{number + 1} of {len(inputs)}", end="", file=sys.stderr)
        names = [peer[0] for peer in peers]
        page = HEAD
        for title, chosen in (
            ("The plane", lambda g: g.dimension == 2 and not g.has_weights),
            ("Space", lambda g: g.dimension == 3 and not g.has_weights),
            ("Weights", lambda g: g.has_weights),
        ):
            of_part = [k for k, given in enumerate(inputs) if chosen(given)]
            if not of_part:
                continue
            columns = [m for m in range(len(names)) if any(answers[k][m] for k in of_part)]
            page += f"\n## {title}\n\n| input | what it is | failed | points | right | "
            page += " | ".join(names[m] for m in columns) + " |\n"
            page += "| --- | --- | --- | --: | --- |" + " --- |" * len(columns) + "\n"
            for k in of_part:
                page += rows[k] + "".join(f" {answers[k][m]} |" for m in columns) + "\n"
            page += f"| right | | | | {len(of_part)} of {len(of_part)} |"
            for m in columns:
                asked = [answers[k][m] for k in of_part if answers[k][m]]
                page += f" {sum(a == 'right' for a in asked)} of {len(asked)} |"
            page += "\n"
        if call.page:
            call.page.write_text(page)
        else:
            print(page)
    elif call.page:
        page = call.page.read_text()
        missing = [row for row in rows if row + " " not in page]
        if missing:
            sys.exit(f"{call.page} lacks: " + "\n".join(missing))
        if page.count("](../tests/hard/museum/") != len(rows):
            sys.exit(f"{call.page} has inputs that are not in {call.inputs}")
        print(f"{call.page} is the page of these inputs")


if __name__ == "__main__":
    main()
