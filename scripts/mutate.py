#!/usr/bin/env python3
"""Breaks the library in one place at a time and shows that a test notices.

  scripts/mutate.py                 every mutant of tests/mutation/*.toml that is not yet judged
  scripts/mutate.py NAME...         those whose names begin with one of these, or of a table or for a
                                    program of that name
  scripts/mutate.py --report        what is known, as tables for docs/mutation.md
  scripts/mutate.py --check         that each mutant's text is there once, and nothing more
  scripts/mutate.py --again NAME... judges those once more that are known

A mutant is a text of a file, which occurs there once, and what to put in its place. The programs that
should notice are linked with the library as it is and, before it, those objects made anew, of a copy of
the sources in build/mutation, that read the file: the test's own and those of the folders that the table
names. They run one after the other until one fails, or has not ended in ten minutes; of a header the test's own object is made first, and
the others only where that does not notice. MUTATION_DIRECTORY names another place, so that two
runs may go on side by side. `refused` is a mutant that does not compile because of a static_assert;
`broken` one that does not compile for any other reason, which is an error of the table. What is known
stands in tests/mutation/judged.json, mutant by mutant as it is found, so that a run may be cut off; where
the file or the mutant changes it is to be judged anew.

Ends with 1 where a mutant survives that is not said to be equivalent, or is killed and is said to be.
"""
import argparse
import concurrent.futures
import fcntl
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = pathlib.Path(os.environ.get("MUTATION_DIRECTORY", ROOT / "build" / "mutation")).resolve()
COPY = WORK / "source"
INSTALLED = WORK / "include" / "signum"
RESULTS = ROOT / "tests" / "mutation" / "judged.json"
FLAGS = ["-std=c++20", "-ffp-contract=off"]
FLAGS += ["-DSIGNUM_WITH_HIGHWAY"] if os.path.exists("/usr/include/hwy/highway.h") else []
LIBRARIES = ["-lgtest_main", "-lgtest", "-lgmpxx", "-lmpfr", "-lgmp", "-ltbb", "-lfmt", "-lpthread"]
COMPILER = os.environ.get("CXX", "g++")
LIMIT = 600
FLAGS_OF_TESTS = ["-O0", f'-DSIGNUM_SOURCES="{COPY}"']
PREPARED = set()
ARCHIVE = []
LIBRARY_READS = {}


def read_tables():
    programs, mutants = {}, []
    for path in sorted((ROOT / "tests" / "mutation").glob("*.toml")):
        with open(path, "rb") as file:
            table = tomllib.load(file)
        programs.update(table.get("program", {}))
        for mutant in table.get("mutant", []):
            mutant["table"] = path.stem
            mutants.append(mutant)
    names = [mutant["name"] for mutant in mutants]
    for name in set(names):
        if names.count(name) > 1:
            sys.exit(f"two mutants are called {name}")
    return programs, mutants


def key_of(mutant):
    """Of what the judgement depends on, but for the tests' own texts."""
    text = (ROOT / mutant["file"]).read_text()
    words = [text, mutant["from"], mutant["to"], " ".join(mutant["programs"])]
    return hashlib.sha256("\0".join(words).encode()).hexdigest()[:16]


def copy_sources():
    """The sources as git knows them, those that have changed alone."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard"], check=True,
                            capture_output=True, text=True).stdout.split("\n")
    for name in listed:
        source, target = ROOT / name, COPY / name
        if not name or not source.is_file() or name.startswith(("docs/", "fuzz/")):
            continue
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)
    if not INSTALLED.is_symlink():
        INSTALLED.parent.mkdir(parents=True, exist_ok=True)
        INSTALLED.symlink_to(COPY)


def precompile_headers():
    """What takes the most of the time of a test's compilation, once."""
    header = WORK / "tests.hpp"
    if not header.with_name(header.name + ".gch").exists():
        header.write_text("#include <boost/multiprecision/gmp.hpp>\n#include <gtest/gtest.h>\n")
        subprocess.run([COMPILER, *FLAGS, *FLAGS_OF_TESTS, "-x", "c++-header", header], check=True)


def build_library():
    """The library as it is: its archive, and the files that each of its sources reads."""
    # As deep as the build folders of others, whose objects ccache then knows.
    folder = ROOT / "build" / "mutation-library"
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DSIGNUM_BUILD_TESTS=OFF", *launcher], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", folder, "-j2", "signum"], check=True, stdout=subprocess.DEVNULL)
    deps = subprocess.run(["ninja", "-C", folder, "-t", "deps"], check=True, capture_output=True, text=True)
    for block in deps.stdout.split("\n\n"):
        files = [os.path.relpath(os.path.normpath(folder / line.strip()), ROOT)
                 for line in block.split("\n")[1:] if line.strip()]
        if files:
            LIBRARY_READS[files[0]] = set(files)
    ARCHIVE.append(str(folder / "libsignum.a"))


