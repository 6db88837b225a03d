#!/usr/bin/env python3
"""Tests scripts/artefacts.sh and the list of a release's files, with planted differences, in a small repository.

usage: artefacts_test.py SOURCE [unittest arguments]
"""

import fcntl
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

SOURCE = pathlib.Path(sys.argv[1]).resolve()
SCRIPT = SOURCE / "scripts" / "artefacts.sh"
LIST = SOURCE / "scripts" / "artefacts_list.py"
VERSION = (SOURCE / "VERSION").read_text().strip()
# What the parts need that are quick to make.
PARTS = "source,notes,vsix"
TREE = ("dev", "scripts", "editors", "VERSION", "CHANGELOG.md", "LICENSE")
sys.path.insert(0, str(SOURCE / "scripts"))
import artefacts_list  # noqa: E402


# Stands for ./dev where a part takes long to make: writes files of the names that the verbs write.
QUICK_DEV = f"""#!/bin/sh
set -e
cd "$(dirname "$0")"
mkdir -p out/packages/debug out/site
case "$*" in
  package)
    for name in {' '.join(artefacts_list.PACKAGES)}; do
      echo "$name" >"out/packages/${{name}}_{VERSION}-1_amd64.deb"
    done
    echo lines >"out/packages/debug/arbiter-dbgsym_{VERSION}-1_amd64.deb" ;;
  "package i386")
    [ -f build-package/build-i386.tar ] || date +%N >build-package/build-i386.tar
    for name in libglx-arbiter0 libarbiter-jit0; do
      cp build-package/build-i386.tar "out/packages/${{name}}_{VERSION}-1_i386.deb"
    done ;;
  docs) echo page >out/site/index.html ;;
  tarball) echo "$SOURCE_DATE_EPOCH" >out/arbiter-{VERSION}-amd64.tar.xz ;;
  vsix) exec python3 editors/vsix.py out/arbiter-vscode.vsix ;;
esac
"""


def run(*command, folder=None):
    return subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)


class Folder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)


