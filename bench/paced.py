"""Runs processes that take turns: clients that draw a number of frames for each line of input.

Two of them run side by side and get commands in turn, so that a busy machine is busy for both. A
turn is as many frames as take about TURN_MS, calibrated for each side, so that the fast side does
not run into the clock's resolution.
"""

import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'tests' / 'clients'))
from plain_environment import plain  # noqa: E402

TURN_MS = 40.0
REACH_PACE_S = 6.0  # the longest time in which a side may reach its pace, as machine code is compiled meanwhile


def environment(layer=None, extra=None):
    """Returns an environment without variables of the layer or of the host's drivers, with the layer in front if
    given."""
    env = plain(MESA_SHADER_CACHE_DISABLE="true")
    if layer:
        env["LD_PRELOAD"] = str(layer)
    env.update(extra or {})
    return env


def layered_parser(doc):
    """Returns a parser for a benchmark of a build with and without the layer: BUILD, --layer, --json."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path, help="the build folder")
    parser.add_argument("--layer", type=pathlib.Path, help="by default BUILD/src/interposer/libGLX_arbiter.so.0")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write the figures")
    return parser


def parse_layered(parser, argv):
    """Returns the arguments of layered_parser(), with the layer's path; exits if it is not built."""
    args = parser.parse_args(argv)
    args.build = args.build.resolve()
    args.layer = (args.layer or args.build / "src/interposer/libGLX_arbiter.so.0").resolve()
    if not args.layer.exists():
        parser.error(f"the layer is not built: {args.layer}")
    return args


class Client:
    """A process that prints one line of JSON when it is ready, and one for each command."""

    def __init__(self, command, env):
        self.command = [str(word) for word in command]
        self.process = subprocess.Popen(self.command, env=env, text=True, stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE)
        self.hello = self.answer("start")
        self.frames = 1

    def answer(self, order):
        line = self.process.stdout.readline()
        if not line:
            code = self.process.wait()
            if code == 77:
                print("skipped: the host lacks it: a context with ARB_fragment_program")
                raise SystemExit(77)
            raise SystemExit(f"{' '.join(self.command)}: ended with status {code} at: {order}")
        return json.loads(line)

    def ask(self, order):
        self.process.stdin.write(f"{order}\n")
        self.process.stdin.flush()
        return self.answer(order)

    def reach_pace(self):
        """Draws frames until two batches in a row take the same time, then sets the number of frames that fills a
        turn."""
        begin, before = time.monotonic(), math.inf
        while True:
            now = self.ask(self.frames)
            self.frames = min(4000, max(1, round(TURN_MS / max(now, 0.001))))
            waited = time.monotonic() - begin
            # The host draws until machine code is ready, so that early agreement means nothing.
            if waited > REACH_PACE_S or (waited > REACH_PACE_S / 12 and abs(now - before) < 0.1 * now):
                return
            before = now

    def turn(self):
        """Returns milliseconds a frame."""
        return self.ask(self.frames)

    def peak_bytes(self):
        for line in pathlib.Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith("VmHWM:"):
                return int(line.split()[1]) * 1024
        raise SystemExit("no VmHWM of a client")

    def close(self):
        self.process.stdin.close()
        code = self.process.wait()
        if code:
            raise SystemExit(f"{' '.join(self.command)}: ended with status {code}")


def take_turns(clients, turns):
    """Returns [times of one round], with a time for each client; the first client changes every round."""
    rounds = []
    for turn in range(turns):
        times = [0.0] * len(clients)
        for place in range(len(clients)):
            which = (place + turn) % len(clients)
            times[which] = clients[which].turn()
        rounds.append(times)
    return rounds


def interval(values):
    """Returns (least, median, greatest): the interval that holds the true median 95 times in 100, by rank."""
    ordered = sorted(values)
    n = len(ordered)
    half = 0.98 * math.sqrt(n)  # 1.96 deviations of a binomial of n and 1/2
    low = max(0, math.floor((n - 1) / 2 - half))
    high = min(n - 1, math.ceil((n - 1) / 2 + half))
    return ordered[low], statistics.median(ordered), ordered[high]


def ratios(rounds):
    """Returns for each round the first client's time divided by the second's: how many times faster the second is."""
    return [times[0] / times[1] for times in rounds]
