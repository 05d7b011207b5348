"""What goes in without a copy, what comes out without one, and what is refused."""

import fractions
import gc
import resource
import subprocess
import sys

import numpy as np
import pytest

import signum

SITES = np.random.default_rng(3).uniform(0, 1, (200, 3)) * [10, 10, 1]
FACES = signum.triangulate(SITES).faces


def layouts():
    wide = np.zeros((200, 7))
    wide[:, 2:5] = SITES
    every_other = np.zeros((400, 3))
    every_other[::2] = SITES
    records = np.zeros(200, [("name", "i8"), ("xyr", "f8", 3)])
    records["xyr"] = SITES
    return {
        "rows": SITES,
        "columns": np.asfortranarray(SITES),
        "a slice of columns": wide[:, 2:5],
        "every other row": every_other[::2],
        "backwards": SITES[::-1][::-1],
        "the field of a record": records["xyr"],
        "transposed": np.ascontiguousarray(SITES.T).T,
    }


@pytest.mark.parametrize("layout", layouts())
def test_strided_views_are_read_in_place(layout, monkeypatch):
    import signum._exact

    def refuse(_):
        raise AssertionError("the array was converted")

    monkeypatch.setattr(signum._exact, "doubles", refuse)
    assert np.array_equal(signum.triangulate(layouts()[layout]).faces, FACES)
    # Upside down: the very rows, in their other order.
    t = signum.triangulate(layouts()[layout][::-1])
    assert np.array_equal(t.sites, SITES[::-1])


@pytest.mark.parametrize(
    "sites",
    [
        SITES.tolist(),
        SITES.astype(">f8"),
        SITES.astype(np.longdouble),
        [[fractions.Fraction(float(c)) for c in row] for row in SITES],
        np.frombuffer(b"x" + SITES.tobytes(), np.uint8)[1:].view(np.float64).reshape(200, 3),
    ],
    ids=["lists", "other byte order", "long doubles", "fractions", "not aligned"],
)
def test_other_numbers_are_converted(sites):
    assert np.array_equal(signum.triangulate(sites).sites, SITES)


def test_whole_numbers_and_floats():
    assert signum.triangulate(np.array([[0, 0], [1, 0], [0, 1]], np.int16)).faces.shape == (4, 3)
    assert signum.triangulate(np.array([[0, 0.5], [1, 0]], np.float32)).sites[0, 1] == 0.5


@pytest.mark.parametrize("number", [2**53 + 1, fractions.Fraction(1, 3), np.longdouble(1) / 3, 10**400])
def test_numbers_that_no_double_is_are_refused(number):
    sites = np.array([[0, 0], [1, number]], object)
    with pytest.raises(ValueError, match="row 1|beyond the doubles"):
        signum.triangulate(sites)
    assert len(signum.triangulate([[0, 0], [1, 2**53 + 2]])) == 2


@pytest.mark.parametrize(
    "sites",
    [
        [[2**53 + 1, 0.5], [0, 1]],
        [[2**63 + 1, -1], [0, 1]],
        np.array([[np.int64(2**53 + 1), fractions.Fraction(1, 2)], [0, 1]], object),
    ],
)
def test_integers_are_not_rounded_on_the_way(sites):
    with pytest.raises(ValueError, match="row 0 has"):
        signum.triangulate(sites)
    with pytest.raises(ValueError, match="row 0 has"):
        signum.ccw([2**53 + 1, 0.0], [2**53, 0], [0, 1.5])


def test_masks_are_refused():
    with pytest.raises(ValueError, match="masked"):
        signum.triangulate(np.ma.array(SITES, mask=SITES > 1))


@pytest.mark.parametrize(
    "wrong",
    [[[0, 0], [np.nan, 1]], [[0, 0], [1, np.inf]], np.array([[0.0, 0, 0], [0, 0, -np.inf]])],
)
def test_what_is_not_finite_is_refused_by_its_row(wrong):
    with pytest.raises(ValueError, match="site 1 is not finite"):
        signum.triangulate(wrong)


@pytest.mark.parametrize(
    "wrong, message",
    [
        ([1, 2, 3], "a table of 2 to 3 columns"),
        (np.zeros((5, 4)), r"shape is \(5, 4\)"),
        (np.zeros((5, 1)), "2 to 3 columns"),
        ([["a", "b"]], "numbers are needed"),
        ([[1, None]], "site 0 is not finite"),
        ([[1, "a"]], "numbers are needed"),
        ([[1, []]], "all must be numbers|inhomogeneous"),
        (np.zeros((2, 2), complex), "numbers are needed"),
        ("sites.csv", "numbers are needed"),
    ],
)
def test_what_is_no_table_is_refused(wrong, message):
    with pytest.raises(ValueError, match=message):
        signum.triangulate(wrong)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"metric": "cosine"}, "power, euclidean, manhattan, supremum"),
        ({"method": "magic"}, "incremental, flips, sweep"),
        ({"method": "flips"}, "flips"),
        ({"arithmetic": "guess"}, "exact, naive"),
        ({"weight_is": "weight"}, "weight"),
    ],
)
def test_options_that_there_are_not(options, message):
    with pytest.raises(ValueError, match=message):
        signum.triangulate(SITES, **options)


def test_results_are_views_that_keep_the_memory():
    t = signum.triangulate(SITES)
    for name in ("sites", "faces", "neighbours"):
        one, other = getattr(t, name), getattr(t, name)
        assert np.shares_memory(one, other), name
        assert not one.flags.writeable and not one.flags.owndata
        with pytest.raises(ValueError):
            one[0] = 0
        with pytest.raises(ValueError):
            one.flags.writeable = True
    assert t.faces.dtype == t.neighbours.dtype == t.hidden.dtype == np.int32
    faces = t.faces
    del t
    gc.collect()
    assert np.array_equal(faces, FACES)


GROWTH = """
import resource, sys
import numpy as np, signum

def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024

n = 500_000
wide = np.random.default_rng(1).uniform(0, 1, (n, 4))
sites = wide[:, 1:3]
signum.triangulate(sites[:1000], "power")
before = peak()
t = signum.triangulate(sites, "power")
built = peak()
views = [t.sites, t.faces, t.neighbours, t.hidden]
assert sum(view.nbytes for view in views) > 35e6
print((built - before) * 2**20 / n, (peak() - built) * 2**20 / n)
"""


def test_memory_says_that_nothing_is_copied():
    """The library promises 150 bytes a site at the peak; a copy would be 16 in and 72 out."""
    done = subprocess.run([sys.executable, "-c", GROWTH], capture_output=True, text=True, check=True)
    built, looked_at = map(float, done.stdout.split())
    assert built < 155, "bytes a site that the construction took"
    assert looked_at < 4, "bytes a site that its arrays took"


def test_indices_do_not_wrap():
    faces = np.array([[0, 1, 2**64 - 1]], np.uint64)
    with pytest.raises(ValueError, match="beyond 32 bits"):
        signum.validate([[0, 0], [1, 0]], faces)
