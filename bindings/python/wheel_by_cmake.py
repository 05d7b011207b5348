"""Makes a wheel: what `pip install .` calls (PEP 517). CMake builds, the standard library packs.

Nothing is fetched: CMake, a compiler, GMP, MPFR, Boost and pybind11 are the system's. In the environment
SIGNUM_BUILD_DIRECTORY names a build folder that is kept, CMAKE_ARGS are further arguments for CMake.
"""

import base64
import hashlib
import os
import pathlib
import shlex
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def project():
    """The table [project] of pyproject.toml, which holds nothing but strings and lists of them."""
    try:
        import tomllib
    except ModuleNotFoundError:  # Python 3.9 and 3.10, and pip is never without it
        from pip._vendor import tomli as tomllib
    with open(ROOT / "pyproject.toml", "rb") as file:
        return tomllib.load(file)["project"]


def information_of(about):
    """The name of the folder that says what a wheel is, and its files."""
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {about['name']}",
        f"Version: {about['version']}",
        f"Summary: {about['description']}",
        f"License: {about['license']['text']}",
        f"Requires-Python: {about['requires-python']}",
    ]
    files = {
        "METADATA": ("\n".join(lines) + "\n").encode(),
        "LICENSE": (ROOT / "LICENSE").read_bytes(),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: signum\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode(),
    }
    return f"{about['name']}-{about['version']}.dist-info", files


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def call(*command):
    print("+", shlex.join(map(str, command)), flush=True)
    if subprocess.run(list(map(str, command))).returncode != 0:
        raise SystemExit("signum: the build failed; what is above says why. docs/python.md lists what it needs.")


def build(directory):
    """Configures and compiles."""
    call(
        "cmake", "-S", ROOT, "-B", directory, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_SHARED_LIBS=OFF",
        "-DSIGNUM_UNITY_BUILD=ON", "-DSIGNUM_BUILD_PYTHON=ON", "-DSIGNUM_BUILD_TOOL=OFF", "-DSIGNUM_BUILD_TESTS=OFF",
        f"-DSIGNUM_PYTHON={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", "")),
    )  # fmt: skip
    call("cmake", "--build", directory, "--target", "signum_python", "--parallel", os.cpu_count() or 1)


def pack(wheel, files, information):
    """A zip archive of (name, bytes), with the list of them that wheels have."""
    record = []
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files:
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(content)}")
            archive.writestr(name, content)
        record.append(f"{information}/RECORD,,")
        archive.writestr(f"{information}/RECORD", "\n".join(record) + "\n")


def wheel_of(directory, wheel_directory):
    """Packs what has been built in a directory, and gives the wheel's name."""
    about = project()
    information, about_files = information_of(about)
    with tempfile.TemporaryDirectory() as staging:
        call("cmake", "--install", directory, "--component", "python", "--prefix", staging)
        files = [
            (path.relative_to(staging).as_posix(), path.read_bytes())
            for path in sorted(pathlib.Path(staging).rglob("*"))
            if path.is_file()
        ]
    if not files:
        raise SystemExit("signum: there is no Python package in " + str(directory))
    files += [(f"{information}/{name}", content) for name, content in about_files.items()]
    wheel = f"{about['name']}-{about['version']}-{tag()}.whl"
    pack(pathlib.Path(wheel_directory) / wheel, files, information)
    return wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """What pip asks first: it is known before anything is built."""
    information, files = information_of(project())
    folder = pathlib.Path(metadata_directory) / information
    folder.mkdir()
    for name, content in files.items():
        (folder / name).write_bytes(content)
    return information


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as scratch:
        directory = pathlib.Path(os.environ.get("SIGNUM_BUILD_DIRECTORY", scratch)).resolve()
        build(directory)
        return wheel_of(directory, wheel_directory)
