"""Replays traces with glretrace and times them: a trace cut behind its last swap, whose last frame is looped.

glretrace loops a trace only if its last call is a swap, and a frame ends at a swap.
"""

import json
import pathlib
import re
import resource
import shutil
import statistics
import subprocess
import sys
from dataclasses import dataclass

import paced

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'tests' / 'real_programs_vs_host'))
from cases import PrepareError, shell  # noqa: E402

SETTLE = 20  # repetitions of the last frame before it is timed: machine code, trials, shadows
LEAST, MOST = 5, 2000  # timed repetitions


@dataclass(frozen=True)
class Side:
    """A way to replay on the X server `display`: the layer in front with `backend` and `fixed_function`, or the bare
    host. It has disk caches of its own."""

    name: str
    display: str
    cache: pathlib.Path
    layer: pathlib.Path | None = None
    backend: str = "auto"
    fixed_function: str | None = None

    def environment(self, recording, folder):
        extra = {**recording.environment, "XDG_CACHE_HOME": str(self.cache)}
        if self.layer:
            extra.update(ARBITER_BACKEND=self.backend, ARBITER_PROFILE="host",
                         ARBITER_STATS=str(folder / "stats.%p.json"))
            if self.fixed_function:
                extra["ARBITER_FIXED_FUNCTION"] = self.fixed_function
            if recording.over_limits:
                extra["ARBITER_LIMITS"] = "report"
        env = {**paced.environment(self.layer, extra), "DISPLAY": self.display}
        del env["MESA_SHADER_CACHE_DISABLE"]  # the cold and the warm start differ by their caches
        return env


@dataclass
class Timed:
    """The result of one replay: seconds of glretrace's clock, which starts at the first call, and the frames shown;
    processor seconds of the process; the layer's statistics."""

    seconds: float
    frames: int
    processor: float
    stats: dict


def cut(trace, folder):
    """Writes (the trace up to its last swap, its first frame) to `folder`; None without a swap."""
    folder.mkdir(parents=True, exist_ok=True)
    calls = shell(["apitrace", "dump", "--color=never", "--grep=SwapBuffers", str(trace)])
    swaps = re.findall(r"^(\d+) \w*SwapBuffers", calls, re.MULTILINE)
    if not swaps:
        return None
    frames = []
    for name, last in (("all", swaps[-1]), ("first", swaps[0])):
        frames.append(folder / f"{trace.stem}.{name}.trace")
        shell(["apitrace", "trim", f"--calls=0-{last}", "-o", str(frames[-1]), str(trace)])
    return frames


def replay(recording, trace, side, folder, loops=0, timeout=600):
    """Replays once. Raises PrepareError if glretrace fails, shows no frame, or runs without `side`'s layer."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    side.cache.mkdir(parents=True, exist_ok=True)
    command = ["glretrace", "-b", *([f"--loop={loops}"] if loops else []), str(trace)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, env=side.environment(recording, folder), cwd=folder, text=True,
                              errors="replace", stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=timeout, check=False)
    except subprocess.TimeoutExpired as error:
        raise PrepareError(f"{side.name}: no end after {timeout} s") from error
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    rendered = re.search(r"^Rendered (\d+) frames in ([\d.e+-]+) secs", done.stdout, re.MULTILINE)
    if done.returncode or not rendered:
        raise PrepareError(f"{side.name}: glretrace ends with status {done.returncode}: {done.stdout[-300:]}")
    stats = {}
    for path in folder.glob("stats.*.json"):
        stats = json.loads(path.read_text())
    if side.layer and not stats.get("contexts"):
        raise PrepareError(f"{side.name}: the layer was not in the process, or saw no context")
    return Timed(float(rendered.group(2)), max(1, int(rendered.group(1))),
                 after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, stats)


@dataclass
class Steady:
    """Milliseconds a frame, as medians over the turns; how often the last frame was timed; the statistics
    of the last replay."""

    wall: float
    processor: float
    loops: int
    stats: dict


def steady(recording, trace, sides, folder, seconds, turns):
    """Returns [Steady] of each side, in turns. A turn's frame is the difference of a long replay and a
    short one, as both contain the one-time work."""
    short = [[] for _ in sides]
    long = [[] for _ in sides]
    loops = []
    for side in sides:  # this sets the lengths, and fills the caches
        first = replay(recording, trace, side, folder, SETTLE)
        again = replay(recording, trace, side, folder, 2 * SETTLE)
        # After a long trace the difference is within the noise of the one-time work.
        frame = max((again.seconds - first.seconds) / SETTLE, again.seconds / again.frames / 4)
        loops.append(min(MOST, max(LEAST, round(seconds / frame))))
    for turn in range(turns):
        for place in range(len(sides)):
            which = (place + turn) % len(sides)
            short[which].append(replay(recording, trace, sides[which], folder, SETTLE))
            long[which].append(replay(recording, trace, sides[which], folder, SETTLE + loops[which]))
    found = []
    for side, a, b, count in zip(sides, short, long, loops):
        wall = statistics.median(y.seconds - x.seconds for x, y in zip(a, b))
        processor = statistics.median(y.processor - x.processor for x, y in zip(a, b))
        if wall <= 0 or processor <= 0:
            raise PrepareError(f"{side.name}: {count} frames more took no longer: --seconds {seconds} is too little")
        found.append(Steady(1000 * wall / count, 1000 * processor / count, count, b[-1].stats))
    return found


def first_frames(recording, whole, first, sides, folder, turns):
    """Returns the median milliseconds to the end of the first frame of each side, in turns: (with empty caches, with
    the caches of a run that replayed the whole recording). The host has caches too."""
    times = [([], []) for _ in sides]
    for _ in range(turns):
        for side, (cold, warm) in zip(sides, times):
            shutil.rmtree(side.cache, ignore_errors=True)
            cold.append(1000 * replay(recording, first, side, folder).seconds)
    for side in sides:
        replay(recording, whole, side, folder, SETTLE)
    for _ in range(turns):
        for side, (cold, warm) in zip(sides, times):
            warm.append(1000 * replay(recording, first, side, folder).seconds)
    return [(statistics.median(cold), statistics.median(warm)) for cold, warm in times]
