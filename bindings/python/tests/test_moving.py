"""What changes, what moves, and what strikes."""

import contextlib
import ctypes
import platform

import numpy as np
import pytest

import signum
from signum import effects

RNG = np.random.default_rng(13)
METRICS = ("power", "euclidean", "manhattan", "supremum")


def same(t, other):
    return np.array_equal(t.faces, other.faces) and np.array_equal(t.hidden, other.hidden)


@pytest.mark.parametrize("metric", METRICS)
def test_a_dynamic_tessellation_is_that_of_its_sites(metric):
    sites = np.column_stack([RNG.integers(0, 9, (50, 2)), RNG.integers(0, 3, 50)]).astype(float)
    d = signum.DynamicTessellation(metric)
    assert d.insert(sites[:30]).tolist() == list(range(30))
    for site in sites[30:]:
        d.insert(site)
    assert same(d.tessellation(), signum.triangulate(sites, metric))
    d.erase([3, 7, 49])
    rest = np.delete(sites, [3, 7, 49], axis=0)
    assert same(d.tessellation(), signum.triangulate(rest, metric))
    assert 3 not in d and 4 in d and len(d) == 47
    d.move(0, (4.5, 4.5))
    d.change(1, 2.5)
    rest[0, :2], rest[1, 2] = 4.5, 2.5
    assert same(d.tessellation(), signum.triangulate(rest, metric))
    assert d.site(1) == tuple(rest[1])
    rest[:, :2] += RNG.uniform(-0.1, 0.1, (47, 2))
    d.move_all(rest[:, :2])
    assert same(d.tessellation(), signum.triangulate(rest, metric))
    assert d.insertions >= 50 and sum(d.moves.values()) == 2
    assert d.insert([1, 1]) == 3, "the least handle that is free"


def test_what_a_dynamic_tessellation_refuses():
    d = signum.DynamicTessellation("power", sites=[[0, 0], [1, 0], [0, 1]])
    with pytest.raises(ValueError, match="row 1 is not finite"):
        d.insert([[0, 0], [np.nan, 0]])
    assert len(d) == 3
    for wrong in (lambda: d.erase(5), lambda: d.move(5, (0, 0)), lambda: d.site(-1)):
        with pytest.raises(IndexError, match="5|-1"):
            wrong()
    with pytest.raises(IndexError, match="99"):
        d.erase([0, 99])
    with pytest.raises(ValueError, match="twice"):
        d.erase([1, 0, 1])
    assert len(d) == 3, "nothing was erased"
    with pytest.raises(ValueError, match="2 centres for 3"):
        d.move_all([[0, 0], [1, 1]])
    with pytest.raises(ValueError, match="weight"):
        signum.DynamicTessellation("euclidean", weight_is="weight")


def test_a_kinetic_tessellation_is_that_of_its_places():
    sites = np.column_stack(
        [RNG.uniform(0, 10, (30, 2)), RNG.uniform(0, 1, 30), RNG.uniform(-1, 1, (30, 2))]
    )
    k = signum.KineticTessellation(sites)
    joined = {tuple(e) for e in k.tessellation().edges().tolist() if e[0] >= 0}
    changes = 0
    for time in (0.5, 1.25, 4.0):
        log = k.advance(time, log=True)
        for _, a, b, comes in log.tolist():
            assert a < b and ((a, b) in joined) != comes
            joined ^= {(a, b)}
        assert (np.diff(log["time"]) >= 0).all() and (log["time"] <= time).all()
        changes += len(log)
        assert k.time == time and k.next_event() > time
        there = np.column_stack([sites[:, :2] + time * sites[:, 3:], sites[:, 2]])
        t = signum.triangulate(there, "power")
        assert np.array_equal(k.faces(), t.faces[t.faces[:, 0] >= 0])
        assert joined == {tuple(e) for e in t.edges().tolist() if e[0] >= 0}
        assert same(k.tessellation(), t)
    assert changes > 20 and k.statistics["events"] > 0
    assert k.advance(5.0) is None
    k.erase(4)
    k.change(0, sites[0])
    assert k.insert([5, 5, 1, 0, 0]) == 4 and len(k) == 30
    assert k.site(0) == (*sites[0, :2], sites[0, 2], *sites[0, 3:], 0.0)
    for wrong in (4.0, np.inf, np.nan):
        with pytest.raises(ValueError):
            k.advance(wrong)


