#!/usr/bin/env python3
"""Tests shards and their merging: every test is in one shard, and incomplete files are rejected."""

import contextlib
import io
import json
import pathlib
import tempfile
import unittest

import merge
import results
from shards import Shard

PIGLIT = {"kind": "piglit", "set": "named", "filter": ["t"], "profiles": ["host", "r300"],
          "platform": "glx", "tests": "d1", "sources": "d2"}
DIFFERENTIAL = {"kind": "differential", "count": 20, "ways": ["glsl", "edges"], "sources": "d2"}
NAMES = ["spec@%d@t%d" % (i % 7, i) for i in range(60)]
WORSE = NAMES[17]  # pass on the bare host, fail under r300
FLAKY = NAMES[23]


def piglit_content(names):
    bare = {name: "skip" if i % 5 == 0 else "pass" for i, name in enumerate(NAMES) if name in names}
    under = {**bare, **{name: "fail" for name in (WORSE, FLAKY) if name in names}}
    flakes = {FLAKY: ["pass", "fail"]} if FLAKY in names else {}
    reasons = {name: "no such extension" for name, status in bare.items() if status == "skip"}
    return {"bare": bare, "profiles": {"host": {"layer": dict(bare), "flakes": {}, "skips": reasons},
                                       "r300": {"layer": under, "flakes": flakes}}}


def piglit_result(shard):
    content = piglit_content([name for name in NAMES if shard.has(name)])
    return results.Result(PIGLIT, shard, content, {"bare": 1.0, "host": 2.0, "r300": 2.5})


def differential_result(shard, failing=(), fault=""):
    first, count = shard.block(20)
    rows = {"glsl": {"name": "glsl", "renderers": ["R"], "programs": count, "values": 9 * count,
                     "ill_conditioned": count, "worst_error": 0.1 * shard.index, "faults": [],
                     "failures": [{"seed": s, "reason": "x"} for s in range(1 + first, 1 + first + count)
                                  if s in failing]}}
    if shard.has("edges"):
        rows["edges"] = {**rows["glsl"], "name": "edges", "programs": 5, "values": 50,
                         "ill_conditioned": 6, "failures": [], "faults": [fault] if fault else []}
    return results.Result(DIFFERENTIAL, shard, {"ways": rows}, {"all": 1.0})


class Case(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._folder.name)
        self.addCleanup(self._folder.cleanup)

    def write(self, made, of, **options):
        paths = []
        for index in range(1, of + 1):
            paths.append(self.folder / ("%d-of-%d.json" % (index, of)))
            results.write(paths[-1], made(Shard(index, of), **options))
        return paths

    def merged(self, paths, **options):
        """Returns (exit status, report, all output)."""
        text = io.StringIO()
        report = self.folder / "report"
        with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
            status = merge.merge(paths, report, **options)
        path = report / "report.json"
        return status, json.loads(path.read_text()) if path.exists() else None, text.getvalue()


class Shards(unittest.TestCase):
    def test_every_name_is_in_one(self):
        for of in (1, 2, 8, 13, 100):
            for name in NAMES:
                self.assertEqual(sum(Shard(i, of).has(name) for i in range(1, of + 1)), 1)

    def test_every_number_is_in_one(self):
        for of in (1, 2, 8, 13, 100):
            for count in (0, 1, 7, 20, 500):
                blocks = [Shard(i, of).block(count) for i in range(1, of + 1)]
                numbers = [n for first, many in blocks for n in range(first, first + many)]
                self.assertEqual(numbers, list(range(count)))
                self.assertLessEqual(max(b[1] for b in blocks) - min(b[1] for b in blocks), 1)

    def test_the_rule_stays(self):
        # Another rule would mix shards of machines with the old one and the new.
        self.assertEqual([Shard(i, 8).has("spec@arb_fragment_program@fp-kil") for i in range(1, 9)].index(True),
                         5)

    def test_what_is_no_shard_is_refused(self):
        for text in ("", "3", "0/8", "9/8", "1/0", "-1/8", "a/b", "1/8/2", " 1/8"):
            with self.assertRaises(ValueError, msg=text):
                Shard.parse(text)
        self.assertEqual(str(Shard.parse("3/8")), "3/8")


