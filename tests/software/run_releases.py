#!/usr/bin/env python3
"""A window whose context is released and made current again, on the bare host and under the layer: what it
shows and holds is equal, and where nothing else can have drawn to it, nothing is asked of the host again.

  run_releases.py --build build [NAME...]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides
from x_server import XServer

# How many images may be moved from the host and to it, of those scenes where that is the point. A scene's
# first frame takes up what the host cleared; a context that leaves gives the host a frame's two images.
MOST = {"cleared": (2, 48), "kept": (2, 48), "within-frames": (2, 96), "again": (2, 2),
        "shown-outside": (2, 48)}


def moved_too_much(name, statistics):
    if name not in MOST:
        return []
    return [f"{statistics.get(what, 0)} {what} of at most {most}"
            for what, most in zip(("downloads", "uploads"), MOST[name]) if statistics.get(what, 0) > most]


def judge(client, name, layer, scratch):
    """(lines of what is wrong, the rasterizer's statistics)."""
    stats = pathlib.Path(scratch) / "stats.json"
    stats.unlink(missing_ok=True)
    answers = []
    with XServer() as display:
        both = {"XDG_CACHE_HOME": scratch, "DISPLAY": display}
        for env in (sides.environment(extra=both),
                    sides.environment(layer, "swrast", {**both, "ARBITER_STATS": str(stats)})):
            try:
                answers.append(sides.run([client, name], env))
            except (sides.Died, subprocess.TimeoutExpired) as death:
                return [str(death)], {}
    if not any(any(pixels) for _, pixels in answers[0]):
        return ["the bare host shows nothing"], {}
    statistics = sides.software_statistics(stats)
    wrong = sides.differences(*answers) + moved_too_much(name, statistics)
    return wrong + ([] if statistics.get("drawn") else ["the rasterizer drew nothing"]), statistics


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/software/software-releases"
    layer = sides.layer_of(build)
    listing = subprocess.run([client, "--list"], capture_output=True, text=True, check=True).stdout
    passed = failed = 0
    with tempfile.TemporaryDirectory(prefix="arbiter-releases-") as scratch:
        for name in listing.split():
            if args.names and name not in args.names:
                continue
            wrong, statistics = judge(client, name, layer, scratch)
            passed, failed = passed + (not wrong), failed + bool(wrong)
            counts = [f"{statistics.get(what, 0)} {what}" for what in ("drawn", "downloads", "uploads")]
            print(f"{'FAIL' if wrong else 'pass'} {name}: {', '.join(counts)}", flush=True)
            for line in wrong[:8]:
                print(f"     {line}")
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
