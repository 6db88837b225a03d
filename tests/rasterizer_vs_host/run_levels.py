#!/usr/bin/env python3
"""Compares levels of detail on the bare host and under the layer: each pixel must use the same ones.

  run_levels.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import collections
import re
import sys

import sides

# The fraction of pixels, for one target, one way of sampling and one projection, that may differ: triangles and quads
# whose level of detail is halfway between two levels within the last bits of their coordinates.
HALFWAY = 0.003
KIND = re.compile(r"seed \d+ (?P<kind>\w+ by (?:fixed function|\w+)(?: in perspective)?)")


def judge(bare, layer):
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records"]
    apart, pixels, seen = collections.Counter(), collections.Counter(), set()
    for (what, a), (_, b) in zip(bare, layer):
        if a:
            kind = KIND.match(what)["kind"]
            apart[kind] += sides.distances(a, b, 0)[0]
            pixels[kind] += len(a) // 4
            seen.update(a[0::4])
    wrong = [f"'{kind}': {count} of {pixels[kind]} pixels are of another level or face"
             for kind, count in apart.items() if count > HALFWAY * pixels[kind]]
    if len(seen) < 9:
        wrong.append(f"{len(seen)} levels alone are seen")
    return wrong


def main():
    args = sides.seeded_arguments(__doc__, 12)
    bare, wrong, part = sides.compare(args, "rasterizer-levels", judge)
    if not sides.all_ours(args, part):
        wrong.append("draws of the host's")
    return sides.conclude(args, "scenes", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
