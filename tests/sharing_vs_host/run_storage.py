#!/usr/bin/env python3
"""Tests objects that share storage, and objects that shaders write. Each scene of sharing-storage is drawn on the bare
host and under the layer, with each back end, and the pictures must be equal.

  run_storage.py --build build [SCENE...]

Ends with "N passed, N failed, N skipped".
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
import sides  # noqa: E402

SKIPPED = "status 77"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("scenes", nargs="*")
    args = parser.parse_args()
    build = args.build.resolve()
    client = build / "tests/sharing_vs_host/sharing-storage"
    listing = subprocess.run([client, "list"], capture_output=True, text=True, check=True).stdout
    tally = sides.Tally()
    with tempfile.TemporaryDirectory(prefix="arbiter-storage-") as scratch, sides.XServer() as display:
        both = {"DISPLAY": display, "XDG_CACHE_HOME": scratch}
        stats = pathlib.Path(scratch) / "stats.json"
        for scene in args.scenes or listing.splitlines():
            try:
                bare = sides.run([client, scene], sides.environment(extra=both))
            except sides.Died as death:
                if SKIPPED in str(death):
                    tally.skip(scene, death)
                else:
                    tally.row(f"{scene}, bare", [str(death)])
                continue
            for backend in ("host", "auto", "swrast"):
                env = sides.environment(sides.layer_of(build), backend,
                                        {**both, "ARBITER_STATS": str(stats)})
                stats.unlink(missing_ok=True)
                try:
                    wrong = sides.differences(bare, sides.run([client, scene], env))
                except sides.Died as death:
                    wrong = [str(death)]
                part = sides.software_statistics(stats)
                if backend == "swrast" and not part.get("drawn"):
                    wrong.append("the rasterizer drew nothing")
                tally.row(f"{scene}, {backend}: the rasterizer drew {part.get('drawn', 0)}, the host "
                          f"{part.get('given_to_host', {})}", wrong)
    return tally.end()


if __name__ == "__main__":
    sys.exit(main())
