#!/usr/bin/env python3
"""Tests of the comparison itself: a worse result fails, and expectations must be true."""

import json
import pathlib
import tempfile
import unittest

import compare
import expectations
import run as piglit
import table


class Lacking(unittest.TestCase):
    HERE, NONE = pathlib.Path(__file__), pathlib.Path("/none/libGLX_arbiter.so.0")

    def test_a_build_that_is_not_there_is_named(self):
        said = compare.lacking("glx", self.NONE, {"DISPLAY": ":1"})
        self.assertIn("/none/libGLX_arbiter.so.0 is not there: ./dev build", said)

    def test_a_display_is_asked_for_where_one_is_needed(self):
        for platform in compare.NEED_DISPLAY:
            self.assertIn("DISPLAY is not set", compare.lacking(platform, None, {}))
            self.assertIsNone(compare.lacking(platform, self.HERE, {"DISPLAY": ":1"}))
        self.assertIsNone(compare.lacking("surfaceless_egl", self.HERE, {}))


class Expectations(unittest.TestCase):
    ROW = "spec@x@a* | skip | pass | the layer has it\n"

    def test_a_difference_without_a_row_is_unexpected(self):
        changes = expectations.differences({"t": "pass", "u": "pass"}, {"t": "fail", "u": "pass"})
        explained, unexpected = expectations.judge(changes, expectations.parse(self.ROW, "f"))
        self.assertEqual(unexpected, {"t": ("pass", "fail")})
        self.assertFalse(explained)

    def test_a_row_explains_its_own_difference_only(self):
        rows = expectations.parse(self.ROW, "f")
        explained, unexpected = expectations.judge(
            {"spec@x@a1": ("skip", "pass"), "spec@x@a2": ("skip", "fail")}, rows)
        self.assertEqual(list(explained), ["spec@x@a1"])
        self.assertEqual(list(unexpected), ["spec@x@a2"])

    def test_a_test_that_vanished_is_a_difference(self):
        self.assertEqual(expectations.differences({"t": "pass"}, {}), {"t": ("pass", "missing")})

    def test_brackets_are_characters(self):
        row = expectations.parse("t[1] | pass | fail | why\n", "f")[0]
        self.assertTrue(row.matches("t[1]"))
        self.assertFalse(row.matches("t1"))

    def test_a_row_needs_a_reason_and_two_results(self):
        for text in ("t | pass | fail\n", "t | pass | fail | \n", "t | pass | pass | why\n",
                     "t | good | bad | why\n"):
            with self.assertRaises(ValueError, msg=text):
                expectations.parse(text, "f")

    def test_a_row_that_nothing_used_is_stale_if_its_test_ran(self):
        rows = expectations.parse(self.ROW, "f")
        self.assertEqual(expectations.unused_rows(rows, {"other"}), [])
        self.assertEqual(expectations.unused_rows(rows, {"spec@x@a1"}), rows)

    def test_every_stored_file_parses(self):
        for profile in ("host", "r300", "r300:report"):
            expectations.load(profile)


class RunAgain(unittest.TestCase):
    def test_what_stays_is_no_flake(self):
        tests = {"a": "quick_gl", "b": "quick_gl"}
        sides = (lambda some: dict.fromkeys(some, "pass"),
                 lambda some: {name: "fail" if name == "a" else "pass" for name in some})
        steady, flakes = compare.run_again(
            {"a": ("pass", "fail"), "b": ("pass", "fail")}, tests, sides, 2)
        self.assertEqual((list(steady), list(flakes)), (["a"], ["b"]))


class Table(unittest.TestCase):
    REPORT = {"profile": "r300", "bare": {"pass": 2}, "layer": {"pass": 1, "fail": 1},
              "unexpected": {"u": {"bare": "pass", "layer": "fail"}},
              "explained": {"e|x": {"bare": "skip", "layer": "pass", "reason": "the layer has it"}},
              "flakes": {"f": {"bare": "pass", "layer": "crash"}}, "stale": {"r300.txt:3": "s*"}}

    def test_every_difference_has_its_row(self):
        kinds = [row[0] for row in table.rows(self.REPORT)]
        self.assertEqual(kinds, ["unexpected", "explained", "flake", "stale"])

    def test_the_page_holds_counts_and_reasons(self):
        page = table.markdown({"set": "full", "reports": [self.REPORT]})
        self.assertIn("| layer | 1 | 1 |", page)
        self.assertIn("| explained | e\\|x | skip | pass | the layer has it |", page)


class Environment(unittest.TestCase):
    def test_a_profile_may_say_how_limits_are_held(self):
        plain = piglit.environment("layer.so", "r300")
        self.assertEqual(plain["ARBITER_PROFILE"], "r300")
        self.assertNotIn("ARBITER_LIMITS", plain)
        report = piglit.environment("layer.so", "r300:report")
        self.assertEqual((report["ARBITER_PROFILE"], report["ARBITER_LIMITS"]), ("r300", "report"))

    def test_the_bare_host_has_no_layer(self):
        self.assertNotIn("LD_PRELOAD", piglit.environment())


class Reasons(unittest.TestCase):
    def test_the_last_words_of_a_test_say_why_it_skips(self):
        for words, reason in (("a.txt:\nTest requires GL_NV_x\n", "piglit's test requires GL_NV_x"),
                              ("Test requires extension GL_NV_x.\n", "piglit's test requires GL_NV_x"),
                              ("limits: 4\nSkipping: no limits.\n\n", "piglit's test says, Skipping, no limits"),
                              ("Sample count of 6 not supported, got 4 samples\n",
                               "piglit's test says, Sample count of N not supported, got N samples"),
                              ("", "piglit's test of x does not say")):
            self.assertEqual(piglit.reason_of("spec@x@y", words), reason)

    def test_of_a_run(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "quick_gl/results.json"
            path.parent.mkdir()
            path.write_text(json.dumps({"tests": {
                "a": {"result": "skip", "out": "Test requires GL_x"}, "b": {"result": "pass", "out": "of b"},
                "c": {"result": "pass", "out": "of c", "subtests": {"x": "skip", "y": "pass"}}}}))
            self.assertEqual(piglit.reasons(folder), {"a": "piglit's test requires GL_x",
                                                      "c/x": "piglit's test leaves out a part"})


class Flatten(unittest.TestCase):
    def test_subtests_are_rows(self):
        table = piglit.flatten({"tests": {"t": {"result": "fail", "subtests": {
            "__type__": "Subtests", "x": "pass", "y": "fail"}}}})
        self.assertEqual(table, {"t": "fail", "t/x": "pass", "t/y": "fail"})
        self.assertEqual(piglit.test_of("t/x", {"t"}), "t")
        self.assertEqual(piglit.test_of("t", {"t"}), "t")


if __name__ == "__main__":
    unittest.main()
