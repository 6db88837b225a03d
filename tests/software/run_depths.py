#!/usr/bin/env python3
"""Depth buffers without stencil, which software hosts give 32 bits: random frames on the bare host and
under the layer, in windows and framebuffer objects. All draws must be the rasterizer's.

  run_depths.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import array
import pathlib
import subprocess
import sys
import tempfile

import sides
from x_server import XServer

# Depths of the two rasterizers differ by the rounding of a plane's steps: of 2^32.
NEAR = 1 << 11
# Pixels of a picture that may be another triangle's: where depths are equal but for that.
MOST = 0.004


def distances(what, a, b):
    """(pixels that differ, by how much at most)."""
    if what.endswith(" depth"):
        apart = [abs(x - y) for x, y in zip(array.array("I", a), array.array("I", b))]
        return sum(d > NEAR for d in apart), max(apart, default=0)
    return sides.distances(a, b)


def judge(bare, layer):
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records: " + next((f"bare '{x}', layer '{y}'" for (x, _), (y, _) in
                                          zip(bare, layer) if x != y), "another count")]
    lines = []
    for (what, a), (_, b) in zip(bare, layer):
        far, worst = distances(what, a, b)
        if far > MOST * len(a) / 4:
            lines.append(f"'{what}': {far} pixels differ, by up to {worst}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    args = parser.parse_args()
    build = args.build.resolve()
    command = [build / "tests/software/software-depths", args.first, args.count]
    with tempfile.TemporaryDirectory(prefix="arbiter-depths-") as scratch, XServer() as display:
        extra = {"DISPLAY": display, "XDG_CACHE_HOME": scratch}
        stats = pathlib.Path(scratch) / "stats.json"
        layer = sides.environment(sides.layer_of(build), args.backend,
                                  {**extra, "ARBITER_STATS": str(stats)})
        try:
            bare = sides.run(command, sides.environment(extra=extra))
            wrong = judge(bare, sides.run(command, layer))
        except (sides.Died, subprocess.TimeoutExpired) as death:
            bare, wrong = [], [str(death)]
        part = sides.software_statistics(stats)
    drawn, given = part.get("drawn", 0), part.get("given_to_host", {})
    if not any("has 32," in what for what, _ in bare):
        print("the host gives no window 32 bits")
    if args.backend == "swrast" and (not drawn or given):
        wrong.append("draws of the host's")
    print(f"{args.count} frames from seed {args.first}, {len(bare)} records; the rasterizer drew "
          f"{drawn}, the host {given}")
    for line in wrong[:12]:
        print(f"     {line}")
    print(f"{int(not wrong)} passed, {int(bool(wrong))} failed, 0 skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
