#!/usr/bin/env python3
"""Runs every suite on one commit, over as many sittings as it takes.

usage: release.py [SUITE...]     those that have no result of this commit yet, or of the named ones
       --list                    the suites, with what is known of each
       --again                   also those that have a result
       --sitting MINUTES         begins no suite that would end later than that from now
       --published FILE         results of other machines, as docs/results/collect.py writes them: suites whose result
                                stands are not run again. docs/results/results.json by default
       --engine NAME ...         --shards, --hosts and --engine-option too, for the suites that take them

A result is out/release/COMMIT/SUITE.json, written when its suite has ended, with SUITE.log beside it. It stands on
later commits until a file changes that the suite reads, which the table of suites says. A run that is
ended by a signal leaves no result of the suite that was under way, so the same command goes on with that one. The
tree must be as the commit has it, before a suite and after it. release.json has the table that is printed at the
end. The status is 0 if every suite has passed, 1 if one has failed, and 3 if one has not been run.
"""

import argparse
import contextlib
import ctypes
import datetime
import fcntl
import fnmatch
import functools
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[1]
SUITES = ROOT / "scripts" / "release_suites.toml"
COUNTS = ("passed", "failed", "skipped")
LAST_LINE = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
NOT_RUN = 3
# Runs a command; when this is to end, all that the command has started ends. A shell has its background commands
# ignore interrupts, which tests send.
GROUP = """trap 'trap "" TERM; kill -TERM 0; exit 143' TERM; env --default-signal=INT,QUIT "$@" & wait $!"""


def suites_of(path):
    """Returns the rows of the table of suites, in its order, each with patterns of the files that it does not read."""
    table = tomllib.loads(path.read_text())
    rows = table["suite"]
    names = [row["name"] for row in rows]
    if len(set(names)) < len(names):
        sys.exit(f"{path.name}: a suite is named twice")
    for files in table.get("files", []):
        if unknown := set(files["read_by"]) - set(names):
            sys.exit(f"{path.name}: no suite {', '.join(sorted(unknown))}, which reads {files['paths'][0]}")
    for row in rows:
        row["unread"] = [each for files in table.get("files", []) if row["name"] not in files["read_by"]
                         for each in files["paths"]]
    return rows


def git(root, *words):
    """Returns the output of a git command, without its last newline."""
    done = subprocess.run(["git", "-C", str(root), *words], check=True, capture_output=True, text=True)
    return done.stdout.rstrip("\n")


def commit_of(root):
    """Returns the commit that the tree is of; ends the program where a file differs from it."""
    changed = git(root, "status", "--porcelain")
    if changed:
        sys.exit("release: the tree is not as a commit has it:\n" + changed)
    return git(root, "rev-parse", "HEAD")


@functools.cache
def changed_between(root, earlier, later):
    """Returns the paths that differ between two commits, None if the one is no ancestor of the other."""
    try:
        git(root, "merge-base", "--is-ancestor", earlier, later)
    except subprocess.CalledProcessError:
        return None
    return git(root, "diff", "--name-only", "--no-renames", earlier, later).splitlines()


def is_unread(path, patterns):
    """Returns whether a pattern names a file. What Meson reads, each suite that builds reads."""
    return not path.endswith("meson.build") and any(fnmatch.fnmatch(path, each) for each in patterns)


def first_line(*command):
    """Returns the first line that the command prints, "" where there is none."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except (OSError, subprocess.TimeoutExpired):
        return ""
    return (done.stdout.splitlines() or [""])[0]


def print_renderer():
    """Prints the names of the GL renderer and version, by a context without a window."""
    egl, gl = ctypes.CDLL("libEGL.so.1"), ctypes.CDLL("libOpenGL.so.0")
    for function in (egl.eglGetDisplay, egl.eglCreateContext):
        function.restype = ctypes.c_void_p
    gl.glGetString.restype = ctypes.c_char_p
    display = ctypes.c_void_p(egl.eglGetDisplay(None))
    egl.eglInitialize(display, None, None)
    egl.eglBindAPI(0x30A2)  # EGL_OPENGL_API
    context = ctypes.c_void_p(egl.eglCreateContext(display, None, None, None))
    egl.eglMakeCurrent(display, None, None, context)
    for name in (0x1F01, 0x1F02):  # GL_RENDERER, GL_VERSION
        print(gl.glGetString(name).decode())


def renderer():
    """Returns the names of the GL renderer and version that the suites draw with, "" where they are not known."""
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "EGL_PLATFORM": "surfaceless"}
    done = subprocess.run([sys.executable, __file__, "--renderer"], capture_output=True, text=True, env=environment)
    lines = done.stdout.splitlines()
    return lines if done.returncode == 0 and len(lines) == 2 else ["", ""]


def machine():
    """Returns what results of this environment depend on besides the commit."""
    system = ""
    for line in pathlib.Path("/etc/os-release").read_text().splitlines():
        if line.startswith("PRETTY_NAME="):
            system = line.split("=", 1)[1].strip('"')
    name, version = renderer()
    return {"renderer": name, "version": version, "compiler": first_line("g++", "--version"), "system": system,
            "processor": os.uname().machine, "cores": os.cpu_count()}


def machine_of(root):
    """Returns the machine that a suite's verb has left as its own, else that of this environment."""
    left = root / "out" / "test" / ".machine"
    return json.loads(left.read_text()) if left.exists() else machine()


