#!/usr/bin/env python3
"""Compares the depths of slanting surfaces and lines on the bare host and under the layer. They must be equal to the
last
bit, so that the same one of two coplanar surfaces is visible, whichever side draws them.

  run_depth_planes.py --build build [--first SEED] [--count N] [--backend auto]

Debian's 32-bit x86 Mesa clips at the view and sets up lines in C with x87's precision, 64-bit Mesa with single
precision. There (CUT_BY_X87=1) the host is the reference for other surfaces only. Of the rest, surfaces that no matrix
of the host has moved must equal a 64-bit rasterizer's, whose depths are the host's: DIGEST.

Ends with "N passed, N failed, 0 skipped".
"""

import array
import functools
import hashlib
import re
import sys

import sides

UNITS = 1 << 8  # the last of 24 bits, in GL_UNSIGNED_INT
CLEARED = (1 << 32) - 1
# The digest of the rasterizer's untransformed depths for these seeds, on processors with fused multiply-add. It
# excludes smooth lines, whose corners depend on sines, which the C libraries of both word sizes may round differently.
DIGEST_SEEDS = range(1, 13)
DIGEST = "40c07d4bd5a1d357983945f4f972348b1499a4e5bc67619c8a22e82d5827f8fd"


def uncut(what):
    """True if a record has only surfaces and nothing of it leaves the view; in perspective it may be behind the eye."""
    return " cut " not in what and "perspective" not in what and " line" not in what


def digest(records):
    whole = hashlib.sha256()
    for what, depths in records:
        seed = re.search(r" seed (\d+) ", what)
        if "untransformed" in what and "smooth" not in what and int(seed.group(1)) in DIGEST_SEEDS:
            whole.update(what.encode() + depths)
    return whole.hexdigest()


def multiplies_and_adds_in_one():
    try:
        with open("/proc/cpuinfo", encoding="ascii", errors="replace") as file:
            return " fma " in file.read()
    except OSError:
        return False


def differing(what, a, b):
    """Returns a line of what is wrong with a record's depths, or nothing."""
    bare, layer = array.array("I", a), array.array("I", b)
    covered = [(x, y) for x, y in zip(bare, layer) if CLEARED not in (x, y)]
    edges = sum((x == CLEARED) != (y == CLEARED) for x, y in zip(bare, layer))
    apart = [abs(x - y) for x, y in covered if x != y]
    if not apart and not edges:
        return None
    return f"'{what}': {len(apart)} depths of {len(covered)} differ, by up to {max(apart, default=0) / UNITS:.0f} " \
           f"units; {edges} pixels are covered by one of the two"


def judge(bare, layer, cut_by_x87=False, seeds=()):
    """Returns complaints. `seeds`: those drawn, if a rasterizer whose bits are known drew them."""
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records"]
    lines = (differing(what, a, b) for (what, a), (_, b) in zip(bare, layer) if uncut(what) or not cut_by_x87)
    wrong = [line for line in lines if line]
    if set(DIGEST_SEEDS) <= set(seeds) and digest(layer) != DIGEST:
        wrong.append(f"untransformed depths are not those of 64 bits: {digest(layer)}")
    return wrong


def main():
    args = sides.seeded_arguments(__doc__, 12)
    known = args.backend == "swrast" and multiplies_and_adds_in_one()
    bare, wrong, part = sides.compare(args, "rasterizer-depth-planes", functools.partial(
        judge, cut_by_x87=sides.HOST_HAS_X87,
        seeds=range(args.first, args.first + args.count) if known else ()))
    if args.backend == "swrast" and (not part.get("drawn", 0) or part.get("given_to_host", {})):
        wrong.append("draws of the host's")
    return sides.conclude(args, "primitives", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
