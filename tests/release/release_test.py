#!/usr/bin/env python3
"""Checks `./dev release` with suites of its own, in a repository of its own."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PATIENCE = 30  # seconds
sys.path.insert(0, str(ROOT / "scripts"))

import release  # noqa: E402

# Leaves the parts that its arguments give, once the file "go" is there.
SUITE = """
import json, pathlib, signal, sys, time
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    sys.exit("an interrupt would be ignored, and tests send some")
name, status, wait = sys.argv[1], int(sys.argv[2]), sys.argv[3] == "wait"
with open("out/runs", "a") as runs:
    runs.write(name + "\\n")
while wait and not pathlib.Path("out/go").exists():
    time.sleep(0.02)
pathlib.Path("out/test").mkdir(parents=True, exist_ok=True)
pathlib.Path("out/test/part.json").write_text(json.dumps(
    {"name": name, "passed": 3, "failed": status, "skipped": 2, "failures": ["case"] * status,
     "skips": {"no display": 2}}))
print("a line of " + name)
sys.exit(status)
"""


class Release(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.scratch.name)
        (self.root / "out").mkdir()
        (self.root / ".gitignore").write_text("/out/\n")
        (self.root / "suite.py").write_text(SUITE)
        self.suites("one 0 quick", "two 0 quick", "three 0 quick")
        for words in (["init", "-q"], ["config", "user.email", "a@b"], ["config", "user.name", "a"]):
            self.git(*words)
        self.commit()

    def tearDown(self):
        self.scratch.cleanup()

    def git(self, *words):
        return release.git(self.root, *words)

    def commit(self):
        self.git("add", ".")
        self.git("commit", "-qm", "a change", "--allow-empty")

    def suites(self, *rows, more=""):
        text = ""
        for row in rows:
            name = row.split()[0]
            command = json.dumps(["sh", "-c", f"{sys.executable} suite.py {row}; exit $?"])
            text += f'[[suite]]\nname = "{name}"\ntitle = "{name}"\ncommand = {command}\nminutes = 1\n{more}\n'
        (self.root / "suites.toml").write_text(text)

    def command(self, *words):
        return [sys.executable, str(ROOT / "scripts" / "release.py"), "--root", str(self.root),
                "--suites", str(self.root / "suites.toml"), *words]

    def run_release(self, *words):
        return subprocess.run(self.command(*words), capture_output=True, text=True, timeout=60)

    def runs(self):
        path = self.root / "out" / "runs"
        return path.read_text().split() if path.exists() else []

    def wait_for_runs(self, count):
        """Waits until so many suites have begun."""
        end = time.monotonic() + PATIENCE
        while len(self.runs()) < count:
            self.assertLess(time.monotonic(), end, f"{count} suites have not begun")
            time.sleep(0.02)

    def result(self, name):
        return json.loads((self.root / "out" / "release" / self.git("rev-parse", "HEAD") / f"{name}.json").read_text())

    def test_each_suite_runs_once_a_commit(self):
        done = self.run_release()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.run_release().returncode, 0)
        self.assertEqual(self.runs(), ["one", "two", "three"])
        result = self.result("two")
        self.assertEqual((result["passed"], result["failed"], result["skipped"]), (3, 0, 2))
        self.assertEqual(result["skips"], {"no display": 2})
        self.assertEqual(result["commit"], self.git("rev-parse", "HEAD"))
        self.assertEqual([row["result"] for row in self.result("release")["suites"]], ["passed"] * 3)
        (self.root / "code").write_text("another")
        self.commit()
        self.assertEqual(self.run_release("--list").returncode, release.NOT_RUN)
        self.assertEqual(self.run_release("two").returncode, release.NOT_RUN)
        self.assertEqual(self.runs(), ["one", "two", "three", "two"])
        self.assertEqual(self.run_release("two", "--again").returncode, release.NOT_RUN)
        self.assertEqual(self.runs()[-2:], ["two", "two"])

    def test_a_result_stands_until_a_file_changes_that_the_suite_reads(self):
        table = self.root / "suites.toml"
        table.write_text(table.read_text() + '[[files]]\npaths = ["docs/*", "suites.toml"]\nread_by = ["two"]\n')
        (self.root / "docs").mkdir()
        self.commit()
        self.assertEqual(self.run_release().returncode, 0)
        first = self.git("rev-parse", "HEAD")
        (self.root / "docs" / "page").write_text("a page")
        self.commit()
        listed = self.run_release("--list")
        self.assertEqual(listed.returncode, release.NOT_RUN)
        self.assertRegex(listed.stdout, rf"one .* passed at {first[:12]}\ntwo +not run\n")
        self.assertEqual(self.run_release().returncode, 0)
        self.assertEqual(self.runs(), ["one", "two", "three", "two"])
        self.assertEqual([row["commit"] for row in self.result("release")["suites"]],
                         [first, self.git("rev-parse", "HEAD"), first])
        table.write_text(table.read_text().replace("suite.py one", "suite.py  one"))
        self.commit()
        self.run_release()
        self.assertEqual(self.runs()[4:], ["one", "two"], "another command, and a file that it reads")
        (self.root / "code").write_text("what no row names")
        self.commit()
        self.run_release("three")
        self.assertEqual(self.runs()[6:], ["three"])
        (self.root / "docs" / "meson.build").write_text("what a build reads")
        self.commit()
        self.run_release("three")
        self.assertEqual(self.runs()[7:], ["three"])

    def test_a_result_of_another_line_of_commits_does_not_stand(self):
        self.run_release("one")
        self.git("commit", "-q", "--amend", "-m", "the same files")
        self.assertRegex(self.run_release("--list").stdout, r"one +not run")

    def test_files_are_read_by_suites_that_exist(self):
        table = self.root / "suites.toml"
        table.write_text(table.read_text() + '[[files]]\npaths = ["docs/*"]\nread_by = ["for"]\n')
        self.assertIn("no suite for", self.run_release("--list").stderr)
        for files in release.tomllib.loads(release.SUITES.read_text())["files"]:
            for path in files["paths"]:
                self.assertTrue(any(ROOT.glob(path.replace("/*", "/**/*"))), path)

    def test_it_goes_on_where_it_was_killed(self):
        self.suites("one 0 quick", "two 0 wait", "three 0 quick")
        self.commit()
        for turn, number in enumerate((signal.SIGTERM, signal.SIGKILL)):
            child = subprocess.Popen(self.command(), stdout=subprocess.DEVNULL)
            self.wait_for_runs(2 + turn)
            child.send_signal(number)
            self.assertNotEqual(child.wait(timeout=PATIENCE), 0)
            with self.assertRaises(FileNotFoundError):
                self.result("two")
        (self.root / "out" / "go").write_text("")
        self.assertEqual(self.run_release().returncode, 0)
        self.assertEqual(self.runs(), ["one", "two", "two", "two", "three"])
        self.assertEqual(self.result("two")["passed"], 3)

    def test_a_killed_one_leaves_no_suite_behind(self):
        self.suites("one 0 wait")
        self.commit()
        child = subprocess.Popen(self.command(), stdout=subprocess.DEVNULL)
        self.wait_for_runs(1)
        second = self.run_release()
        self.assertIn("another one is under way", second.stderr)
        child.kill()
        child.wait()
        time.sleep(1)
        (self.root / "out" / "go").write_text("")
        time.sleep(0.2)
        self.assertFalse((self.root / "out" / "test").exists(), "the suite went on")

    def test_failures_are_counted_and_others_go_on(self):
        self.suites("one 1 quick", "two 0 quick")
        self.commit()
        done = self.run_release()
        self.assertEqual(done.returncode, 1)
        self.assertEqual(self.result("one")["failures"], ["case"])
        self.assertEqual(self.runs(), ["one", "two"])
        self.assertRegex(done.stdout, r"one +3 +1 +2 +0  failed")
        self.assertIn("a line of one", next((self.root / "out" / "release").glob("*/one.log")).read_text())

    def test_a_suite_may_have_a_machine_of_its_own(self):
        self.suites("one 0 quick", "two 0 quick")
        table = self.root / "suites.toml"
        leaves = "mkdir -p out/test; echo '{\\\"renderer\\\": \\\"of one\\\"}' >out/test/.machine; "
        table.write_text(table.read_text().replace('"-c", "', f'"-c", "{leaves}', 1))
        self.commit()
        self.assertEqual(self.run_release().returncode, 0)
        self.assertEqual(self.result("one")["machine"], {"renderer": "of one"})
        self.assertNotEqual(self.result("two")["machine"]["renderer"], "of one", "the machine of the suite before")
        self.assertEqual(self.result("two")["machine"]["cores"], os.cpu_count())

    def test_the_tree_must_be_the_commits(self):
        (self.root / "suite.py").write_text(SUITE + "\n")
        done = self.run_release()
        self.assertEqual(done.returncode, 1)
        self.assertIn("suite.py", done.stderr)
        self.assertEqual(self.runs(), [])

    def test_a_tree_that_changes_meanwhile_gives_no_result(self):
        self.suites("one 0 wait")
        self.commit()
        before = self.git("rev-parse", "HEAD")
        child = subprocess.Popen(self.command(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.wait_for_runs(1)
        self.commit()
        (self.root / "out" / "go").write_text("")
        self.assertIn("became another commit", child.communicate(timeout=PATIENCE)[1])
        self.assertFalse((self.root / "out" / "release" / before / "one.json").exists())

    def test_what_does_not_fit_a_sitting_is_left(self):
        done = self.run_release("--sitting", "0.5")
        self.assertEqual(done.returncode, release.NOT_RUN)
        self.assertEqual(self.runs(), [])
        self.assertIn("left to another sitting", done.stdout)

    def test_suites_that_others_have_run_are_left_out(self):
        row = {"suite": "two", "passed": 1, "failed": 1, "skipped": 0, "seconds": 60, "status": 1,
               "date": "2026-12-01T00:00:00Z", "commit": self.git("rev-parse", "HEAD")}
        file = self.root / "out" / "published.json"
        file.write_text(json.dumps({"results": [row, {**row, "suite": "three", "commit": "f" * 40}]}))
        done = self.run_release("--published", str(file))
        self.assertEqual(self.runs(), ["one", "three"])
        self.assertEqual(done.returncode, 1, "what others saw fail has failed")
        self.assertRegex(done.stdout, r"two +1 +1 +0 +1  failed")

    def test_engines_are_for_the_suites_that_take_them(self):
        self.suites("one 0 quick", more="engine = true")
        self.commit()
        self.run_release("--engine", "parallel", "--shards", "8")
        self.assertEqual(self.result("one")["command"][-2:], ["--engine=parallel", "--shards=8"])

    def test_unknown_suites_are_named(self):
        self.assertIn("no suite nought", self.run_release("nought").stderr)


class Counts(unittest.TestCase):
    def test_of_parts_of_a_line_or_of_the_end(self):
        part = {"name": "a", "passed": 1, "failed": 2, "skipped": 3, "failures": ["x", "y"]}
        self.assertEqual(release.summed([part, part], 1, "")["failed"], 4)
        log = "1 passed, 0 failed, 0 skipped\n5 passed, 0 failed, 2 skipped\n"
        self.assertEqual(release.summed([], 0, log)["passed"], 5)
        self.assertEqual(release.summed([], 1, "")["failed"], 1)
        self.assertFalse(release.passed({"status": 0, "failed": 1}))
        self.assertFalse(release.passed({"status": 1, "failed": 0}))

    def test_the_suites_of_the_project_are_verbs(self):
        verbs = subprocess.run(["grep", "-oE", r"^verb_\w+", str(ROOT / "dev")], capture_output=True, text=True).stdout
        for suite in release.suites_of(release.SUITES):
            self.assertEqual(suite["command"][0], "./dev")
            self.assertIn("verb_" + suite["command"][1], verbs.split(), suite["name"])


if __name__ == "__main__":
    unittest.main()
