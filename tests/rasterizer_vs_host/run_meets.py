#!/usr/bin/env python3
"""Tests passes that compare depths for equality. Passes that meet on the bare host must meet under the layer, however
they
transform their vertices, and whoever draws the frame. Passes that only meet under the layer are no fault, as hosts
differ in that.

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

# The host may draw a frame with its own order of operations in the transformation, and the rasterizer the next. The
# back end `host` must meet as the bare host does, to the pixel. Under the legacy numerics vertex programs are GLSL on
# the host, which clips them by planes in eye space, and fixed function in clip space.
WAYS = {"auto": ("auto", {"ARBITER_DEBUG": "steady"}),
        "auto, late code": ("auto", {"ARBITER_DEBUG": "late-code"}),
        "swrast": ("swrast", {}), "host": ("host", {}),
        "host, legacy numerics": ("host", {"ARBITER_NUMERICS": "legacy"})}
HOSTS = ("llvmpipe", "softpipe")
# With x87, softpipe's vertices are computed there. Where a sum of products is rounded depends on its operations, so
# that GLSL meets fixed function only by chance.
ALONE_BY_X87 = {"llvmpipe": set(), "softpipe": {"fixed", "invariant"}}
# The fraction of pixels that met which may be missing under the layer, as the two rasterizers may cover edges
# differently.
LOST = 0.01
# With so few pixels the fraction says nothing.
FEW = 12


def met(picture):
    """Returns the pixels of the second pass, which is white; the first one is blue."""
    return {i for i in range(0, len(picture), 4) if picture[i] > 127}


def covered(picture):
    return {i for i in range(0, len(picture), 4) if picture[i + 2] > 127}


def transforms(what):
    """Returns the names of the first and second pass's transformation."""
    return [way.split(" by ")[0] for way in re.sub(r"^seed \d+: (clipped, )?", "", what).split(", then ")]


def judge(bare, layer, exact, clips, alone):
    """Returns complaints. `exact`: passes that do not meet bare may not meet here either. `clips`: user clip planes
    cut all ways' transformations at the same places. `alone`: ways that meet no other."""
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
    """Returns complaints if the comparison cannot show anything: some passes must meet, and others not."""
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
