"""Runs one program on an X server of its own, on the bare host or with the layer, and watches its screen."""

import argparse
import collections
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import picture
from cases import Case, PrepareError


def command_line(description: str, packages: tuple, name: str, applications=None) -> tuple:
    """Parses a script's command line; for --packages it prints them and ends.

    Returns (the options, the folder for pictures and logs). `applications`: names that may be chosen from."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--packages", action="store_true", help="print Debian packages and stop")
    parser.add_argument("--build", type=lambda text: Path(text).absolute(), default="build",
                        help="Meson's build folder")
    parser.add_argument("--out", type=Path, help="pictures and logs (default: a temporary folder)")
    if applications:
        parser.add_argument("names", nargs="*", choices=[[], *applications], metavar="NAME")
    options = parser.parse_args()
    if options.packages:
        print(" ".join(packages))
        sys.exit(0)
    out = (options.out or Path(tempfile.mkdtemp(prefix=f"arbiter-{name}-"))).absolute()
    out.mkdir(parents=True, exist_ok=True)
    return options, out


class SessionError(Exception):
    """The X server did not start, or a program gave no picture."""


class XServer:
    """An Xvfb on a free display, whose screen is a file that can be read at any time."""

    def __init__(self, folder: Path, width: int = 1024, height: int = 768):
        folder.mkdir(parents=True, exist_ok=True)
        self._screen = folder / "Xvfb_screen0"
        read_end, write_end = os.pipe()
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24",
                   "-fbdir", str(folder), "-noreset", "-nocursor", "-nolisten", "tcp"]
        try:
            self._process = subprocess.Popen(command, pass_fds=[write_end],
                                             stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        except FileNotFoundError as error:
            raise SessionError("Xvfb is not installed") from error
        finally:
            os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise SessionError("Xvfb did not start")
        self.display = f":{number}"

    def screen(self) -> picture.Picture:
        return picture.read(self._screen)

    def close(self) -> None:
        self._process.terminate()
        self._process.wait()

    def __enter__(self) -> "XServer":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@dataclass(frozen=True)
class Mode:
    """A way to run: a name, and the layer's library, profile and back end, if there is a layer."""

    name: str
    library: Path | None = None
    profile: str = ""
    backend: str = "auto"

    def environment(self, folder: Path) -> dict[str, str]:
        if self.library is None:
            return {}
        preload = " ".join(filter(None, [str(self.library), os.environ.get("LD_PRELOAD", "")]))
        return {"LD_PRELOAD": preload, "ARBITER_PROFILE": self.profile,
                "ARBITER_BACKEND": self.backend,
                "ARBITER_STATS": str(folder / "stats.%p.json")}


@dataclass
class Outcome:
    """The result of one run: its status, its picture, its log and the layer's statistics."""

    status: int
    seconds: float
    picture: picture.Picture | None
    log: str
    stats: list[dict] = field(default_factory=list)


def record(case: Case, folder: Path, trace: Path) -> None:
    """Runs the case on the bare host under apitrace, which writes the file `trace`."""
    shutil.rmtree(folder, ignore_errors=True)
    trace.unlink(missing_ok=True)
    command = ["apitrace", "trace", f"--api={case.api}", "-o", str(trace), *case.command]
    run(replace(case, command=command, output=""), Mode("bare"), folder)
    if not trace.exists():
        raise PrepareError(f"apitrace left no trace; see {folder / 'log.txt'}")


def run(case: Case, mode: Mode, folder: Path) -> Outcome:
    """Runs the case once in `folder`, which must be empty or new."""
    folder.mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    with XServer(folder / "screen") as server:
        environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", **case.environment,
                       **mode.environment(folder), "DISPLAY": server.display}
        if case.over_limits:
            environment["ARBITER_LIMITS"] = "report"
        for name in ("WAYLAND_DISPLAY", "XAUTHORITY"):
            environment.pop(name, None)
        seen = _Seen(case)
        with open(folder / "log.txt", "wb") as log:
            process = subprocess.Popen(case.command, cwd=folder, env=environment, stdout=log,
                                       stderr=subprocess.STDOUT, stdin=subprocess.PIPE,
                                       start_new_session=True)
            _feed(process, case.stdin)
            status = _watch(process, case, server, seen)
    return Outcome(status, time.monotonic() - started, _picture(case, folder, seen),
                   (folder / "log.txt").read_text(errors="replace"), read_stats(folder))


class _Seen:
    """Counts how often each screen of a run was seen; ignores blank ones."""

    def __init__(self, case: Case):
        self._case = case
        self._count: collections.Counter[bytes] = collections.Counter()
        self._size = (0, 0)

    def count_screen(self, server: XServer) -> None:
        shot = server.screen()
        if self._case.size[0]:
            shot = shot.crop(*self._case.size)
        if not shot.is_blank():
            self._size = (shot.width, shot.height)
            self._count[shot.rgb] += 1

    def most_frequent(self) -> picture.Picture | None:
        if not self._count:
            return None
        return picture.Picture(*self._size, self._count.most_common(1)[0][0])


def _feed(process: subprocess.Popen, text: str) -> None:
    assert process.stdin is not None
    try:
        process.stdin.write(text.encode())
        process.stdin.close()
    except BrokenPipeError:
        pass


def _watch(process: subprocess.Popen, case: Case, server: XServer, seen: _Seen) -> int:
    """Waits for the program while watching the screen; returns its status, or -SIGKILL past the time limit."""
    begin, asked = time.monotonic(), False
    while process.poll() is None:
        elapsed = time.monotonic() - begin
        if case.stop_after and elapsed > case.stop_after and not asked:
            os.killpg(process.pid, signal.SIGTERM)
            asked = True
        if elapsed > case.timeout:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            break
        if not case.output and not asked:
            seen.count_screen(server)
        time.sleep(0.05)
    return 0 if asked and process.returncode == -signal.SIGTERM else process.returncode


def _picture(case: Case, folder: Path, seen: _Seen) -> picture.Picture | None:
    if not case.output:
        return seen.most_frequent()
    try:
        return picture.read(folder / case.output)
    except (OSError, picture.PictureError):
        return None


def read_stats(folder: Path) -> list[dict]:
    """Reads the statistics of each process that ran with the layer in `folder`."""
    found = []
    for path in sorted(folder.glob("stats.*.json")):
        try:
            found.append(json.loads(path.read_text()))
        except ValueError:
            found.append({"unreadable": path.name})
    return found
