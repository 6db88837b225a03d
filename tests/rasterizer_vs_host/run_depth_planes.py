#!/usr/bin/env python3
"""Depths of slanting surfaces on the bare host and under the layer: the same to the last bit, so that of
surfaces in one plane the same one is seen, whichever of the two draws them.

  run_depth_planes.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import array
import sys

import sides

UNITS = 1 << 8  # of the last bit of 24, in what GL_UNSIGNED_INT reads
CLEARED = (1 << 32) - 1


def differing(what, a, b):
    """A line of what is wrong with a record's depths, or nothing."""
    bare, layer = array.array("I", a), array.array("I", b)
    covered = [(x, y) for x, y in zip(bare, layer) if CLEARED not in (x, y)]
    edges = sum((x == CLEARED) != (y == CLEARED) for x, y in zip(bare, layer))
    apart = [abs(x - y) for x, y in covered if x != y]
    if not apart and not edges:
        return None
    return f"'{what}': {len(apart)} depths of {len(covered)} differ, by up to {max(apart, default=0) / UNITS:.0f} " \
           f"units; {edges} pixels are covered by one of the two"


def judge(bare, layer):
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records"]
    lines = (differing(what, a, b) for (what, a), (_, b) in zip(bare, layer))
    return [line for line in lines if line]


def main():
    args = sides.seeded_arguments(__doc__, 12)
    bare, wrong, part = sides.compare(args, "rasterizer-depth-planes", judge)
    if args.backend == "swrast" and (not part.get("drawn", 0) or part.get("given_to_host", {})):
        wrong.append("draws of the host's")
    return sides.conclude(args, "primitives", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
