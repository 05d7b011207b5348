import itertools
import math

import exact
import numpy as np
import pytest

import signum

RNG = np.random.default_rng(11)
LATTICE = np.array(list(itertools.product(range(3), repeat=3)), float)
BALLS = np.column_stack([RNG.integers(0, 6, (80, 3)), RNG.integers(0, 3, 80)]).astype(float)


def test_degenerate_sites_have_one_valid_result():
    for sites in (LATTICE, BALLS, RNG.uniform(0, 1, (50, 3))):
        t = signum.triangulate_space(sites)
        judged = t.validate()
        assert judged and judged.canonical, judged
        assert np.array_equal(signum.triangulate_space(sites, seed=9).cells, t.cells)
        assert np.array_equal(t.sites, sites)
    assert len(signum.triangulate_space(BALLS).hidden) > 0


def test_cells_are_empty_in_rationals():
    t = signum.triangulate_space(BALLS[:25])
    for cell in t.cells[(t.cells >= 0).all(axis=1)]:
        corners = BALLS[cell]
        assert exact.ccw_in_space(*corners[:, :3]) > 0
        assert all(exact.power_in_sphere(*corners, q) <= 0 for q in BALLS[:25])


def test_strided_sites_and_weights():
    wide = np.zeros((len(BALLS), 9))
    wide[:, 1:8:2] = BALLS
    cells = signum.triangulate_space(BALLS).cells
    assert np.array_equal(signum.triangulate_space(wide[:, 1:8:2]).cells, cells)
    weights = np.column_stack([BALLS[:, :3], BALLS[:, 3] ** 2])
    t = signum.triangulate_space(weights, weight_is="weight")
    assert np.array_equal(t.cells, cells) and t.weight_is == "weight"


def test_neighbours_edges_vertices():
    t = signum.triangulate_space(BALLS)
    for c, cell in enumerate(t.cells):
        for k in range(4):
            assert set(np.delete(cell, k)) <= set(t.cells[t.neighbours[c, k]])
    pairs = {tuple(sorted(p)) for cell in t.cells.tolist() for p in itertools.combinations(cell, 2)}
    assert list(map(tuple, t.edges().tolist())) == sorted(pairs)
    finite = (t.cells >= 0).all(axis=1)
    vertices = t.vertices()
    assert np.isnan(vertices[~finite]).all()
    for cell, vertex in zip(t.cells[finite][:20], vertices[finite]):
        for site in BALLS[cell]:
            assert math.isclose(exact.power_distance(vertex[:3], site), vertex[3], abs_tol=1e-9)


def test_flat_sites():
    flat = signum.triangulate_space(np.column_stack([LATTICE[:9, 1:], np.zeros(9)]))
    assert flat.dimension == 2 and flat.cells.shape[1] == 3 and flat.validate()
    line = signum.triangulate_space([[0, 0, 0], [1, 1, 1], [3, 3, 3]])
    assert line.dimension == 1 and line.cells.shape[1] == 2
    assert signum.triangulate_space(np.zeros((0, 3))).dimension == -1


def test_cells_in_a_box():
    cells = signum.triangulate_space(LATTICE).clip([[-0.5] * 3, [2.5] * 3])
    assert np.array_equal(cells.volumes, np.ones(27)) and np.array_equal(cells.areas, np.full(27, 6.0))
    assert np.array_equal(cells.centroids, LATTICE)
    assert (np.diff(cells.first_face) == 6).all() and (cells.face_areas == 1).all()
    middle = cells.face_beyond[cells.first_face[13] : cells.first_face[14]]
    assert sorted(middle) == [4, 10, 12, 14, 16, 22]
    corners, faces, beyond = cells.polyhedron(0)
    assert len(corners) == 8 and len(faces) == 6 and sorted(beyond) == [-5, -3, -1, 1, 3, 9]

    cells = signum.triangulate_space(BALLS).clip(((-1, -1, -1), (7, 7, 7)))
    assert math.isclose(cells.volumes.sum(), 512, rel_tol=1e-9)
    assert (cells.volumes[cells.tessellation.hidden[:, 0]] == 0).all()


def test_what_is_refused():
    with pytest.raises(ValueError, match="site 1 is not finite"):
        signum.triangulate_space([[0, 0, 0], [0, np.nan, 0]])
    with pytest.raises(ValueError, match="3 to 4 columns"):
        signum.triangulate_space(np.zeros((4, 2)))
    with pytest.raises(ValueError):
        signum.triangulate_space(LATTICE, arithmetic="sum")
    with pytest.raises(ValueError):
        signum.triangulate_space(LATTICE).clip([[1, 1, 1], [0, 2, 2]])
