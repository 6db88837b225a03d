#!/usr/bin/env python3
"""Tests how results over another host are judged, with planted failures, and how a host is chosen."""

import contextlib
import fnmatch
import io
import os
import pathlib
import re
import sys
import tempfile
import unittest
from unittest import mock

import judge
import suites
from suites import BARE, Outcome

import hosts

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/piglit")]

# A test program of three cases, whose second ends it: what it prints is what GoogleTest would.
DIES = """#!/bin/sh
case "$1" in --gtest_filter=*-*A.two*) later=yes ;; esac
if [ "$1" = "--gtest_filter=*" ]; then
  printf '[ RUN      ] A.one\\n[       OK ] A.one (0 ms)\\n[ RUN      ] A.two\\n'
  kill -SEGV $$
fi
[ -n "$later" ] || exit 3
printf '[ RUN      ] A.three\\nx.cpp:1: Skipped\\nGL_x is not offered here\\n\\n[  SKIPPED ] A.three (0 ms)\\n'
printf '[  PASSED  ] 0 tests.\\n[  SKIPPED ] 1 test, listed below:\\n'
"""


def judged(bare, layer, known=(), alike=()):
    """Returns (passed, failed, skipped, failures) of one case "a" on both sides, and "b" that the bare host passes."""
    results = {BARE: {"a": Outcome(bare, "w"), "b": Outcome("passed")}, "auto": {"a": Outcome(layer, "w", alike)}}
    counts = judge.judged(results, dict.fromkeys(known, "why"))
    assert sum(counts["skips"].values()) == counts["skipped"]
    return counts["passed"], counts["failed"], counts["skipped"], counts["failures"]


class Judged(unittest.TestCase):
    def test_what_the_bare_host_passes_has_to_pass(self):
        self.assertEqual(judged("passed", "passed"), (3, 0, 0, []))
        self.assertEqual(judged("passed", "failed"), (2, 1, 0, ["auto: a: w"]))

    def test_what_the_bare_host_fails_is_its_own(self):
        self.assertEqual(judged("failed", "failed"), (1, 0, 2, []))
        self.assertEqual(judged("failed", "passed"), (2, 0, 1, []))

    def test_what_the_bare_host_cannot_run_has_to_pass(self):
        self.assertEqual(judged("skipped", "failed"), (1, 1, 1, ["auto: a: w"]))

    def test_the_bare_hosts_case_may_have_another_name(self):
        self.assertEqual(judged("failed", "failed", alike=("b",))[3], ["auto: a: w"])
        self.assertEqual(judged("failed", "failed", alike=("b", "a"))[3], [])

    def test_a_known_defect_is_of_what_the_bare_host_cannot_run(self):
        self.assertEqual(judged("skipped", "failed", known=["a*"]), (1, 0, 2, []))
        self.assertEqual(judged("passed", "failed", known=["a*"])[1], 2)

    def test_a_known_defect_that_is_no_more_fails(self):
        self.assertEqual(judged("skipped", "passed", known=["a"])[3], ["known.toml: a: no such defect any more"])

    def test_a_host_that_passes_nothing_judges_nothing(self):
        counts = judge.judged({BARE: {"a": Outcome("failed")}, "auto": {"a": Outcome("failed")}}, {})
        self.assertEqual(counts["failures"], ["bare: no case passes"])
        self.assertEqual(counts["failed"], 1)

    def test_what_is_printed_ends_with_the_counts(self):
        results = {BARE: {"a": Outcome("passed"), "b": Outcome("failed", "w")}, "auto": {"a": Outcome("failed", "v")}}
        with contextlib.redirect_stdout(io.StringIO()) as said:
            judge.show(results, judge.judged(results, {}))
        self.assertIn("the bare host fails b: w\nFAIL auto: a: v\n1 passed, 1 failed, 1 skipped\n", said.getvalue())