class Compare(Folder):
    def pair(self, first, second):
        for name, files in (("a", first), ("b", second)):
            for file, content in files.items():
                path = self.folder / name / file
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
            (self.folder / name).mkdir(exist_ok=True)
        return run(SCRIPT, "--compare", self.folder / "a", self.folder / "b")

    def test_equal_folders_pass(self):
        done = self.pair({"x.deb": b"\0\1", "sub/y z": b"y"}, {"x.deb": b"\0\1", "sub/y z": b"y"})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("2 files compared, 0 differ", done.stdout)

    def test_a_byte_that_differs_is_an_error_that_names_the_file(self):
        done = self.pair({"x.deb": b"\0\1", "sub/y z": b"y"}, {"x.deb": b"\0\1", "sub/y z": b"Y"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("artefacts: sub/y z differs", done.stderr)
        self.assertNotIn("x.deb", done.stderr)

    def test_a_file_of_one_folder_alone_is_an_error(self):
        for first, second in (({"x": b"", "y": b""}, {"x": b""}), ({"x": b""}, {"x": b"", "y": b""})):
            shutil.rmtree(self.folder / "a", ignore_errors=True)
            shutil.rmtree(self.folder / "b", ignore_errors=True)
            done = self.pair(first, second)
            self.assertEqual(done.returncode, 1)
            self.assertIn("artefacts: only one of both turns has y", done.stderr)

    def test_nothing_is_no_success(self):
        self.assertEqual(self.pair({}, {}).returncode, 1)
        self.assertEqual(run(SCRIPT, "--compare", self.folder / "a", self.folder / "none").returncode, 1)
        self.assertEqual(run(SCRIPT, "--compare", self.folder / "a").returncode, 1)


class List(Folder):
    NAMES = {
        *(f"{name}_{VERSION}-1_amd64.deb" for name in artefacts_list.PACKAGES),
        *(f"{name}_{VERSION}-1_i386.deb" for name in ("libglx-arbiter0", "libarbiter-jit0")),
        f"arbiter-{VERSION}.tar.xz", f"arbiter-{VERSION}-amd64.tar.xz", f"arbiter-{VERSION}-site.tar.xz",
        f"arbiter-{VERSION}.vsix", "release-notes.md",
    }

    def setUp(self):
        super().setUp()
        for name in self.NAMES:
            (self.folder / name).write_text(name)

    def listed(self):
        return run(LIST, "--whole", "--version", VERSION, "--commit", "a" * 40, "--date", "2026-11-30T00:00:00Z",
                   self.folder)

    def check(self):
        return run(LIST, "--check", self.folder)

    def test_both_lists_say_what_is_there(self):
        self.assertEqual(self.listed().returncode, 0)
        report = json.loads((self.folder / "artefacts.json").read_text())
        self.assertEqual((report["schema"], report["version"], report["commit"]), (1, VERSION, "a" * 40))
        rows = {row["name"]: row for row in report["files"]}
        self.assertEqual(set(rows), self.NAMES)
        for name, row in rows.items():
            self.assertEqual((row["bytes"], row["sha256"]),
                             (len(name), hashlib.sha256(name.encode()).hexdigest()))
            self.assertTrue(row["what"])
        sums = run("sha256sum", "-c", "--strict", "SHA256SUMS", folder=self.folder)
        self.assertEqual(sums.returncode, 0, sums.stdout)
        self.assertEqual(len(sums.stdout.splitlines()), len(self.NAMES) + 1)
        self.assertEqual(self.check().returncode, 0)

    def test_the_packages_are_those_of_debian_control(self):
        control = (SOURCE / "debian" / "control").read_text()
        self.assertEqual(set(re.findall(r"^Package: (.*)$", control, re.M)), set(artefacts_list.PACKAGES))

    def test_a_kind_without_a_file_is_an_error(self):
        for name in sorted(self.NAMES):
            (self.folder / name).unlink()
            done = self.listed()
            self.assertEqual(done.returncode, 1, name)
            self.assertIn("artefacts: there is no ", done.stderr)
            self.assertFalse((self.folder / "SHA256SUMS").exists())
            (self.folder / name).write_text(name)

    def test_a_file_of_no_kind_is_an_error(self):
        for name in ("arbiter_1.deb", f"arbiter_{VERSION}-1_i386.deb", "core"):
            (self.folder / name).write_text("")
            self.assertIn(f"artefacts: {name}: nothing says what this is", self.listed().stderr)
            (self.folder / name).unlink()

    def test_a_changed_file_is_found(self):
        self.listed()
        for change in (lambda: (self.folder / "release-notes.md").write_text("other"),
                       lambda: (self.folder / "release-notes.md").unlink(),
                       lambda: (self.folder / "more").write_text("")):
            change()
            self.assertEqual(self.check().returncode, 1)
            (self.folder / "more").unlink(missing_ok=True)
            (self.folder / "release-notes.md").write_text("release-notes.md")
            self.assertEqual(self.check().returncode, 0)
        report = self.folder / "artefacts.json"
        report.write_text(report.read_text() + " ")
        self.assertIn("artefacts.json: is not as SHA256SUMS says", self.check().stderr)


class Build(Folder):
    """The parts that are quick to make, of a repository that has only what they need."""

    def setUp(self):
        super().setUp()
        self.tree = self.folder / "tree"
        self.tree.mkdir()
        for name in TREE:
            if (SOURCE / name).is_dir():
                shutil.copytree(SOURCE / name, self.tree / name, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copy2(SOURCE / name, self.tree / name)
        (self.tree / ".gitignore").write_text("/build*/\n/out*/\n__pycache__/\n")
        self.git("init", "--quiet")
        self.commit("first")

    def git(self, *words):
        done = run("git", "-c", "user.name=a", "-c", "user.email=a@arbiter.example", *words, folder=self.tree)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def commit(self, subject):
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", subject)

    def made(self, *words):
        return run(self.tree / "scripts" / "artefacts.sh", "--only", *(words or [PARTS]), folder=self.folder)

    def edit(self, name, old, new):
        text = (self.tree / name).read_text()
        self.assertIn(old, text)
        (self.tree / name).write_text(text.replace(old, new, 1))

    def test_files_are_made_twice_and_listed(self):
        done = self.made()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("1 files compared, 0 differ"), 3)
        out = self.tree / "out" / "release" / "artefacts"
        source = f"arbiter-{VERSION}.tar.xz"
        self.assertEqual({path.name for path in out.iterdir()},
                         {source, f"arbiter-{VERSION}.vsix", "release-notes.md", "artefacts.json", "SHA256SUMS"})
        report = json.loads((out / "artefacts.json").read_text())
        self.assertEqual(report["commit"], self.git("rev-parse", "HEAD").strip())
        self.assertIn(f"# Arbiter {VERSION}\n", (out / "release-notes.md").read_text())
        with tarfile.open(out / source) as archive:
            names = {name.partition("/")[2] for name in archive.getnames()}
        self.assertEqual({name for name in names if (self.tree / name).is_file()},
                         set(self.git("ls-files").splitlines()))
        # Nothing stays of the folders that they were built in.
        self.assertEqual(len(self.git("worktree", "list").splitlines()), 1)
        # debian/watch finds the sources among these files, and only them.
        watched = (SOURCE / "debian" / "watch").read_text().split()[-1]
        self.assertEqual([name for name in List.NAMES if re.fullmatch(watched, name)], [source])

    @unittest.skipUnless(run("dpkg", "--print-architecture").stdout == "amd64\n", "packages of 32 bits are amd64's")
    def test_all_parts_are_a_release(self):
        (self.tree / "dev").write_text(QUICK_DEV)
        self.commit("quick")
        done = run(self.tree / "scripts" / "artefacts.sh", self.folder / "made")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads((self.folder / "made" / "artefacts.json").read_text())
        self.assertEqual({row["name"] for row in report["files"]}, List.NAMES)
        self.assertEqual(run(LIST, "--check", self.folder / "made").returncode, 0)
        # Both turns have the Debian that the first one made; it is kept for the next commit.
        self.assertTrue((self.tree / "build-package" / "build-i386.tar").is_file())
        date = self.git("log", "-1", "--format=%ct")
        self.assertEqual((self.folder / "made" / f"arbiter-{VERSION}-amd64.tar.xz").read_text(), date)

    def test_a_part_is_made_once_a_commit(self):
        self.assertEqual(self.made("notes").stdout.count("turn: "), 2)
        self.assertEqual(self.made("notes").stdout.count("turn: "), 0)
        self.assertEqual(self.made("notes,vsix").stdout.count("turn: "), 2)
        self.edit("CHANGELOG.md", "# Changes", "# All changes")
        self.commit("second")
        self.assertEqual(self.made("notes").stdout.count("turn: "), 2)

    def test_a_date_or_a_folder_in_a_file_is_an_error(self):
        for planted in ("str(time.time_ns())", "str(EXTENSION)", "oct(os.umask(0))", "str(time.timezone)"):
            self.edit("editors/vsix.py", "    with zipfile",
                      f"    import os, time\n    files['x.txt'] = ({planted}).encode()\n    with zipfile")
            self.commit(planted)
            done = self.made("vsix,notes")
            self.assertEqual(done.returncode, 1, planted)
            self.assertIn(f"artefacts: arbiter-{VERSION}.vsix differs", done.stderr)
            self.assertNotIn("release-notes.md differs", done.stderr)
            self.assertFalse((self.tree / "out" / "release" / "artefacts").exists())
            self.git("reset", "--quiet", "--hard", "HEAD^")

    def test_what_is_not_committed_is_an_error(self):
        self.edit("CHANGELOG.md", "# Changes", "# All changes")
        done = self.made("notes")
        self.assertEqual(done.returncode, 1)
        self.assertIn("changes that are not committed", done.stderr)

    def test_two_runs_at_once_are_an_error(self):
        (self.tree / "build-artefacts").mkdir()
        with open(self.tree / "build-artefacts" / "lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            done = self.made("notes")
            self.assertEqual(done.returncode, 1)
            self.assertIn("another run is making them", done.stderr)
        self.assertEqual(self.made("notes").returncode, 0)

    def test_a_part_that_fails_fails_all(self):
        self.edit("scripts/changelog.py", "    content =", "    sys.exit(3)\n    content =")
        self.commit("broken")
        self.assertNotEqual(self.made("notes").returncode, 0)
        self.assertEqual(self.made("nothing").returncode, 1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
