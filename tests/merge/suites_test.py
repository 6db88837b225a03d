#!/usr/bin/env python3
"""Runs a few tests of each suite in one process and in shards: the merged report must be the same.

usage: suites_test.py BUILD_TREE"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import merge
import sharding

BUILD = None
SUITES = {
    # A way's block is smaller than the count of shards; edges are one test.
    "differential": (["scripts/run_differential.py", "--count", "8", "--vertex-count", "2", "--mode-count", "5",
                      "--ways", "glsl,layer,vertex-glsl,swrast-edges,swrast-vertex"], "--out"),
    "piglit": (["tests/piglit/compare.py", "--platform", "surfaceless_egl", "--jobs", "2",
                "--profiles", "r300", "fp-abs", "fp-kil", "fp-indirections"], "--results"),
}


def run(*words):
    """Returns (exit status, output)."""
    done = subprocess.run([sys.executable, *map(str, words)], stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


class Suites(unittest.TestCase):
    def spread(self, suite, shards):
        words, folder_option = SUITES[suite]
        words = [sharding.ROOT / words[0], "--build", BUILD, *words[1:]]
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            status, alone = run(*words, folder_option, folder / "alone")
            self.assertEqual(status, 0, alone)
            # The order differs from the joining order, as machines end in any order.
            files = []
            for index in range(shards, 0, -1):
                part, said = run(*words, folder_option, folder / "spread", "--shard", "%d/%d" % (index, shards))
                self.assertEqual(part, 0, said)
                files.append(folder / "spread/shards" / ("shard-%d-of-%d.json" % (index, shards)))
            against = folder / "alone/report.json"
            merged, together = run(merge.__file__, "--against", against, *files)
            self.assertEqual(merged, 0, together)
            self.assertIn(alone.splitlines()[-1], together.splitlines())
            return json.loads(against.read_text())

    def test_differential(self):
        report = self.spread("differential", 3)
        self.assertEqual({row["name"]: row["programs"] for row in report["rows"] if row["name"] != "swrast-edges"},
                         {"glsl": 8, "layer": 8, "vertex-glsl": 2, "swrast-vertex": 5})

    def test_piglit(self):
        r300, = self.spread("piglit", 2)["reports"]
        self.assertGreater(sum(r300["layer"].values()), 2)
        self.assertEqual(list(r300["explained"]), ["spec@arb_fragment_program@fp-indirections"])


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
