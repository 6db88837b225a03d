"""Checks that recordings of programs draw the same with Arbiter as without it, in every frame.

  python3 tests/real_programs_vs_host/recordings [NAME...] --build DIR     programs of ../programs
  python3 tests/real_programs_vs_host/recordings --trace FILE --build DIR  a trace of apitrace's

A program is recorded once on the bare host; its trace stays in --work. Each trace is replayed
twice on the bare host. The frames on which the two agree are compared with those of a run with the
layer: the back end `auto` with cold and with warm caches, `swrast`, `host`, all with the profile
host, and the default profile. A frame is wrong if more than 60 pixels differ by more than 3 %.
"""

import argparse
import json
import sys
import tempfile
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from cases import PrepareError
from recordings import table
from recordings.chosen import SHARED, Choice
from recordings.judge import Row, compare
from recordings.replay import Way, ways


def main() -> int:
    options = _options()
    choice = Choice(options.names, options.trace, options.case, options.work, options.frames)
    if choice.unknown():
        return _refuse(f"no program named {', '.join(choice.unknown())}; run.py --list shows them")
    library = options.library or options.build / "src/interposer/libGLX_arbiter.so.0"
    if not library.exists():
        return _refuse(f"{library} is not there; build it, or name it with --library")
    chosen = ways(library.absolute())
    if options.way:
        known = {way.name: way for way in chosen}
        missing = [name for name in options.way if name not in known]
        if missing:
            return _refuse(f"no way named {', '.join(missing)}; there are {', '.join(known)}")
        chosen = [known[name] for name in options.way]
    rows = _compare_all(options, choice, chosen)
    table.write(rows, chosen)
    return _report(rows, options)


def _refuse(text: str) -> int:
    print(f"recordings: {text}", file=sys.stderr)
    return 2


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="recordings", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help="programs; without NAME and --trace all, and the traces of "
                             "../shared/cases where that is")
    parser.add_argument("--trace", type=Path, action="append", default=[], metavar="FILE",
                        help="a trace to compare; may be given again")
    parser.add_argument("--case", help="only cases whose name contains this")
    parser.add_argument("--way", action="append", help="only this way; may be given again")
    parser.add_argument("--build", type=Path, default=Path("build"), help="Meson's build folder")
    parser.add_argument("--library", type=Path, help="the layer, if not in the build folder")
    parser.add_argument("--frames", type=int, default=120,
                        help="of a longer trace only the first so many (default: %(default)s)")
    parser.add_argument("--timeout", type=float, default=300.0,
                        help="seconds for one replay (default: %(default)s)")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "arbiter-real",
                        help="inputs and traces, kept between runs (default: %(default)s)")
    parser.add_argument("--out", type=Path,
                        help="pictures, logs, recordings.json (default: WORK/recordings)")
    parser.add_argument("--counts", type=Path, help="file for the counts, as JSON")
    return parser.parse_args()


def _compare_all(options: argparse.Namespace, choice: Choice, chosen: list[Way]) -> list[Row]:
    out = (options.out or options.work / "recordings").absolute()
    if choice.everything and not choice.files():
        print(f"recordings: there are no traces in {SHARED}: they are left out (name them with --trace)",
              file=sys.stderr)
    rows: list[Row] = []
    for make in choice.recordings():
        try:
            recording = make()
            rows += compare(recording, chosen, out / recording.name, options.timeout,
                            table.progress)
        except PrepareError as error:
            row = Row("-", "-", "-", problems=[f"cannot be prepared: {error}"])
            table.progress(row)
            rows.append(row)
    return rows


def _report(rows: list[Row], options: argparse.Namespace) -> int:
    out = (options.out or options.work / "recordings").absolute()
    out.mkdir(parents=True, exist_ok=True)
    failures = [f"{row.recording}, {row.way}: {row.reason}" for row in rows if not row.passed]
    failed, passed = len(failures), len(rows) - len(failures)
    listed = [{**asdict(row), "reason": row.reason,
               "verdict": "pass" if row.passed else "fail"} for row in rows]
    (out / "recordings.json").write_text(json.dumps({"schema": 1, "rows": listed}, indent=1) + "\n")
    if options.counts:
        options.counts.write_text(json.dumps({"name": "recordings", "passed": passed,
                                              "failed": failed, "skipped": 0, "failures": failures,
                                              "skips": {}}) + "\n")
    print(f"pictures of wrong frames and recordings.json: {out}")
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
