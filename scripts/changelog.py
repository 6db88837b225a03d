#!/usr/bin/env python3
"""Reads CHANGELOG.md: prints the versions, or the notes of a release, which are the newest entry.

usage: changelog.py [--notes]     without, a line for each version: VERSION DATE

An entry begins with `## VERSION (YYYY-MM-DD)` and ends where the next one begins.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADING = re.compile(r"^## (\d+\.\d+\.\d+) \((\d{4}-\d{2}-\d{2})\)$", re.M)


def entries(text):
    """Returns [(version, date, text)] of a changelog, in the order of its entries."""
    found = list(HEADING.finditer(text))
    ends = [heading.start() for heading in found[1:]] + [len(text)]
    return [(heading.group(1), heading.group(2), text[heading.end():end].strip())
            for heading, end in zip(found, ends)]


def notes(text):
    """Returns the newest entry as a page of its own, without links into the tree."""
    version, date, body = entries(text)[0]
    body = re.sub(r"^###", "##", body, flags=re.M)
    # Beside the files of a release there is no tree that a link could lead into.
    body = re.sub(r"\[([^][]*)\]\((?![a-z]+:)[^)]*\)", r"\1", body)
    return (f"# Arbiter {version}\n\nReleased on {date}.\n\n{body}\n\n## Files\n\n"
            "`sha256sum -c SHA256SUMS` checks what you have loaded. artefacts.json says what each file is.\n")


if __name__ == "__main__":
    content = (ROOT / "CHANGELOG.md").read_text()
    if sys.argv[1:] == ["--notes"]:
        print(notes(content), end="")
    elif len(sys.argv) == 1:
        for number, day, _ in entries(content):
            print(number, day)
    else:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
