#!/usr/bin/env python3
"""Tests draws of very many vertices, lists of very many commands, and very long programs.

The process takes at most 1.3 times the bare one's memory and, with --time, time. The picture is compared with the
layer's own host back end, as the bare host shades smoothly under ARB programs whatever ShadeModel says.

  run_large.py --build build [--vertices N] [--binds N] [--time] [--backend NAME] [--kind NAME]

Ends with "N passed, N failed, 0 skipped".
"""

import json
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
import sides  # noqa: E402
from x_server import XServer  # noqa: E402

RATIO = 1.3
LONG_RATIO = 1.5  # of memory: under the layer, long programs go through the host's GLSL
# KiB that the layer takes for any number of vertices: machine code, the first vertices of Begin and End. They matter if
# the vertices are few and in no array.
OWN, OWN_UP_TO = 24 << 10, 10_000_000
WAIT_US = 600_000
CHAINS = ("long-mad", "long-tex", "long-pow", "long-mixture")
PIXELS = 0.02  # the fraction of pixels that may differ, as the rasterizers' lines and points are not equal


def figures_of(build, what, count, display, folder, backend=None):
    """Returns (pixels, milliseconds, KiB, software statistics)."""
    stats = pathlib.Path(folder) / f"{what}-{backend}.json"
    layer = sides.layer_of(build) if backend else None
    # Each run has its own cache, as the host stores compiled programs.
    cache = pathlib.Path(folder) / f"cache-{backend}"
    env = sides.environment(layer, backend, {"DISPLAY": display, "XDG_CACHE_HOME": str(cache),
                                             "ARBITER_STATS": str(stats)})
    records = dict(sides.run([build / "tests/memory_vs_host/rasterizer-large", what, count], env))
    milliseconds, kib = records["figures"].split()
    return records["picture"], int(milliseconds), int(kib), sides.software_statistics(stats)


def wrong_of_long(statistics):
    """Checks that machine code is not waited for: the host draws with the program."""
    wrong = []
    if not statistics.get("given_to_host", {}).get("not_compiled"):
        wrong.append("the host did not draw with the long program")
    waited = statistics.get("machine_code", {}).get("compile_microseconds", 0)
    if waited > WAIT_US:
        wrong.append(f"{waited} us for machine code")
    return wrong


def main():
    parser = sides.options(__doc__)
    parser.add_argument("--vertices", type=int, default=1_300_001)
    parser.add_argument("--binds", type=int, default=300_000)
    parser.add_argument("--instructions", type=int, default=1500)
    parser.add_argument("--time", action="store_true", help="hold the time to the ratio too")
    parser.add_argument("--any-memory", action="store_true",
                        help="judge no memory: AddressSanitizer keeps what is freed")
    parser.add_argument("--backend", default="swrast", choices=("host", "auto", "swrast"))
    parser.add_argument("--kind", action="append")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    sides.TIMEOUT = 1800  # the bare host takes minutes for a program of 16,000 instructions
    build = arguments.build.resolve()
    client = build / "tests/memory_vs_host/rasterizer-large"
    kinds = arguments.kind or [*sides.subprocess.run([client, "--list"], capture_output=True, text=True,
                                                     check=True).stdout.split(), "binds", *CHAINS]
    rows, tally = [], sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-large-") as folder, XServer() as display:
        for kind in kinds:
            count = (arguments.binds if kind == "binds" else
                     arguments.instructions if kind in CHAINS else arguments.vertices)
            bare = figures_of(build, kind, count, display, folder)
            layered = figures_of(build, kind, count, display, folder, arguments.backend)
            host = figures_of(build, kind, count, display, folder, "host")
            far, worst = sides.distances(host[0], layered[0])
            drawn = layered[3].get("drawn", 0)
            given = {k: v for k, v in layered[3].get("given_to_host", {}).items() if v}
            wrong = []
            if far > PIXELS * len(bare[0]) / 4:
                wrong.append(f"{far} pixels differ, by up to {worst}")
            own = OWN if kind.startswith("begin-") and count < OWN_UP_TO else 0
            if not arguments.any_memory and layered[2] > (LONG_RATIO if kind in CHAINS else RATIO) * bare[2] + own:
                wrong.append(f"{layered[2]} KiB against {bare[2]}")
            longest = bare[1] + WAIT_US / 1000 if kind in CHAINS else RATIO * bare[1]
            if arguments.time and layered[1] > longest:
                wrong.append(f"{layered[1]} ms against {bare[1]}")
            if kind in CHAINS:
                wrong += wrong_of_long(layered[3])
                if (pixels := sides.distances(bare[0], layered[0])[0]) > PIXELS * len(bare[0]) / 4:
                    wrong.append(f"{pixels} pixels are not the bare host's")
            elif arguments.backend == "swrast" and (given or drawn < 2):
                wrong.append(f"the rasterizer drew {drawn}, the host {given}")
            rows.append({"kind": kind, "count": count, "milliseconds": [bare[1], layered[1]],
                         "kib": [bare[2], layered[2]], "pixels": far, "wrong": wrong})
            tally.row(f"{kind}: {layered[1]} ms ({bare[1]} bare), {layered[2]} KiB ({bare[2]}), {far} pixels differ",
                      wrong)
    if arguments.json:
        arguments.json.parent.mkdir(parents=True, exist_ok=True)
        arguments.json.write_text(json.dumps(rows, indent=1))
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
