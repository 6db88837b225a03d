"""What a real program is to the runner: the packages it needs, its preparation, its cases."""

import os
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


class PrepareError(Exception):
    """A program's input could not be made; the text says which command failed and how."""


# How recordings are compared (recordings/replay.py): with the rasterizer, and with the host as what draws.
DRAWN = ("auto-late", "auto-cold", "auto-warm", "swrast", "r300")
WAYS = (*DRAWN, "host", "programs")


@dataclass(frozen=True)
class Case:
    """One command whose last picture is compared between the bare host and the layer.

    The picture is `output` (a file that the program writes, relative to the run's own folder), or,
    where that is empty, what the X screen shows most of the time.
    """

    name: str
    command: list[str]
    output: str = ""
    size: tuple[int, int] = (0, 0)  # of the part of the screen to compare; 0: all of it
    stdin: str = ""
    environment: dict[str, str] = field(default_factory=dict)
    timeout: float = 120.0
    stop_after: float = 0.0  # seconds after which SIGTERM ends a program that runs for ever
    # Not the same from run to run, so that only its recording can be compared (recordings/).
    recorded: bool = False
    api: str = "gl"  # of window systems that apitrace records: gl, with GLX, or egl
    # Of its recorded frames, how many pixels may be off by more than 3 %. More than 60 needs a reason.
    wrong_pixels: int = 60
    ways_left_out: tuple[str, ...] = ()  # in which its recording is not compared. Any needs a reason.
    step: int = 8  # of 255, in place of those 3 %. More needs a reason too.
    frames: int = 0  # that its recording keeps, from the first; 0: as many as the runner's option says
    maximum: int = 0  # tolerance: largest difference of a channel, of 255
    mean: float = 0.0  # tolerance: mean difference of all channels, of 255
    # More than a Radeon 9700 holds: under a profile with enforced limits the program would be refused
    # as that card's driver refused it, so this case asks for a report only (ARBITER_LIMITS).
    over_limits: bool = False
    least_programs: int = 1  # fragment programs that must have been compiled by the layer
    refused: int = 0  # programs that the bare host refuses too
    statuses: tuple[int, ...] = (0,)  # exit statuses that are a success

    def __post_init__(self):
        unknown = set(self.ways_left_out) - set(WAYS)
        if unknown:
            raise ValueError(f"{self.name}: no way is named {', '.join(sorted(unknown))}")


@dataclass(frozen=True)
class Program:
    """A program of Debian's, or a kind of client that is built here against one of its libraries."""

    name: str
    packages: tuple[str, ...]
    about: str

    def cases(self, work: Path) -> list[Case]:
        """Prepares the input under `work` (kept between runs) and returns the cases."""
        raise NotImplementedError

    def finish(self, work: Path) -> None:
        """Ends what the program leaves running."""


# For cases with anisotropic textures: the filter is each implementation's own. llvmpipe's is a weighted mean
# of whole texels of one level, the rasterizer's one of trilinear samples (tests/rasterizer_vs_host/run_anisotropy.py):
# in 0ad's terrain single pixels are 33 apart, at the edges of magnified texels 47. What is lost or moved is
# further off.
ANISOTROPIC_STEP = 48
# So the same are compared with the usual step, too: a host that lacks the filter.
WITHOUT_ANISOTROPY = {"MESA_EXTENSION_OVERRIDE": "-GL_EXT_texture_filter_anisotropic"}

DATA = Path(__file__).resolve().parent / "data"


def shell(command: list[str], cwd: Path | None = None, environment: dict[str, str] | None = None,
          timeout: float = 300.0) -> str:
    """Runs a preparation step; its output if it succeeds, PrepareError if not."""
    try:
        done = subprocess.run(command, cwd=cwd, env={**os.environ, **(environment or {})},
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace",
                              timeout=timeout, check=False)
    except FileNotFoundError as error:
        raise PrepareError(f"{command[0]}: not installed") from error
    except subprocess.TimeoutExpired as error:
        raise PrepareError(f"{' '.join(command)}: no end after {timeout:.0f} s") from error
    if done.returncode:
        raise PrepareError(f"{' '.join(command)}: status {done.returncode}\n{done.stdout[-2000:]}")
    return done.stdout


def build_client(work: Path, source: str, libraries: list[str]) -> Path:
    """Compiles data/SOURCE against a library's development files, unless that was done; its path."""
    path = DATA / source
    binary = work / path.stem
    if not binary.exists() or binary.stat().st_mtime < path.stat().st_mtime:
        shell(["g++", "-O1", "-w", "-fPIC", str(path), "-o", str(binary), *libraries])
    return binary
