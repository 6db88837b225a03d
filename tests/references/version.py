#!/usr/bin/env python3
"""Fails if a file names another version than VERSION does, or another day than CHANGELOG.md.

VERSION is one line, MAJOR.MINOR.PATCH. meson.build and the scripts read it. Files that cannot are compared:
the newest entries of CHANGELOG.md and debian/changelog, the extension for VS Code, include/GL/arbiter.h, and what a
manual page or a store page says. With --built the outputs of a tree are compared too: what the command prints,
and the store page.

usage: version.py ROOT [--built ARBITER METAINFO] | version.py --self-test
"""

import datetime
import email.utils
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import changelog
import tree

FORM = re.compile(r"\d+\.\d+\.\d+")
DEBIAN = re.compile(r"^arbiter \(([^)]*)\) .*?^ -- [^\n]*?>  ([^\n]*)$", re.M | re.S)
HEADER = re.compile(r"^#define ARBITER_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)$", re.M)
# What asks for the version, and the words by which it does.
READERS = {
    "meson.build": "version: files('VERSION')",
    "docs/site/build.py": '"VERSION"',
    "scripts/tarball.sh": '"$root/VERSION"',
    "scripts/artefacts.sh": '"$root/VERSION"',
    "scripts/flatpak.sh": '"$root/VERSION"',
    "data/meson.build": "CHANGELOG.md",
    "data/arbiter-builder.metainfo.xml.in": "@releases@",
}


def of_debian(text):
    """Returns the version that is before Debian's revision, and the day, of a debian/changelog's newest entry."""
    entry = DEBIAN.match(text)
    if not entry:
        return "", ""
    moment = email.utils.parsedate_to_datetime(entry.group(2)).astimezone(datetime.timezone.utc)
    return entry.group(1).rpartition("-")[0] or entry.group(1), moment.date().isoformat()


def named_in(root):
    """Yields (place, version named there) of each file that names one; "" where one is missing."""
    yield "debian/changelog", of_debian((root / "debian/changelog").read_text())[0]
    yield "CHANGELOG.md", (changelog.entries((root / "CHANGELOG.md").read_text()) or [("", "", "")])[0][0]
    yield "editors/vscode/package.json", json.loads((root / "editors/vscode/package.json").read_text())["version"]
    yield "include/GL/arbiter.h", ".".join(HEADER.findall((root / "include/GL/arbiter.h").read_text()))
    for page in sorted(root.glob("docs/man/*.[1-9]")):
        head = re.match(r"\.TH (.*)", page.read_text())
        for number in FORM.findall(head.group(1)) if head else []:
            yield page.relative_to(root).as_posix(), number
    for page in sorted(root.glob("data/**/*.metainfo.xml")):
        for release in ElementTree.parse(page).iter("release"):
            yield page.relative_to(root).as_posix(), release.get("version")
            break


def complaints_of(root):
    text = (root / "VERSION").read_text()
    version = text[:-1]
    if not FORM.fullmatch(version) or not text.endswith("\n"):
        return [f"VERSION: is no line of MAJOR.MINOR.PATCH: {text!r}"], 1
    places = list(named_in(root))
    complaints = [f"{place}: names version {named or 'none'}, and VERSION {version}"
                  for place, named in places if named != version]
    for reader, words in READERS.items():
        if words not in (root / reader).read_text():
            complaints.append(f"{reader}: does not ask for the version ({words})")
    releases = changelog.entries((root / "CHANGELOG.md").read_text())
    day = of_debian((root / "debian/changelog").read_text())[1]
    if releases and releases[0][1] != day:
        complaints.append(f"debian/changelog: is of {day}, and CHANGELOG.md of {releases[0][1]}")
    numbers = [[int(part) for part in number.split(".")] for number, _, _ in releases]
    if numbers != sorted(numbers, reverse=True) or len(numbers) != len({*map(tuple, numbers)}):
        complaints.append("CHANGELOG.md: its versions are not each less than the one before")
    complaints += [f"CHANGELOG.md: the entry of {number} is empty" for number, _, body in releases if not body]
    return complaints, len(places)


