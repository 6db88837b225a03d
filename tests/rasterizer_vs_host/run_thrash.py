#!/usr/bin/env python3
"""Tests an application that moves images between the rasterizer and the host in every frame: under `auto` the layer
measures which of them should draw it and keeps to that, and the pictures stay the bare host's.

  run_thrash.py --build build [--frames N]

Prints the frame times of both, which depend on the machine and are not judged.
"""

import argparse
import pathlib
import statistics
import sys
import tempfile

import sides

# The host draws only the trial frames (7 and the first), or all but those.
TRIAL_FRAMES = 16


def judge(kind, part, frames):
    """Returns what is wrong with the statistics, as text; empty: nothing."""
    back_off = part.get("back_off", {})
    on_host = back_off.get("frames_on_host", 0)
    if not part.get("drawn"):
        return "the rasterizer drew nothing"
    if not back_off.get("trials"):
        return "there was no trial"
    if kind == "cheap" and on_host < frames // 2:
        return f"only {on_host} of {frames} frames are the host's"
    if kind == "dear" and on_host > TRIAL_FRAMES:
        return f"{on_host} frames are the host's"
    return ""


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--frames", type=int, default=120)
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-thrash"
    failed = 0
    with tempfile.TemporaryDirectory(prefix="arbiter-thrash-") as scratch, \
            sides.Displays() as displays:
        for kind in ("cheap", "dear"):
            stats = pathlib.Path(scratch) / f"{kind}.json"
            show = {"DISPLAY": displays.name()}
            layer = {**show, "XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats)}
            found = []
            for env in (sides.environment(extra=show),
                        sides.environment(sides.layer_of(build), "auto", layer)):
                (what, picture), (_, times) = sides.run([client, kind, args.frames], env)
                late = [int(time) for time in times.split()][args.frames * 2 // 3:]
                found.append((what, picture, statistics.median(late) / 1000))
            (bare_what, bare_picture, bare), (what, picture, layered) = found
            part = sides.software_statistics(stats)
            wrong = judge(kind, part, args.frames)
            far, worst = sides.distances(bare_picture, picture)
            if far or bare_what != what:
                wrong = f"'{what}' for '{bare_what}', {far} pixels differ, by up to {worst}"
            print(f"{'FAIL' if wrong else 'pass'} {kind}: {bare:.2f} ms a frame bare, {layered:.2f} "
                  f"layered; {part.get('back_off')}; drew {part.get('drawn')}; {wrong}")
            failed += bool(wrong)
    print(f"{2 - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
