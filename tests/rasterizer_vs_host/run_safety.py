#!/usr/bin/env python3
"""Runs scenes that no careful program draws, each in a process of its own, on the bare host and under the layer:
nothing
may crash, and errors and defined pictures must be equal.

  run_safety.py --build build [NAME...]

Ends with "N passed, N failed, N skipped".
"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

import sides


# Scenes of an extension that the bare host lacks and that the layer must offer.
OF_CARD = {"sampled-by-vertices": {"ARBITER_PROFILE": "nv40", "SAFETY_NEEDS": "GL_NV_vertex_program3"}}


def draw(client, name, env):
    try:
        return sides.run([client, name], env)
    except (sides.Died, subprocess.TimeoutExpired) as death:
        return str(death)


def judge(bare, layer):
    """Returns (result, lines): pass, host (the bare host crashes too) or FAIL."""
    if isinstance(layer, str):
        return ("host" if isinstance(bare, str) else "FAIL"), [f"layer: {layer}"]
    if isinstance(bare, str):
        return "host", [f"the bare host: {bare}"]
    lines = sides.differences(bare, layer)
    return ("FAIL" if lines else "pass"), lines[:8]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    parser.add_argument("--drawn", action="store_true", help="fail if the rasterizer drew nothing")
    parser.add_argument("--guard", choices=("begin", "end"),
                        help="the layer's blocks begin, or end, at a page that nobody may touch")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-safety"
    listing = subprocess.run([client, "--list"], capture_output=True, text=True, check=True).stdout
    names = args.names or listing.split()
    counts = {"pass": 0, "host": 0, "FAIL": 0}
    with tempfile.TemporaryDirectory(prefix="arbiter-safety-") as scratch, \
            sides.Displays() as displays, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        stats = pathlib.Path(scratch) / "stats-%p.json"
        bare_env = sides.environment()
        layer_env = sides.environment(sides.layer_of(build), args.backend,
                                      {"XDG_CACHE_HOME": scratch, "ARBITER_STATS": str(stats)})
        if args.guard:
            layer_env = sides.guarded(build, layer_env, args.guard)

        def both(name):
            more = OF_CARD.get(name, {})
            return [draw(client, name, {**env, "DISPLAY": displays.name()})
                    for env in (bare_env, {**layer_env, **more})]

        for name, (bare, layer) in zip(names, pool.map(both, names)):
            result, lines = judge(bare, layer)
            counts[result] += 1
            print(f"{result} {name}")
            for text in lines:
                print(f"     {text}", flush=True)
        drawn, given = sides.software_totals(scratch)
    print(f"the rasterizer drew {drawn}, and the host {given or 'nothing'}; "
          f"the bare host itself dies of {counts['host']}")
    counts["FAIL"] += args.drawn and not drawn
    print(f"{counts['pass'] + counts['host']} passed, {counts['FAIL']} failed, 0 skipped")
    return 1 if counts["FAIL"] else 0


if __name__ == "__main__":
    sys.exit(main())
