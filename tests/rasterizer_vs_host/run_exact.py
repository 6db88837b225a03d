#!/usr/bin/env python3
"""Random draws through random fragment programs with nearest and linear filters, on the bare host and under the layer:
the same to the last bit, of bytes and of floats. Inputs often lie on the edges of texels and on ties of cube maps' axes, where
the last bit of an input is seen as another texel.

  run_exact.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import array
import sys

import sides


def differing(what, a, b):
    """A line of what two pictures differ in, or nothing. Numbers that are none are alike."""
    floats = what.startswith("floats")
    if a == b:
        return None
    if floats:
        one, other = array.array("f", a), array.array("f", b)
        apart = {i // 4 for i, (x, y) in enumerate(zip(one, other)) if x != y and not (x != x and y != y)}
        worst = max((abs(one[i] - other[i]) for i in range(len(one)) if i // 4 in apart), default=0)
    else:
        apart = {i // 4 for i, (x, y) in enumerate(zip(a, b)) if x != y}
        worst = max((abs(x - y) for x, y in zip(a, b)), default=0)
    return f"'{what}': {len(apart)} pixels differ, by up to {worst}" if apart or len(a) != len(b) else None


def judge(bare, layer):
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records"]
    return [line for line in (differing(what, a, b) for (what, a), (_, b) in zip(bare, layer)) if line]


def main():
    args = sides.seeded_arguments(__doc__, 40)
    bare, wrong, part = sides.compare(args, "rasterizer-exact", judge)
    if not sides.all_ours(args, part):
        wrong.append("draws of the host's")
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
