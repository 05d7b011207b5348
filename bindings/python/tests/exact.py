"""The definitions in rationals, for a few sites: what the tests compare with."""

from fractions import Fraction


def sign(number):
    return (number > 0) - (number < 0)


def rational(row):
    return [Fraction(float(number)) for number in row]


def determinant(rows):
    if len(rows) == 1:
        return rows[0][0]
    return sum(
        (-1) ** k * rows[0][k] * determinant([row[:k] + row[k + 1 :] for row in rows[1:]])
        for k in range(len(rows))
    )


def ccw(a, b, c):
    a, b, c = map(rational, (a, b, c))
    return sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def ccw_in_space(a, b, c, d):
    a, b, c, d = map(rational, (a, b, c, d))
    return sign(determinant([[p[k] - a[k] for k in range(3)] for p in (b, c, d)]))


def lifted(site, q):
    """The row of a site in the power metric: x, y, (z,) r, less those of q."""
    s, q = rational(site), rational(q)
    centre = [s[k] - q[k] for k in range(len(s) - 1)]
    return centre + [sum(d * d for d in centre) - (s[-1] ** 2 - q[-1] ** 2)]


def power_in_circle(i, j, k, q):
    return sign(determinant([lifted(s, q) for s in (i, j, k)]))


def power_in_sphere(i, j, k, l, q):
    return -sign(determinant([lifted(s, q) for s in (i, j, k, l)]))


def power_distance(p, site):
    s, p = rational(site), rational(p)
    return sum((s[k] - p[k]) ** 2 for k in range(len(p))) - s[-1] ** 2


def empty_circle_faces(points):
    """All triples that turn counterclockwise around a circle with no point inside."""
    n = len(points)
    sites = [(*p, 0.0) for p in points]
    return {
        (a, b, c)
        for a in range(n)
        for b in range(a + 1, n)
        for c in range(a + 1, n)
        if b != c
        and ccw(points[a], points[b], points[c]) > 0
        and all(power_in_circle(sites[a], sites[b], sites[c], sites[q]) <= 0 for q in range(n))
    }
