"""The two sides of a comparison: the bare host, and the layer in front with a back end named."""

import argparse
import collections
import contextlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "clients"))
from plain_environment import sanitized  # noqa: E402
from x_server import XServer  # noqa: E402

TIMEOUT = 300
# Debian's Mesa of 32-bit x86 computes with x87 what it does in C: cutting, dividing, products of matrices.
HOST_HAS_X87 = os.environ.get("CUT_BY_X87") == "1"


def environment(layer=None, backend=None, extra=None, fresh=None):
    """`fresh`: 0 to 255 chooses the pattern that fresh memory holds. The C library's allocator reads one
    variable, AddressSanitizer's, which takes its place in a tree of ./dev asan, the other (and fills no
    more than 4 KiB unless it is told)."""
    env = sanitized(bool(layer))
    if layer:
        env.update(LD_PRELOAD=str(layer), ARBITER_BACKEND=backend, ARBITER_PROFILE="host")
    if fresh is not None:
        env["MALLOC_PERTURB_"] = str(fresh)
        env["ASAN_OPTIONS"] += f":malloc_fill_byte={fresh}:max_malloc_fill_size={1 << 28}"
    env.update(extra or {})
    return env


class Displays:
    """An X server for each thread that asks: windows of one server hide one another."""

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
    """A client that ended with a status that is not 0."""


def run(command, env, text=None):
    """The client's records: [(what, bytes)]."""
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
    """(how many pixels of four bytes differ by more than `rounding`, the furthest distance)."""
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
    """What two clients' records differ in, a line each; nothing where they agree. `rounding`: of 255, how
    far two may be apart that agree."""
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
    """differences(), where up to `few` pixels of a picture may be further apart than `rounding`."""
    lines = differences([(what, b"") for what, _ in bare], [(what, b"") for what, _ in layer])
    for (what, one), (_, other) in zip(bare, layer):
        far, worst = distances(one, other, rounding)
        if far > few:
            lines.append(f"'{what}': {far} pixels differ, by up to {worst}")
    return lines


def software_statistics(path):
    """The part of the layer's statistics that is about the rasterizer; empty without one."""
    try:
        return json.loads(pathlib.Path(path).read_text()).get("software") or {}
    except (OSError, ValueError):
        return {}


def bare_and_layer(command, layer, scratch, server_options=(), bare=None):
    """(the bare host's records, those under the layer with the back end swrast, its statistics), on an X
    server each. `scratch`: a folder for caches and statistics. `bare`: the command on the bare host, where it
    is another."""
    stats = pathlib.Path(scratch) / "stats.json"
    stats.unlink(missing_ok=True)
    both = {"XDG_CACHE_HOME": str(scratch)}
    answers = []
    for arguments, env in ((bare or command, environment(extra=both)),
                           (command, environment(layer, "swrast", {**both, "ARBITER_STATS": str(stats)}))):
        with XServer(options=server_options) as display:
            answers.append(run(arguments, {**env, "DISPLAY": display}))
    return (*answers, software_statistics(stats))


def software_totals(folder):
    """(draws of the rasterizer, {reason: draws that it left to the host}) over the statistics there."""
    drawn, given = 0, collections.Counter()
    for path in pathlib.Path(folder).glob("stats-*"):
        part = software_statistics(path)
        drawn += part.get("drawn", 0)
        given.update(part.get("given_to_host", {}))
    return drawn, dict(given)


def guarded(build, env, at):
    """`env` of a layer whose memory lies between pages that nobody may touch: guarded_memory.cpp.
    `at`: begin or end, where blocks lie next to such a page."""
    guard = build / "tests/rasterizer_vs_host/librasterizer_guard.so"
    if not guard.exists():
        sys.exit(f"not built: {guard}")
    return {**env, "LD_PRELOAD": f"{guard}:{env['LD_PRELOAD']}", "GUARD_AT": at}


