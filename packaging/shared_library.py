#!/usr/bin/env python3
"""The shared library from outside, as it is recorded in shared_library.txt: its size, what it needs, what it exports.

    packaging/shared_library.py LIBRARY           writes the record beside this script
    packaging/shared_library.py LIBRARY --check   ends with 1 where it is another; the size may be a twentieth off

The record is that of g++ 12 for x86-64, optimized, without debugging information, with GMP.
"""
import pathlib
import re
import subprocess
import sys

RECORD = pathlib.Path(__file__).resolve().parent / "shared_library.txt"
TOLERANCE = 0.05


def said(*call):
    return subprocess.run(call, stdout=subprocess.PIPE, text=True, check=True).stdout


def loaded_bytes(library):
    """What of it a process maps: debugging information and the table of all symbols are not among it."""
    return sum(int(size, 16) for size in re.findall(r"^ +LOAD +\S+ \S+ \S+ (0x[0-9a-f]+)", said("readelf", "-lW", library), re.M))


def record(library):
    dynamic = said("readelf", "-dW", library)
    symbols = [line.split(" ", 2)[2] for line in said("nm", "-D", "-C", "--defined-only", library).splitlines()]
    # A node of versions is a symbol, too; it stands at the name of each.
    symbols = sorted({symbol for symbol in symbols if "@@" in symbol})
    needs = sorted(re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic))
    return [f"bytes {loaded_bytes(library)}", f"name {re.search(r'SONAME.*?.(lib[^ ]*)]', dynamic)[1]}",
            *(f"needs {name}" for name in needs), *(f"exports {symbol}" for symbol in symbols)]


def difference(recorded, found):
    """The lines that are in one alone; of two sizes near each other none."""
    sizes = [int(lines[0].removeprefix("bytes ")) for lines in (recorded, found)]
    wrong = [] if abs(sizes[1] - sizes[0]) <= TOLERANCE * sizes[0] else [f"- {recorded[0]}", f"+ {found[0]}"]
    wrong += [f"- {line}" for line in recorded[1:] if line not in found]
    return wrong + [f"+ {line}" for line in found[1:] if line not in recorded]


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    found = record(sys.argv[1])
    if sys.argv[2:] == []:
        RECORD.write_text("\n".join(found) + "\n")
        return
    recorded = RECORD.read_text().splitlines()
    if wrong := difference(recorded, found):
        sys.exit("\n".join(wrong) + "\nthe shared library is not as recorded (docs/versions.md says what that means): "
                 "packaging/shared_library.py writes the record")
    # The test of the test: a name more, a name less and a library that has grown are found out.
    for other in (recorded + ["exports signum::more()"], recorded[:-1], ["bytes 1"] + recorded[1:]):
        if not difference(other, found):
            sys.exit("a difference should have been found")


if __name__ == "__main__":
    main()
