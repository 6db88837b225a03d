#!/usr/bin/env python3
"""Measures how much faster than the bare host the layer draws the scenes of tests/scenes_vs_reference, and the cost
of register combiners against ARB programs of the same meaning.

A scene is drawn in each available way: by ARB's extensions, which the bare host has too, and by those of
2002. "times faster" takes turns between a bare client with the named ARB way, and a layered one with each of
its ways; "combiners by ARB" between two ways of one layered client. A figure is the median over the turns, with the
interval that holds the true median 95 times in 100. The profile is nv30. On a machine that does other work,
--time processor measures the processor time of a frame's threads instead of the clock.

examples:
  bench/scenes.py build-bench
  bench/scenes.py build-bench --scene fur --turns 51 --backend host
"""

import json
import sys

from feedback import judge
from machine import describe, heading
from paced import TURN_MS, Client, environment, interval, layered_parser, parse_layered
from verdicts import finish

# For each scene: the way that the bare host draws, and the layer's ways that are compared with it.
SCENES = {"fur": [("arb", ("arb", "combiners", "as-then"))],
          "shadow": [("programs", ("programs", "combiners")), ("arb", ("arb", "as-then"))],
          "skinning": [("arb", ("arb", "as-then"))]}
COMBINED = {"fur": "arb", "shadow": "programs", "glow": "arb", "bumps": "arb"}  # the ARB way
FASTER, COMBINERS = 2, 1.1
WARM_MS = 3000  # machine code is compiled and tried meanwhile


def parse(argv):
    parser = layered_parser(__doc__)
    parser.add_argument("--backend", default="auto", choices=("auto", "swrast", "host"))
    parser.add_argument("--scene", action="append", choices=sorted({*SCENES, *COMBINED}), help="may be repeated")
    parser.add_argument("--time", default="clock", choices=("clock", "processor"), help="what is counted")
    parser.add_argument("--size", type=int, default=512, help="of the picture")
    parser.add_argument("--turns", type=int, default=21, help="of each side of a row")
    parser.add_argument("--self-test", action="store_true", help="few turns: do the rows run?")
    args = parse_layered(parser, argv)
    args.turn_ms, args.warm_ms = (2.0, 2.0) if args.self_test else (TURN_MS, WARM_MS)
    args.turns = 2 if args.self_test else args.turns
    return args


class Scene(Client):
    """A client that draws one scene; `ways` are those that it offers."""

    def __init__(self, args, scene, layer=None):
        extra = {"ARBITER_PROFILE": "nv30", "ARBITER_BACKEND": args.backend} if layer else {}
        client = args.build / "tests/scenes_vs_reference/scenes"
        super().__init__([client, "--pace", scene, args.size], environment(layer, extra))
        self.ways, self.counts = self.hello, {}

    def sample(self, args, way):
        """Returns the milliseconds of a frame, averaged over as many as take a turn."""
        if way not in self.counts:
            spent, once = 0.0, 1.0
            while spent < args.warm_ms:
                count = max(1, round(args.turn_ms / max(once, 0.01)))
                once, _ = self.ask(f"{way} {count}")
                spent += once * count
            self.counts[way] = max(1, round(args.turn_ms / once))
        return self.ask(f"{way} {self.counts[way]}")[args.time == "processor"]


def row_of(args, name, sides, bound, bound_is):
    """Measures two (client, way) of `sides`; the figure is the first's time divided by the second's."""
    rounds = []
    for client, way in sides:
        client.sample(args, way)  # reaches its pace
    for turn in range(args.turns):
        times = [0.0, 0.0]
        for side in ((0, 1), (1, 0))[turn % 2]:
            client, way = sides[side]
            client.ask(f"{way} 1")  # replaces the other way's state
            times[side] = client.sample(args, way)
        rounds.append(times)
    low, figure, high = interval([first / second for first, second in rounds])
    first, second = (interval([times[side] for times in rounds])[1] for side in (0, 1))
    row = {"name": name, "first": first, "second": second, "figure": figure, "low": low, "high": high,
           "bound": bound, "bound_is": bound_is, "rounds": rounds}
    row["verdict"] = judge(row)
    sign = ">=" if bound_is == "least" else "<="
    print(f"{name:<44} {first:>8.3f} {second:>8.3f} {figure:>7.2f} {low:>6.2f} .. {high:<6.2f} {sign} {bound:<4g} "
          f"{row['verdict']}", flush=True)
    return row


def faster_rows(args, scene):
    bare, layered = Scene(args, scene), Scene(args, scene, args.layer)
    for of_arb, ways in SCENES[scene]:
        for way in ways:
            if way not in layered.ways or of_arb not in bare.ways:
                raise SystemExit(f"{scene}: {way} and {of_arb} are not offered")
            yield row_of(args, f"{scene}, {way} / bare {of_arb}", [(bare, of_arb), (layered, way)], FASTER, "least")
    bare.close()
    layered.close()


def combined_row(args, scene):
    client = Scene(args, scene, args.layer)
    row = row_of(args, f"{scene}: combiners / {COMBINED[scene]}",
                 [(client, "combiners"), (client, COMBINED[scene])], COMBINERS, "most")
    client.close()
    return row


def main(argv=None):
    args = parse(sys.argv[1:] if argv is None else argv)
    machine = describe()
    print(f"{heading(machine)}; {args.size}x{args.size}, ARBITER_PROFILE=nv30, ARBITER_BACKEND={args.backend}, "
          f"{args.time} time")
    wanted = args.scene or sorted({*SCENES, *COMBINED})
    print(f"\n{'times faster':<44} {'bare':>8} {'layer':>8} {'figure':>7} {'95 of 100':>13}    bound", flush=True)
    rows = [row for scene in SCENES if scene in wanted for row in faster_rows(args, scene)]
    print(f"\n{'combiners by ARB':<44} {'comb.':>8} {'ARB':>8} {'figure':>7} {'95 of 100':>13}    bound", flush=True)
    rows += [combined_row(args, scene) for scene in COMBINED if scene in wanted]
    if args.json:
        args.json.parent.mkdir(parents=True, exist_ok=True)
        args.json.write_text(json.dumps({"schema": 1, "machine": machine, "backend": args.backend, "size": args.size,
                                         "time": args.time,
                                         "rows": rows}, indent=2) + "\n")
    return 0 if args.self_test else finish(rows)


if __name__ == "__main__":
    sys.exit(main())