def test_newtons_cradle():
    balls = [[2.0 * i, 0, 1, 1.0 * (i == 0), 0, 1] for i in range(4)]
    balls[0][0] = -3.0
    simulation = signum.Simulation(balls)
    run = simulation.run(10)
    assert run.ending == "nothing", "nothing meets any more"
    assert run.log["time"].tolist() == [3, 3, 3]
    assert list(zip(run.log["a"], run.log["b"])) == [(0, 1), (1, 2), (2, 3)]
    assert not run.log["wall"].any() and run.log["impulse"].tolist() == [1, 1, 1]
    state = simulation.state()
    assert state.v.tolist() == [[0, 0], [0, 0], [0, 0], [1, 0]]
    assert state.centres(10)[3].tolist() == [13, 0]
    assert simulation.counts["strikes"] == 3 and len(state) == 4 and state.mass.tolist() == [1] * 4


def test_the_log_does_not_depend_on_the_structure():
    x, y = np.meshgrid(np.arange(1, 10, 2.0), np.arange(1, 10, 2.0))
    gas = np.column_stack([x.ravel(), y.ravel(), np.full(25, 0.5), RNG.normal(size=(25, 2))])
    runs = [
        signum.Simulation(gas, box=((0, 0), (10, 10)), structure=s).run(20)
        for s in ("auto", "pairs", "cells", "delaunay")
    ]
    assert len(runs[0].log) > 100
    assert all(np.array_equal(run.log, runs[0].log) for run in runs)
    # In two steps, and by a number of strikes.
    simulation = signum.Simulation(gas, box=((0, 0), (10, 10)))
    first = simulation.run(strikes=50)
    assert first.ending == "strikes" and len(first.log) == 50
    assert np.array_equal(np.concatenate([first.log, simulation.run(20).log]), runs[0].log)
    assert signum.Simulation(gas, box=((0, 0), (10, 10))).run(20, log=False).log.size == 0


def test_a_ball_that_falls():
    ball = [[0, 2, 1, 0, 0]]
    run = signum.Simulation(ball, gravity=(0, -2), obstacles=[effects.HalfSpace((0, 1), 0)]).run(2.5)
    assert run.log.tolist() == [(1.0, True, 0, 4, 4.0)]  # twice the momentum, 1 m times 2 m/s
    half = signum.Simulation(ball, gravity=(0, -2), wall_restitution=0.5, box=((-5, 0), (5, 9))).run(2.5)
    assert half.log["time"].tolist() == [1.0, 2.0, 2.5] and set(half.log["b"]) == {2}


def test_in_space_and_effects():
    balls = [[0, 0, 0, 1, 1, 0, 0], [5, 0, 0, 1, 0, 0, 0]]
    simulation = signum.Simulation(balls, friction=effects.Friction(0.1), restitution=0.5)
    assert simulation.run(10).log["time"].tolist() == [3.0]
    state = simulation.state()
    assert state.dimension == 3 and state.x.shape == (2, 3)
    assert state.v[:, 0].tolist() == [0.25, 0.75]
    a, b, gap = state.closest_pair()
    assert (a, b) == (0, 1)
    wall = effects.Segment((3, -1), (3, 1))
    assert signum.Simulation([[0, 0, 1, 1, 0]], obstacles=[wall]).run(9).log["time"].tolist() == [2.0]
    ring = effects.Sphere((0, 0), 4, inside=True)
    assert signum.Simulation([[0, 0, 1, 1, 0]], obstacles=[ring]).run(4).log["time"].tolist() == [3.0]
    grown = signum.Simulation([[0, 0, 1, 0, 0], [4, 0, 1, 0, 0]], growth=effects.Growth(0.5, 9))
    assert grown.run(3).log["time"][0] == 2.0


