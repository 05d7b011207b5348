#!/usr/bin/env python3
"""Which names the shared library exports: what its installed headers declare and do not define.

    packaging/exports.py INCLUDE           writes exports.map beside this script
    packaging/exports.py INCLUDE --check   ends with 1 where that file is not what would be written

INCLUDE/signum has the headers as they are installed. clang++ reads them (CLANG says which one). A function
whose body is in a header is compiled by its users; a private member that no header calls is nobody's.
The patterns are demangled names up to their parameters, so that they hold for every standard library.
"""
import json
import os
import pathlib
import re
import subprocess
import sys

FUNCTIONS = {"FunctionDecl", "CXXMethodDecl", "CXXConstructorDecl", "CXXDestructorDecl", "CXXConversionDecl"}
CLASSES = {"CXXRecordDecl", "ClassTemplateSpecializationDecl"}
MAP = pathlib.Path(__file__).resolve().parent / "exports.map"


def syntax_trees(include):
    """What clang++ makes of namespace signum, all headers together. bindings/interop/ needs libraries of others."""
    headers = sorted(header.relative_to(include) for header in (include / "signum").rglob("*.hpp")
                     if "interop" not in header.parts)
    clang = os.environ.get("CLANG", "clang++")
    dump = subprocess.run([clang, "-std=c++20", "-fsyntax-only", f"-I{include}", "-x", "c++", "-",
                           "-Xclang", "-ast-dump=json", "-Xclang", "-ast-dump-filter=signum"],
                          input="".join(f"#include <{header}>\n" for header in headers),
                          stdout=subprocess.PIPE, text=True, check=True).stdout
    decoder, at = json.JSONDecoder(), 0
    while (at := dump.find("{", at)) >= 0:
        tree, at = decoder.raw_decode(dump, at)
        yield tree


class Declarations:
    def __init__(self):
        self.patterns = {}     # by the number clang gives a declaration
        self.private = {}      # its name, where only its class may call it
        self.defined = set()   # numbers
        self.called = set()    # numbers and, where a template leaves open which, names

    def read(self, node, scope="", private=False, template=False):
        kind, name = node.get("kind"), re.sub("<.*", "", node.get("name", ""))
        inner = node.get("inner", [])
        if kind == "NamespaceDecl":
            for child in inner:
                self.read(child, f"{scope}{name}::")
        elif kind in ("FunctionTemplateDecl", "ClassTemplateDecl"):  # what is behind the pattern are its instances
            for child in inner:
                if child.get("kind") in FUNCTIONS | {"CXXRecordDecl"}:
                    self.read(child, scope, private, template=True)
                    break
        elif kind in CLASSES:
            of_template = "<*>" if template or kind != "CXXRecordDecl" else ""
            private = node.get("tagUsed") == "class"
            for child in inner:
                if child.get("kind") == "AccessSpecDecl":
                    private = child["access"] == "private"
                else:
                    self.read(child, f"{scope}{name}{of_template}::", private)
        elif kind in FUNCTIONS:
            self.read_function(node, scope + name, private, template)
        elif kind == "VarDecl" and node.get("storageClass") == "extern":
            self.patterns[node["id"]] = scope + name

    def read_function(self, node, name, private, template):
        inner = node.get("inner", [])
        self.note_calls(inner)
        if any(child.get("kind") in ("CompoundStmt", "CXXTryStmt") for child in inner):
            self.defined |= {node["id"], node.get("previousDecl")}
        elif not (node.get("isImplicit") or node.get("explicitlyDefaulted") or node.get("explicitlyDeleted")):
            pattern = re.sub(r"[^\w:*]", "?", name) + "[!a-zA-Z0-9_]*"  # there are none with ~, <, >, = or (
            self.patterns[node["id"]] = f"{start_of_type(node)}*[!0-?]{pattern}" if template else pattern
            if private:
                self.private[node["id"]] = name.rpartition("::")[2]

    def note_calls(self, nodes):
        for node in nodes:
            self.called |= {node.get("referencedMemberDecl"), node.get("referencedDecl", {}).get("id")}
            if node.get("kind", "").startswith(("Unresolved", "CXXDependentScope")):
                self.called |= {node.get("name"), node.get("member")}
            self.note_calls(node.get("inner", []))

    def exported(self):
        return sorted({pattern for number, pattern in self.patterns.items()
                       if number not in self.defined
                       and (number not in self.private or self.called & {number, self.private[number]})})


def start_of_type(function):
    """An instance of a template is named with its type in front. Without that the pattern would hold for what is
    inside the function, too, and for templates of such types (of 0-? one is <)."""
    first = re.match(r"[\w:]+", function["type"]["qualType"])[0]
    if first.startswith("std::"):
        return first.replace("std::", "std::*")  # libc++ has a namespace between
    return first if first in ("void", "bool", "int", "double") else "signum::"


def text_of_map(include):
    declarations = Declarations()
    for tree in syntax_trees(include):
        declarations.read(tree)
    patterns = declarations.exported()
    if len(patterns) < 100:
        sys.exit(f"exports.py: only {len(patterns)} names in the headers of {include}")
    version = re.search(r"project\(signum VERSION (\d+\.\d+)", (MAP.parent.parent / "CMakeLists.txt").read_text())[1]
    lines = [f"        {pattern};" for pattern in patterns]
    return "\n".join(["# What the shared library exports; written by packaging/exports.py from the installed headers.",
                      f"SIGNUM_{version} {{", "    global:", "      signum_*;", '      extern "C++" {', *lines,
                      "      };", "    local: *;", "};", ""])


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--check"]):
        sys.exit(__doc__)
    text = text_of_map(pathlib.Path(sys.argv[1]))
    if sys.argv[2:] == []:
        MAP.write_text(text)
    elif MAP.read_text() != text:
        sys.exit("packaging/exports.map is not what the installed headers declare: packaging/exports.py writes it")
