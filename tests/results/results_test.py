#!/usr/bin/env python3
"""Tests of the results page: what is published of a fixture, and that each planted fault is refused."""

import copy
import json
import pathlib
import re
import shutil
import tempfile
import unittest

import fixture
from fixture import COMMIT, MACHINE, OTHER, SUITES, part, suite, written

import collect
import deviations
import page

ROWS = [{"name": "A | b", "kind": "drivers", "what": "w", "specification": "S", "section": "1", "here": "h",
         "why": "as specified", "others": {"Mesa": "m"}, "test": ["Case.One"], "code": ["src/a.cpp"],
         "since": "2026-11-30", "fails": ["piglit: spec@a*"]}]


class Folder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def changed(self, change):
        """Returns what is published of one suite's file after a change of it."""
        row = suite("piglit", [part("r300", 12, 1, 3, ["a"], {"x": 3}), part("swrast", 5, 0, 0)], MACHINE)
        change(row)
        root = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        return collect.collected([written(root, row["commit"], [row])], SUITES)

    def refused(self, change, reason):
        with self.assertRaisesRegex(collect.Refused, reason):
            self.changed(change)


class Collected(Folder):
    def setUp(self):
        super().setUp()
        self.data = collect.collected(fixture.two_hosts(self.folder), SUITES)
        self.rows = {(row["suite"], row["host"]): row for row in self.data["results"]}

    def test_a_column_is_a_driver(self):
        self.assertEqual([host["name"] for host in self.data["hosts"]], ["llvmpipe, Mesa 22.3", "llvmpipe, Mesa 25.0"])
        for renderer, version, processor, name in (
                ("softpipe", "2.1 Mesa 22.3.6", "x86_64", "softpipe, Mesa 22.3"),
                ("zink (llvmpipe (LLVM 15.0.6, 256 bits))", "4.6 Mesa 25.0.7", "x86_64", "zink, Mesa 25.0"),
                ("NVIDIA H200/PCIe/SSE2", "4.6.0 NVIDIA 580.159.04", "x86_64", "NVIDIA 580.159.04"),
                ("llvmpipe (LLVM 15.0.6)", "2.1 Mesa 22.3.6", "aarch64", "llvmpipe, Mesa 22.3, aarch64")):
            self.assertEqual(collect.host_of({"renderer": renderer, "version": version, "processor": processor}), name)

    def test_counts_of_a_real_log_are_its_tallys(self):
        row = self.rows["test", "llvmpipe, Mesa 22.3"]
        self.assertEqual([row[name] for name in collect.COUNTS], [17, 0, 3])

    def test_nothing_of_a_machine_is_published(self):
        text = json.dumps(self.data, ensure_ascii=False)
        self.assertIn("…/x.png", text)
        for secret in ("/home", "a machine's own name", str(self.folder)):
            self.assertNotIn(secret, text)
        self.assertEqual(collect.without_paths(f"{collect.ROOT}/src/a.cpp:3 needs /usr/bin/x, and/or ./dev test/all"),
                         "src/a.cpp:3 needs /usr/bin/x, and/or ./dev test/all")

    def test_no_folder_is_no_run(self):
        data = collect.collected([], SUITES)
        self.assertEqual((data["commit"], data["results"], data["suites"]), (None, [], SUITES))


