#!/usr/bin/env python3
"""Changes state between two draws, one piece at a time, on the bare host and under the layer: the pictures before,
after,
and after undoing the change must be equal.

  run_changes.py --build build [NAME...]
  run_changes.py --build build --backend auto

A change that is invisible on the bare host fails too, as nothing would be tested. Ends with
"N passed, N failed, N skipped".
"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

import sides

# The rasterizer must make at least this fraction of all draws.
MOST_DRAWN = 0.8


def pictures(client, name, env):
    """Returns [(form and name, moment, bytes)], or how the client died."""
    try:
        return [(*what.rsplit(": ", 1), data) for what, data in sides.run([client, name], env)]
    except (sides.Died, subprocess.TimeoutExpired) as death:
        return str(death)


def judge(bare, layer):
    """Returns complaints, as lines."""
    for side, found in (("the bare host", bare), ("layer", layer)):
        if isinstance(found, str):
            return [f"{side}: {found}"]
    if [row[:2] for row in bare] != [row[:2] for row in layer]:
        return ["other records"]
    lines, seen = [], {}
    for (what, when, a), (_, _, b) in zip(bare, layer):
        seen.setdefault(what, {})[when] = a
        far, worst = sides.distances(a, b)
        if far:
            lines.append(f"{what}, {when}: {far} pixels differ, by up to {worst}")
    for what, moments in seen.items():
        for first, second in (("before", "after"), ("pushed", "popped")):
            if first in moments and moments[first] == moments.get(second):
                lines.append(f"{what}: {second} is not to be seen in pixels")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("names", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-changes"
    listing = subprocess.run([client, "list"], capture_output=True, text=True, check=True).stdout
    names = args.names or listing.splitlines()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="arbiter-changes-") as scratch, \
            sides.Displays() as displays, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        stats = pathlib.Path(scratch) / "stats-%p.json"
        bare = sides.environment()
        layer = sides.environment(sides.layer_of(build), args.backend,
                                  {"ARBITER_STATS": str(stats), "XDG_CACHE_HOME": scratch})

        def compare(name):
            display = {"DISPLAY": displays.name()}
            return judge(pictures(client, name, {**bare, **display}),
                         pictures(client, name, {**layer, **display}))

        for name, lines in zip(names, pool.map(compare, names)):
            failed += bool(lines)
            if lines:
                print(f"{name}: FAIL")
            for line in lines[:8]:
                print(f"    {line}", flush=True)
        drawn, given = sides.software_totals(scratch)
    print(f"the rasterizer drew {drawn}, the host {given}")
    if args.backend == "swrast" and not args.names:
        failed += drawn < MOST_DRAWN * (drawn + sum(given.values()))
    print(f"{max(0, len(names) - failed)} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
