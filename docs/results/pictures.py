#!/usr/bin/env python3
"""Draws the gallery and the demonstrations, each beside its reference, for docs/results/pictures.md.

usage: pictures.py --build BUILD     writes docs/results/pictures/*.png, pictures.json and the page

The pictures are in the tree, as the site is built where nothing else is. pictures.json notes what they were drawn from:
once a program changes, its pictures are stale and `./dev check` says so. References are those of the tests: the
interpreter's picture of a document, and a demonstration's own plain C++.
"""

import argparse
import hashlib
import json
import os
import pathlib
import platform
import re
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE), str(ROOT / "scripts"), str(ROOT / "tests" / "real_programs_vs_host")]
import collect  # noqa: E402
import picture  # noqa: E402
import run_demos  # noqa: E402

FOLDER = HERE / "pictures"
RECORD = HERE / "pictures.json"
SOURCES = {"gallery": "demos/gallery", "demonstrations": "demos/programs"}
WAYS = {"swrast": "the rasterizer", "host": "the driver"}
FACTOR = 16  # by which differences are made visible
SIZE = "96x96"
MOST_BYTES = 600 * 1024  # of all pictures
GALLERY_LINE = re.compile(r"^(\S+)\.fp +(host|swrast) +largest difference +(\d+) of +(\d+), "
                          r"beyond it +(\d+) pixels of +(\d+)", re.M)
DEMO_LINE = re.compile(r"max error (\d+) of 255 \(tolerance (\d+)(?:, and ([\d.]+)% of the pixels beyond it; "
                       r"at most (\d+) are)?\)")


class Stale(Exception):
    """Pictures that are not those of the tree, with the reason."""


class Failed(Exception):
    """A picture that could not be drawn, or is not like its reference."""


def digest(folder):
    """Returns the SHA-256 of the names and texts of a folder's files."""
    found = hashlib.sha256()
    for file in sorted(path for path in folder.iterdir() if path.is_file()):
        found.update(f"{file.name}\0".encode() + file.read_bytes() + b"\0")
    return found.hexdigest()


def expected(root=ROOT):
    """Returns (group, name) of each picture that the tests compare: the cases, and the demonstrations."""
    cases = re.findall(r'^    \{"(\w+)\.fp", ', (root / "tests/gallery_vs_interpreter/gallery_test.cpp").read_text(),
                       re.M)
    demos = re.findall(r"^  '([\w-]+)': \[\['", (root / "demos/meson.build").read_text(), re.M)
    return [("gallery", name) for name in sorted(cases)] + [("demonstrations", name) for name in sorted(demos)]


def filtered(line, above, kind):
    """Returns a row of RGB bytes by a filter of PNG: 0 none, 1 left, 2 above, 4 Paeth."""
    if kind == 0:
        return line
    out = bytearray(len(line))
    for at, value in enumerate(line):
        a, b, c = (line[at - 3], above[at], above[at - 3]) if at >= 3 else (0, above[at], 0)
        if kind == 4:
            p = a + b - c
            guess = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
        else:
            guess = a if kind == 1 else b
        out[at] = (value - guess) & 255
    return bytes(out)


def small_png(shown):
    """Returns a picture's PNG, each row by the filter that leaves the smallest numbers."""
    stride = shown.width * 3
    rows, above = [], bytes(stride)
    for y in range(shown.height):
        line = shown.rgb[y * stride:(y + 1) * stride]
        choices = [bytes([kind]) + filtered(line, above, kind) for kind in (0, 1, 2, 4)]
        rows.append(min(choices, key=lambda row: sum(min(byte, 256 - byte) for byte in row[1:])))
        above = line

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", shown.width, shown.height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(b"".join(rows), 9)) + chunk(b"IEND", b""))


def entry(out, group, name, drawn, ways):
    """Writes the strip of a pair into a folder, and returns its row. drawn: {way: file}, "reference" among them."""
    ours, reference = (picture.read(drawn[key]) for key in ("swrast", "reference"))
    difference = picture.compare(ours, reference)
    if ours.is_blank() or not difference.same_size:
        raise Failed(f"{name}: blank, or of another size than its reference")
    strip = small_png(picture.side_by_side([ours, reference, picture.magnified(ours, reference, FACTOR)]))
    file = out / f"{group}-{name}.png"
    file.write_bytes(strip)
    return {"group": group, "name": name, "file": f"pictures/{file.name}", "width": ours.width, "height": ours.height,
            "mean": round(difference.mean, 3), "pixels": difference.pixels, "ways": ways,
            "sha256": hashlib.sha256(strip).hexdigest()}


def gallery(build, work, out, *document):
    """Yields the rows of the gallery, or of one document, as its test draws and judges it."""
    environment = dict(os.environ, GALLERY_KEEP=str(work), LIBGL_ALWAYS_SOFTWARE="1")
    words = [build / "tests/gallery_vs_interpreter/gallery_test", build / "src/apps/tools/arbiter",
             ROOT / "demos/gallery", ",".join(WAYS), *document]
    run = subprocess.run(words, env=environment, capture_output=True, text=True)
    if run.returncode:
        raise Failed(f"gallery_test: status {run.returncode}\n{run.stdout}{run.stderr}")
    found = {}
    for name, way, *numbers in GALLERY_LINE.findall(run.stdout):
        found.setdefault(name, {})[way] = dict(zip(("largest", "levels", "beyond", "most"), map(int, numbers)))
    for name, ways in sorted(found.items()):
        yield entry(out, "gallery", name, {key: work / f"{name}-{key}.png" for key in (*WAYS, "reference")}, ways)


