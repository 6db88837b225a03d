#!/usr/bin/env python3
"""Tests scripts/leaks.py with texts of reports, and with a program that leaks in several ways under the options that
./dev asan has: what the tree's code leaks is found, and what a host leaks, loaded or unloaded, is not."""

import argparse
import contextlib
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import leaks  # noqa: E402

STATS = leaks.EXITED + "\nStats: 0M malloced (0M for red zones) by 9 calls\n"
TREE = pathlib.Path("/tree/build")
OWN = f"void own() at {ROOT}/src/a.cpp:7 of /tree/build/lib/libown.so.0+0x7c"
INLINED = "std::vector<int>::reserve() at /usr/include/c++/12/bits/vector.tcc:70 of /tree/build/lib/libown.so.0+0x7c"
HOST = "driver at <null> of /usr/lib/dri/swrast_dri.so+0x99"
UNLOADED = "<null> at <null> of <null>+0x7f0012345678"
STALE = "<null> at <null> of /tree/build/lib/libown.so.0+0x7c"
LLVM = "llvm::Module::make() at <null> of /tree/build/lib/libown.so.0+0x7c"
MALLOC = "malloc at ../asan.cpp:3 of /usr/lib/x86_64-linux-gnu/libasan.so.8+0x1"
STRDUP = "strdup at <null> of /usr/lib/x86_64-linux-gnu/libc.so.6+0x1"
ERROR = ("=================\n==a==5==ERROR: AddressSanitizer: {} on address 0x6 at pc 0x5\n    #0 0x55 in " + OWN +
         "\n\nSUMMARY: AddressSanitizer: {} ../src/a.cpp:7 in own\nShadow bytes around the buggy address:\n  00 00\n")
UNDEFINED = "../src/b.cpp:9:3: runtime error: index 4 out of bounds for type 'int [4]'\n    #0 0x55 in " + OWN + "\n"
BLIND = "==5==LeakSanitizer has encountered a fatal error.\n==5==HINT: LeakSanitizer does not work under ptrace\n"


def leak(*frames, kind="Direct"):
    """Returns the text of a record."""
    lines = [f"    #{at} 0x7f{at:02} in {frame}" for at, frame in enumerate(frames)]
    return f"{kind} leak of 6 byte(s) in 1 object(s) allocated from:\n" + "\n".join(lines) + "\n\n"


def leaking(*records):
    return "=====\n==a==5==ERROR: LeakSanitizer: detected memory leaks\n\n" + "".join(records) + STATS


# (text of a report, [passed, failed], what the failure names)
REPORTS = [
    (STATS, [1, 0], ""),
    (leaking(leak(MALLOC, OWN)), [0, 1], "own() (src/a.cpp:7)"),
    (leaking(leak(MALLOC, OWN, kind="Indirect")), [0, 1], "own() (src/a.cpp:7)"),
    (leaking(leak(MALLOC, STRDUP, OWN, HOST)), [0, 1], "own()"),
    (leaking(leak(MALLOC, INLINED, OWN)), [0, 1], "own() (src/a.cpp:7)"),
    (leaking(leak(MALLOC, HOST, OWN)), [1, 0], ""),
    (leaking(leak(MALLOC, UNLOADED, OWN)), [1, 0], ""),
    (leaking(leak(MALLOC, LLVM, OWN)), [1, 0], ""),
    (leaking(leak(MALLOC, STALE, OWN)), [1, 0], ""),
    (leaking(leak(MALLOC)), [1, 0], ""),
    (leaking(leak(MALLOC, HOST), leak(MALLOC, OWN), leak(MALLOC, INLINED, OWN)), [0, 1], "own()"),
    (ERROR.format("heap-use-after-free", "heap-use-after-free"), [0, 1], "heap-use-after-free src/a.cpp:7 in own"),
    (ERROR.format("SEGV", "SEGV"), [0, 0], ""),
    (ERROR.format("double-free", "double-free").replace(" ../src", f" {ROOT}/build-asan/../src"), [0, 1],
     "double-free src/a.cpp:7 in own"),
    (UNDEFINED, [0, 1], "index 4 out of bounds"),
    ("==a==5==Unable to get registers from thread 7.\n", [0, 0], ""),
    (BLIND, [0, 1], "could not be looked for"),
    (BLIND + STATS, [0, 1], "could not be looked for"),
    ("something else\n", [0, 1], "something else"),
]


