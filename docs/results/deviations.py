"""Reads docs/results/deviations.toml, and checks that each row's tests and sources are in the tree."""

import fnmatch
import re
import tomllib

KINDS = ("specification", "drivers")
TEXTS = ("name", "what", "specification", "section", "here", "why", "since")
CASE = re.compile(r"\bTEST(?:_F|_P)?\((\w+), (\w+)\)")
MESON = re.compile(r"\btest\('([^']+)'( \+)?")
DATE = re.compile(r"\d{4}-\d\d-\d\d")


class Broken(Exception):
    """A table that cannot be published, with what is wrong in it."""


class Tests:
    """The tests that a tree has, by the names that a row may give."""

    def __init__(self, root):
        self.cases = {".".join(case) for folder in ("src", "tests") for file in (root / folder).rglob("*.cpp")
                      for case in CASE.findall(file.read_text(errors="replace"))}
        self.meson = [file.read_text() for folder in ("src", "tests", "demos", "docs", "data", "bench")
                      for file in (root / folder).rglob("meson.build")]
        self.rows = {line.split(" | ")[0].strip()
                     for file in (root / "tests" / "piglit" / "expectations").glob("*.txt")
                     for line in file.read_text().splitlines() if " | " in line and not line.startswith("#")}

    def has(self, name):
        kind, _, rest = name.partition(" ")
        if kind == "meson":
            return any(self.declares(text, rest) for text in self.meson)
        return rest in self.rows if kind == "piglit" else name in self.cases

    @staticmethod
    def declares(text, name):
        """True if a meson.build has the name, or a loop that makes it of a prefix and a word of the file."""
        return any(name.startswith(found) and f"'{name[len(found):]}'" in text if joined else name == found
                   for found, joined in MESON.findall(text))


def as_list(value):
    return [value] if isinstance(value, str) else list(value)


def complaints_of(row, tests, root):
    """Yields what is wrong with a row."""
    for key in TEXTS:
        if not isinstance(row.get(key), str) or not row[key].strip():
            yield f"lacks {key}"
    if row.get("kind") not in KINDS:
        yield f"kind is {row.get('kind')}, not {' or '.join(KINDS)}"
    if not DATE.fullmatch(str(row.get("since", ""))):
        yield "since is no day"
    if not row.get("others"):
        yield "does not say what other drivers do"
    if not as_list(row.get("test", [])):
        yield "has no test"
    for name in as_list(row.get("test", [])):
        if not tests.has(name):
            yield f"no test {name}"
    for name in row.get("code", []):
        if not (root / name).is_file():
            yield f"no source {name}"
    if not row.get("code"):
        yield "names no source"


def read(root, file=None):
    """Returns the rows in their order, each test and source of which is in the tree.
    Raises Broken with all that is wrong."""
    try:
        rows = tomllib.loads((file or root / "docs" / "results" / "deviations.toml").read_text())["deviation"]
    except (tomllib.TOMLDecodeError, KeyError) as error:
        raise Broken(f"deviations.toml: {error}") from None
    tests = Tests(root)
    wrong = [f"deviations.toml: {row.get('name')}: {text}" for row in rows for text in complaints_of(row, tests, root)]
    names = [row.get("name") for row in rows]
    wrong += [f"deviations.toml: {name} is there twice" for name in sorted(set(names)) if names.count(name) > 1]
    if wrong:
        raise Broken("\n".join(wrong))
    return [{**row, "test": as_list(row["test"]), "fails": as_list(row.get("fails", []))} for row in rows]


def explaining(rows, suite, failure):
    """Returns the deviation that explains a suite's failure, or None."""
    for row in rows:
        for pattern in row["fails"]:
            if fnmatch.fnmatchcase(f"{suite}: {failure}", re.sub(r"\[", "[[]", pattern)):
                return row
    return None
