"""Reads what a test program has printed: its counts, the names of failures, the reasons of skips.

Known are GoogleTest, Python's unittest, and this project's own runners. Those print lines "skip NAME: REASON" and
"FAIL NAME", and a last line "N passed, N failed, N skipped". A program without counts is one case. If its exit status
is 77, it is skipped, and its last line is the reason. A reason is counted by its cause, the words before a colon:
"bare host: compares all the same" and "bare host: counts the text" are two of "bare host"."""

import collections
import dataclasses
import re

NO_REASON = "no reason is given"
SKIPPED = 77
COUNTS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
GTEST = {
    "passed": re.compile(r"^\[  PASSED  \] (\d+) tests?", re.M),
    "failed": re.compile(r"^\[  FAILED  \] (\d+) tests?, listed", re.M),
    "skipped": re.compile(r"^\[  SKIPPED \] (\d+) tests?, listed", re.M),
}
GTEST_CASE = re.compile(r"^\[ +(RUN|OK|FAILED|SKIPPED) +\] ([\w/.]+)", re.M)
GTEST_REASON = re.compile(r": Skipped\n(.*?)\n+\[  SKIPPED \] ", re.S)
UNITTEST = re.compile(r"^Ran (\d+) tests? in .*\n\n(OK|FAILED)(?: \((.*)\))?$", re.M)
UNITTEST_FAILURE = re.compile(r"^(?:FAIL|ERROR): (\w+)(?: \((?:__main__\.)?([\w.]+)\))?", re.M)
UNITTEST_REASON = re.compile(r"\.\.\. skipped (['\"])(.*)\1$", re.M)
OWN_FAILURE = re.compile(r"^(?:FAIL|fail) +(\S.*)$|^([\w ,./-]+: FAIL: .*)$", re.M)
OWN_REASON = re.compile(r"^skip +\S.*?: (.+)$", re.M)
PROGRAM = re.compile(r"^[\w.-]+: ")  # before a message
LONGEST = 160  # characters of a failure's name


@dataclasses.dataclass
class Counts:
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    failures: list = dataclasses.field(default_factory=list)  # names; perhaps fewer than `failed`
    skips: collections.Counter = dataclasses.field(default_factory=collections.Counter)  # by reason

    def add(self, other, name):
        """Adds those of a test; its failures get its name."""
        self.passed += other.passed
        self.failed += other.failed
        self.skipped += other.skipped
        self.failures += [f"{name}: {case}" if case else name for case in other.failures]
        self.skips += other.skips

    def part(self, name):
        """Returns the document of a part of a suite."""
        return {"name": name, "passed": self.passed, "failed": self.failed, "skipped": self.skipped,
                "failures": self.failures, "skips": dict(self.skips.most_common())}


def last_line(*texts):
    """Returns the last line with words of the first text that has one."""
    for text in texts:
        lines = [line.strip() for line in text.splitlines() if re.search(r"\w", line)]
        if lines:
            return lines[-1]
    return ""


def cause(reason):
    """Returns the words of a reason before a colon."""
    return " ".join(reason.split(": ")[0].split()) or NO_REASON


def reason_of_status(out, err):
    """Returns why a program ended with the status of a skip."""
    said = re.findall(r"skipped: (.+)$", f"{out}\n{err}", re.M)
    return said[-1] if said else PROGRAM.sub("", last_line(err, out))


def ended(status):
    return f"signal {-status}" if status < 0 else f"status {status}"


def gtest_cases(out):
    """Returns {case: passed, failed, skipped or, if the program died in it, run}."""
    words = {"RUN": "run", "OK": "passed", "FAILED": "failed", "SKIPPED": "skipped"}
    return {case: words[word] for word, case in GTEST_CASE.findall(out) if "." in case}


def gtest_reasons(out):
    """Returns [(case, reason)] of GoogleTest's skipped cases."""
    pairs = []
    for block in re.split(r"^(?=\[ RUN      \] )", out, flags=re.M)[1:]:
        case = GTEST_CASE.match(block)
        reason = GTEST_REASON.search(block)
        if reason and case:
            pairs.append((case.group(2), cause(reason.group(1))))
    return pairs


def of_gtest(out, ending):
    found = {kind: pattern.search(out) for kind, pattern in GTEST.items()}
    every = gtest_cases(out)
    if found["passed"]:
        numbers = [int(found[kind].group(1)) if found[kind] else 0 for kind in ("passed", "failed", "skipped")]
    else:  # it died before it counted them
        hows = collections.Counter(every.values())
        numbers = [hows["passed"], hows["failed"] + hows["run"], hows["skipped"]]
    failures = [case if how == "failed" else f"{case}: {ending}" for case, how in every.items()
                if how in ("failed", "run")]
    return numbers, failures, [reason for _, reason in gtest_reasons(out)]


def of_unittest(ran, text):
    kinds = dict(re.findall(r"([a-z][a-z ]*)=(\d+)", ran.group(3) or ""))
    skipped = int(kinds.get("skipped", 0))
    failed = sum(int(kinds.get(kind, 0)) for kind in ("failures", "errors", "unexpected successes"))
    numbers = [max(0, int(ran.group(1)) - failed - skipped), failed, skipped]
    failures = [f"{of}.{name}" if of and not of.endswith(name) else of or name
                for name, of in UNITTEST_FAILURE.findall(text)]
    return numbers, failures, [reason for _, reason in UNITTEST_REASON.findall(text)]


def read(out, err="", passed=True, status=0, ending=""):
    """Returns the Counts of a program.

    passed: whether whoever ran it takes it for passed or skipped; ending: how one that failed ended, such as
    "timed out"."""
    whole, ending = f"{out}\n{err}", ending or ended(status)
    own = COUNTS.findall(out)
    ran = list(UNITTEST.finditer(whole))
    if own:
        numbers = [int(n) for n in own[-1]]
        failures = [" ".join((one or other).split())[:LONGEST] for one, other in OWN_FAILURE.findall(out)]
        reasons = OWN_REASON.findall(out)
    elif any(pattern.search(out) for pattern in GTEST.values()) or gtest_cases(out):
        numbers, failures, reasons = of_gtest(out, ending)
    elif ran:
        numbers, failures, reasons = of_unittest(ran[-1], whole)
    else:
        numbers, failures, reasons = [int(passed and status != SKIPPED), 0, 0], [], []
    if passed and status == SKIPPED and numbers[2] == 0:
        numbers, reasons = [numbers[0], numbers[1], 1], [reason_of_status(out, err)]
    # What fails for whoever ran it is a failure, whatever the program printed before it died.
    if not passed and numbers[1] == 0:
        numbers[1] = 1
        failures = [": ".join(filter(None, (ending, last_line(err, out))))[:LONGEST]]
    reasons = reasons[max(0, len(reasons) - numbers[2]):]  # a runner's self-test may print some too
    skips = collections.Counter(map(cause, reasons))
    skips[NO_REASON] += numbers[2] - len(reasons)
    return Counts(*numbers, failures[-numbers[1]:] if numbers[1] else [], +skips)
