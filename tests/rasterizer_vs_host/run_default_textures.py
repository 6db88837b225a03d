#!/usr/bin/env python3
"""Texture 0 of each target among textures with names: random sequences on the bare host and under the
layer, pictures and texels compared; their draws must be the rasterizer's, but for textures that another
context deleted.

  run_default_textures.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides


def main():
    args = sides.seeded_arguments(__doc__, 40)
    # Mesa 22.3.6 reads memory that it freed where a context ends that shared textures, and waits for
    # ever where freed memory holds something else by then: Meson asks for that of its tests.
    bare, wrong, part = sides.compare(args, "rasterizer-default-textures", sides.differences, {"MALLOC_PERTURB_": "0"})
    if not sides.mostly_ours(args, part, 50):
        wrong.append("too many draws are the host's")
    return sides.conclude(args, "sequences", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
