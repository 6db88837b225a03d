#!/usr/bin/env python3
"""Compares fixed function with depth comparison textures on the bare host and under the layer, whose rasterizer draws
them: each target, depth format, TEXTURE_COMPARE_FUNC, DEPTH_TEXTURE_MODE and filter.

  run_compared.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides

OTHER = ", t is another"  # OpenGL's rule, which no host follows: the reference is the picture without it


def judge(bare, layer):
    wrong = sides.differences([each for each in bare if OTHER not in each[0]],
                              [each for each in layer if OTHER not in each[0]])
    ours = dict(layer)
    for what, picture in layer:
        far, worst = sides.distances(picture, ours[what.replace(OTHER, "")], 0)
        if far:
            wrong.append(f"'{what}': {far} pixels are not those where t is r, by up to {worst}")
    return wrong


def main():
    args = sides.seeded_arguments(__doc__, 1)
    bare, wrong, part = sides.compare(args, "rasterizer-compared", judge)
    if args.backend == "swrast" and (not part.get("drawn") or part.get("given_to_host")):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
