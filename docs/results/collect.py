#!/usr/bin/env python3
"""Writes docs/results/results.json from the files that `./dev release` leaves, and the pages with it.

usage: collect.py [FOLDER...]      each is out/release/COMMIT, of one machine; without any no suite has run
       --suites FILE               the planned suites, by default scripts/release_suites.toml
       --out FILE                  by default docs/results/results.json; the pages are written for that one alone
       --add                       keep what --out has. A new result replaces that of its suite and driver
       --other-commits             take the last results of several commits; the page marks those of another than the
                                   first folder's

A file that is cut short, does not add up, or is of another commit than the others is refused: nothing is written.
What is published has no paths of a machine and no logs.
"""

import argparse
import json
import pathlib
import re
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SUITES = ROOT / "scripts" / "release_suites.toml"
RESULTS = HERE / "results.json"
SCHEMA = 1
COUNTS = ("passed", "failed", "skipped")
MACHINE = ("renderer", "version", "compiler", "system", "processor", "cores")
COMMIT = re.compile(r"[0-9a-f]{40}")
DATE = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ")
SYSTEM_PATHS = ("/usr/", "/lib/", "/etc/", "/proc/", "/dev/", "/sys/")
PATH = re.compile(r"(?<![\w./<-])/(?:[\w.+@~-]+/)+[\w.+@~-]*")
MOST_FAILURES = 200  # of one suite that are named


class Refused(Exception):
    """A result that cannot be published, with the reason."""


def suites_of(file):
    """Returns the planned suites in their order: name, title, command, minutes and what each needs."""
    try:
        rows = tomllib.loads(file.read_text())["suite"]
        suites = [{"name": row["name"], "title": row["title"], "command": list(row["command"]),
                   "minutes": row["minutes"], "needs": row.get("needs", "")} for row in rows]
    except (OSError, KeyError, tomllib.TOMLDecodeError) as error:
        raise Refused(f"{file.name}: {error}") from None
    names = [suite["name"] for suite in suites]
    if len(set(names)) < len(names):
        raise Refused(f"{file.name}: a suite is named twice")
    return suites


def host_of(machine):
    """Returns the driver as a column is named: "llvmpipe, Mesa 22.3", "zink, Mesa 25.0", "NVIDIA 580.159.04"."""
    renderer, version = machine["renderer"], machine["version"]
    if mesa := re.search(r"Mesa (\d+\.\d+)", version):
        name = f"{re.split(r'[ (]', renderer)[0]}, Mesa {mesa.group(1)}"
    elif nvidia := re.search(r"NVIDIA (\d[\d.]*)", version):
        name = f"NVIDIA {nvidia.group(1)}"
    else:
        name = renderer
    return name if machine["processor"] in ("x86_64", "amd64") else f"{name}, {machine['processor']}"


def without_paths(text):
    """Returns the text with paths of the tree relative to it, and of others that are no system's the last name."""
    text = text.replace(str(ROOT) + "/", "")
    return PATH.sub(lambda path: path.group() if path.group().startswith(SYSTEM_PATHS) else
                    "…/" + path.group().rstrip("/").split("/")[-1], text)


def counts_of(where, row):
    """Returns passed, failed and skipped of a file or a part, which must agree with the names and reasons it gives."""
    counts = [row[name] for name in COUNTS]
    if not all(type(count) is int and count >= 0 for count in counts):
        raise Refused(f"{where}: passed, failed and skipped are not whole numbers")
    reasons, failures = row.get("skips") or {}, row.get("failures") or []
    if not all(type(count) is int and count > 0 for count in reasons.values()):
        raise Refused(f"{where}: a reason has no cases")
    if len(failures) > counts[1]:
        raise Refused(f"{where}: {len(failures)} failures are named, {counts[1]} are counted")
    if sum(reasons.values()) > counts[2]:
        raise Refused(f"{where}: reasons of {sum(reasons.values())} skips, {counts[2]} are counted")
    return counts


def parts_of(where, row):
    """Returns the parts' names and counts. Their sum is the suite's, and a part with reasons has one for each skip."""
    parts = []
    for part in row["parts"]:
        inside = f"{where}, part {part['name']}"
        counts = counts_of(inside, part)
        if part.get("skips") and sum(part["skips"].values()) != counts[2]:
            raise Refused(f"{inside}: reasons of {sum(part['skips'].values())} of {counts[2]} skips")
        parts.append({"name": part["name"], **dict(zip(COUNTS, counts))})
    for name in COUNTS if parts else ():
        if sum(part[name] for part in parts) != row[name]:
            raise Refused(f"{where}: {row[name]} {name}, and its parts have {sum(part[name] for part in parts)}")
    return parts


