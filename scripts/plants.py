#!/usr/bin/env python3
"""Plants faults, one at a time, and says whether the suite that is there for each kind finds it.

usage: plants.py [NAME...]      those of scripts/plants.toml, or the named ones
       --list                   what there is: each plant, what it is, the command that has to find it
       --counts FILE            the result, as a part of a suite (tally.py)

A row has a file with the text `find`, which is in it once, and `put`, the fault in its place; or a `create`, the text
of a new file. Its command has to fail, and to print `says`: a command that passes, or that fails for another reason,
has not found the fault. The fault stands in the tree itself, so that only what depends on it is built. Nothing begins
in a tree that differs from its commit, and each fault is taken back when its command has ended or this program is
ended; where that was by SIGKILL, the next run takes it back. What commands print is in out/plants/NAME.log."""

import argparse
import contextlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import tomllib

from release import GROUP

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "scripts/plants.toml"
KEYS = {"name", "title", "file", "find", "put", "create", "command", "says", "minutes"}
ENDINGS = (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)


class Refused(Exception):
    """Nothing was planted, for this reason."""


def rows(path):
    """Returns the rows of a table by their names. Raises Refused for one that is not as plants.py says."""
    table = {}
    for row in tomllib.loads(path.read_text())["plant"]:
        kinds = row.keys() & {"find", "put", "create"}
        wanted = KEYS - {"find", "put", "create"}
        if not wanted <= row.keys() <= KEYS or kinds not in ({"find", "put"}, {"create"}) or row["name"] in table:
            raise Refused(f"{path.name}: {row.get('name')}: a row has {', '.join(sorted(wanted))}, and either find and "
                          "put or create; its name is its own")
        table[row["name"]] = row
    return table


def planted_text(root, row):
    """Returns the text of the file with the fault. Raises Refused if there is no one place for it."""
    path = root / row["file"]
    if "create" in row:
        if path.exists():
            raise Refused(f"{row['name']}: there is a {row['file']} already")
        return row["create"]
    text = path.read_text() if path.is_file() else ""
    if text.count(row["find"]) != 1 or row["find"] == row["put"]:
        raise Refused(f"{row['name']}: {row['file']} has the text {text.count(row['find'])} times, and not once: "
                      f"{row['find']}")
    return text.replace(row["find"], row["put"])


def git(root, *words):
    return subprocess.run(["git", "-C", str(root), *words], check=True, capture_output=True, text=True).stdout


def refuse_changes(root):
    changed = git(root, "status", "--porcelain")
    if changed:
        raise Refused("the tree is not as a commit has it:\n" + changed.rstrip("\n"))


class Planter:
    """Puts faults into a tree, and takes them back."""

    def __init__(self, root, out):
        self.root, self.mark = root, out / "planted.json"
        out.mkdir(parents=True, exist_ok=True)

    @contextlib.contextmanager
    def planted(self, row):
        """The fault is in the tree meanwhile."""
        path, text = self.root / row["file"], planted_text(self.root, row)
        self.mark.write_text(json.dumps({"file": row["file"], "text": text}))
        try:
            path.write_text(text)
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_BLOCK, ENDINGS)
            self.take_back()
            signal.pthread_sigmask(signal.SIG_UNBLOCK, ENDINGS)

    def take_back(self):
        """Takes back a fault that is in the tree, if one is. What somebody has changed in the file since then stays.

        The file is written anew, so that what was built of the fault is older."""
        if not self.mark.exists():
            return
        mark = json.loads(self.mark.read_text())
        path = self.root / mark["file"]
        if path.exists() and path.read_text() == mark["text"]:
            if git(self.root, "ls-files", "--", mark["file"]):
                git(self.root, "checkout", "--", mark["file"])
            else:
                path.unlink()
        self.mark.unlink()


def follow(command, root, log, results):
    """Runs a command with its output in a file. Returns its status. It ends with this program, however that ends."""
    with log.open("wb") as out:
        child = subprocess.Popen(["setpriv", "--pdeathsig", "TERM", "sh", "-c", GROUP, "sh", *command], cwd=root,
                                 stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                 env={**os.environ, "DEV_RESULTS": str(results)}, start_new_session=True)
    try:
        return child.wait()
    except BaseException:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(child.pid, signal.SIGTERM)
        child.wait()
        raise


def run(planter, row, out):
    """Returns {name, found, status, seconds, why}: what became of a plant."""
    begun, log = time.monotonic(), out / f"{row['name']}.log"
    try:
        with planter.planted(row):
            status = follow(row["command"], planter.root, log, out / row["name"])
    except Refused as refusal:
        return {"name": row["name"], "found": False, "status": None, "seconds": 0, "why": str(refusal)}
    said = row["says"] in log.read_text(errors="replace")
    why = "" if status and said else f"the command passed; {log}" if not status else \
        f"status {status}, and nothing says: {row['says']}; {log}"
    return {"name": row["name"], "found": not why, "status": status, "seconds": round(time.monotonic() - begun),
            "why": why}


def part_of(results):
    """Returns the results as a part of a suite."""
    missed = [result for result in results if not result["found"]]
    return {"name": "plants", "passed": len(results) - len(missed), "failed": len(missed), "skipped": 0,
            "failures": [f"{result['name']}: {result['why']}"[:300] for result in missed], "skips": {},
            "plants": results}


def arguments(words):
    parser = argparse.ArgumentParser(prog="./dev plants", description="planted faults, which suites have to find")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true", help="only print what there is")
    parser.add_argument("--counts", type=pathlib.Path, metavar="FILE", help="leave the result there")
    parser.add_argument("--table", type=pathlib.Path, default=TABLE, help=argparse.SUPPRESS)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help=argparse.SUPPRESS)
    return parser.parse_args(words)


def main(words):
    args = arguments(words)
    table = rows(args.table)
    unknown = set(args.names) - table.keys()
    if unknown:
        raise Refused(f"no plant {', '.join(sorted(unknown))}; there are {', '.join(table)}")
    chosen = [row for row in table.values() if not args.names or row["name"] in args.names]
    if args.list:
        for row in chosen:
            print(f"{row['name']:<10} {row['minutes']:>3} min  {row['title']}: {' '.join(row['command'])}")
        return 0
    out = args.root / "out/plants"
    for ending in ENDINGS:
        signal.signal(ending, lambda number, _: sys.exit(128 + number))
    planter = Planter(args.root, out)
    planter.take_back()
    refuse_changes(args.root)
    results = []
    for at, row in enumerate(chosen):
        print(f"==> {at + 1} of {len(chosen)}: {row['name']}: {row['title']} (about {row['minutes']} minutes)",
              flush=True)
        results.append(run(planter, row, out))
        print(f"    {'found' if results[-1]['found'] else 'NOT found: ' + results[-1]['why']} "
              f"({results[-1]['seconds']} s)", flush=True)
        refuse_changes(args.root)
    part = part_of(results)
    if args.counts:
        args.counts.write_text(json.dumps(part) + "\n")
    print(f"{part['passed']} passed, {part['failed']} failed, 0 skipped")
    return 1 if part["failed"] else 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Refused as refusal:
        sys.exit(f"plants: {refusal}")
