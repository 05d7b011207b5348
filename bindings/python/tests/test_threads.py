"""Ctrl-C, progress, and other threads while a call is running."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import signum

SITES = np.random.default_rng(17).uniform(0, 1, (300_000, 2))

INTERRUPTED = """
import os, signal, sys, threading, time
import numpy as np, signum
sites = np.random.default_rng(1).uniform(0, 1, (400_000, 3)) * [1, 1, 1e-6]
balls = np.random.default_rng(1).uniform(0, 1, (300, 5)) * [1, 1, 1e-6, 1, 1]
work = {
    "plane": lambda: signum.triangulate(np.tile(sites, (5, 1)) + np.arange(5.0).repeat(400_000)[:, None] * [1, 0, 0]),
    "simulation": lambda: signum.Simulation(balls, box=((-1, -1), (2, 2))).run(log=False),
    "moving": lambda: signum.KineticTessellation(np.tile(balls, (640, 1)) + np.random.default_rng(2).normal(size=(192_000, 5))).advance(1e9),
    "predicates": lambda: signum.ccw(sites[:4000, None, :2], sites[None, :, :2], sites[0, :2]),
}[sys.argv[1]]
threading.Thread(target=lambda: (time.sleep(1), os.kill(os.getpid(), signal.SIGINT)), daemon=True).start()
began = time.monotonic()
try:
    work()
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - began)
else:
    print("done", time.monotonic() - began)
"""


@pytest.mark.parametrize("work", ["plane", "simulation", "moving", "predicates"])
def test_ctrl_c_ends_a_long_call(work):
    done = subprocess.run(
        [sys.executable, "-c", INTERRUPTED, work], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr
    how, seconds = done.stdout.split()
    assert how == "interrupted" and float(seconds) < 10


def test_progress_is_told_and_may_stop():
    # A word ten times a second: of few sites a quick machine says none.
    for number in (300_000, 1_200_000, 4_800_000):
        sites = np.random.default_rng(17).uniform(0, 1, (number, 2))
        shares = []
        signum.triangulate(sites, "euclidean", progress=shares.append)
        if shares:
            break
    assert shares and shares == sorted(shares) and 0 <= shares[0] <= shares[-1] <= 1

    def stop(_):
        raise RuntimeError("enough")

    # So many more that it is told even where the first ones were told late.
    sites = np.random.default_rng(18).uniform(0, 1, (4 * number, 2))
    with pytest.raises(RuntimeError, match="enough"):
        signum.triangulate(sites, "euclidean", progress=stop)


def test_other_threads_run_meanwhile():
    """A counter in Python goes on while triangulate() is at work in this thread."""
    # With the lock held it could go on for one interval of a few milliseconds at either end. On a busy machine it may
    # not have had its turn: once is enough.
    assert any(counted_meanwhile() > 20_000 for _ in range(20))


def counted_meanwhile():
    count, done = 0, threading.Event()

    def counting():
        nonlocal count
        while not done.is_set():
            count += 1

    other = threading.Thread(target=counting)
    other.start()
    before = count
    signum.triangulate(SITES, "power")
    during = count - before
    done.set()
    other.join()
    return during


def test_several_threads_get_the_same():
    sites = SITES[:20_000]
    expected = signum.triangulate(sites, "power").faces
    results = [None] * 4

    def work(k):
        results[k] = signum.triangulate(sites, "power", seed=k).faces

    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(faces, expected) for faces in results)


def test_what_changes_is_used_by_one_at_a_time():
    dynamic = signum.DynamicTessellation("power")
    refused = []

    def insert():
        try:
            dynamic.insert(SITES[:100_000])
        except RuntimeError as error:
            refused.append(str(error))

    thread = threading.Thread(target=insert)
    thread.start()
    deadline = time.monotonic() + 30
    while not refused and thread.is_alive() and time.monotonic() < deadline:
        try:
            len(dynamic)
        except RuntimeError as error:
            refused.append(str(error))
    thread.join()
    assert refused == ["another call is using this object"]
    assert len(dynamic) in (0, 100_000)


def test_a_simulation_goes_on_after_its_callback_has_stopped_it():
    balls = np.random.default_rng(1).uniform(0, 1, (300, 5)) * [1, 1, 1e-4, 1, 1]
    box = ((-1, -1), (2, 2))
    simulation = signum.Simulation(balls, box=box)

    def stop(_):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        simulation.run(log=False, progress=stop)
    done = int(simulation.counts["strikes"])
    assert done > 0
    whole = signum.Simulation(balls, box=box).run(strikes=done + 100).log
    assert np.array_equal(simulation.run(strikes=100).log, whole[done:])


def test_the_signal_handler_is_left_as_it_was():
    before = signal.getsignal(signal.SIGINT)
    signum.triangulate(SITES[:100])
    assert signal.getsignal(signal.SIGINT) is before


@pytest.mark.parametrize("metric", ("power", "supremum"))
def test_any_number_of_threads_works_on_one_call(metric):
    sites = np.random.default_rng(2).uniform(0, 1000, (30_000, 3)) * [1, 1, 1e-3]
    t = signum.triangulate(sites, metric, threads=1)
    said = t.validate(threads=1)
    cells = signum.voronoi(t, threads=1).clip()
    for threads in (0, 2, 3):
        other = signum.triangulate(sites, metric, threads=threads)
        assert np.array_equal(other.faces, t.faces)
        assert repr(other.validate(threads=threads)) == repr(said)
        assert np.array_equal(signum.voronoi(t, threads=threads).clip().areas, cells.areas)
    assert signum.validate(sites, t.faces, metric, neighbours=t.neighbours, hidden=t.hidden, threads=2)


@pytest.mark.parametrize("threads", (-1, 1025))
def test_a_number_of_threads_that_there_is_not_is_refused(threads):
    for call in (
        lambda: signum.triangulate(SITES[:10], threads=threads),
        lambda: signum.triangulate_space([[0, 0, 0]], threads=threads),
        lambda: signum.validate(SITES[:10], [], threads=threads),
        lambda: signum.voronoi(signum.triangulate(SITES[:10]), threads=threads),
    ):
        with pytest.raises(ValueError, match="threads"):
            call()
