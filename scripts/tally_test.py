"""Plants cases for tally.py: counts, names of failures, reasons of skips, owners."""

import json
import pathlib
import tempfile

import skips
import tally
import tally_log

GTEST_SKIP = """[ RUN      ] Queries.ByName
../tests/queries_test.cpp:54: Skipped
bare host: counts
the text
[  SKIPPED ] Queries.ByName (0 ms)
[ RUN      ] Queries.All
[       OK ] Queries.All (0 ms)
"""
GTEST_FAIL = """[ RUN      ] A.One
../a_test.cpp:3: Failure
[  FAILED  ] A.One (0 ms)
[ RUN      ] Cpus/A.Two/1
[  FAILED  ] Cpus/A.Two/1, where GetParam() = 4 (0 ms)
[  PASSED  ] 3 tests.
[  FAILED  ] 2 tests, listed below:
[  FAILED  ] A.One
[  FAILED  ] Cpus/A.Two/1, where GetParam() = 4
"""
UNITTEST = """test_a (__main__.Doctor.test_a) ... skipped 'no man on this machine'
test_b (__main__.Doctor.test_b)
Says so. ... ok
======================================================================
FAIL: test_c (__main__.Doctor.test_c)
======================================================================
ERROR: test_d (__main__.Doctor)
----------------------------------------------------------------------
Ran 5 tests in 0.002s

FAILED (failures=1, errors=1, skipped=1)
"""
PLANTED = "skip of the self-test: planted\nFAIL of the self-test\n"
RUNNER = PLANTED + "pass a\nFAIL b, swrast:  2 differ\nskip c, 3 from 1: the host lacks it: status 77: no imaging\n"

# (an entry of meson's log, counts, names of failures, reasons of skips)
LOG = [
    ({"result": "OK", "stdout": "[  PASSED  ] 12 tests.\n"}, [12, 0, 0], [], {}),
    ({"result": "FAIL", "stdout": GTEST_FAIL}, [3, 2, 0], ["A.One", "Cpus/A.Two/1"], {}),
    ({"result": "FAIL", "stdout": "[  PASSED  ] 1 test.", "returncode": 1}, [1, 1, 0],
     ["status 1: [  PASSED  ] 1 test."], {}),
    ({"result": "FAIL", "stdout": GTEST_SKIP + "[ RUN      ] Queries.Dies\n", "returncode": -11}, [1, 1, 1],
     ["Queries.Dies: signal 11"], {"bare host": 1}),
    ({"result": "OK", "stdout": GTEST_SKIP + "[  PASSED  ] 1 test.\n[  SKIPPED ] 1 test, listed below:\n"}, [1, 0, 1],
     [], {"bare host": 1}),
    ({"result": "SKIP", "stdout": ""}, [0, 0, 1], [], {tally_log.NO_REASON: 1}),
    ({"result": "SKIP", "stdout": "x\n", "stderr": "texts: no GL context: no display\n"}, [0, 0, 1], [],
     {"no GL context": 1}),
    ({"result": "SKIP", "stdout": "0 passed, 0 failed, 1 skipped: this processor has no avx2\n"}, [0, 0, 1], [],
     {"this processor has no avx2": 1}),
    ({"result": "OK", "stdout": "x\n5 passed, 0 failed, 2 skipped\n"}, [5, 0, 2], [], {tally_log.NO_REASON: 2}),
    ({"result": "OK", "stdout": PLANTED + "5 passed, 0 failed, 0 skipped\n"}, [5, 0, 0], [], {}),
    ({"result": "FAIL", "stdout": RUNNER + "1 passed, 1 failed, 1 skipped\n", "returncode": 1}, [1, 1, 1],
     ["b, swrast: 2 differ"], {"the host lacks it": 1}),
    ({"result": "FAIL", "stdout": "", "stderr": UNITTEST, "returncode": 1}, [2, 2, 1],
     ["Doctor.test_c", "Doctor.test_d"], {"no man on this machine": 1}),
    ({"result": "OK", "stdout": "", "stderr": "...\nRan 3 tests in 0.1s\n\nOK (skipped=1)\n"}, [2, 0, 1], [],
     {tally_log.NO_REASON: 1}),
    ({"result": "TIMEOUT"}, [0, 1, 0], ["timed out"], {}),
    ({"result": "FAIL", "stderr": "run.py: no such row\n", "returncode": 2}, [0, 1, 0],
     ["status 2: run.py: no such row"], {}),
]
# (status, whether it is one case, output, the part that the step left, [passed, failed, skipped, failures])
STEPS = [
    (0, False, "nothing to count\n", None, [1, 0, 0, []]),
    (3, False, "a complaint\n", None, [0, 1, 0, ["status 3: a complaint"]]),
    (77, False, "step: skipped: no network\n", None, [0, 0, 1, []]),
    (0, False, "7 passed, 0 failed, 0 skipped\n", None, [7, 0, 0, []]),
    (1, False, "FAIL b\n6 passed, 1 failed, 0 skipped\n", None, [6, 1, 0, ["b"]]),
    (0, True, "7 passed, 0 failed, 0 skipped\n", None, [1, 0, 0, []]),
    (1, True, "7 passed, 0 failed, 0 skipped\nbad format\n", None, [0, 1, 0, ["status 1: bad format"]]),
    (1, False, "", [4, 1, 0, ["its own"]], [4, 1, 0, ["its own"]]),
    (9, False, "died\n", [4, 0, 0, []], [4, 1, 0, ["status 9: died"]]),
]
TABLE = """[[skip]]
reasons = ["GL_* is not offered here"]
test = "api-layered-nv40-*"

[[skip]]
reasons = ["this processor has no *", "GL_EXT_x is not offered here"]
nowhere = "no such processor"

[[skip]]
reasons = ["needs root"]
machine = "any, for root"
"""
BAD_TABLES = ['[[skip]]\nreasons = ["a"]\n', '[[skip]]\nreasons = ["a"]\ntest = "b"\nsuite = "c"\n',
              '[[skip]]\nreasons = ["a", "a"]\ntest = "b"\n', '[[skip]]\nreasons = ["a"]\nsuite = "nosuch"\n']


