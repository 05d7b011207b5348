"""Drawing: what lands on the axes is what the results say."""

import matplotlib

matplotlib.use("Agg")

import numpy as np
import pytest
from matplotlib import pyplot
from matplotlib.collections import LineCollection, PatchCollection, PolyCollection

import signum
from signum import plot

RNG = np.random.default_rng(19)
SITES = np.column_stack([RNG.uniform(0, 10, (20, 2)), RNG.uniform(0.1, 1, 20)])
PLACES = np.array([(3.0 * x, 3.0 * y) for x in range(5) for y in range(4)])
MOVING = np.column_stack([PLACES, SITES[:, 2], RNG.uniform(-1, 1, (20, 2))])


@pytest.fixture(autouse=True)
def close():
    yield
    pyplot.close("all")


def collected(ax, kind):
    return [c for c in ax.collections if type(c) is kind]


@pytest.mark.parametrize("metric", ["power", "euclidean", "manhattan", "supremum"])
def test_a_tessellation_is_its_edges_and_its_sites(metric):
    t = signum.triangulate(SITES, metric)
    ax = plot.draw(t)
    (lines,) = collected(ax, LineCollection)
    edges = t.edges()
    edges = edges[edges[:, 0] >= 0]
    assert np.array_equal(np.array(lines.get_segments()), SITES[edges, :2])
    visible, hidden = collected(ax, PatchCollection)
    assert len(visible.get_paths()) == 20 - len(t.hidden)
    assert len(hidden.get_paths()) == len(t.hidden)
    ax.figure.canvas.draw()


def test_cells_are_polygons_within_the_box():
    _, ax = pyplot.subplots()
    v = signum.voronoi(signum.triangulate(SITES))
    assert plot.draw(v.clip((0, 0, 10, 10)), ax=ax, edgecolor="red") is ax
    (cells,) = collected(ax, PolyCollection)
    points, first, _ = v.clip((0, 0, 10, 10)).polygons()
    assert len(cells.get_paths()) == len(first) - 1
    assert np.array_equal(cells.get_paths()[0].vertices[:-1], points[: first[1]])
    assert ax.get_xlim() == (0, 10) and ax.get_ylim() == (0, 10)
    assert collected(plot.draw(v), PolyCollection)


def test_what_lies_in_space():
    t = signum.triangulate_space(np.column_stack([SITES, SITES[:, 0] / 9]))
    ax = plot.draw(t)
    assert ax.name == "3d"
    plot.draw(t.clip()).figure.canvas.draw()


def test_what_moves():
    for result in (
        signum.DynamicTessellation(sites=SITES),
        signum.KineticTessellation(MOVING),
        signum.Simulation(MOVING),
        signum.Simulation(MOVING).state(),
        signum.Simulation([[0, 0, 0, 1, 0, 0, 0]]),
    ):
        plot.draw(result).figure.canvas.draw()
    with pytest.raises(TypeError, match="no picture of a dict"):
        plot.draw({})


@pytest.mark.parametrize("moving", ["simulation", "kinetic"])
def test_an_animation_runs_what_it_shows(moving, tmp_path):
    if moving == "simulation":
        what = signum.Simulation(MOVING, box=((-2, -2), (15, 15)))
        time = lambda: what.state().time
    else:
        what = signum.KineticTessellation(MOVING)
        time = lambda: what.time
    _, ax = pyplot.subplots(figsize=(1, 1))
    animation = plot.animate(what, [0.0, 0.5, 1.0], ax)
    animation.save(tmp_path / "moving.gif", writer="pillow", dpi=20)
    assert time() == 1.0 and ax.get_title() == "t = 1"
    assert (tmp_path / "moving.gif").read_bytes()[:3] == b"GIF"
    with pytest.raises(TypeError, match="does not move"):
        plot.animate(signum.triangulate(SITES), [0.0])
