"""Runs the rows of a table such as comparisons.py: a client on the bare host and under the layer, in each of the row's
ways.

  comparisons.py ROW --build build [--first SEED] [--count N] [--backend swrast|auto|host] [NAME...]

N is a number of random scenes, or of frames. NAMEs select from the scenes that the client has by name.
Prints a line for each run under the layer. Ends with "N passed, N failed, N skipped".
"""

import concurrent.futures
import contextlib
import dataclasses
import itertools
import pathlib
import subprocess
import tempfile
from typing import Callable

import sides
from x_server import XServer

DEATHS = (sides.Died, subprocess.TimeoutExpired)
SKIPPED = "status 77"  # the host lacks what the client draws


@dataclasses.dataclass(frozen=True)
class Way:
    """A way to run a client."""
    name: str = ""  # in the output
    backend: str = ""  # "": the command line's; None: the bare host
    env: dict = dataclasses.field(default_factory=dict)
    words: tuple = ()  # the last words of the client, which the bare host's has too
    own_words: tuple = ()  # further words, of this run alone
    count: Callable = lambda count: count  # changes the command line's
    only: Callable = lambda name: True  # selects names
    checks: tuple = None  # replaces the row's
    fresh: int = None  # a pattern of fresh memory
    is_alone: bool = False  # compared with nothing


BARE = Way(backend=None)


@dataclasses.dataclass(frozen=True)
class Row:
    """A comparison. A check is a function of a Run that returns complaints, a line each."""
    client: str
    checks: tuple
    count: int = 1  # unless the command line says another
    words: tuple = ("{first}", "{count}")  # of the client; {name}, {first} and {count} are replaced
    names: tuple = ("",)
    is_listed: bool = False  # the client's --list prints the names
    bare: Way = BARE  # what the layer is compared with; None: nothing
    ways: tuple = (Way(),)
    env: dict = dataclasses.field(default_factory=dict)
    drivers: tuple = ("",)  # of Mesa
    # Options of X servers by name, and the scenes that are drawn on them. Each run gets a server of its own.
    servers: dict = dataclasses.field(default_factory=dict)
    cache: str = "row"  # the runs that share a folder of machine code: all of the "row", of a "case", or a single "run"
    jobs: int = 1
    bare_may_die: bool = False  # then there is nothing to compare
    read_bare: Callable = lambda case, way: case.records(case.row.bare, way)
    least_drawn: float = None  # the rasterizer's fraction of all draws of the row
    tell: Callable = lambda run: f"the rasterizer drew {run.drawn}, the host {run.given}"


@dataclasses.dataclass
class Run:
    """A run under the layer, and the records that it is compared with."""
    case: "Case"
    way: Way
    bare: list
    layer: list
    part: dict  # the rasterizer's statistics

    @property
    def name(self):
        return self.case.name

    @property
    def count(self):
        return self.way.count(self.case.args.count)

    @property
    def backend(self):
        return self.way.backend or self.case.args.backend

    @property
    def drawn(self):
        return self.part.get("drawn", 0)

    @property
    def given(self):
        return self.part.get("given_to_host", {})

    def again(self, **changes):
        """Returns the same run once more, in a way that is changed."""
        way = dataclasses.replace(self.way, **changes)
        return Run(self.case, way, self.bare, *self.case.process(way, way))