def is_of_tests(name):
    """The tests and the tool, of which some of them take generators, are not in the archive."""
    return name.startswith(("tests/", "tool/"))


def sources_of(program):
    """The test, its helpers, and what of the library may have to be made anew."""
    names = [program["source"]]
    for folder in program.get("library", []):
        path = COPY / folder
        found = [path] if path.is_file() else sorted(path.rglob("*.cpp"))
        names += [str(each.relative_to(COPY)) for each in found]
    return names


def object_of(name, folder):
    return WORK / folder / (name.replace("/", "+") + ".o")


def compile_object(name, target):
    """The compiler's complaint, empty where there is none."""
    target.parent.mkdir(parents=True, exist_ok=True)
    own = FLAGS_OF_TESTS + ["-include", WORK / "tests.hpp"] if is_of_tests(name) else ["-O1"]
    command = [COMPILER, "-I", INSTALLED.parent] + FLAGS + own + ["-MMD", "-MF", str(target) + ".d", "-c", name, "-o", str(target)]
    done = subprocess.run(command, cwd=COPY, capture_output=True, text=True)
    return done.stderr if done.returncode else ""


def reads(name):
    """The files that an object was made of."""
    if not is_of_tests(name):
        return LIBRARY_READS[name]
    text = (object_of(name, "objects").with_name(object_of(name, "objects").name + ".d")).read_text()
    words = text.replace("\\\n", " ").split(":", 1)[1].split()
    return {os.path.normpath(word) for word in words}


def build_base(programs, pool):
    """Objects of the tests as they are; those of an earlier run where nothing has changed."""
    wanted = sorted({name for program in programs for name in sources_of(program)
                     if is_of_tests(name)})

    def build(name):
        target = object_of(name, "objects")
        depends = target.with_name(target.name + ".d")
        if target.exists() and depends.exists():
            made = target.stat().st_mtime
            if all((COPY / each).exists() and (COPY / each).stat().st_mtime <= made
                   for each in reads(name)):
                return ""
        return compile_object(name, target)

    for name, complaint in zip(wanted, pool.map(build, wanted)):
        if complaint:
            sys.exit(f"{name} does not compile as it is:\n{complaint}")


def run_program(program, binary):
    """Whether it passes."""
    command = [str(binary), "--gtest_brief=1", "--gtest_fail_fast"]
    if "script" in program:
        command = ["bash", str(COPY / program["script"]), str(binary)]
    if "filter" in program:
        command.append("--gtest_filter=" + program["filter"])
    try:
        done = subprocess.run(command, cwd=COPY, capture_output=True, text=True, timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return False
    if done.returncode == 77:
        sys.exit("a program skips itself: " + done.stdout)
    return done.returncode == 0


def link(program, changed, binary):
    objects = [str(object_of(name, "mutant" if name in changed else "objects"))
               for name in sources_of(program) if name in changed or is_of_tests(name)]
    libraries = [] if "script" in program else ARCHIVE + LIBRARIES
    subprocess.run([COMPILER, *objects, "-o", str(binary), *libraries], check=True)


def prepare(name, program, pool):
    """Builds it of the sources as they are; it has to pass."""
    if name in PREPARED:
        return
    build_base([program], pool)
    binary = WORK / "program"
    link(program, set(), binary)
    if not run_program(program, binary):
        sys.exit(f"{name} fails on the sources as they are")
    PREPARED.add(name)


def judge(mutant, programs, pool):
    """killed, survived, refused or broken, and by what."""
    path = COPY / mutant["file"]
    text = path.read_text()
    if text.count(mutant["from"]) != 1:
        return "broken", f"the text occurs {text.count(mutant['from'])} times"
    times = path.stat()

    def restore():
        path.write_text(text)
        os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))

    changed_text = text.replace(mutant["from"], mutant["to"])
    done = set()
    try:
        for name in mutant["programs"]:
            program = programs[name]
            restore()
            prepare(name, program, pool)
            path.write_text(changed_text)
            changed = {each for each in sources_of(program) if mutant["file"] in reads(each)}
            for part in sorted({frozenset(changed & {program["source"]}), frozenset(changed)}, key=len):
                if not part:
                    continue
                fresh = sorted(part - done)
                complaints = pool.map(lambda each: compile_object(each, object_of(each, "mutant")), fresh)
                for complaint in filter(None, complaints):
                    assertion = re.search(r"static assertion failed", complaint)
                    return ("refused", "static_assert") if assertion else ("broken", complaint[:2000])
                done |= part
                binary = WORK / "mutated_program"
                link(program, part, binary)
                if not run_program(program, binary):
                    return "killed", name
        return "survived", ""
    finally:
        restore()


