#!/usr/bin/env python3
"""Judges the layer over the host that TEST_HOST names, by what the bare host makes of the same cases.

usage: judge.py api|demonstrations|differential --build BUILD --out FOLDER [--counts FILE]

Each case runs on the bare host and under the layer, by back ends. A case that the bare host fails is no case of the
layer's: it is skipped there, and under the layer if it fails again. So is one that the bare host cannot run, if
known.toml has a defect of the host for it. All else has to pass. A row of known.toml that nothing needs fails too.
Ends with "N passed, N failed, N skipped"; the exit status is 1 if a case fails."""

import argparse
import collections
import fnmatch
import json
import os
import pathlib
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "scripts")]

import hosts  # noqa: E402
import suites  # noqa: E402

BARE = suites.BARE
HOSTS_OWN = "the bare host fails or is not steady"
KNOWN = pathlib.Path(__file__).resolve().parent / "known.toml"


def known_defects(host, suite, path=KNOWN):
    """Returns {pattern of cases: why} of the defects of a host that a suite meets."""
    rows = tomllib.loads(path.read_text())["defect"]
    return {case: row["why"] for row in rows if (row["host"], row["suite"]) == (host, suite) for case in row["cases"]}


def is_hosts_own(way, name, outcome, bare, known, used):
    """Returns whether a failure is one of the host, which fails the case itself, or cannot show it and is known to.
    Adds the pattern that says so to `used`."""
    on_host = [bare[key].kind for key in outcome.alike or (name,) if key in bare]
    if way == BARE or "failed" in on_host:
        return True
    fits = [pattern for pattern in known if fnmatch.fnmatchcase(name, pattern)]
    if "passed" in on_host or not fits:
        return False
    used.update(fits)
    return True


def judged(results, known):
    """Returns the counts of {way: {case: Outcome}}, among which BARE is the bare host's way."""
    counts = {"passed": 0, "failed": 0, "skipped": 0}
    failures, skips, used = [], collections.Counter(), set()
    bare = results[BARE]
    for way, cases in results.items():
        for name, outcome in cases.items():
            kind, why = outcome.kind, outcome.why
            if kind == "failed" and is_hosts_own(way, name, outcome, bare, known, used):
                kind, why = "skipped", HOSTS_OWN
            counts[kind] += 1
            if kind == "failed":
                failures.append(f"{way}: {name}: {why}" if why else f"{way}: {name}")
            elif kind == "skipped":
                skips[why] += 1
    # Over a host that does nothing right, nothing is judged.
    wrong = [] if any(outcome.kind == "passed" for outcome in bare.values()) else [f"{BARE}: no case passes"]
    wrong += [f"{KNOWN.name}: {pattern}: no such defect any more" for pattern in known if pattern not in used]
    counts["failed"] += len(wrong)
    failures += wrong
    return {**counts, "failures": failures, "skips": dict(skips.most_common())}


def show(results, counts):
    """Prints a line for each way and each failure, and the last line of counts."""
    for way, cases in results.items():
        kinds = collections.Counter(outcome.kind for outcome in cases.values())
        print(f"{way:12} {kinds['passed']:5} passed {kinds['failed']:5} failed {kinds['skipped']:5} skipped")
    for name, outcome in results[BARE].items():
        if outcome.kind == "failed":
            print(f"the bare host fails {name}: {outcome.why}")
    for failure in counts["failures"]:
        print(f"FAIL {failure}")
    print("{passed} passed, {failed} failed, {skipped} skipped".format(**counts), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suite", choices=suites.SUITES)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=100, help="generated programs of each language")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    args = parser.parse_args()
    args.build, args.out = args.build.resolve(), args.out.resolve()
    args.out.mkdir(parents=True, exist_ok=True)
    os.environ.update(hosts.environment())
    results = suites.SUITES[args.suite](args)
    counts = judged(results, known_defects(os.environ.get("TEST_HOST", "llvmpipe"), args.suite))
    show(results, counts)
    if args.counts:
        args.counts.write_text(json.dumps({"name": args.counts.stem, **counts}) + "\n")
    return 1 if counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
