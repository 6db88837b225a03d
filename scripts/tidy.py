#!/usr/bin/env python3
"""Runs clang-tidy on each source of src/ and demos/ that a tree compiles, tests aside.

usage: tidy.py BUILD KEPT      BUILD: a tree that compiles each source on its own
       tidy.py --self-test

A source that passed is not looked at again as long as it, what it includes, its flags and the rules stay the same:
KEPT is a folder with one empty file for each state that passed. The status is 1 if a source has complaints.
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
STEP = 20  # sources between two lines of progress


def entries_of(build, root):
    """Returns the rows of the tree's table of commands to look at, one for each source, by its path."""
    rows = {}
    for row in json.loads((build / "compile_commands.json").read_text()):
        source = pathlib.Path(os.path.realpath(os.path.join(row["directory"], row["file"])))
        if re.search(r"-unity\d*\.cpp$", source.name):
            sys.exit(f"{build} compiles units of sources; a tree without b_pch is needed")
        inside = source.is_relative_to(root / "src") or source.is_relative_to(root / "demos")
        if inside and not source.name.endswith("_test.cpp"):
            rows.setdefault(source, row)
    return sorted(rows.items())


class Tidy:
    """clang-tidy, with what it has found good already."""

    def __init__(self, build, kept, root):
        self.build, self.kept = build, kept
        kept.mkdir(parents=True, exist_ok=True)
        version = subprocess.run(["clang-tidy", "--version"], check=True, capture_output=True).stdout
        self.rules = version + (root / ".clang-tidy").read_bytes()
        self.texts = {}

    def text_hash(self, path):
        """Returns the hash of a file's text, read once."""
        if path not in self.texts:
            self.texts[path] = hashlib.sha256(pathlib.Path(path).read_bytes()).digest()
        return self.texts[path]

    def state(self, row):
        """Returns the name of all that a complaint depends on; None if the compiler cannot read the source."""
        words = iter(shlex.split(row["command"]))
        words = [word for word in words
                 if word not in ("-c", "-MD") and not (word in ("-o", "-MQ", "-MF") and next(words))]
        listed = subprocess.run([*words, "-M"], cwd=row["directory"], capture_output=True, text=True)
        if listed.returncode != 0:
            return None
        state = hashlib.sha256(self.rules + "\0".join(words).encode())
        for path in sorted(set(listed.stdout.replace("\\\n", " ").split(": ", 1)[1].split())):
            state.update(path.encode() + self.text_hash(os.path.join(row["directory"], path)))
        return state.hexdigest()

    def look(self, source, row):
        """Returns whether clang-tidy ran, and its complaints, "" for none."""
        state = self.state(row)
        if state and (self.kept / state).exists():
            return False, ""
        done = subprocess.run(["clang-tidy", "-p", self.build, "--quiet", source], capture_output=True, text=True)
        if done.returncode == 0:
            if state:
                (self.kept / state).touch()
            return True, ""
        return True, done.stdout or done.stderr or f"{source}: clang-tidy ended with status {done.returncode}"


def run(build, kept, root):
    """Prints the complaints and a line of counts; returns how many sources have some, and how many were looked at."""
    tidy, rows = Tidy(build, kept, root), entries_of(build, root)
    looked = bad = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        waiting = [pool.submit(tidy.look, source, row) for source, row in rows]
        for number, done in enumerate(concurrent.futures.as_completed(waiting), 1):
            ran, complaints = done.result()
            looked, bad = looked + ran, bad + bool(complaints)
            if complaints:
                print(complaints, flush=True)
            if number % STEP == 0 or number == len(rows):
                print(f"{number}/{len(rows)} sources, {looked} looked at, {bad} with complaints", flush=True)
    return bad, looked


def self_test():
    """Ends the program unless a planted fault is found, and only what changed is looked at again."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder).resolve()
        header, source, other = root / "src" / "a.h", root / "src" / "a.cpp", root / "src" / "b.cpp"
        header.parent.mkdir()
        (root / ".clang-tidy").write_text((ROOT / ".clang-tidy").read_text())
        header.write_text("inline double half(int n) { return n / 2.0; }\n")
        source.write_text('#include "a.h"\ndouble a(int n) { return half(n); }\n')
        other.write_text("int b() { return 1; }\n")
        rows = [{"directory": folder, "file": f"src/{name}.cpp",
                 "command": f"g++ -MD -MQ {name}.o -MF {name}.d -o {name}.o -c src/{name}.cpp"} for name in "ab"]
        (root / "compile_commands.json").write_text(json.dumps(rows))

        def looked_at(expected, why):
            if run(root, root / "kept", root) != expected:
                sys.exit(f"tidy.py: {why}")

        looked_at((0, 2), "both sources are to be looked at first")
        looked_at((0, 0), "what passed is looked at again")
        header.write_text("inline double half(int n) { return n / 2; }\n")
        looked_at((1, 1), "a fault in a header is not found")
        looked_at((1, 1), "what failed is not looked at again")
        (root / ".clang-tidy").write_text("Checks: '-*,bugprone-infinite-loop'\n")
        looked_at((0, 2), "other rules do not look again")
        silent = root / "bin" / "clang-tidy"
        silent.parent.mkdir()
        silent.write_text('#!/bin/sh\n[ "$1" = --version ]\n')
        silent.chmod(0o755)
        os.environ["PATH"] = f"{silent.parent}:{os.environ['PATH']}"
        looked_at((2, 2), "one that ends without a word has passed")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    elif len(sys.argv) == 3:
        sys.exit(run(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]), ROOT)[0] > 0)
    else:
        sys.exit(__doc__)
