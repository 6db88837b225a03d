#!/usr/bin/env python3
"""Fails if the workflows of .github leave out a part of .ci/run, or take an action of no version.

ci.yml runs each command of .ci/run, and nothing else. release.yml begins with a tag, holds it to VERSION, makes the
artefacts and publishes them. An action is named with all three numbers of its version.

usage: workflows.py ROOT | workflows.py --self-test
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "include_graph"))
import tree

FOLDER = ".github/workflows"
COMMAND = re.compile(r"^(?:exec )?(\./dev [^\n]*?) *$", re.M)
PART = re.compile(r'^ *- \{name: \w+, command: "([^"]*)"\}$', re.M)
ACTION = re.compile(r"^ *(?:- )?uses: *([^\s#]+)", re.M)
# What the release does, in this order.
STEPS = ('tags: ["v*"]', '= "v$(cat VERSION)"', "scripts/artefacts.sh ", "actions/upload-artifact@",
         "actions/download-artifact@", "sha256sum -c SHA256SUMS", "gh release create ")


def complaints_of(root):
    complaints = []
    asked = COMMAND.findall((root / ".ci/run").read_text())
    done = PART.findall((root / FOLDER / "ci.yml").read_text())
    complaints += [f".ci/run: ci.yml does not run {command}" for command in asked if command not in done]
    complaints += [f"ci.yml: .ci/run has no {command}" for command in done if command not in asked]
    release, at = (root / FOLDER / "release.yml").read_text(), 0
    for step in STEPS:
        place = release.find(step, at)
        if place < 0:
            complaints.append(f"release.yml: has no {step.strip()}, or not in its place")
        else:
            at = place
    actions = 0
    for path in sorted((root / FOLDER).glob("*.yml")):
        for action in ACTION.findall(path.read_text()):
            actions += 1
            if not re.fullmatch(r"[\w/-]+@v\d+\.\d+\.\d+", action):
                complaints.append(f"{path.name}: {action} has no version of three numbers")
    return complaints, len(done) + actions


GOOD = {
    ".ci/run": "#!/bin/sh\n# ./dev is asked thrice.\n./dev check --quick\nexec ./dev test\n",
    f"{FOLDER}/ci.yml": ('        - {name: check, command: "./dev check --quick"}\n'
                         '        - {name: test, command: "./dev test"}\n      - uses: actions/checkout@v4.2.2\n'),
    f"{FOLDER}/release.yml": ("tags: [\"v*\"]\ntest $TAG = \"v$(cat VERSION)\"\nscripts/artefacts.sh out\n"
                              "- uses: actions/upload-artifact@v4.6.2\n- uses: actions/download-artifact@v4.3.0\n"
                              "sha256sum -c SHA256SUMS\ngh release create v1\n"),
}


def changed(name, old, new):
    assert old in GOOD[name], (name, old)
    return {**GOOD, name: GOOD[name].replace(old, new, 1)}


PLANTED = [
    (GOOD, 0),
    (changed(".ci/run", "exec ", "./dev package --libraries\nexec "), 1),
    (changed(f"{FOLDER}/ci.yml", "./dev test", "./dev tests"), 2),
    (changed(f"{FOLDER}/ci.yml", "@v4.2.2", "@v4"), 1),
    (changed(f"{FOLDER}/ci.yml", "@v4.2.2", "@main"), 1),
    (changed(f"{FOLDER}/ci.yml", "@v4.2.2", ""), 1),
    (changed(f"{FOLDER}/release.yml", "tags:", "branches:"), 1),
    (changed(f"{FOLDER}/release.yml", "v$(cat VERSION)", "v1.0.0"), 1),
    (changed(f"{FOLDER}/release.yml", "sha256sum -c SHA256SUMS\ngh release create v1\n",
             "gh release create v1\nsha256sum -c SHA256SUMS\n"), 1),
]


if __name__ == "__main__":
    sys.exit(tree.main(__doc__, complaints_of, PLANTED, "{read} parts and actions read, {wrong} complaints"))
