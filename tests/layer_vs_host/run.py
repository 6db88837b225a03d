#!/usr/bin/env python3
"""Draws every case of the path client on the bare host and under the layer, and compares.

  tests/layer_vs_host/run.py --build build                 all
  tests/layer_vs_host/run.py --build build nested-depth    the named ones
  tests/layer_vs_host/run.py --build build --out FOLDER    keeps the pictures that differ (bare, layer)
  tests/layer_vs_host/run.py --build build --surface pbuffer

Pictures may differ by 1 of 255 in a channel; values and errors must be equal. If the client's table says that the
bare host is wrong, only the case's own checks count. Exit status 1 if a case fails.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "rasterizer_vs_host"), str(HERE.parent / "real_programs_vs_host")]
import sides  # noqa: E402
from picture import of_rgba, write_png  # noqa: E402

SIZE = 64
TIMEOUT = 240


@dataclass
class Report:
    """One side's results of a case."""
    died: int = 0
    skipped: str = ""
    failed: list = field(default_factory=list)
    pictures: list = field(default_factory=list)  # list of (what, bytes)
    values: list = field(default_factory=list)  # list of [what, text]


def environment(display, layer, scratch):
    env = sides.sanitized(bool(layer), DISPLAY=display, XDG_RUNTIME_DIR=str(scratch))
    if layer:
        env["LD_PRELOAD"] = str(layer)
    return env


def draw(client, names, display, layer, folder, surface):
    """Returns {name: Report}, in the client's order."""
    folder.mkdir(parents=True, exist_ok=True)
    result = subprocess.run([client, "--out", folder, "--surface", surface, *names], text=True,
                            env=environment(display, layer, folder), capture_output=True,
                            timeout=TIMEOUT)
    reports = {}
    for line in result.stdout.splitlines():
        if not line.startswith("{"):
            continue
        row = json.loads(line)
        name = row["case"]
        if "died" in row:
            reports[name] = Report(died=row["died"])
            continue
        pictures = [(what, (folder / f"{name}.{i}.rgba").read_bytes())
                    for i, what in enumerate(row["pictures"])]
        reports[name] = Report(0, row["skipped"], row["failed"], pictures, row["values"])
    if not reports:
        sys.exit(f"paths: the client does not run: {result.stderr[-400:]}")
    return reports


def compare(bare, layer):
    """Returns the differences, as lines."""
    lines = []
    if bare.values != layer.values:
        pairs = [f"{x[0]}: {x[1]}, layer {y[0]}: {y[1]}" for x, y in zip(bare.values, layer.values)
                 if x != y]
        if len(bare.values) != len(layer.values):
            pairs.append(f"{len(bare.values)} values, layer {len(layer.values)}")
        lines += pairs[:6]
    for (what, a), (_, b) in zip(bare.pictures, layer.pictures):
        count, worst = sides.distances(a, b)  # compilers order the same sums differently
        if count:
            lines.append(f"picture '{what}': {count} pixels differ, by up to {worst}")
    return lines


def judge(reason, bare, layer):
    """Returns (result, notes): pass, skip, host (the bare host is wrong, the layer right) or FAIL."""
    if layer.died and layer.died == bare.died:
        return "host", [f"dies, and so it does on the bare host: {layer.died}"]
    if layer.died:
        return "FAIL", [f"died under the layer: {layer.died}"]
    if layer.failed:
        return "FAIL", [f"layer: {line}" for line in layer.failed]
    if layer.skipped:
        return "skip", [layer.skipped]
    if reason:
        differs = bare.died or bare.failed or compare(bare, layer)
        return ("host" if differs else "pass"), [f"the bare host {reason}"] if differs else []
    if bare.died:
        return "FAIL", [f"died on the bare host: {bare.died}"]
    if bare.failed:
        return "FAIL", [f"bare host: {line}" for line in bare.failed]
    lines = compare(bare, layer)
    return ("FAIL" if lines else "pass"), lines


def keep(folder, name, bare, layer):
    folder.mkdir(parents=True, exist_ok=True)
    for (what, a), (_, b) in zip(bare.pictures, layer.pictures):
        if sides.distances(a, b)[0]:
            for side, pixels in (("bare", a), ("layer", b)):
                path = folder / f"{name}.{what.replace(' ', '-')}.{side}.png"
                write_png(path, of_rgba(pixels, SIZE, SIZE))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=Path, default=Path("build"))
    parser.add_argument("--out", type=Path)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--surface", default="window", choices=("pbuffer", "pixmap", "window"))
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    client = build / "tests/layer_vs_host/paths"
    listing = subprocess.run([client, "--list"], text=True, capture_output=True, check=True).stdout
    reasons = dict(line.split("\t") for line in listing.splitlines())
    unknown = set(arguments.names) - set(reasons)
    if unknown:
        sys.exit(f"paths: no such case: {', '.join(sorted(unknown))}")
    rows = []
    with tempfile.TemporaryDirectory(prefix="arbiter-paths-") as scratch, sides.XServer() as display:
        drawn = [draw(client, arguments.names, display, layer, Path(scratch) / name,
                      arguments.surface)
                 for name, layer in (("bare", None), ("layer", build / "src/interposer/libGLX_arbiter.so.0"))]
    for name, layer in drawn[1].items():
        bare = drawn[0].get(name, Report(died=-1))
        result, notes = judge(reasons[name], bare, layer)
        rows.append({"name": name, "result": result, "notes": notes})
        print(f"skip  {name}: {notes[0]}" if result == "skip" else f"{result:5} {name}")
        for note in notes if result != "skip" else ():
            print(f"        {note}")
        if arguments.out:
            keep(arguments.out, name, bare, layer)
    tally = {r: sum(row["result"] == r for row in rows) for r in ("pass", "host", "FAIL", "skip")}
    print(f"paths: the bare host is wrong in {tally['host']} of those that pass")
    print(f"{tally['pass'] + tally['host']} passed, {tally['FAIL']} failed, {tally['skip']} skipped")
    if arguments.json:
        arguments.json.write_text(json.dumps({**tally, "cases": rows}, indent=2))
    return 1 if tally["FAIL"] else 0


if __name__ == "__main__":
    sys.exit(main())
