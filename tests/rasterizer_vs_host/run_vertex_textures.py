#!/usr/bin/env python3
"""Textures in vertex programs: random sequences under the layer, drawn by the host and by the rasterizer,
compared; a bare host has no such programs. The host waits for what it has drawn to a texture before a
vertex program samples it: llvmpipe of Mesa 22.3.6 does not, and gives other pixels from run to run. The
rasterizer must have drawn nearly all of its draws.

  run_vertex_textures.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import sys
import tempfile

import sides
from x_server import XServer


def main():
    args = sides.seeded_arguments(__doc__, 40)
    build = args.build.resolve()
    command = [build / "tests/rasterizer_vs_host/rasterizer-vertex-textures", args.first, args.count]
    found = []
    with tempfile.TemporaryDirectory(prefix="arbiter-vertex-textures-") as scratch, XServer() as display:
        stats = pathlib.Path(scratch) / "stats.json"
        for backend in ("host", args.backend):
            stats.unlink(missing_ok=True)
            waits = ["finish"] if backend == "host" else []
            found.append(sides.run([*command, *waits], sides.environment(sides.layer_of(build), backend, {
                "DISPLAY": display, "XDG_CACHE_HOME": scratch, "ARBITER_PROFILE": "nv40",
                "ARBITER_STATS": str(stats)})))
        part = sides.software_statistics(stats)
    wrong = sides.differences(*found)
    drawn, given = part.get("drawn", 0), part.get("given_to_host", {})
    if args.backend == "swrast" and drawn <= 50 * sum(given.values()):
        wrong.append("too many draws are the host's")
    print(f"{args.count} sequences from seed {args.first}, {len(found[0])} records; the rasterizer drew "
          f"{drawn}, the host {given}")
    for line in wrong[:12]:
        print(f"     {line}")
    print(f"{int(not wrong)} passed, {int(bool(wrong))} failed, 0 skipped")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
