import itertools
import math

import exact
import numpy as np
import pytest

import signum

METRICS = ("power", "euclidean", "manhattan", "supremum")
README = [[0, 0, 1], [4, 0, 2], [0, 3, 1], [4, 1, 0.5]]


def some_sites(n=60, seed=1):
    """Small integers: sites that touch, nest, coincide and lie on common circles."""
    rng = np.random.default_rng(seed)
    return np.column_stack([rng.integers(0, 9, (n, 2)), rng.integers(0, 3, n)]).astype(float)


def test_the_example_of_the_readme():
    t = signum.triangulate(README)
    assert t.faces.tolist() == [[-1, 0, 2], [-1, 1, 0], [-1, 2, 1], [0, 1, 2]]
    assert t.hidden.tolist() == [[3, 1]]
    assert (t.metric, t.weight_is, len(t)) == ("euclidean", "radius", 4)


@pytest.mark.parametrize("metric", METRICS)
def test_degenerate_sites_have_one_valid_result(metric):
    sites = some_sites()
    t = signum.triangulate(sites, metric)
    judged = t.validate()
    assert judged and judged.canonical, judged
    for seed in range(3):
        assert np.array_equal(signum.triangulate(sites, metric, seed=seed).faces, t.faces)
    visible = len(sites) - len(t.hidden)
    assert len(t.faces) == len(t.neighbours) == 2 * visible - 2
    assert len(t.edges()) == 3 * visible - 3


@pytest.mark.parametrize("metric, method", [("power", "flips"), ("manhattan", "sweep"), ("supremum", "sweep")])
def test_methods_give_the_same(metric, method):
    t = signum.triangulate(some_sites(), metric)
    other = signum.triangulate(some_sites(), metric, method=method)
    assert np.array_equal(t.faces, other.faces) and np.array_equal(t.hidden, other.hidden)


@pytest.mark.parametrize("arithmetic", ["interval", "sum", "multiprecision"])
def test_exact_arithmetics_give_the_same(arithmetic):
    t = signum.triangulate(some_sites(30), "power")
    assert np.array_equal(signum.triangulate(some_sites(30), "power", arithmetic=arithmetic).faces, t.faces)


def test_faces_have_empty_circles_in_rationals():
    points = np.array(list(itertools.product(range(3), repeat=2)) + [[0.1, 0.1], [0.3, 0.1 + 0.2]])
    t = signum.triangulate(points, "power")
    finite = {tuple(face) for face in t.faces.tolist() if face[0] >= 0}
    assert finite <= exact.empty_circle_faces(points.tolist())
    # The rule of ties chooses among those; the area says that the chosen ones cover the hull once.
    corners = points[[list(face) for face in finite]]
    twice = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert math.isclose(twice.sum(), 8.0)


def test_neighbours_lie_across():
    t = signum.triangulate(some_sites(), "power")
    for f, face in enumerate(t.faces):
        for k in range(3):
            across = t.faces[t.neighbours[f, k]]
            assert {face[(k + 1) % 3], face[(k + 2) % 3]} <= set(across)


def test_vertices_are_the_nearest_doubles():
    t = signum.triangulate(some_sites(), "power")
    vertices = t.vertices()
    finite = (t.faces >= 0).all(axis=1)
    assert np.isnan(vertices[~finite]).all()
    assert (np.isfinite(vertices[finite])).all()
    face, vertex = t.faces[finite][0], vertices[finite][0]
    for site in t.sites[face]:
        assert math.isclose(exact.power_distance(vertex[:2], site), vertex[2], rel_tol=1e-14, abs_tol=1e-12)


def test_locate_and_nearest_agree_with_rationals():
    sites = some_sites(20)
    t = signum.triangulate(sites, "power")
    points = np.random.default_rng(2).uniform(-1, 10, (50, 2))
    nearest = t.nearest(points)
    assert nearest.dtype == np.int32
    for p, site, face in zip(points, nearest, t.locate(points)):
        least = min(exact.power_distance(p, s) for s in sites)
        assert exact.power_distance(p, sites[site]) == least
        a, b, c = t.faces[face]
        if a >= 0:
            a, b, c = sites[[a, b, c], :2]
            assert min(exact.ccw(a, b, p), exact.ccw(b, c, p), exact.ccw(c, a, p)) >= 0
    assert t.nearest(points[0]) == nearest[0] and isinstance(t.nearest(points[0]), int)
    assert isinstance(t.locate([1, 1]), int)


