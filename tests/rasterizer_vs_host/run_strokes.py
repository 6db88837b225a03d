#!/usr/bin/env python3
"""Points, lines and polygons that are not filled, on the bare host and under the layer, whose rasterizer draws them.

  run_strokes.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides

ROUNDING = 4  # of 24 blended ones, whose alpha is a product of a width and a length
FEW_PIXELS = 3  # at the corners of what was cut
# At the ends of a smooth line's dashes, which Mesa 25 has a little otherwise than Mesa 22 and the rasterizer.
ENDS_OF_DASHES = 32


def judge(bare, layer):
    wrong = []
    for few, dashes in ((FEW_PIXELS, False), (ENDS_OF_DASHES, True)):
        one, other = ([(what, picture) for what, picture in records if ("smooth stippled" in what) == dashes]
                      for records in (bare, layer))
        wrong += sides.far_pictures(one, other, ROUNDING, few)
    return wrong + [f"'{what}': nothing is drawn" for what, picture in bare
                    if picture and not any(picture[0::4]) and not any(picture[2::4])]


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-strokes", judge)
    if args.backend == "swrast" and (not part.get("drawn", 0) or part.get("given_to_host", {})):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