def test_what_a_simulation_refuses():
    with pytest.raises(ValueError, match="row 1"):
        signum.Simulation([[0, 0, 1, 0, 0], [1, 0, 1, 0, 0]])
    with pytest.raises(ValueError, match="row 0"):
        signum.Simulation([[0, 0, -1, 0, 0]])
    with pytest.raises(ValueError, match="5 to 8 columns"):
        signum.Simulation([[0, 0, 1]])
    with pytest.raises(ValueError, match="structure"):
        signum.Simulation([[0, 0, 1, 0, 0]], structure="magic")
    with pytest.raises(TypeError, match="gravitation"):
        signum.Simulation([[0, 0, 1, 0, 0]], gravitation=1)
    with pytest.raises(ValueError, match="2 numbers"):
        signum.Simulation([[0, 0, 1, 0, 0]], gravity=(1, 2, 3))
    with pytest.raises(ValueError, match="restitution"):
        signum.Simulation([[0, 0, 1, 0, 0]], restitution=2.0)
    for strikes in (-1, 2**64, 0.5):
        with pytest.raises(ValueError, match="strikes"):
            signum.Simulation([[0, 0, 1, 0, 0]]).run(strikes=strikes)
    with pytest.raises(ValueError, match="Segment"):
        signum.Simulation([[0, 0, 0, 1, 0, 0, 0]], obstacles=[effects.Segment((0, 1), (1, 1))])


@contextlib.contextmanager
def control_word(more):
    """The floating-point environment of this thread with more bits in the control word of SSE."""
    libm = ctypes.CDLL("libm.so.6")
    before, other = (ctypes.c_uint32 * 8)(), (ctypes.c_uint32 * 8)()
    libm.fegetenv(before)
    libm.fegetenv(other)
    other[7] |= more
    libm.fesetenv(other)
    try:
        yield
    finally:
        libm.fesetenv(before)


@pytest.mark.skipif(
    platform.machine() != "x86_64" or platform.libc_ver()[0] != "glibc", reason="its control word"
)
def test_arguments_are_judged_alike_in_every_environment():
    u, two, three, negative = 5e-324, 1e-323, 1.5e-323, -5e-324
    denormals_are_zero, upward = 0x8040, 0x4000
    # The fifth leaves the square at three.
    corners = [[0, 0, 0, 0, 0], [8, 0, 0, 0, 0], [8, 8, 0, 0, 0], [0, 8, 0, 0, 0]]
    sites = np.array([*corners, [4, three, 0, 0, -1]])
    expected = signum.KineticTessellation(sites)
    expected.advance(two)
    event, faces = expected.next_event(), expected.faces()
    assert event == three and len(faces) == 4
    moving = signum.KineticTessellation(sites)
    refused = []
    with control_word(denormals_are_zero):
        moving.advance(two)
        next_event, found = moving.next_event(), moving.faces()
        for call in (
            lambda: moving.advance(u),
            lambda: signum.meeting_time([0, 0, 1, 1, 0], [9, 0, negative, 0, 0]),
        ):
            try:
                call()
            except ValueError:
                refused.append(call)
    assert next_event.hex() == event.hex() and np.array_equal(found, faces)
    assert len(refused) == 2 and moving.time.hex() == two.hex()
    balls = np.array([[9 * i, 0, 0.1 + 0.05 * i, 0, 0] for i in range(8)])
    masses = signum.Simulation(balls).state().mass
    with control_word(upward):
        in_upward = signum.Simulation(balls).state().mass
    assert in_upward.tobytes() == masses.tobytes()