def of_part(part):
    return [part["passed"], part["failed"], part["skipped"], part["failures"]]


def check_log():
    for test, counts, failures, reasons in LOG:
        got = tally.cases(test)
        assert [got.passed, got.failed, got.skipped] == counts, (test, got)
        assert got.failures == failures and got.skips == reasons, (test, got)
    return len(LOG)


def check_steps(folder):
    log, target = folder / "step.log", folder / "step.json"
    for status, is_one, text, left, expected in STEPS:
        log.write_text(text)
        target.unlink(missing_ok=True)
        if left:
            target.write_text(json.dumps(dict(zip(("passed", "failed", "skipped", "failures"), left), name="step")))
        tally.from_step("step", status, log, target, is_one)
        got = of_part(json.loads(target.read_text()))
        assert got == expected, (status, text, got)
    assert tally.total(folder) == 1
    tally.ended("whole", 3, folder)
    assert not (folder / "whole.json").exists(), "a step says already that it failed"
    target.unlink()
    tally.ended("whole", 3, folder)
    assert json.loads((folder / "whole.json").read_text())["failed"] == 1
    return len(STEPS) + 3


def entry(name, result="OK", case="A.B", reason=None):
    text = f"[ RUN      ] {case}\n" + (f"x.cpp:1: Skipped\n{reason}\n[  SKIPPED ] {case} (0 ms)\n" if reason else
                                       f"[       OK ] {case} (0 ms)\n")
    return json.dumps({"name": name, "command": ["/b/api_test"], "result": result, "stdout": text, "duration": 1.0})


def check_owners(folder):
    """Checks what has no row, what no test runs, rows that nothing needs, and bad tables."""
    log, table, part = folder / "log", folder / "skips.toml", folder / "parts/meson.json"
    part.parent.mkdir()
    table.write_text(TABLE)
    lacks, cpu = "GL_NV_x is not offered here", "this processor has no neon"
    # (entries of the log, complaints, unused rows)
    planted = [
        ([entry("a", reason=lacks), entry("b")], 0, 2),
        ([entry("a", reason=lacks), entry("b", reason=lacks)], 1, 2),
        ([entry("a", reason=lacks), entry("b", case="A.C")], 1, 2),
        ([entry("a", reason=cpu)], 0, 2),
        ([entry("a", reason="GL_EXT_x is not offered here")], 0, 2),
        ([entry("a", reason="of no row"), entry("b", reason=cpu)], 1, 2),
        ([entry("a")], 0, 3),
    ]
    for entries, wrong, rest in planted:
        log.write_text("\n".join(entries) + "\n")
        (part.parent / "skips.json").unlink(missing_ok=True)
        tally.from_meson(log, part, True)
        assert tally.owned(part.parent, table) == (wrong > 0), entries
        assert (part.parent / "skips.json").exists() == (wrong > 0), entries
        assert len(skips.complaints(skips.rows(table), skips.parts_of(part.parent)[:1])) == wrong, entries
        assert len(skips.unused(skips.rows(table), skips.parts_of(part.parent))) == rest, entries
    log.write_text(entry("a", reason=lacks) + "\n")
    tally.from_meson(log, part, False)  # one test alone may well skip it
    assert tally.owned(part.parent, table) == 0
    for text in BAD_TABLES:
        table.write_text(text)
        try:
            skips.rows(table)
        except skips.BadTable:
            continue
        raise AssertionError(text)
    return len(planted) + 1 + len(BAD_TABLES)


def main():
    with tempfile.TemporaryDirectory(prefix="arbiter-tally-") as folder:
        steps = pathlib.Path(folder) / "steps"
        steps.mkdir()
        count = check_log() + check_steps(steps) + check_owners(pathlib.Path(folder))
    assert skips.rows(skips.TABLE)
    print("%d passed, 0 failed, 0 skipped" % (count + 1))
    return 0