def test(name, start, *command, result="OK"):
    """Returns an entry of meson's log."""
    return {"name": f"arbiter:unit / {name}", "starttime": start, "duration": 10.0, "command": list(command),
            "result": result}


def judged(folder, tree=TREE, log=(), table=()):
    """Returns the part, the rows used and what was printed."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        part, used = leaks.judge(folder, tree, list(log), list(table))
    return part, used, said.getvalue()


class Folder(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory(prefix="arbiter-leaks-")
        self.addCleanup(self.place.cleanup)
        self.folder = pathlib.Path(self.place.name) / "reports"
        self.folder.mkdir()

    def report(self, text, name="report.a.5", time=100.0):
        path = self.folder / name
        path.write_text(text)
        os.utime(path, (time, time))


class Texts(Folder):
    def test_each_report_is_judged(self):
        for text, counts, named in REPORTS:
            with self.subTest(text=text):
                self.report(text)
                part, _, said = judged(self.folder)
                self.assertEqual([part["passed"], part["failed"]], counts, said)
                self.assertEqual(bool(part["failures"]), bool(named), part)
                self.assertIn(named, "".join(part["failures"]))

    def test_a_leak_of_many_processes_is_said_once(self):
        for number in range(30):
            self.report(leaking(leak(MALLOC, OWN)), f"report.client.{number}")
        part, _, said = judged(self.folder)
        self.assertEqual((part["passed"], part["failed"], len(part["failures"])), (0, 1, 1))
        self.assertEqual(said.count("own() (src/a.cpp:7)"), 1, said)
        self.report(leaking(leak(MALLOC, OWN, HOST), leak(MALLOC, INLINED, OWN)), "report.client.30")
        self.assertEqual(len(judged(self.folder)[0]["failures"]), 1, "two ways to one place have one name")

    def test_one_of_many_may_not_look(self):
        for number in range(99):
            self.report(STATS, f"report.client.{number}")
        self.report(BLIND, "report.blind.5")
        part, _, said = judged(self.folder)
        self.assertEqual((part["passed"], part["failed"]), (99, 0), said)
        self.report(BLIND, "report.blind.6")
        part, _, said = judged(self.folder)
        self.assertEqual(part["failures"], ["leaks could not be looked for in 2 of 101 processes"], said)

    def test_an_error_counts_where_leaks_could_not_be_looked_for(self):
        for number in range(199):
            self.report(STATS, f"report.client.{number}")
        self.report(UNDEFINED + BLIND, "report.blind.5")
        part, _, said = judged(self.folder)
        self.assertEqual((part["passed"], part["failed"]), (199, 1), said)
        self.assertIn("index 4 out of bounds", part["failures"][0])

    def test_what_failed_while_one_could_not_look_runs_again(self):
        log = [test("early", 80.0, "x", result="FAIL"), test("runs", 96.0, "y", result="FAIL"), test("good", 96.0, "z")]
        self.report(BLIND)
        self.report(leaking(leak(MALLOC, OWN)), "report.b.6")
        self.report(UNDEFINED + BLIND, "report.c.7")
        self.assertEqual(leaks.again(self.folder, TREE, log), ["runs"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["report.b.6", "report.c.7"])
        first, second = self.folder / "first.json", self.folder / "second.json"
        for result, good in (("OK", False), ("FAIL", False)):
            first.write_text("".join(json.dumps(row) + "\n" for row in log))
            second.write_text(json.dumps(test("runs", 200.0, "y", result=result)) + "\n")
            self.assertEqual(leaks.merge(first, second), good)
            self.assertEqual([row["result"] for row in leaks.log_of(second)], ["FAIL", result, "OK"])
        first.write_text(json.dumps(log[1]) + "\n")
        second.write_text(json.dumps(test("runs", 200.0, "y")) + "\n")
        self.assertTrue(leaks.merge(first, second))

    def test_the_test_is_named_that_ran_then(self):
        log = [test("early", 80.0, "/b/a"), test("beside", 95.0, "python3", "run.py"), test("runs", 96.0, "/b/a", "-x")]
        self.report(leaking(leak(MALLOC, OWN)))
        self.assertEqual(judged(self.folder, log=log)[0]["failures"], ["a (in runs): void own() (src/a.cpp:7)"])
        self.assertEqual(judged(self.folder, log=log[:2])[0]["failures"], ["a (in beside): void own() (src/a.cpp:7)"])

    def test_a_row_keeps_its_leak_alone(self):
        for row, kept in (({"source": "src/a.cpp"}, True), ({"source": "src/**/a.cpp"}, False),
                          ({"function": "void own()"}, True), ({"function": "own"}, False),
                          ({"function": "void own()", "program": "b"}, False)):
            self.report(leaking(leak(MALLOC, INLINED, OWN)))
            part, used, said = judged(self.folder, table=[row])
            self.assertEqual((part["passed"] == 1, used), (kept, {0} if kept else set()), (row, said))

    def test_a_table_has_reasons_and_is_not_for_everything(self):
        for text in ('[[leak]]\nsource = "a"\n', '[[leak]]\nreason = "b"\n', '[[leak]]\nprogram = "a"\nreason = "b"\n',
                     '[[leak]]\nsource = "a"\nreason = "b"\nfile = "c"\n'):
            (self.folder / "table.toml").write_text(text)
            with self.assertRaises(leaks.BadTable, msg=text):
                leaks.rows(self.folder / "table.toml")
        self.assertIsInstance(leaks.rows(leaks.TABLE), list)

    def run_main(self, *more):
        target = self.folder.parent / "leaks.json"
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = leaks.main(["judge", str(self.folder), str(self.folder.parent), str(target), *more])
        return status, json.loads(target.read_text()), said.getvalue()

    def test_a_run_of_all_tests_has_processes_and_needs_its_rows(self):
        table, leaks.TABLE = leaks.TABLE, self.folder.parent / "table.toml"
        self.addCleanup(setattr, leaks, "TABLE", table)
        leaks.TABLE.write_text('[[leak]]\nsource = "src/nosuch.cpp"\nreason = "planted"\n')
        self.assertEqual(self.run_main()[0], 0)
        status, part, said = self.run_main("whole")
        self.assertEqual((status, part["failures"]), (1, ["no process has looked for leaks"]))
        self.assertIn("nosuch.cpp", said)
        self.report(STATS)
        self.assertEqual(self.run_main("whole")[0], 0)


class Programs(Folder):
    planted = host = tree = None

    def run_planted(self, what, host):
        options = leaks.OPTIONS.format(self.folder)
        return subprocess.run([self.planted, what, host], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "ASAN_OPTIONS": options}).returncode

    def test_each_way(self):
        if not self.planted:
            self.skipTest("no AddressSanitizer in this tree")
        host = shutil.copy(self.host, self.folder.parent / "libhost.so")
        table = [{"function": "*keepsOnPurpose*", "reason": "planted"}]
        # (what the program does, its status, [passed, failed], what the failure names, rows used)
        for what, status, counts, named, used in (
                ("nothing", 0, [1, 0], "", set()),
                ("leak", 0, [0, 2], "leaks (tests/leaks/planted.cpp", set()),
                ("keep", 0, [1, 0], "", {0}),
                ("host", 0, [1, 0], "", set()),
                ("unloaded", 0, [1, 0], "", set()),
                ("misuse", -6, [0, 1], "heap-use-after-free tests/leaks/planted.cpp", set()),
                ("signal", -6, [0, 0], "", set())):
            with self.subTest(what=what):
                for old in self.folder.iterdir():
                    old.unlink()
                self.assertEqual(self.run_planted(what, host), status)
                texts = "".join(path.read_text() for path in self.folder.iterdir())
                part, rows, said = judged(self.folder, pathlib.Path(self.tree), table=table)
                self.assertEqual(([part["passed"], part["failed"]], rows), (counts, used), said + texts)
                self.assertIn(named, "".join(part["failures"]), said)
                self.assertEqual("leak of " in texts, what in ("leak", "keep", "host", "unloaded"), texts)


def main():
    parser = argparse.ArgumentParser()
    for name in ("tree", "planted", "host"):
        parser.add_argument(f"--{name}")
    options, rest = parser.parse_known_args()
    Programs.planted, Programs.host, Programs.tree = options.planted, options.host, options.tree
    unittest.main(argv=[sys.argv[0], "-v", *rest])


if __name__ == "__main__":
    main()
