#!/usr/bin/env python3
"""Lists the files of a release: artefacts.json says what each is, SHA256SUMS is what `sha256sum -c` reads.

usage: artefacts_list.py [--whole] --version V --commit C --date D FOLDER    writes both
       artefacts_list.py --check FOLDER     1 if a file is not as both say, or is in neither

A file that no kind describes is an error; so is, with --whole, a kind that has no file.
"""

import argparse
import hashlib
import json
import pathlib
import re
import sys

SCHEMA = 1
LIST, SUMS = "artefacts.json", "SHA256SUMS"
VERSION = r"\d+\.\d+\.\d+"
PACKAGES = {
    "arbiter": "the command, its manual and the pages",
    "libglx-arbiter0": "the layer",
    "libarbiter-jit0": "machine code of programs",
    "arbiter-builder": "the Shader Builder's window",
    "arbiter-demos": "the demonstrations",
    "arbiter-dev": "the header",
}
WIDTHS = {"amd64": "64-bit programs", "i386": "32-bit programs"}
# Patterns of names, and what such a file is.
KINDS = [(rf"{package}_{VERSION}-\d+_{architecture}\.deb", f"Debian package for {width}: {what}")
         for architecture, width in WIDTHS.items() for package, what in PACKAGES.items()
         if architecture != "i386" or package.startswith("lib")]
KINDS += [
    (rf"arbiter-{VERSION}-amd64\.tar\.xz", "a folder that runs from anywhere, with the window and the demonstrations"),
    (rf"arbiter-{VERSION}\.tar\.xz", "the sources, as git has them"),
    (rf"arbiter-{VERSION}-site\.tar\.xz", "the pages as a site with search"),
    (rf"arbiter-{VERSION}\.vsix", "the extension for Visual Studio Code"),
    (r"release-notes\.md", "what is new"),
]


def files_of(folder):
    return sorted(path for path in folder.iterdir() if path.name not in (LIST, SUMS))


def sum_of(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def described(folder, whole):
    """Returns (rows, complaints): a row for each file, and files or kinds that have no other half."""
    rows, complaints, met = [], [], set()
    for path in files_of(folder):
        kinds = [kind for kind in KINDS if re.fullmatch(kind[0], path.name)]
        if not kinds:
            complaints.append(f"{path.name}: nothing says what this is")
            continue
        met.add(kinds[0])
        rows.append({"name": path.name, "bytes": path.stat().st_size, "sha256": sum_of(path), "what": kinds[0][1]})
    if whole:
        complaints += [f"there is no {what} ({pattern})" for pattern, what in KINDS if (pattern, what) not in met]
    if not rows:
        complaints.append(f"{folder} is empty")
    return rows, complaints


def write(folder, options):
    rows, complaints = described(folder, options.whole)
    if complaints:
        return complaints
    report = {"schema": SCHEMA, "version": options.version, "commit": options.commit, "date": options.date,
              "files": rows}
    (folder / LIST).write_text(json.dumps(report, indent=1) + "\n")
    names = [row["name"] for row in rows] + [LIST]
    (folder / SUMS).write_text("".join(f"{sum_of(folder / name)}  {name}\n" for name in sorted(names)))
    for row in rows:
        print(f"{row['bytes']:>12}  {row['name']}")
    print(folder / LIST)
    return []


def checked(folder):
    """Returns complaints about files that are not as both lists say."""
    report = json.loads((folder / LIST).read_text())
    listed = {row["name"]: (row["bytes"], row["sha256"]) for row in report["files"]}
    sums = dict(reversed(line.split("  ", 1)) for line in (folder / SUMS).read_text().splitlines())
    there = {path.name: (path.stat().st_size, sum_of(path)) for path in files_of(folder)}
    complaints = [f"{name}: is not as {LIST} says" for name in sorted({*listed, *there})
                  if listed.get(name) != there.get(name)]
    there[LIST] = (0, sum_of(folder / LIST))
    return complaints + [f"{name}: is not as {SUMS} says" for name in sorted({*sums, *there})
                         if sums.get(name) != there.get(name, (0, None))[1]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--check", action="store_true")
    for name in ("--version", "--commit", "--date"):
        parser.add_argument(name)
    options = parser.parse_args()
    if not options.check and None in (options.version, options.commit, options.date):
        parser.error("--version, --commit and --date are needed")
    complaints = checked(options.folder) if options.check else write(options.folder, options)
    for complaint in complaints:
        print(f"artefacts: {complaint}", file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
