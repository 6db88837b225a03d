"""Expected differences between the bare host and the layer.

One line for each difference, four fields with ` | ` between them:

    test or pattern (* matches anything) | result on the bare host | result under the layer | reason

A line without a reason is an error. So is a line whose tests ran without such a difference:
the files describe the present state. PROFILE-on-HOST.txt has those that only that host has (scripts/hosts.py).
"""

import fnmatch
import os
import pathlib
import re

STATUSES = ("pass", "warn", "fail", "crash", "timeout", "skip", "incomplete", "missing",
            "dmesg-warn", "dmesg-fail")


class Expectation:
    def __init__(self, where, pattern, bare, layer, reason):
        self.where, self.pattern, self.bare, self.layer = where, pattern, bare, layer
        self.reason, self.used = reason, False

    def matches(self, test):
        # Square brackets belong to names here and are not sets of characters.
        return fnmatch.fnmatchcase(test, re.sub(r"\[", "[[]", self.pattern))

    def explains(self, test, bare, layer):
        return self.bare == bare and self.layer == layer and self.matches(test)


def parse(text, where):
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.startswith("#"):
            continue
        fields = [field.strip() for field in line.split(" | ")]
        place = "%s:%d" % (where, number)
        if len(fields) != 4 or not all(fields):
            raise ValueError("%s: four fields wanted: test | bare | layer | reason" % place)
        if fields[1] not in STATUSES or fields[2] not in STATUSES or fields[1] == fields[2]:
            raise ValueError("%s: two different results wanted, of %s"
                             % (place, ", ".join(STATUSES)))
        rows.append(Expectation(place, *fields))
    return rows


def load(profile):
    """Returns the expectations of a configuration, over the host that TEST_HOST names. auto-programs and
    swrast-programs share those of auto and swrast."""
    name = profile.removesuffix("-programs").replace(":", "-")
    folder = pathlib.Path(__file__).parent / "expectations"
    rows = parse((folder / (name + ".txt")).read_text(), name + ".txt")
    of_host = folder / f"{name}-on-{os.environ.get('TEST_HOST', 'llvmpipe')}.txt"
    return rows + parse(of_host.read_text(), of_host.name) if of_host.exists() else rows


def differences(bare, layer):
    """Returns {test: (bare result, layer result)} of the tests that differ."""
    return {test: (bare.get(test, "missing"), layer.get(test, "missing"))
            for test in sorted(set(bare) | set(layer))
            if bare.get(test, "missing") != layer.get(test, "missing")}


def judge(changes, rows):
    """Returns (explained, unexpected) of {test: (bare, layer)}; marks the rows used."""
    explained, unexpected = {}, {}
    for test, (bare, layer) in changes.items():
        row = next((r for r in rows if r.explains(test, bare, layer)), None)
        if row:
            row.used = True
            explained[test] = row.reason
        else:
            unexpected[test] = (bare, layer)
    return explained, unexpected


def unused_rows(rows, ran):
    """Returns the rows whose tests ran without their difference."""
    return [row for row in rows
            if not row.used and any(row.matches(test) for test in ran)]
