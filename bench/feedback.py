#!/usr/bin/env python3
"""Measures how much faster the rasterizer is than the bare host, side by side in one run.

Each row launches the same client twice, bare and with the layer in front (ARBITER_BACKEND=auto
unless stated otherwise). They take turns batch by batch. A frame is one draw, the feedback copy if
there is one, and a finish. `times faster` is the median over the turns of bare / layered, with the
interval that holds the true median 95 times in 100, and the acceptance bound beside it.

  workloads    the seven programs, headless; and their geometric mean
  window       the same programs, each frame shown in a GLX window on an Xvfb of its own
  sizes        the layer's cost a pixel from 256x256 to 4096x4096
  passes       cost a pixel of a linear filter at 1:1, from 256x256 to 4096x4096, including sizes of
               films and windows; beside it the cost of a nearest filter
  threads      two threads of the rasterizer against one
  scene        100,000 triangles with depth, blending and per-pixel lighting
  first-draw   from a program's text to its first finished frame, 100 generated programs
  memory       peak resident size beyond the bare host's, relative to the application's images
  small        draws of a few pixels each, which gain nothing: no more than 1.05x the bare host

examples:
  bench/feedback.py build-bench
  bench/feedback.py build-bench --part workloads --size 2048 --threads 1 --turns 31
"""

import collections
import json
import pathlib
import sys
import tempfile

import paced
from feedback_rows import first_draw_rows, memory_rows, pass_rows, \
    scene_rows, size_rows, small_rows, \
    thread_rows, window_rows, workload_rows
from machine import describe, heading
from verdicts import finish

PARTS = {"workloads": workload_rows, "window": window_rows, "sizes": size_rows, "passes": pass_rows,
         "threads": thread_rows, "scene": scene_rows, "first-draw": first_draw_rows,
         "memory": memory_rows, "small": small_rows}


def parse(argv):
    parser = paced.layered_parser(__doc__)
    parser.add_argument("--part", action="append", choices=PARTS, help="may be repeated")
    parser.add_argument("--workload", action="append", metavar="TEXT",
                        help="only workloads whose name has TEXT; may be repeated")
    parser.add_argument("--size", type=int, default=1024, help="edge of the pictures")
    parser.add_argument("--threads", type=int, default=0, help="of the rasterizer; 0: its default")
    parser.add_argument("--cpu", default="", choices=("avx512", "avx2", "sse4.1"),
                        help="the rasterizer as on a lesser processor, the bare host's too under sse4.1: "
                        "of workloads the mean alone has a bound then")
    parser.add_argument("--backend", default="auto", choices=("auto", "swrast", "host"))
    parser.add_argument("--turns", type=int, default=21, help="of each side of a row")
    parser.add_argument("--self-test", action="store_true", help="small and few: do the rows run?")
    args = paced.parse_layered(parser, argv)
    if args.self_test:
        args.size, args.turns = 64, 3
        paced.REACH_PACE_S = 0.1
    return args


def text_of(row):
    """Returns a row as text; its bound_is says whether the bound is the `least` or the `most`."""
    bound = ""
    if row.get("bound") is not None:
        bound = f"{'>=' if row['bound_is'] == 'least' else '<='} {row['bound']:g}"
    spread = f"{row['low']:.2f} .. {row['high']:.2f}" if "low" in row else ""
    sides = [f"{row[side]:.3f}" if side in row else "" for side in ("bare", "layered")]
    return (f"{row['name']:<44} {sides[0]:>9} {sides[1]:>9} {row['unit']:<6}"
            f"{row['figure']:>8.2f} {spread:>17} {bound:>8}  "
            f"{row['verdict']}{'  ' + row['note'] if row.get('note') else ''}")


def judge(row):
    """Returns met, missed, or unclear if the interval contains the bound; nothing without a bound."""
    if row.get("bound") is None:
        return ""
    low, high = row.get("low", row["figure"]), row.get("high", row["figure"])
    if row["bound_is"] == "most":
        row_good, may_be = row["figure"] <= row["bound"], low <= row["bound"]
    else:
        row_good, may_be = row["figure"] >= row["bound"], high >= row["bound"]
    return "met" if row_good else "unclear" if may_be else "MISSED"


def main(argv=None):
    args = parse(sys.argv[1:] if argv is None else argv)
    machine = describe()
    print(f"{heading(machine)}; "
          f"{args.size}x{args.size}, ARBITER_BACKEND={args.backend}, "
          f"{args.threads or 'as many as processors'} threads"
          f"{', held to ' + args.cpu if args.cpu else ''}", flush=True)
    rows = []
    with tempfile.TemporaryDirectory(prefix="arbiter-feedback-") as scratch:
        args.scratch = pathlib.Path(scratch)
        for part in args.part or PARTS:
            print(f"\n{part:<44} {'bare':>9} {'layered':>9} {'':<6}{'figure':>8} "
                  f"{'95 of 100':>17} {'bound':>8}", flush=True)
            for row in PARTS[part](args, rows):
                row.update(part=part, verdict=judge(row))
                rows.append(row)
                print(text_of(row), flush=True)
    verdicts = collections.Counter(row["verdict"] for row in rows if row["verdict"])
    print("\nbounds: " + ", ".join(f"{count} {verdict}" for verdict, count in verdicts.items()))
    if args.json:
        args.json.parent.mkdir(parents=True, exist_ok=True)
        args.json.write_text(json.dumps(
            {"schema": 1, "machine": machine, "size": args.size, "backend": args.backend,
             "threads": args.threads, "cpu": args.cpu, "turns": args.turns, "rows": rows}, indent=1) + "\n")
    return 0 if args.self_test else finish(rows)


if __name__ == "__main__":
    sys.exit(main())
