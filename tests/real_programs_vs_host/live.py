#!/usr/bin/env python3
"""Edits a program of an unmodified Debian application while it runs, and watches its picture change.

  live.py --build DIR [--out DIR]
  live.py --packages          the packages that it needs

MPlayer is captured for a few frames. Then it plays a still picture forever under
`arbiter run --replace` with the capture's folder, and its fragment program is edited there: to another
formula, to an invalid one, back to its own. The screen is read after each step.
"""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import picture
import session

PACKAGES = ("mplayer", "xvfb", "libgl1-mesa-dri")
SIZE = (320, 240)
PLAYER = ["mplayer", "-noconfig", "all", "-nosound", "-noconsolecontrols", "-vo", "gl:yuv=2",
          "-geometry", "0:0"]


class Failure(Exception):
    """A step did not have the required result."""


def main() -> int:
    options, out = session.command_line(__doc__, PACKAGES, "live")
    shutil.rmtree(out / "mplayer.capture", ignore_errors=True)
    try:
        _steps(options.build / "src/apps/tools/arbiter", out)
    except (Failure, session.SessionError, FileNotFoundError) as failure:
        print(f"live: FAIL: {failure}; see {out}")
        return 1
    print(f"live: pass; pictures: {out}")
    return 0


def clip(path: Path) -> Path:
    """Makes a second of a still gradient of all colors."""
    width, height = SIZE
    luma = bytes(40 + (x * 150 // width + y // 4) % 180 for y in range(height) for x in range(width))
    blue = bytes(60 + x * 130 // (width // 2) for y in range(height // 2) for x in range(width // 2))
    red = bytes(60 + y * 130 // (height // 2) for y in range(height // 2) for x in range(width // 2))
    head = f"YUV4MPEG2 W{width} H{height} F25:1 Ip A1:1 C420\n".encode()
    path.write_bytes(head + (b"FRAME\n" + luma + blue + red) * 25)
    return path


def _steps(arbiter: Path, out: Path) -> None:
    folder = out / "mplayer.capture"
    still = clip(out / "still.y4m")
    with session.XServer(out / "screen") as server:
        environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "DISPLAY": server.display}
        for name in ("WAYLAND_DISPLAY", "XAUTHORITY"):
            environment.pop(name, None)
        with open(out / "capture.log", "wb") as log:
            subprocess.run([arbiter, "capture", "-o", folder, "--", *PLAYER, "-frames", "5", still],
                           env=environment, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                           timeout=120, check=False)
        program = _captured(folder)
        own = program.read_bytes()
        with open(out / "run.log", "wb") as log:
            player = subprocess.Popen([arbiter, "run", "--replace", folder, "--", *PLAYER,
                                       "-loop", "0", still], env=environment,
                                      stdin=subprocess.DEVNULL, stdout=log, stderr=log)
            try:
                _edit(server, program, own, out)
                if player.poll() is not None:
                    raise Failure(f"the application ended with status {player.returncode}")
            finally:
                player.terminate()
                player.wait()
        text = (out / "run.log").read_text(errors="replace")
        if f"{program}:2:19: error:" not in text:
            raise Failure("the wrong edit is not in the log")


def _captured(folder: Path) -> Path:
    """Returns the text that drew the frames."""
    index = json.loads((folder / "index.json").read_text())
    drawn = [p for p in index["programs"] if p["target"] == "fragment" and p["draws"] >= 5]
    if not drawn:
        raise Failure("the capture has no fragment program with five draws")
    if [t["width"] for t in drawn[0]["textures"]][:1] == [0]:
        raise Failure("the capture has no texture at the program's unit")
    return folder / drawn[0]["file"]


def _edit(server: session.XServer, program: Path, own: bytes, out: Path) -> None:
    before = wait(server, lambda shot: not shot.is_blank(), "nothing was drawn")
    picture.write_png(out / "before.png", before)
    _put(program, b"!!ARBfp1.0\nTEMP y;\nTEX y, fragment.texcoord[0], texture[0], 2D;\n"
                  b"SUB result.color, {1, 1, 1, 1}, y;\nEND\n")
    after = wait(server, lambda shot: picture.compare(shot, before).mean > 10,
                  "the edit does not change the picture")
    picture.write_png(out / "after.png", after)
    _put(program, b"!!ARBfp1.0\nMOV result.color, nothing;\nEND\n")
    for _ in range(5):
        time.sleep(0.3)
        wait(server, lambda shot: not shot.is_blank() and picture.compare(shot, after).identical,
              "a wrong edit changes the picture")
    _put(program, own)
    wait(server, lambda shot: picture.compare(shot, before).identical,
          "the own text does not bring the picture back")


def _put(path: Path, text: bytes) -> None:
    """Saves as editors do: to another name, which is then renamed."""
    beside = path.with_suffix(".new")
    beside.write_bytes(text)
    os.replace(beside, path)


def _shot(server: session.XServer) -> picture.Picture:
    return server.screen().crop(*SIZE)


def wait(server: session.XServer, good, problem: str) -> picture.Picture:
    """Returns the first picture that is good and unchanged a moment later."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        shot = _shot(server)
        time.sleep(0.3)
        if good(shot) and picture.compare(_shot(server), shot).identical:
            return shot
    raise Failure(problem)


if __name__ == "__main__":
    sys.exit(main())
