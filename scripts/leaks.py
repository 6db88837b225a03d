#!/usr/bin/env python3
"""Judges what AddressSanitizer and LeakSanitizer have said of the processes of a run, each in a file of its own.

  leaks.py options FOLDER               the ASAN_OPTIONS of processes whose reports go there
  leaks.py again FOLDER TREE            the failed tests that run again, a line each; their reports go
  leaks.py merge FIRST SECOND           the two logs of meson as the second one; 1 if a test has failed
  leaks.py judge FOLDER TREE FILE [whole]
                                        leaves the part FILE of a suite (tally.py), and says what has leaked; whole: all
                                        tests of the tree ran, so that each row of leaks.toml is needed

A leak is the project's own if its code asked for the memory: of the frames of the allocation, without those of the C
and the C++ library, the nearest is a function of the tree's. The host's driver keeps memory for the life of a process,
and is often unloaded by the time that leaks are looked for, so that its frames have no name, or are taken for places of
another file. What a library of others returns for its caller to free, such as a reply of libxcb, is the library's by
this rule, and is not found. leaks.toml has the leaks that are kept on purpose.

A process that looked for leaks and has none of these is a case that passed, a place that leaks is one that failed, in
however many processes. Leaks leave the exit status of a process alone; other errors still abort it, and are cases that
failed, as their text is in these files too. The end by a signal such as SIGSEGV is the test's to judge. Now and then
LeakSanitizer cannot stop the threads of a process that ends, and aborts it. Tests that failed while that happened run
once more; of many processes it is a failure."""

import collections
import dataclasses
import fnmatch
import json
import os
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "scripts/leaks.toml"
# exitcode without abort_on_error would have errors pass. atexit: a process without a leak leaves a file, too.
OPTIONS = ("detect_leaks=1:atexit=1:exitcode=0:abort_on_error=1:verify_asan_link_order=0:log_exe_name=1:"
           "log_path={}/report:stack_trace_format='    #%n %p in %f at %S of %m+%o'")
FILE = re.compile(r"report\.(.*)\.(\d+)$")
RECORD = re.compile(r"^(?:Direct|Indirect) leak of (\d+) byte\(s\) in (\d+) object\(s\) allocated from:$")
FRAME = re.compile(r"^ +#\d+ 0x[0-9a-f]+ in (.*) at (.*) of (.*)\+(?:0x)?[0-9a-f]+$")
EXITED = "AddressSanitizer exit stats:"
BLIND = "LeakSanitizer has encountered a fatal error"
# The end by a signal, which tests provoke: also while the process looks for leaks.
SIGNAL = re.compile(r"AddressSanitizer: (?:SEGV|ABRT|BUS|FPE|ILL|TRAP) |^==.*==Unable to get registers from thread")
ERROR = re.compile(r"==ERROR: (?!LeakSanitizer: detected)|: runtime error: |CHECK failed|ERROR: Can't ")
# Libraries that allocate for whoever calls them, by their names without versions.
RUNTIME = {"libasan", "libubsan", "liblsan", "libc", "libm", "libpthread", "libdl", "ld-linux-x86-64", "libstdc++",
           "libgcc_s", "libc++", "libc++abi"}
# Code of others that is linked into the tree's files.
LINKED = ("llvm::*", "LLVM*")
GOOD = ("OK", "EXPECTEDFAIL", "SKIP")  # results of meson's
SHOWN = 25  # frames of a stack, and distinct leaks
BLIND_SHARE = 0.01  # of the processes that could not look for leaks


class BadTable(Exception):
    pass


@dataclasses.dataclass(frozen=True)
class Frame:
    function: str
    source: str  # path:line:column, or <null>
    module: str  # path, or <null> of what is unloaded or was made at run time

    def __str__(self):
        source = self.source.removeprefix(f"{ROOT}/")
        where = pathlib.Path(self.module).name if source == "<null>" else source
        return f"{self.function if self.function != '<null>' else '?'} ({where})"


@dataclasses.dataclass
class Report:
    program: str
    time: float = 0.0
    looked: bool = False  # it has come to its end
    blind: bool = False  # leaks could not be looked for
    leaks: list = dataclasses.field(default_factory=list)  # of (bytes, stack)
    error: str = ""  # the text of an error


def is_runtime(frame):
    return re.split(r"\.so|-\d", pathlib.Path(frame.module).name)[0] in RUNTIME


