#!/usr/bin/env python3
"""Prints the object files of a build tree that recent commits may have broken, a line each.

usage: changed_objects.py TREE COMMITS

Those are of sources that differ from what they were so many commits ago, and of sources that include a header that
does, directly or through others; files that are not committed yet count too. Where there are fewer commits it is all
objects. What is generated depends on more than includes: its objects are always among them."""

import collections
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "include_graph"))

from tree import includes  # noqa: E402


def git(root, *words):
    """Returns the lines that a git command prints, None where it fails or there is no git."""
    try:
        done = subprocess.run(["git", "-C", str(root), *words], capture_output=True, text=True)
    except FileNotFoundError:
        return None
    return done.stdout.splitlines() if done.returncode == 0 else None


def changed(root, commits):
    """Returns the names of the files that differ from so many commits ago, None if there are fewer."""
    tracked = git(root, "diff", "--name-only", f"HEAD~{commits}")
    others = git(root, "ls-files", "--others", "--exclude-standard")
    return None if tracked is None or others is None else set(tracked) | set(others)


def reached(names, graph):
    """Returns the files that include one of these, at any depth, and these. graph: {file: files that it includes}"""
    users = collections.defaultdict(set)
    for name, used in graph.items():
        for other in used:
            users[other].add(name)
    found, left = set(), list(names)
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            left += users[name]
    return found


def graph_of(root):
    """Returns {source or header: those of this tree that it includes}, by names from the root."""
    graph = {}
    for folder in ("src", "include"):
        for path, rows in includes(root / folder):
            beside = path.parent
            places = [place / name for _, name in rows for place in (root / "src", root / "include", beside)]
            graph[str(path.relative_to(root))] = {os.path.relpath(place, root) for place in places if place.exists()}
    return graph


def chosen(root, tree, names):
    """Returns the objects of the tree for changed files; None as names stands for all files."""
    rows = json.loads((tree / "compile_commands.json").read_text())
    wanted = None if names is None else reached(names, graph_of(root))
    objects = []
    for row in rows:
        source = os.path.relpath(os.path.join(row["directory"], row["file"]), root)
        generated = not (root / source).exists() or (root / source).is_relative_to(tree)
        if wanted is None or generated or source in wanted:
            objects.append(row["output"])
    return objects


def main():
    if len(sys.argv) != 3 or not sys.argv[2].isdigit():
        print(__doc__, file=sys.stderr)
        return 2
    objects = chosen(ROOT, pathlib.Path(sys.argv[1]).resolve(), changed(ROOT, int(sys.argv[2])))
    print("\n".join(objects))
    return 0


if __name__ == "__main__":
    sys.exit(main())
