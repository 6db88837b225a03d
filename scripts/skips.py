"""The owners of skips, by tests/skips.toml: for each reason the suite or machine on which the skipped cases run."""

import collections
import fnmatch
import json
import os
import pathlib
import re
import tomllib

import tally_log

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "tests/skips.toml"
OWNERS = ("test", "suite", "machine", "nowhere")  # a row has one of them


class BadTable(Exception):
    pass


def rows(path):
    """Returns {reason or pattern: row}.

    Raises BadTable for a row without an owner, with two, or with a suite that ./dev has not."""
    table, verbs = {}, re.findall(r"^verb_(\w+)\(\)", (ROOT / "dev").read_text(), re.M)
    for row in tomllib.loads(pathlib.Path(path).read_text()).get("skip", []):
        for reason in row["reasons"]:
            if sum(owner in row for owner in OWNERS) != 1:
                raise BadTable(f"{path}: {reason}: there is one of {', '.join(OWNERS)} in a row")
            if "suite" in row and row["suite"].split()[0] not in verbs:
                raise BadTable(f"{path}: {reason}: ./dev has no verb {row['suite']}")
            if reason in table:
                raise BadTable(f"{path}: {reason}: there are two rows")
            table[reason] = row
    return table


def row_of(table, reason):
    """Returns the table's key for a reason, or None. A pattern has *, and the longest that fits counts."""
    if reason in table:
        return reason
    fits = [key for key in table if "*" in key and fnmatch.fnmatchcase(reason, key)]
    return max(fits, key=len, default=None)


def parts_of(folder):
    """Returns the results in a folder that have skips: the parts of a suite, or suites."""
    documents = [json.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.json"))]
    return [each for each in documents if isinstance(each, dict) and "skips" in each]


def unrun(tests):
    """Returns {reason: [case]} of GoogleTest's cases that some tests of meson's log skip, and none of them runs."""
    ran, skipped = set(), collections.defaultdict(set)
    for test in tests:
        out = test.get("stdout") or ""
        program = os.path.basename((test.get("command") or [test["name"]])[0])
        ran |= {(program, case) for case, how in tally_log.gtest_cases(out).items() if how != "skipped"}
        for case, reason in tally_log.gtest_reasons(out):
            skipped[reason].add((program, case))
    return {reason: sorted(case for _, case in cases - ran) for reason, cases in skipped.items() if cases - ran}


def complaints(table, parts):
    """Returns a line for each reason without a row, and for each case whose row says that `./dev test` runs it in
    another way, where that is not so."""
    lines = []
    reasons = sum((collections.Counter(part["skips"]) for part in parts), collections.Counter())
    for reason, count in reasons.most_common():
        if row_of(table, reason) is None:
            lines.append(f"no row for {count} skipped: {reason}")
    for part in parts:
        for reason, cases in part.get("unrun", {}).items():
            row = table.get(row_of(table, reason), {})
            if "test" in row:
                lines.append(f"skipped in every test: {', '.join(cases[:4])}: {reason}")
    return lines


def unused(table, parts):
    """Returns the table's reasons that no skip of the parts has, but for those of other machines."""
    used = {row_of(table, reason) for part in parts for reason in part["skips"]}
    return [reason for reason, row in table.items() if reason not in used and "machine" not in row]
