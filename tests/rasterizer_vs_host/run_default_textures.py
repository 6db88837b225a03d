#!/usr/bin/env python3
"""Tests texture 0 of each target among named textures: random sequences on the bare host and under the layer, whose
pictures and texels are compared. The rasterizer must make the draws, except with textures that another context
deleted.

  run_default_textures.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides


def main():
    args = sides.seeded_arguments(__doc__, 40)
    # Mesa 22.3.6 reads freed memory when a context that shared textures ends, and hangs if it contains something else
    # by then, as Meson arranges for its tests.
    bare, wrong, part = sides.compare(args, "rasterizer-default-textures", sides.differences, {"MALLOC_PERTURB_": "0"})
    if not sides.mostly_ours(args, part, 50):
        wrong.append("too many draws are the host's")
    return sides.conclude(args, "sequences", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
