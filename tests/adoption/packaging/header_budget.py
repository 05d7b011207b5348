"""What a header of predicates costs the compiler over an empty file, optimized: no more than so many times what the
standard library's <algorithm> costs, which every second file of a program includes.

The time is the processor's, user and system. It grows on a busy machine, but for the yardstick alike: they are measured
in turns, and the least of all rounds counts. Where a header is above its budget, more rounds are made first.
"""
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

BUDGET = {"predicates/ccw.hpp": 0.5, "exact/sign_of_sum.hpp": 1.0, "predicates/power.hpp": 0.9}
BUDGET_OF_OTHERS = 1.1
MOST_ROUNDS = 12
prefix, sources = pathlib.Path(os.environ["PREFIX"]), pathlib.Path(os.environ["SOURCES"])


def seconds(compiler, text, folder):
    file = folder / "one.cpp"
    file.write_text(text)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([compiler, "-std=c++20", "-O2", f"-I{prefix}/include", "-c", file, "-o", folder / "one.o"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def costs(compiler, headers, folder):
    """Of each header in multiples of <algorithm>'s; and that in seconds."""
    texts = {"": ""} | {header: f"#include <{header}>\n" for header in ["algorithm", *headers]}
    least = dict.fromkeys(texts, float("inf"))
    for _ in range(MOST_ROUNDS):
        for name, text in texts.items():
            least[name] = min(least[name], seconds(compiler, text, folder))
        yardstick = least["algorithm"] - least[""]
        ratios = {header: (least[header] - least[""]) / yardstick for header in headers}
        if all(ratio < budget(header) for header, ratio in ratios.items()):
            break
    return ratios, yardstick


def budget(header):
    return BUDGET.get(header.removeprefix("signum/"), BUDGET_OF_OTHERS)


def main():
    listed = re.findall(r'#include "(.+)"', (sources / "signum.hpp").read_text())
    headers = [f"signum/{header}" for header in listed
               if header.startswith("predicates/") or header == "exact/sign_of_sum.hpp"]
    compilers = [compiler for name in ("g++", "clang++") if (compiler := shutil.which(name))]
    if len(headers) < 7 or not compilers:
        sys.exit(f"only {headers}, {compilers}")
    above = []
    with tempfile.TemporaryDirectory() as folder:
        for compiler in compilers:
            ratios, yardstick = costs(compiler, headers, pathlib.Path(folder))
            for header, ratio in ratios.items():
                print(f"{pathlib.Path(compiler).name:8} {header:32} {ratio:5.2f} of {budget(header):4.2f}, {1000 * ratio * yardstick:4.0f} ms")
            above += [header for header, ratio in ratios.items() if ratio >= budget(header)]
    if above:
        sys.exit(f"above the budget: {' '.join(above)}")


main()
