#!/usr/bin/env python3
"""Fails the Nth allocation of the layer's in frames of every kind (allocation_scenes.cpp), for every N
(--every 1) or for a part of them, on each back end. No process may end, a frame that is not as it should
be must raise OUT_OF_MEMORY, and the next frame, with all memory there is, must be right.

  run_allocations.py --build build [--every K] [--scene NAME] [--backend NAME] [--mode once|forgood]

Ends with "N passed, N failed, 0 skipped", where one is a scene on a back end in a mode.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "software"))
import sides  # noqa: E402

TIMEOUT = 240
PART = 60  # failing allocations of one process: a frame with its own context takes a second
BACKENDS = ("host", "auto", "swrast")
MODES = ("once", "forgood")


def one_process(command, env):
    """(status, the lines that it wrote)."""
    try:
        result = subprocess.run(command, env=env, capture_output=True, timeout=TIMEOUT)
    except subprocess.TimeoutExpired as late:
        return "hangs", (late.stdout or b"").decode().splitlines(), ""
    return result.returncode, result.stdout.decode().splitlines(), result.stderr.decode(errors="replace")


def run_scene(build, scene, backend, mode, every, display, most=10**9):
    """A report of all failing allocations of a scene."""
    client = build / "tests/memory/software-allocations"
    failing = build / "tests/memory/libfailing_memory.so"
    report = {"scene": scene, "backend": backend, "mode": mode, "allocations": 0, "failed": 0, "wrong": []}
    with tempfile.TemporaryDirectory(prefix="arbiter-memory-") as folder:
        env = sides.environment(sides.layer_of(build), backend,
                                {"DISPLAY": display, "XDG_CACHE_HOME": folder, "ARBITER_THREADS": "2"})
        env["LD_PRELOAD"] = f"{failing}:{env['LD_PRELOAD']}"
        at = 1
        while at < most:
            status, lines, errors = one_process(
                [str(client), scene, str(at), str(every), str(PART), mode], env)
            tried = [int(line.split()[1]) for line in lines if line.startswith("at ")]
            report["failed"] += len(tried)
            report["wrong"] += [line[7:] for line in lines if line.startswith("wrong: ")]
            done = next((line for line in lines if line.startswith("done: ")), None)
            if not done:
                where = tried[-1] if tried else 0
                tail = re.sub(r"\s+", " ", errors)[-200:]
                report["wrong"].append(f"at {where}: the process ends ({status}) {tail}")
                if not tried or len(report["wrong"]) > 40:
                    break
                at = where + every
                continue
            _, last, made = done.split()
            report["allocations"] = max(report["allocations"], int(made))
            at += every * PART
            if int(last) + every < at:
                break
    return report


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build"))
    parser.add_argument("--every", type=int, default=1, help="every K-th allocation fails in turn")
    parser.add_argument("--scene", action="append")
    parser.add_argument("--backend", action="append", choices=BACKENDS)
    parser.add_argument("--mode", action="append", choices=MODES)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    client = str(build / "tests/memory/software-allocations")
    scenes = arguments.scene or subprocess.run([client, "--list"], capture_output=True, text=True,
                                               check=True).stdout.split()
    jobs = [(scene, backend, mode) for scene in scenes for backend in arguments.backend or BACKENDS
            for mode in arguments.mode or MODES]
    reports, failed = [], 0
    with sides.Displays() as displays, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for report in pool.map(
                lambda job: run_scene(build, *job, arguments.every, displays.name()), jobs):
            reports.append(report)
            failed += bool(report["wrong"])
            print(f"{'FAIL' if report['wrong'] else 'pass'} {report['scene']} {report['backend']} "
                  f"{report['mode']}: {report['failed']} frames, up to {report['allocations']} "
                  f"allocations each", flush=True)
            for line in report["wrong"][:12]:
                print(f"     {line}", flush=True)
    if arguments.json:
        arguments.json.parent.mkdir(parents=True, exist_ok=True)
        arguments.json.write_text(json.dumps({"every": arguments.every, "scenes": reports}, indent=1))
    frames = sum(report["failed"] for report in reports)
    print(f"{frames} frames in which an allocation failed")
    print(f"{len(reports) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed or not frames else 0


if __name__ == "__main__":
    sys.exit(main())