class Merging(Case):
    def test_as_one_machine_has_it(self):
        for made in (piglit_result, differential_result):
            for failing in ((), (7, 19)):
                options = {"failing": failing} if made is differential_result else {}
                alone = self.merged(self.write(made, 1, **options))
                for of in (2, 5, 40):  # most shards of the last have nothing of a way
                    together = self.merged(self.write(made, of, **options))
                    self.assertEqual(alone[0], together[0])
                    kind = merge.KINDS[made(Shard(1, 1)).run["kind"]]
                    self.assertEqual(merge.results_of(alone[1], kind.MEASURED),
                                     merge.results_of(together[1], kind.MEASURED))
                    self.assertEqual(alone[2].splitlines()[-1], together[2].splitlines()[-1])

    def test_a_worse_test_of_one_shard_fails_the_run_and_a_flake_does_not(self):
        status, report, text = self.merged(self.write(piglit_result, 5))
        self.assertEqual(status, 1)
        r300 = report["reports"][1]
        self.assertEqual((list(r300["unexpected"]), list(r300["flakes"])), ([WORSE], [FLAKY]))
        self.assertIn("95 passed, 1 failed, 24 skipped", text)

    def test_the_counts_name_failures_and_reasons(self):
        path = self.folder / "counts.json"
        self.merged(self.write(piglit_result, 5), counts=path)
        part = json.loads(path.read_text())
        self.assertEqual(part["failures"], [f"r300: {WORSE}: pass on the bare host, fail under the layer"])
        self.assertEqual(part["skips"], {"no such extension": 12, "no reason is given": 12})
        self.merged(self.write(differential_result, 4, failing=(11,), fault="drew half"), counts=path)
        self.assertEqual(json.loads(path.read_text())["failures"], ["glsl: seed 11: x", "edges: drew half"])

    def test_a_failure_and_a_fault_of_one_shard_fail_the_run(self):
        self.assertEqual(self.merged(self.write(differential_result, 4))[0], 0)
        self.assertEqual(self.merged(self.write(differential_result, 4, failing=(11,)))[0], 1)
        status, report, _ = self.merged(self.write(differential_result, 4, fault="drew half"))
        self.assertEqual((status, report["failed"]), (1, 1))

    def test_a_row_of_expectations_that_no_shard_needed_is_stale(self):
        whole = {**PIGLIT, "filter": [], "profiles": ["r300"]}
        name = "spec@arb_vertex_program@big-param"  # expected to fail under r300
        for status, stale in (("fail", 0), ("pass", 1)):
            paths = []
            for index in (1, 2):
                shard = Shard(index, 2)
                bare = {name: "pass"} if shard.has(name) else {"other": "pass"}
                content = {"bare": bare, "profiles": {"r300": {
                    "layer": {name: status} if shard.has(name) else bare, "flakes": {}}}}
                paths.append(self.folder / ("stale-%d.json" % index))
                results.write(paths[-1], results.Result(whole, shard, content, {"r300": 1}))
            self.assertEqual(len(self.merged(paths)[1]["reports"][0]["stale"]), stale)

    def test_a_report_made_otherwise_is_compared(self):
        paths = self.write(differential_result, 3, failing=(4,))
        self.merged(paths)
        other = self.folder / "other.json"
        other.write_text((self.folder / "report/report.json").read_text())
        self.assertEqual(self.merged(self.write(differential_result, 1, failing=(4,)), other=other)[0], 1)
        status, _, text = self.merged(self.write(differential_result, 1, failing=(5,)), other=other)
        self.assertEqual(status, merge.PIECES)
        self.assertIn("/rows/0/failures/0/seed: 4 and 5", text)
        self.assertEqual(self.merged(paths, other=self.folder / "none.json")[0], merge.PIECES)


