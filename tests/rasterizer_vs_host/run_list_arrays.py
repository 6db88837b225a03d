#!/usr/bin/env python3
"""Compares vertex arrays and primitives in display lists on the bare host and under the layer: pictures and errors must
be
equal, and the rasterizer draws what it can.

  run_list_arrays.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides

# The least number of draws of the rasterizer: lists, and a triangle after each. The host gets lists that restart
# primitives, contain errors or lack positions, and, of lists from before the first program, also those with any state.
ORDERS = {"programs-first": 209, "lists-first": 187, "no-programs": 209}
# There are more if lists are executed too: the triangles after those.
EXECUTED = {"programs-first": 294, "lists-first": 187, "no-programs": 294}
# After arrays with colors the current color is undefined (OpenGL 2.1, 2.8). Mesa uses the value that the previously
# compiled list set, which is a separate list only if the layer keeps none. Hosts split quads that are not flat freely,
# and differently at once and in lists.
UNDEFINED = ("no positions after", "client mode 7 arrays while compiled after",
             "buffer mode 7 arrays while compiled after")


# How the client makes lists under the layer, and on the bare host. Mesa 22.3.6 refuses commands behind a primitive of a
# list that it also executes, so that there lists are called after compilation. It draws quads of arrays differently in
# lists, and therefore also restarts: those pictures may match either.
MODES = {"compiled": ["compiled"], "executed": ["called", "executed"]}


def as_at_once(rows):
    """Returns the bare host's rows. If a list draws differently from its commands executed at once, with every
    component
    given, the latter count. Mesa 25.0.7 gives vertices of a list the coordinates of later ones with more components."""
    by_name = dict(rows)
    found = []
    for name, pixels in rows:
        end = " after" if name.endswith(" after") else ""
        directly = by_name.get(name.removesuffix(" after") + " directly" + end, pixels)
        found.append((name, directly if sides.distances(pixels, directly)[0] else pixels))
    return found


def name_in(line):
    """Returns the picture's name in a line of sides.differences."""
    return line.split("'")[1] if "'" in line else line


def judge(client, order, mode, layer, scratch):
    """Returns (complaints, the number of the rasterizer's draws)."""
    wrong, least = [], (EXECUTED if mode == "executed" else ORDERS)[order]
    for bare_mode in MODES[mode]:
        try:
            bare, layered, statistics = sides.bare_and_layer([client, order, mode], layer, scratch,
                                                             bare=[client, order, bare_mode])
        except (sides.Died, subprocess.TimeoutExpired) as death:
            return [str(death)], 0
        drawn = statistics.get("drawn", 0)
        defined = [[row for row in rows if row[0] not in UNDEFINED] for rows in (bare, layered)]
        wrong.append(sides.differences(as_at_once(defined[0]), defined[1]))
    few = [] if drawn >= least else [f"{drawn} draws of the rasterizer, of at least {least}"]
    names = set.intersection(*({name_in(line) for line in lines} for lines in wrong))
    return [line for line in wrong[0] if name_in(line) in names] + few, drawn


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
            for mode in MODES:
                wrong, drawn = judge(client, order, mode, layer, scratch)
                tally.row(f"{order}, {mode}: {drawn} draws of the rasterizer", wrong, 24)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
