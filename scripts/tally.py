#!/usr/bin/env python3
"""Counts of results: from meson's log or a step's output, the sum over the parts of a suite, the owners of skips.

  tally.py meson TESTLOG FILE [whole]    a part from meson's testlog.json; whole: it has all tests, so that each case
                                         that one of them skips for another is asked for
  tally.py step NAME STATUS OUTPUT FILE  a part from what a step printed, which may have left FILE itself
  tally.py once NAME STATUS OUTPUT FILE  likewise, but the step is one case, whatever it printed
  tally.py ended NAME STATUS FOLDER      leaves a part that fails, if no other part does: NAME ended with STATUS
  tally.py owned FOLDER [TABLE]          leaves a part that fails for each skip without an owner
  tally.py stale FOLDER [TABLE]          says which rows of the table no skip of these results needs
  tally.py total FOLDER [skips]          the sum of a folder's parts; skips: all of them may be skipped

A part is a JSON file {"name", "passed", "failed", "skipped", "failures": [name], "skips": {reason: count}}; `total`
prints the parts, the failures, the skips, and a last line of the sums."""

import collections
import json
import pathlib
import sys

import skips
import tally_log

GOOD = ("OK", "EXPECTEDFAIL", "SKIP")
ENDINGS = {"TIMEOUT": "timed out", "INTERRUPT": "interrupted", "UNEXPECTEDPASS": "passed unexpectedly"}
SHOWN = 40  # failures of a folder


def cases(test):
    """Returns the Counts of one entry of meson's testlog.json."""
    good = test["result"] in GOOD
    # Meson's SKIP has the status 77, except in logs that name no status.
    status = tally_log.SKIPPED if test["result"] == "SKIP" else test.get("returncode", 0 if good else 1)
    return tally_log.read(test.get("stdout") or "", test.get("stderr") or "", good, status,
                          ENDINGS.get(test["result"], ""))


def short_name(test):
    return test["name"].split(" / ")[-1]


def from_meson(log, target, is_whole):
    tests = [json.loads(line) for line in pathlib.Path(log).read_text(errors="replace").splitlines()]
    whole = tally_log.Counts()
    for test in tests:
        whole.add(cases(test), short_name(test))
    write(target, {**whole.part("meson"), **({"unrun": skips.unrun(tests)} if is_whole else {})})
    print_slowest(tests)


def print_slowest(tests, count=12):
    """The tests that take longest, and their part of the whole."""
    whole = sum(test["duration"] for test in tests)
    print(f"\n{'seconds':>8}  the {count} slowest of {len(tests)} tests, of {whole:.0f} seconds together")
    for test in sorted(tests, key=lambda test: -test["duration"])[:count]:
        print(f"{test['duration']:8.0f}  {short_name(test)}")


def from_step(name, status, output, target, is_one):
    """Writes the part of a step that ended with this status. A part that the step left itself stays, but fails if the
    step did."""
    good = status in (0, tally_log.SKIPPED)
    text = pathlib.Path(output).read_text(errors="replace")
    if pathlib.Path(target).exists():
        part = json.loads(pathlib.Path(target).read_text())
        if not good and not part["failed"]:
            part["failed"] = 1
            part.setdefault("failures", []).append(f"{tally_log.ended(status)}: {tally_log.last_line(text)}")
        write(target, part)
        return
    counts = tally_log.Counts(passed=1)
    if status or not is_one:
        counts = tally_log.read("" if is_one else text, text if is_one else "", good, status)
    whole = tally_log.Counts()
    whole.add(counts, name)
    write(target, {**whole.part(name), "failures": counts.failures})


def ended(name, status, folder):
    parts = [json.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.json"))]
    if not any(part["failed"] for part in parts):
        failure = f"{tally_log.ended(status)}, and no step of it has failed"
        write(pathlib.Path(folder) / f"{name}.json", tally_log.Counts(failed=1, failures=[failure]).part(name))


def write(target, part):
    pathlib.Path(target).write_text(json.dumps(part) + "\n")


def total(folder, may_skip=False):
    """Prints the sum; returns the exit status: 1 if anything failed or nothing ran.

    may_skip: a suite that has skipped all that it has is in order"""
    sums, reasons, failures = [0, 0, 0], collections.Counter(), []
    parts = [json.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.json"))]
    width = max([12, *(len(part["name"]) for part in parts)])
    for part in parts:
        counts = [part["passed"], part["failed"], part["skipped"]]
        print("%-*s %6d passed %6d failed %6d skipped" % (width, part["name"], *counts))
        sums = [a + b for a, b in zip(sums, counts)]
        failures += [f"{part['name']}: {failure}" for failure in part.get("failures", [])]
        reasons += collections.Counter(part.get("skips", {}))
    for reason, count in reasons.most_common():
        print("%6d skipped: %s" % (count, reason))
    for failure in failures[:SHOWN]:
        print("failed: %s" % failure)
    if len(failures) > SHOWN:
        print("and %d more, in %s" % (len(failures) - SHOWN, folder))
    print("%d passed, %d failed, %d skipped" % tuple(sums), flush=True)
    return 1 if sums[1] or not (sums[0] or may_skip and sums[2]) else 0


def owned(folder, table):
    """Leaves a part in the folder if a skip in its parts has no owner; returns the exit status."""
    wrong = skips.complaints(skips.rows(table), skips.parts_of(folder))
    for text in wrong:
        print(f"{table}: {text}")
    if wrong:
        write(pathlib.Path(folder) / "skips.json",
              {"name": "skips", "passed": 0, "failed": len(wrong), "skipped": 0, "failures": wrong, "skips": {}})
    return 1 if wrong else 0


def stale(folder, table):
    """Prints the rows that matched no skip of a folder's results; returns how many, at most 1."""
    unused = skips.unused(skips.rows(table), skips.parts_of(folder))
    for reason in unused:
        print(f"{table}: no suite of {folder} skips anything for: {reason}")
    return 1 if unused else 0


def main(words):
    verb, operands = (words or [""])[0], words[1:]
    table = pathlib.Path(operands[1] if operands[1:] else skips.TABLE)
    if verb == "meson" and len(operands) >= 2:
        from_meson(*operands[:2], operands[2:] == ["whole"])
    elif verb in ("step", "once") and len(operands) == 4:
        from_step(operands[0], int(operands[1]), *operands[2:], verb == "once")
    elif verb == "ended" and len(operands) == 3:
        ended(operands[0], int(operands[1]), operands[2])
    elif verb == "owned" and operands:
        return owned(operands[0], table)
    elif verb == "stale" and operands:
        return stale(operands[0], table)
    elif verb == "total" and operands:
        return total(operands[0], operands[1:] == ["skips"])
    elif verb == "self-test":
        import tally_test
        return tally_test.main()
    else:
        print(__doc__, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
