#!/usr/bin/env python3
"""Compares bitmaps under random state on the bare host and under the layer: pictures, depths, raster positions and
errors
must be equal. Hosts do not all implement the specification's texture coordinates, fog and second color of bitmaps,
DrawPixels and CopyPixels; these are compared with colors computed here. Bitmaps that a host keeps for later must not
crash a program, with any back end.

  run_bitmaps.py --build build [--first SEED] [--count N] [--backend auto]

The scenes are drawn by one context each, then by two of a share group in turns.

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import subprocess
import sys
import tempfile

import sides
from x_server import XServer

# The rasterizer must make at least this fraction of the scenes' draws.
MOST_DRAWN = 0.8
# The RGBA that OpenGL 2.1 (2.13, 3.7, 3.9, 3.10) defines for the values of rasterizer-bitmaps.
RULES = {
    "rule texture coordinates": (64, 191, 128, 255),
    "rule texture coordinates of another unit": (128, 32, 255, 255),
    "rule secondary colour": (96, 191, 207, 255),
    "rule colour sum": (96, 191, 207, 255),
    "rule fog": (112, 96, 143, 255),  # (4 - 1) / 4 of the color
    "rule fog of a depth": (112, 96, 143, 255),
    "rule fog of a program": (112, 96, 143, 255),
    "rule a texture": (0, 0, 255, 255),
}


# Texts by glXUseXFont, and whether the host writes anything.
FONTS = {"font before": True, "font in names of GenLists": True, "font in other names": True,
         "font in another context": True, "font of another context": True,
         "font and a list of the application's": True, "font deleted": False}


def judge_rules(client, env):
    found = dict(sides.run([client, "rules"], env))
    return [f"{name}: {tuple(found.get(name, b''))}, not {colour}"
            for rule, colour in RULES.items() for name in (rule, rule + " of DrawPixels", rule + " of CopyPixels")
            if sides.distances(found.get(name, b""), bytes(colour))[0]]


def judge_frames(client, layer, extra):
    """Checks that a bitmap and an image have their fog in every frame, whoever draws the rest of it."""
    wanted = bytes(RULES["rule fog"] * 2)
    return [f"{what}: {tuple(found)}" for what, found in
            sides.run([client, "frames"], sides.environment(layer, "auto", extra))
            if sides.distances(found, wanted)[0]]


# Bitmaps that sample, followed by a change and a draw (the client's `letters`): the numbers of each.
CHANGES, DRAWS = range(3), range(6)
TRIANGLE = (255, 255, 0, 255)


def judge_letters(client, layer, extra):
    wrong = []
    for backend in ("auto", "host", "swrast"):
        env = sides.environment(layer, backend, extra)
        for change in CHANGES:
            for draw in DRAWS:
                what = f"letters {change} {draw}, {backend}"
                try:
                    found = dict(sides.run([client, "letters", change, draw], env))
                except sides.Died as death:
                    wrong.append(f"{what}: {str(death)[:60]}")
                    continue
                if found.get("letters", b"")[:3] != bytes((0, 255, 0)):
                    wrong.append(f"{what}: {tuple(found.get('letters', b''))}")
                if found.get("triangle") != bytes(TRIANGLE):
                    wrong.append(f"{what}: triangle {tuple(found.get('triangle', b''))}")
    return wrong


def judge_fonts(bare, layer):
    if any(what == "fonts: none" for what, _ in bare):
        return ["the X server has no font 'fixed', which is one of those that are built into it"]
    seen = {what: any(picture[0::4]) for what, picture in bare if picture}
    return sides.differences(bare, layer) + [
        f"'{what}': {'nothing is' if not seen.get(what) else 'something is'} written"
        for what, is_seen in FONTS.items() if seen.get(what) != is_seen]


def main():
    args = sides.seeded_arguments(__doc__, 60)
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-bitmaps"
    command = [client, args.first, args.count]
    shared = [client, "shared", args.first, args.count]
    results = {}
    with tempfile.TemporaryDirectory(prefix="arbiter-bitmaps-") as scratch, XServer() as display:
        extra = {"DISPLAY": display, "XDG_CACHE_HOME": scratch}
        stats = pathlib.Path(scratch) / "stats.json"
        layer = sides.environment(sides.layer_of(build), args.backend,
                                  {**extra, "ARBITER_STATS": str(stats)})
        try:
            bare = sides.run(command, sides.environment(extra=extra))
            results["scenes"] = sides.differences(bare, sides.run(command, layer))
            part = sides.software_statistics(stats)
            results["shared scenes"] = sides.differences(
                sides.run(shared, sides.environment(extra=extra)), sides.run(shared, layer))
            fonts = [client, "fonts"]
            results["fonts"] = judge_fonts(sides.run(fonts, sides.environment(extra=extra)), sides.run(fonts, layer))
            results["letters"] = judge_letters(client, sides.layer_of(build), extra)
            results["frames"] = judge_frames(client, sides.layer_of(build), extra)
            if args.backend != "host":
                results["rules"] = judge_rules(client, layer)
        except (sides.Died, subprocess.TimeoutExpired) as death:
            results["clients"], part = [str(death)], {}
    drawn, given = part.get("drawn", 0), sum(part.get("given_to_host", {}).values())
    print(f"the rasterizer drew {drawn}, the host {part.get('given_to_host', {})}")
    if args.backend == "swrast":
        results["draws"] = [] if drawn and drawn >= MOST_DRAWN * (drawn + given) else \
            ["too few are the rasterizer's"]
    tally = sides.Tally()
    for name, lines in results.items():
        tally.row(name, lines, most=12)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