class Case:
    """A scene of a row, on a kind of X server and a driver of Mesa."""

    def __init__(self, runner, name, server, driver):
        self.row, self.args, self.runner = runner.row, runner.args, runner
        self.name, self.server, self.driver = name, server, driver
        self.number = next(runner.numbers)
        self.seen = {}  # the bare host's records, by the client's words

    @property
    def cache(self):
        """Returns the folder of machine code for the next run."""
        return self.runner.folder / {"row": "cache", "case": f"cache-{self.number}",
                                     "run": f"cache-{next(self.runner.numbers)}"}[self.row.cache]

    def process(self, way, of):
        """Runs the client in a way, for a comparison with the way `of`. Returns its records and the statistics."""
        numbers = {"name": self.name, "first": self.args.first, "count": of.count(self.args.count)}
        words = [word.format(**numbers) for word in (*self.row.words, *of.words, *way.own_words)]
        with contextlib.ExitStack() as stack:
            display = stack.enter_context(XServer(options=self.row.servers[self.server][0])) if self.row.servers \
                else self.runner.displays.name()
            stats = self.runner.folder / f"stats-{next(self.runner.numbers)}.json"
            env = {"DISPLAY": display, "XDG_CACHE_HOME": str(self.cache),
                   **({"GALLIUM_DRIVER": self.driver} if self.driver else {}), **self.row.env, **way.env}
            if way.backend is None:
                env = sides.environment(extra=env, fresh=way.fresh)
            else:
                env = sides.environment(self.runner.layer, way.backend or self.args.backend,
                                        {"ARBITER_STATS": str(stats), **env}, way.fresh)
                if self.args.guard:
                    env = sides.guarded(self.args.build, env, self.args.guard)
            return sides.run([self.runner.client, *words], env), sides.software_statistics(stats)

    def records(self, way, of):
        return self.process(way, of)[0]

    def bare_of(self, way, anew=False):
        """Returns the bare host's records for a way, which are read once for ways with the same words."""
        key = way.words, way.count(self.args.count)
        if self.row.bare and not way.is_alone and (anew or key not in self.seen):
            self.seen[key] = self.row.read_bare(self, way)
        return self.seen.get(key, [])

    def judged(self, run, checks):
        """Returns the complaints about a run. Where the bare host draws something else on a busy machine, it is judged
        by what it draws the second time."""
        wrong = [line for check in checks for line in check(run)]
        if wrong and run.bare:
            first, run.bare = run.bare, self.bare_of(run.way, anew=True)
            if run.bare != first:
                wrong = [line for check in checks for line in check(run)]
        return wrong

    def results(self):
        """Returns [(what ran, complaints, the run or None)]; in place of complaints, why it is skipped."""
        found = []
        for way in self.row.ways:
            if not way.only(self.name):
                continue
            seeded = "{first}" in (*self.row.words, *way.words)
            numbers = f"{way.count(self.args.count)} from {self.args.first}" if seeded else ""
            what = ", ".join(filter(None, (self.driver, self.name, self.server, way.name, numbers))) or self.args.row
            try:
                bare = self.bare_of(way)
            except DEATHS as death:
                if SKIPPED in str(death):
                    return [(what, f"the host lacks it: {death}", None)]
                if self.row.bare_may_die:
                    return [(f"{what}: the bare host: {death}", [], None)]
                return [(what, [f"the bare host: {death}"], None)]
            try:
                run = Run(self, way, bare, *self.process(way, way))
                checks = self.row.checks if way.checks is None else way.checks
                found.append((f"{what}: {self.row.tell(run)}", self.judged(run, checks), run))
            except DEATHS as death:
                found.append((what, self.judge_death(way, death), None))
        return found

    def judge_death(self, way, death):
        """Returns the complaint about a run that died, or why it is none: the host drew, and dies without the layer."""
        if way.backend == "host":
            try:
                self.process(BARE, way)
            except DEATHS as bare:
                if str(bare) == str(death):
                    return f"the bare host does not stand it: {bare}"
        return [str(death)]


class Runner:
    """Runs the cases of a row."""

    def __init__(self, row, args, displays, folder):
        self.row, self.args, self.displays, self.folder = row, args, displays, pathlib.Path(folder)
        self.client, self.layer = args.clients / row.client, sides.layer_of(args.build)
        self.numbers = itertools.count()

    def cases(self):
        names = self.row.names
        if self.row.is_listed:
            names = subprocess.run([self.client, "--list"], capture_output=True, text=True,
                                   check=True).stdout.splitlines()
        names = [name for name in names if not self.args.names or name in self.args.names]
        return [Case(self, name, server, driver) for driver in self.row.drivers
                for server, (_, shown) in (self.row.servers or {"": ((), ())}).items()
                for name in names if not shown or name in shown]

    def run(self):
        """Prints the results and returns the exit status."""
        tally, drawn, given = sides.Tally(), 0, 0
        with concurrent.futures.ThreadPoolExecutor(self.args.jobs) as pool:
            for results in pool.map(Case.results, self.cases()):
                for what, wrong, run in results:
                    if isinstance(wrong, str):
                        tally.skip(what, wrong)
                        continue
                    tally.row(what, wrong, 12)
                    drawn += run.drawn if run else 0
                    given += sum(run.given.values()) if run else 0
        if self.row.least_drawn is not None and self.args.backend == "swrast" and not self.args.names:
            few = drawn == 0 or drawn < self.row.least_drawn * (drawn + given)
            tally.row(f"in all the rasterizer drew {drawn}, the host {given}", ["too few"] if few else [])
        if not tally.passed + tally.failed + tally.skipped:
            tally.row("scenes", ["there are none"])
        return tally.end()


def main(rows, folder):
    """Runs the row that the command line names, with a client of tests/`folder`, and returns the exit status."""
    parser = sides.options(__doc__)
    parser.add_argument("row", choices=rows, metavar="ROW", help=", ".join(rows))
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int)
    parser.add_argument("--backend", default="swrast", choices=("swrast", "auto", "host"))
    parser.add_argument("--guard", choices=("begin", "end"),
                        help="the layer's blocks begin, or end, at a page that nobody may touch")
    parser.add_argument("--jobs", type=int, help="processes at a time")
    parser.add_argument("names", nargs="*", metavar="NAME")
    args = parser.parse_intermixed_args()  # NAMEs may follow options
    row = rows[args.row]
    args.clients = args.build.resolve() / "tests" / folder
    args.build, args.jobs = args.build.resolve(), args.jobs or row.jobs
    args.count = row.count if args.count is None else args.count
    with tempfile.TemporaryDirectory(prefix="arbiter-comparison-") as folder, sides.Displays() as displays:
        return Runner(row, args, displays, folder).run()
