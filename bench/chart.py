#!/usr/bin/env python3
"""Draws the chart of docs/driver/performance.md, and fills its first table, from figures of bench/feedback.py.

usage: chart.py            writes both from bench/figures/*.json
       chart.py --check    1 if one of them does not match the figures
       chart.py -o SVG FEEDBACK.json...    draws a chart of other figures

The files of bench/figures have the form that `bench/feedback.py --json` writes, without the turns.
"""

import argparse
import json
import pathlib
import sys
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES = [ROOT / "bench/figures" / name for name in ("xeon.json", "epyc.json")]
SVG = ROOT / "docs/pictures/performance.svg"
PAGE = ROOT / "docs/driver/performance.md"
BEGIN, END = "<!-- bench/chart.py: table -->\n", "<!-- end of table -->\n"

STYLE = """
text { font: 13px "DejaVu Sans", Verdana, sans-serif; fill: #1f2328; }
.title { font-weight: bold; } .small { font-size: 11px; fill: #59636e; }
.back { fill: #ffffff; } .axis { stroke: #d0d7de; } .bound { stroke: #cf222e; stroke-width: 2; }
.bar0 { fill: #0969da; } .bar1 { fill: #bf8700; }
@media (prefers-color-scheme: dark) {
  text { fill: #e6edf3; } .small { fill: #9198a1; } .back { fill: #0d1117; } .axis { stroke: #3d444d; }
  .bar0 { fill: #4493f8; } .bar1 { fill: #d29922; } .bound { stroke: #f85149; }
}
"""
SCENES = {"scene, fixed-function vertices": "100,000 triangles", "scene, vertex program": "with a vertex program"}
LEFT, WIDTH, BAR, GAP, TOP = 170, 760, 11, 12, 62


def shown_rows(document):
    return [row for row in document["rows"] if row["part"] in ("workloads", "scene")]


def name_of(document):
    return f"{document['machine']['model']}, {document['machine']['processors']} processors"


def tidy(figure):
    return f"{figure:.2f}" if figure < 3 else f"{figure:.1f}" if figure < 30 else f"{figure:.0f}"


def draw(documents):
    """Returns the chart: for each row one bar for each machine, and the bound as a red line."""
    rows = [row["name"] for row in shown_rows(documents[0])]
    most = max(row["figure"] for document in documents for row in shown_rows(document))
    scale = (WIDTH - LEFT - 60) / most
    step = BAR * len(documents) + GAP
    height = TOP + step * len(rows) + 30
    size = documents[0]["size"]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" '
           f'viewBox="0 0 {WIDTH} {height}" role="img">',
           "<title>How many times faster than llvmpipe Arbiter's rasterizer draws</title>",
           f"<style>{STYLE}</style>", f'<rect class="back" width="{WIDTH}" height="{height}"/>',
           '<text class="title" x="12" y="22">Times faster than llvmpipe '
           f'({size}x{size}; the red line is the bound that is aimed at)</text>']
    for index, document in enumerate(documents):
        x = 12 + 260 * index
        out.append(f'<rect class="bar{index}" x="{x}" y="34" width="12" height="12"/>'
                   f'<text class="small" x="{x + 18}" y="44">{escape(name_of(document))}</text>')
    for place in range(0, int(most) + 1, 10):
        x = LEFT + place * scale
        out.append(f'<line class="axis" x1="{x:.1f}" y1="{TOP - 6}" x2="{x:.1f}" y2="{height - 24}"/>'
                   f'<text class="small" x="{x:.1f}" y="{height - 10}" text-anchor="middle">{place}</text>')
    for line, name in enumerate(rows):
        y = TOP + line * step
        label = SCENES.get(name, name)
        out.append(f'<text x="{LEFT - 8}" y="{y + step / 2 - 1:.1f}" text-anchor="end">{escape(label)}</text>')
        for index, document in enumerate(documents):
            row = next(row for row in shown_rows(document) if row["name"] == name)
            top, end = y + index * BAR, row["figure"] * scale
            out.append(f'<rect class="bar{index}" x="{LEFT}" y="{top}" width="{end:.1f}" height="{BAR - 1}"/>'
                       f'<text class="small" x="{LEFT + end + 4:.1f}" y="{top + BAR - 2}">{tidy(row["figure"])}</text>')
            if row.get("bound"):
                x = LEFT + row["bound"] * scale
                out.append(f'<line class="bound" x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{top + BAR - 1}"/>')
    return "\n".join(out + ["</svg>"]) + "\n"


def table(documents):
    """Returns the page's table: the first machine in full, and the ratio of the others."""
    first, *others = documents
    out = ["| program | llvmpipe, ms | Arbiter, ms | times faster | 95 of 100 | bound | in a window |"
           + "".join(f" {name_of(other)} |" for other in others),
           "|---|---|---|---|---|---|---|" + "---|" * len(others)]
    shown = {row["name"]: row for row in first["rows"] if row["part"] == "window"}
    for row in shown_rows(first):
        window = shown.get(row["name"] + ", shown")
        cells = [row["name"].replace("scene, ", "100,000 triangles, "),
                 *(f"{row[side]:g}" if side in row else "" for side in ("bare", "layered")), tidy(row["figure"]),
                 f"{row['low']:g}–{row['high']:g}" if "low" in row else "", f"{row['bound']:g}",
                 tidy(window["figure"]) if window else ""]
        for other in others:
            cells.append(tidy(next(each["figure"] for each in shown_rows(other) if each["name"] == row["name"])))
        out.append("| " + " | ".join(cells) + " |")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("-o", "--output", type=pathlib.Path)
    parser.add_argument("feedback", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    documents = [json.loads(path.read_text()) for path in options.feedback or FIGURES]
    if options.output:
        options.output.write_text(draw(documents))
        return 0
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    wanted = {SVG: draw(documents), PAGE: before + BEGIN + table(documents) + END + rest.split(END)[1]}
    stale = [path for path, text in wanted.items() if not path.exists() or path.read_text() != text]
    for path in stale:
        if not options.check:
            path.write_text(wanted[path])
        print(path.relative_to(ROOT), "is not what bench/figures says" if options.check else "written")
    return 1 if options.check and stale else 0


if __name__ == "__main__":
    sys.exit(main())
