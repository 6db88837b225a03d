#!/usr/bin/env python3
"""Texture 0 of each target among textures with names: random sequences on the bare host and under the
layer, pictures and texels compared; their draws must be the rasterizer's, but for textures that another
context deleted.

  run_default_textures.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides
from x_server import XServer


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    args = parser.parse_args()
    build = args.build.resolve()
    command = [build / "tests/software/software-default-textures", args.first, args.count]
    with tempfile.TemporaryDirectory(prefix="arbiter-default-") as scratch, XServer() as display:
        # Mesa 22.3.6 reads memory that it freed where a context ends that shared textures, and waits for
        # ever where freed memory holds something else by then: Meson asks for that of its tests.
        extra = {"DISPLAY": display, "XDG_CACHE_HOME": scratch, "MALLOC_PERTURB_": "0"}
        stats = pathlib.Path(scratch) / "stats.json"
        layer = sides.environment(sides.layer_of(build), args.backend,
                                  {**extra, "ARBITER_STATS": str(stats)})
        try:
            bare = sides.run(command, sides.environment(extra=extra))
            wrong = sides.differences(bare, sides.run(command, layer))
        except (sides.Died, subprocess.TimeoutExpired) as death:
            bare, wrong = [], [str(death)]
        part = sides.software_statistics(stats)
    drawn, given = part.get("drawn", 0), part.get("given_to_host", {})
    if args.backend == "swrast" and drawn <= 50 * sum(given.values()):
        wrong.append("too many draws are the host's")
    print(f"{args.count} sequences from seed {args.first}, {len(bare)} records; the rasterizer drew "
          f"{drawn}, the host {given}")
    for line in wrong[:12]:
        print(f"     {line}")
    print(f"{int(not wrong)} passed, {int(bool(wrong))} failed, 0 skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
