#!/usr/bin/env python3
"""Tessellations that are made wrong, as JSON and as HDF5: signum-mpi validate says of the one what
signum validate says of the other, whatever the number of ranks.

    judged.py SIGNUM RANKS [SEED [RUNS]]        in an empty folder; RANKS COUNT ... runs signum-mpi
"""

import collections
import json
import random
import subprocess
import sys

import h5py
import numpy

signum, ranks = sys.argv[1:3]
seed, runs = (int(number) for number in (sys.argv[3:] + ["1", "36"][len(sys.argv) - 3 :]))
chance = random.Random(seed)


def said(*command):
    return subprocess.run(command, capture_output=True, text=True).stdout.split(":")[0].strip()


def flip(cells, neighbours):
    """Flips an edge whose two faces share no other; None where there is no such edge."""
    f, k = chance.randrange(len(cells)), chance.randrange(3)
    g = neighbours[f][k]
    if neighbours[g].count(f) != 1:
        return None
    m = neighbours[g].index(f)
    a, b, c = (cells[f][(k + i) % 3] for i in range(3))
    d = cells[g][m]
    beside = [neighbours[f][(k + 1) % 3], neighbours[f][(k + 2) % 3]]  # across ca, ab
    beyond = [neighbours[g][(m + 1) % 3], neighbours[g][(m + 2) % 3]]  # across bd, dc
    moved = [(beside[0], f, g), (beyond[0], g, f)]
    if a == d or any(neighbours[n].count(old) != 1 for n, old, _ in moved):
        return None
    for n, old, new in moved:
        neighbours[n][neighbours[n].index(old)] = new
    cells[f], neighbours[f] = [a, b, d], [beyond[0], g, beside[1]]
    cells[g], neighbours[g] = [a, d, c], [beyond[1], beside[0], f]
    for n in (f, g):
        turn(cells, neighbours, n, cells[n].index(min(cells[n])))
    return True


def turn(cells, neighbours, f, by):
    cells[f] = cells[f][by:] + cells[f][:by]
    neighbours[f] = neighbours[f][by:] + neighbours[f][:by]


def change(what, cells, neighbours, hidden, sites):
    """One change; None where it cannot be made."""
    f, k = chance.randrange(len(cells)), chance.randrange(len(cells[0]))
    if what == "a face elsewhere":
        cells[0], cells[f] = cells[f], cells[0]
    elif what == "another site":
        cells[f][k] = chance.randrange(-1, sites)
    elif what == "another neighbour":
        neighbours[f][k] = chance.randrange(len(cells))
    elif what == "a flip":
        return flip(cells, neighbours) if len(cells[0]) == 3 else None
    elif what == "a face turned over":
        cells[f][:2], neighbours[f][:2] = cells[f][1::-1], neighbours[f][1::-1]
    elif what == "another beginning" and len(cells[0]) == 3:
        turn(cells, neighbours, f, 1)
    elif what == "hidden by another" and hidden:
        chance.choice(hidden)[1] = chance.randrange(sites)
    elif what == "another one hidden" and hidden:
        chance.choice(hidden)[0] = chance.randrange(sites)
    elif what == "one hidden less" and hidden:
        hidden.pop(chance.randrange(len(hidden)))
    elif what == "hidden in another order" and len(hidden) > 1:
        i = len(hidden) // 2
        hidden[i - 1], hidden[i] = hidden[i], hidden[i - 1]
    elif what == "a site moved":
        lines = open("sites.txt").read().splitlines()
        i = chance.randrange(len(lines))
        x, *rest = lines[i].split()
        lines[i] = " ".join([repr(float(x) + chance.choice([1e-9, 0.1, 50.0])), *rest])
        open("sites.txt", "w").write("\n".join(lines) + "\n")
    elif what != "nothing":
        return None
    return True


changes = ["nothing", "a face elsewhere", "another site", "another neighbour", "a flip"]
changes += ["a face turned over", "another beginning", "hidden by another", "another one hidden"]
changes += ["one hidden less", "hidden in another order", "a site moved"]
verdicts = collections.Counter()
run = 0
while run < runs:
    dimension = chance.choice(["2", "2", "3"])
    metric = "power" if dimension == "3" else chance.choice(
        ["power", "euclidean", "manhattan", "supremum"])
    kinds = ["random", "grid", "sphere"] if dimension == "3" else ["random", "grid", "rings"]
    subprocess.run(
        [signum, "generate", chance.choice(kinds), "-n", chance.choice(["10", "40", "150"]),
         "--radius", chance.choice(["0:0", "0:9", "0:60"]), "--seed", str(chance.randrange(10**6)),
         "--dimension", dimension, "-o", "sites.txt"], check=True)
    call = ["triangulate", "sites.txt", "--metric", metric, "--dimension", dimension, "--quiet"]
    subprocess.run([ranks, "1", *call, "-o", "right.h5", "-o", "right.json"], check=True)
    document = json.load(open("right.json"))
    name = "cells" if dimension == "3" else "faces"
    cells, neighbours, hidden = (document[key] for key in (name, "neighbours", "hidden"))
    what = changes[run % len(changes)]
    if change(what, cells, neighbours, hidden, document["sites"]) is None:
        continue
    run += 1
    json.dump(document, open("changed.json", "w"))
    with h5py.File("right.h5", "r+") as file:
        file["signum"][name][...] = numpy.array(cells)
        file["signum/neighbours"][...] = numpy.array(neighbours)
        del file["signum/hidden"]
        file["signum/hidden"] = numpy.array(hidden, dtype="i8").reshape(len(hidden), 2)
    expected = said(signum, "validate", "changed.json", "sites.txt", "--quiet")
    found = said(ranks, str(1 + run % 3), "validate", "right.h5", "sites.txt", "--quiet")
    verdicts[expected] += 1
    if not expected or found != expected:
        sys.exit(f"seed {seed}, run {run}: {what}, {metric}: '{found}', not '{expected}'")
if len(verdicts) != 3:
    sys.exit(f"not all verdicts came: {dict(verdicts)}")
print(dict(verdicts))
