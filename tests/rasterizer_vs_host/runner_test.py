#!/usr/bin/env python3
"""Tests that the runner fails a row with a planted fault. No client runs: the records are made here."""

import argparse
import contextlib
import io
import sys
import unittest

import sides
from checks import all_ours, alike, counted
from runner import Case, Row, Runner, Way

PICTURE = [("seed 1", bytes(16)), ("errors", b"")]
OTHER = [("seed 1", bytes(12) + b"\xff" * 4), ("errors", b"")]
DRAWN = {"drawn": 3, "downloads": 2}


class Planted(Case):
    """A case whose client answers with what is planted: records or a death, and statistics."""
    bare, layer, part = PICTURE, PICTURE, DRAWN

    def process(self, way, of):
        found = self.bare if way.backend is None else self.layer
        if isinstance(found, str):
            raise sides.Died(found)
        return found, self.part if way.backend != "auto" else {}


class Unsteady(Planted):
    """A case whose bare host answers with one after another of its records."""
    answers = ()

    def process(self, way, of):
        if way.backend is None:
            self.bare, *rest = self.answers
            type(self).answers = rest or self.answers
        return super().process(way, of)


class Rows(unittest.TestCase):
    def run_row(self, names=("",), checks=(alike, all_ours), planted=None, kind=Planted, **options):
        """Returns (the exit status, the last line)."""
        runner = Runner.__new__(Runner)
        runner.row = Row("client", checks, names=names, **options)
        runner.args = argparse.Namespace(names=[], jobs=1, backend="swrast", first=1, count=1, row="row")
        runner.numbers = iter(range(100))
        case = type("One", (kind,), planted or {})
        runner.cases = lambda: [case(runner, name, "", "") for name in names]
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            status = runner.run()
        return status, text.getvalue().splitlines()[-1]

    def test_equal_records_pass(self):
        self.assertEqual(self.run_row(("a", "b")), (0, "2 passed, 0 failed, 0 skipped"))

    def test_faults_fail(self):
        for planted in ({"layer": OTHER}, {"layer": PICTURE[:1]}, {"layer": "status -11"}, {"bare": "status -11"},
                        {"part": {}}, {"part": {**DRAWN, "given_to_host": {"state": 1}}}):
            self.assertEqual(self.run_row(planted=planted), (1, "0 passed, 1 failed, 0 skipped"), planted)

    def test_a_counter_out_of_bounds_fails(self):
        for most, failed in ((2, 0), (1, 1)):
            checks = (counted("downloads", lambda run, most=most: (0, most)),)
            self.assertEqual(self.run_row(checks=checks)[0], failed)

    def test_each_way_is_judged(self):
        ways = (Way("swrast", "swrast"), Way("auto", "auto", checks=(alike,)), Way("drawn", "auto"))
        self.assertEqual(self.run_row(ways=ways), (0, "3 passed, 0 failed, 0 skipped"))
        self.assertEqual(self.run_row(ways=ways, planted={"layer": OTHER}), (1, "0 passed, 3 failed, 0 skipped"))

    def test_a_death_of_the_hosts_own_is_skipped(self):
        both, other = {"bare": "status -11", "layer": "status -11"}, {"bare": "status -6", "layer": "status -11"}
        for backend, planted, counts in (("host", both, (0, 0, 1)), ("swrast", both, (0, 1, 0)),
                                         ("host", other, (0, 1, 0)), ("host", {"layer": "status -11"}, (0, 1, 0))):
            ways = (Way("way", backend, is_alone=True),)
            self.assertEqual(self.run_row(planted=planted, ways=ways)[1], "%d passed, %d failed, %d skipped" % counts)

    def test_a_bare_host_that_is_not_steady_is_asked_again(self):
        for answers, failed in (([OTHER, PICTURE], 0), ([PICTURE, OTHER], 0), ([OTHER, OTHER], 1),
                                ([OTHER, PICTURE[:1]], 1)):
            self.assertEqual(self.run_row(planted={"answers": answers}, kind=Unsteady)[0], failed, answers)
        ways = (Way("swrast", "swrast"), Way("again", "swrast"))
        self.assertEqual(self.run_row(planted={"answers": [OTHER, PICTURE]}, kind=Unsteady, ways=ways)[0], 0)

    def test_what_the_host_lacks_is_skipped(self):
        self.assertEqual(self.run_row(planted={"bare": "status 77: "}), (0, "0 passed, 0 failed, 1 skipped"))

    def test_the_bare_host_may_die(self):
        self.assertEqual(self.run_row(planted={"bare": "status -11"}, bare_may_die=True)[0], 0)
        self.assertEqual(self.run_row(planted={"layer": "status -11"}, bare_may_die=True)[0], 1)

    def test_too_few_draws_fail(self):
        self.assertEqual(self.run_row(least_drawn=0.8)[0], 0)
        self.assertEqual(self.run_row(checks=(alike,), planted={"part": {}}, least_drawn=0)[0], 1)

    def test_no_scenes_fail(self):
        self.assertEqual(self.run_row(())[0], 1)


if __name__ == "__main__":
    sys.exit(unittest.main())
