#!/usr/bin/env python3
"""Fails if docs/design/builder_answers.md names a test that does not exist, or if a row of its tables names none.

`Suite.Name` is a TEST of that suite and name in some source, `Class.test_name` a method of a Python
test, and a single word a test name in a meson.build.

usage: answers.py ROOT | answers.py --self-test
"""

import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = "docs/design/builder_answers.md"
CPP = re.compile(r"^TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.M)
PYTHON = re.compile(r"^(?:class (\w+)|    def (test_\w+))", re.M)
BUILD = re.compile(r"\btest\(\s*'([\w:-]+)'")
NAMED = re.compile(r"`([\w.:-]+)`")
COMPLAINTS = 10


def sources(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True,
                            text=True)
    names = listed.stdout.split("\n") if listed.returncode == 0 else [
        path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()]
    for name in names:
        path = root / name
        if name.endswith((".cpp", ".py", "meson.build")) and path.is_file():
            yield name, path.read_text(errors="replace")


def tests_of(root):
    """Returns all names of tests, as the page spells them."""
    names = set()
    for name, text in sources(root):
        if name.endswith(".cpp"):
            names.update(f"{suite}.{test}" for suite, test in CPP.findall(text))
        elif name.endswith(".py"):
            owner = ""
            for each, method in PYTHON.findall(text):
                owner = each or owner
                if method:
                    names.add(f"{owner}.{method}")
        else:
            names.update(BUILD.findall(text))
    return names


def rows_of(page):
    """Yields (line number, cells) of each table's rows, without its head."""
    previous = ""
    for number, line in enumerate(page.split("\n"), 1):
        is_row = line.startswith("| ") and previous.startswith(("|---", "| "))
        if is_row:
            yield number, [cell.strip() for cell in line.strip("|").split("|")]
        previous = line


def complaints_of(root):
    page = (root / PAGE).read_text()
    known = tests_of(root)
    found = []
    numbers = []
    for number, cells in rows_of(page):
        named = NAMED.findall(cells[-1])
        if not named:
            found.append(f"{PAGE}:{number}: names no test")
        found += [f"{PAGE}:{number}: there is no test {name}" for name in named if name not in known]
        if digits := re.match(r"(\d+)\. ", cells[0]):
            numbers.append(int(digits.group(1)))
    if numbers != list(range(1, COMPLAINTS + 1)):
        found.append(f"{PAGE}: complaints are {numbers}, not 1 to {COMPLAINTS}")
    return found


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / PAGE).parent.mkdir(parents=True)
        (root / "a_test.cpp").write_text("TEST_F(Window, Opens) {}\nTEST(Session,\n     Draws) {}\n")
        (root / "a.py").write_text("class Other:\n    def test_b(self):\nclass A:\n    def test_a(self):\n")
        (root / "meson.build").write_text("test('gallery', exe)\n")
        rows = "".join(f"| {i}. x | y | `Window.Opens`, `A.test_a` |\n" for i in range(1, COMPLAINTS))
        good = "| a | b | tests |\n|---|---|---|\n" + rows + "| 10. x | y | `gallery`, `Session.Draws` |\n"
        page = root / PAGE
        for text, wrong in ((good, 0), (good.replace("Window.Opens", "Window.Open"), COMPLAINTS - 1),
                            (good.replace("A.test_a", "A.test_b"), COMPLAINTS - 1),
                            (good.replace("`gallery`, `Session.Draws`", "none"), 1),
                            (good.replace("| 3. x", "| x"), 1)):
            page.write_text(text)
            assert len(complaints_of(root)) == wrong, (text, complaints_of(root))
    return 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(self_test())
    complaints = complaints_of(pathlib.Path(sys.argv[1]))
    print("\n".join(complaints) or "every test that the page names is there")
    sys.exit(1 if complaints else 0)
