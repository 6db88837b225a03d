#!/usr/bin/env python3
"""Compares depth buffers without stencil, to which software hosts give 32 bits: random frames on the bare host and
under
the layer, in windows and framebuffer objects. The rasterizer must make all draws, and depths must be equal to the
last bit.

  run_depths.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import array
import sys

import sides


def distances(what, a, b):
    """Returns (pixels that differ, the largest difference)."""
    if what.endswith(" depth"):
        apart = [abs(x - y) for x, y in zip(array.array("I", a), array.array("I", b))]
        return sum(d > 0 for d in apart), max(apart, default=0)
    return sides.distances(a, b)


def judge(bare, layer):
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records: " + next((f"bare '{x}', layer '{y}'" for (x, _), (y, _) in
                                          zip(bare, layer) if x != y), "another count")]
    lines = []
    for (what, a), (_, b) in zip(bare, layer):
        far, worst = distances(what, a, b)
        if far:
            lines.append(f"'{what}': {far} pixels differ, by up to {worst}")
    return lines


def main():
    args = sides.seeded_arguments(__doc__, 12)
    bare, wrong, part = sides.compare(args, "rasterizer-depths", judge)
    drawn, given = part.get("drawn", 0), part.get("given_to_host", {})
    if not any("has 32," in what for what, _ in bare):
        print("the host gives no window 32 bits")
    if args.backend == "swrast" and (not drawn or given):
        wrong.append("draws of the host's")
    return sides.conclude(args, "frames", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