class Faults(Folder):
    def test_the_file_without_a_fault_is_taken(self):
        self.assertEqual(self.changed(lambda row: None)["results"][0]["skips"], {"x": 3})

    def test_a_file_that_is_cut_short(self):
        folder, _ = fixture.two_hosts(self.folder)
        text = (folder / "piglit.json").read_text()
        for size in (0, 1, len(text) // 2, len(text) - 1):
            (folder / "piglit.json").write_text(text[:size])
            with self.assertRaisesRegex(collect.Refused, "piglit.json: cut short"):
                collect.collected([folder], SUITES)

    def test_counts_that_do_not_sum(self):
        self.refused(lambda row: row.update(passed=18), "18 passed, and its parts have 17")
        self.refused(lambda row: row.update(failed=2), "2 failed, and its parts have 1")
        self.refused(lambda row: row["parts"][0].update(skips={"x": 2}), "part r300: reasons of 2 of 3 skips")
        self.refused(lambda row: row.update(skips={"x": 4}), "reasons of 4 skips, 3 are counted")
        self.refused(lambda row: row.update(failures=["a", "b"]), "2 failures are named, 1 are counted")
        self.refused(lambda row: row.update(passed=-1), "not whole numbers")

    def test_what_a_file_lacks(self):
        for key in ("passed", "parts", "machine", "seconds", "status", "commit", "date", "schema"):
            self.refused(lambda row, key=key: row.pop(key) if key != "commit" else row.update(commit="dirty"),
                         key if key != "commit" else "commit or date")
        self.refused(lambda row: row.update(schema=2), "schema 2")
        self.refused(lambda row: row.update(suite="other"), "no suite other")

    def test_results_of_two_commits(self):
        folders = [written(self.folder, "a", [suite("test", [part("m", 1, 0, 0)], MACHINE)]),
                   written(self.folder, "b", [suite("piglit", [part("m", 1, 0, 0)], MACHINE, OTHER)])]
        with self.assertRaisesRegex(collect.Refused, "several commits: 0123456789ab, ffffffffffff"):
            collect.collected(folders, SUITES)
        data = collect.collected(folders, SUITES, other_commits=True)
        self.assertEqual(data["commit"], COMMIT)
        text = page.overview(page.checked(data, SUITES), [])
        self.assertIn("| 1 passed (commit ffffffffffff) |", text)
        self.assertIn("**1 result below, marked, is of another commit.**", text)

    def test_results_are_added_to_those_of_their_commit(self):
        first = collect.collected([written(self.folder, "a", [suite("test", [part("m", 1, 1, 0)], MACHINE),
                                                              suite("piglit", [part("m", 5, 0, 0)], MACHINE)])], SUITES)
        again = written(self.folder, "b", [suite("test", [part("m", 2, 0, 0)], {**MACHINE, "cores": 16})])
        data = collect.collected([again], SUITES, earlier=first)
        self.assertEqual({row["suite"]: row["passed"] for row in data["results"]}, {"test": 2, "piglit": 5})
        self.assertEqual([machine["cores"] for machine in data["hosts"][0]["machines"]], [16, MACHINE["cores"]])
        other = written(self.folder, OTHER, [suite("test", [part("m", 1, 0, 0)], MACHINE, OTHER)])
        with self.assertRaisesRegex(collect.Refused, "several commits"):
            collect.collected([other], SUITES, earlier=first)

    def test_a_file_in_the_folder_of_another_commit(self):
        folder = written(self.folder, OTHER, [suite("test", [part("m", 1, 0, 0)], MACHINE)])
        with self.assertRaisesRegex(collect.Refused, "in the folder of another"):
            collect.collected([folder], SUITES)

    def test_two_results_of_one_suite_on_one_host(self):
        rows = [suite("test", [part("m", 1, 0, 0)], MACHINE)]
        folders = [written(self.folder, "a", rows), written(self.folder, "b", rows)]
        for other_commits in (False, True):
            with self.assertRaisesRegex(collect.Refused, "two results of"):
                collect.collected(folders, SUITES, other_commits)

    def test_the_last_result_of_several_commits(self):
        first = written(self.folder, COMMIT, [suite("test", [part("m", 1, 0, 0)], MACHINE)])
        row = {**suite("test", [part("m", 2, 0, 0)], MACHINE, OTHER), "date": "2036-01-01T00:00:00Z"}
        later = written(self.folder, OTHER, [row])
        for folders in ((first, later), (later, first)):
            found = collect.collected(folders, SUITES, other_commits=True)
            self.assertEqual([(row["commit"], row["passed"]) for row in found["results"]], [(OTHER, 2)])


class Page(Folder):
    def setUp(self):
        super().setUp()
        self.data = collect.collected(fixture.two_hosts(self.folder), SUITES)

    def text(self, known=()):
        return page.overview(page.checked(self.data, SUITES), list(known))

    def test_suites_of_one_title_are_one_row(self):
        suites = [{**SUITES[0], "name": name, "title": "over another driver"} for name in ("here", "there", "nowhere")]
        names = ("softpipe", "zink")
        rows = [suite("here", [part("a", 3, 0, 0)], {**MACHINE, "renderer": names[0]}),
                suite("there", [part("a", 4, 0, 0)], {**MACHINE, "renderer": names[1]})]
        data = collect.collected([written(self.folder, "same", rows)], suites)
        lines = page.first_table(page.checked(data, suites), [])
        self.assertEqual(lines[0], "| suite | softpipe, Mesa 22.3 | zink, Mesa 22.3 |")
        self.assertEqual(lines[2:], ["| over another driver | 3 passed | 4 passed |"])
        data["results"].append({**data["results"][0], "suite": "nowhere", "passed": 0, "skipped": 1, "skips": {"x": 1},
                                "parts": []})
        self.assertEqual(page.first_table(page.checked(data, suites), [])[2:],
                         ["| over another driver | 3 passed; 0 passed, 1 skipped | 4 passed |"])

    def test_the_first_sentence_and_table(self):
        lines = self.text().splitlines()
        self.assertEqual(lines[2], "At commit `0123456789ab` of 30 November 2026, 4 of 20 suites ran on 2 hosts: 3,553 "
                         "cases passed, **1 failed**, 171 skipped. **1 suite ended early.**")
        self.assertEqual(lines[4], "| suite | llvmpipe, Mesa 22.3 | llvmpipe, Mesa 25.0 |")
        rows = {line.split(" | ")[0]: line for line in lines[6:26]}
        self.assertEqual(rows["| piglit, whole, five back ends"], "| piglit, whole, five back ends | **1 failed**, "
                         "2,433 passed, 34 skipped | 1,100 passed, 134 skipped |")
        self.assertIn("| passed | not run |", rows["| check: format, linters, generated files, tidy"])
        self.assertIn("| not run | **ended with status 124**, 3 passed |", rows["| fuzzing, an hour"])
        self.assertEqual(sum("| not run | not run |" in row for row in rows.values()), 16)

    def test_a_known_failure_is_linked(self):
        text = self.text(ROWS)
        self.assertIn("none failed apart from 1 known deviation", text)
        self.assertIn("| [A &#124; b](deviations.md) |", text)
        self.assertIn("| **no** |", self.text())

    def test_foreign_text_is_no_markup(self):
        text = self.text()
        self.assertIn("spec@a &#124; b@&#60;c&#62; &#96;d&#96;&#46;cpp", text)
        head, *rows = [line for line in text.splitlines() if "| host | case |" in line or "spec@a" in line]
        self.assertEqual({row.count("|") for row in rows}, {head.count("|")})

    def test_skips_have_their_reasons(self):
        text = self.text()
        self.assertIn("| 164 | needs GL 4.6 | piglit on llvmpipe, Mesa 22.3; piglit on llvmpipe, Mesa 25.0 |", text)
        self.assertIn("| 3 | no reason is given | test on llvmpipe, Mesa 22.3 |", text)

    def test_no_run_says_so(self):
        self.data = collect.collected([], SUITES)
        self.assertIn("none of the 20 planned suites has run", self.text())
        self.assertEqual(self.text().count("| not run |\n"), 20)

    def test_published_data_that_was_changed_by_hand(self):
        for change, reason in (
                (lambda data: data["results"][1].update(passed=99), "its parts have"),
                (lambda data: data["results"].append(data["results"][0]), "there twice"),
                (lambda data: data["results"][0].update(host="none"), "not planned"),
                (lambda data: data["suites"].pop(), "other suites than"),
                (lambda data: data.update(commit=OTHER), "no result is of its commit"),
                (lambda data: data.update(schema=0), "schema 0")):
            data = copy.deepcopy(self.data)
            change(data)
            with self.assertRaisesRegex(page.Stale, reason):
                page.checked(data, SUITES)

    def test_a_stale_page_is_named(self):
        self.assertEqual(page.stale(), [])
        copied = self.folder / "pages"
        shutil.copytree(page.HERE, copied)
        (copied / "README.md").write_text((copied / "README.md").read_text().replace("# Results", "# Result"))
        (copied / "pictures.md").unlink()
        self.assertEqual(page.stale(copied), ["README.md", "pictures.md"])


class Deviations(Folder):
    def setUp(self):
        super().setUp()
        for name, text in {"src/a.cpp": "TEST(Case, One) {", "tests/a/b_test.cpp": "TEST_F(Other, Two) {",
                           "tests/meson.build": "test('plain', x)\nways = ['one']\ntest('many-' + way, y)\n",
                           "tests/piglit/expectations/r300.txt": "# test | x\nspec@a* | pass | fail | why\n"}.items():
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_text(text)

    def read(self, **change):
        row = {**ROWS[0], **change}
        others = row.pop("others")
        lines = "".join(f"{key} = {json.dumps(value)}\n" for key, value in row.items() if value is not None)
        lines += "[deviation.others]\n" + "".join(f"{json.dumps(key)} = {json.dumps(value)}\n"
                                                  for key, value in others.items())
        (self.folder / "d.toml").write_text("[[deviation]]\n" + lines)
        return deviations.read(self.folder, self.folder / "d.toml")

    def test_tests_that_are_there(self):
        for name in ("Case.One", "Other.Two", "meson plain", "meson many-one", "piglit spec@a*"):
            self.assertEqual(self.read(test=name)[0]["test"], [name])

    def test_a_test_that_is_not_there(self):
        for name in ("Case.Two", "One", "meson none", "meson many-two", "meson many-", "piglit spec@b",
                     "piglit # test"):
            with self.assertRaisesRegex(deviations.Broken, re.escape(f"A | b: no test {name}")):
                self.read(test=["Case.One", name])

    def test_rows_with_a_fault(self):
        for change, reason in (({"test": []}, "has no test"), ({"code": ["src/b.cpp"]}, "no source src/b.cpp"),
                               ({"code": []}, "names no source"), ({"section": None}, "lacks section"),
                               ({"kind": "other"}, "kind is other"), ({"since": "lately"}, "since is no day"),
                               ({"others": {}}, "what other drivers do")):
            with self.assertRaisesRegex(deviations.Broken, reason):
                self.read(**change)

    def test_the_trees_own_rows(self):
        rows = deviations.read(page.ROOT)
        self.assertGreaterEqual(len(rows), 20)
        self.assertEqual({row["kind"] for row in rows}, set(deviations.KINDS))

    def test_only_what_it_names_is_explained(self):
        self.assertIs(deviations.explaining(ROWS, "piglit", "spec@a: b"), ROWS[0])
        self.assertIsNone(deviations.explaining(ROWS, "piglit", "spec@b"))
        self.assertIsNone(deviations.explaining(ROWS, "real", "spec@a"))


if __name__ == "__main__":
    unittest.main()
