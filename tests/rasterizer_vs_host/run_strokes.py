#!/usr/bin/env python3
"""Points, lines and polygons that are not filled, on the bare host and under the layer, whose rasterizer draws them.

  run_strokes.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides

ROUNDING = 4  # of 24 blended ones, whose alpha is a product of a width and a length
FEW_PIXELS = 3  # at the corners of what was cut


def judge(bare, layer):
    wrong = sides.differences([(what, b"") for what, _ in bare], [(what, b"") for what, _ in layer])
    for (what, one), (_, other) in zip(bare, layer):
        far, worst = sides.distances(one, other, ROUNDING)
        if far > FEW_PIXELS:
            wrong.append(f"'{what}': {far} pixels differ, by up to {worst}")
        if one and not any(one[0::4]):
            wrong.append(f"'{what}': nothing is drawn")
    return wrong


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-strokes", judge)
    if args.backend == "swrast" and (not part.get("drawn", 0) or part.get("given_to_host", {})):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
