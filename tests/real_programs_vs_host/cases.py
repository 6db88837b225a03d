"""Describes a real program to the runner: the packages it needs, its preparation, its cases."""

import os
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


class PrepareError(Exception):
    """A program's input could not be made; the text says which command failed and how."""


# The ways in which recordings are compared (recordings/replay.py): drawn by the rasterizer, and drawn by the host.
DRAWN = ("auto-late", "auto-cold", "auto-warm", "swrast", "r300")
WAYS = (*DRAWN, "host", "programs")


@dataclass(frozen=True)
class Case:
    """A command whose last picture is compared between the bare host and the layer.

    The picture is `output` (a file that the program writes, relative to the run's own folder), or, if
    that is empty, what the X screen shows most of the time.
    """

    name: str
    command: list[str]
    output: str = ""
    size: tuple[int, int] = (0, 0)  # of the part of the screen to compare; 0: all of it
    stdin: str = ""
    environment: dict[str, str] = field(default_factory=dict)
    timeout: float = 120.0
    stop_after: float = 0.0  # seconds after which SIGTERM ends a program that runs forever
    # It varies from run to run, so that only its recording can be compared (recordings/).
    recorded: bool = False
    api: str = "gl"  # a window system that apitrace records: gl (with GLX) or egl
    # The number of pixels of a recorded frame that may differ by more than 3 %. More than 60 needs a reason.
    wrong_pixels: int = 60
    ways_left_out: tuple[str, ...] = ()  # ways in which its recording is not compared; any needs a reason
    step: int = 8  # in 255ths, replaces those 3 %; more needs a reason too
    frames: int = 0  # the number of first frames that its recording keeps; 0: the runner's option
    maximum: int = 0  # tolerance: largest difference of a channel, in 255ths
    mean: float = 0.0  # tolerance: mean difference of all channels, in 255ths
    # It exceeds a Radeon 9700: under a profile with enforced limits the program would be refused, as by that card's
    # driver, so that this case only asks for a report (ARBITER_LIMITS).
    over_limits: bool = False
    least_programs: int = 1  # fragment programs that the layer must have compiled
    refused: int = 0  # programs that the bare host refuses too
    statuses: tuple[int, ...] = (0,)  # exit statuses that are a success

    def __post_init__(self):
        unknown = set(self.ways_left_out) - set(WAYS)
        if unknown:
            raise ValueError(f"{self.name}: no way is named {', '.join(sorted(unknown))}")


@dataclass(frozen=True)
class Program:
    """A program from Debian, or a client that is built here with one of its libraries."""

    name: str
    packages: tuple[str, ...]
    about: str

    def cases(self, work: Path) -> list[Case]:
        """Prepares the input under `work` (kept between runs) and returns the cases."""
        raise NotImplementedError

    def finish(self, work: Path) -> None:
        """Ends what the program leaves running."""


# For cases with anisotropic textures, whose filter is implementation-dependent. llvmpipe's is a weighted mean of whole
# texels of one level, the rasterizer's one of trilinear samples (tests/rasterizer_vs_host/anisotropy.py). In 0ad's
# terrain single pixels differ by 33, at the edges of magnified texels by 47. Lost or moved geometry differs more.
ANISOTROPIC_STEP = 48
# These cases are compared with the usual step too, on a host without the filter.
WITHOUT_ANISOTROPY = {"MESA_EXTENSION_OVERRIDE": "-GL_EXT_texture_filter_anisotropic"}

DATA = Path(__file__).resolve().parent / "data"


def shell(command: list[str], cwd: Path | None = None, environment: dict[str, str] | None = None,
          timeout: float = 300.0) -> str:
    """Runs a preparation step; returns its output if it succeeds, and raises PrepareError if not."""
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
    """Compiles data/SOURCE with a library's development files, unless that was done; returns its path."""
    path = DATA / source
    binary = work / path.stem
    if not binary.exists() or binary.stat().st_mtime < path.stat().st_mtime:
        shell(["g++", "-O1", "-w", "-fPIC", str(path), "-o", str(binary), *libraries])
    return binary
