#!/usr/bin/env python3
"""Compares fixed-function draws with all state random, on the bare host and under the layer, whose rasterizer draws
them.

  run_fixed_states.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides

ROUNDING = 1
# Pixels whose coordinate is between two faces of a cube within its last bit.
FEW_PIXELS = 2


def judge(bare, layer):
    return sides.far_pictures(bare, layer, ROUNDING, FEW_PIXELS)


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-fixed-states", judge)
    if not sides.mostly_ours(args, part, 20):
        wrong.append("too many draws are the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
