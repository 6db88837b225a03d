#!/usr/bin/env python3
"""Checks which objects scripts/changed_objects.py names, in a repository of its own."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

import changed_objects  # noqa: E402

FILES = {
    "src/low.h": "int low();\n",
    "src/room/high.h": '#include "low.h"\n',
    "src/room/user.cpp": '#include "room/high.h"\n',
    "src/room/beside.cpp": '#include "high.h"\n',
    "src/other.cpp": "#include <low.h.in>\n",
    "docs/page.md": "a page\n",
}
SOURCES = ("room/user", "room/beside", "other")


class ChangedObjects(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.root = pathlib.Path(holder.name)
        self.tree = self.root / "build"
        self.tree.mkdir()
        rows = [{"directory": str(self.tree), "file": f"../src/{name}.cpp", "output": f"{name}.o"} for name in SOURCES]
        rows.append({"directory": str(self.tree), "file": "made.cpp", "output": "made.o"})
        (self.tree / "made.cpp").write_text("")
        (self.tree / "compile_commands.json").write_text(json.dumps(rows))
        self.git("init", "-q", "-b", "main")
        self.write("src/low.h", "")
        for name, text in FILES.items():
            self.write(name, text)
        self.commit()

    def git(self, *words):
        subprocess.run(["git", "-C", str(self.root), "-c", "user.name=a", "-c", "user.email=a@b.c", *words], check=True)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def commit(self):
        self.git("add", "src", "docs")
        self.git("commit", "-qm", "one")

    def objects(self, commits):
        return set(changed_objects.chosen(self.root, self.tree, changed_objects.changed(self.root, commits)))

    def after(self, name):
        """Returns the objects after a commit of this file alone."""
        self.write(name, (self.root / name).read_text() + "// more\n")
        self.commit()
        return self.objects(1)

    def test_a_source_that_changed(self):
        self.assertEqual(self.after("src/other.cpp"), {"other.o", "made.o"})

    def test_who_includes_a_header_at_any_depth(self):
        self.assertEqual(self.after("src/low.h"), {"room/user.o", "room/beside.o", "made.o"})
        self.assertEqual(self.after("src/room/high.h"), {"room/user.o", "room/beside.o", "made.o"})

    def test_no_source_includes_a_page(self):
        self.assertEqual(self.after("docs/page.md"), {"made.o"})

    def test_the_commits_before_do_not_count(self):
        self.after("src/low.h")
        self.after("src/other.cpp")
        self.assertEqual(self.objects(1), {"other.o", "made.o"})
        self.assertEqual(self.objects(2), {"other.o", "room/user.o", "room/beside.o", "made.o"})

    def test_what_is_not_committed_counts(self):
        self.write("src/other.cpp", "int other;\n")
        self.assertEqual(self.objects(0), {"other.o", "made.o"})

    def test_all_where_there_are_fewer_commits(self):
        self.assertEqual(len(self.objects(9)), len(SOURCES) + 1)

    def test_all_where_there_is_no_git(self):
        with mock.patch.dict(os.environ, PATH=""):
            self.assertEqual(len(self.objects(0)), len(SOURCES) + 1)


if __name__ == "__main__":
    unittest.main()
