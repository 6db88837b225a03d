"""The two sides of a comparison: the bare host, and the layer in front with a named back end."""

import argparse
import collections
import contextlib
import json
import os
import pathlib
import subprocess
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "clients"))
from plain_environment import sanitized  # noqa: E402
from x_server import XServer  # noqa: E402

TIMEOUT = 300
# In C code, Debian's 32-bit x86 Mesa computes with x87: clipping, dividing, products of matrices.
HOST_HAS_X87 = os.environ.get("CUT_BY_X87") == "1"


def environment(layer=None, backend=None, extra=None, fresh=None):
    """Returns the environment of a side.

    `fresh`: 0 to 255 selects the pattern of fresh memory. The C library's allocator reads one variable.
    AddressSanitizer's
    allocator, which replaces it in a tree of ./dev asan, reads the other (and fills no more than 4 KiB by default)."""
    env = sanitized(bool(layer))
    if layer:
        env.update(LD_PRELOAD=str(layer), ARBITER_BACKEND=backend, ARBITER_PROFILE="host")
    if fresh is not None:
        env["MALLOC_PERTURB_"] = str(fresh)
        env["ASAN_OPTIONS"] += f":malloc_fill_byte={fresh}:max_malloc_fill_size={1 << 28}"
    env.update(extra or {})
    return env


class Displays:
    """Runs an X server for each thread, as windows on one server cover one another."""

    def __enter__(self):
        self.own, self.stack = threading.local(), contextlib.ExitStack()
        self.lock = threading.Lock()
        return self

    def name(self):
        if not hasattr(self.own, "name"):
            server = XServer()
            self.own.name = server.__enter__()
            with self.lock:
                self.stack.push(server)
        return self.own.name

    def __exit__(self, *error):
        self.stack.close()


class Died(Exception):
    """A client ended with a nonzero status."""


def run(command, env, text=None):
    """Returns the client's records: [(what, bytes)]."""
    result = subprocess.run([str(word) for word in command], env=env, input=text,
                            capture_output=True, timeout=TIMEOUT)
    if result.returncode:
        tail = result.stderr.decode(errors="replace")[-600:]
        raise Died(f"status {result.returncode}: {tail}")
    return records(result.stdout)


def records(data):
    found, at = [], 0
    while at < len(data):
        end = data.index(b"\n", at)
        what, size = data[at:end].decode().rsplit("\t", 1)
        found.append((what, data[end + 1:end + 1 + int(size)]))
        at = end + 1 + int(size)
    return found


def distances(a, b, rounding=1):
    """Returns (how many pixels of four bytes differ by more than `rounding`, the largest difference)."""
    if a == b:
        return 0, 0
    if len(a) != len(b):
        return max(len(a), len(b)) // 4, 255
    apart = [abs(x - y) for x, y in zip(a, b)]
    worst = max(apart)
    if worst <= rounding:
        return 0, worst
    return sum(max(apart[i:i + 4]) > rounding for i in range(0, len(apart), 4)), worst


def differences(bare, layer, rounding=1):
    """Returns the differences of two clients' records, a line each. `rounding`: the difference in 255ths that counts as
    equal."""
    lines = []
    if [what for what, _ in bare] != [what for what, _ in layer]:
        pairs = [(x, y) for (x, _), (y, _) in zip(bare, layer) if x != y]
        lines += [f"bare '{x}', layer '{y}'" for x, y in pairs[:4]] or ["other records"]
    for (what, a), (_, b) in zip(bare, layer):
        far, worst = distances(a, b, rounding)
        if far:
            lines.append(f"'{what}': {far} pixels differ, by up to {worst}")
    return lines


def far_pictures(bare, layer, rounding, few):
    """Returns differences(), except that up to `few` pixels of a picture may differ by more than `rounding`."""
    lines = differences([(what, b"") for what, _ in bare], [(what, b"") for what, _ in layer])
    for (what, one), (_, other) in zip(bare, layer):
        far, worst = distances(one, other, rounding)
        if far > few:
            lines.append(f"'{what}': {far} pixels differ, by up to {worst}")
    return lines


def software_statistics(path):
    """Returns the rasterizer's part of the layer's statistics; empty without a file."""
    try:
        return json.loads(pathlib.Path(path).read_text()).get("software") or {}
    except (OSError, ValueError):
        return {}


def software_totals(folder):
    """Returns (draws of the rasterizer, {reason: draws that it left to the host}) over the statistics there."""
    drawn, given = 0, collections.Counter()
    for path in pathlib.Path(folder).glob("stats-*"):
        part = software_statistics(path)
        drawn += part.get("drawn", 0)
        given.update(part.get("given_to_host", {}))
    return drawn, dict(given)


def guarded(build, env, at):
    """Returns `env` with the layer's memory between inaccessible pages: guarded_memory.cpp.

    `at`: begin or end, whichever end of a block is next to such a page."""
    guard = build / "tests/rasterizer_vs_host/librasterizer_guard.so"
    if not guard.exists():
        sys.exit(f"not built: {guard}")
    return {**env, "LD_PRELOAD": f"{guard}:{env['LD_PRELOAD']}", "GUARD_AT": at}


# The names of ARBITER_CPU's processors in /proc/cpuinfo.
CPU_FLAGS = {"avx512": "avx512dq", "avx2": "avx2", "sse4.1": "sse4_1"}


def cpu_setting(cpu):
    """Returns the variables that restrict the rasterizer to a family of processors; exits with 77 if this processor
    does not belong to it."""
    if not cpu:
        return {}
    words = pathlib.Path("/proc/cpuinfo").read_text().split()
    if CPU_FLAGS[cpu] not in words:
        print(f"skipped: this processor does not run code for {cpu}")
        sys.exit(77)
    return {"ARBITER_CPU": cpu}


def options(description):
    """Returns a parser of a runner's command line: --build."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    return parser


def layer_of(build):
    layer = build / "src/interposer/libGLX_arbiter.so.0"
    if not layer.exists():
        sys.exit(f"the layer is not built: {layer}")
    return layer


class Tally:
    """Prints the rows of a comparison, a line each as they are known, and the result at the end."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def row(self, what, wrong, most=8):
        """Counts a row. `wrong`: lines; none if the row passes."""
        self.passed, self.failed = self.passed + (not wrong), self.failed + bool(wrong)
        print(f"{'FAIL' if wrong else 'pass'} {what}", flush=True)
        for line in wrong[:most]:
            print(f"     {line}")

    def skip(self, what, why):
        self.skipped += 1
        print(f"skip {what}: {why}", flush=True)

    def end(self):
        """Prints the result and returns the process's exit status."""
        print(f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped")
        return 1 if self.failed else 0
