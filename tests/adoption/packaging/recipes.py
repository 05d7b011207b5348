"""What can be told of the recipes without vcpkg, Conan and conda: they speak of this version, pass options that there
are, and a build with these options can be configured; without GMP nothing of it is left in what is installed."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sources = pathlib.Path(os.environ["SOURCES"])
project = (sources / "CMakeLists.txt").read_text()
version = re.search(r"project\(signum VERSION (\S+)", project)[1]


def text(name):
    return (sources / name).read_text()


def require(holds, words):
    if not holds:
        sys.exit(words)


compile(text("packaging/conan/conanfile.py"), "conanfile.py", "exec")
compile(text("packaging/conan/test_package/conanfile.py"), "conanfile.py", "exec")
port = json.loads(text("packaging/vcpkg/vcpkg.json"))
said = {"packaging/vcpkg/vcpkg.json": port["version"],
        "packaging/conan/conanfile.py": re.search(r'version = "(.*)"', text("packaging/conan/conanfile.py"))[1],
        "packaging/conda/meta.yaml": re.search(r'set version = "(.*)"', text("packaging/conda/meta.yaml"))[1],
        "CITATION.cff": re.search(r"^version: (.*)$", text("CITATION.cff"), re.M)[1],
        "CHANGELOG.md": re.search(r"^## \[(\d.*)\]", text("CHANGELOG.md"), re.M)[1]}
for name, other in said.items():
    require(other == version, f"{name} speaks of {other}, this is {version}")
require(f"SIGNUM_{version.rpartition('.')[0]} {{" in text("packaging/exports.map"), "exports.map is of another version")

# The options that they pass.
declared = set(re.findall(r"(?:option\(|set\()(SIGNUM_\w+)(?: \"| AUTO CACHE)", project + text("cmake/Numbers.cmake") + text("cmake/Parallel.cmake") + text("cmake/Highway.cmake")
                          + text("cmake/Install.cmake")))
for name in ("packaging/vcpkg/portfile.cmake", "packaging/conan/conanfile.py", "packaging/conda/meta.yaml"):
    passed = set(re.findall(r"SIGNUM_\w+", text(name)))
    require(passed and passed <= declared, f"{name}: there is no option {passed - declared}")
# What the tool finds by CMake is what the recipes bring.
for package in re.findall(r"find_package\((\w+)", text("tool/CMakeLists.txt")):
    name = {"nlohmann_json": "nlohmann-json"}.get(package, package).lower()
    require(name in port["features"]["tool"]["dependencies"], f"vcpkg.json does not bring {name}")
    require(name.replace("-", "_") in text("packaging/conda/meta.yaml"), f"meta.yaml does not bring {name}")

with tempfile.TemporaryDirectory() as build:
    call = ["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSIGNUM_BUILD_TESTS=OFF",
            f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}", "-DSIGNUM_BUILD_TOOL=OFF", "-DSIGNUM_INSTALL=ON",
            "-DSIGNUM_WITH_GMP=OFF", "-DSIGNUM_WITH_TBB=OFF", "-DCMAKE_INSTALL_LIBDIR=lib"]
    done = subprocess.run(call, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    require(done.returncode == 0 and "not used by the project" not in done.stdout, done.stdout)
    pc = (pathlib.Path(build) / "signum.pc").read_text()
    require("gmp" not in pc and "tbb" not in pc and "-lstdc++" in pc or "-lc++" in pc, f"signum.pc without GMP:\n{pc}")
    config = (pathlib.Path(build) / "signum-config.cmake").read_text()
    require("if(OFF)" in config, "signum-config.cmake asks for GMP all the same")
