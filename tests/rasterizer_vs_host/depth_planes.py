"""Judges the depths of slanting surfaces and lines. They must be equal to the last bit, so that the same one of two
coplanar surfaces is visible, whichever side draws them.

Debian's 32-bit x86 Mesa clips at the view and sets up lines in C with x87's precision, 64-bit Mesa with single
precision. There (CUT_BY_X87=1) the host is the reference for other surfaces only. Of the rest, surfaces that no matrix
of the host has moved must equal a 64-bit rasterizer's, whose depths are the host's: DIGEST.
"""

import array
import hashlib
import re

import checks
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
    if sides.HOST_HAS_X87 and not uncut(what):
        return None
    bare, layer = array.array("I", a), array.array("I", b)
    covered = [(x, y) for x, y in zip(bare, layer) if CLEARED not in (x, y)]
    edges = sum((x == CLEARED) != (y == CLEARED) for x, y in zip(bare, layer))
    apart = [abs(x - y) for x, y in covered if x != y]
    if not apart and not edges:
        return None
    return f"'{what}': {len(apart)} depths of {len(covered)} differ, by up to {max(apart, default=0) / UNITS:.0f} " \
           f"units; {edges} pixels are covered by one of the two"


def as_64_bits(run):
    """Compares untransformed depths with the digest, if a rasterizer whose bits are known drew its seeds."""
    seeds = range(run.case.args.first, run.case.args.first + run.count)
    known = run.backend == "swrast" and multiplies_and_adds_in_one() and set(DIGEST_SEEDS) <= set(seeds)
    if not known or digest(run.layer) == DIGEST:
        return []
    return [f"untransformed depths are not those of 64 bits: {digest(run.layer)}"]


alike = checks.each(differing)
