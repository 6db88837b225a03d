#!/usr/bin/python3
"""Makes the picture of README, docs/pictures/front.png, of what real programs show.

usage: front_picture.py --build BUILD [--out FILE]    makes it
       front_picture.py --build BUILD --check         makes it and keeps nothing; 1 if a part is not as it should be

VertexTextures, a sample of the engine Wild Magic, loads programs in two of NVIDIA's options, which Mesa lacks. Bare it
shows nothing; under Arbiter it shows its height field. Beside that are the pixel debugger, as docs/pictures/debug.png
has it, and the output of `arbiter check --why`. Needs libwildmagic-examples, ffmpeg, Xvfb, Pillow and the fonts DejaVu.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from PIL import Image, ImageChops, ImageDraw, ImageFont, ImageStat

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "clients"))
from x_server import XServer  # noqa: E402

SAMPLE = "/usr/lib/x86_64-linux-gnu/libwildmagic/SampleGraphics/VertexTextures/VertexTextures"
CARD = "nv40"  # a GeForce 6800, which had NV_fragment_program2 and NV_vertex_program3
WINDOW = (640, 480)
MIDDLE = (180, 100, 460, 380)  # of the window, where the height field is; frames a second stand below
VIEW = (120, 90, 520, 390)  # what is kept of the window
DOCUMENT = "demos/gallery/twirl.fp"
LINES = 14  # of the output of check
SECONDS = 40
SIZE = (1240, 510)
COLOURS = {"back": "#14181d", "panel": "#0d1117", "text": "#dde3ea", "dim": "#9aa5b1", "mark": "#6db3f2"}
FONTS = pathlib.Path("/usr/share/fonts/truetype/dejavu")
LARGEST = 400 * 1024  # bytes
NOTHING, SOMETHING = 2, 30  # standard deviation of the middle, of 255 at most, at least


class Wrong(Exception):
    """A part of the picture is not as it should be."""


def grabbed(display, path):
    subprocess.run(["ffmpeg", "-v", "quiet", "-f", "x11grab", "-draw_mouse", "0", "-video_size", "%dx%d" % WINDOW,
                    "-i", display, "-frames:v", "1", "-y", str(path)], check=True, stdin=subprocess.DEVNULL)
    return Image.open(path).convert("RGB")


def shown(prefix, folder):
    """What the sample shows, once the middle has stayed the same for a second and is not black."""
    with XServer("%dx%dx24" % WINDOW) as display:
        environment = {**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1",
                       "WM5_PATH": "/usr/share/libwildmagic"}
        sample = subprocess.Popen([*prefix, SAMPLE], env=environment, cwd=folder, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            before, until = None, time.monotonic() + SECONDS
            while time.monotonic() < until:
                picture = grabbed(display, folder / "shown.png")
                middle = picture.crop(MIDDLE)
                if max(ImageStat.Stat(middle).mean) > 5 and before and \
                        not ImageChops.difference(before, middle).getbbox():
                    return picture
                before = middle
                time.sleep(1)
            raise Wrong(f"{' '.join(prefix) or 'bare'}: no still picture")
        finally:
            sample.terminate()
            sample.wait()


def spread(picture):
    return max(ImageStat.Stat(picture.crop(MIDDLE)).stddev)


def parts(build, folder):
    """The two pictures of the sample, and the lines of check."""
    command = str(build / "src/apps/tools/arbiter")
    bare = shown([], folder)
    under = shown([command, "run", "--profile", CARD, "--"], folder)
    if spread(bare) > NOTHING or spread(under) < SOMETHING:
        raise Wrong(f"standard deviation {spread(bare):.0f} bare, {spread(under):.0f} under Arbiter")
    told = subprocess.run([command, "check", "--why", DOCUMENT], cwd=ROOT, capture_output=True, text=True,
                          env={**os.environ, "NO_COLOR": "1"}, check=True).stdout.split("\n")
    if len(told) < LINES or not any("dependent read" in line for line in told):
        raise Wrong("check --why: " + "\n".join(told))
    return bare, under, told[:LINES]


def composed(bare, under, told):
    """Two pictures above the text at the left, the window at the right."""
    title = ImageFont.truetype(str(FONTS / "DejaVuSans.ttf"), 14)
    mono = ImageFont.truetype(str(FONTS / "DejaVuSansMono.ttf"), 11)
    picture = Image.new("RGB", SIZE, COLOURS["back"])
    draw = ImageDraw.Draw(picture)
    for x, text, part in ((14, "Wild Magic: VertexTextures on llvmpipe", bare),
                          (314, f"the same, arbiter run --profile {CARD}", under)):
        draw.text((x, 12), text, COLOURS["text"], title)
        picture.paste(part.crop(VIEW).resize((286, 214), Image.Resampling.LANCZOS), (x, 36))
    draw.text((14, 264), f"$ arbiter check --why {DOCUMENT}", COLOURS["mark"], mono)
    draw.rectangle((14, 282, 600, SIZE[1] - 14), COLOURS["panel"])
    for number, line in enumerate(told):
        draw.text((22, 288 + 14.6 * number), line, COLOURS["text" if number == 0 else "dim"], mono)
    window = Image.open(ROOT / "docs/pictures/debug.png").convert("RGB")
    width = SIZE[0] - 614 - 14
    window = window.resize((width, window.height * width // window.width), Image.Resampling.LANCZOS)
    draw.text((614, 12), "the pixel debugger of the Shader Builder", COLOURS["text"], title)
    picture.paste(window, (614, 36))
    return picture


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/pictures/front.png")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="arbiter-front-") as folder:
        folder = pathlib.Path(folder)
        out = folder / "front.png" if options.check else options.out
        try:
            composed(*parts(options.build.absolute(), folder)).save(out, optimize=True)
        except Wrong as wrong:
            print(f"front_picture.py: {wrong}", file=sys.stderr)
            return 1
        if out.stat().st_size > LARGEST:
            print(f"front_picture.py: {out.stat().st_size} bytes", file=sys.stderr)
            return 1
    print("1 passed, 0 failed, 0 skipped" if options.check else options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
