#!/usr/bin/env python3
"""Runs random sequences of several contexts that share objects, on the bare host and under the layer. Everything read
after each step must be equal, to the bit.

  run_sharing.py --build build                              the quick set, three back ends
  run_sharing.py --build build --count 10000 --jobs 16      that many sequences for each back end
  run_sharing.py --build build --first 41 --count 1         one of them
  run_sharing.py --build build --backend swrast --windows 0 one back end, no windows
  run_sharing.py --build build --planted                    also: is a command noticed that one side leaves out?

A share of the sequences (--windows, in percent) has GLX windows, which are shown and resized; the others have
pbuffers of EGL without a window system. A differing sequence is reduced: commands are removed as long as it still
differs. It is run twice on the bare host, and what differs between the two is ignored. Progress goes to the error
output. --json FILE writes the result as data. Ends with "N passed, N failed, N skipped".
"""

import collections
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

for folder in ("processes_vs_host", "rasterizer_vs_host"):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / folder))
import rates  # noqa: E402
import sides  # noqa: E402
from run_sequences import minimise  # noqa: E402

BACKENDS = ("host", "auto", "swrast")
TIMEOUT = 60  # seconds for a sequence


class Sides:
    """Runs the bare host and the layer with each back end."""

    def __init__(self, args, displays, scratch):
        self.client = args.build / "tests/sharing_vs_host/sharing-model"
        self.commands, self.displays = args.commands, displays
        # Images have a tile or two: more of the host's threads would only wait for one another.
        extra = {"LP_NUM_THREADS": "1"}
        self.environments = {
            "bare": sides.environment(extra={**extra, "XDG_CACHE_HOME": str(scratch / "host")})}
        for name in args.backend or BACKENDS:
            self.environments[name] = sides.environment(
                sides.layer_of(args.build), name, {**extra, "XDG_CACHE_HOME": str(scratch / name)})

    def words(self, windows, first, count, only=None, names=False):
        kept = [",".join(map(str, only))] if only is not None else []
        flags = (["--windows"] if windows else []) + (["--names"] if names else [])
        return [str(word) for word in (self.client, *flags, first, count, self.commands, *kept)]

    def run(self, side, windows, first, count, only=None, extra=None):
        """Returns {seed: its lines}; if the process ended within a sequence, its last line says so."""
        env = {**self.environments[side], **(extra or {})}
        if windows:
            env["DISPLAY"] = self.displays.name()
        results, last = {}, first + count
        while first < last:
            words = self.words(windows, first, last - first, only)
            try:
                done = subprocess.run(words, env=env, capture_output=True,
                                      timeout=TIMEOUT + 5 * (last - first))
                output, status, errors = done.stdout, done.returncode, done.stderr
            except subprocess.TimeoutExpired as late:
                output, status, errors = late.stdout or b"", "timeout", late.stderr or b""
            of_seed = collections.defaultdict(list)
            for line in output.decode(errors="replace").splitlines():
                of_seed[int(line.split(" ", 1)[0])].append(line)
            while first < last and of_seed[first] and of_seed[first][-1].startswith(f"{first} end\t"):
                results[first] = of_seed[first]
                first += 1
            if first < last:
                tail = errors.decode(errors="replace").strip()[-1500:]
                results[first] = of_seed[first] + [f"{first} ended: {status}: {tail}"]
                first += 1
        return results

    def differs(self, side, windows, seed, only):
        bare = self.run("bare", windows, seed, 1, only)[seed]
        return difference(bare, self.run(side, windows, seed, 1, only)[seed])

    def names(self, seed, only):
        words = self.words(False, seed, 1, only, names=True)
        return subprocess.run(words, capture_output=True, text=True, check=True).stdout.splitlines()


def ended(lines):
    return " ended: " in lines[-1].split("\t", 1)[0] if lines else False


def difference(bare, layer):
    """Returns the first line in which the layer's sequence differs from the bare host's; None if all are equal, or if
    the bare host's process ended."""
    if ended(bare):
        return None
    for got, expected in zip(layer, bare):
        if got != expected:
            return f"'{got}' is '{expected}' on the bare host"
    return None if len(bare) == len(layer) else f"{len(layer)} lines, bare host {len(bare)}"


class Count:
    """Counts the results and prints progress."""

    def __init__(self, sequences):
        self.lock, self.sequences, self.started = threading.Lock(), sequences, time.monotonic()
        self.done, self.skipped, self.said = 0, [], 0.0
        self.failures = []

    def add(self, done, failures, skipped):
        with self.lock:
            self.done += done
            self.failures += failures
            self.skipped += skipped
            now = time.monotonic()
            if now - self.said < 5 and self.done < self.sequences:
                return
            self.said = now
            print(f"{self.done} of {self.sequences} sequences, {len(self.failures)} differences, "
                  f"{now - self.started:.0f} s", file=sys.stderr, flush=True)


def batch(model, count, windows, first, size):
    backends = [side for side in model.environments if side != "bare"]
    bare = model.run("bare", windows, first, size)
    again = None
    failures, skipped = [], [(seed, side) for seed in bare if ended(bare[seed]) for side in backends]
    for side in backends:
        layer = model.run(side, windows, first, size)
        for seed in range(first, first + size):
            what = difference(bare[seed], layer[seed])
            if not what:
                continue
            again = again or model.run("bare", windows, first, size)
            if again[seed] != bare[seed] or bare_ends_so(model, side, windows, seed, layer[seed]):
                skipped.append((seed, side))  # a fault of the bare host
            else:
                failures.append({"seed": seed, "backend": side, "windows": windows, "what": what})
    count.add(size, failures, skipped)


