#!/usr/bin/env python3
"""Tests scripts/plants.py in a small repository: faults that are found and missed, texts that do not fit, and that the
tree is as before however a run ends; and that each row of the project's own table fits the tree."""

import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts/plants.py"
sys.path.insert(0, str(ROOT / "scripts"))

import plants  # noqa: E402

SOURCE = "one\ntwo\ntwo\nthree\n"
FINDS = "if grep -q FAULT a.txt; then echo a fault; exit 3; fi"


def row(name, command, *, find="one\n", put="FAULT\n", says="a fault", **more):
    """Returns the text of a row whose command is a line of a shell."""
    values = {"name": name, "title": "planted", "file": "a.txt", "find": find, "put": put,
              "command": ["sh", "-c", command], "says": says, "minutes": 1, **more}
    return "[[plant]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in values.items()
                                   if value is not None)


class Repository(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory(prefix="arbiter-plants-")
        self.addCleanup(place.cleanup)
        self.root, self.table = pathlib.Path(place.name) / "tree", pathlib.Path(place.name) / "plants.toml"
        self.root.mkdir()
        (self.root / "a.txt").write_text(SOURCE)
        (self.root / ".gitignore").write_text("out/\n")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("-c", "user.name=a", "-c", "user.email=a@example.org", "commit", "-qm", "a")

    def git(self, *words):
        return subprocess.run(["git", "-C", self.root, *words], check=True, capture_output=True, text=True).stdout

    def command(self, *words):
        return [sys.executable, SCRIPT, "--root", self.root, "--table", self.table, *words]

    def run_plants(self, *rows, names=()):
        """Returns the status, what was printed, and the part that was left."""
        self.table.write_text("\n".join(rows))
        counts = self.root.parent / "counts.json"
        counts.unlink(missing_ok=True)
        done = subprocess.run(self.command("--counts", counts, *names), capture_output=True, text=True, timeout=60)
        return done.returncode, done.stdout + done.stderr, json.loads(counts.read_text()) if counts.exists() else None

    def assert_clean(self):
        self.assertEqual(self.git("status", "--porcelain"), "")
        self.assertEqual((self.root / "a.txt").read_text(), SOURCE)

    def test_a_fault_that_its_command_finds(self):
        status, said, part = self.run_plants(row("a", FINDS))
        self.assertEqual((status, part["passed"], part["failed"]), (0, 1, 0), said)
        self.assertEqual((part["plants"][0]["found"], part["plants"][0]["status"]), (True, 3))
        self.assertEqual((self.root / "out/plants/a.log").read_text(), "a fault\n")
        self.assert_clean()

    def test_a_fault_that_is_missed(self):
        for command in ("true", "echo a fault", "echo of another kind; exit 1", "no-such-command"):
            with self.subTest(command=command):
                status, said, part = self.run_plants(row("a", command), row("b", FINDS))
                self.assertEqual((status, part["passed"], part["failed"]), (1, 1, 1), said)
                self.assertTrue(part["failures"][0].startswith("a: "), part)
                self.assert_clean()

    def test_a_text_that_is_not_there_once(self):
        for find in ("two\n", "four\n"):
            status, said, part = self.run_plants(row("a", FINDS, find=find))
            self.assertEqual((status, part["failed"]), (1, 1), said)
            self.assertIn("times, and not once", part["failures"][0])
            self.assert_clean()

    def test_a_new_file(self):
        new = {"file": "b.txt", "find": None, "put": None, "create": "FAULT\n"}
        self.assertEqual(self.run_plants(row("a", "! grep FAULT b.txt", says="FAULT", **new))[0], 0)
        self.assert_clean()
        self.assertEqual(self.run_plants(row("a", "exit 1", **{**new, "file": "a.txt"}))[0], 1)
        self.assert_clean()

    def test_names_choose(self):
        rows = row("a", "exit 1"), row("b", FINDS)
        self.assertEqual(self.run_plants(*rows, names=["b"])[0], 0)
        status, said, part = self.run_plants(*rows, names=["c"])
        self.assertEqual((status, part), (1, None))
        self.assertIn("no plant c; there are a, b", said)

    def test_a_bad_table(self):
        for text in (row("a", FINDS) + row("a", FINDS), row("a", FINDS, says=None), row("a", FINDS, more="x"),
                     row("a", FINDS, create="x"), row("a", FINDS, put=None)):
            self.assertEqual(self.run_plants(text)[::2], (1, None), text)

    def test_a_tree_with_changes_stays_as_it_is(self):
        for name in ("a.txt", "b.txt"):
            (self.root / name).write_text("mine\n")
            status, said, part = self.run_plants(row("a", FINDS))
            self.assertEqual((status, part), (1, None))
            self.assertIn("not as a commit has it", said)
            self.assertEqual((self.root / name).read_text(), "mine\n")

    def begun(self):
        """Returns a run whose command is under way."""
        self.table.write_text(row("a", "touch out/begun; sleep 60; exit 1"))
        child = subprocess.Popen(self.command(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        begun, end = self.root / "out/begun", time.monotonic() + 30
        while not begun.exists() and time.monotonic() < end:
            time.sleep(0.02)
        begun.unlink()
        self.assertIn("FAULT", (self.root / "a.txt").read_text())
        return child

    def test_a_run_that_is_ended_takes_the_fault_back(self):
        for ending in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            child = self.begun()
            child.send_signal(ending)
            self.assertEqual(child.wait(timeout=30), 128 + ending)
            self.assert_clean()

    def test_the_next_run_takes_back_what_a_killed_one_left(self):
        child = self.begun()
        child.kill()
        child.wait()
        self.assertNotEqual(self.git("status", "--porcelain"), "")
        self.assertEqual(self.run_plants(row("b", FINDS))[0], 0)
        self.assert_clean()

    def test_what_was_changed_after_a_kill_stays(self):
        child = self.begun()
        child.kill()
        child.wait()
        (self.root / "a.txt").write_text("mine\n")
        self.assertEqual(self.run_plants(row("b", FINDS))[0], 1)
        self.assertEqual((self.root / "a.txt").read_text(), "mine\n")


class Table(unittest.TestCase):
    def test_each_row_fits_the_tree(self):
        verbs = re.findall(r"^verb_(\w+)\(\)", (ROOT / "dev").read_text(), re.M)
        for name, plant in plants.rows(plants.TABLE).items():
            with self.subTest(plant=name):
                self.assertTrue(plants.planted_text(ROOT, plant))
                called = re.findall(r"\./dev (\w+)", " ".join(plant["command"]))
                self.assertTrue(called and set(called) <= set(verbs), plant["command"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
