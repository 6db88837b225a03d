#!/usr/bin/env python3
"""Draws docs/design/tour.svg, the map of the rooms, from the includes of src.

usage: tour_map.py            writes it
       tour_map.py --check    writes nothing; 1 if the map is not that of the includes

A room stands above the rooms that it includes, and an arrow is an include that no longer way implies. The rooms of
state stand one above the other, in the order of tests/include_graph/sub_rooms.py.
"""

import html
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "include_graph"))
import include_graph  # noqa: E402
import sub_rooms  # noqa: E402
import tree  # noqa: E402

MAP = ROOT / "docs/design/tour.svg"
# What a room is for, and its column.
ROOMS = {
    "interposer": ("GLX, EGL, preload, OSMesa", 1), "dispatch": ("generated entry points", 1),
    "state": ("a context and its parts, the highest first", 0), "tools": ("the command arbiter", 3),
    "builder": ("the Shader Builder's window", 4), "scene": ("documents: panels, meshes", 4),
    "enumerants": ("GL's names and the compiler's", 1), "swrast": ("a rasterizer without GL", 2),
    "control": ("messages to and from clients", 0), "fp_compiler": ("program text to IR, GLSL, code", 3),
    "host": ("the host's functions", 2), "util": ("log, flags, JSON, cache", 2),
}
WIDTH, HEIGHT, ACROSS, DOWN, MARGIN = 168, 46, 24, 54, 20
FLOOR = 20  # height of a room of state
STYLE = """text { font: 12px sans-serif; fill: #1b222b; }
.name { font-weight: bold; }
.about { font-size: 10px; fill: #51606f; }
.room { fill: #ffffff; stroke: #7a8a99; }
.floor { fill: #eef3f8; stroke: #c3cfda; }
.page { fill: #f7f9fb; }
path { stroke: #8795a3; fill: none; }
marker path { fill: #8795a3; stroke: none; }"""


def edges():
    """Returns {room: rooms that it includes}."""
    found = {room: set() for room in ROOMS}
    generator = (ROOT / "src/dispatch/thunks.py").read_text()  # writes the includes of dispatch's sources
    found["dispatch"] = {name.split("/")[0] for name in re.findall(r'#include "(\w+/[^"]+)"', generator)} - {"dispatch"}
    for source, includes in tree.includes(ROOT / "src"):
        room = include_graph.room_of(source, ROOT)
        if room not in found or include_graph.is_test(source) or "testing" in source.parts:
            continue
        for quoted, name in includes:
            target, _ = include_graph.target_room(name, quoted, source, ROOT)
            if target in found and target != room:
                found[room].add(target)
    return found


def heights(graph):
    """Returns {room: the length of the longest way down from it}."""
    known = {}

    def height(room):
        if room not in known:
            known[room] = 1 + max((height(each) for each in graph[room]), default=-1)
        return known[room]

    for room in graph:
        height(room)
    return known


def reduced(graph):
    """Leaves out an edge that a longer way implies."""
    def reaches(start, goal):
        return any(each == goal or reaches(each, goal) for each in graph[start])

    return {room: {each for each in below if not any(reaches(other, each) for other in below - {each})}
            for room, below in graph.items()}


class Drawing:
    def __init__(self):
        self.parts = []

    def box(self, kind, x, y, width, height):
        self.parts.append(f'<rect class="{kind}" x="{x}" y="{y}" width="{width}" height="{height}" rx="4"/>')

    def text(self, kind, x, y, words):
        self.parts.append(f'<text class="{kind}" x="{x}" y="{y}">{html.escape(words)}</text>')

    def arrow(self, x1, y1, x2, y2):
        middle = (y1 + y2) // 2
        self.parts.append(f'<path d="M{x1} {y1} C{x1} {middle} {x2} {middle} {x2} {y2 - 5}" marker-end="url(#end)"/>')


def picture():
    graph = edges()
    height = heights(graph)
    floors = list(reversed(sub_rooms.ORDER["state"]))
    lines = -(-len(floors) // 3)
    sizes = {room: (3 * WIDTH + 2 * ACROSS, HEIGHT + FLOOR * lines + 8) if room == "state" else (WIDTH, HEIGHT)
             for room in ROOMS}
    drawing, place, y = Drawing(), {}, MARGIN
    for level in range(max(height.values()), -1, -1):
        row = [room for room in ROOMS if height[room] == level]
        for room in row:
            place[room] = (MARGIN + ROOMS[room][1] * (WIDTH + ACROSS), y, *sizes[room])
        y += max(sizes[room][1] for room in row) + DOWN
    for room, below in sorted(reduced(graph).items()):
        for other in sorted(below):
            x1, y1, width1, tall1 = place[room]
            x2, y2, width2, _ = place[other]
            drawing.arrow(x1 + width1 // 2, y1 + tall1, x2 + width2 // 2, y2)
    for room, (x, top, width, tall) in place.items():
        drawing.box("room", x, top, width, tall)
        drawing.text("name", x + 10, top + 19, room)
        drawing.text("about", x + 10, top + 35, ROOMS[room][0])
        for number, floor in enumerate(floors if room == "state" else ()):
            column = (width - 20) // 3
            left, line = x + 10 + number // lines * column, number % lines
            drawing.box("floor", left, top + HEIGHT + line * FLOOR, column - 4, FLOOR - 3)
            drawing.text("about", left + 6, top + HEIGHT + line * FLOOR + 12, floor)
    width, tall = 5 * WIDTH + 4 * ACROSS + 2 * MARGIN, y - DOWN + MARGIN
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {tall}" width="{width}" height="{tall}" '
            'role="img" aria-label="The rooms of src, and which includes which">\n'
            f"<style>{STYLE}</style>\n"
            '<marker id="end" viewBox="0 0 8 8" refX="4" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
            '<path d="M0 0 L8 4 L0 8 z"/></marker>\n'
            f'<rect class="page" width="{width}" height="{tall}"/>\n' + "\n".join(drawing.parts) + "\n</svg>\n")


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    drawn = picture()
    if not sys.argv[1:]:
        MAP.write_text(drawn)
        return 0
    if MAP.read_text() == drawn:
        return 0
    print(f"{MAP.relative_to(ROOT)} is not the map of the includes; docs/tour_map.py makes it", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
