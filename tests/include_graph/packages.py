#!/usr/bin/env python3
"""Fails if the installed packages and docs/design/dependencies.md differ.

Installed are the packages of scripts/packages.sh and those that the real programs need."""

import pathlib
import re
import subprocess
import sys


def main():
    root = pathlib.Path(sys.argv[1])
    lists = re.sub(r"#.*", "", (root / "scripts/packages.sh").read_text())
    installed = {word for body in re.findall(r"packages_\w+=\(([^)]*)\)", lists)
                 for word in re.findall(r"[^\s'|]+", body)}
    real = root / "tests/real_programs_vs_host/run.py"
    if real.exists():
        installed.update(subprocess.run([sys.executable, str(real), "--packages"], check=True,
                                        capture_output=True, text=True).stdout.split())
    rows = re.findall(r"^\| (`[^|]*) \|", (root / "docs/design/dependencies.md").read_text(), re.M)
    documented = {name for row in rows for name in re.findall(r"`([^`]+)`", row)}
    for name in sorted(installed - documented):
        print("docs/design/dependencies.md does not say why %s is installed" % name, file=sys.stderr)
    for name in sorted(documented - installed):
        print("docs/design/dependencies.md names %s, which nothing installs" % name, file=sys.stderr)
    return 1 if installed != documented or not installed else 0


if __name__ == "__main__":
    sys.exit(main())
