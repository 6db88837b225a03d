#!/usr/bin/env python3
"""Compares frames that the rasterizer and the host draw together, in windows that change: random sequences are shown
and
read on the bare host and under the layer, with the server's MIT-SHM and without. The layer's fresh memory contains a
pattern, so that undefined pixels are visible.

  run_mixed.py --build build [--first SEED] [--count N]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import sides
from x_server import XServer

SERVERS = {"MIT-SHM": (), "no MIT-SHM": ("-extension", "MIT-SHM")}
# Late machine code arrives while frames pause; the passes of a frame must meet nevertheless.
PAUSE_MS = 40
WAYS = {"auto": ("auto", {"ARBITER_DEBUG": "steady"}),
        "auto, late code": ("auto", {"ARBITER_DEBUG": "late-code"}),
        "swrast": ("swrast", {}), "host": ("host", {})}
POISON = (85, 170, 157)  # patterns of fresh memory: of two bare runs, and of the layer's


def defined(first, second):
    """Returns what two bare runs agree on: a host without MIT-SHM shows uninitialised memory if a window has grown
    since
    its buffers were made."""
    return [a if a == b else None for a, b in zip(first, second)]


def judge(bare, layer, backend, part):
    """Returns complaints, as lines."""
    if len(bare) != len(layer):
        return [f"{len(layer)} records for {len(bare)}"]
    kept = [(a, b) for a, b in zip(bare, layer) if a]
    wrong = sides.differences(*zip(*kept))
    if len(kept) < len(bare) * 3 // 4:
        wrong.append(f"only {len(kept)} of {len(bare)} pictures are defined")
    if backend == "host":
        return wrong
    if not part.get("drawn"):
        wrong.append("the rasterizer drew nothing")
    if not part.get("given_to_host"):
        wrong.append("the host drew nothing")
    return wrong


def bare_run(command, options, poison, attempts=3):
    """Returns the bare host's records. It may crash from uninitialised memory: in one of twenty runs under
    AddressSanitizer, inside its driver."""
    try:
        with XServer(options=options) as display:
            return sides.run(command, sides.environment(extra={"DISPLAY": display}, fresh=poison))
    except sides.Died:
        if attempts == 1:
            raise
    return bare_run(command, options, poison, attempts - 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=25)
    args = parser.parse_args()
    build = args.build.resolve()
    command = [build / "tests/rasterizer_vs_host/rasterizer-mixed", args.first, args.count]
    tally = sides.Tally()
    for server, options in SERVERS.items():
        bare = defined(*(bare_run(command, options, poison) for poison in POISON[:2]))
        for way, (backend, extra) in WAYS.items():
            with tempfile.TemporaryDirectory(prefix="arbiter-mixed-") as scratch, \
                    XServer(options=options) as display:
                stats = pathlib.Path(scratch) / "stats.json"
                env = sides.environment(sides.layer_of(build), backend,
                                        {"DISPLAY": display, "XDG_CACHE_HOME": scratch,
                                         "ARBITER_STATS": str(stats), **extra}, POISON[2])
                try:
                    layer = sides.run([*command, PAUSE_MS] if "late" in way else command, env)
                except (sides.Died, subprocess.TimeoutExpired) as death:
                    wrong = [str(death)]
                else:
                    wrong = judge(bare, layer, backend, sides.software_statistics(stats))
            tally.row(f"{way}, {server}: {args.count} sequences from seed {args.first}, {len(bare)} pictures",
                      wrong, 12)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
