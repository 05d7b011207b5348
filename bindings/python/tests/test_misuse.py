"""What is meant otherwise: an exception with a sentence, never a crash, nor a call without end."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest

import signum
from signum import effects

RNG = np.random.default_rng(29)
SITES = RNG.uniform(0, 9, (20, 3)) * [1, 1, 0.1]
BALLS = [[0, 0, 0.1, 1, 0.3, 1], [1, 0, 0.1, -1, 0.1, 1]]


def objects():
    t = signum.triangulate(SITES)
    space = signum.triangulate_space(RNG.uniform(0, 9, (20, 3)))
    simulation = signum.Simulation(BALLS)
    return {
        "Tessellation": t,
        "Validation": t.validate(),
        "Voronoi": signum.voronoi(t),
        "Cells": signum.voronoi(t).clip(),
        "SpaceTessellation": space,
        "SpaceCells": space.clip(),
        "DynamicTessellation": signum.DynamicTessellation(sites=SITES),
        "KineticTessellation": signum.KineticTessellation(RNG.uniform(0, 9, (9, 5))),
        "State": simulation.state(),
        "Simulation": simulation,
    }


OBJECTS = objects()

ENDING = """
import sys, threading, time
import numpy as np, signum
sites = np.random.default_rng(1).uniform(0, 1, (400_000, 3)) * [1, 1, 1e-6]
balls = np.random.default_rng(1).uniform(0, 1, (300, 5)) * [1, 1, 1e-6, 1, 1]
few = signum.triangulate(sites[:300])

def again_and_again():
    while True:
        few.edges()
        few.nearest(sites[:20, :2])

work, number = {
    "plane": (lambda: signum.triangulate(np.tile(sites, (8, 1)) + np.arange(8.0).repeat(400_000)[:, None] * [1, 0, 0], "power"), 1),
    "told": (lambda: signum.triangulate(np.tile(sites, (8, 1)) + np.arange(8.0).repeat(400_000)[:, None] * [1, 0, 0], "power", progress=lambda _: None), 1),
    "simulation": (lambda: signum.Simulation(balls, box=((-1, -1), (2, 2))).run(log=False), 1),
    "predicates": (lambda: signum.ccw(sites[:4000, None, :2], sites[None, :, :2], sites[0, :2]), 1),
    "short calls": (again_and_again, 6),
}[sys.argv[1]]
for _ in range(number):
    threading.Thread(target=work, daemon=True).start()
time.sleep(0.7)
sys.exit(5)
"""


@pytest.mark.parametrize("work", ["plane", "told", "simulation", "predicates", "short calls"])
def test_a_program_may_end_while_a_thread_computes(work):
    done = subprocess.run([sys.executable, "-c", ENDING, work], capture_output=True, text=True, timeout=120)
    assert done.returncode == 5, done.stderr


@pytest.mark.parametrize("name", [name for name in OBJECTS if name != "Simulation"])
def test_what_new_alone_has_made_is_empty(name):
    kind = type(OBJECTS[name])
    empty = kind.__new__(kind)
    for attribute in dir(kind):
        if attribute.startswith("__") or callable(getattr(kind, attribute)):
            continue
        with pytest.raises(TypeError, match="__new__"):
            getattr(empty, attribute)
    for method in ("edges", "faces", "state", "centres", "neighbours_of", "site", "polygon", "__len__", "__bool__"):
        if hasattr(kind, method) and name != "SpaceCells":
            arguments = (0,) if method in ("neighbours_of", "site", "polygon") else ()
            with pytest.raises(TypeError, match="__new__"):
                getattr(empty, method)(*arguments)


@pytest.mark.parametrize("name", OBJECTS)
def test_copies_are_refused(name):
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        with pytest.raises(TypeError, match=f"cannot pickle or copy a {name}"):
            pickle.dumps(OBJECTS[name], protocol)
    for copied in (copy.copy, copy.deepcopy):
        with pytest.raises(TypeError, match=f"cannot pickle or copy a {name}"):
            copied(OBJECTS[name])


def simulated(**acting):
    return signum.Simulation(BALLS, box=((-1, -1), (5, 5)), **acting)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: simulated(restitution="x"), "restitution: a float"),
        (lambda: simulated(time_step=None), "time_step: a float"),
        (lambda: simulated(wall_restitution=10**400), "wall_restitution: a float"),
        (lambda: simulated(friction=0.1), "coefficient: a 'float' has none"),
        (lambda: simulated(speed_law="x"), "speed: a 'str' has none"),
        (lambda: simulated(friction=effects.Friction(inertia="x")), "inertia: a float"),
        (lambda: simulated(contacts=effects.LastingContacts(0.1, sweeps=2**40)), "sweeps: a whole number"),
        (lambda: simulated(obstacles=[effects.HalfSpace((0, 1), [])]), "offset: a float"),
        (lambda: simulated().state().centres("x"), "time: a float"),
        (lambda: OBJECTS["Cells"].polygon(0, "x"), "tolerance: a float"),
        (lambda: OBJECTS["Cells"].polygons(10**400), "tolerance: a float"),
    ],
)
def test_what_is_no_number_is_refused_by_name(call, message):
    with pytest.raises(TypeError, match=message):
        call()


def test_what_cannot_be_told_is_refused_before_the_work():
    t = signum.triangulate(SITES)
    for call in (
        lambda: signum.triangulate(SITES, progress=5),
        lambda: signum.triangulate_space(SITES, progress="x"),
        lambda: signum.validate(t.sites, t.faces, progress=[]),
        lambda: t.validate(progress=1.0),
        lambda: signum.Simulation(BALLS).run(1.0, progress={}),
    ):
        with pytest.raises(TypeError, match="progress: a function"):
            call()


def test_a_table_is_no_moving_site():
    moving = signum.KineticTessellation(RNG.uniform(0, 9, (9, 5)))
    for wrong in (np.ones((2, 3)), np.ones((5, 1)), np.ones((2, 5)), np.ones((1, 1, 5))):
        with pytest.raises(ValueError, match="site: "):
            moving.insert(wrong)
        with pytest.raises(ValueError, match="site: "):
            moving.change(0, wrong)
    assert moving.insert(np.ones((1, 5))) == 9


def test_more_rows_than_sites_can_be_are_refused_at_once():
    rows = np.broadcast_to([1.0, 2.0, 0.5], (2**40, 3))
    for call in (
        lambda: signum.triangulate(rows),
        lambda: signum.DynamicTessellation(sites=rows),
        lambda: signum.DynamicTessellation().insert(rows),
        lambda: signum.validate(rows, [[-1, 0, 1]]),
    ):
        with pytest.raises(ValueError, match="too many sites"):
            call()


def test_balls_much_larger_than_their_box_are_refused():
    box = [[0, 0], [10, 10]]
    assert signum.meeting_time([0, 0, 1, 1, 1], [5, 5, 100, -1, 0], until=4.0, periodic_box=box) == 0
    for radius in (1e5, 1e308):
        with pytest.raises(ValueError, match="smaller radii or a larger box"):
            signum.meeting_time([0, 0, 1, 1, 1], [5, 5, radius, -1, 0], until=4.0, periodic_box=box)
        with pytest.raises(ValueError, match="row 0: .*smaller radii or a larger box"):
            signum.meeting_time(
                [[0, 0, 0, 1, 1, 1, 1]],
                [5, 5, 5, radius, -1, 0, 0],
                until=4.0,
                periodic_box=[[0, 0, 0], [10, 10, 10]],
            )
