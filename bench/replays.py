"""Replays of a trace with glretrace, timed: a trace cut behind its last swap, whose last frame is looped.

glretrace loops a trace only where its last call is a swap, and calls a frame what a swap ends.
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

SETTLE = 20  # times that the last frame is shown before it is timed: machine code, trials, shadows
LEAST, MOST = 5, 2000  # times that it is timed


@dataclass(frozen=True)
class Side:
    """One way to replay, on the X server `display`: `layer` in front with `backend` and, if it is said, whose
    `fixed_function` is, or the bare host; its caches on disk."""

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
        del env["MESA_SHADER_CACHE_DISABLE"]  # the cold and the warm start are told apart
        return env


@dataclass
class Timed:
    """Of one replay: seconds of glretrace's own clock, which starts at the first call, and the frames that it
    showed; processor seconds of the process; what the layer's statistics say."""

    seconds: float
    frames: int
    processor: float
    stats: dict


def cut(trace, folder):
    """(the trace up to its last swap, its first frame), as files in `folder`; None without a swap."""
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
    """One replay; PrepareError if glretrace fails, shows no frame, or ran without the layer that `side` has."""
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
    """Milliseconds a frame, medians over the turns; how often the last frame was timed; the statistics
    of the last replay."""

    wall: float
    processor: float
    loops: int
    stats: dict


def steady(recording, trace, sides, folder, seconds, turns):
    """[Steady] of each side, which take turns. A turn's frame is the difference of a long replay and a
    short one: what happens once is in both."""
    short = [[] for _ in sides]
    long = [[] for _ in sides]
    loops = []
    for side in sides:  # a pace to choose the lengths by; fills the caches
        first = replay(recording, trace, side, folder, SETTLE)
        again = replay(recording, trace, side, folder, 2 * SETTLE)
        # Behind a long trace the difference is within the noise of what happens once.
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
    """Milliseconds to the end of the first frame, medians: (with empty caches, with what a start left that
    replayed the whole recording) of each side, which take turns. The host has caches too."""
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
