"""Results of suites as `./dev release` leaves them, of two drivers, for the tests of the results page."""

import contextlib
import io
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(ROOT / "scripts"), str(ROOT / "docs" / "results")]
import collect  # noqa: E402
import tally  # noqa: E402

COMMIT, OTHER = "0123456789abcdef" * 2 + "01234567", "f" * 40
SUITES = collect.suites_of(HERE / "suites.toml")
MACHINE = {"renderer": "llvmpipe (LLVM 15.0.6, 256 bits)", "version": "2.1 Mesa 22.3.6", "compiler": "g++ 12.2.0",
           "system": "Debian GNU/Linux 12", "processor": "x86_64", "cores": 2, "name": "a machine's own name"}
NEWER = {**MACHINE, "renderer": "llvmpipe (LLVM 19.1.7, 256 bits)", "version": "2.1 Mesa 25.0.7-2",
         "system": "Debian GNU/Linux 13"}
LOG = [{"name": "layer / a", "result": "OK", "duration": 1, "stdout": "[  PASSED  ] 12 tests.\n"},
       {"name": "layer / b", "result": "OK", "duration": 1, "stdout": "5 passed, 0 failed, 2 skipped\n"},
       {"name": "layer / c", "result": "SKIP", "duration": 1, "stdout": ""}]


def part(name, passed, failed, skipped, failures=(), skips=None):
    return {"name": name, "passed": passed, "failed": failed, "skipped": skipped, "failures": list(failures),
            "skips": skips or {}}


def tallied(folder):
    """Returns the part that scripts/tally.py makes of a log of Meson's."""
    log, target = folder / "testlog.json", folder / "meson.json"
    log.write_text("".join(json.dumps(row) + "\n" for row in LOG))
    with contextlib.redirect_stdout(io.StringIO()):
        tally.from_meson(log, target, is_whole=False)
    return json.loads(target.read_text())


def suite(name, parts, machine, commit=COMMIT, status=None):
    """Returns a suite's file: the sum of its parts."""
    counts = {key: sum(each[key] for each in parts) for key in collect.COUNTS}
    skips = {}
    for each in parts:
        for reason, count in (each.get("skips") or {}).items():
            skips[reason] = skips.get(reason, 0) + count
    return {"schema": 1, "suite": name, "command": ["./dev", name], "commit": commit, "date": "2026-11-30T23:59:00Z",
            "seconds": 812, "status": bool(counts["failed"]) if status is None else status, **counts,
            "failures": [case for each in parts for case in each.get("failures") or []], "skips": skips,
            "parts": parts, "machine": machine}


def written(root, name, suites):
    """Writes the files of a run's folder, and returns the folder."""
    folder = root / name
    folder.mkdir(parents=True)
    for row in suites:
        (folder / (row["suite"] + ".json")).write_text(json.dumps(row))
    (folder / "state.json").write_text('{"left": []}')  # a note of the run's own
    return folder


def two_hosts(root):
    """Writes the runs of one commit on two drivers: one case failed, some were skipped, most suites did not run."""
    first = [suite("test", [tallied(root)], MACHINE),
             suite("piglit", [part("r300", 1200, 0, 34, skips={"needs GL 4.6": 30, "no display": 4}),
                              part("swrast", 1233, 1, 0, ["spec@a | b@<c> `d`.cpp: /home/me/tree/x.png"])], MACHINE),
             suite("check", [], MACHINE)]
    second = [suite("piglit", [part("r300", 1100, 0, 134, skips={"needs GL 4.6": 134})], NEWER),
              suite("fuzz", [part("front", 3, 0, 0)], NEWER, status=124)]
    return [written(root, f"{COMMIT}/llvmpipe", first), written(root, f"{COMMIT}/newer", second)]
