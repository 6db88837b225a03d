#!/usr/bin/env python3
"""Compares frames shown in windows on the bare host and under the layer, each scene with an X server of its own: the
server must show the same after each swap. With an MIT-SHM server the layer must have shown frames itself; without the
extension the host shows them all.

  run_presenter.py --build build [NAME...]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides


def judge(client, name, server_options, layer, scratch):
    """Returns (complaints, draws of the rasterizer)."""
    try:
        bare, layered, statistics = sides.bare_and_layer([client, name], layer, scratch, server_options)
    except (sides.Died, subprocess.TimeoutExpired) as death:
        return [str(death)], 0
    if not any(pixels for _, pixels in bare):
        return ["the bare host shows nothing"], 0
    drawn = statistics.get("drawn", 0)
    return sides.differences(bare, layered) + ([] if drawn else ["the rasterizer drew nothing"]), drawn


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-presenter"
    layer = sides.layer_of(build)
    listing = subprocess.run([client, "--list"], capture_output=True, text=True, check=True).stdout
    known = listing.split()
    scenes = [(name, ()) for name in known] + \
        [(name, ("-extension", "MIT-SHM")) for name in ("frames", "resized", "two-windows")]
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-presenter-") as scratch:
        for name, options in scenes:
            if args.names and name not in args.names:
                continue
            wrong, drawn = judge(client, name, options, layer, scratch)
            tally.row(f"{name}{', no MIT-SHM' if options else ''}: {drawn} draws of the rasterizer", wrong)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
