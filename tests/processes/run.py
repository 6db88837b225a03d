#!/usr/bin/env python3
"""The matrix of foreign processes: each row is something that programs do to themselves (ends.cpp,
surroundings.cpp, forks.cpp, threads.cpp), run on the bare host and under the layer with each back end.
None may be worse than bare: the same end, the same output, the same picture within a step, in time.

  tests/processes/run.py --build build                     all
  tests/processes/run.py --build build --only exit         rows that have "exit" in their name
  tests/processes/run.py --build build --repeat 20         each row that comes from aside 20 times
  tests/processes/run.py --build build --seed 1234         as a failure named it

Prints a table, and with --json writes it. Exit status 1 if a row is worse than bare.
"""
import argparse
import concurrent.futures
import json
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
from x_server import XServer  # noqa: E402

WAYS = ("host", "auto", "swrast")
TIMEOUT = 60
# Rows in which something comes at any time, by the seed.
FROM_ASIDE = ("drawing", "compiling", "draws", "longjmp", "sig")
ALLOCATORS = {"jemalloc": "libjemalloc.so.2", "tcmalloc": "libtcmalloc_minimal.so.4"}


class Row:
    def __init__(self, name, mode, client="foreign", preload=None, wrapper=(), environment=None):
        self.name, self.mode, self.client = name, mode, client
        self.preload, self.wrapper, self.environment = preload, wrapper, environment or {}
        self.repeats = any(word in mode for word in FROM_ASIDE) and mode != "handler-draws"


def library(name):
    """The path of a library of this machine's, or None."""
    listing = subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True).stdout
    return next((line.split()[-1] for line in listing.splitlines() if line.split()[:1] == [name]), None)


def comma_locale(scratch):
    """A folder with a locale that writes 0,5, or None where it cannot be made."""
    made = subprocess.run(["localedef", "--no-archive", "-i", "de_DE", "-f", "UTF-8",
                           str(scratch / "de_DE.UTF-8")], capture_output=True) \
        if shutil.which("localedef") else None
    return scratch if made and (scratch / "de_DE.UTF-8").is_dir() else None


def all_rows(build, scratch):
    """The rows, and what of them this machine cannot run."""
    listing = subprocess.run([build / "tests/processes/foreign"], capture_output=True, text=True, check=True)
    rows, skipped = [], []
    for mode in listing.stdout.split():
        if mode == "draw-for-ever":  # statistics.py's
            continue
        if mode == "comma-locale":
            folder = comma_locale(scratch)
            if not folder:
                skipped.append((mode, "no localedef, or no sources of de_DE (package locales)"))
                continue
            rows.append(Row(mode, mode, environment={"LOCPATH": str(folder), "FOREIGN_LOCALE": "de_DE.UTF-8"}))
        else:
            rows.append(Row(mode, mode))
    for mode in ("plain", "exit-in-handler-compiling", "fork-child-exits", "thread-ends-with-context"):
        rows.append(Row(f"own-allocator:{mode}", mode, client="foreign_own_allocator"))
    for name, file in ALLOCATORS.items():
        path = library(file)
        if path:
            rows.append(Row(f"{name}:plain", "plain", preload=path))
        else:
            skipped.append((name, f"{file} is not installed"))
    rows.append(Row("egl:plain", "plain", environment={"FOREIGN_EGL": "1"}))
    rows.append(Row("no-home", "plain", environment={"HOME": None, "XDG_CACHE_HOME": None}))
    rows.append(Row("read-only-home", "plain", environment={"HOME": "/proc", "XDG_CACHE_HOME": None}))
    return rows, skipped


def environment_of(row, way, build, display, scratch, seed):
    env = {k: v for k, v in os.environ.items() if not k.startswith(("ARBITER_", "__GLX_", "__EGL_", "LD_"))}
    env.update(DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1", XDG_CACHE_HOME=str(scratch / "cache"),
               MESA_SHADER_CACHE_DISABLE="true", FOREIGN_SEED=str(seed))
    preload = [row.preload] if row.preload else []
    if way != "bare":
        preload.insert(0, str(build / "src/interposer/libGLX_arbiter.so.0"))
        env.update(ARBITER_BACKEND=way, ARBITER_THREADS="3",
                   ARBITER_STATS=str(scratch / f"stats-{row.name.replace('/', '_')}-{way}-{seed}.json"))
    if preload:
        env["LD_PRELOAD"] = ":".join(preload)
    for name, value in row.environment.items():
        env.pop(name, None)
        if value is not None:
            env[name] = value
    return env


