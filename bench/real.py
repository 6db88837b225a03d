#!/usr/bin/env python3
"""Measures how much faster recorded real programs are with Arbiter than on the bare host, in turns.

Each recording (tests/real_programs_vs_host/recordings says where they come from) is cut behind its last
swap and replayed by glretrace, its last frame looped. `bare` and `layered` are milliseconds of that frame,
`faster` is bare by layered, `cpu` the ratio of processor times. `cold` is the time to the end of the first
frame with empty caches, including the host's; `warm` is that time with the caches of a run that replayed
everything. `b. cold` and `b. warm` are the bare host's. `hosts` is the share of draws that are left to the
host, with the reasons below. A recording without a swap is replayed as a whole.

examples:
  bench/real.py build-bench
  bench/real.py build-bench gem irrlicht --seconds 3
  bench/real.py build-bench --trace FILE --backend swrast
"""

import json
import math
import pathlib
import statistics
import sys
import tempfile

import replays
from machine import describe, heading
from paced import layered_parser, parse_layered
from replays import Side

from cases import PrepareError
from recordings.chosen import Choice
from x_server import XServer


def parse(argv):
    parser = layered_parser(__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME",
                        help="programs of tests/real_programs_vs_host; without NAME and --trace all")
    parser.add_argument("--trace", type=pathlib.Path, action="append", default=[], metavar="FILE")
    parser.add_argument("--case", help="only cases whose name contains this")
    parser.add_argument("--backend", default="auto", choices=("auto", "swrast", "host"))
    parser.add_argument("--fixed-function", choices=("always", "programs"),
                        help="whose draws without a program are (default: as the layer has it)")
    parser.add_argument("--turns", type=int, default=3, help="of each side (default: %(default)s)")
    parser.add_argument("--seconds", type=float, default=1.5,
                        help="that the last frame is looped for in a turn (default: %(default)s)")
    parser.add_argument("--frames", type=int, default=120,
                        help="of a longer trace only the first so many (default: %(default)s)")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "arbiter-real",
                        help="inputs and traces, kept between runs (default: %(default)s)")
    args = parse_layered(parser, argv)
    args.choice = Choice(args.names, args.trace, args.case, args.work, args.frames)
    if args.choice.unknown():
        parser.error(f"no program named {', '.join(args.choice.unknown())}; "
                     "tests/real_programs_vs_host/run.py --list shows them")
    return args


def measure(recording, args, scratch):
    """Measures a row: all figures of one recording."""
    bare = Side("bare", args.display, scratch / "bare-cache")
    layered = Side("layered", args.display, scratch / "cache", args.layer, args.backend,
                   args.fixed_function)
    row = {"recording": recording.name, "programs": 0}
    traces = replays.cut(recording.trace, scratch / "traces")
    run = scratch / "run"
    if traces:
        whole, first = traces
        row["kind"] = "frame"
        firsts = replays.first_frames(recording, whole, first, [bare, layered], run, args.turns)
        row["first"] = {"bare_cold": firsts[0][0], "cold": firsts[1][0],
                        "bare_warm": firsts[0][1], "warm": firsts[1][1]}
        sides = replays.steady(recording, whole, [bare, layered], run, args.seconds, args.turns)
        row.update(bare=sides[0].wall, layered=sides[1].wall, loops=[side.loops for side in sides],
                   bare_cpu=sides[0].processor, layered_cpu=sides[1].processor)
        stats = sides[1].stats
    else:
        row["kind"] = "whole"
        runs = [[replays.replay(recording, recording.trace, side, run) for side in (bare, layered)]
                for _ in range(args.turns + 1)][1:]  # the first run fills the caches
        for place, name in enumerate(("bare", "layered")):
            row[name] = 1000 * statistics.median(pair[place].seconds for pair in runs)
            row[f"{name}_cpu"] = 1000 * statistics.median(pair[place].processor for pair in runs)
        stats = runs[-1][1].stats
    row["faster"] = row["bare"] / row["layered"]
    row["faster_cpu"] = row["bare_cpu"] / row["layered_cpu"] if row["layered_cpu"] > 0 else None
    row.update(draws_of(stats))
    return row


def draws_of(stats):
    """Returns who made the draws, from the layer's statistics."""
    software = stats.get("software") or {}
    given = software.get("given_to_host", {})
    drawn = software.get("drawn", 0)
    every = drawn + sum(given.values())
    return {"programs": len(stats.get("programs", [])), "drawn": drawn, "given_to_host": given,
            "hosts_share": sum(given.values()) / every if every else None}


def text_of(row):
    first = row.get("first")
    shown = (" ".join(f"{first[name]:7.1f}" for name in ("bare_cold", "cold", "bare_warm", "warm"))
             if first else f"{'':31}")
    share = "" if row["hosts_share"] is None else f"{100 * row['hosts_share']:.1f} %"
    cpu = f"{row['faster_cpu']:5.2f}" if row["faster_cpu"] else "    -"
    return (f"{row['recording']:26} {row['bare']:9.2f} {row['layered']:9.2f} {row['faster']:7.2f} {cpu} "
            f"{shown} {share:>8}{'  whole' if row['kind'] == 'whole' else ''}")


def mean(rows):
    return math.exp(statistics.fmean(math.log(row["faster"]) for row in rows)) if rows else None


def summary(rows):
    """Returns geometric means and the slowest, with program texts and without."""
    found = {}
    for name, some in (("with programs", [r for r in rows if r["programs"]]),
                       ("without programs", [r for r in rows if not r["programs"]])):
        if some:
            slowest = min(some, key=lambda row: row["faster"])
            found[name] = {"recordings": len(some), "mean": mean(some), "slowest": slowest["faster"],
                           "slowest_is": slowest["recording"]}
    return found


def main(argv=None):
    args = parse(sys.argv[1:] if argv is None else argv)
    machine = describe()
    print(f"{heading(machine)}; "
          f"ARBITER_BACKEND={args.backend}\n\n{'recording':26} {'bare ms':>9} {'layered':>9} {'faster':>7} "
          f"{'cpu':>5} {'b. cold':>7} {'cold':>7} {'b. warm':>7} {'warm':>7} {'hosts':>8}", flush=True)
    rows, failed = [], []
    with XServer("1280x1024x24") as args.display, \
            tempfile.TemporaryDirectory(prefix="arbiter-bench-real-") as scratch:
        for make in args.choice.recordings():
            name = "-"
            try:
                recording = make()
                name = recording.name
                if sys.stderr.isatty():
                    print(f"\r{name} ..", end="\r", file=sys.stderr, flush=True)
                row = measure(recording, args, pathlib.Path(scratch) / name)
            except PrepareError as error:
                failed.append({"recording": name, "problem": str(error)})
                print(f"{name:26} not measured: {error}", flush=True)
                continue
            rows.append(row)
            print(text_of(row), flush=True)
            for reason, count in sorted(row["given_to_host"].items(), key=lambda pair: -pair[1]):
                print(f"{'':28}{count} of the host: {reason}", flush=True)
    means = summary(rows)
    for name, of in means.items():
        print(f"\n{name}: {of['recordings']} recordings, geometric mean {of['mean']:.2f} times, "
              f"slowest {of['slowest']:.2f} ({of['slowest_is']})")
    if args.json:
        args.json.parent.mkdir(parents=True, exist_ok=True)
        args.json.write_text(json.dumps({"schema": 1, "machine": machine, "backend": args.backend,
                                         "rows": rows, "not_measured": failed, "means": means}, indent=1) + "\n")
    return 1 if failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())
