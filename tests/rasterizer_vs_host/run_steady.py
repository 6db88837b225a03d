#!/usr/bin/env python3
"""Tests frames whose depths must meet, with a draw in the middle that the rasterizer lacks: under `auto` they settle on
one
rasterizer instead of alternating, and the pictures stay the bare host's. If the rasterizer drew a program's frames
completely, it draws from the start at the next run.

  run_steady.py --build build [--frames N]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides

DRAWS = 12  # in a frame
FIRST = 8  # frames until machine code is there
STARTS = 4  # more starts: on a busy machine one may not wait long enough for the machine code on disk
# How many draws of all frames the rasterizer may make: (least, most).
BOUNDS = {
    "whole": lambda frames: ((frames - FIRST) * DRAWS, frames * DRAWS),
    "formats": lambda frames: (0, FIRST * DRAWS),
    "indices": lambda frames: (0, FIRST * DRAWS),
}


def judge(kind, part, frames):
    """Returns what is wrong with the statistics, as text; empty: nothing."""
    least, most = BOUNDS[kind](frames)
    drawn = part.get("drawn", 0)
    return "" if least <= drawn <= most else f"not {least} to {most}"


def starts_again(command, environment, stats, bare, draws):
    """Returns what is wrong with the starts after the first one, as text."""
    drawn = []
    for _ in range(STARTS):
        wrong = "; ".join(sides.differences(bare, sides.run(command, environment)))
        drawn.append(sides.software_statistics(stats).get("drawn", 0))
        if wrong or drawn[-1] == draws:
            return wrong
    return f"starts after it drew {drawn} of {draws}"


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
                environment = sides.environment(sides.layer_of(build), "auto", layer)
                layered = sides.run(command, environment)
                part = sides.software_statistics(stats)
                wrong = "; ".join(sides.differences(bare, layered)) or judge(kind, part, args.frames)
                if kind == "whole" and not wrong:
                    wrong = starts_again(command, environment, stats, bare, args.frames * DRAWS)
            print(f"{'FAIL' if wrong else 'pass'} {kind}: the rasterizer drew {part.get('drawn')} of "
                  f"{args.frames * DRAWS}, the host {part.get('given_to_host')}; {wrong}")
            failed += bool(wrong)
    print(f"{len(BOUNDS) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
