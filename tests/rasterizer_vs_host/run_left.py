#!/usr/bin/env python3
"""A window of several samples a pixel, in which every draw is the host's: the context is left alone, and its
pictures are the bare host's before and after. Where it begins to draw to a texture that is the rasterizer's again.

  run_left.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides
from x_server import XServer

FRAMES = 1080
# Draws of a frame that are refused for their target, with a list's; such frames until the context is left alone,
# and those in which it is looked at again and draws to a texture, too.
DRAWS, REFUSED_FRAMES = 4, 8 + 80


def judge(bare, layer, part):
    wrong = sides.differences(bare, layer)
    refused = part.get("given_to_host", {}).get("target", 0)
    if not 0 < refused <= DRAWS * REFUSED_FRAMES:
        wrong.append(f"{refused} draws are refused for their target")
    return wrong


def judge_again(bare, layer, part):
    """The same of a start that finds its machine code: the frames that draw to the texture are over before a busy
    machine has made it."""
    wrong = judge(bare, layer, part)
    if part.get("drawn", 0) < DRAWS:
        wrong.append(f"the rasterizer drew {part.get('drawn', 0)} to the texture: {part.get('given_to_host')}")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    build = parser.parse_args().build.resolve()
    command = [build / "tests/rasterizer_vs_host/rasterizer-left", FRAMES]
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-left-") as scratch, XServer() as display:
        stats = pathlib.Path(scratch) / "stats.json"
        extra = {"DISPLAY": display, "XDG_CACHE_HOME": scratch}
        try:
            bare = sides.run(command, sides.environment(extra=extra))
            ways = ("auto", judge), ("swrast", lambda *records: sides.differences(*records[:2])), ("auto", judge_again)
            for backend, answer in ways:
                layer = sides.run(command, sides.environment(sides.layer_of(build), backend,
                                                             {**extra, "ARBITER_STATS": str(stats)}))
                tally.row(f"a window of four samples, {backend}",
                          answer(bare, layer, sides.software_statistics(stats)))
        except sides.Died as death:
            tally.row("a window of four samples", [str(death)])
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
