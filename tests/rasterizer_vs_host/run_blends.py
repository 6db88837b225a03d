#!/usr/bin/env python3
"""Tests blending in byte buffers: each pair of factors, each equation, with and without alpha, and a stack of faint
layers, on the bare host and by the rasterizer. The two must be equal to the last bit: llvmpipe rounds operands and
each product to bytes, and so does the rasterizer.

  run_blends.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides

# One picture for each of: factors, equations, and the layers; the last record has the errors.
RECORDS = 2 * (15 * 15 + 5 * 5) + 1 + 1
# Whoever fills the pictures, the rasterizer draws the blended squares.
SQUARES = 64


def judge(bare, layer, drawn):
    wrong = sides.differences(bare, layer, rounding=0)
    if len(bare) != RECORDS:
        wrong.append(f"{len(bare)} records, not {RECORDS}")
    if len({picture for _, picture in bare}) < RECORDS // 2:
        wrong.append("pictures are alike that are to differ")
    if drawn < SQUARES * (RECORDS - 2):
        wrong.append(f"the rasterizer drew {drawn} squares of {SQUARES * (RECORDS - 2)}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    build = parser.parse_args().build.resolve()
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-blends-") as scratch:
        try:
            bare, layer, part = sides.bare_and_layer([build / "tests/rasterizer_vs_host/rasterizer-blends"],
                                                     sides.layer_of(build), scratch)
            tally.row("blended bytes", judge(bare, layer, part.get("drawn", 0)))
        except sides.Died as death:
            tally.row("blended bytes", [str(death)])
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
