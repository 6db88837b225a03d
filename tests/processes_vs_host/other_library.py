#!/usr/bin/env python3
"""Tests that the layer refuses a libarbiter_jit.so built with other headers: it logs one line, and the host draws.
Also tests that the version changes with each of the headers.

  other_library.py --build build
"""

import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent / "src"
sys.path[:0] = [str(HERE.parent / "rasterizer_vs_host"), str(SOURCE / "fp_compiler")]
import jit_version  # noqa: E402
import sides  # noqa: E402

ROOTS = ("fp_compiler/jit_boundary.h", "fp_compiler/jit_fields.h")
# The interface uses these headers for certain, so that the closure must have found them.
KNOWN = {"fp_compiler/abi.h", "fp_compiler/jit.h", "fp_compiler/ir/interface.h", "fp_compiler/ir/ir.h",
         "fp_compiler/ir/ops.def", "fp_compiler/numerics.h"}
REFUSED = re.compile(r"no rasterizer, the host draws: .* was built with other headers than this$")


def patched(library, version, folder):
    """Returns a copy of the library with another version."""
    data = library.read_bytes()
    old = version.to_bytes(8, "little")
    if old not in data:
        raise AssertionError("the library does not say its version")
    copy = folder / "libarbiter_jit.so"
    copy.write_bytes(data.replace(old, (version ^ (1 << 40)).to_bytes(8, "little")))
    return copy


def drawn_with(build, library, backend, display, folder):
    """Returns (lines of output, lines of the log, draws of the rasterizer)."""
    stats = folder / "stats.json"
    stats.unlink(missing_ok=True)
    env = sides.environment(sides.layer_of(build), backend,
                            {"DISPLAY": display, "XDG_CACHE_HOME": str(folder), "ARBITER_STATS": str(stats),
                             "ARBITER_JIT_LIBRARY": str(library or "")})
    done = subprocess.run([build / "tests/processes_vs_host/foreign", "plain"], env=env, capture_output=True,
                          text=True, timeout=120)
    if done.returncode:
        raise AssertionError(f"{library}, {backend}: status {done.returncode}: {done.stderr[-400:]}")
    return done.stdout.splitlines(), done.stderr.splitlines(), sides.software_statistics(stats).get("drawn", 0)


def wrong_versions(build):
    """Returns lines about faults of the version."""
    headers = jit_version.closure(SOURCE, ROOTS)
    text = (build / "src/fp_compiler/jit_version.h").read_text()
    now = jit_version.version(headers)
    if f"0x{now};" not in text:
        yield "the build's version is not that of the headers"
    if KNOWN - set(headers):
        yield f"not looked at: {sorted(KNOWN - set(headers))}"
    for name in headers:
        if jit_version.version({**headers, name: headers[name] + b"\n"}) == now:
            yield f"{name} may change, and the version does not"


def wrong_ends(build, display, folder):
    own = build / "src/fp_compiler/back/llvm/libarbiter_jit.so"
    version = int(jit_version.version(jit_version.closure(SOURCE, ROOTS)), 16)
    other = build / "tests/processes_vs_host/libother_jit.so"
    right = drawn_with(build, None, "swrast", display, folder)
    if right[2] == 0:
        yield "the rasterizer draws nothing with its own library"
    for library in (other, patched(own, version, folder)):
        for backend in ("auto", "swrast"):
            output, log, drawn = drawn_with(build, library, backend, display, folder)
            what = f"{library.name}, {backend}"
            said = [line for line in log if REFUSED.search(line)]
            if len(said) != 1:
                yield f"{what}: the log says {log}"
            if drawn:
                yield f"{what}: the rasterizer drew"
            if len(output) != len(right[0]):
                yield f"{what}: {len(output)} lines of output"


def main():
    parser = sides.options(__doc__)
    build = parser.parse_args().build.resolve()
    problems = list(wrong_versions(build))
    with sides.XServer() as display, tempfile.TemporaryDirectory(prefix="arbiter-library-") as folder:
        problems += wrong_ends(build, display, pathlib.Path(folder))
    print("\n".join(problems) or "another library is refused")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
