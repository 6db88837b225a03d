#!/usr/bin/env python3
"""Compares filled polygons of any shape on the bare host and under the layer, whose rasterizer draws them.

  run_polygons.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides


def judge(bare, layer):
    return sides.differences(bare, layer) + sides.empty_pictures(bare)


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-polygons", judge)
    if not sides.all_ours(args, part):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