def demonstrations(build, work, out, *names):
    """Yields the rows of the demonstrations, or of those named, each form by itself, as --verify judges them."""
    layer = build / "src/interposer/libGLX_arbiter.so.0"
    demos = {name: path for name, path in run_demos.demos_of(build).items() if not names or name in names}
    for name, path, options in run_demos.runs_of(demos):
        drawn, ways = {"reference": work / f"{name}-reference.png"}, {}
        for way in WAYS:
            drawn[way] = work / f"{name}-{way}.png"
            environment = dict(os.environ, LD_PRELOAD=str(layer), ARBITER_BACKEND=way, LIBGL_ALWAYS_SOFTWARE="1")
            run = subprocess.run([path, "--headless", "--verify", "--size", SIZE, "--out", drawn[way], "--reference",
                                  drawn["reference"], *options], env=environment, capture_output=True, text=True)
            line = DEMO_LINE.search(run.stdout)
            if run.returncode or not line:
                raise Failed(f"{name}: status {run.returncode}\n{run.stdout}{run.stderr}")
            width, height = map(int, SIZE.split("x"))
            most = int(float(line.group(3) or 0) / 100 * width * height)
            ways[way] = {"largest": int(line.group(1)), "levels": int(line.group(2)),
                         "beyond": int(line.group(4) or 0), "most": most}
        yield entry(out, "demonstrations", name, drawn, ways)


def driver(build):
    """Returns the name of the driver under the layer."""
    run = subprocess.run([build / "demos/twirl", "--headless", "--info"], capture_output=True, text=True, check=True,
                         env=dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1"))
    info = json.loads(run.stdout)
    return collect.host_of({**info, "processor": platform.machine()})


def draw(build):
    """Draws all pictures and their record anew."""
    FOLDER.mkdir(exist_ok=True)
    for old in FOLDER.glob("*.png"):
        old.unlink()
    with tempfile.TemporaryDirectory(prefix="arbiter-pictures-") as folder:
        work = pathlib.Path(folder)
        rows = [*gallery(build, work, FOLDER), *demonstrations(build, work, FOLDER)]
    size = sum(file.stat().st_size for file in FOLDER.glob("*.png"))
    if size > MOST_BYTES:
        raise Failed(f"the pictures have {size} bytes, and {MOST_BYTES} are the most")
    record = {"schema": 1, "host": driver(build), "factor": FACTOR,
              "sources": {group: digest(ROOT / folder) for group, folder in SOURCES.items()}, "pictures": rows}
    RECORD.write_text(json.dumps(record, indent=1) + "\n")
    print(f"{len(rows)} pictures, {size} bytes")


def published(here=HERE, root=ROOT):
    """Returns the record of the pictures. Raises Stale if one is missing, or other than noted, or of other sources."""
    record = json.loads((here / "pictures.json").read_text())
    for group, folder in SOURCES.items():
        if digest(root / folder) != record["sources"].get(group):
            raise Stale(f"pictures.json: {folder} has changed; run ./dev docs --pictures")
    for row in record["pictures"]:
        file = here / row["file"]
        if not file.is_file() or hashlib.sha256(file.read_bytes()).hexdigest() != row["sha256"]:
            raise Stale(f"{row['file']}: not the picture that pictures.json describes")
    rows = [(row["group"], row["name"]) for row in record["pictures"]]
    # A demonstration may have forms: life-packed is one of life's.
    lacking = [name for group, name in expected(root) if not any(
        group == other and (name == row or group == "demonstrations" and row.startswith(name + "-"))
        for other, row in rows)]
    if lacking:
        raise Stale(f"pictures.json: lacks {', '.join(lacking)}; run ./dev docs --pictures")
    return record


def figures(way):
    """Returns a cell: the largest difference, and how many pixels are beyond what the test allows."""
    beyond = f", {way['beyond']} pixels of {way['most']} beyond" if way["beyond"] else ""
    return f"{way['largest']} of {way['levels']}{beyond}"


def page(record):
    """Returns the text of docs/results/pictures.md."""
    out = ["# Pictures beside their references\n",
           f"Each strip has Arbiter's picture by its rasterizer, the reference, and their difference times "
           f"{record['factor']}: black is alike.\n",
           "The test named with a table compares the same pictures, on every driver that it runs on. A figure is the "
           "largest difference of a pixel in 255ths, and the difference that the test allows. Pixels on outlines may "
           f"fall to the other side: those beyond are counted. The driver here is {record['host']}.\n",
           "Generated by `docs/results/page.py` from `docs/results/pictures.json`; do not edit. "
           "`./dev docs --pictures` draws them anew. [pictures.json](pictures.json) has the figures."]
    titles = {"gallery": ("The gallery", "The reference is the interpreter's: it runs the same programs in plain C++. "
                          "The test is [gallery](../../tests/gallery_vs_interpreter/gallery_test.cpp)."),
              "demonstrations": ("The demonstrations", "The reference is a computation in C++ that knows no program. "
                                 "The tests are those named `demo-`; [demos](../../demos/README.md) says what each "
                                 "shows.")}
    for group, (title, text) in titles.items():
        out += [f"\n## {title}\n", text + "\n", "| name | Arbiter, reference, difference | "
                + " | ".join(WAYS.values()) + " |", "|---|---|" + "---|" * len(WAYS)]
        out += [f"| `{row['name']}` | ![{row['name']}: Arbiter, the reference, the difference]({row['file']}) | "
                + " | ".join(figures(row["ways"][way]) for way in WAYS) + " |"
                for row in record["pictures"] if row["group"] == group]
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    build = parser.parse_args().build.resolve()
    try:
        draw(build)
    except Failed as error:
        print(f"pictures.py: {error}", file=sys.stderr)
        return 1
    import page as results
    results.write()
    return 0


if __name__ == "__main__":
    sys.exit(main())
