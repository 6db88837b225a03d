#!/usr/bin/env python3
"""Tests textures that EGLImages share, under the layer with each back end: run_images.py --build build.
Ends with "N passed, N failed, N skipped"."""

import argparse
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
import sides  # noqa: E402

SKIPPED = 77  # the host does not support EGLImages of textures


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    build = parser.parse_args().build.resolve()
    client, counts = build / "tests/sharing_vs_host/sharing-images", {"passed": 0, "failed": 0, "skipped": 0}
    with tempfile.TemporaryDirectory(prefix="arbiter-images-") as scratch:
        for side in ("bare", "host", "auto", "swrast"):
            env = sides.environment(extra={"XDG_CACHE_HOME": scratch}) if side == "bare" else \
                sides.environment(sides.layer_of(build), side, {"XDG_CACHE_HOME": scratch})
            done = subprocess.run([str(client)], env=env, capture_output=True, text=True,
                                  timeout=sides.TIMEOUT)
            result = {0: "passed", SKIPPED: "skipped"}.get(done.returncode, "failed")
            counts[result] += 1
            print(f"{side}: {result}{'' if result == 'passed' else ' ' + done.stderr.strip()[-600:]}")
    print(", ".join(f"{number} {name}" for name, number in counts.items()))
    return 1 if counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
