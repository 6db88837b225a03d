"""Shared parts of the checks of a tree: its includes, small trees with planted faults, and main().

A check is a function of a tree's root that returns (complaints, how much it has read). Planted trees
are a list of ({file: text}, complaints expected).
"""

import pathlib
import re
import sys
import tempfile

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.M)
SUFFIXES = {".h", ".hpp", ".cpp", ".cc", ".c", ".def", ".inc", ".in"}


def includes(folder):
    """Returns [(path, [(whether it is quoted, name) of each include])] of the sources under a folder, sorted by
    path; empty if the folder does not exist."""
    return [(path, [(bracket == '"', name)
                    for bracket, name in INCLUDE.findall(path.read_text(errors="replace"))])
            for path in sorted(folder.rglob("*")) if path.suffix in SUFFIXES and path.is_file()]


def self_test(check, planted):
    """Checks that each planted tree gives the expected number of complaints, 0 for a good one."""
    for files, expected in planted:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            complaints, _ = check(root)
            assert len(complaints) == expected, (files, complaints, expected)
    print(f"{len(planted)} passed, 0 failed, 0 skipped")


def main(usage, check, planted, summary):
    """Returns the exit status of a check's command line: the root of a tree, or --self-test. The summary has
    places for `read` and `wrong`. A tree of which nothing is read fails."""
    if sys.argv[1:] == ["--self-test"]:
        self_test(check, planted)
        return 0
    if len(sys.argv) != 2:
        print(usage, file=sys.stderr)
        return 2
    complaints, read = check(pathlib.Path(sys.argv[1]).resolve())
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    print(summary.format(read=read, wrong=len(complaints)))
    return 1 if complaints or not read else 0
