#!/usr/bin/env python3
"""What the Python package costs beside C++, and SciPy beside it: tables for docs/python.md.

  benchmarks/python.py cost BUILD [-n 1000000] [-r 9]     BUILD: with SIGNUM_BUILD_PYTHON, targets
  benchmarks/python.py scipy BUILD [-n 100000] [-r 5]    signum_python and python_rival

Times alternate, a pass of one and a pass of the other, so that what else the machine does falls on both;
ratios are those of a pass, and their median is given. Wrong edges are judged by exact predicates: an edge
between two sites is wrong where no permitted choice of ties has it, missing where too few are there.
"""

import argparse
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("table", choices=["cost", "scipy"])
parser.add_argument("build", type=pathlib.Path)
parser.add_argument("-n", type=int)
parser.add_argument("-r", type=int)
arguments = parser.parse_args()
sys.path.insert(0, str(arguments.build / "bindings/python"))

import numpy as np

import signum


def seconds(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def cost(n, passes):
    """Python's triangulate() against C++'s, on the same points."""
    rng = np.random.default_rng(1)
    sites = rng.uniform(0, 1, (n, 2))
    print(f"| metric, {n} random points | C++ s | Python s | ratio |\n| --- | --: | --: | --: |")
    with tempfile.NamedTemporaryFile() as file:
        sites.tofile(file)
        file.flush()
        for metric in ("power", "euclidean"):
            rival = subprocess.Popen(
                [arguments.build / "bindings/python/python_rival", file.name, metric],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            )  # fmt: skip
            rows = []
            for number in range(passes + 1):
                rival.stdin.write("\n")
                rival.stdin.flush()
                taken, faces = rival.stdout.readline().split()
                here, t = seconds(lambda: signum.triangulate(sites, metric))
                assert len(t.faces) == int(faces)
                if number > 0:  # the first pass warms both
                    rows.append((float(taken), here, here / float(taken)))
                del t
            rival.stdin.close()
            rival.wait()
            cpp, python, ratio = (statistics.median(column) for column in zip(*rows))
            print(f"| {metric} | {cpp:.3f} | {python:.3f} | {ratio:.3f} |", flush=True)


def families(n):
    rng = np.random.default_rng(2)
    side = int(n**0.5)
    x, y = np.meshgrid(np.arange(side) * 0.1, np.arange(side) * 0.1)
    # Beyond a few thousand there Qhull takes minutes.
    on_circle = min(n, 2000)
    angle = rng.uniform(0, 2 * np.pi, on_circle)
    centres = rng.uniform(0, 1, (max(n // 1000, 1), 2))
    return {
        "random": rng.uniform(0, 1, (n, 2)),
        "clustered": centres[rng.integers(0, len(centres), n)] + rng.normal(scale=1e-4, size=(n, 2)),
        "grid, 0.1 apart": np.column_stack([x.ravel(), y.ravel()]),
        f"{on_circle} on a circle": np.column_stack([np.cos(angle), np.sin(angle)]),
        "random, 1e8 away": rng.uniform(0, 1, (n, 2)) + 1e8,
    }


def edges_of(simplices):
    corners = np.sort(simplices, axis=1)
    pairs = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [0, 2]]])
    return np.unique(pairs, axis=0)


def scipy(n, passes):
    from scipy.spatial import Delaunay, Voronoi

    print(
        f"| {n} points | Delaunay: SciPy s | signum s | SciPy's edges wrong | missing "
        "| Voronoi: SciPy s | signum s |\n| --- | --: | --: | --: | --: | --: | --: |"
    )
    for name, sites in families(n).items():
        rows = []
        for _ in range(passes):
            theirs, delaunay = seconds(lambda: Delaunay(sites))
            ours, t = seconds(lambda: signum.triangulate(sites, "power"))
            their_cells, _ = seconds(lambda: Voronoi(sites))
            our_cells, _ = seconds(lambda: signum.voronoi(signum.triangulate(sites, "power")))
            rows.append((theirs, ours, their_cells, our_cells))
        theirs, ours, their_cells, our_cells = (statistics.median(column) for column in zip(*rows))
        edges = edges_of(delaunay.simplices)
        wrong = int((~t.may_share_edge(edges)).sum())
        expected = t.edges()
        missing = int((expected[:, 0] >= 0).sum()) - len(edges)
        print(
            f"| {name} | {theirs:.2f} | {ours:.2f} | {wrong} | {max(missing, 0)} | {their_cells:.2f} | {our_cells:.2f} |",
            flush=True,
        )


if arguments.table == "cost":
    cost(arguments.n or 1_000_000, arguments.r or 9)
else:
    scipy(arguments.n or 100_000, arguments.r or 5)