def test_neighbours_of_a_site():
    t = signum.triangulate(README)
    assert sorted(t.neighbours_of(0)) == [-1, 1, 2]
    assert len(t.neighbours_of(3)) == 0
    with pytest.raises(IndexError, match="site 4"):
        t.neighbours_of(4)


def test_may_share_edge():
    t = signum.triangulate([[0, 0], [1, 0], [0, 1], [1, 1], [5, 0.5]], "power")
    # Both diagonals of a square are right; what crosses it to the point far off is not.
    assert t.may_share_edge([[0, 3], [1, 2], [0, 4]]).tolist() == [True, True, False]
    with pytest.raises(IndexError):
        t.may_share_edge([[0, 9]])


def test_validate_tells_what_is_wrong():
    t = signum.triangulate(some_sites(), "power")
    assert signum.validate(t.sites, t.faces, "power", neighbours=t.neighbours, hidden=t.hidden).canonical
    broken = t.faces.copy()
    broken[-1] = broken[-2]
    judged = signum.validate(t.sites, broken, "power", hidden=t.hidden)
    assert not judged and judged.message
    # Either diagonal of a square is valid; the rule of ties chooses one.
    square = np.array([[0.0, 0], [1, 0], [0, 1], [1, 1]])
    hull = [[-1, 1, 0], [-1, 3, 1], [-1, 2, 3], [-1, 0, 2]]
    choices = [[[0, 1, 2], [1, 3, 2]], [[0, 1, 3], [0, 3, 2]]]
    assert all(signum.validate(square, choice + hull, "power") for choice in choices)
    chosen = signum.triangulate(square, "power").faces.tolist()
    assert sum(all(face in chosen for face in choice) for choice in choices) == 1


def test_statistics():
    assert signum.triangulate(README).statistics["in_circle"] is None
    counted = signum.triangulate(some_sites(), count=True).statistics
    assert counted["in_circle"] > 0 and counted["seconds"] >= 0


@pytest.mark.parametrize("n", [0, 1, 2])
def test_few_sites(n):
    t = signum.triangulate(np.zeros((n, 2)) + np.arange(n)[:, None])
    assert len(t.faces) == max(2 * n - 2, 0) and t.faces.shape[1] == 3
    assert t.nearest([0.0, 0.0]) == (0 if n else -1)


def test_simplices_of_others_are_judged():
    points = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]], float)
    simplices = np.array([[0, 1, 4], [2, 4, 1], [3, 2, 4], [0, 4, 3]])
    assert signum.validate(points, simplices)
    judged = signum.validate(points, [[0, 1, 2], [2, 3, 0], [0, 1, 3]])
    assert not judged and not judged.valid
    assert judged.faults.tolist() == [0, 1, 2] and judged.kinds == ["overlap"] * 3
    assert judged.missing.tolist() == [4] and judged.open == []
    assert "same side" in judged.message and "same side" in repr(judged)
    # With infinity, or a metric, faces are those of a tessellation.
    t = signum.triangulate(points, "power")
    assert signum.validate(points, t.faces, "power", neighbours=t.neighbours).canonical
    assert isinstance(signum.validate(points, simplices, "power"), signum.Validation)
    # Weights: the middle one is hidden where it weighs too little.
    weighted = np.column_stack([points, [0, 0, 0, 0, -9.0]])
    assert not signum.validate(weighted, simplices, weight_is="weight")
    assert signum.validate(weighted, [[0, 1, 2], [2, 3, 0]], weight_is="weight")
    tetrahedra = [[0, 1, 2, 3], [4, 2, 1, 3]]
    corners = [[0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 3], [3, 3, 3]]
    assert signum.validate(corners, tetrahedra)
    assert signum.validate(corners, tetrahedra[:1]).missing.tolist() == [4]
