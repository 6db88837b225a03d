#!/usr/bin/env python3
"""Counts of results: from meson's log, and the sum over the parts of a test run.

A part leaves a JSON file {"name", "passed", "failed", "skipped"}; `total` adds them up and prints
one line. A test program may hold many cases: GoogleTest's summary is read, and so is a last line
of the form "N passed, N failed, N skipped", which this project's own runners print.
"""

import json
import pathlib
import re
import sys

COUNTS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
GTEST = {
    "passed": re.compile(r"^\[  PASSED  \] (\d+) tests?", re.M),
    "failed": re.compile(r"^\[  FAILED  \] (\d+) tests?, listed", re.M),
    "skipped": re.compile(r"^\[  SKIPPED \] (\d+) tests?, listed", re.M),
}


def cases(test):
    """(passed, failed, skipped) of one entry of meson's testlog.json."""
    text = test.get("stdout", "") or ""
    own = COUNTS.findall(text)
    if own:
        counts = [int(n) for n in own[-1]]
    elif GTEST["passed"].search(text):
        found = {k: r.search(text) for k, r in GTEST.items()}
        counts = [int(found[k].group(1)) if found[k] else 0
                  for k in ("passed", "failed", "skipped")]
    else:
        counts = [0, 0, 0]
        if test["result"] in ("OK", "EXPECTEDFAIL"):
            counts[0] = 1
        elif test["result"] == "SKIP":
            counts[2] = 1
    # What meson calls a failure is one, whatever the program printed before it died.
    if test["result"] not in ("OK", "EXPECTEDFAIL", "SKIP") and counts[1] == 0:
        counts[1] = 1
    return counts


def from_meson(log, target):
    tests = [json.loads(line) for line in pathlib.Path(log).read_text(errors="replace").splitlines()]
    total = [0, 0, 0]
    for test in tests:
        total = [a + b for a, b in zip(total, cases(test))]
    write(target, "meson", total)
    print_slowest(tests)


def print_slowest(tests, count=12):
    """The tests that take longest, and their part of the whole."""
    whole = sum(test["duration"] for test in tests)
    print(f"\n{'seconds':>8}  the {count} slowest of {len(tests)} tests, of {whole:.0f} seconds together")
    for test in sorted(tests, key=lambda test: -test["duration"])[:count]:
        print(f"{test['duration']:8.0f}  {test['name'].split(' / ')[-1]}")


def write(target, name, counts):
    passed, failed, skipped = counts
    pathlib.Path(target).write_text(json.dumps(
        {"name": name, "passed": passed, "failed": failed, "skipped": skipped}) + "\n")


def total(folder):
    """Prints the sum; returns the exit status: 1 if anything failed or nothing ran."""
    sums = [0, 0, 0]
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        part = json.loads(path.read_text())
        counts = [part["passed"], part["failed"], part["skipped"]]
        print("%-12s %6d passed %6d failed %6d skipped" % (part["name"], *counts))
        sums = [a + b for a, b in zip(sums, counts)]
    print("%d passed, %d failed, %d skipped" % tuple(sums), flush=True)
    return 1 if sums[1] or not sums[0] else 0


def self_test():
    log = [
        ({"result": "OK", "stdout": "[  PASSED  ] 12 tests.\n"}, [12, 0, 0]),
        ({"result": "FAIL", "stdout": "[  PASSED  ] 3 tests.\n[  FAILED  ] 2 tests, listed below:"},
         [3, 2, 0]),
        ({"result": "FAIL", "stdout": "[  PASSED  ] 1 test."}, [1, 1, 0]),
        ({"result": "SKIP", "stdout": ""}, [0, 0, 1]),
        ({"result": "OK", "stdout": "x\n5 passed, 0 failed, 2 skipped\n"}, [5, 0, 2]),
        ({"result": "TIMEOUT"}, [0, 1, 0]),
    ]
    for test, expected in log:
        got = cases(test)
        assert got == expected, (test, got, expected)
    print("%d passed, 0 failed, 0 skipped" % len(log))


def main():
    if sys.argv[1:2] == ["meson"]:
        from_meson(sys.argv[2], sys.argv[3])
        return 0
    if sys.argv[1:2] == ["total"]:
        return total(sys.argv[2])
    if sys.argv[1:2] == ["self-test"]:
        self_test()
        return 0
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