def is_own(frame, tree):
    # The tree has symbols, so that a place of its files without one is another file's, which is unloaded.
    return frame.function != "<null>" and pathlib.Path(frame.module).is_relative_to(tree) and \
        not any(fnmatch.fnmatchcase(frame.function, pattern) for pattern in LINKED)


def asker(stack):
    """Returns the frame that asked for memory, or None."""
    return next((frame for frame in stack if not is_runtime(frame)), None)


def read(path, tree):
    """Returns the Report of a file. Paths of sources are relative to the tree, or whole."""
    text = path.read_text(errors="replace")
    report = Report(FILE.search(path.name).group(1), path.stat().st_mtime, EXITED in text, BLIND in text)
    stack = None
    for line in text.splitlines():
        record, frame = RECORD.match(line), FRAME.match(line)
        if record:
            stack = []
            report.leaks.append((int(record.group(1)), stack))
        elif frame and stack is not None:
            function, source, module = frame.groups()
            stack.append(Frame(function, os.path.normpath(tree / source) if ":" in source else source, module))
        else:
            stack = None
    error = ERROR.search(text)
    if error:
        report.error = text[text.rfind("\n", 0, error.start()) + 1:].split("\nShadow bytes around")[0].split(EXITED)[0]
    elif not (report.looked or report.leaks or report.blind):
        report.error = text  # of a kind that is not known
    return report


def reports_of(folder, tree):
    return [read(path, tree) for path in sorted(folder.iterdir()) if FILE.search(path.name)]


def again(folder, tree, log):
    """Returns the names of failed tests that ran when a process could not look for leaks. Its report is removed."""
    failed = {short_name(test) for test in log if test["result"] not in GOOD}
    found = set()
    for path in sorted(folder.iterdir()):
        report = read(path, tree) if FILE.search(path.name) else None
        if report and report.blind and not report.error:
            tests = failed & set(tests_of(report, log))
            found |= tests
            if tests:
                path.unlink()
    return sorted(found)


def merge(first, second):
    """Writes both logs of meson into the second's file: of a test that ran again, what it said then. Returns whether
    all tests have passed."""
    tests = {short_name(test): test for log in (first, second) for test in log_of(log)}
    second.write_text("".join(json.dumps(test) + "\n" for test in tests.values()))
    return all(test["result"] in GOOD for test in tests.values())


def log_of(path):
    """Returns the entries of meson's testlog.json, none where there is no such file."""
    return [json.loads(line) for line in path.read_text(errors="replace").splitlines()] if path.exists() else []


def short_name(test):
    return test["name"].split(" / ")[-1]


def rows(path):
    """Returns the rows of a table. Raises BadTable for one without a reason, or that any stack would fit."""
    table = tomllib.loads(path.read_text()).get("leak", [])
    for row in table:
        if not row.get("reason") or not set(row) <= {"function", "source", "program", "reason"} or \
                not set(row) & {"function", "source"}:
            raise BadTable(f"{path.name}: a row has a reason, and a function, a source or both: {row}")
    return table


def fits(row, program, stack):
    """Returns whether a row is of a leak: one frame of the stack has the function and the source."""
    return fnmatch.fnmatchcase(program, row.get("program", "*")) and any(
        fnmatch.fnmatchcase(frame.function, row.get("function", "*")) and
        fnmatch.fnmatchcase(frame.source.removeprefix(f"{ROOT}/"), row["source"] + ":*" if "source" in row else "*")
        for frame in stack)


def tests_of(report, log):
    """Returns the names of the tests, of meson's log, that ran when a process ended: those that run the program
    itself, if any does."""
    during = [test for test in log if test["starttime"] <= report.time + 0.1 and
              report.time <= test["starttime"] + test["duration"] + 0.1]
    own = [test for test in during if any(pathlib.Path(word).name == report.program for word in test["command"])]
    return [short_name(test) for test in own or during]


def names(words, count=4):
    """Returns distinct words, most frequent first, of which some are named."""
    distinct = [word for word, _ in collections.Counter(words).most_common()]
    return ", ".join(distinct[:count]) + (f" and {len(distinct) - count} more" if len(distinct) > count else "")


