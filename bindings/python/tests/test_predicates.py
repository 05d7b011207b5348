import itertools
from fractions import Fraction

import exact
import numpy as np
import pytest

import signum

RNG = np.random.default_rng(5)
GRID = np.array(list(itertools.product([0.0, 0.1, 0.2, 0.1 + 0.2], repeat=2)))


def test_ccw_in_rationals():
    a, b, c = GRID[RNG.integers(0, 16, (3, 300))]
    signs = signum.ccw(a, b, c)
    assert signs.dtype == np.int8 and set(signs) == {-1, 0, 1}
    assert signs.tolist() == [exact.ccw(*abc) for abc in zip(a, b, c)]


def test_ccw_of_space_in_rationals():
    a, b, c, d = RNG.integers(0, 3, (4, 200, 3)) / 10
    assert signum.ccw(a, b, c, d).tolist() == [exact.ccw_in_space(*abcd) for abcd in zip(a, b, c, d)]


def test_shapes_are_matched():
    a, b, c = RNG.integers(0, 4, (3, 5, 2)).astype(float)
    all_of_them = signum.ccw(a[:, None, None], b[:, None], c)
    assert all_of_them.shape == (5, 5, 5)
    for i, j, k in itertools.product(range(5), repeat=3):
        assert all_of_them[i, j, k] == exact.ccw(a[i], b[j], c[k])
    assert signum.ccw(a[0], b, c[::-1]).shape == (5,)
    assert signum.ccw(a[:0], b[:0], c[0]).shape == (0,)
    scalar = signum.ccw([0, 0], [1, 0], [0, 1])
    assert type(scalar) is int and scalar == 1
    with pytest.raises(ValueError, match="does not match"):
        signum.ccw(a, b[:3], c)
    with pytest.raises(ValueError, match="a: 2 numbers"):
        signum.ccw([[0, 0, 0]], b, c)


def test_in_circle_of_the_power_metric_in_rationals():
    sites = np.column_stack([RNG.integers(0, 4, (400, 2)), RNG.integers(0, 2, 400)]) / 10.0
    i, j, k, q = sites.reshape(4, 100, 3)
    there = signum.exists(i, j, k, "power")
    assert there.dtype == bool and there.tolist() == [exact.ccw(*s) > 0 for s in zip(i, j, k)]
    i, j, k, q = (s[there] for s in (i, j, k, q))
    signs = signum.in_circle(i, j, k, q, "power")
    assert signs.tolist() == [exact.power_in_circle(*s) for s in zip(i, j, k, q)]
    assert 0 in signs
    weights = [np.column_stack([s[:, :2], s[:, 2] ** 2]) for s in (i, j, k, q)]
    of_weights = signum.in_circle(*weights, "power", weight_is="weight")
    assert (of_weights == signs).mean() > 0.9  # 0.1 ** 2 is not the square of 0.1


@pytest.mark.parametrize("metric", ["euclidean", "manhattan", "supremum"])
def test_in_circle_of_the_other_metrics(metric):
    # A circle of radius 1 around (1, 1), whatever the norm, touched by four sites of radius 0 ...
    i, j, k, q = np.array([[0.0, 1, 0], [1, 0, 0], [2, 1, 0], [1, 2, 0]])
    assert signum.in_circle(i, j, k, q, metric) == 0
    # ... and a fifth that just reaches it, or not.
    for r, expected in ((0.5, 0), (0.5 + 2**-53, 1), (0.5 - 2**-54, -1)):
        assert signum.in_circle(i, j, k, [1, 2.5, r], metric) == expected


def test_a_tangent_disc_is_told_from_one_beside_it():
    i, j, k = [0, 0, 0], [4, 0, 0], [0, 3, 0]
    assert signum.in_circle(i, j, k, [4, 3]) == 0
    assert signum.in_circle(i, j, k, [4, np.nextafter(3, 0)]) == 1
    assert signum.in_circle(i, j, k, [4, np.nextafter(3, 4)]) == -1


def test_what_has_no_meaning_is_refused():
    i, j, k = [0, 0], [0, 1], [1, 0]
    with pytest.raises(ValueError, match="no circle"):
        signum.in_circle(i, j, k, [5, 5])
    with pytest.raises(ValueError, match="row 1: no circle"):
        signum.in_circle([[0, 0], [0, 0]], [[1, 0], [0, 1]], [[0, 1], [1, 0]], [5, 5], "power")
    with pytest.raises(ValueError, match="hidden"):
        signum.in_circle([0, 0, 3], [9, 0], [0, 9], [1, 0, 0])
    with pytest.raises(ValueError, match="row 0, 1: a number is not finite"):
        signum.ccw([[[0, 0], [0, np.nan]]], j, k)
    with pytest.raises(ValueError, match="weight"):
        signum.in_circle(i, k, j, [5, 5], weight_is="weight")


