#!/usr/bin/env python3
"""Tests that a second start of an application reads its machine code from disk: the functions are the same,
nothing is stored again, and they are ready in a fraction of the time.

  run_cache.py --build build

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import pathlib
import sys
import tempfile

import sides
from x_server import XServer

SCENE = "feedback"  # of rasterizer-presenter: two fragment programs


def start(client, layer, folder, display):
    """Returns (the software part of the statistics, {object: which file})."""
    stats = folder / "stats.json"
    sides.run([client, SCENE],
              sides.environment(layer, "swrast", {"DISPLAY": display, "XDG_CACHE_HOME": str(folder),
                                                "ARBITER_STATS": str(stats)}))
    objects = {path: path.stat().st_ino for path in folder.glob("**/code/**/*")
               if path.is_file() and path.name != "key"}
    return sides.software_statistics(stats), objects


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    build = parser.parse_args().build.resolve()
    client = build / "tests/rasterizer_vs_host/rasterizer-presenter"
    with tempfile.TemporaryDirectory(prefix="arbiter-cache-") as folder, XServer() as display:
        runs = [start(client, sides.layer_of(build), pathlib.Path(folder), display)
                for _ in range(2)]
    (first, stored), (second, kept) = runs
    made, taken = (run.get("machine_code", {}) for run in (first, second))
    checks = {
        "the first start stores its functions": len(stored) >= 3,
        "the second has as many functions": made.get("functions", 0) >= 3
        and made["functions"] == taken.get("functions"),
        "the second stores nothing": stored == kept,
        # Compiling a function takes some milliseconds, loading it a fraction of one.
        "the second does not compile": 0 < 3 * taken.get("compile_microseconds", 0)
        < made.get("compile_microseconds", 0),
        # Draws wait here: under auto, on a busy machine, the host may draw before the library is loaded.
        "all draws of the second are the rasterizer's": second.get("drawn", 0) > 0
        and not second.get("given_to_host"),
    }
    for what, holds in checks.items():
        print(f"{'pass' if holds else 'FAIL'} {what}")
    print(f"compiled in {made.get('compile_microseconds')} us, taken from the disk in "
          f"{taken.get('compile_microseconds')} us, {len(stored)} objects")
    failed = sum(not holds for holds in checks.values())
    print(f"{len(checks) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