def built_complaints(root, command, metainfo):
    """Returns complaints of what a tree has built."""
    version = (root / "VERSION").read_text().strip()
    printed = subprocess.run([command, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    complaints = [] if printed == f"arbiter {version}" else [f"{command}: prints {printed}, and VERSION has {version}"]
    releases = [(one.get("version"), one.get("date")) for one in ElementTree.parse(metainfo).iter("release")]
    expected = [(number, day) for number, day, _ in changelog.entries((root / "CHANGELOG.md").read_text())]
    if releases != expected:
        complaints.append(f"{metainfo}: has the releases {releases}, and CHANGELOG.md {expected}")
    return complaints


GOOD = {
    "VERSION": "1.2.3\n",
    **READERS,
    "CHANGELOG.md": "# Changes\n\n## 1.2.3 (2026-11-30)\n\nNew.\n\n## 1.2.2 (2026-11-26)\n\nOld.\n",
    "debian/changelog": ("arbiter (1.2.3-1) unstable; urgency=medium\n\n  * New.\n\n"
                         " -- A <a@arbiter.example>  Tue, 01 Dec 2026 01:00:00 +0200\n\n"
                         "arbiter (1.2.2-1) unstable; urgency=medium\n\n  * Old.\n\n"
                         " -- A <a@arbiter.example>  Thu, 26 Nov 2026 09:00:00 +0000\n"),
    "editors/vscode/package.json": '{"version": "1.2.3"}\n',
    "include/GL/arbiter.h": ("#define ARBITER_VERSION_MAJOR 1\n#define ARBITER_VERSION_MINOR 2\n"
                             "#define ARBITER_VERSION_PATCH 3\n"),
    "docs/man/arbiter.1": '.TH ARBITER 1 "" "Arbiter" "User Commands"\n',
    "data/flatpak/a.metainfo.xml": '<component><releases><release version="1.2.3"/></releases></component>\n',
}


def changed(name, old, new):
    assert old in GOOD[name], (name, old)
    return {**GOOD, name: GOOD[name].replace(old, new, 1)}


PLANTED = [
    (GOOD, 0),
    ({**GOOD, "debian/changelog": GOOD["debian/changelog"].replace("1.2.3-1", "1.2.3")}, 0),
    (changed("data/flatpak/a.metainfo.xml", '<release version="1.2.3"/>', ""), 0),
    (changed("docs/man/arbiter.1", '"Arbiter"', '"Arbiter 1.2.3"'), 0),
    (changed("docs/man/arbiter.1", '"Arbiter"', '"Arbiter 1.2.2"'), 1),
    (changed("data/flatpak/a.metainfo.xml", "1.2.3", "1.2.2"), 1),
    (changed("VERSION", "1.2.3\n", "1.2.3"), 1),
    (changed("VERSION", "1.2.3", "1.2"), 1),
    (changed("VERSION", "1.2.3", "1.2.4"), 5),
    (changed("debian/changelog", "1.2.3", "1.2.2"), 1),
    (changed("debian/changelog", "01 Dec", "02 Dec"), 1),
    (changed("debian/changelog", "arbiter (", "other ("), 2),
    (changed("editors/vscode/package.json", "1.2.3", "1.2.30"), 1),
    (changed("include/GL/arbiter.h", "MINOR 2", "MINOR 1"), 1),
    (changed("CHANGELOG.md", "## 1.2.3 (2026-11-30)\n\nNew.\n\n", ""), 2),
    (changed("CHANGELOG.md", "New.", ""), 1),
    (changed("CHANGELOG.md", "1.2.2", "1.2.10"), 1),
    (changed("meson.build", READERS["meson.build"], "version: '1.2.3'"), 1),
    (changed("scripts/tarball.sh", READERS["scripts/tarball.sh"], "1.2.3"), 1),
    (changed("data/arbiter-builder.metainfo.xml.in", "@releases@", ""), 1),
]


if __name__ == "__main__":
    if len(sys.argv) == 5 and sys.argv[2] == "--built":
        wrong = built_complaints(pathlib.Path(sys.argv[1]), *sys.argv[3:])
        print("\n".join(wrong) or "the command and the store page have the version")
        sys.exit(1 if wrong else 0)
    sys.exit(tree.main(__doc__, complaints_of, PLANTED, "{read} versions compared, {wrong} complaints"))