def test_at_infinity_hidden_and_nearer():
    assert signum.in_circle_infinite([0, 0], [1, 0], [[0.5, -1], [0.5, 1]], "power").tolist() == [1, -1]
    assert signum.in_circle_infinite([0, 0, 1], [4, 0, 1], [2, 0, 1]) == 0
    with pytest.raises(ValueError, match="one centre"):
        signum.in_circle_infinite([0, 0], [0, 0], [1, 1], "power")
    assert signum.hidden([[1, 0, 1], [1, 0, 2]], [0, 0, 2]).tolist() == [True, False]
    assert signum.hidden([1, 0, 1], [0, 0, 2], "supremum") is True
    assert signum.nearer([1, 0], [0, 0, 0], [2, 0, 0], "power") == 0
    assert signum.nearer([1, 0], [0, 0, 1], [3, 0, 1], "manhattan") == 1


def test_in_sphere_in_rationals():
    sites = np.column_stack([RNG.integers(0, 3, (500, 3)), RNG.integers(0, 2, 500)]) / 10.0
    balls = list(sites.reshape(5, 100, 4))
    turned = signum.ccw(*(s[:, :3] for s in balls[:4])) > 0
    balls = [s[turned] for s in balls]
    signs = signum.in_sphere(*balls)
    assert signs.tolist() == [exact.power_in_sphere(*s) for s in zip(*balls)]
    assert len(signs) > 20 and 0 in signs
    with pytest.raises(ValueError, match="no sphere"):
        signum.in_sphere([0, 0, 0], [0, 1, 0], [1, 0, 0], [0, 0, 1], [9, 9, 9])


def test_in_sphere_of_the_other_metrics():
    around = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    i, j, k, l = around[[0, 2, 4, 1]]
    if signum.ccw(i, j, k, l) < 0:
        j, k = k, j
    assert signum.in_sphere(i, j, k, l, around[5], "euclidean") == 0
    assert signum.in_sphere(i, j, k, l, [0, 0, -1.5], "euclidean") == -1
    for metric in ("manhattan", "supremum"):
        with pytest.raises(ValueError, match="spheres"):
            signum.in_sphere(i, j, k, l, around[5], metric, sphere=7)
    # The one cube that touches these four, in four sides, has the centre (1, 1, 1) and the half side 1.
    cube = np.array([[0, 0.5, 1.25], [2, 0.75, 1.5], [1.25, 0, 0.5], [1.5, 1, 0]])
    assert [signum.in_sphere(*cube, [1, 1, z], "supremum") for z in (2.5, 2, 1.5)] == [-1, 0, 1]


def test_sign_of_sum():
    terms = np.array([[1e300, 1, -1e300], [0.1, 0.2, -(0.1 + 0.2)], [1, -1, 0]])
    assert signum.sign_of_sum(terms).tolist() == [
        exact.sign(sum(map(Fraction, row))) for row in terms.tolist()
    ] == [1, -1, 0]
    assert signum.sign_of_sum([1e300, 1.0, -1e300, -1e-300]) == 1
    cube = RNG.integers(-2, 3, (3, 4, 5)) * 1e200
    for axis in (0, 1, 2, -1, -2):
        expected = np.sign(np.sign(cube.astype(object)).sum(axis) * 0 + cube.sum(axis))
        assert np.array_equal(signum.sign_of_sum(cube, axis), expected.astype(int)), axis
    with pytest.raises(ValueError, match="axis"):
        signum.sign_of_sum(cube, 3)


def test_meeting_time():
    a = [0, 0, 1, 1, 0]
    times = signum.meeting_time(a, [[10, 0, 1, 0, 0], [0, 10, 1, 0, 0], [10, 0, 1, -3, 0]])
    assert times.tolist() == [8.0, np.inf, 2.0]
    assert signum.meeting_time([0, 0, 0, 1, 3, 0, 0], [8, 0, 0, 1, 0, 0, 0]) == 2.0
    around = signum.meeting_time(a, [4, 0, 1, 1.5, 0], until=100, periodic_box=[[0, 0], [10, 10]])
    assert around == 8.0  # across the border: a gap of 6 - 2 closes by 1/2
    with pytest.raises(ValueError, match="negative"):
        signum.meeting_time(a, [0, 0, -1, 0, 0])
    with pytest.raises(ValueError, match="NaN"):
        signum.meeting_time(a, [4, 0, 1, 1.5, 0], until=np.nan)
    with pytest.raises(ValueError, match="both finite"):
        signum.meeting_time(a, [4, 0, 1, 1.5, 0], until=9, periodic_box=[[0, 0], [np.inf, 10]])
    with pytest.raises(ValueError, match="an earlier time"):
        signum.meeting_time([0, 0, 0.1, 1, 0], [0, 0.5, 0.1, 3, 0], until=1e15, periodic_box=[[0, 0], [1, 1]])
    with pytest.raises(ValueError):
        signum.meeting_time(a, [4, 0, 1, 1.5, 0], periodic_box=[[0, 0], [10, 10]])