# What /proc/cpuinfo calls the processors of ARBITER_CPU.
CPU_FLAGS = {"avx512": "avx512dq", "avx2": "avx2", "sse4.1": "sse4_1"}


def cpu_setting(cpu):
    """The variables that hold the rasterizer to a family of processors; ends with 77 where this one is
    not of it."""
    if not cpu:
        return {}
    words = pathlib.Path("/proc/cpuinfo").read_text().split()
    if CPU_FLAGS[cpu] not in words:
        print(f"0 passed, 0 failed, 1 skipped: this processor has no {cpu}")
        sys.exit(77)
    return {"ARBITER_CPU": cpu}


def layer_of(build):
    layer = build / "src/interposer/libGLX_arbiter.so.0"
    if not layer.exists():
        sys.exit(f"the layer is not built: {layer}")
    return layer


def seeded_arguments(doc, count):
    """The command line of a runner of random scenes: --build, --first SEED, --count N, --backend."""
    parser = argparse.ArgumentParser(description=doc,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    return parser.parse_args()


def compare(args, client, judge, extra=None, host=None):
    """(the other side's records, what judge(other, layer) finds wrong, the rasterizer's statistics) of a
    client of tests/rasterizer_vs_host that draws args.count scenes from seed args.first on. The other side
    is the bare host, or with `host`, further arguments of the client, the layer whose host draws all."""
    build = args.build.resolve()
    command = [build / "tests/rasterizer_vs_host" / client, args.first, args.count]
    with tempfile.TemporaryDirectory(prefix="arbiter-sides-") as scratch, XServer() as display:
        both = {"DISPLAY": display, "XDG_CACHE_HOME": scratch, **(extra or {})}
        stats = pathlib.Path(scratch) / "stats.json"
        layer = environment(layer_of(build), args.backend, {**both, "ARBITER_STATS": str(stats)})
        other = environment(extra=both) if host is None else environment(layer_of(build), "host", both)
        try:
            bare = run([*command, *(host or [])], other)
            wrong = judge(bare, run(command, layer))
        except (Died, subprocess.TimeoutExpired) as death:
            bare, wrong = [], [str(death)]
        return bare, wrong, software_statistics(stats)


def conclude(args, what, records, wrong, part):
    """Says how a comparison of compare() went; 1 where something is wrong."""
    print(f"{args.count} {what} from seed {args.first}, {len(records)} records; the rasterizer drew "
          f"{part.get('drawn', 0)}, the host {part.get('given_to_host', {})}")
    for line in wrong[:12]:
        print(f"     {line}")
    print(f"{int(not wrong)} passed, {int(bool(wrong))} failed, 0 skipped")
    return 1 if wrong else 0


def mostly_ours(args, part, least):
    """Whether the rasterizer, where it must draw, drew more than `least` times what the host did."""
    return args.backend != "swrast" or part.get("drawn", 0) > least * sum(part.get("given_to_host", {}).values())


def all_ours(args, part):
    """Whether the rasterizer, where it must draw, drew all that there was."""
    return args.backend != "swrast" or (part.get("drawn", 0) > 0 and not part.get("given_to_host", {}))


def empty_pictures(records):
    """A line for each picture, of red and blue, in which nothing is drawn."""
    return [f"'{what}': nothing is drawn" for what, picture in records
            if picture and not any(picture[0::4]) and not any(picture[2::4])]


class Tally:
    """The rows of a comparison, a line each as they are known, and what is said at the end."""

    def __init__(self):
        self.passed = self.failed = self.skipped = 0

    def row(self, what, wrong, most=8):
        """`wrong`: lines; none if the row passes."""
        self.passed, self.failed = self.passed + (not wrong), self.failed + bool(wrong)
        print(f"{'FAIL' if wrong else 'pass'} {what}", flush=True)
        for line in wrong[:most]:
            print(f"     {line}")

    def skip(self, what, why):
        self.skipped += 1
        print(f"skip {what}: {why}", flush=True)

    def end(self):
        """The status for the process."""
        print(f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped")
        return 1 if self.failed else 0
