#!/usr/bin/env python3
"""Adds up what gcov knows of a build: lines that were run, and branches that were taken, folder by folder.

  scripts/covered.py BUILD [FOLDER...]     by default core exact filters predicates

Of a template every instance has lines and branches of its own, and a function that is inlined has as many as callers: a
line is covered where one of them ran it, and a branch where one of them took it. A branch counts where the line decides
something (if, for, while, case, ?:, && or ||): others are those of exceptions on their way through temporaries. Prints
what is not covered. Ends with 1 where lines or branches of a folder are below 95 %.
"""
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEAST = 95.0
DECIDES = re.compile(r"\b(if|for|while|case)\b|\?|&&|\|\|")
# Templates whose arguments decide, and assertions, which no test may fail.
DECIDES_NOT = re.compile(r"\bif constexpr\b|^\s*(//|static_assert|SIGNUM_(EXPECTS|ENSURES))|requires")


def of_object(data):
    """The files that gcov tells of, with their lines."""
    told = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities", data],
                          cwd=data.parent, check=True, capture_output=True, text=True).stdout
    return [(each["file"], each["lines"], report.get("current_working_directory", ""))
            for report in map(json.loads, filter(None, told.split("\n"))) for each in report["files"]]


def together(instances, text):
    """How often each branch of a line was taken: gcov puts the branches of all instances into one row, two for each
    condition that the line has."""
    decisions = len(re.findall(r"\b(?:if|for|while)\b|\?", text))
    joints = len(re.findall(r"&&|\|\|", text))
    number = 2 * (decisions + joints if decisions else joints + 1)
    whole = [branches for branches in instances if len(branches) % number == 0]
    if not whole:
        number = max(map(len, instances))
        whole = [branches for branches in instances if len(branches) == number]
    times = [0] * number
    for branches in whole:
        for place, count in enumerate(branches):
            times[place % number] += count
    return times


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    folders = sys.argv[2:] or ["core", "exact", "filters", "predicates"]
    runs = collections.defaultdict(dict)  # file, line: times
    instances = collections.defaultdict(lambda: collections.defaultdict(list))  # file, line: times of the branches of each
    with concurrent.futures.ThreadPoolExecutor() as pool:
        for files in pool.map(of_object, sorted(build.rglob("*.gcda"))):
            for name, lines, folder in files:
                path = os.path.relpath(os.path.normpath(os.path.join(folder or build, name)), ROOT)
                if path.split("/")[0] not in folders:
                    continue
                for line in lines:
                    number = line["line_number"]
                    runs[path][number] = runs[path].get(number, 0) + line["count"]
                    branches = [each["count"] for each in line["branches"] if not each["throw"]]
                    if branches:
                        instances[path][number].append(branches)
    below = False
    for folder in folders:
        lines = covered = branches = took = 0
        missing = []
        for path in sorted(runs):
            if path.split("/")[0] != folder:
                continue
            text = [""] + (ROOT / path).read_text().split("\n")
            for number, times in sorted(runs[path].items()):
                lines += 1
                covered += times > 0
                if times == 0:
                    missing.append(f"  {path}:{number}: not run: {text[number].strip()}")
            for number, known in sorted(instances[path].items()):
                if runs[path].get(number, 0) == 0 or not DECIDES.search(text[number]) or DECIDES_NOT.search(text[number]):
                    continue
                times = together(known, text[number])
                branches += len(times)
                took += sum(t > 0 for t in times)
                if not all(times):
                    missing.append(f"  {path}:{number}: {sum(t == 0 for t in times)} of {len(times)} branches not taken: "
                                   f"{text[number].strip()}")
        of_lines, of_branches = 100.0 * covered / max(lines, 1), 100.0 * took / max(branches, 1)
        print(f"{folder}: lines {of_lines:.1f} % of {lines}, branches {of_branches:.1f} % of {branches}")
        print("\n".join(missing))
        below |= min(of_lines, of_branches) < LEAST or lines == 0
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