class Release:
    """The results of one commit, and the suites that make them."""

    def __init__(self, root, suites, commit, out, published=()):
        self.root, self.suites, self.commit = root, suites, commit
        self.published = published
        self.folder = out / commit
        self.folder.mkdir(parents=True, exist_ok=True)

    def local(self, suite):
        """Returns the results that the suite has had here, of any commit."""
        rows = []
        for path in self.folder.parent.glob(f"*/{suite['name']}.json"):
            with contextlib.suppress(json.JSONDecodeError):
                rows.append(json.loads(path.read_text()))
        return rows

    def result(self, suite):
        """Returns the suite's result of this commit, else the last one of an earlier commit that stands, else None."""
        published = [row for row in self.published if row["suite"] == suite["name"]]
        rows = [row for row in self.local(suite) + published if self.stands(row, suite)]
        own = [row for row in rows if row["commit"] == self.commit]
        return own[0] if own else max(rows, key=lambda row: row["date"], default=None)

    def stands(self, row, suite):
        """Returns whether a result is of the suite's command, and no file that it reads has changed since."""
        changed = changed_between(self.root, row["commit"], self.commit)
        command = row.get("command", suite["command"])
        return (command[:len(suite["command"])] == suite["command"] and changed is not None
                and all(is_unread(path, suite["unread"]) for path in changed))

    def minutes(self, suite):
        """Returns how long the suite takes here: by the last run that passed, on any commit, else by the table."""
        done = [row for row in self.local(suite) if passed(row)]
        return max(done, key=lambda row: row["date"])["seconds"] / 60 if done else suite["minutes"]

    def parts(self):
        """Returns the counts that the suite's verb has left."""
        return [json.loads(path.read_text()) for path in sorted((self.root / "out" / "test").glob("*.json"))]

    def run(self, suite, options, place):
        """Runs a suite to its end and writes its result."""
        command = suite["command"] + (options if suite.get("engine") else [])
        for old in [*(self.root / "out" / "test").glob("*.json"), self.root / "out" / "test" / ".machine"]:
            old.unlink(missing_ok=True)
        log = self.folder / f"{suite['name']}.log"
        started, date = time.monotonic(), datetime.datetime.now(datetime.timezone.utc)
        status = self.follow(command, log, place)
        if commit_of(self.root) != self.commit:
            sys.exit(f"release: the tree became another commit while {suite['name']} ran: no result")
        result = {"schema": 1, "suite": suite["name"], "command": command, "commit": self.commit,
                  "date": date.strftime("%Y-%m-%dT%H:%M:%SZ"), "seconds": round(time.monotonic() - started),
                  "status": status, **summed(self.parts(), status, log.read_text(errors="replace")),
                  "machine": machine_of(self.root)}
        write(self.folder / f"{suite['name']}.json", result)
        return result

    def follow(self, command, log, place):
        """Runs a command with its output in a file, and says every minute where it is. Returns its status.

        The command ends with this program, however that ends."""
        with log.open("wb") as out:
            child = subprocess.Popen(["setpriv", "--pdeathsig", "TERM", "sh", "-c", GROUP, "sh", *command],
                                     cwd=self.root, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                     start_new_session=True)
        started = time.monotonic()
        try:
            while True:
                try:
                    return child.wait(timeout=60)
                except subprocess.TimeoutExpired:
                    print(f"    {place} {(time.monotonic() - started) / 60:4.0f} min  {last_words(log)}", flush=True)
        except BaseException:
            os.killpg(child.pid, signal.SIGTERM)
            child.wait()
            raise

    def table(self):
        """Prints what is known of every suite, writes release.json, and returns the status of the whole."""
        rows = []
        print(f"\n{'suite':<14} {'passed':>8} {'failed':>7} {'skipped':>8} {'minutes':>8}  result")
        for suite in self.suites:
            result = self.result(suite)
            if result is None:
                rows.append({"suite": suite["name"], "result": "not run"})
                print(f"{suite['name']:<14} {'':>8} {'':>7} {'':>8} {'':>8}  not run")
                continue
            word = "passed" if passed(result) else "failed"
            rows.append({key: result[key] for key in ("suite", *COUNTS, "seconds", "date", "commit")} |
                        {"result": word})
            word += "" if result["commit"] == self.commit else f" at {result['commit'][:12]}"
            print(f"{suite['name']:<14} {result['passed']:>8} {result['failed']:>7} {result['skipped']:>8} "
                  f"{result['seconds'] / 60:>8.0f}  {word}")
        write(self.folder / "release.json", {"commit": self.commit, "suites": rows})
        words = [row["result"] for row in rows]
        return 1 if "failed" in words else NOT_RUN if "not run" in words else 0


