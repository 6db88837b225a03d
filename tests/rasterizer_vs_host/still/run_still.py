#!/usr/bin/env python3
"""Draws still pictures, each of one feature of the rasterizer, frame after frame under `auto`: none may change, from
the
first frame on, whoever draws.

  run_still.py --build build [--frames N] [SCENE...]

Each scene is a process of its own, without machine code on disk; then it starts again with the stored code.
Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import sides  # noqa: E402

# Scenes that the two sides round differently, and by how many steps of 255: one of a thousand lit vertices.
ROUNDED = {"lit-apart": 1, "materials": 1}
# A scene that changes once: only after its draw does the first frame turn out to be a mixed one.
ONCE = ("anisotropy-mixed",)
START = 100  # frames of runs after the first
# Two contexts also draw these in turns; the second one starts with the results about the first.
TWO = ("anisotropy", "anisotropy-by-program", "color-sum-late", "letters-in-fog", "stipple-in-perspective")


def changes(scene, found):
    """Returns lines about the pictures that differ from the first one."""
    pictures = [(what, picture) for what, picture in found if picture]
    lines = [f"'{what}'" for what, picture in found if not picture and what != "errors"]
    if scene in ONCE and len(pictures) > 1:
        pictures = pictures[1:]
    for what, picture in pictures[1:]:
        far, worst = sides.distances(pictures[0][1], picture, ROUNDED.get(scene, 0))
        if far:
            lines.append(f"'{what}': {far} pixels change, by up to {worst}")
    return lines


def judge(client, layer, scene, frames, display):
    """Returns what is wrong with a scene, as text."""
    wrong = []
    with tempfile.TemporaryDirectory(prefix="arbiter-still-") as scratch:
        environment = sides.environment(layer, "auto", {"DISPLAY": display, "XDG_CACHE_HOME": scratch})
        few = min(frames, START)
        for run, words in ("first start", [frames]), ("second start", [few]), ("by turns", [few, "two"]):
            if words[-1] != "two" or scene in TWO:
                found = sides.run([client, scene, *words], environment)
                wrong += [f"{run}: {line}" for line in changes(scene, found)]
    return "; ".join(wrong)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--frames", type=int, default=2000)
    parser.add_argument("scenes", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-still"
    names = args.scenes or subprocess.run([client, "list"], capture_output=True, check=True,
                                          text=True).stdout.split()
    layer = sides.layer_of(build)
    failed = 0
    with sides.Displays() as displays, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        answers = pool.map(
            lambda scene: judge(client, layer, scene, args.frames, displays.name()), names)
        for scene, wrong in zip(names, answers):
            print(f"{'FAIL' if wrong else 'pass'} {scene}: {wrong}", flush=True)
            failed += bool(wrong)
    print(f"{len(names) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
