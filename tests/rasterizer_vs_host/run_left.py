#!/usr/bin/env python3
"""Tests windows in which the host makes every draw, because of several samples a pixel or of draws that only the host
supports. The layer stops inspecting the context, and its pictures are the bare host's before and after. Later draws
that the rasterizer supports, to a texture or in whole frames, are the rasterizer's again.

  run_left.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides
from x_server import XServer

FRAMES = 1300  # the last 300 contain draws for the rasterizer
DRAWS = 4  # in each frame
# A context that the layer left has few refused draws, except in the last frames to the window with four samples; any
# other context has all. A busy machine returns to it more often, as frame times vary, and leaves it later, as frames
# count for nothing while machine code is made. Half of all draws separates the two.
MOST = DRAWS * FRAMES // 2


def judge(bare, layer, part):
    wrong = sides.differences(bare, layer)
    refused = part.get("given_to_host", {}).get("target", 0)
    if not 0 < refused <= MOST:
        wrong.append(f"{refused} draws are refused for their target")
    return wrong


def judge_mixed(bare, layer, part):
    wrong = sides.differences(bare, layer)
    refused = part.get("given_to_host", {}).get("mixed-frame", 0)
    if refused > MOST:
        wrong.append(f"{refused} draws are the host's for the frame's sake")
    return wrong


def again(judged):
    """Judges a start that finds its machine code: the rasterizer's frames may be over before a busy machine has
    loaded it."""

    def judge_again(bare, layer, part):
        wrong = judged(bare, layer, part)
        if part.get("drawn", 0) < DRAWS:
            wrong.append(f"the rasterizer drew {part.get('drawn', 0)}: {part.get('given_to_host')}")
        return wrong

    return judge_again


def alike(bare, layer, _):
    return sides.differences(bare, layer)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    build = parser.parse_args().build.resolve()
    # Without machine code frames count for nothing, so that more frames of the first start are mixed.
    windows = (("a window of four samples", "samples", judge, judge),
               ("a window of mixed frames", "mixed", alike, judge_mixed))
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-left-") as scratch, XServer() as display:
        stats = pathlib.Path(scratch) / "stats.json"
        extra = {"DISPLAY": display, "XDG_CACHE_HOME": scratch}
        for words, kind, first, judged in windows:
            command = [build / "tests/rasterizer_vs_host/rasterizer-left", FRAMES, kind]
            try:
                bare = sides.run(command, sides.environment(extra=extra))
                for backend, answer in ("auto", first), ("swrast", alike), ("auto", again(judged)):
                    layer = sides.run(command, sides.environment(sides.layer_of(build), backend,
                                                                 {**extra, "ARBITER_STATS": str(stats)}))
                    tally.row(f"{words}, {backend}", answer(bare, layer, sides.software_statistics(stats)))
            except sides.Died as death:
                tally.row(words, [str(death)])
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
