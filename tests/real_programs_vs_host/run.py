#!/usr/bin/env python3
"""Checks that unmodified programs from Debian draw the same with Arbiter as without it.

  run.py --list                       the programs and their packages
  run.py --packages [NAME...]         only the packages, for a script that installs them
  run.py [NAME...] --build DIR        runs them on the bare host and with the layer, and compares
  run.py [NAME...] --texts DIR        records them on the bare host; writes each program string there

Each reproducible case runs twice on the bare host and once with the layer for each profile; recordings/
compares recordings of all, frame by frame. A case passes if the pictures agree within its tolerance and
the layer's statistics show that it compiled the fragment programs and drew with them.
"""

import argparse
import json
import shutil
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import evidence
import picture
import session
from cases import Case, PrepareError, Program
from programs import PROGRAMS


def main() -> int:
    options = _options()
    names = options.names or list(PROGRAMS)
    unknown = [n for n in names if n not in PROGRAMS]
    if unknown:
        print(f"run.py: no program named {', '.join(unknown)}; --list shows them", file=sys.stderr)
        return 2
    programs = [PROGRAMS[n] for n in names]
    if options.list:
        for program in programs:
            print(f"{program.name:10} {program.about}\n{'':10} {' '.join(program.packages)}")
        return 0
    if options.packages:
        print(" ".join(sorted({package for p in programs for package in p.packages})))
        return 0
    if options.texts:
        return _record(programs, options)
    return _compare(programs, options)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="programs; all if none is named")
    parser.add_argument("--list", action="store_true", help="print the programs and stop")
    parser.add_argument("--packages", action="store_true", help="print Debian packages and stop")
    parser.add_argument("--build", type=Path, default=Path("build"), help="Meson's build folder")
    parser.add_argument("--library", type=Path, help="the layer, if not in the build folder")
    parser.add_argument("--profile", action="append", help="default: r300 and host")
    parser.add_argument("--case", help="only cases whose name contains this")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "arbiter-real",
                        help="prepared inputs, kept between runs (default: %(default)s)")
    parser.add_argument("--out", type=Path, help="pictures, logs, result.json (default: WORK/out)")
    parser.add_argument("--counts", type=Path, help="file for the counts, as JSON")
    parser.add_argument("--texts", type=Path, metavar="DIR",
                        help="record under apitrace on the bare host and extract program strings")
    return parser.parse_args()


def _cases(program: Program, options: argparse.Namespace) -> list[Case]:
    work = (options.work / program.name).absolute()
    work.mkdir(parents=True, exist_ok=True)
    return [c for c in program.cases(work) if not options.case or options.case in c.name]


def _compare(programs: list[Program], options: argparse.Namespace) -> int:
    library = options.library or options.build / "src/interposer/libGLX_arbiter.so.0"
    if not library.exists():
        print(f"run.py: {library} is not there; build it, or name it with --library",
              file=sys.stderr)
        return 2
    profiles = options.profile or ["r300", "host"]
    modes = [session.Mode(p, library.absolute(), p) for p in profiles]
    out = (options.out or options.work / "out").absolute()
    rows = []
    for program in programs:
        try:
            for case in _cases(program, options):
                if not case.recorded:
                    rows += _run_case(program, case, modes, out / case.name)
        except PrepareError as error:
            print(f"{program.name}: cannot be prepared: {error}")
            rows.append({"program": program.name, "case": "-", "mode": "-", "verdict": "fail",
                         "reason": str(error)})
        finally:
            program.finish((options.work / program.name).absolute())
    out.mkdir(parents=True, exist_ok=True)
    (out / "result.json").write_text(json.dumps({"schema": 1, "rows": rows}, indent=1) + "\n")
    failures = [f"{r['program']}, {r['case']}, {r['mode']}: {r['reason']}" for r in rows if r["verdict"] != "pass"]
    failed, passed = len(failures), len(rows) - len(failures)
    if options.counts:
        options.counts.write_text(json.dumps({"name": "real", "passed": passed, "failed": failed,
                                              "skipped": 0, "failures": failures, "skips": {}}) + "\n")
    print(f"pictures and result.json: {out}")
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


def _run_case(program: Program, case: Case, modes: list[session.Mode], out: Path) -> list[dict]:
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    bare, again = (session.run(case, session.Mode("bare"), out / name)
                   for name in ("bare", "again"))
    head = {"program": program.name, "case": case.name}
    problem = _problem(case, bare) or _problem(case, again)
    if problem:
        row = {**head, "mode": "bare", "verdict": "fail", "reason": f"bare host: {problem}"}
        return [_print(row)]
    picture.write_png(out / "bare.png", bare.picture)
    repeat = picture.compare(bare.picture, again.picture)
    rows = []
    for mode in modes:
        outcome = session.run(case, mode, out / mode.name)
        row = {**head, "mode": mode.name, "seconds": [round(bare.seconds, 2),
                                                      round(outcome.seconds, 2)],
               "repeat_maximum": repeat.maximum, "status": outcome.status}
        rows.append(_print(_judge(case, bare, outcome, row, out)))
    return rows


def _judge(case: Case, bare: session.Outcome, outcome: session.Outcome, row: dict,
           out: Path) -> dict:
    summary = evidence.summarise(outcome.stats)
    row = {**row, **summary}
    reasons = [_problem(case, outcome)]
    reasons += evidence.problems(summary, case.least_programs, case.refused)
    if outcome.picture is not None:
        apart = picture.compare(bare.picture, outcome.picture)
        row |= asdict(apart)
        shown = [bare.picture, outcome.picture]
        if apart.same_size and not apart.identical:
            shown.append(picture.magnified(*shown))
        picture.write_png(out / f"{row['mode']}.png", picture.side_by_side(shown))
        if not apart.same_size:
            reasons.append("pictures of different size")
        elif apart.maximum > case.maximum or apart.mean > case.mean:
            reasons.append(f"differs: maximum {apart.maximum} (allowed {case.maximum}), "
                           f"mean {apart.mean:.4f} (allowed {case.mean})")
    reasons = [r for r in reasons if r]
    return {**row, "verdict": "fail" if reasons else "pass", "reason": "; ".join(reasons)}


def _problem(case: Case, outcome: session.Outcome) -> str:
    """Returns what is wrong with a run by itself; empty if nothing is."""
    last = " | ".join(outcome.log.strip().splitlines()[-2:])[-200:]
    if outcome.status not in case.statuses:
        return f"status {outcome.status} ({last})"
    if outcome.picture is None:
        return f"no picture ({last})"
    return "the picture is blank" if outcome.picture.is_blank() else ""


def _print(row: dict) -> dict:
    figures = (f"max {row['maximum']:3} mean {row['mean']:.4f}" if "maximum" in row else "")
    counts = (f"programs {row['programs']:2} draws {row['draws_programs']:5}"
              if "programs" in row else "")
    print(f"{row['verdict']:4} {row['case']:20} {row['mode']:6} {figures:20} {counts:26} "
          f"{row['reason']}", flush=True)
    return row


def _record(programs: list[Program], options: argparse.Namespace) -> int:
    out = (options.out or options.work / "out").absolute()
    failures = 0
    for program in programs:
        try:
            for case in _cases(program, options):
                count = evidence.record(case, out / case.name, options.texts)
                print(f"{case.name:20} {count} fragment program strings loaded on the bare host",
                      flush=True)
                failures += count < case.least_programs
        except PrepareError as error:
            print(f"{program.name}: cannot be prepared: {error}")
            failures += 1
        finally:
            program.finish((options.work / program.name).absolute())
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
