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
ORDERS = {"programs-first": 209, "lists-first": 187, "no-programs": 209}
# More where lists are executed too: the triangles after those.
EXECUTED = {"programs-first": 294, "lists-first": 187, "no-programs": 294}
# After arrays with colours the current colour is undefined (OpenGL 2.1, 2.8). Mesa takes for it what the list that
# was compiled before set, which is a list of its own only where the layer keeps none.
# Quads that are not flat are drawn as the host likes, at once otherwise than in lists.
UNDEFINED = ("no positions after", "client mode 7 arrays while compiled after",
             "buffer mode 7 arrays while compiled after")


# How the client makes lists under the layer, and on the bare host. Mesa 22.3.6 refuses commands behind a primitive
# of a list that it executes too, so there lists are called once they are compiled. It draws quads of arrays otherwise
# in lists than at once, and so restarts: those pictures may be as of either.
MODES = {"compiled": ["compiled"], "executed": ["called", "executed"]}


def as_at_once(rows):
    """The bare host's rows; of a list that it draws otherwise than its commands at once, with every component
    given, what those draw. Mesa 25.0.7 gives vertices of a list the coordinates of later ones that have more
    components."""
    by_name = dict(rows)
    found = []
    for name, pixels in rows:
        end = " after" if name.endswith(" after") else ""
        directly = by_name.get(name.removesuffix(" after") + " directly" + end, pixels)
        found.append((name, directly if sides.distances(pixels, directly)[0] else pixels))
    return found


def name_in(line):
    """Of a line of sides.differences, the picture's."""
    return line.split("'")[1] if "'" in line else line


def judge(client, order, mode, layer, scratch):
    """(lines of what is wrong, how many draws were the rasterizer's)."""
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