class Programs(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.program = pathlib.Path(holder.name) / "api_test"

    def written(self, text):
        self.program.write_text(text)
        self.program.chmod(0o755)
        self.log = self.program.with_name("bare.log")
        return suites.gtest(self.program, "*", {}, self.log)

    def test_the_cases_after_one_that_dies_run(self):
        self.assertEqual(self.written(DIES), {"A.one": Outcome("passed"), "A.two": Outcome("failed", "signal 11"),
                                              "A.three": Outcome("skipped", "GL_x is not offered here")})
        for name in ("A.two", "A.three"):
            self.assertIn(name, self.log.read_text())

    def test_a_program_without_cases_has_failed(self):
        found = self.written("#!/bin/sh\necho no display >&2; exit 77\n")
        self.assertEqual(found, {"api_test": Outcome("failed", "status 77: no display")})

    def test_one_that_hangs_has_failed(self):
        with mock.patch.object(suites, "TIMEOUT", 0.2):
            status, output = suites.output_of(["sh", "-c", "echo begun; exec sleep 60"], {})
        self.assertEqual((status, output.split()), (-9, ["begun"]))


class Hosts(unittest.TestCase):
    SAYS = {"llvmpipe": ["llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 Mesa 22.3.6"], "softpipe": ["softpipe", "3.3 Mesa"],
            "zink": ["zink (llvmpipe (LLVM 15.0.6, 256 bits))", "4.6 Mesa"],
            "nvidia": ["NVIDIA H200/PCIe/SSE2", "4.6.0 NVIDIA 580.159.04"]}

    def test_each_is_known_by_its_renderer_alone(self):
        self.assertEqual(set(self.SAYS), set(hosts.HOSTS))
        for name in hosts.HOSTS:
            for other, said in self.SAYS.items():
                status, line = hosts.check(name, said)
                self.assertEqual(status, 0 if name == other else 77 if name == "nvidia" else 1, (name, line))

    def test_one_that_cannot_be_here_is_skipped_with_its_reason(self):
        self.assertEqual(hosts.check("nvidia", ["", ""]), (77, "skipped: no driver of NVIDIA's here"))
        self.assertEqual(hosts.check("zink", ["", ""]), (1, "zink was asked for, and no GL draws"))

    def test_the_environment_is_that_of_the_named_host(self):
        with mock.patch.dict(os.environ, {"TEST_HOST": "softpipe"}):
            self.assertEqual(hosts.environment()["GALLIUM_DRIVER"], "softpipe")
            self.assertIn("VK_ICD_FILENAMES", hosts.environment("zink"))
            self.assertNotIn("GALLIUM_DRIVER", hosts.environment("llvmpipe"))

    def test_the_command_refuses_what_it_does_not_know(self):
        for words in ([], ["check"], ["check", "nosuch"], ["known"], ["known", "zink", ""], ["environment"],
                      ["list", "zink"]):
            with contextlib.redirect_stderr(io.StringIO()):
                self.assertEqual(hosts.main(words), 2, words)

    def test_piglit_runs_over_the_host_and_expects_what_it_does(self):
        import expectations
        import run as piglit
        with mock.patch.dict(os.environ, {"TEST_HOST": "zink", "GALLIUM_DRIVER": "foreign", "VK_FOREIGN": "1"}):
            made, rows = piglit.environment(), expectations.load("auto")
        self.assertEqual((made["GALLIUM_DRIVER"], made["TEST_HOST"], "VK_FOREIGN" in made), ("zink", "zink", False))
        self.assertTrue(any(row.where.startswith("auto-on-zink.txt") for row in rows))
        with mock.patch.dict(os.environ, {"GALLIUM_DRIVER": "foreign"}):
            os.environ.pop("TEST_HOST", None)
            made, rows = piglit.environment(), expectations.load("auto")
        self.assertFalse("GALLIUM_DRIVER" in made or any("-on-" in row.where for row in rows))


class Known(unittest.TestCase):
    def test_rows_are_of_hosts_suites_and_cases_that_are_there(self):
        text = "".join(file.read_text() for file in (ROOT / "tests/layer_vs_specification").rglob("*.cpp"))
        cases = [".".join(case) for case in re.findall(r"\bTEST_F\((\w+), (\w+)\)", text)]
        for row in judge.tomllib.loads(judge.KNOWN.read_text())["defect"]:
            self.assertIn(row["host"], hosts.HOSTS)
            self.assertIn(row["suite"], suites.SUITES)
            self.assertTrue(row["why"])
            for pattern in row["cases"]:
                self.assertTrue(row["suite"] != "api" or fnmatch.filter(cases, pattern), pattern)

    def test_rows_are_of_one_host_and_suite(self):
        self.assertIn("EraPointSprites.*", judge.known_defects("zink", "api"))
        self.assertEqual(judge.known_defects("softpipe", "api"), {})
        self.assertEqual(judge.known_defects("zink", "differential"), {})

    def test_the_ways_are_those_of_the_differential(self):
        settings = suites.argparse.Namespace(build=ROOT, count=3, vertex_count=3, mode_count=3, ways=None)
        names = {way[0] for way in suites.run_differential.all_ways(settings, ROOT)}
        self.assertLessEqual(set(suites.DIFFERENTIAL), names)
        self.assertLessEqual({way for ways in suites.DIFFERENTIAL.values() for way in ways}, names)


if __name__ == "__main__":
    unittest.main()
