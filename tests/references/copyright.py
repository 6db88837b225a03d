#!/usr/bin/env python3
"""Fails if the statements of copyright disagree: .reuse/dep5, debian/copyright, LICENSES/, and what files say of all.

Both lists have the same patterns of files, with the same holders and licences, each in its own words. Each pattern
meets a file, each licence has its text, and no text is left over. `reuse lint` reads .reuse/dep5: Debian 12's release
of it knows no other list, and newer ones take it too.

usage: copyright.py ROOT | copyright.py --self-test
"""

import fnmatch
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree
from references import tracked

REUSE, DEBIAN = ".reuse/dep5", "debian/copyright"
# Licences by SPDX's words, and by Debian's.
NAMES = {"MIT": "Expat", "GPL-2.0-or-later": "GPL-2+", "GPL-2.0-only": "GPL-2", "ClArtistic": "Clarified-Artistic"}
# The licence of the whole, as files of other forms name it.
WHOLE = {
    "meson.build": r"license: '([^']*)'",
    "editors/vscode/package.json": r'"license": "([^"]*)"',
    "data/arbiter-builder.metainfo.xml.in": r"<project_license>([^<]*)<",
}


def paragraphs(text):
    """Returns the paragraphs of a list as {field: text}; lines that go on are joined by line ends."""
    found = []
    for paragraph in re.split(r"\n\s*\n", text.strip()):
        fields, name = {}, ""
        for line in paragraph.split("\n"):
            if re.match(r"[\w-]+:", line):
                name, _, value = line.partition(":")
                fields[name] = value.strip()
            elif name:
                fields[name] += "\n" + line.strip()
        found.append(fields)
    return found


def licences(words):
    """Returns the licences that an expression joins, of SPDX's form or of Debian's, in SPDX's words."""
    spdx = {debian: name for name, debian in NAMES.items()}
    return {spdx.get(name, name) for name in re.split(r"\s+(?:AND|and|OR|or)\s+", words.split("\n")[0])}


def rules(text):
    """Returns {pattern: (holders, licences)} of a list."""
    return {pattern: (fields.get("Copyright", ""), licences(fields.get("License", "")))
            for fields in paragraphs(text) if "Files" in fields for pattern in fields["Files"].split()}


def complaints_of(root):
    texts = {name: (root / name).read_text() for name in (REUSE, DEBIAN)}
    lists = {name: rules(text) for name, text in texts.items()}
    names = tracked(root)
    complaints = []
    for pattern in sorted({*lists[REUSE], *lists[DEBIAN]}):
        ours, theirs = lists[REUSE].get(pattern), lists[DEBIAN].get(pattern)
        if ours != theirs:
            complaints.append(f"{pattern}: {REUSE} says {ours}, and {DEBIAN} {theirs}")
        if not any(fnmatch.fnmatchcase(name, pattern) for name in names):
            complaints.append(f"{pattern}: there is no such file")
    used = set().union(*(found for _, found in lists[REUSE].values()))
    there = {pathlib.PurePosixPath(name).stem for name in names if name.startswith("LICENSES/")}
    complaints += [f"LICENSES: has no text of {name}" for name in sorted(used - there)]
    complaints += [f"LICENSES: {name} is of no file" for name in sorted(there - used)]
    explained = {fields["License"].split("\n")[0] for fields in paragraphs(texts[DEBIAN])
                 if "Files" not in fields and "\n" in fields.get("License", "")}
    complaints += [f"{DEBIAN}: has no text of {NAMES.get(name, name)}" for name in sorted(used)
                   if NAMES.get(name, name) not in explained]
    whole = " AND ".join(sorted(lists[REUSE].get("*", ("", {"none"}))[1]))
    for name, form in WHOLE.items():
        said = re.search(form, (root / name).read_text())
        if not said or said.group(1) != whole:
            complaints.append(f"{name}: says {said and said.group(1)}, and {REUSE} {whole}")
    if (root / "LICENSE").read_text() != (root / f"LICENSES/{whole}.txt").read_text():
        complaints.append(f"LICENSE: is not LICENSES/{whole}.txt")
    return complaints, len(lists[REUSE]) + len(there)


GOOD = {
    REUSE: ("Format: x\n\nFiles: *\nCopyright: 2026 A\nLicense: MIT\n\n"
            "Files: b.png c.png\nCopyright: 2026 A\n 2001 B\nLicense: MIT AND GPL-2.0-or-later\n"),
    DEBIAN: ("Format: y\n\nFiles: *\nCopyright: 2026 A\nLicense: Expat\n\n"
             "Files: b.png\n c.png\nCopyright: 2026 A\n  2001 B\nLicense: Expat and GPL-2+\n\n"
             "License: Expat\n Text.\n\nLicense: GPL-2+\n Text.\n"),
    "meson.build": "project('a', license: 'MIT')\n",
    "editors/vscode/package.json": '{"license": "MIT"}\n',
    "data/arbiter-builder.metainfo.xml.in": "<project_license>MIT</project_license>\n",
    "LICENSE": "Text.\n", "LICENSES/MIT.txt": "Text.\n", "LICENSES/GPL-2.0-or-later.txt": "Text.\n",
    "b.png": "", "c.png": "",
}


def changed(name, old, new):
    assert old in GOOD[name], (name, old)
    return {**GOOD, name: GOOD[name].replace(old, new, 1)}


PLANTED = [
    (GOOD, 0),
    (changed(REUSE, "2001 B", "2002 B"), 2),
    (changed(REUSE, "MIT AND GPL-2.0-or-later", "GPL-2.0-or-later"), 2),
    (changed(DEBIAN, "Expat and GPL-2+", "Expat and GPL-2"), 2),
    (changed(DEBIAN, " c.png", " d.png"), 3),
    (changed(DEBIAN, "License: GPL-2+\n Text.\n", ""), 1),
    ({name: text for name, text in GOOD.items() if name != "c.png"}, 1),
    ({name: text for name, text in GOOD.items() if name != "LICENSES/GPL-2.0-or-later.txt"}, 1),
    ({**GOOD, "LICENSES/BSL-1.0.txt": "Text.\n"}, 1),
    ({**GOOD, "LICENSE": "Other.\n"}, 1),
    (changed("meson.build", "MIT", "GPL"), 1),
    (changed("editors/vscode/package.json", "license", "licence"), 1),
    (changed("data/arbiter-builder.metainfo.xml.in", "MIT", "Expat"), 1),
]


if __name__ == "__main__":
    sys.exit(tree.main(__doc__, complaints_of, PLANTED, "{read} rules and texts compared, {wrong} complaints"))
