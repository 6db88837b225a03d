"""Replays a trace in one way, on an X server of its own, and passes each frame on as it comes."""

import os
import shutil
import signal
import subprocess
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import session
from picture import PictureError
from recordings import traces
from recordings.frames import Frame, read_frames
from recordings.traces import Recording

# glretrace reads pictures of the size that it expects of a window. If the host's buffers are smaller, the rest is
# uninitialised memory of malloc. Every run fills that with the same byte, so that it is no difference, unless the layer
# writes there.
_FILLED = {"MALLOC_PERTURB_": "85"}


@dataclass(frozen=True)
class Way:
    """A way of running: the layer's library, if any, and the state of its caches."""

    mode: session.Mode
    cold: bool = False  # begins with empty caches; otherwise with those of earlier ways
    programs_alone: bool = False  # fixed function is the host's where there is no program
    late: bool = False  # machine code is late, as on a busy machine: the host draws meanwhile

    @property
    def name(self) -> str:
        return self.mode.name


@dataclass
class Run:
    """The result of a replay."""

    status: int  # negative: ended by that signal
    seconds: float
    log: str
    stats: list[dict]
    problem: str = ""  # why its frames could not be read to their end
    cut_off: bool = False  # ended by the time limit, so that its frames prove nothing


def ways(library: Path) -> list[Way]:
    """Returns the ways: the back ends, with cold and warm caches, and with late machine code; the default
    profile, whose limits are only reported, as a recording cannot react to a refusal; and fixed function
    drawn by the host in contexts without programs."""
    def mode(name: str, backend: str, profile: str = "host") -> session.Mode:
        return session.Mode(name, library, profile, backend)

    return [Way(mode("auto-late", "auto"), cold=True, late=True),
            Way(mode("auto-cold", "auto"), cold=True), Way(mode("auto-warm", "auto")),
            Way(mode("swrast", "swrast")), Way(mode("host", "host")),
            Way(mode("r300", "auto", "r300")), Way(mode("programs", "auto"), programs_alone=True)]


def replay(recording: Recording, calls: str, way: Way, folder: Path, timeout: float,
           take: Callable[[Frame], None]) -> Run:
    """Runs glretrace in `folder`; calls `take` with each snapshot. Caches are beside the folder,
    one for the bare host and one for all ways with the layer."""
    cache = folder.parent / ("cache" if way.mode.library else "bare-cache")
    if way.cold:
        shutil.rmtree(cache, ignore_errors=True)
    for path in (folder, cache):
        path.mkdir(parents=True, exist_ok=True)
    command = [traces.player(recording.trace), "-b", "-s", "-", "-S", calls, str(recording.trace)]
    started = time.monotonic()
    with session.XServer(folder / "screen") as server, open(folder / "log.txt", "wb") as log:
        environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", **_FILLED,
                       **recording.environment, **way.mode.environment(folder), "DISPLAY": server.display,
                       "XDG_CACHE_HOME": str(cache)}
        if way.programs_alone:
            environment["ARBITER_FIXED_FUNCTION"] = "programs"
        if way.late:
            environment["ARBITER_DEBUG"] = "late-code"
        if recording.over_limits or way.mode.profile == "r300":
            environment["ARBITER_LIMITS"] = "report"
        process = subprocess.Popen(command, env=environment, cwd=folder, stdout=subprocess.PIPE,
                                   stderr=log, stdin=subprocess.DEVNULL, start_new_session=True)
        problem, cut_off = _take_all(process, timeout, take)
    shutil.rmtree(folder / "screen", ignore_errors=True)
    return Run(process.returncode, time.monotonic() - started,
               (folder / "log.txt").read_text(errors="replace"), session.read_stats(folder),
               problem, cut_off)


def _take_all(process: subprocess.Popen, timeout: float,
              take: Callable[[Frame], None]) -> tuple[str, bool]:
    """Passes on the frames until the process ends. Returns what kept it from ending well, or nothing, and
    whether that was the time limit."""
    late = threading.Event()

    def end() -> None:
        late.set()
        _kill(process)

    timer = threading.Timer(timeout, end)
    timer.start()
    try:
        for frame in read_frames(process.stdout):
            take(frame)
        problem = ""
    except (PictureError, ValueError) as error:
        problem = str(error)
        _kill(process)
    finally:
        process.stdout.close()
        process.wait()
        timer.cancel()
    if late.is_set():
        return f"cut off after {timeout:.0f} s: see --timeout", True
    return problem, False


def _kill(process: subprocess.Popen) -> None:
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
