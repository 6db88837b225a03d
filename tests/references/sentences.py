#!/usr/bin/env python3
"""Fails if a page's sentences are too long: the mean may be 17 words in README and 20 in a page of docs/.

Code, tables and headings are left out, and docs/reference/, which is generated. Code within a sentence is one word.
An item of a list ends a sentence, as a paragraph does.

usage: sentences.py ROOT | sentences.py --list ROOT | sentences.py --self-test
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree
from links import FENCE, LINK
from references import tracked

BOUNDS = {"README.md": 17, "CONTRIBUTING.md": 20, "SECURITY.md": 20, "CHANGELOG.md": 20, "docs/": 20}
GENERATED = "docs/reference/"
END = re.compile(r"(?<!\be\.g)(?<!\bi\.e)[.!?][)\"']*(?:\s+|$)")
WORD = re.compile(r"\w[\w'’.,/-]*")


def blocks(text):
    """Yields the paragraphs and the items of lists."""
    text = re.sub(r"<!--.*?-->", "", FENCE.sub("", text), flags=re.S)
    block = []
    for line in text.split("\n") + [""]:
        item = re.match(r"\s*(?:[-*]|\d+\.)\s+", line)
        if not line.strip() or item or line.startswith(("|", "#", "    ", "![")):
            if block:
                yield " ".join(block)
            block = []
        if line.startswith(("|", "#", "    ", "![")) and not item:
            continue
        if line.strip():
            block.append(line[item.end() if item else 0:].strip())


def sentences(text):
    """Yields the number of words of each sentence."""
    for block in blocks(text):
        block = LINK.sub(lambda link: re.sub(r"^!?\[|\]\([^)]*\)$", "", link.group()), block)
        block = re.sub(r"(`+).+?\1", "code", block)
        for sentence in END.split(block):
            words = len(WORD.findall(sentence))
            if words:
                yield words


def means(root):
    for name in sorted(tracked(root)):
        bound = next((most for start, most in BOUNDS.items() if name.startswith(start)), None)
        if bound and name.endswith(".md") and not name.startswith(GENERATED) and (root / name).is_file():
            lengths = list(sentences((root / name).read_text()))
            if lengths:
                yield name, sum(lengths) / len(lengths), bound, len(lengths)


def complaints_of(root):
    read, complaints = 0, []
    for name, mean, bound, count in means(root):
        read += count
        if mean > bound:
            complaints.append(f"{name}: {mean:.1f} words a sentence, {bound} at most")
    return complaints, read


SHORT, LONG = "One two three.", " ".join(["word"] * 21) + "."
PLANTED = [
    ({"README.md": f"{SHORT}\n"}, 0),
    ({"README.md": f"{LONG}\n"}, 1),
    ({"README.md": " ".join(["word"] * 18) + ".\n"}, 1),
    ({"docs/use/a.md": " ".join(["word"] * 18) + ".\n"}, 0),
    ({"docs/use/a.md": f"{LONG} {SHORT}\n"}, 0),
    ({"docs/use/a.md": f"- {LONG}\n- {LONG}\n"}, 1),
    ({"docs/use/a.md": "- " + " ".join(["word"] * 15) + "\n- " + " ".join(["word"] * 15) + "\n"}, 0),
    ({"docs/use/a.md": f"{SHORT}\n\n```\n{LONG}\n```\n\n| a | b |\n|---|---|\n| {LONG} | c |\n"}, 0),
    ({"docs/use/a.md": f"`{LONG}` is [one two three](a.md).\n"}, 0),
    ({"docs/reference/a.md": f"{LONG}\n", "docs/use/b.md": SHORT}, 0),
]

if __name__ == "__main__":
    if sys.argv[1:2] == ["--list"]:
        for page, average, most, number in means(pathlib.Path(sys.argv[2])):
            print(f"{average:5.1f} {'over' if average > most else '    '} {number:4} {page}")
        sys.exit(0)
    sys.exit(tree.main(__doc__, complaints_of, PLANTED, "{read} sentences, {wrong} pages over their bound"))
