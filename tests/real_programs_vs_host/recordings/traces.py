"""Traces: recorded once from a program with apitrace and kept, or given as files."""

import json
import re
import shutil
from dataclasses import dataclass, field, replace
from pathlib import Path

import session
from cases import ANISOTROPIC_STEP, WITHOUT_ANISOTROPY, Case, PrepareError, shell
from recordings.frames import STEP, WRONG_PIXELS

# Calls that may change a picture without showing it; the last one after the last swap is captured too.
_DRAWS = (r"^(gl(Draw|MultiDraw|End(ARB)?$|CallLists?$|Clear$|Rect[dfis]|Bitmap|CopyPixels|"
          r"ReadPixels)|(glX|egl)SwapBuffers)")


@dataclass(frozen=True)
class Recording:
    """A trace, and the required results of its replay with the layer."""

    name: str
    trace: Path
    program: str = ""  # of tests/real_programs_vs_host/programs; empty for a given file
    environment: dict[str, str] = field(default_factory=dict)
    over_limits: bool = False
    wrong_pixels: int = WRONG_PIXELS  # the number that a frame may have
    step: int = STEP  # the smallest difference that makes a pixel wrong
    least_programs: int = 0  # fragment programs that the layer must have compiled
    refused: int | None = None  # programs that the bare host refuses too; None: not known
    ways_left_out: tuple[str, ...] = ()


@dataclass(frozen=True)
class FileVariant:
    """How a given trace is compared; `suffix` is added to its name."""

    suffix: str = ""
    least_programs: int = 0
    refused: int | None = None
    step: int = STEP
    environment: dict[str, str] = field(default_factory=dict)


# Traces from others, by file name.
KNOWN_FILES = {
    "0ad-terrain.trace": (FileVariant(least_programs=5, refused=0, step=ANISOTROPIC_STEP),
                          FileVariant("-trilinear", least_programs=5, refused=0, environment=WITHOUT_ANISOTROPY)),
    "irrlicht-ex10.trace": (FileVariant(least_programs=8, refused=0),),
}


def variants(path: Path) -> tuple[FileVariant, ...]:
    return KNOWN_FILES.get(path.name, (FileVariant(),))


def of_file(path: Path, work: Path, frames: int, variant: FileVariant) -> Recording:
    """Returns the first `frames` frames of an existing trace."""
    if not path.is_file():
        raise PrepareError(f"{path}: no such trace")
    return Recording(path.stem + variant.suffix, _shortened(path, work, frames), environment=variant.environment,
                     step=variant.step, least_programs=variant.least_programs, refused=variant.refused)


def of_case(program: str, case: Case, work: Path, frames: int) -> Recording:
    """Returns the case's trace under `work`; records it on the bare host unless it exists."""
    trace = work / f"{case.name}.trace"
    if not trace.exists():
        _record(case, work, frames, trace)
    return Recording(case.name, trace, program, case.environment, case.over_limits,
                     case.wrong_pixels, case.step, case.least_programs, case.refused,
                     case.ways_left_out)


def _record(case: Case, work: Path, frames: int, trace: Path) -> None:
    """Records until something is drawn. A busy machine may take longer than `stop_after` to start
    the program, and a stored trace without a draw would fail forever."""
    fresh = work / f"{case.name}.new.trace"
    for attempt in range(4):
        session.record(replace(case, stop_after=case.stop_after * 2**attempt),
                       work / f"{case.name}.record", fresh)
        shutil.rmtree(work / f"{case.name}.record" / "screen", ignore_errors=True)
        if _last_draw(fresh):
            break
    else:
        raise PrepareError(f"{case.name}: draws nothing while it is recorded")
    short = _shortened(fresh, work, frames)
    if short != fresh:
        fresh.unlink()
    short.rename(trace)


def _shortened(trace: Path, work: Path, frames: int) -> Path:
    """Returns the trace itself, or a copy of its first frames if it has more than that."""
    if frame_count(trace) <= frames:
        return trace
    work.mkdir(parents=True, exist_ok=True)
    short = work / f"{trace.stem}.first{frames}.trace"
    if not short.exists() or short.stat().st_mtime < trace.stat().st_mtime:
        shell(["apitrace", "trim", f"--frames=0-{frames - 1}", "-o", str(short), str(trace)])
    return short


def frame_count(trace: Path) -> int:
    """Returns how many frames end with a swap; a trace that was cut off is no error."""
    try:
        return int(json.loads(shell(["apitrace", "info", str(trace)]))["FramesCount"])
    except (ValueError, KeyError) as error:
        raise PrepareError(f"{trace}: apitrace does not read it: {error}") from error


def player(trace: Path) -> str:
    """Returns the program that replays it, by the window system that it was recorded with."""
    egl = shell(["apitrace", "dump", "--color=never", "--grep=^eglCreateContext$", str(trace)])
    return "eglretrace" if egl.strip() else "glretrace"


def snapshot_calls(trace: Path) -> str:
    """Returns the calls for glretrace's snapshots: each frame, and the last draw if no swap follows it, as
    in programs that draw to a framebuffer object and read it, or that were ended while drawing."""
    last = _last_draw(trace)
    if last is None:
        raise PrepareError(f"{trace}: draws nothing")
    return "frame" if "SwapBuffers" in last.group(2) else f"frame,{last.group(1)}"


def _last_draw(trace: Path) -> re.Match | None:
    """Returns the number and name of the last call that may change a picture."""
    calls = shell(["apitrace", "dump", "--color=never", f"--grep={_DRAWS}", str(trace)])
    last = None
    for last in re.finditer(r"^(\d+) (\w+)\(", calls, re.MULTILINE):
        pass
    return last