class Pieces(Case):
    def refused(self, paths, *words):
        status, report, text = self.merged(paths)
        self.assertEqual((status, report), (merge.PIECES, None), text)
        for word in words:
            self.assertIn(word, text)

    def test_a_missing_shard_is_named(self):
        paths = self.write(piglit_result, 8)
        self.refused(paths[:2] + paths[3:6] + paths[7:], "of 8 shards these are missing: 3, 7")
        self.refused([], "there is no whole result file")
        self.refused(paths[:7] + [self.folder / "gone.json"], "gone.json does not count", "missing: 8")

    def test_a_file_that_is_cut_short_anywhere_is_no_result(self):
        paths = self.write(differential_result, 2)
        data = paths[1].read_bytes()
        for at in [0, 1, *range(2, len(data) - 2, 13), len(data) - 2]:
            paths[1].write_bytes(data[:at])
            self.refused(paths, "2-of-2.json does not count", "missing: 2")
        paths[1].write_bytes(data)
        self.assertEqual(self.merged(paths)[0], 0)

    def test_a_changed_file_is_no_result(self):
        paths = self.write(differential_result, 2)
        text = paths[1].read_text()
        paths[1].write_text(text.replace('"failures": []', '"failures": [{"seed": 1, "reason": ""}]', 1))
        self.assertNotEqual(paths[1].read_text(), text)
        self.refused(paths, "its digest is not that of what it holds")
        for other in ("[]", "{}", "null", "7"):
            paths[1].write_text(other)
            self.refused(paths, "does not count")
        paths[1].write_bytes(b"\xff\x00")
        self.refused(paths, "does not count")

    def test_another_schema_is_no_result(self):
        paths = self.write(differential_result, 2)
        document = json.loads(paths[1].read_text())
        del document["digest"]
        for change, said in (({"schema": 2}, "of schema 2"), ({"shard": "9/2"}, "it lacks"),
                             ({"shard": None}, "it lacks")):
            changed = {**document, **change}
            changed["digest"] = results.digest(changed)
            paths[1].write_text(json.dumps(changed))
            self.refused(paths, said)

    def test_a_doubled_shard_counts_once(self):
        paths = self.write(differential_result, 3)
        copy = self.folder / "copy.json"
        copy.write_bytes(paths[1].read_bytes())
        status, report, text = self.merged(paths + [copy])
        self.assertEqual((status, report["rows"][0]["programs"]), (0, 20))
        self.assertIn("counted once", text)

    def test_a_doubled_shard_that_says_otherwise_contradicts(self):
        paths = self.write(differential_result, 3)
        other = self.folder / "other.json"
        results.write(other, differential_result(Shard(2, 3), failing=(8,)))
        self.refused(paths + [other], "are both shard 2/3, and do not say the same")

    def test_other_counts_of_shards_contradict(self):
        self.refused(self.write(piglit_result, 3) + self.write(piglit_result, 4),
                     "is one of 3 shards", "one of 4")

    def test_other_runs_contradict(self):
        paths = self.write(piglit_result, 3)
        for field, value in (("set", "quick"), ("profiles", ["host"]), ("sources", "d3"),
                             ("tests", "d4"), ("filter", [])):
            result = piglit_result(Shard(2, 3))
            result.run = {**PIGLIT, field: value}
            results.write(paths[1], result)
            self.refused(paths, "are of different runs (%s:" % field)
        results.write(paths[1], differential_result(Shard(2, 3)))
        self.refused(paths, "are of different runs")

    def test_an_unknown_kind_is_refused(self):
        path = self.folder / "kind.json"
        results.write(path, results.Result({"kind": "other"}, Shard(1, 1), {}, {}))
        self.refused([path], "no kind of run")


class Files(Case):
    def test_what_is_written_is_read(self):
        path = self.folder / "deep/er/1.json"
        results.write(path, piglit_result(Shard(1, 3)))
        read = results.read(path)
        self.assertEqual((read.run, str(read.shard), read.content),
                         (PIGLIT, "1/3", piglit_result(Shard(1, 3)).content))

    def test_a_write_that_fails_leaves_what_was_there(self):
        path = self.folder / "1.json"
        results.write(path, piglit_result(Shard(1, 3)))
        before = path.read_bytes()
        bad = piglit_result(Shard(1, 3))
        bad.content = {"x": object()}
        with self.assertRaises(TypeError):
            results.write(path, bad)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["1.json"])
        self.assertEqual(path.read_bytes(), before)

    def test_sources_are_what_they_hold_and_where(self):
        for name, text in (("a/x.py", "1"), ("a/b/y.py", "2")):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)
        first = results.sources_digest(self.folder, ["a"])
        (self.folder / "a/__pycache__").mkdir()
        (self.folder / "a/__pycache__/x.pyc").write_text("3")
        self.assertEqual(results.sources_digest(self.folder, ["a"]), first)
        (self.folder / "a/x.py").write_text("4")
        self.assertNotEqual(results.sources_digest(self.folder, ["a"]), first)
        (self.folder / "a/x.py").write_text("1")
        (self.folder / "a/x.py").rename(self.folder / "a/z.py")
        self.assertNotEqual(results.sources_digest(self.folder, ["a"]), first)


if __name__ == "__main__":
    unittest.main()
