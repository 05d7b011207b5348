#!/usr/bin/env python3
"""Makes signum_predicates.hpp and .cpp from the rooms, or with --check says what differs.

The rooms are C++20; what is made here compiles as C++17, without a library. Files come in the order
below. Rewritten are what C++17 has no words for: concepts become plain parameters, questions about
members become traits (parts/words.hpp), spans and the functions of <bit> those of the same file.
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Rooms in the order in which they stand on one another; parts/ are written for this alone.
SOURCES = """
single/parts/words.hpp
core/contract.hpp
core/sign.hpp
core/site.hpp
core/index.hpp
single/parts/error_free.hpp
filters/environment.hpp
filters/bounds.hpp
filters/verdict.hpp
filters/tally.hpp
filters/rounding_count.hpp
filters/interval.hpp
filters/double_double.hpp
filters/bounded.hpp
exact/floating_environment.hpp
exact/expansion.hpp
exact/expansion.cpp
exact/parts.hpp
exact/sign_of_sum.hpp
exact/sign_of_sum.cpp
single/parts/dyadic.hpp
exact/integer_rows.hpp
predicates/arithmetic.hpp
predicates/ladder/decision.hpp
predicates/formulas/difference.hpp
predicates/formulas/orientation.hpp
predicates/formulas/lifted.hpp
predicates/ccw.hpp
single/parts/ladder.hpp
predicates/ladder/doubted.hpp
predicates/ccw.cpp
predicates/power/weight.hpp
predicates/power/in_circle.hpp
predicates/power/infinite.hpp
predicates/power/infinite.cpp
predicates/power/edge.hpp
predicates/power/edge.cpp
predicates/power/ties.hpp
predicates/power/ties.cpp
predicates/power.hpp
predicates/space/ccw.hpp
single/parts/small_integers.hpp
predicates/space/ccw.cpp
predicates/space/in_sphere.hpp
predicates/space/nearer.hpp
predicates/space/nearer.cpp
predicates/additive.hpp
predicates/ladder/forms.hpp
predicates/ladder/forms.cpp
predicates/rectangular/squares.hpp
predicates/manhattan.hpp
predicates/supremum.hpp
predicates/formulas/apollonius.hpp
predicates/formulas/discs.hpp
predicates/euclidean/filter.hpp
predicates/euclidean.hpp
single/parts/stages.cpp
""".split()

NOTICE = """\
// signum: signs of geometric predicates that are never wrong.
// Made by single/make.py of version {version}: edit the rooms that it names, not this file.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The signum authors
"""

CONCEPTS = "HasCentre3|HasCentre|PowerSite3|PowerSite"
BITS = "bit_cast|bit_width|bit_ceil|countr_zero|countl_zero|span"


def without_comments(text):
    """No string of the rooms has two slashes in it but addresses, of which there are none here."""
    text = re.sub(r"(?m)^\s*//.*\n", "", text)
    return re.sub(r"(?m)\s*//.*$", "", text)


def closing(text, start):
    """Past the bracket that closes the one at the place."""
    open_, close = text[start], {"(": ")", "{": "}"}[text[start]]
    depth = 0
    for at in range(start, len(text)):
        depth += (text[at] == open_) - (text[at] == close)
        if depth == 0:
            return at + 1
    raise ValueError("a bracket stays open")


def without_requirements(text):
    """`requires { m.w; }` and `requires { Number::zero(); }` become has_w<...> and has_zero<...>;
    `requires(...)` of a constructor goes."""
    while (found := re.search(r"requires\s*\{", text)) is not None:
        end = closing(text, found.end() - 1)
        inside = text[found.end() : end - 1].strip().rstrip(";")
        if member := re.fullmatch(r"(\w+)\.(\w+)(\(\))?", inside):
            trait = f"words::has_{member[2]}<decltype({member[1]})>"
        elif member := re.fullmatch(r"(\w+)::(\w+)(\(.*\))?", inside):
            trait = f"words::has_{member[2]}<{member[1]}>"
        else:
            raise ValueError(f"no trait for {inside!r}")
        text = text[: found.start()] + trait + text[end:]
    while (found := re.search(r"\brequires\s*\(", text)) is not None:
        text = text[: found.start()] + text[closing(text, found.end() - 1) :]
    return text


def in_cpp17(text):
    text = re.sub(r"template <[^<>]*>\s*concept [^;{]*(\{[^}]*\})?[^;{]*;\n", "", text)
    text = re.sub(rf"\b({CONCEPTS}) (\w+)(?=[,>])", r"class \2", text)
    text = without_requirements(text)
    text = re.sub(r"\s*\[\[(un)?likely\]\]", "", text)
    text = re.sub(r"(?m)^.*friend bool operator==\(const \w+&, const \w+&\) = default;\n", "", text)
    text = re.sub(rf"\bstd::({BITS})\b", r"words::\1", text)
    text = re.sub(r"std::same_as<", "words::same<", text)
    text = text.replace("std::make_unique_for_overwrite<Term[]>(input.size())",
                        "std::unique_ptr<Term[]>(new Term[input.size()])")
    return text


def replaced(text, old, new):
    """Fails where the room no longer says what is replaced."""
    if old not in text:
        raise ValueError(f"nothing to replace: {old!r}")
    return text.replace(old, new)


def section(path, includes):
    text = (ROOT / path).read_text()
    for include in re.findall(r"(?m)^#include (<.*>)$", text):
        includes.add(include)
    text = re.sub(r"(?m)^#(include .*|pragma once)\n", "", text)
    text = in_cpp17(without_comments(text))
    # parts/c.cpp looks at what it is given; the preconditions about sites are the caller's.
    text = text.replace("SIGNUM_EXPECTS(condition) assert(condition)",
                        "SIGNUM_EXPECTS(condition) static_cast<void>(0)")
    if path == "exact/expansion.hpp":
        text = replaced(text, ", gnu::always_inline]] inline Expansion", "]] inline Expansion")
        text = replaced(text, "[[gnu::always_inline]] void assign", "void assign")
    # The library's build checks these counts of roundings; they are left out here.
    text = re.sub(r"(?m)^static_assert\((?:[^;\"]|\n)*?roundings(?:[^;\"]|\n)*?\);\n", "", text)
    text = re.sub(r"(?m)^struct (No)?Tally \{\n(.*\n)*?\};\n", "", text)
    # Behind the filters short code counts for more than inlined code.
    text = text.replace("friend Bounded operator", "[[gnu::noinline]] friend Bounded operator")
    text = text.replace("[[gnu::always_inline]] friend inline DoubleDoubleOf operator",
                        "[[gnu::noinline]] friend DoubleDoubleOf operator")
    # Templates are instantiated where they are called: all is in one source.
    text = re.sub(r"(?m)^#define SIGNUM_INSTANTIATE(.*\\\n)*.*\n", "", text)
    text = re.sub(r"(?m)^(#undef |SIGNUM_FOR_\w+\()?SIGNUM_INSTANTIATE.*\n", "", text)
    text = re.sub(r"\bsignum\b(?!_)", "rooms", text)
    text = text.replace("rooms needs IEEE", "signum needs IEEE")
    text = re.sub(r"\n{2,}", "\n", text).strip()
    if path == "exact/integer_rows.hpp":
        text = f"#if defined(__SIZEOF_INT128__)\n{text}\n#endif"
    return f"// ---- {path} " + "-" * max(3, 92 - len(path)) + f"\n\n{text}\n"


def made_source(version):
    includes = {"<initializer_list>"}
    sections = [section(path, includes) for path in SOURCES]
    # Those that floating_environment.hpp asks for under a condition stand in parts/guard.hpp.
    conditional = {"<immintrin.h>", "<cfenv>"}
    unknown = {"<bit>", "<span>", "<concepts>", "<compare>"}
    lines = "".join(f"#include {each}\n" for each in sorted(includes - conditional - unknown))
    guard = (ROOT / "single/parts/guard.hpp").read_text()
    body = "\n".join(sections)
    # Each of these stands in one room; a reworded one would leave its place here as it was.
    for here in ("SIGNUM_EXPECTS(condition) static_cast<void>(0)",
                 "[[gnu::noinline]] friend Bounded operator",
                 "[[gnu::noinline]] friend DoubleDoubleOf operator", "signum needs IEEE"):
        if here not in body:
            raise ValueError(f"no room has led to {here!r}")
    # What other code could write must not be local to this file.
    body = replaced(body, "alignas(16) extern float environment_witness[4];",
                    "using ::signum_environment_witness;")
    body = re.sub(r"\benvironment_witness", "signum_environment_witness", body)
    witness = re.search(r"\[\[gnu::used\]\][^;]*;", (ROOT / "filters/environment.cpp").read_text())[0]
    witness = witness.replace("environment_witness", "signum_environment_witness")
    api = without_comments((ROOT / "single/parts/c.cpp").read_text())
    return (NOTICE.format(version=version) + "\n#include \"signum_predicates.hpp\"\n\n" + lines +
            "\n" + guard.strip() + "\n\nextern \"C\" {\n"
            "extern float signum_environment_witness[4];\n" + witness + "\n}\n\n"
            "namespace {\n\n" + body + "\n}  // namespace\n\n" + api.strip() + "\n")


def c_declarations():
    """The predicates of the C interface that are here, as they stand there."""
    text = (ROOT / "bindings/c/signum.h").read_text()
    metric = text[text.index("typedef int32_t signum_metric;") : text.index("/// What the third number")]
    predicates = text[text.index("// ---- predicates") : text.index("// ---- tessellations of the plane")]
    blocks = predicates.strip().split("\n\n")
    kept = []
    for block in blocks:
        # Spheres of the three metrics with additive weights are not here.
        if "signum_spheres" in block or "SIGNUM_INFINITELY_MANY" in block:
            block = block[block.index("/// In the power metric, without a look") :]
        kept.append(block)
    text = metric + "\n" + "\n\n".join(kept)
    text = re.sub(r"/// Whether i alone hides q\.\nint signum_hidden_space\(.*\n", "", text)
    return text


def made_header(version):
    text = (ROOT / "single/parts/header.hpp").read_text()
    text = replaced(text, "// C_DECLARATIONS", c_declarations().strip())
    return NOTICE.format(version=version) + text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 where it differs")
    call = parser.parse_args()
    version = re.search(r"project\(\s*signum\s+VERSION\s+([\d.]+)",
                        (ROOT / "CMakeLists.txt").read_text())[1]
    wrong = 0
    for name, text in (("signum_predicates.hpp", made_header(version)),
                       ("signum_predicates.cpp", made_source(version))):
        path = ROOT / "single" / name
        if not call.check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            print(f"single/{name} is not what single/make.py makes: run it", file=sys.stderr)
            wrong = 1
    return wrong


if __name__ == "__main__":
    sys.exit(main())
