"""Every public name says what it is, and is what its stub says."""

import inspect
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import signum
from signum import effects, frames, plot

SAMPLE = """
import numpy as np
import numpy.typing as npt
import signum
from signum import effects

def cells(sites: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    t: signum.Tessellation = signum.triangulate(sites, "power", progress=print)
    faces: npt.NDArray[np.int32] = t.faces
    assert signum.validate(sites, faces, "power").valid
    return signum.voronoi(t).clip((0, 0, 1, 1)).areas

def run() -> str:
    s = signum.Simulation([[0, 0, 1, 1, 0]], obstacles=[effects.Sphere((0, 0), 3, inside=True)])
    return s.run(3.0).ending
"""
WRONG = """
import signum
signum.triangulate([[0, 0]], metrik="power")
signum.triangulate([[0, 0]]).faces + "a"
"""


def public():
    for module in (signum, effects, frames, plot):
        yield module.__name__, module
        names = getattr(module, "__all__", None) or [
            name
            for name, thing in vars(module).items()
            if not name.startswith("_") and getattr(thing, "__module__", None) == module.__name__
        ]
        for name in names:
            thing = getattr(module, name)
            yield f"{module.__name__}.{name}", thing
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_") and (callable(value) or inspect.isdatadescriptor(value)):
                        yield f"{name}.{member}", value


def test_the_version_is_that_of_the_project():
    root = pathlib.Path(__file__).resolve().parents[3]
    assert f'version = "{signum.__version__}"' in (root / "pyproject.toml").read_text()


def test_every_public_name_has_a_docstring():
    named = dict(public())
    assert len(named) > 120
    assert [name for name, thing in named.items() if not self_made(thing)] == []


def self_made(thing):
    """The docstring, less the line with the signature that pybind11 puts before it."""
    text = inspect.getdoc(thing) or ""
    lines = [line for line in text.splitlines() if line.strip()]
    if lines and "->" in lines[0] and "(" in lines[0]:
        lines = lines[1:]
    # What dataclasses write themselves is the signature again.
    name = getattr(thing, "__name__", None)
    return bool(lines) and not (name and lines[0].startswith(f"{name}("))


@pytest.fixture
def package(tmp_path):
    """The package's files alone, where mypy takes them for what they are."""
    source = pathlib.Path(signum.__file__).parent
    (tmp_path / "signum").mkdir()
    for file in source.iterdir():
        if file.suffix in (".py", ".pyi", ".typed") or file.name == "py.typed":
            shutil.copy(file, tmp_path / "signum")
    return tmp_path


@pytest.mark.skipif(not shutil.which("mypy"), reason="there is no mypy")
def test_types_are_checked(package):
    for name, text in (("right", SAMPLE), ("wrong", WRONG)):
        (package / f"{name}.py").write_text(text)
    done = subprocess.run(
        [sys.executable, "-m", "mypy", "--strict", f"--cache-dir={package}/cache", "right.py", "wrong.py"],
        cwd=package, env=os.environ | {"MYPYPATH": str(package), "PYTHONPATH": ""},
        capture_output=True, text=True,
    )  # fmt: skip
    complaints = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert [line.split(":")[:2] for line in complaints] == [["wrong.py", "3"], ["wrong.py", "4"]], done.stdout


def parameters(text):
    """Names of parameters in a signature as pybind11 writes it."""
    inside = text[text.index("(") + 1 : text.rindex(") ->")]
    depth, names, word = 0, [], ""
    for character in inside + ",":
        depth += (character in "[(") - (character in "])")
        if character == "," and depth == 0:
            names.append(word.split(":")[0].split("=")[0].strip())
            word = ""
        else:
            word += character
    return [name for name in names if name not in ("*", "")]


def test_stubs_name_what_there_is():
    import ast

    from signum import _signum

    stub = ast.parse((pathlib.Path(signum.__file__).parent / "_signum.pyi").read_text())
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    functions = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
    there = {name for name in vars(_signum) if not name.startswith("__")}
    assert set(classes) | set(functions) == there

    def agree(stubbed, real, name):
        wanted = [a.arg for a in stubbed.args.args + stubbed.args.kwonlyargs]
        assert parameters(real.__doc__.splitlines()[0]) == wanted, name

    for name, node in functions.items():
        agree(node, getattr(_signum, name), name)
    for name, node in classes.items():
        members = {m.name: m for m in node.body if isinstance(m, ast.FunctionDef)}
        real = {
            m for m in vars(getattr(_signum, name))
            if not m.startswith("_") or m in ("__len__", "__contains__", "__bool__")
        }  # fmt: skip
        assert {m for m in members if m != "__init__"} == real, name
        for member, stubbed in members.items():
            thing = vars(getattr(_signum, name)).get(member)
            if member.startswith("_") or isinstance(thing, property):
                assert member.startswith("_") or stubbed.decorator_list, f"{name}.{member}"
                continue
            agree(stubbed, thing, f"{name}.{member}")
