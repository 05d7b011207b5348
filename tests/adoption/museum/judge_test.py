"""The museum's judge finds every fault that is planted: judge_test.py SIGNUM."""
import sys
import tempfile
import types
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[3] / "scripts"))
import museum

signum = sys.argv[1]
planted = 0
for path in sorted(museum.INPUTS.glob("*.txt")):
    given = museum.Input(path)
    d = given.dimension
    faces = museum.of_signum(signum, given)
    if not faces or len(faces) > 200:
        continue

    def is_wrong(damaged, what):
        global planted
        planted += 1
        assert museum.judge(given.sites, d, damaged)[0], f"{path.stem}: {what} is not found"

    assert museum.judge(given.sites, d, [face[::-1] for face in faces])[0] is None
    is_wrong([], "no face")
    is_wrong(faces + faces[:1], "a face twice")
    is_wrong([[faces[0][0]] * (d + 1)] + faces[1:], "a flat face")
    for k in range(len(faces)):
        is_wrong(faces[:k] + faces[k + 1 :], "a face that is missing")
    if given.has_weights:
        continue
    # Right for all sites but one.
    for left_out in range(min(len(given.sites), 3)):
        if given.sites.count(given.sites[left_out]) > 1:
            continue
        rest = [site for i, site in enumerate(given.rows) if i != left_out]
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            print("x y z" if d == 3 else "x y", file=file)
            for row in rest:
                print(*map(repr, row), file=file)
            file.flush()
            partly = museum.of_signum(signum, types.SimpleNamespace(path=file.name, dimension=d))
        if partly:
            is_wrong([[i + (i >= left_out) for i in face] for face in partly], "a missing site")
    if d == 3:
        continue
    # The other diagonal of two faces is right only where all four sites are on a circle.
    beside = {}
    for k, face in enumerate(faces):
        for m in range(3):
            beside.setdefault(frozenset(face[:m] + face[m + 1 :]), []).append((k, face[m]))
    for ends, both in beside.items():
        if len(both) < 2:
            continue
        (k, p), (m, q) = both
        if museum.conflict([given.sites[i] for i in faces[k]], given.sites[q]) == 0:
            continue
        a, b = ends
        others = [face for n, face in enumerate(faces) if n not in (k, m)]
        is_wrong(others + [[p, q, a], [p, q, b]], "a flipped edge")
assert planted > 500, planted
print(f"{planted} faults found")
