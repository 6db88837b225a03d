#!/usr/bin/env python3
"""Attaches to unmodified Debian applications while they run, and watches their pictures change.

  attached.py --build DIR [--out DIR] [NAME...]
  attached.py --packages          the packages that it needs

Each plays a still picture forever under `arbiter run --control`. Through `arbiter ctl` its fragment program is
listed with its cost, a pixel of its frame is traced, and the program is edited: the picture changes, and
is restored when the client has gone. The screen is read after each step.
"""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import live
import picture
import session

PACKAGES = (*live.PACKAGES, "xine-ui", "libxine2-bin", "libxine2-x")
# Name, and the command, to which the clip is added.
APPLICATIONS = {
    "mplayer": [*live.PLAYER, "-loop", "0"],
    "xine": ["xine", "-V", "opengl", "-A", "none", "-g", "-p", "--no-gui", "--loop=loop", "--no-splash",
             "-G", "320x240+0+0"],
}
NEGATIVE = ("!!ARBfp1.0\nTEMP y;\nTEX y, fragment.texcoord[0], texture[0], 2D;\n"
            "SUB result.color, {1, 1, 1, 1}, y;\nEND\n")


class Attached:
    """A controlled application, and its client."""

    def __init__(self, arbiter: Path, command: list, out: Path, server: session.XServer):
        self.arbiter, self.out, self.server = arbiter, out, server
        self.environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "DISPLAY": server.display,
                            "XDG_RUNTIME_DIR": str(out), "HOME": str(out)}
        for name in ("WAYLAND_DISPLAY", "XAUTHORITY"):
            self.environment.pop(name, None)
        self.log = open(out / "run.log", "wb")
        self.process = subprocess.Popen([arbiter, "run", "--control", "--", *command], env=self.environment,
                                        stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)

    def close(self) -> None:
        self.process.terminate()
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.log.close()

    def _words(self, words: tuple) -> list:
        return [str(word) for word in (self.arbiter, "ctl", "--timeout", 60, *words)]

    def ask(self, *words) -> dict:
        """Returns the answer of `arbiter ctl --json`."""
        done = subprocess.run(self._words(("--json", *words)), env=self.environment, capture_output=True,
                              text=True, timeout=120)
        if done.returncode != 0:
            raise live.Failure(f"arbiter ctl {' '.join(map(str, words))}: {done.stderr.strip()}")
        return json.loads(done.stdout)

    def holding(self, *words) -> subprocess.Popen:
        return subprocess.Popen(self._words(words), env=self.environment, stderr=self.log)


def main() -> int:
    options, out = session.command_line(__doc__, PACKAGES, "attached", APPLICATIONS)
    failures = 0
    for name in options.names or APPLICATIONS:
        folder = out / name
        folder.mkdir(parents=True, exist_ok=True)
        try:
            said = _attach(options.build / "src/apps/tools/arbiter", name, folder)
            print(f"attached: {name}: pass: {said}")
        except (live.Failure, session.SessionError, FileNotFoundError) as failure:
            print(f"attached: {name}: FAIL: {failure}; see {folder}")
            failures += 1
    return min(failures, 1)


def _attach(arbiter: Path, name: str, out: Path) -> str:
    (out / ".xine").mkdir(exist_ok=True)
    (out / ".xine/config").write_text(".version:2\n")  # without a file xine asks for settings
    clip = live.clip(out / "still.y4m")
    with session.XServer(out / "screen") as server:
        application = Attached(arbiter, [*APPLICATIONS[name], str(clip)], out, server)
        try:
            said = _steps(application, out)
            if application.process.poll() is not None:
                raise live.Failure(f"the application ended with status {application.process.returncode}")
            return said
        finally:
            application.close()


def _steps(application: Attached, out: Path) -> str:
    before = live.wait(application.server, lambda shot: not shot.is_blank(), "nothing was drawn")
    picture.write_png(out / "before.png", before)
    program = next((row for row in application.ask("programs")["programs"]
                    if row["target"] == "fragment" and row["draws"] > 0), None)
    if program is None:  # the first list starts the count
        program = _drawn(application)
    cost = application.ask("measure")["programs"].get(program["id"])
    if not cost or not cost["pixels"]:
        raise live.Failure(f"no pixels are counted for {program['id']}")
    trace = _trace(application, program["id"])
    text = out / "negative.fp"
    text.write_text(NEGATIVE)
    client = application.holding("set", program["id"], text)
    try:
        after = live.wait(application.server, lambda shot: picture.compare(shot, before).mean > 10,
                          "the edit does not change the picture")
        picture.write_png(out / "after.png", after)
    finally:
        client.send_signal(signal.SIGINT)
        client.wait()
    live.wait(application.server, lambda shot: picture.compare(shot, before).identical,
              "the picture is not what it was when the client has gone")
    return (f"{program['id']}, {cost['pixels']} pixels in {cost['milliseconds']:.2f} ms a frame; "
            f"{len(trace['rows'])} instructions traced: {trace['verdict']['line']}")


def _drawn(application: Attached) -> dict:
    """Returns the fragment program that draws; draws are counted while a client is attached."""
    measured = application.ask("measure")["programs"]
    rows = application.ask("programs")["programs"]
    for row in rows:
        if row["target"] == "fragment" and measured.get(row["id"], {}).get("draws"):
            return row
    raise live.Failure("no fragment program draws")


def _trace(application: Attached, program: str) -> dict:
    """Traces a pixel inside the picture, which a player draws again in every frame."""
    done = subprocess.run(application._words(("--json", "trace", "100,100")), env=application.environment,
                          capture_output=True, text=True, timeout=120)
    frame = application.out / "frame.png"
    if done.returncode not in (0, 5) or not done.stdout:
        subprocess.run(application._words(("frame", "-o", frame)), env=application.environment)
        raise live.Failure(f"no trace: {done.stderr.strip()}")
    trace = json.loads(done.stdout)
    if trace["file"] != program:
        raise live.Failure(f"the pixel is traced in {trace['file']}, and {program} draws")
    return trace


if __name__ == "__main__":
    sys.exit(main())
