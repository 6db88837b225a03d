#!/usr/bin/env python3
"""Fails if a comment or a page of docs/ names a file, a function, a variable or an option that does not exist.

A file is a name with a suffix of the tree's languages (`residency.cpp`, `state/core/context.h`). It must be the end of
some path in the tree, or of a generated file. A function is a name with empty brackets (`settled()`), and must be a
word of the code; functions of GL, GLX, EGL, POSIX and the C++ library are exempt. Variables are ARBITER_NAMES; options
begin with two dashes and must belong to a program here.

usage: references.py ROOT | references.py --self-test
"""

import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree

CODE = {".h", ".cpp", ".def", ".py", ".sh", ".build"}
FILE = re.compile(r"(?<![\w/.*{}<>-])((?:[\w.-]+/)*[\w-]+\.(?:cpp|h|def|py|sh|toml|md))(?![\w(*-])")
FUNCTION = re.compile(r"(?<![\w.:>$-])((?:[A-Za-z_]\w*(?:::|\.))*[A-Za-z_]\w*)\(\)")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+[a-z]\b")
VARIABLE = re.compile(r"\bARBITER_[A-Z][A-Z0-9_]*[A-Z0-9]\b(?!\*)")
OTHERS = re.compile(r"(gl|glX|egl|X[A-Z]|wgl|std::|llvm::|pthread_|OSMesa|_mm|__builtin|Q[A-Z])")

# Files of other projects (Mesa, libglvnd, LLVM), generated files, and example names of a user's files.
OTHER_FILES = re.compile(
    r"(.*/)?(limits|glext|host_table|jit_version|main/config|i915_context|r300_pci_ids|lib(glx|egl)abi)\.h|"
    r"gl\.xml|(entry|software)_points\.cpp|host_table\.cpp|ErrorHandling\.cpp|(FILE|small)\.toml|"
    r"(.*/)?NAME\w*\.\w+|compile_commands\.json|CHANGELOG\.md|steam\.sh")
PROGRAMS = {"dev", "bench/run", "tests/fuzz/run"}  # without a suffix
OTHER_OPTIONS = {"--snapshot"}  # of glretrace


def tracked(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else []
    if not any(names):  # an archive of the tree, or a test
        names = [path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()]
    return [name for name in names if name and not name.startswith(("build", "out/"))]


def comments_of(name, text):
    """Yields (line number, text) of a source file's comments, or of a page's lines."""
    if name.endswith(".md"):
        fenced = False
        for number, line in enumerate(text.split("\n"), 1):
            if line.startswith("```"):
                fenced = not fenced
            elif not fenced:
                yield number, line
        return
    mark = "#" if name.endswith((".py", ".sh", ".build", ".toml")) else "//"
    for number, line in enumerate(text.split("\n"), 1):
        place = line.find(mark)
        if place >= 0 and line.count('"', 0, place) % 2 == 0 and line[place:place + 2] != "#i":
            yield number, line[place:]


def without_comments(name, text):
    if not name.endswith((".h", ".cpp", ".def")):
        return text
    return re.sub(r"//[^\n]*", "", text)


def complaints_of(root):
    names = tracked(root)
    ends = set()
    for name in names:
        parts = name.split("/")
        ends.update("/".join(parts[i:]) for i in range(len(parts)))
    words, options, texts = set(), set(), {}
    for name in names:
        if pathlib.PurePosixPath(name).suffix in CODE | {".md", ".toml"} or name in PROGRAMS:
            texts[name] = (root / name).read_text(errors="replace")
            if not name.endswith(".md"):
                code = without_comments(name, texts[name])
                words.update(re.findall(r"[A-Za-z_]\w*", code))
                options.update(OPTION.findall(code))
    read = 0
    complaints = []
    for name, text in texts.items():
        if not name.startswith(("src/", "docs/", "README.md", "CONTRIBUTING.md")):
            continue
        for number, comment in comments_of(name, text):
            read += 1
            for file in FILE.findall(comment):
                file = re.sub(r"^(\.\./)+", "", file)  # a link from a page
                if file not in ends and not OTHER_FILES.fullmatch(file):
                    complaints.append(f"{name}:{number}: no file {file}")
            for function in FUNCTION.findall(comment):
                last = re.split(r"::|\.", function)[-1]
                if last not in words and not OTHERS.match(function):
                    complaints.append(f"{name}:{number}: no function {function}()")
            for variable in VARIABLE.findall(comment):
                if variable not in words:
                    complaints.append(f"{name}:{number}: no variable {variable}")
            for option in OPTION.findall(comment):
                if option not in options | OTHER_OPTIONS:
                    complaints.append(f"{name}:{number}: no option {option}")
    return complaints, read


PLANTED = [
    # (text of src/a.h, complaints expected)
    ("/// See b.h, and src/b.h.\n", 0),
    ("/// See c.h.\n", 1),
    ("/// See docs/b.h.\n", 1),
    ("/// Called by work() and std::sort().\nvoid work();\n", 0),
    ("/// Called by worker().\nvoid work();\n", 1),
    ("// ARBITER_NOTHING switches it off.\n", 1),
    ("/// As --left says.\nconst char *kOption = \"--left\";\n", 0),
    ("/// As --right says.\nconst char *kOption = \"--left\";\n", 1),
    ('const char *kName = "c.h"; // b.h\n', 0),
]


if __name__ == "__main__":
    sys.exit(tree.main(__doc__, complaints_of,
                       [({"src/a.h": text, "src/b.h": ""}, expected) for text, expected in PLANTED],
                       "{read} comments and lines read, {wrong} name what is not there"))
