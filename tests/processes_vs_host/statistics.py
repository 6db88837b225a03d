#!/usr/bin/env python3
"""Tests statistics and logs of processes that end in any way. The files of `arbiter run --stats --log` must exist, be
complete, and count the frames that were drawn; and `arbiter run` itself must end as its command does.

usage: statistics.py --build BUILD [--only NAME]
"""
import argparse
import concurrent.futures
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "clients"))
from plain_environment import heed_signals, plain  # noqa: E402
from x_server import XServer  # noqa: E402

TIMEOUT = 60


class Failure(Exception):
    pass


class Case:
    """A run of `arbiter run --stats FILE --log FILE -- foreign MODE`."""

    def __init__(self, build, display, scratch):
        self.build, self.scratch = build, scratch
        self.stats, self.log = scratch / "stats.json", scratch / "log.txt"
        self.env = plain(DISPLAY=display, XDG_CACHE_HOME=str(scratch / "cache"))

    def foreign(self, mode):
        client = "foreign_watched" if "-layer-" in mode else "foreign"
        return [str(self.build / "tests/processes_vs_host" / client), mode]

    def start(self, command, stats=None):
        self.env["FOREIGN_SEED"] = str(int(time.time() * 1000) % 100000)
        return subprocess.Popen([self.build / "src/apps/tools/arbiter", "run", "--stats", stats or self.stats,
                                 "--log", f"info:{self.log}", "--", *command], env=self.env,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True)

    def run(self, command, expected, stats=None):
        process = self.start(command, stats)
        out, err = process.communicate(timeout=TIMEOUT)
        need(process.returncode == expected, f"ended as {process.returncode}, not {expected}: {err[-300:]}")
        return out

    def reports(self):
        """Returns all written reports, once no record is left."""
        for _ in range(1200):  # a minute, as the machine may be busy
            if not list(self.scratch.glob("*.running")):
                break
            time.sleep(0.05)
        left = [p.name for p in self.scratch.glob("*.running")] + [p.name for p in self.scratch.glob("*.tmp")]
        need(not left, f"left behind: {left}")
        return [json.loads(p.read_text()) for p in sorted(self.scratch.glob("stats*"))]

    def report(self):
        reports = self.reports()
        need(len(reports) == 1, f"{len(reports)} reports")
        need(len(reports[0]["programs"]) >= 2, "programs are missing")
        need(reports[0]["contexts"] and reports[0]["contexts"][0]["offered"], "the context is missing")
        need(reports[0]["frames"] >= 1, "no frame is counted")
        need(sum(reports[0]["draws"][k] for k in ("host_glsl", "host_assembly", "rasterizer")) >= reports[0]["frames"],
             "draws are missing")
        need("front of" in self.log.read_text(), "the log is missing")
        return reports[0]


def need(good, text):
    if not good:
        raise Failure(text)


def ended_by(mode, expected):
    def case(c):
        c.run(c.foreign(mode), expected)
        c.report()
    return case


def sent(number, to_command):
    """Sends a signal from outside, to `arbiter run` or to the command itself."""
    def case(c):
        process = c.start(c.foreign("draw-for-ever"))
        line = process.stdout.readline()  # its process number
        need(line.startswith("drawing "), f"no frame: {line!r}")
        os.kill(int(line.split()[1]) if to_command else process.pid, number)
        out, err = process.communicate(timeout=TIMEOUT)
        need(process.returncode == -number, f"ended as {process.returncode}: {err[-300:]}")
        c.report()
        try:
            os.kill(int(line.split()[1]), 0)
            raise Failure("the command lives on")
        except ProcessLookupError:
            pass
    return case


def without_run(c):
    """Tests the layer alone: `arbiter stats` makes the report of a process that was killed."""
    env = dict(c.env, LD_PRELOAD=str(c.build / "src/interposer/libGLX_arbiter.so.0"),
               ARBITER_STATS=str(c.stats), ARBITER_LOG=f"info:{c.log}", FOREIGN_SEED="5")
    code = subprocess.run(c.foreign("sigkill"), env=env, timeout=TIMEOUT).returncode
    need(code == -signal.SIGKILL, f"ended as {code}")
    need(not c.stats.exists() and list(c.scratch.glob("*.running")), "nothing was left to be completed")
    made = subprocess.run([c.build / "src/apps/tools/arbiter", "stats", c.scratch / "none.json", c.stats],
                          capture_output=True, text=True)
    need(made.returncode == 0 and made.stdout.startswith("made of what killed processes left: 1\n"),
         f"arbiter stats: {made}")
    c.report()
    again = subprocess.run([c.build / "src/apps/tools/arbiter", "stats", "--json", c.stats], capture_output=True,
                           text=True)
    need(json.loads(again.stdout)["made"] == 0, "there was something to be completed twice")


