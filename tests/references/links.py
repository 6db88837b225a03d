#!/usr/bin/env python3
"""Fails on a dead link of a page, on a page of docs/ that its index lacks, and on a file that README names unlinked.

Links are followed within the tree: to files, to folders, and to the #headings of pages. Addresses of other sites are
left alone, so that the test needs no network.

usage: links.py ROOT | links.py --self-test
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree
from references import tracked

INDEX = "docs/README.md"
LINK = re.compile(r"!?\[(?:[^][]|\[[^]]*\])*\]\(\s*([^)\s]*)[^)]*\)")
FENCE = re.compile(r"^(```|~~~).*?^\1[^\n]*$", re.M | re.S)
HEADING = re.compile(r"^#{1,6} +(.*?) *#*$", re.M)
NAMED = re.compile(r"(?<![\w/.-])(?:[\w.-]+/)*[\w-]+\.(?:md|toml|py|svg|png|sh)(?![\w-])")


def blank(match):
    """Blanks a match but keeps its line breaks, so that line numbers stay."""
    return re.sub(r"[^\n]", " ", match.group())


def anchor(heading):
    """Returns the anchor that a forge gives to a heading."""
    text = re.sub(r"!?\[([^][]*)\]\([^)]*\)", r"\1", heading).replace("`", "").lower()
    return re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", text))


def anchors(text):
    found = set()
    for heading in HEADING.findall(FENCE.sub(blank, text)):
        name, count = anchor(heading), 1
        while name in found:
            name, count = f"{anchor(heading)}-{count}", count + 1
        found.add(name)
    return found


def line_of(text, place):
    return text.count("\n", 0, place) + 1


def complaints_of(root):
    names = tracked(root)
    folders = {parent.as_posix() for name in names for parent in pathlib.PurePosixPath(name).parents}
    pages = {name: (root / name).read_text() for name in names if name.endswith(".md") and (root / name).is_file()}
    read, complaints, indexed = 0, [], {INDEX}
    for page, text in pages.items():
        for link in LINK.finditer(FENCE.sub(blank, text)):
            target, _, place = link.group(1).partition("#")
            if re.match(r"[a-z]+:", link.group(1)):
                continue
            read += 1
            file = resolved(page, target)
            where = f"{page}:{line_of(text, link.start())}"
            if file not in names and file not in folders:
                complaints.append(f"{where}: dead link {link.group(1)}")
            elif place and place not in anchors(pages.get(file, "")):
                complaints.append(f"{where}: no heading #{place} in {file}")
            if page == INDEX:
                indexed.add(file)
        if page == "README.md":
            bare = LINK.sub(blank, FENCE.sub(blank, text))
            complaints += [f"{page}:{line_of(bare, name.start())}: {name.group()} is named and not linked"
                           for name in NAMED.finditer(bare) if name.group() in names]
    if INDEX in pages:
        complaints += [f"{INDEX}: does not name {page}" for page in pages
                       if page.startswith("docs/") and page not in indexed]
    return complaints, read


def resolved(page, target):
    """Returns the path in the tree that a page's link leads to."""
    parts = [] if target.startswith("/") else list(pathlib.PurePosixPath(page).parent.parts)
    for part in pathlib.PurePosixPath(target).parts if target else [pathlib.PurePosixPath(page).name]:
        if part == ".." and parts:
            parts.pop()
        elif part not in (".", "/"):
            parts.append(part)
    return "/".join(parts) or "."


PAGES = {"docs/README.md": "[a](use/a.md)\n", "docs/use/a.md": "# One `two`\n\n```\n# no heading\n```\n"}
PLANTED = [
    # (text of README.md, complaints expected)
    ("[a](docs/use/a.md) and [two](docs/use/a.md#one-two), [docs](docs), [x](https://example.org/none.md)\n", 0),
    ("[a](docs/a.md)\n", 1),
    ("[a](docs/use/a.md#no-heading)\n", 1),
    ("[here](#there)\n\n## There\n", 0),
    ("[here](#nowhere)\n\n## There\n", 1),
    ("![picture](docs/none.png)\n", 1),
    ("See docs/use/a.md.\n", 1),
    ("See `docs/use/a.md`.\n", 1),
    ("See [`docs/use/a.md`](docs/use/a.md).\n\n```\ncat docs/use/a.md\n[a](none.md)\n```\n", 0),
]
UNLISTED = ({**PAGES, "docs/use/b.md": "# B\n"}, 1)

if __name__ == "__main__":
    sys.exit(tree.main(__doc__, complaints_of,
                       [({**PAGES, "README.md": text}, expected) for text, expected in PLANTED] + [UNLISTED],
                       "{read} links followed, {wrong} complaints"))