def merged(skips):
    """Returns {reason without paths: cases}, the most frequent first."""
    found = {}
    for reason, count in skips.items():
        reason = without_paths(reason)
        found[reason] = found.get(reason, 0) + count
    return dict(sorted(found.items(), key=lambda row: (-row[1], row[0])))


def row_of(file):
    """Returns the object that a file holds."""
    try:
        row = json.loads(file.read_text())
    except ValueError as error:
        raise Refused(f"{file.parent.name[:12]}/{file.name}: cut short, or no JSON: {error}") from None
    if not isinstance(row, dict):
        raise Refused(f"{file.parent.name[:12]}/{file.name}: no result")
    return row


def result_of(file, row, names):
    """Returns (result, machine) of a suite's file, trimmed to what is published."""
    where = f"{file.parent.name[:12]}/{file.name}"
    try:
        if row["schema"] != SCHEMA:
            raise Refused(f"{where}: schema {row['schema']}, and {SCHEMA} is known")
        if row["suite"] != file.stem or row["suite"] not in names:
            raise Refused(f"{where}: no suite {row['suite']} is planned under this name")
        if not COMMIT.fullmatch(row["commit"]) or not DATE.fullmatch(row["date"]):
            raise Refused(f"{where}: commit or date is none")
        if COMMIT.fullmatch(file.parent.name) and file.parent.name != row["commit"]:
            raise Refused(f"{where}: of commit {row['commit'][:12]}, in the folder of another")
        counts = counts_of(where, row)
        machine = {name: row["machine"][name] for name in MACHINE}
        return {"suite": row["suite"], "host": host_of(machine), "commit": row["commit"], "date": row["date"],
                "seconds": row["seconds"], "status": row["status"], **dict(zip(COUNTS, counts)),
                "failures": sorted(map(without_paths, row.get("failures") or []))[:MOST_FAILURES],
                "skips": merged(row.get("skips") or {}), "parts": parts_of(where, row)}, machine
    except (KeyError, TypeError) as error:
        raise Refused(f"{where}: lacks {error}") from None


def collected(folders, suites, other_commits=False, earlier=None):
    """Returns what is published of the folders' files, and of what was published earlier if that is given.

    The commit is that of the first folder."""
    names = [suite["name"] for suite in suites]
    hosts, seen = {}, {}
    for folder in folders:
        files = sorted(folder.glob("*.json"))
        if not files:
            raise Refused(f"{folder.name}: no results")
        for file in files:
            row = row_of(file)
            if file.stem not in names and "suite" not in row:
                continue  # a note of the run's own
            result, machine = result_of(file, row, names)
            key = result["suite"], result["host"]
            other = seen.get(key)
            if other and not (other_commits and other["commit"] != result["commit"]):
                raise Refused(f"{' on '.join(key)}: two results of {result['commit'][:12]}")
            if other and other["date"] > result["date"]:
                continue
            seen[key] = result
            machines = hosts.setdefault(result["host"], [])
            if machine not in machines:
                machines.append(machine)
    results = list(seen.values())
    if earlier:
        kept = [row for row in earlier["results"] if (row["suite"], row["host"]) not in seen and row["suite"] in names]
        results += kept
        for host in earlier["hosts"]:
            known = hosts.setdefault(host["name"], [])
            known += [machine for machine in host["machines"] if machine not in known]
    commits = {result["commit"] for result in results}
    if len(commits) > 1 and not other_commits:
        raise Refused("results of several commits: " + ", ".join(sorted(commit[:12] for commit in commits)))
    commit = next((folder.name for folder in folders if folder.name in commits),
                  results[0]["commit"] if results else None)
    results.sort(key=lambda row: (names.index(row["suite"]), list(hosts).index(row["host"])))
    return {"schema": SCHEMA, "commit": commit, "date": max((row["date"] for row in results), default=None),
            "suites": suites, "hosts": [{"name": name, "machines": found} for name, found in hosts.items()],
            "results": results}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--suites", type=pathlib.Path, default=SUITES)
    parser.add_argument("--out", type=pathlib.Path, default=RESULTS)
    parser.add_argument("--other-commits", action="store_true")
    parser.add_argument("--add", action="store_true")
    options = parser.parse_args()
    try:
        earlier = json.loads(options.out.read_text()) if options.add else None
        published = collected([folder.resolve() for folder in options.folders], suites_of(options.suites),
                              options.other_commits, earlier)
    except (Refused, OSError, ValueError) as error:
        print(f"collect.py: {error}", file=sys.stderr)
        return 1
    options.out.write_text(json.dumps(published, indent=1, ensure_ascii=False) + "\n")
    print(f"{options.out}: {len(published['results'])} results of {len(published['suites'])} suites on "
          f"{len(published['hosts'])} hosts")
    if options.out.resolve() == RESULTS:
        sys.path.insert(0, str(HERE))
        import page
        page.write()
    return 0


if __name__ == "__main__":
    sys.exit(main())