def several(c):
    """Tests children that are killed one after the other, by their numbers."""
    one = " ".join(c.foreign("sigkill"))
    c.run(["sh", "-c", f"{one}; {one}; exit 3"], 3, stats=c.scratch / "stats-%p.json")
    reports = c.reports()
    need(len(reports) == 2, f"{len(reports)} reports of two processes")
    need(len({r["pid"] for r in reports}) == 2, "two reports of one process")


def executed(c):
    """Tests a program that executes another: both are reported."""
    c.run(c.foreign("exec-itself"), 0)
    need(len(c.reports()) == 2, "one of two programs is missing")


def forked(c):
    """Tests a child forked during a frame. The host's own exit() sometimes hangs there, so that the child executes
    another program instead."""
    c.run(c.foreign("fork-child-execs-drawing"), 0)
    reports = c.reports()
    need(len(reports) == 2 and reports[0]["pid"] != reports[1]["pid"], f"{len(reports)} reports of two")


def stopped(c):
    """Tests that a command that stops is seen to stop, and continues."""
    process = c.start(c.foreign("draw-for-ever"))
    child = int(process.stdout.readline().split()[1])
    os.kill(child, signal.SIGSTOP)
    pid, status = os.waitpid(process.pid, os.WUNTRACED)
    need(os.WIFSTOPPED(status), "it does not stop")
    os.kill(process.pid, signal.SIGCONT)
    need("State:\tT" not in Path(f"/proc/{child}/status").read_text() or time.sleep(1) or
         "State:\tT" not in Path(f"/proc/{child}/status").read_text(), "it does not go on")
    os.kill(process.pid, signal.SIGTERM)
    process.communicate(timeout=TIMEOUT)
    need(process.returncode == -signal.SIGTERM, f"ended as {process.returncode}")
    c.report()


def no_command(c):
    c.run(["/nonexistent/command"], 127)


CASES = {
    "return": ended_by("return-from-main", 0), "exit-in-handler": ended_by("exit-in-layer-drawing", 7),
    "exit-in-handler-compiling": ended_by("exit-in-layer-compiling", 7),
    "_exit": ended_by("_exit-in-handler-drawing", 7), "quick_exit": ended_by("quick_exit-in-handler-drawing", 7),
    "exit-in-thread": ended_by("exit-beside-layer-drawing", 7),
    "exit-in-thread-compiling": ended_by("exit-beside-layer-compiling", 7),
    "abort": ended_by("abort-in-thread-drawing", -signal.SIGABRT),
    "sigkill-compiling": ended_by("sigkill-compiling", -signal.SIGKILL),
    **{f"own-{s.name}": ended_by(s.name.lower(), -s) for s in (
        signal.SIGINT, signal.SIGTERM, signal.SIGPIPE, signal.SIGXFSZ, signal.SIGKILL, signal.SIGSEGV)},
    **{f"{s.name}-to-run": sent(s, False) for s in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL)},
    **{f"{s.name}-to-command": sent(s, True) for s in (signal.SIGINT, signal.SIGKILL)},
    "without-run": without_run, "several": several, "executed": executed, "forked": forked,
    "stopped": stopped, "no-command": no_command,
}


def run_case(name, build, display):
    with tempfile.TemporaryDirectory(prefix="arbiter-statistics-") as folder:
        try:
            CASES[name](Case(build, display, Path(folder)))
            return None
        except (Failure, subprocess.TimeoutExpired, ValueError, IndexError) as failure:
            return f"{type(failure).__name__}: {failure}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build"))
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    heed_signals()
    chosen = [n for n in CASES if not arguments.only or any(o in n for o in arguments.only)]
    failed = 0
    with XServer() as display, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        futures = {n: pool.submit(run_case, n, arguments.build.resolve(), display) for n in chosen}
        for name, future in futures.items():
            failed += future.result() is not None
            print(f"{'FAIL' if future.result() else 'pass':5} {name:28} {future.result() or ''}", flush=True)
    print(f"{len(chosen) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed or not chosen else 0


if __name__ == "__main__":
    sys.exit(main())
