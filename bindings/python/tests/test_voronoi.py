import math

import numpy as np
import pytest

import signum

METRICS = ("power", "euclidean", "manhattan", "supremum")
SITES = np.column_stack([np.random.default_rng(7).uniform(0, 10, (40, 2)), np.arange(40) % 5 / 5])
BOX = (-1, -2, 11, 12)


def area(polygon):
    x, y = polygon.T
    return (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2


@pytest.mark.parametrize("metric", METRICS)
def test_cells_tile_the_box(metric):
    cells = signum.voronoi(signum.triangulate(SITES, metric)).clip(BOX)
    assert cells.box == BOX and len(cells) == 40
    assert math.isclose(cells.areas.sum(), 12 * 14, rel_tol=1e-12)
    # The whole's centroid is the middle.
    visible = cells.areas > 0
    middle = (cells.areas[visible, None] * cells.centroids[visible]).sum(0) / cells.areas.sum()
    assert np.allclose(middle, [5, 5], atol=1e-9)
    points, first, sites = cells.polygons(1e-6)
    of_site = np.zeros(40)
    for site, begin, end in zip(sites, first[:-1], first[1:]):
        of_site[site] += area(points[begin:end])
    assert np.allclose(of_site, cells.areas, atol=1e-4)
    assert np.array_equal(points[: first[1]], cells.polygon(sites[0], 1e-6)[0])


def test_cells_of_a_lattice_are_squares():
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0))
    t = signum.triangulate(np.column_stack([x.ravel(), y.ravel()]), "power")
    v = signum.voronoi(t, merge=True)
    cells = v.clip((-0.5, -0.5, 3.5, 3.5))
    assert np.array_equal(cells.areas, np.ones(16)) and np.array_equal(cells.perimeters, np.full(16, 4.0))
    assert np.array_equal(cells.centroids, t.sites[:, :2])
    assert len(v.vertices) == 9, "merged"
    assert len(signum.voronoi(t).vertices) == 18


def test_the_diagram():
    v = signum.voronoi(signum.triangulate(SITES))
    t = v.tessellation
    assert np.array_equal(t.sites, SITES)
    vertices = t.vertices()
    with_vertex = v.vertex_of_face >= 0
    assert np.array_equal(v.vertices[v.vertex_of_face[with_vertex]], vertices[with_vertex])
    left, right, start, end, _, _ = v.edges.T
    for at in (start, end):
        ends = at >= 0
        x, y, rho = v.vertices[at[ends]].T
        for side in (left, right):
            sx, sy, r = SITES[side[ends]].T
            assert np.allclose(np.hypot(x - sx, y - sy) - r, rho, atol=1e-9)
    hidden = set(t.hidden[:, 0])
    for site in range(40):
        cell = v.cell(site)
        assert v.is_hidden(site) == (site in hidden) == (len(cell) == 0)
        for edge, forward in cell:
            assert v.edges[edge, 0 if forward else 1] == site
    kinds = {v.edge_kind(e) for e in range(len(v.edges))}
    assert "hyperbola" in kinds and "segment" in kinds
    assert any(v.is_unbounded(s) for s in range(40))


def test_lines_of_edges_lie_between_their_sites():
    v = signum.voronoi(signum.triangulate(SITES))
    cells = v.clip(BOX)
    assert sum(len(cells.edge_lines(e)) > 0 for e in range(len(v.edges))) > 60
    for edge in range(len(v.edges)):
        (ax, ay, ar), (bx, by, br) = SITES[v.edges[edge, :2]]
        for line in cells.edge_lines(edge, 1e-9):
            x, y = line.T
            assert np.allclose(np.hypot(x - ax, y - ay) - ar, np.hypot(x - bx, y - by) - br, atol=1e-6)


def test_what_cells_refuse():
    v = signum.voronoi(signum.triangulate(SITES))
    for box in ((0, 0, 0, 1), (0, 0, 1), (0, 0, np.nan, 1)):
        with pytest.raises(ValueError):
            v.clip(box)
    cells = v.clip()
    with pytest.raises(ValueError):
        cells.polygon(0, -1.0)
    for call in (cells.polygon, v.cell, v.is_hidden):
        with pytest.raises(IndexError):
            call(40)


def test_cells_outlive_their_diagram():
    areas = signum.voronoi(signum.triangulate(SITES)).clip(BOX).areas
    assert math.isclose(areas.sum(), 168, rel_tol=1e-12)
