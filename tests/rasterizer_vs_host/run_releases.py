#!/usr/bin/env python3
"""Tests a window whose context is released and made current again, on the bare host and under the layer. Its visible
content and its buffers must be equal. If no one else can have drawn to it, nothing may be read from the host again.

  run_releases.py --build build [NAME...]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides

# The allowed number of images moved from the host and to it, in the scenes that test it. A scene's first frame takes up
# what the host cleared; a context that is released gives the host a frame's two images.
MOST = {"cleared": (2, 48), "kept": (2, 48), "within-frames": (2, 96), "again": (2, 2),
        "shown-outside": (2, 48)}


def moved_too_much(name, statistics):
    if name not in MOST:
        return []
    return [f"{statistics.get(what, 0)} {what} of at most {most}"
            for what, most in zip(("downloads", "uploads"), MOST[name]) if statistics.get(what, 0) > most]


def judge(client, name, layer, scratch):
    """Returns (complaints, the rasterizer's statistics)."""
    try:
        bare, layered, statistics = sides.bare_and_layer([client, name], layer, scratch)
    except (sides.Died, subprocess.TimeoutExpired) as death:
        return [str(death)], {}
    if not any(any(pixels) for _, pixels in bare):
        return ["the bare host shows nothing"], {}
    wrong = sides.differences(bare, layered) + moved_too_much(name, statistics)
    return wrong + ([] if statistics.get("drawn") else ["the rasterizer drew nothing"]), statistics


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-releases"
    layer = sides.layer_of(build)
    listing = subprocess.run([client, "--list"], capture_output=True, text=True, check=True).stdout
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-releases-") as scratch:
        for name in listing.split():
            if args.names and name not in args.names:
                continue
            wrong, statistics = judge(client, name, layer, scratch)
            counts = [f"{statistics.get(what, 0)} {what}" for what in ("drawn", "downloads", "uploads")]
            tally.row(f"{name}: {', '.join(counts)}", wrong)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
