#!/usr/bin/env python3
"""Runs random sequences of GL commands on the bare host and under the layer: everything read must be equal.

  run_sequences.py --build build                       the quick set
  run_sequences.py --build build --count 500           that many seeds
  run_sequences.py --build build --first 41 --count 1  one of them
  run_sequences.py --build build --backend auto --commands 400
  run_sequences.py --build build --planted             also: is a command noticed that one side leaves out?

Draws of the layer and of the host are mixed; all are exact in any arithmetic, so that no bit may differ. A differing
sequence is reduced: commands are removed as long as it still differs. Ends with "N passed, N failed, N skipped".
"""

import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

import sides


class Sequences:
    """Runs sequences in one way, on both sides."""

    def __init__(self, args, displays, scratch):
        self.client = args.build / "tests/rasterizer_vs_host/rasterizer-sequence"
        self.commands, self.scratch = args.commands, pathlib.Path(scratch)
        self.displays, self.skip = displays, args.skip or []
        self.bare = sides.environment()
        self.layer = sides.environment(sides.layer_of(args.build), args.backend,
                                       {"XDG_CACHE_HOME": scratch})

    def command(self, seed, only):
        kept = [",".join(map(str, only))] if only is not None else []
        return [self.client, seed, self.commands, *kept]

    def drawn(self, seed):
        """Returns how many draws the rasterizer made; None without statistics."""
        path = self.scratch / f"stats-{seed}.json"
        sides.run(self.command(seed, None), {**self.layer, "ARBITER_STATS": str(path),
                                             "DISPLAY": self.displays.name()})
        return sides.software_statistics(path).get("drawn")

    def differences(self, seed, only=None):
        """Returns the differences, as lines."""
        if only is None:
            only = self.start(seed)
        results = []
        for env in (self.bare, self.layer):
            try:
                results.append(sides.run(self.command(seed, only),
                                         {**env, "DISPLAY": self.displays.name()}))
            except sides.Died as death:
                results.append(str(death))
        bare, layer = results
        if isinstance(bare, str) and isinstance(layer, str):
            return []  # a fault of the host
        if isinstance(bare, str) or isinstance(layer, str):
            return [f"{'bare host' if isinstance(bare, str) else 'layer'}: "
                    f"{bare if isinstance(bare, str) else layer}"]
        return self.compare(bare, layer)

    @staticmethod
    def compare(bare, layer):
        lines = []
        for (what, a), (other, b) in zip(bare, layer):
            if what != other:
                return lines + [f"bare host '{what}', layer '{other}'"]
            if a != b:
                far, worst = sides.distances(a, b)
                count = sum(a[i:i + 4] != b[i:i + 4] for i in range(0, len(a), 4))
                lines.append(f"'{what}': {count} of {len(a) // 4} pixels differ, {far} of them by "
                             f"more than 1, by up to {worst}")
        if len(bare) != len(layer):
            lines.append(f"{len(bare)} records, layer {len(layer)}")
        return lines

    def start(self, seed):
        """Returns the commands without those of --skip; None for all."""
        if not self.skip:
            return None
        return [int(name.split(" ", 1)[0]) for name in self.names(seed, None)
                if name.split(" ", 1)[1] not in self.skip]

    def names(self, seed, only):
        """Returns the names of the commands `only`, or of all."""
        kept = [",".join(map(str, only))] if only is not None else []
        lines = subprocess.run([str(word) for word in (self.client, "--names", seed, self.commands,
                                                       *kept)],
                               capture_output=True, text=True, check=True).stdout
        return lines.splitlines()

    def planted(self, seed, most=10):
        """Returns (noticed, planted): how many single pixel commands, left out on one side, are noticed. They are the
        last
        ones, as earlier drawings are mostly cleared or drawn over."""
        kinds = ("program quad", "feedback", "fixed quad", "CopyTexSubImage", "TexSubImage")
        numbers = [int(name.split(" ", 1)[0]) for name in self.names(seed, None)
                   if name.split(" ", 1)[1] in kinds][-most:]
        env = {**self.bare, "DISPLAY": self.displays.name()}
        whole = sides.run(self.command(seed, None), env)
        seen = 0
        for number in numbers:
            without = [n for n in range(self.commands) if n != number]
            seen += bool(self.compare(whole, sides.run(self.command(seed, without), env)))
        return seen, len(numbers)


def minimise(differs, kept, attempts=300):
    """Reduces the commands `kept` while differs(list) still holds: first it removes the commands after the first
    difference, then ever smaller pieces."""
    tried = 0
    piece = max(1, len(kept) // 2)
    while tried < attempts:
        at, shorter = 0, False
        while at < len(kept) and tried < attempts:
            without = kept[:at] + kept[at + piece:]
            tried += 1
            if differs(without):
                kept, shorter = without, True
            else:
                at += piece
        if piece == 1 and not shorter:
            break
        piece = max(1, piece // 2)
    return kept


def self_test():
    wanted = {5, 41, 77}
    assert minimise(lambda kept: wanted <= set(kept), list(range(120))) == sorted(wanted)
    same = [("1 ReadPixels", bytes(16))]
    assert Sequences.compare(same, same) == []
    assert Sequences.compare(same, [("1 ReadPixels", bytes(15) + b"\1")]) != []
    assert Sequences.compare(same, []) != []
    assert Sequences.compare(same, [("1 ReadPixels errors 0x0502", b"")]) != []
    data = b"1 ReadPixels\t4\n\n\t\n9end\t0\n"
    assert sides.records(data) == [("1 ReadPixels", b"\n\t\n9"), ("end", b"")]
    print("5 passed, 0 failed, 0 skipped")


def report(sequences, seed, lines, reduces):
    print(f"FAIL seed {seed}: differs")
    for line in lines[:4]:
        print(f"    {line}")
    if not reduces:
        return
    kept = minimise(lambda some: bool(sequences.differences(seed, some)),
                    sequences.start(seed) or list(range(sequences.commands)))
    print(f"    reduced: {' '.join(map(str, sequences.command(seed, kept)[1:]))}")
    for name in sequences.names(seed, kept):
        print(f"      {name}")
    for line in sequences.differences(seed, kept)[:4]:
        print(f"    {line}", flush=True)


def main():
    parser = sides.options(__doc__)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    parser.add_argument("--first", type=int, default=1, help="seed")
    parser.add_argument("--count", type=int, default=24, help="seeds")
    parser.add_argument("--commands", type=int, default=150, help="of a sequence")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--reduce", type=int, default=2, help="how many failures are reduced")
    parser.add_argument("--skip", action="append", metavar="KIND", help="of commands, by name")
    parser.add_argument("--planted", action="store_true", help="also test the test")
    parser.add_argument("--drawn", action="store_true", help="fail if the rasterizer drew nothing")
    parser.add_argument("--self-test", action="store_true")
    args = parser.parse_args()
    if args.self_test:
        return self_test()
    args.build = args.build.resolve()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="arbiter-sequences-") as scratch, \
            sides.Displays() as displays, \
            concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        sequences = Sequences(args, displays, scratch)
        seeds = range(args.first, args.first + args.count)
        for seed, lines in zip(seeds, pool.map(sequences.differences, seeds)):
            if lines:
                failed += 1
                report(sequences, seed, lines, failed <= args.reduce)
        if args.planted:
            seen, planted = sequences.planted(args.first)
            print(f"{seen} of {planted} commands that one side leaves out are seen")
            failed += seen < planted / 2
        drawn = sequences.drawn(args.first)
        print(f"of seed {args.first} the rasterizer drew {drawn}")
        failed += args.drawn and not drawn
    print(f"{max(0, args.count - failed)} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
