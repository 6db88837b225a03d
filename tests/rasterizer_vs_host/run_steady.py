#!/usr/bin/env python3
"""Frames whose depths must meet, with a draw in the middle that the rasterizer lacks: under `auto` they
settle on one rasterizer, and are not drawn by the two in turns; the pictures stay the bare host's.

  run_steady.py --build build [--frames N]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides

DRAWS = 12  # a frame
FIRST = 8  # frames until machine code is there
# How many draws of all frames may be the rasterizer's: (least, most).
BOUNDS = {
    "whole": lambda frames: ((frames - FIRST) * DRAWS, frames * DRAWS),
    "formats": lambda frames: (0, FIRST * DRAWS),
    "indices": lambda frames: (0, FIRST * DRAWS),
}


def judge(kind, part, frames):
    """What is wrong with the statistics, as text; nothing if they are as they should be."""
    least, most = BOUNDS[kind](frames)
    drawn = part.get("drawn", 0)
    return "" if least <= drawn <= most else f"not {least} to {most}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--frames", type=int, default=200)
    args = parser.parse_args()
    build = args.build.resolve()
    failed = 0
    with sides.Displays() as displays:
        for kind in BOUNDS:
            command = [build / "tests/rasterizer_vs_host/rasterizer-steady", kind, args.frames]
            show = {"DISPLAY": displays.name()}
            with tempfile.TemporaryDirectory(prefix="arbiter-steady-") as scratch:
                stats = pathlib.Path(scratch) / "stats.json"
                layer = {**show, "XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats)}
                bare = sides.run(command, sides.environment(extra=show))
                layered = sides.run(command, sides.environment(sides.layer_of(build), "auto", layer))
                part = sides.software_statistics(stats)
            wrong = "; ".join(sides.differences(bare, layered)) or judge(kind, part, args.frames)
            print(f"{'FAIL' if wrong else 'pass'} {kind}: the rasterizer drew {part.get('drawn')} of "
                  f"{args.frames * DRAWS}, the host {part.get('given_to_host')}; {wrong}")
            failed += bool(wrong)
    print(f"{len(BOUNDS) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
