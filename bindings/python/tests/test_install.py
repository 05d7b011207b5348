"""A wheel of what has been built, installed elsewhere, alone."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

BUILT = os.environ.get("SIGNUM_BUILT")
ROOT = pathlib.Path(__file__).resolve().parents[3]

USE = """
import pathlib, signum
print(pathlib.Path(signum.__file__).parent.parent)
print(signum.triangulate([[0, 0], [1, 0], [0, 1]], "power").faces.tolist())
"""


@pytest.mark.skipif(not BUILT, reason="SIGNUM_BUILT names no build folder")
def test_a_wheel_is_installed_and_used(tmp_path):
    sys.path.insert(0, str(ROOT / "bindings/python"))
    import wheel_by_cmake

    wheel = tmp_path / wheel_by_cmake.wheel_of(BUILT, tmp_path)
    target = tmp_path / "there"
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-compile",
         "--break-system-packages", "--root-user-action=ignore", "--target", target, wheel],
        check=True,
    )  # fmt: skip
    assert (target / "signum/py.typed").exists()
    done = subprocess.run(
        [sys.executable, "-c", USE], cwd=tmp_path, env=os.environ | {"PYTHONPATH": str(target)},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.splitlines() == [str(target), "[[-1, 0, 2], [-1, 1, 0], [-1, 2, 1], [0, 1, 2]]"]


def test_the_version_is_that_of_the_library():
    cmake = (ROOT / "CMakeLists.txt").read_text()
    version = re.search(r"project\(signum VERSION ([\d.]+)", cmake).group(1)
    assert f'version = "{version}"' in (ROOT / "pyproject.toml").read_text()
