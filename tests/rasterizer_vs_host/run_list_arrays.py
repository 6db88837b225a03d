#!/usr/bin/env python3
"""Vertex arrays and primitives in display lists, on the bare host and under the layer: pictures and errors
are equal, and the rasterizer draws what it can.

  run_list_arrays.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides

# What the rasterizer draws at least: lists, and a triangle after each. Left to the host are lists that
# restart primitives, hold mistakes or have no positions; of those from before the first program also what
# holds any state.
ORDERS = {"programs-first": 195, "lists-first": 173, "no-programs": 195}
# After arrays with colours the current colour is undefined (OpenGL 2.1, 2.8). Mesa takes for it what the list that
# was compiled before set, which is a list of its own only where the layer keeps none.
UNDEFINED = ("no positions after",)


def judge(client, order, layer, scratch):
    """(lines of what is wrong, how many draws were the rasterizer's)."""
    try:
        bare, layered, statistics = sides.bare_and_layer([client, order], layer, scratch)
    except (sides.Died, subprocess.TimeoutExpired) as death:
        return [str(death)], 0
    drawn = statistics.get("drawn", 0)
    few = [] if drawn >= ORDERS[order] else [f"{drawn} draws of the rasterizer, of at least {ORDERS[order]}"]
    defined = [[row for row in rows if row[0] not in UNDEFINED] for rows in (bare, layered)]
    return sides.differences(*defined) + few, drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-list-arrays"
    layer = sides.layer_of(build)
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-list-arrays-") as scratch:
        for order in ORDERS:
            wrong, drawn = judge(client, order, layer, scratch)
            tally.row(f"{order}: {drawn} draws of the rasterizer", wrong, 24)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
