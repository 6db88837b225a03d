#!/usr/bin/env python3
"""Passes that compare depths for equality: where two meet on the bare host they meet under the layer,
whichever way they transform their vertices, and whichever draws the frame. What meets under the layer and not
on the bare host is no fault: hosts differ in it.

  run_meets.py --build build [--first SEED] [--count N]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import sides
from x_server import XServer

# The host may draw a frame by the order of its own transformation, and the next be the rasterizer's; the
# back end `host` must meet as the bare host does, to the pixel. Under the legacy numerics vertex programs are
# GLSL on the host, which it clips by planes in eye space, and fixed function in clip space.
WAYS = {"auto": ("auto", {"ARBITER_DEBUG": "steady"}),
        "auto, late code": ("auto", {"ARBITER_DEBUG": "late-code"}),
        "swrast": ("swrast", {}), "host": ("host", {}),
        "host, legacy numerics": ("host", {"ARBITER_NUMERICS": "legacy"})}
HOSTS = ("llvmpipe", "softpipe")
# Where the host has x87 softpipe has its vertices from there: where a sum of products is rounded depends on the
# operations that it is made of, so that GLSL meets fixed function by luck.
ALONE_BY_X87 = {"llvmpipe": set(), "softpipe": {"fixed", "invariant"}}
# Of the pixels that met, what may be missing under the layer: at edges the two rasterizers may cover others.
LOST = 0.01
# So few pixels say nothing by their rate.
FEW = 12


def met(picture):
    """The pixels of the second pass: it is white, the first one blue."""
    return {i for i in range(0, len(picture), 4) if picture[i] > 127}


def covered(picture):
    return {i for i in range(0, len(picture), 4) if picture[i + 2] > 127}


def transforms(what):
    """The names of the first pass's way and of the second's."""
    return [way.split(" by ")[0] for way in re.sub(r"^seed \d+: (clipped, )?", "", what).split(", then ")]


def judge(bare, layer, exact, clips, alone):
    """Lines of what is wrong. `exact`: what does not meet bare may not meet here either. `clips`: user clip
    planes cut what every way transforms at the same places. `alone`: ways that meet no other."""
    if [what for what, _ in bare] != [what for what, _ in layer]:
        return ["other records"]
    wrong = []
    for (what, a), (_, b) in zip(bare, layer):
        if "clipped" in what and not clips:
            continue
        first, second = transforms(what)
        if first != second and {first, second} & alone:
            continue
        if exact:
            far, worst = sides.distances(a, b)
            if far:
                wrong.append(f"'{what}': {far} pixels differ, by up to {worst}")
            continue
        wanted = met(a)
        lost = len((wanted & covered(b)) - met(b))
        if lost > max(FEW, LOST * len(wanted)):
            wrong.append(f"'{what}': {lost} of {len(wanted)} pixels are lost")
    return wrong


def sanity(bare):
    """Lines; empty where the comparison can tell anything: passes meet, and others do not."""
    counts = [(what, len(met(picture))) for what, picture in bare]
    if sum(count > 100 for _, count in counts) < len(counts) // 2:
        return ["too few passes meet on the bare host"]
    return [f"'{what}': {what[what.rindex('GL'):]}" for what, _ in counts if "GL_" in what]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=12)
    args = parser.parse_args()
    build = args.build.resolve()
    command = [build / "tests/rasterizer_vs_host/rasterizer-meets", args.first, args.count]
    tally = sides.Tally()
    for host in HOSTS:
        with XServer() as display, tempfile.TemporaryDirectory(prefix="arbiter-meets-") as scratch:
            both = {"DISPLAY": display, "XDG_CACHE_HOME": scratch, "GALLIUM_DRIVER": host}
            bare = sides.run(command, sides.environment(extra=both))
            tally.row(f"{host}: {len(bare)} pairs of passes on the bare host", sanity(bare))
            for way, (backend, extra) in WAYS.items():
                stats = pathlib.Path(scratch) / "stats.json"
                stats.unlink(missing_ok=True)
                env = sides.environment(sides.layer_of(build), backend,
                                        {**both, "ARBITER_STATS": str(stats), **extra})
                try:
                    layer = sides.run(command, env)
                except (sides.Died, subprocess.TimeoutExpired) as death:
                    wrong = [str(death)]
                else:
                    legacy = "legacy" in way
                    wrong = judge(bare, layer, exact=way == "host", clips=not legacy,
                                  alone=ALONE_BY_X87[host] if sides.HOST_HAS_X87 and legacy else set())
                if backend != "host" and not sides.software_statistics(stats).get("drawn"):
                    wrong.append("the rasterizer drew nothing")
                tally.row(f"{host}, {way}: {args.count} scenes from seed {args.first}", wrong, 12)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