def bare_ends_so(model, side, windows, seed, lines):
    """True if the bare host's process ends in that sequence too, in other runs, and as often as the layer's did. Mesa
    22.3.6 does so because of renderbuffers of deleted contexts."""
    def end(one):
        last = model.run(one, windows, seed, 1)[seed]
        return last[-1].split(": ")[1] if ended(last) else None
    if not ended(lines):
        return False
    worse, _ = rates.compare(lines[-1].split(": ")[1], lambda: end("bare"), lambda: end(side))
    return not worse


def reduce(model, failure):
    seed, side, windows = failure["seed"], failure["backend"], failure["windows"]
    kept = minimise(lambda only: bool(model.differs(side, windows, seed, only)),
                    list(range(model.commands)))
    failure["kept"] = kept
    failure["commands"] = model.names(seed, kept)
    failure["reduced"] = model.differs(side, windows, seed, kept)


def planted(model, seeds):
    """Returns (noticed, planted) of pixel commands near the end that one side leaves out, one for each seed."""
    kinds = ("texture quad", "TexSubImage", "CopyTexSubImage", "ReadPixels", "TexImage")
    seen = tried = 0
    for seed in seeds:
        numbers = [int(name.split(" ", 1)[0]) for name in model.names(seed, None)
                   if name.split(" ", 1)[1] in kinds]
        if not numbers:
            continue
        whole = model.run("bare", False, seed, 1)[seed]
        without = [n for n in range(model.commands) if n != numbers[-1]]
        seen += bool(difference(whole, model.run("bare", False, seed, 1, without)[seed]))
        tried += 1
    return seen, tried


def drawn(model, side, windows, scratch):
    """Returns how many draws the rasterizer made in one batch. Returns None if the layer is not there, so that the bare
    host was compared with itself."""
    path = scratch / f"stats-{windows}.json"
    model.run(side, windows, 1, 4, extra={"ARBITER_STATS": str(path)})
    return sides.software_statistics(path).get("drawn", 0)


def parse():
    parser = sides.options(__doc__)
    parser.add_argument("--backend", action="append", choices=BACKENDS)
    parser.add_argument("--first", type=int, default=1, help="seed")
    parser.add_argument("--count", type=int, default=48, help="seeds")
    parser.add_argument("--commands", type=int, default=60, help="of a sequence")
    parser.add_argument("--windows", type=int, default=25, metavar="PERCENT")
    parser.add_argument("--batch", type=int, default=12, help="sequences of a process")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reduce", type=int, default=3, help="how many failures are reduced")
    parser.add_argument("--planted", action="store_true", help="also test the test")
    parser.add_argument("--json", type=pathlib.Path, help="the result, to this file")
    parser.add_argument("--self-test", action="store_true")
    return parser.parse_args()


def self_test():
    end = ["7 1 ReadPixels\t4 aa", "7 end\t0 0"]
    assert difference(end, end) is None
    assert difference(end, ["7 1 ReadPixels\t4 ab", "7 end\t0 0"])
    assert difference(end, ["7 ended: -11: "])
    assert difference(["7 ended: -11: "], end) is None
    assert difference(end, end[:1])
    print("5 passed, 0 failed, 0 skipped")


def main():
    args = parse()
    if args.self_test:
        return self_test()
    args.build = args.build.resolve()
    backends = args.backend or BACKENDS
    bad = 0
    with tempfile.TemporaryDirectory(prefix="arbiter-sharing-") as folder, \
            sides.Displays() as displays, \
            concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        scratch = pathlib.Path(folder)
        model = Sides(args, displays, scratch)
        count = Count(args.count)
        # The last seeds have windows, so that a seed's kind is known from the command line.
        split = args.first + args.count - args.count * args.windows // 100
        jobs = []
        for start in range(args.first, args.first + args.count):
            if (start - (args.first if start < split else split)) % args.batch == 0:
                end = split if start < split else args.first + args.count
                jobs.append(pool.submit(batch, model, count, start >= split, start,
                                        min(args.batch, end - start)))
        for job in jobs:
            job.result()
        for failure in count.failures[:args.reduce]:
            reduce(model, failure)
        if args.planted:
            seen, tried = planted(model, range(args.first, args.first + 8))
            print(f"{seen} of {tried} commands that one side leaves out are seen")
            bad += seen < tried / 2
        rasterizing = [side for side in backends if side != "host"]
        for side, windows in [(side, windows) for side in rasterizing[-1:] for windows in (False, True)]:
            total = drawn(model, side, windows, scratch)
            print(f"of four sequences in {'windows of GLX' if windows else 'pbuffers of EGL'} the "
                  f"rasterizer drew {total}")
            bad += total == 0
    for failure in count.failures:
        print(f"FAIL seed {failure['seed']}, {failure['backend']}{', windows' if failure['windows'] else ''}: "
              f"{failure['what']}")
        if "kept" in failure:
            print(f"    reduced to {','.join(map(str, failure['kept']))}: {failure['reduced']}")
            for name in failure["commands"]:
                print(f"      {name}")
    seconds = time.monotonic() - count.started
    failed, skipped = len(count.failures) + bad, sorted(set(count.skipped))
    seeds = sorted({seed for seed, _ in skipped})
    if args.json:
        args.json.write_text(json.dumps(
            {"sequences": args.count, "commands": args.commands, "backends": list(backends),
             "windows_percent": args.windows, "failures": count.failures,
             "skipped": seeds, "seconds": round(seconds, 1)}, indent=2) + "\n")
    for seed, backend in skipped:
        print(f"skip seed {seed}, {backend}: the bare host fails or is not steady")
    print(f"{args.count} sequences a back end in {seconds:.0f} s; of the bare host's own making: "
          f"{len(seeds)}")
    print(f"{args.count * len(backends) - len(count.failures) - len(skipped)} passed, {failed} failed, "
          f"{len(skipped)} skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
