"""What a header of predicates costs over an empty file: less than 100 ms of the compiler's time, optimized.

The time is the processor's, user and system, the least of several runs; runs of the empty file stand between them. On
a busy machine all of it takes longer: above the budget more runs are made before it counts as spent.
"""
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

BUDGET = 0.100
ROUNDS, MOST_ROUNDS = 3, 3
prefix, sources = pathlib.Path(os.environ["PREFIX"]), pathlib.Path(os.environ["SOURCES"])


def seconds(compiler, file):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([compiler, "-std=c++20", "-O2", f"-I{prefix}/include", "-c", file, "-o", f"{file}.o"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def cost(compiler, header, folder):
    """The least over the least of an empty file."""
    empty, file = folder / "empty.cpp", folder / "header.cpp"
    empty.write_text("")
    file.write_text(f"#include <signum/{header}>\n" if header else "#include <algorithm>\n#include <regex>\n")
    least, least_empty = 1e9, 1e9
    for round_ in range(MOST_ROUNDS):
        least_empty = min(least_empty, seconds(compiler, empty))
        least = min(least, seconds(compiler, file))
        if round_ + 1 >= ROUNDS and least - least_empty < BUDGET:
            break
    return least - least_empty


def main():
    listed = re.search(r"set\(public_headers\n([^)]*)\)", (sources / "cmake/Install.cmake").read_text())[1]
    headers = [header for header in listed.split() if header.startswith("predicates/")] + ["exact/sign_of_sum.hpp"]
    if len(headers) < 6:
        sys.exit(f"only {headers}")
    compilers = [compiler for name in ("g++", "clang++") if (compiler := shutil.which(name))]
    spent = []
    with tempfile.TemporaryDirectory() as folder:
        for compiler in compilers:
            for header in headers:
                took = cost(compiler, header, pathlib.Path(folder))
                print(f"{pathlib.Path(compiler).name:8} {header:30} {1000 * took:4.0f} ms")
                if took >= BUDGET:
                    spent.append(header)
    if spent:
        sys.exit(f"above {1000 * BUDGET:.0f} ms: {' '.join(spent)}")


main()
