#!/usr/bin/env python3
"""Fails on a header that does not compile by itself.

A precompiled header declares names that a header forgets to include, so that a tree built with one
does not notice; the next build without one fails. Here each header of src, including generated ones,
is the only include of a source. It is compiled with the options of the nearest target, without a
precompiled header. Warnings count as complaints.

usage: lone_headers.py ROOT BUILD_TREE [HEADER...] | lone_headers.py --self-test
BUILD_TREE has a compile_commands.json, and its generated headers exist.
"""

import concurrent.futures
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

# These options take a word, and the others are irrelevant to a syntax check.
PAIRS = {"-include", "-o", "-MF", "-MQ", "-MT"}
DROPPED = {"-c", "-MD", "-MMD", "-fpch-preprocess", "-Winvalid-pch", "-fpch-deps"}
DROPPED_STARTS = ("-O", "-g", "-D_FORTIFY_SOURCE", "-fdiagnostics", "-Wno-pch")


def options_of(command):
    """Returns the compiler and its options without input, output, optimisation and precompiled header."""
    words = shlex.split(command)
    while "ccache" in pathlib.Path(words[0]).name:
        words.pop(0)
    kept, skip = [], False
    for word in words:
        if skip:
            skip = False
        elif word in PAIRS:
            skip = True
        elif word not in DROPPED and not word.startswith(DROPPED_STARTS) \
                and not word.endswith((".cpp", ".cc")):
            kept.append(word)
    return kept


class Tree:
    """The sources of a build tree, by folder."""

    def __init__(self, root, build):
        self.root, self.build = pathlib.Path(root).resolve(), pathlib.Path(build).resolve()
        self.commands = {}  # by folder, one for each set of options
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            if entry["file"].endswith((".cpp", ".cc")):
                source = os.path.normpath(os.path.join(entry["directory"], entry["file"]))
                self.commands.setdefault(os.path.dirname(source), {}).setdefault(
                    tuple(options_of(entry["command"])), entry["directory"])

    def headers(self):
        """Returns the headers of src and the generated ones, except those of precompiled headers."""
        found = sorted((self.root / "src").rglob("*.h"))
        generated = sorted((self.build / "src").rglob("*.h"))
        return [path for path in found + generated if "precompiled" not in path.parts]

    def nearest(self, header):
        """Returns (options, directory) of the targets in the header's folder, or in the nearest one to it."""
        wanted = str(self.root / header.relative_to(self.build)
                     if self.build in header.parents else header).split("/")
        return max(self.commands.items(), key=lambda each: len(
            os.path.commonprefix([each[0].split("/"), wanted])))[1].items()

    def complaint(self, header):
        """Returns the compiler's first error for the header alone; empty if it compiles in one of the targets."""
        for options, directory in self.nearest(header):
            done = subprocess.run(
                [*options, "-Werror", "-fsyntax-only", "-x", "c++", "-"], cwd=directory,
                input=f'#include "{header}"\n', capture_output=True, text=True)
            if done.returncode == 0:
                return ""
        lines = [line for line in done.stderr.splitlines() if "error:" in line]
        return f"{header.relative_to(self.root)}: does not compile alone: " \
            + (lines[0].split("error:")[1].strip() if lines else done.stderr.strip()[:200])


def check(root, build, names=()):
    """Returns complaints, and how many headers were compiled."""
    tree = Tree(root, build)
    headers = [pathlib.Path(name).resolve() for name in names] or tree.headers()
    complaints, show = [], sys.stderr.isatty()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done, complaint in enumerate(pool.map(tree.complaint, headers), 1):
            if complaint:
                complaints.append(complaint)
            if show:
                print(f"\r{done} of {len(headers)} headers", end="", file=sys.stderr)
    if show:
        print(file=sys.stderr)
    return complaints, len(headers)


def self_test():
    """Checks a good header and three bad ones, beside a source whose precompiled header hides one."""
    files = {
        "src/room/good.h": "#pragma once\n#include <string>\nstd::string good();\n",
        "src/room/lacks.h": "#pragma once\nstd::string lacks();\n",
        "src/room/warns.h": "#pragma once\ninline int warns() {}\n",
        "src/room/inner/deep.h": "#pragma once\nunsigned_t deep();\n",
        "src/room/source.cpp": '#include "room/lacks.h"\n',
        "src/precompiled/all.h": "#pragma once\n#include <string>\n",
    }
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        (root / "build").mkdir()
        (root / "build/compile_commands.json").write_text(json.dumps([{
            "directory": str(root / "build"), "file": "../src/room/source.cpp",
            "command": "ccache c++ -I../src -include ../src/precompiled/all.h -Wall -O2 -g -MD -MQ"
                       " x.o -MF x.d -o x.o -c ../src/room/source.cpp"}]))
        complaints, read = check(root, root / "build")
        assert read == 4, read
        named = sorted(complaint.split(":")[0] for complaint in complaints)
        assert named == ["src/room/inner/deep.h", "src/room/lacks.h", "src/room/warns.h"], complaints
    print("4 passed, 0 failed, 0 skipped")
    return 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    complaints, read = check(arguments[0], arguments[1], arguments[2:])
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    print(f"{read} headers compiled, {len(complaints)} complaints")
    return 1 if complaints or not read else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
