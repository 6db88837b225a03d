#!/usr/bin/env python3
"""Runs the matrix of foreign processes. Each row is something that programs do to themselves (ends.cpp,
surroundings.cpp,
forks.cpp, threads.cpp), on the bare host and under the layer with each back end. No row may be worse than bare: the
end, the output and the time must match, and the picture may differ by a step. If the bare host itself sometimes
fails, the layer may not fail more often (rates.py).

  tests/processes_vs_host/run.py --build build                     all
  tests/processes_vs_host/run.py --build build --quick --repeat 1  as ./dev test
  tests/processes_vs_host/run.py --build build --only exit         rows that have "exit" in their name
  tests/processes_vs_host/run.py --build build --repeat 20         each row with asynchronous events 20 times
  tests/processes_vs_host/run.py --build build --seed 1234         as a failure named it

Prints a table, and with --json writes it. Exit status 1 if a row is worse than bare.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "clients"))
import rates  # noqa: E402
from plain_environment import heed_signals, plain  # noqa: E402
from x_server import XServer  # noqa: E402

WAYS = ("host", "auto", "swrast")
TIMEOUT = 60
TIMEOUT_OF_RATES = 25
TIMEOUT_OF_VALGRIND = 300
QUICK_RATES = 150  # seconds for a comparison of rates in ./dev test, which stops it after ten minutes
# valgrind reports "Mismatched free" for a block that one operator new returned and another delete took.
VALGRIND = ("valgrind", "--undef-value-errors=no", "--leak-check=no", "--show-mismatched-frees=yes")
# The bare host does not always survive these, by its own locks and destructors. Their rates are compared, which takes
# minutes and is left to the whole matrix. The rows of watched.cpp test the layer alone.
BY_CHANCE = ("exit-in-handler-", "exit-in-thread-", "exit-while-other-draws", "longjmp-then-exit",
             "fork-child-exits")
# In these rows an event comes asynchronously, by the seed.
FROM_ASIDE = ("drawing", "compiling", "draws", "longjmp", "sig")
# The bare host never survives these, so that they test the layer alone; the value is the required end.
ASKED = {"exit-slowly-in-thread-drawing": "exit 7"}
WITHOUT_HOST = ("exit-in-layer-drawing-bitmaps", "exit-slowly-in-thread-drawing", "longjmp-out-of-layer-drawing")
# These rows run again with a texture in the vertex program (NV_vertex_program3). The bare host's program has none, but
# its picture is the same.
SAMPLING = ("plain", "exit-in-handler-drawing", "exit-in-thread-drawing", "longjmp-then-exit", "sigterm", "sigsegv",
            "interrupted", "handler-draws", "own-faults", "callback-throws", "fork-before-context", "fork-child-_exits",
            "fork-child-exits", "fork-while-compiling", "small-stack", "cancelled-drawing", "cancelled-compiling",
            "other-context-deletes-drawing")
# A row with such a texture runs on the host back end only if the bare host survives this mode: the back end's requests
# to the host differ from the bare run's.
ASKED_OF_HOST = {"small-stack": "small-stack-links"}
VERTEX_TEXTURE = {"FOREIGN_VERTEX_TEXTURE": "1", "ARBITER_PROFILE": "nv40"}
ALLOCATORS = {"jemalloc": "libjemalloc.so.2", "tcmalloc": "libtcmalloc_minimal.so.4"}


class Row:
    def __init__(self, name, mode, client="foreign", preload=None, wrapper=(), environment=None, without_layer=False,
                 layered=None):
        self.layered = layered or {}  # the environment under the layer alone
        self.name, self.mode, self.client, self.without_layer = name, mode, client, without_layer
        self.preload, self.wrapper, self.environment = preload, wrapper, environment or {}
        # If the host draws, the layer's part of a bitmap or a large draw is a few instructions, which a signal rarely
        # or never interrupts. A host that draws after its destructors ran fails too.
        self.ways = [w for w in WAYS if w != "host"] if mode in WITHOUT_HOST else WAYS
        self.repeats = any(word in mode for word in FROM_ASIDE) and mode != "handler-draws"


def library(name):
    """Returns the path of an installed library, or None."""
    listing = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True).stdout
    return next((line.split()[-1] for line in listing.splitlines() if line.split()[:1] == [name]), None)


def comma_locale(scratch):
    """Makes a folder with a locale that writes 0,5. Returns None if it cannot be made."""
    made = subprocess.run(["localedef", "--no-archive", "-i", "de_DE", "-f", "UTF-8",
                           str(scratch / "de_DE.UTF-8")], capture_output=True) \
        if shutil.which("localedef") else None
    return scratch if made and (scratch / "de_DE.UTF-8").is_dir() else None


def other_users(build, scratch):
    """Makes the client a set-user-ID program of another user. Returns it, or None and the reason."""
    path = scratch / "foreign_other_user"
    if os.geteuid() != 0:
        return None, "needs root: a program of another user's is made"
    if os.statvfs(scratch).f_flag & os.ST_NOSUID:
        return None, "the temporary folder is mounted nosuid"
    shutil.copy(build / "tests/processes_vs_host/foreign", path)
    os.chown(path, 65534, 65534)
    path.chmod(0o4755)
    return path, None


def all_rows(build, scratch):
    """Returns the rows, and those that this machine cannot run."""
    listing = subprocess.run([build / "tests/processes_vs_host/foreign"], capture_output=True, text=True, check=True)
    rows, skipped = [], []
    for mode in listing.stdout.split():
        if mode == "draw-for-ever":  # for statistics.py
            continue
        if mode == "comma-locale":
            folder = comma_locale(scratch)
            if not folder:
                skipped.append((mode, "not installed: localedef with the sources of de_DE (locales)"))
                continue
            rows.append(Row(mode, mode, environment={"LOCPATH": str(folder), "FOREIGN_LOCALE": "de_DE.UTF-8"}))
        else:
            rows.append(Row(mode, mode))
    watched = subprocess.run([build / "tests/processes_vs_host/foreign_watched"], capture_output=True,
                             text=True, check=True)
    rows += [Row(m, m, client="foreign_watched") for m in watched.stdout.split() if "-layer-" in m]
    for mode in ("plain", "exit-in-handler-compiling", "fork-child-exits", "thread-ends-with-context"):
        rows.append(Row(f"own-allocator:{mode}", mode, client="foreign_own_allocator"))
    for name, file in ALLOCATORS.items():
        path = library(file)
        if path:
            rows.append(Row(f"{name}:plain", "plain", preload=path))
        else:
            skipped.append((name, f"not installed: {file}"))
    path, why = other_users(build, scratch)
    if path:  # the loader preloads nothing by its path there, so that even the layer's own check does not run
        rows.append(Row("set-user-id", "plain", client=path, without_layer=True))
    else:
        skipped.append(("set-user-id", why))
    if shutil.which("valgrind"):
        rows.append(Row("valgrind:own-allocator", "plain", client="foreign_own_allocator", wrapper=VALGRIND))
    else:
        skipped.append(("valgrind:own-allocator", "not installed: valgrind"))
    rows.append(Row("reopens-libgl", "plain", client="foreign_reopens"))
    rows += [Row(f"vertex-texture:{mode}", mode, layered=VERTEX_TEXTURE) for mode in SAMPLING]
    rows += [Row(f"vertex-texture:{mode}", mode, client="foreign_watched", layered=VERTEX_TEXTURE)
             for mode in watched.stdout.split() if mode == "longjmp-out-of-layer-drawing"]
    rows.append(Row("egl:other-context-deletes-drawing", "other-context-deletes-drawing",
                    environment={"FOREIGN_EGL": "1"}, layered=VERTEX_TEXTURE))
    rows.append(Row("egl:plain", "plain", environment={"FOREIGN_EGL": "1"}))
    rows.append(Row("no-home", "plain", environment={"HOME": None, "XDG_CACHE_HOME": None}))
    rows.append(Row("read-only-home", "plain", environment={"HOME": "/proc", "XDG_CACHE_HOME": None}))
    return rows, skipped


def stats_file(row, way, scratch, seed):
    return scratch / f"stats-{row.name}-{way}-{seed}.json"


def environment_of(row, way, build, display, scratch, seed):
    env = plain(DISPLAY=display, XDG_CACHE_HOME=str(scratch / "cache"),
                MESA_SHADER_CACHE_DISABLE="true", FOREIGN_SEED=str(seed))
    preload = [row.preload] if row.preload else []
    if way != "bare":
        preload.insert(0, str(build / "src/interposer/libGLX_arbiter.so.0"))
        env.update(ARBITER_BACKEND=way, ARBITER_THREADS="3",
                   ARBITER_STATS=str(stats_file(row, way, scratch, seed)), **row.layered)
    if preload:
        env["LD_PRELOAD"] = ":".join(preload)
    for name, value in row.environment.items():
        env.pop(name, None)
        if value is not None:
            env[name] = value
    return env


def run_once(row, way, build, display, scratch, seed, timeout=TIMEOUT):
    """Returns how the process ended ("exit 7", "SIGTERM", "hangs"), its lines of output, its errors."""
    command = [*row.wrapper, build / "tests/processes_vs_host" / row.client, row.mode]
    process = subprocess.Popen(command, env=environment_of(row, way, build, display, scratch, seed),
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, errors="replace", start_new_session=True, cwd=scratch)
    try:
        out, err = process.communicate(timeout=TIMEOUT_OF_VALGRIND if row.wrapper else timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate()
        return "hangs", out.splitlines(), err
    code = process.returncode
    return (signal.Signals(-code).name if code < 0 else f"exit {code}"), out.splitlines(), err


def same_line(one, other):
    if not (one.startswith("picture ") and other.startswith("picture ")) or len(one) != len(other):
        return one == other
    a, b = bytes.fromhex(one[8:]), bytes.fromhex(other[8:])
    return max(abs(x - y) for x, y in zip(a, b)) <= 1


def difference(bare, layer):
    """Returns how `layer` is worse than `bare`, or None."""
    if layer[0] != bare[0]:
        return f"{layer[0]}, bare {bare[0]}: {layer[2].strip()[-300:]}"
    if len(layer[1]) != len(bare[1]):
        return f"{len(layer[1])} lines of output, bare {len(bare[1])}"
    for number, (one, other) in enumerate(zip(layer[1], bare[1]), 1):
        if not same_line(one, other):
            return f"line {number}: {one[:60]!r}, bare {other[:60]!r}"
    return None


def gave_up(result):
    """True if the process ended in a way that no program asks for; the bare host may do so too."""
    return result[0] in ("hangs", "SIGSEGV", "SIGABRT", "SIGBUS", "SIGILL", "SIGFPE", "exit 4")


def expected_end(mode):
    """True if the row is meant to end by a signal, so that this is no failure of the bare host."""
    return mode.startswith(("abort", "sigsegv"))


def bare_of(row, build, display, scratch, seed):
    """Returns a bare run that ends as the row requires, if any of five does, and how the others ended. For a row that
    tests the layer alone it returns the requirement."""
    if row.mode in ASKED:
        return (ASKED[row.mode], [], ""), []
    failed = []
    for attempt in range(5):
        bare = run_once(row, "bare", build, display, scratch, seed + 1_000_000 * attempt)
        if not gave_up(bare) or expected_end(row.mode):
            return bare, failed
        failed.append(bare[0])
    return None, failed


def ways_of(row, build, display, scratch, seed):
    """Returns the back ends that the row supports, on this host."""
    mode = ASKED_OF_HOST.get(row.mode) if row.layered else None
    if mode and "host" in row.ways and not bare_of(Row(mode, mode), build, display, scratch, seed)[0]:
        print(f"        {row.name}: not by the host, which does not stand {mode}", flush=True)
        return [way for way in row.ways if way != "host"]
    return row.ways


def not_shown(row, way, layer, scratch, seed):
    """Returns what the output lacks: proof that the run tested what its row is for, or valid memory. None: nothing."""
    if "-layer-" in row.mode and "interrupted the layer" not in layer[2]:
        return "never in the layer's code"
    for words in ("Mismatched free", "Invalid free"):
        if words in layer[2]:
            at = layer[2].index(words)
            return layer[2][at:at + 300]
    present = stats_file(row, way, scratch, seed).exists()
    if row.without_layer and present:
        return "the layer is in a set-user-ID process"
    if row.name == "reopens-libgl" and not present:
        return "the layer is not in the process"
    return None


def run_row(row, build, display, scratch, seeds, seconds_of_rates):
    begin = time.monotonic()
    problems, rates_seen, bare_ends, stood = [], [], set(), False
    for seed in seeds if row.repeats else seeds[:1]:
        bare, failed = bare_of(row, build, display, scratch, seed)
        bare_ends.update(failed)
        if not bare:  # the bare host does not survive the row, so that nothing can be worse
            continue
        bare_ends.add(bare[0])
        stood = True
        for way in ways_of(row, build, display, scratch, seed):
            layer = run_once(row, way, build, display, scratch, seed)
            worse = difference(bare, layer) or not_shown(row, way, layer, scratch, seed)
            if worse and gave_up(layer) and not expected_end(row.mode):
                seeds_of_rates = iter(range(seed + 1, seed + 10_000_000))

                def ended(one_way):
                    result = run_once(row, one_way, build, display, scratch, next(seeds_of_rates),
                                      TIMEOUT_OF_RATES)
                    return result[0] if difference(bare, result) else None
                is_worse, words = rates.compare(layer[0], lambda: ended("bare"), lambda: ended(way),
                                                seconds_of_rates)
                rates_seen.append(f"{way}: {words}")
                worse = words if is_worse else None
            if worse:
                problems.append({"way": way, "seed": seed, "worse": worse})
    result = "FAIL" if problems else "pass" if stood else "bare"
    return {"row": row.name, "result": result, "asked": row.mode in ASKED, "bare": sorted(bare_ends),
            "rates": rates_seen, "problems": problems, "seconds": round(time.monotonic() - begin, 2)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build"))
    parser.add_argument("--only", action="append", help="part of a row's name; may be repeated")
    parser.add_argument("--quick", action="store_true",
                        help="without valgrind, and rows that the bare host fails now and then")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--seed", type=int, help="the first seed; by chance if it is not given")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    heed_signals()
    build = arguments.build.resolve()
    first = arguments.seed if arguments.seed is not None else random.SystemRandom().randrange(1, 1_000_000)
    seeds = list(range(first, first + arguments.repeat))
    results = []
    with XServer() as display, tempfile.TemporaryDirectory(prefix="arbiter-processes-") as folder, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        scratch = Path(folder)
        rows, skipped = all_rows(build, scratch)
        if arguments.quick:
            rows = [r for r in rows if not r.mode.startswith(BY_CHANCE) and not r.wrapper]
        if arguments.only:
            rows = [r for r in rows if any(o in r.name for o in arguments.only)]
            if not rows:
                sys.exit(f"processes: no row has {' or '.join(arguments.only)} in its name")
        seconds = QUICK_RATES if arguments.quick else math.inf
        futures = [pool.submit(run_row, r, build, display, scratch, seeds, seconds) for r in rows]
        for future in concurrent.futures.as_completed(futures):
            result = future.result()
            results.append(result)
            print(f"{result['result']:5} {result['row']:34} {result['seconds']:6.2f} s  "
                  f"{'asked' if result['asked'] else 'bare'}: {', '.join(result['bare'])}", flush=True)
            for words in result["rates"]:
                print(f"        {words}", flush=True)
            for problem in result["problems"]:
                print(f"        {problem['way']}, seed {problem['seed']}: {problem['worse']}", flush=True)
    skipped += [(r["row"], "the bare host does not stand it") for r in results if r["result"] == "bare"]
    for name, why in skipped:
        print(f"skip  {name}: {why}")
    passed, failed = (sum(r["result"] == kind for r in results) for kind in ("pass", "FAIL"))
    print(f"processes: seed {first}")
    print(f"{passed} passed, {failed} failed, {len(skipped)} skipped")
    if arguments.json:
        arguments.json.write_text(json.dumps({"seed": first, "repeat": arguments.repeat, "passed": passed,
                                              "failed": failed, "skipped": [s[0] for s in skipped],
                                              "rows": results}, indent=2))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
