#!/usr/bin/env python3
"""Fails when the example of docs/design/ir.md is not what `arbiter compile` prints.

usage: ir_example.py ARBITER ROOT
"""

import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = "docs/design/ir.md"
EMITTED = (("--emit", "ir"), ("--emit", "ir", "-O"), ("--emit", "glsl"))


def main(command, root):
    blocks = re.findall(r"^```\n(.*?)^```$", (root / PAGE).read_text(), re.M | re.S)
    if len(blocks) != 1 + len(EMITTED):
        print(f"{PAGE}: {len(blocks)} blocks of code, not the program and {len(EMITTED)} more", file=sys.stderr)
        return 1
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "example.fp"
        program.write_text(blocks[0])
        for options, written in zip(EMITTED, blocks[1:]):
            told = subprocess.run([command, "compile", *options, str(program)], capture_output=True, text=True)
            if told.stdout != written or told.returncode:
                wrong += 1
                print(f"{PAGE}: arbiter compile {' '.join(options)} prints\n{told.stdout}{told.stderr}",
                      file=sys.stderr)
    print(f"{len(EMITTED) - wrong} passed, {wrong} failed, 0 skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