def read_known():
    return json.loads(RESULTS.read_text()) if RESULTS.exists() else {}


def note(mutant, verdict):
    """Two runs may go on side by side."""
    with open(ROOT / "build" / "judging", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        known = read_known()
        known[mutant["name"]] = [key_of(mutant), *verdict]
        lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(known[name])}" for name in sorted(known))
        RESULTS.write_text("{\n" + lines + "\n}\n")


def verdict_of(mutant, known):
    """Nothing where it is not judged as it is now."""
    key, *verdict = known.get(mutant["name"], [None])
    return verdict if key == key_of(mutant) else None


def check(programs, mutants):
    wrong = [f"{mutant['name']}: the text is not in {mutant['file']}, once" for mutant in mutants
             if (ROOT / mutant["file"]).read_text().count(mutant["from"]) != 1]
    wrong += [f"{mutant['name']}: there is no program {name}" for mutant in mutants
              for name in mutant["programs"] if name not in programs]
    print("\n".join(wrong) if wrong else f"{len(mutants)} mutants")
    return wrong != []


def report(mutants, known):
    print("| file | mutants | refused by the compiler | noticed by the proofs | by a test | equivalent | "
          "survived | not judged |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    rows = {}
    for mutant in mutants:
        outcome, by = verdict_of(mutant, known) or ("not judged", "")
        row = rows.setdefault(mutant["file"], [0] * 7)
        row[0] += 1
        if outcome == "refused":
            row[1] += 1
        elif outcome == "killed":
            row[2 if by == "proofs" else 3] += 1
        elif outcome == "survived" and "equivalent" in mutant:
            row[4] += 1
        else:
            row[5 if outcome == "survived" else 6] += 1
            print(f"{mutant['name']}: {outcome}", file=sys.stderr)
    for file, row in sorted(rows.items()):
        print(f"| `{file}` | " + " | ".join(str(number or "") for number in row) + " |")
    total = [sum(row[k] for row in rows.values()) for k in range(7)]
    print("| all | " + " | ".join(str(number) for number in total) + " |")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("names", nargs="*")
    words.add_argument("--report", action="store_true")
    words.add_argument("--again", action="store_true")
    words.add_argument("--check", action="store_true")
    words.add_argument("--jobs", type=int, default=os.cpu_count())
    given = words.parse_args()
    programs, mutants = read_tables()
    if given.check:
        return check(programs, mutants)
    known = {} if given.again else read_known()
    if given.report:
        report(mutants, known)
        return 0
    chosen = [mutant for mutant in mutants
              if not given.names or any(mutant["name"].startswith(name) or mutant["table"] == name
                                        or mutant["programs"][0] == name for name in given.names)]
    wanted = [mutant for mutant in chosen if not verdict_of(mutant, known)]
    # Those first that take the least time, and those together that are judged by the same programs.
    wanted.sort(key=lambda mutant: (mutant["programs"][0] == "proofs", mutant["programs"], mutant["file"]))
    copy_sources()
    precompile_headers()
    build_library()
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for mutant in wanted:
            begin = time.monotonic()
            try:
                outcome, by = judge(mutant, programs, pool)
            except subprocess.CalledProcessError as error:
                outcome, by = "broken", str(error)[:200]
            seconds = round(time.monotonic() - begin)
            print(f"{mutant['name']:44} {outcome:9} {by} ({seconds} s)", flush=True)
            if outcome != "broken":
                note(mutant, (outcome, by))
                known = read_known()
    wrong = 0
    for mutant in chosen:
        outcome = (verdict_of(mutant, known) or ["broken"])[0]
        if outcome == "broken" or (outcome == "survived") != ("equivalent" in mutant):
            print(f"{mutant['name']}: {outcome}" + (", though equivalent" if "equivalent" in mutant else ""))
            wrong += 1
    print(f"{len(chosen)} mutants, {wrong} unexplained")
    return wrong != 0


if __name__ == "__main__":
    sys.exit(main())
