#!/usr/bin/env python3
"""Measures programs in NVIDIA's languages against ARB programs of the same meaning, under the profile nv40.

One client with the layer draws each pair of texts (nv_texts.cpp) in turns; the pictures of both are
compared first. A figure is the median over the turns of NV / ARB, with the interval that holds the
true median 95 times in 100.

  frame   512x512 pixels, or 25,600 quads of a grid whose triangles are all culled, and a finish
  load    from a program's name to its first finished draw, for texts that no cache has seen
  warm    the load in a process whose disk caches, including the host's, another process has filled

examples:
  bench/nv.py build-bench
  bench/nv.py build-bench --backend swrast --pair LOOP --part frame --turns 51
"""

import collections
import json
import pathlib
import statistics
import sys
import tempfile

from feedback import judge
from machine import describe, heading
from paced import TURN_MS, Client, environment, interval, layered_parser, parse_layered
from verdicts import finish

MOST = 1.15  # NV / ARB
APART = 0.001  # the fraction of pixels that may differ by more than 2 of 255
SIDES = ("ARB", "NV")
FRAME = "nv-frame/"


def parse(argv):
    parser = layered_parser(__doc__)
    parser.add_argument("--backend", action="append", choices=("swrast", "host"), help="may be repeated")
    parser.add_argument("--part", action="append", choices=PARTS, help="may be repeated")
    parser.add_argument("--pair", action="append", metavar="TEXT",
                        help="only pairs whose name has TEXT; may be repeated")
    parser.add_argument("--turns", type=int, default=21, help="of each side of a pair")
    parser.add_argument("--self-test", action="store_true", help="few turns: do the rows run?")
    args = parse_layered(parser, argv)
    args.turn_ms = TURN_MS
    if args.self_test:
        args.turns, args.turn_ms = 2, 2.0
    return args


class Layered(Client):
    """Runs bench-client under the layer; its statistics tell at the end whether the back end drew."""

    def __init__(self, args, backend, cache=None):
        self.stats, self.backend = args.scratch / "stats.json", backend
        self.stats.unlink(missing_ok=True)
        extra = {"ARBITER_PROFILE": "nv40", "ARBITER_BACKEND": backend,
                 "ARBITER_STATS": str(self.stats), "ARBITER_CACHE": "0",
                 "ARBITER_THREADS": "1", "LP_NUM_THREADS": "1"}  # programs are compared, not machines
        if cache:
            extra.update(ARBITER_CACHE="1", XDG_CACHE_HOME=str(cache), MESA_SHADER_CACHE_DIR=str(cache),
                         MESA_SHADER_CACHE_DISABLE="false")
        super().__init__([args.build / "bench/bench-client"], environment(args.layer, extra))

    def pairs(self, args):
        names = [name[len(FRAME):-len(", NV")] for name in self.ask("rows")
                 if name.startswith(FRAME) and name.endswith(", NV")]
        if not names:
            raise SystemExit(f"{args.layer}: the client sees none of NVIDIA's extensions")
        return [name for name in names if not args.pair or any(text in name for text in args.pair)]

    def sample(self, row, pair, side, count=1, seed=0):
        """Returns milliseconds."""
        times = self.ask(f"sample {count} {seed} nv-{row}/{pair}, {side}")
        if min(times) < 0:
            raise SystemExit(f"{pair}, {side}: rejected")
        return statistics.fmean(times) / 1e6

    def finish(self):
        """Checks that the rasterizer drew: otherwise the figures would be the host's."""
        self.close()
        software = json.loads(self.stats.read_text()).get("software") or {}
        if self.backend == "swrast" and not software.get("drawn"):
            raise SystemExit("swrast: the rasterizer has drawn nothing")


def in_turns(turns, sample):
    """Returns [(ARB, NV)] of sample(side, turn); the first side alternates."""
    rounds = []
    for turn in range(turns):
        times = {side: sample(side, turn) for side in (SIDES if turn % 2 else SIDES[::-1])}
        rounds.append([times[side] for side in SIDES])
    return rounds


def row_of(name, backend, rounds):
    low, figure, high = interval([nv / arb for arb, nv in rounds])
    return {"name": name, "backend": backend, "unit": "ms", "arb": statistics.median(r[0] for r in rounds),
            "nv": statistics.median(r[1] for r in rounds), "figure": figure, "low": low, "high": high,
            "bound": MOST, "bound_is": "most", "rounds": rounds}


def frame_rows(args, backend):
    client = Layered(args, backend)
    for pair in client.pairs(args):
        apart = client.ask(f"differ {pair}")
        if not 0 <= apart <= APART:
            raise SystemExit(f"{pair}: {100 * apart:.2f} % of the pixels differ: not of one meaning")
        counts = {}
        for side in SIDES:
            for count in (3, 10):  # machine code is compiled and tried meanwhile
                once = client.sample("frame", pair, side, count)
            counts[side] = max(1, round(args.turn_ms / once))
        yield row_of(pair, backend, in_turns(args.turns, lambda side, _: client.sample(
            "frame", pair, side, counts[side])))
    client.finish()


def load_rows(args, backend):
    client = Layered(args, backend)
    for pair in client.pairs(args):
        for side in SIDES:  # one-time work stays out of the figures
            client.sample("load", pair, side, 1, 300)
        yield row_of(pair, backend, in_turns(args.turns, lambda side, turn: client.sample(
            "load", pair, side, 1, turn)))
    client.finish()


def warm_rows(args, backend):
    with tempfile.TemporaryDirectory(prefix="arbiter-caches-") as cache:
        first = Layered(args, backend, cache)
        pairs = first.pairs(args)
        for pair in pairs:
            for side in SIDES:
                first.sample("load", pair, side, args.turns)
                first.sample("load", pair, side, 1, 300)
        first.finish()
        client = Layered(args, backend, cache)
        for pair in pairs:
            for side in SIDES:
                client.sample("load", pair, side, 1, 300)
            yield row_of(pair, backend, in_turns(args.turns, lambda side, turn: client.sample(
                "load", pair, side, 1, turn)))
        client.finish()


PARTS = {"frame": frame_rows, "load": load_rows, "warm": warm_rows}


def main(argv=None):
    args = parse(sys.argv[1:] if argv is None else argv)
    machine = describe()
    print(f"{heading(machine)}; ARBITER_PROFILE=nv40", flush=True)
    rows = []
    with tempfile.TemporaryDirectory(prefix="arbiter-nv-") as scratch:
        args.scratch = pathlib.Path(scratch)
        for backend in args.backend or ("swrast", "host"):
            for part in args.part or PARTS:
                print(f"\n{backend + ', ' + part:<30} {'ARB':>8} {'NV':>8} {'':<3}{'NV/ARB':>8} "
                      f"{'95 of 100':>14} {'bound':>8}", flush=True)
                for row in PARTS[part](args, backend):
                    row.update(part=part, verdict=judge(row))
                    rows.append(row)
                    print(f"{row['name']:<30} {row['arb']:>8.3f} {row['nv']:>8.3f} ms {row['figure']:>8.2f} "
                          f"{row['low']:>6.2f} .. {row['high']:.2f} {'<= %g' % MOST:>8}  {row['verdict']}",
                          flush=True)
    verdicts = collections.Counter(row["verdict"] for row in rows)
    print("\n" + ", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items())))
    if args.json:
        args.json.parent.mkdir(parents=True, exist_ok=True)
        args.json.write_text(json.dumps({"schema": 1, "machine": machine, "profile": "nv40",
                                         "rows": rows}, indent=2) + "\n")
    return 0 if args.self_test else finish(rows)


if __name__ == "__main__":
    sys.exit(main())
