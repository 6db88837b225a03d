#!/usr/bin/python3
"""Makes docs/pictures/programs.png: what programs of Debian show under Arbiter, on one sheet.

usage: program_pictures.py --build BUILD [--out FILE]    runs the programs and makes the sheet
       program_pictures.py --packages                    prints the packages that it needs

The programs are cases of tests/real_programs_vs_host. A program that shows nothing is an error.
"""

import argparse
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "real_programs_vs_host"))
import session  # noqa: E402
from programs import PROGRAMS  # noqa: E402

# The programs of a row of docs/use/programs.md, and the cases that stand for it.
SHOWN = (
    ("games", ("games-etr", "games-armagetronad", "games-briquolo", "games-neverball", "games-chromium-bsu",
               "games-billard-gl")),
    ("savers", ("savers-hyperspace", "savers-euphoria", "savers-lattice")),
    ("hacks", ("hacks-dangerball", "hacks-gears", "hacks-molecule")),
)
TILE = (240, 180)
COLUMNS = 4
CAPTION = 20
SIZE_LIMIT = 500 * 1024  # bytes
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def taken(build, folder):
    """Yields (name, picture) of each case, as the screen showed it for the longest time."""
    library = (build / "src/interposer/libGLX_arbiter.so.0").absolute()
    mode = session.Mode("arbiter", library, "r300")
    for program, names in SHOWN:
        work = folder / program
        work.mkdir()
        cases = {case.name: case for case in PROGRAMS[program].cases(work)}
        for name in names:
            outcome = session.run(cases[name], mode, folder / name)
            if outcome.picture is None:
                sys.exit(f"program_pictures.py: {name} shows nothing: {outcome.log.strip()[-300:]}")
            print(name, f"{outcome.picture.width}x{outcome.picture.height}", flush=True)
            yield name.partition("-")[2], outcome.picture


def drawn_part(image):
    """Crops the screen's black border, as most programs have a window in its corner."""
    box = image.point(lambda value: 255 if value > 8 else 0).getbbox()
    return image.crop(box) if box else image


def sheet(pictures):
    from PIL import Image, ImageDraw, ImageFont
    font = ImageFont.truetype(FONT, 12)
    rows = -(-len(pictures) // COLUMNS)
    width, height = TILE[0], TILE[1] + CAPTION
    whole = Image.new("RGB", (COLUMNS * width, rows * height), "#14181d")
    draw = ImageDraw.Draw(whole)
    for number, (name, picture) in enumerate(pictures):
        x, y = number % COLUMNS * width, number // COLUMNS * height
        image = drawn_part(Image.frombytes("RGB", (picture.width, picture.height), picture.rgb))
        image.thumbnail((TILE[0] - 8, TILE[1] - 8))
        whole.paste(image, (x + (width - image.width) // 2, y + (TILE[1] - image.height) // 2))
        draw.text((x + width // 2, y + TILE[1] + 8), name, fill="#dde3ea", font=font, anchor="mm")
    return whole.convert("P", palette=Image.Palette.ADAPTIVE, colors=256)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/pictures/programs.png")
    parser.add_argument("--packages", action="store_true")
    options = parser.parse_args()
    if options.packages:
        print("python3-pil", "fonts-dejavu-core",
              *sorted({package for program, _ in SHOWN for package in PROGRAMS[program].packages}))
        return 0
    if not options.build:
        parser.error("--build is missing")
    with tempfile.TemporaryDirectory() as folder:
        picture = sheet(list(taken(options.build, pathlib.Path(folder))))
    picture.save(options.out, optimize=True)
    size = options.out.stat().st_size
    print(f"{options.out}: {size} bytes")
    return 1 if size > SIZE_LIMIT else 0


if __name__ == "__main__":
    sys.exit(main())
