#!/usr/bin/env python3
"""Fails if scripts/packages.sh and docs/dependencies.md do not name the same packages."""

import pathlib
import re
import sys


def main():
    root = pathlib.Path(sys.argv[1])
    lists = re.sub(r"#.*", "", (root / "scripts/packages.sh").read_text())
    installed = {word for body in re.findall(r"packages_\w+=\(([^)]*)\)", lists)
                 for word in body.split()}
    rows = re.findall(r"^\| (`[^|]*) \|", (root / "docs/dependencies.md").read_text(), re.M)
    documented = {name for row in rows for name in re.findall(r"`([^`]+)`", row)}
    for name in sorted(installed - documented):
        print("docs/dependencies.md does not say why %s is installed" % name, file=sys.stderr)
    for name in sorted(documented - installed):
        print("docs/dependencies.md names %s, which no list installs" % name, file=sys.stderr)
    return 1 if installed != documented or not installed else 0


if __name__ == "__main__":
    sys.exit(main())
