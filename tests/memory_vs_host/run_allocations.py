#!/usr/bin/env python3
"""Fails the Nth allocation of the layer in frames of every kind (allocation_scenes.cpp), for every N
(--every 1) or for a part of them, on each back end.

No process may end, a frame with a wrong picture must raise OUT_OF_MEMORY, and the next frame, with all memory, must be
right.

  run_allocations.py --build build [--every K] [--scene NAME] [--backend NAME] [--mode once|forgood]

Ends with "N passed, N failed, 0 skipped", where one is a scene on a back end in a mode.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "rasterizer_vs_host"))
import sides  # noqa: E402

TIMEOUT = 240
PART = 40  # failing allocations of one process: a frame with its own context takes a second
BACKENDS = ("host", "auto", "swrast")
MODES = ("once", "forgood")
# A compilation makes 23,000 allocations, most of them alike, so that N advances by this many times --every.
SPARSE = {"compiles": 37}


class Runner:
    """Runs a scene on a back end, with or without failing allocations."""

    def __init__(self, build, scene, backend):
        self.build, self.scene, self.backend = build, scene, backend

    def process(self, display, first, every, count, mode):
        """Returns (status, lines, standard error, draws of the rasterizer)."""
        client = self.build / "tests/memory_vs_host/rasterizer-allocations"
        failing = self.build / "tests/memory_vs_host/libfailing_memory.so"
        with tempfile.TemporaryDirectory(prefix="arbiter-memory-") as folder:
            stats = pathlib.Path(folder) / "stats.json"
            env = sides.environment(sides.layer_of(self.build), self.backend,
                                    {"DISPLAY": display, "XDG_CACHE_HOME": folder, "ARBITER_THREADS": "2",
                                     # the count must not depend on the machine's load
                                     "ARBITER_DEBUG": "steady", "ARBITER_STATS": str(stats)})
            env["LD_PRELOAD"] = f"{failing}:{env['LD_PRELOAD']}"
            command = [str(client), self.scene, str(first), str(every), str(count), mode]
            try:
                result = subprocess.run(command, env=env, capture_output=True, timeout=TIMEOUT)
            except subprocess.TimeoutExpired as late:
                return "hangs", (late.stdout or b"").decode().splitlines(), "", 0
            drawn = sides.software_statistics(stats).get("drawn", 0)
        return (result.returncode, result.stdout.decode().splitlines(),
                result.stderr.decode(errors="replace"), drawn)

    def allocations(self, display):
        """Returns (the most allocations of a frame, what is wrong already)."""
        status, lines, errors, drawn = self.process(display, 10**9, 1, 1, "once")
        done = done_line(lines)
        if status != 0 or not done:
            return 0, [f"with all memory the process ends ({status}) {errors[-200:]}"]
        if self.backend != "host" and not drawn:
            return 0, ["the rasterizer draws nothing"]
        return int(done[2]), []

    def part(self, display, first, end, every, mode):
        """Returns (how many frames were tried, what is wrong): numbers `first`, `first + every`, .. below `end`."""
        tried, wrong, at, unreached = 0, [], first, 0
        while at < end and len(wrong) <= 40 and unreached < 3:
            count = (end - at + every - 1) // every
            status, lines, errors, _ = self.process(display, at, every, count, mode)
            numbers = [int(line.split()[1]) for line in lines if line.startswith("at ")]
            tried += len(numbers)
            wrong += [line[7:] for line in lines if line.startswith("wrong: ")]
            done = done_line(lines)
            if done and status == 0:
                # The process ends early at a frame with fewer allocations: after one failure (of a compiler) it does
                # not try again, but the next process does.
                last = int(done[1])
                unreached = 0 if last >= at else unreached + 1
                at = max(last, at) + every
                continue
            tail = re.sub(r"\s+", " ", errors)[-200:]
            wrong.append(f"at {numbers[-1] if numbers else 0}: the process ends ({status}) {tail}")
            if not numbers:
                break
            at = numbers[-1] + every
        return tried, wrong


def done_line(lines):
    return next((line.split() for line in lines if line.startswith("done: ")), None)


def main():
    parser = sides.options(__doc__)
    parser.add_argument("--every", type=int, default=1, help="every K-th allocation fails in turn")
    parser.add_argument("--scene", action="append")
    parser.add_argument("--backend", action="append", choices=BACKENDS)
    parser.add_argument("--mode", action="append", choices=MODES)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    client = str(build / "tests/memory_vs_host/rasterizer-allocations")
    scenes = arguments.scene or subprocess.run([client, "--list"], capture_output=True, text=True,
                                               check=True).stdout.split()
    pairs = [(scene, backend) for scene in scenes for backend in arguments.backend or BACKENDS]
    modes = arguments.mode or MODES
    every, reports, tally = arguments.every, [], sides.Tally()
    with sides.Displays() as displays, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        counted = list(pool.map(
            lambda pair: Runner(build, *pair).allocations(displays.name()), pairs))
        parts = {}
        for pair, (most, wrong) in zip(pairs, counted):
            step = every * SPARSE.get(pair[0], 1)
            # A frame with failures may make more allocations than one without.
            end = 1 if wrong else most + most // 10 + 2
            for mode in modes:
                parts[pair, mode] = [
                    pool.submit(lambda r, *what: r.part(displays.name(), *what),
                                Runner(build, *pair), at, min(at + step * PART, end), step, mode)
                    for at in range(1, end, step * PART)]
        for pair, (most, before) in zip(pairs, counted):
            for mode in modes:
                results = [part.result() for part in parts[pair, mode]]
                wrong = before + [line for _, lines in results for line in lines]
                report = {"scene": pair[0], "backend": pair[1], "mode": mode, "allocations": most,
                          "failed": sum(tried for tried, _ in results), "wrong": wrong}
                reports.append(report)
                tally.row(f"{report['scene']} {report['backend']} {mode}: {report['failed']} frames of up to {most} "
                          "allocations", wrong, 12)
    if arguments.json:
        arguments.json.parent.mkdir(parents=True, exist_ok=True)
        arguments.json.write_text(json.dumps({"every": arguments.every, "scenes": reports}, indent=1))
    frames = sum(report["failed"] for report in reports)
    print(f"{frames} frames in which an allocation failed")
    return tally.end() or not frames


if __name__ == "__main__":
    sys.exit(main())
