#!/usr/bin/env python3
"""Compares points, lines and unfilled polygons on the bare host and under the layer, whose rasterizer draws them.

  run_strokes.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides

ROUNDING = 4  # of 24 blended layers, whose alpha is a product of a width and a length
FEW_PIXELS = 3  # at the corners of what was clipped
# In one picture of forty a point is between two rows within its last bit. Also, the ends of a smooth line's dashes
# differ slightly between Mesa 25 and both Mesa 22 and the rasterizer.
A_ROW = 48


def judge(bare, layer):
    wrong = sides.far_pictures(bare, layer, ROUNDING, A_ROW)
    close = [line for line in sides.far_pictures(bare, layer, ROUNDING, FEW_PIXELS) if "smooth stippled" not in line]
    if len(close) > len(bare) / 40:
        wrong += close
    return wrong + sides.empty_pictures(bare)


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-strokes", judge)
    if not sides.all_ours(args, part):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