def judge(folder, tree, log, table):
    """Returns the part of a suite, and the rows of the table that were needed by their places in it."""
    reports = reports_of(folder, tree)
    part = {"name": "leaks", "passed": 0, "failed": 0, "skipped": 0, "failures": [], "skips": {}}
    leaks, errors, used = collections.defaultdict(list), collections.defaultdict(list), set()
    faulty = signals = blind = 0
    for report in reports:
        stacks, tests = set(), tests_of(report, log)
        for size, stack in report.leaks:
            by = asker(stack)
            if not by or not is_own(by, tree):
                continue
            of = {at for at, row in enumerate(table) if fits(row, report.program, stack)}
            used |= of
            if not of:
                stacks.add(tuple(stack))
                leaks[tuple(stack)].append((report.program, tests, size))
        if report.error and SIGNAL.search(report.error):
            signals += 1
            print(f"a signal ended {report.program}{during(tests)}: {summary(report.error)}")
            continue
        if report.blind and not report.error:
            blind += 1
            print(f"leaks could not be looked for in {report.program}{during(tests)}")
            continue
        if report.error:
            errors[f"{report.program}: {summary(report.error)}"].append((report.error, tests))
        faulty += bool(stacks or report.error)
    say_leaks(leaks, part)
    for name, found in errors.items():
        said = f"{name}{during(sum((tests for _, tests in found), []))}"
        print(f"\n{said}, {len(found)} times\n{found[0][0]}")
        part["failures"].append(said)
    if blind > BLIND_SHARE * len(reports):
        part["failures"].append(f"leaks could not be looked for in {blind} of {len(reports)} processes")
    looked = len(reports) - signals - blind
    part["passed"], part["failed"] = looked - faulty, len(part["failures"])
    print(f"\n{looked} processes looked for leaks, {faulty} failed; {blind} could not; "
          f"{signals} more were ended by a signal")
    return part, used


def during(tests):
    return f" (in {names(tests)})" if tests else ""


def summary(text):
    """Returns the line of a report that says what is wrong."""
    found = re.search(r"^SUMMARY: \w+: (.*)$", text, re.M) or ERROR.search(text)
    line = found.group(1) if found and found.re is not ERROR else text.strip().split("\n")[0]
    return re.sub(r"(?:[^/ ]+/)?\.\./", "", line.replace(f"{ROOT}/", ""))[:140]


def say_leaks(leaks, part):
    """Prints each stack that leaks once, with the programs and tests of its leaks."""
    for at, (stack, found) in enumerate(sorted(leaks.items(), key=lambda each: -len(each[1]))):
        programs, tests = [each[0] for each in found], sum((each[1] for each in found), [])
        own = next((frame for frame in stack if frame.source.startswith(f"{ROOT}/")), asker(stack))
        failure = f"{names(programs)}{during(tests)}: {own}"
        part["failures"] += [failure] if failure not in part["failures"] else []
        if at < SHOWN:
            print(f"\n{sum(each[2] for each in found)} bytes in {len(found)} leaks of {names(programs)}{during(tests)}")
            for frame in stack[:SHOWN]:
                print(f"    {frame}")
    if len(leaks) > SHOWN:
        print(f"\nand {len(leaks) - SHOWN} other stacks")


def main(words):
    verb, words = (words or [""])[0], words[1:]
    if verb == "options" and len(words) == 1:
        print(OPTIONS.format(words[0]))
        return 0
    if verb == "merge" and len(words) == 2:
        return 0 if merge(*map(pathlib.Path, words)) else 1
    if (verb, len(words)) not in (("again", 2), ("judge", 3), ("judge", 4)) or words[3:] not in ([], ["whole"]):
        print(__doc__, file=sys.stderr)
        return 2
    folder, tree = map(pathlib.Path, words[:2])
    tests = log_of(tree / "meson-logs/testlog.json")
    if verb == "again":
        print(*again(folder, tree.resolve(), tests), sep="\n")
        return 0
    target = pathlib.Path(words[2])
    table = rows(TABLE)
    part, used = judge(folder, tree.resolve(), tests, table)
    if words[3:]:
        for at in sorted(set(range(len(table))) - used):
            print(f"leaks.toml: nothing leaks as this row has it: {table[at]}")
        if not part["passed"] + part["failed"]:
            part["failed"], part["failures"] = 1, ["no process has looked for leaks"]
    target.write_text(json.dumps(part) + "\n")
    return 1 if part["failed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
