#!/usr/bin/env python3
"""Draws a detailed plane at steep angles with anisotropic filters of 2, 4, 8 and 16 to 1, and compares the
pictures of bare hosts and of the rasterizer with a reference of 256 samples a pixel, and with each other.

  run_anisotropy.py --build build

Differences are root mean squares over the picture, in 255ths. Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import math
import pathlib
import sys
import tempfile

import sides

# The two hosts of Mesa. llvmpipe draws the same for any limit above 1, softpipe and the layer depend on it.
HOSTS = ("llvmpipe", "softpipe")
MOST = (1, 2, 4, 8, 16)
# The difference of pictures that are equal except for the rounding of weights and levels.
SAME = 1.5
# If the limit causes the blur, softpipe and the rasterizer may be equally near.
NEARER = 1.05


def distance(a, b):
    """Returns the difference of red, green and blue; alpha is 255 everywhere."""
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / (len(a) * 3 // 4))


def judge(view, host, bare, layer, apart):
    """Returns complaints; the lists have an element for each of MOST."""
    wrong = []
    if host == "llvmpipe" and apart[0] > SAME:
        wrong.append("without anisotropy the two differ")
    wrong += [f"at {most} to 1 the host is nearer to the reference"
              for most, ours, other in list(zip(MOST, layer, bare))[1:] if ours > NEARER * other]
    if any(more > less + SAME for less, more in zip(layer, layer[1:])):
        wrong.append("more samples are worse")
    return [f"{host}, {view}: {line}" for line in wrong]


def pictures(build, driver, stats):
    """Returns the records of the bare host and of the layer, by name."""
    command = [build / "tests/rasterizer_vs_host/rasterizer-anisotropy"]
    with tempfile.TemporaryDirectory(prefix="arbiter-anisotropy-") as scratch, \
            sides.XServer() as display:
        both = {"DISPLAY": display, "XDG_CACHE_HOME": scratch, "GALLIUM_DRIVER": driver}
        layer = sides.environment(sides.layer_of(build), "swrast",
                                  {**both, "ARBITER_STATS": str(stats)})
        return [dict(sides.run(command, env)) for env in (sides.environment(extra=both), layer)]


def compare(build, host):
    """Returns (views, complaints); prints the figures."""
    with tempfile.TemporaryDirectory(prefix="arbiter-anisotropy-") as scratch:
        stats = pathlib.Path(scratch) / "stats.json"
        bare, layer = pictures(build, host, stats)
        part = sides.software_statistics(stats)
    views = [name.removesuffix(": reference") for name in bare if name.endswith(": reference")]
    wrong = []
    if part.get("drawn", 0) < len(views) * len(MOST) or part.get("given_to_host"):
        wrong.append(f"the rasterizer drew {part.get('drawn')}, the host {part.get('given_to_host')}")
    print(f"{host:37}" + "".join(f"{side:34}" for side in ("bare", "layer", "apart")).rstrip())
    for view in views:
        names = [f"{view}: {most}" for most in MOST]
        rows = [[distance(bare[f"{view}: reference"], side[name]) for name in names]
                for side in (bare, layer)]
        rows.append([distance(bare[name], layer[name]) for name in names])
        print(f"{view:33}" + "    ".join("".join(f"{d:6.2f}" for d in row) for row in rows), flush=True)
        wrong += judge(view, host, *rows)
    return len(views), wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    args = parser.parse_args()
    views, wrong = 0, []
    for host in HOSTS:
        some, lines = compare(args.build.resolve(), host)
        views, wrong = views + some, wrong + lines
    for line in wrong:
        print(f"     {line}")
    print(f"{views - len(wrong)} passed, {len(wrong)} failed, 0 skipped")
    return 1 if wrong or not views else 0


if __name__ == "__main__":
    sys.exit(main())