def run_once(row, way, build, display, scratch, seed):
    """How the process ended ("exit 7", "SIGTERM", "hangs"), its lines of output, its errors."""
    command = [*row.wrapper, build / "tests/processes" / row.client, row.mode]
    process = subprocess.Popen(command, env=environment_of(row, way, build, display, scratch, seed),
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, errors="replace", start_new_session=True, cwd=scratch)
    try:
        out, err = process.communicate(timeout=TIMEOUT)
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
    """None, or how `layer` is worse than `bare`."""
    if layer[0] != bare[0]:
        return f"{layer[0]}, bare {bare[0]}: {layer[2].strip()[-300:]}"
    if len(layer[1]) != len(bare[1]):
        return f"{len(layer[1])} lines of output, bare {len(bare[1])}"
    for number, (one, other) in enumerate(zip(layer[1], bare[1]), 1):
        if not same_line(one, other):
            return f"line {number}: {one[:60]!r}, bare {other[:60]!r}"
    return None


def gave_up(result):
    """The bare host itself does not stand the row: nothing can be worse."""
    return result[0] in ("hangs", "SIGSEGV", "SIGABRT", "SIGBUS", "SIGILL", "SIGFPE", "exit 4")


# The host's destructors wait for its threads, which a child of fork() has not, and hang now and then;
# and they destroy what another thread still compiles with: bare, one run of 16 ends by SIGSEGV.
HOST_MAY_FAIL = {"fork-child-exits": "hangs", "exit-in-thread-compiling": "SIGSEGV"}


def expected_end(mode):
    """A row that is to end so is not given up by the bare host because it does."""
    return mode.startswith(("abort", "sigsegv"))


def run_row(row, build, display, scratch, seeds):
    begin = time.monotonic()
    problems, bare_ends = [], set()
    for seed in seeds if row.repeats else seeds[:1]:
        bare = run_once(row, "bare", build, display, scratch, seed)
        bare_ends.add(bare[0])
        for way in WAYS:
            layer = run_once(row, way, build, display, scratch, seed)
            worse = difference(bare, layer)
            for _ in range(3 if row.mode in HOST_MAY_FAIL else 0):
                if layer[0] == HOST_MAY_FAIL[row.mode]:
                    layer = run_once(row, way, build, display, scratch, seed)
                    worse = difference(bare, layer)
            if worse and gave_up(bare) and not expected_end(row.mode):
                continue
            if worse:
                problems.append({"way": way, "seed": seed, "worse": worse})
    return {"row": row.name, "result": "FAIL" if problems else "pass", "bare": sorted(bare_ends),
            "problems": problems, "seconds": round(time.monotonic() - begin, 2)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build"))
    parser.add_argument("--only", action="append", help="part of a row's name; may be repeated")
    parser.add_argument("--repeat", type=int, default=2)
    parser.add_argument("--seed", type=int, help="the first seed; by chance if it is not given")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    first = arguments.seed if arguments.seed is not None else random.SystemRandom().randrange(1, 1_000_000)
    seeds = list(range(first, first + arguments.repeat))
    results = []
    with XServer() as display, tempfile.TemporaryDirectory(prefix="arbiter-processes-") as folder, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        scratch = Path(folder)
        rows, skipped = all_rows(build, scratch)
        if arguments.only:
            rows = [r for r in rows if any(o in r.name for o in arguments.only)]
            if not rows:
                sys.exit(f"processes: no row has {' or '.join(arguments.only)} in its name")
        for future in [pool.submit(run_row, r, build, display, scratch, seeds) for r in rows]:
            result = future.result()
            results.append(result)
            print(f"{result['result']:5} {result['row']:34} {result['seconds']:6.2f} s  bare: "
                  f"{', '.join(result['bare'])}", flush=True)
            for problem in result["problems"]:
                print(f"        {problem['way']}, seed {problem['seed']}: {problem['worse']}", flush=True)
    for name, why in skipped:
        print(f"skip  {name:34} {why}")
    failed = sum(r["result"] == "FAIL" for r in results)
    print(f"processes: {len(results) - failed} passed, {failed} failed, {len(skipped)} skipped; seed {first}")
    if arguments.json:
        arguments.json.write_text(json.dumps({"seed": first, "repeat": arguments.repeat, "passed": len(results) - failed,
                                              "failed": failed, "skipped": [s[0] for s in skipped],
                                              "rows": results}, indent=2))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