def summed(parts, status, log):
    """Returns the counts of a suite: of its parts, of the last line that has counts, or of its end alone."""
    counts = {key: sum(part[key] for part in parts) for key in COUNTS}
    lines = LAST_LINE.findall(log)
    if not parts and lines:
        counts = dict(zip(COUNTS, map(int, lines[-1])))
    elif not parts:
        counts = {"passed": int(status == 0), "failed": int(status != 0), "skipped": 0}
    skips = {}
    for part in parts:
        for reason, count in part.get("skips", {}).items():
            skips[reason] = skips.get(reason, 0) + count
    failures = [name for part in parts for name in part.get("failures", [])]
    return counts | {"failures": failures, "skips": skips, "parts": parts}


def passed(result):
    """Returns whether the suite has ended well."""
    return result["status"] == 0 and result["failed"] == 0


def last_words(log):
    """Returns the last line of a log that says something."""
    with log.open("rb") as text:
        text.seek(max(0, log.stat().st_size - 4000))
        lines = [line.strip() for line in re.split(r"[\r\n]+", text.read().decode(errors="replace"))]
    lines = [line for line in lines if line]
    return lines[-1][:100] if lines else ""


def write(path, content):
    """Writes JSON under another name, and renames it when it is whole."""
    part = path.with_suffix(".part")
    part.write_text(json.dumps(content, indent=1) + "\n")
    part.rename(path)


def only_one(out):
    """Returns an open lock; ends the program where another release is under way in this tree."""
    out.mkdir(parents=True, exist_ok=True)
    lock = (out / "lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit("release: another one is under way in this tree")
    return lock


def hours(minutes):
    return f"{int(minutes) // 60}:{int(minutes) % 60:02d}"


def arguments(words):
    parser = argparse.ArgumentParser(prog="./dev release", description="every suite, on one commit")
    parser.add_argument("names", nargs="*", metavar="SUITE")
    parser.add_argument("--list", action="store_true", help="only print what is known of each suite")
    parser.add_argument("--again", action="store_true", help="run suites that have a result, too")
    parser.add_argument("--sitting", type=float, metavar="MINUTES", help="begin nothing that would end later")
    parser.add_argument("--suites", type=pathlib.Path, default=SUITES, help=argparse.SUPPRESS)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    parser.add_argument("--published", type=pathlib.Path, metavar="FILE", help="results of other machines")
    for name in ("engine", "shards", "hosts", "engine-option"):
        parser.add_argument(f"--{name}", action="append", default=[], help="of suites that run as shards")
    return parser.parse_args(words)


def main():
    if sys.argv[1:] == ["--renderer"]:
        return print_renderer()
    if sys.argv[1:] == ["--machine"]:
        return print(json.dumps(machine()))
    args = arguments(sys.argv[1:])
    suites = suites_of(args.suites)
    unknown = set(args.names) - {suite["name"] for suite in suites}
    if unknown:
        sys.exit(f"release: no suite {', '.join(sorted(unknown))}; --list names them")
    file = args.published or args.root / "docs" / "results" / "results.json"
    published = json.loads(file.read_text())["results"] if args.published or file.exists() else ()
    release = Release(args.root, suites, commit_of(args.root), args.root / "out" / "release", published)
    if args.list:
        return release.table()
    lock = only_one(args.root / "out" / "release")
    options = [f"--{name}={value}" for name in ("engine", "shards", "hosts", "engine-option")
               for value in getattr(args, name.replace("-", "_"))]
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    left = [suite for suite in suites if (not args.names or suite["name"] in args.names)
            and (args.again or release.result(suite) is None)]
    begun = time.monotonic()
    for at, suite in enumerate(left):
        needed = [release.minutes(one) for one in left[at:]]
        if args.sitting and (time.monotonic() - begun) / 60 + needed[0] > args.sitting:
            print(f"==> {suite['name']} would take {needed[0]:.0f} minutes: left to another sitting", flush=True)
            continue
        print(f"==> {at + 1} of {len(left)}: {suite['name']}: {suite['title']} "
              f"({hours(needed[0])} hours, {hours(sum(needed))} with what follows)", flush=True)
        result = release.run(suite, options, f"{at + 1}/{len(left)}")
        print(f"    {result['passed']} passed, {result['failed']} failed, {result['skipped']} skipped, status "
              f"{result['status']}; {release.folder.relative_to(args.root)}/{suite['name']}.log", flush=True)
    lock.close()
    return release.table()


if __name__ == "__main__":
    sys.exit(main())
