#!/usr/bin/env python3
"""Fails on an #include between rooms inside a room that is against their order, on
circular includes of more than eight units, on a room of too many files, and on an
entry point of state outside of the room of entry points.

A room is a folder of ALLOWED; a folder that has no row belongs to the room that contains it. Includes
between a room and one that contains it are free: the outer one has what its rooms share, and what puts
them together. A unit is a header and its source. Tests, benchmarks and files in a folder `testing` may
include everything.

usage: sub_rooms.py ROOT | sub_rooms.py --self-test
"""

import pathlib
import re
import sys

import tree

IR = "fp_compiler/ir"
LLVM = "fp_compiler/back/llvm"
R300 = "fp_compiler/hw/r300"
CORE = "state/core"
SHARE = "state/share"
PROGRAMS = "state/programs"
LISTS = "state/lists"
HOST_DRAW = "state/host_draw"
REPORT = "state/report"
MIRROR = "state/mirror"
RESIDENCY = "state/residency"
RASTER_DRAW = "state/raster_draw"
CONTROL = "state/control"
HUD = "state/hud"
ERA = "state/era"
IMAGING = "state/imaging"
PIXELS = "state/client_pixels"
STATE = {CONTROL, HUD, CORE, SHARE, PROGRAMS, LISTS, HOST_DRAW, REPORT, MIRROR, RESIDENCY, RASTER_DRAW,
         ERA, IMAGING, PIXELS}

# The rooms that a room may include, if neither contains the other.
ALLOWED = {
    "fp_compiler": set(),
    IR: set(),
    "fp_compiler/analysis": {IR},
    "fp_compiler/opt": {IR},
    "fp_compiler/ati": {IR},
    "fp_compiler/vertex_shader": {IR},
    "fp_compiler/front": {"fp_compiler/ati", IR},
    "fp_compiler/hw": {IR, R300, R300 + "/report"},
    R300: {IR, R300 + "/lower", R300 + "/pair"},
    R300 + "/lower": {IR},
    R300 + "/pair": {R300 + "/lower"},
    R300 + "/check": {IR},
    R300 + "/execute": {R300 + "/check", IR},
    R300 + "/report": {R300 + "/check", IR},
    "fp_compiler/back/assembly": {IR},
    "fp_compiler/back/glsl": {"fp_compiler/analysis", IR},
    LLVM + "/code": set(),
    LLVM + "/math": {LLVM + "/code"},
    LLVM + "/program": {LLVM + "/code", LLVM + "/math", "fp_compiler/analysis", "fp_compiler/opt", IR},
    LLVM + "/sample": {LLVM + "/code", LLVM + "/math"},
    LLVM + "/pixel": {LLVM + "/code", IR},
    LLVM + "/fragment": {LLVM + "/code", LLVM + "/math", LLVM + "/program", LLVM + "/pixel",
                         "fp_compiler/analysis", IR},
    LLVM + "/engine": {LLVM + "/code", LLVM + "/program", LLVM + "/fragment", IR},
    "enumerants": set(),
    "swrast": set(),
    "swrast/image": set(),
    "swrast/setup": set(),
    "swrast/cover": {"swrast/setup"},
    "swrast/strokes": {"swrast/setup", "swrast/cover"},
    # A context has parts of all rooms except the entry points, which nothing includes: what they call never calls back.
    # The mirror and residency do not know contexts.
    "state": set(),
    CORE: STATE,
    SHARE: {CORE, PROGRAMS, LISTS, HOST_DRAW, RASTER_DRAW},
    PROGRAMS: {CORE, SHARE, LISTS, HOST_DRAW, REPORT, ERA, IMAGING, PIXELS},
    LISTS: {CORE, SHARE, PROGRAMS, HOST_DRAW, MIRROR, RASTER_DRAW, ERA, IMAGING},
    HOST_DRAW: {CORE, SHARE, PROGRAMS, LISTS, REPORT, MIRROR, RASTER_DRAW, ERA, IMAGING},
    REPORT: {CORE, PROGRAMS, HOST_DRAW, RASTER_DRAW},
    RASTER_DRAW: {CORE, SHARE, PROGRAMS, LISTS, HOST_DRAW, MIRROR, RESIDENCY, IMAGING},
    ERA: {CORE, SHARE, LISTS, MIRROR, RASTER_DRAW},
    IMAGING: {CORE, PROGRAMS, LISTS, MIRROR, RASTER_DRAW, PIXELS},
    PIXELS: {CORE, MIRROR},
    "state/handlers": STATE,
    MIRROR: {CORE},
    RESIDENCY: {CORE, SHARE, MIRROR},
    # Observers of drawing are above the drawing rooms, which only know their hooks (core/control_hooks.h).
    CONTROL: {CORE, SHARE, PROGRAMS, HOST_DRAW, REPORT, MIRROR, RASTER_DRAW, HUD, PIXELS},
    HUD: {CORE, SHARE, REPORT, MIRROR, RASTER_DRAW, CONTROL, PIXELS},
    # Words and panels come first; textures and meshes are made from them; the document has all.
    "scene": set(),
    "scene/panel": set(),
    "scene/texture": {"scene/panel"},
    "scene/mesh": {"scene/panel", "scene/texture"},
    # The window's views show models, and no model includes a view.
    "builder/model": set(),
    "builder/model/text": set(),
    "builder/model/language": {"builder/model/text"},
    "builder/model/render": {"builder/model/text", "builder/model/language"},
    "builder/model/panels": {"builder/model/text", "builder/model/render"},
    "builder/model/attach": {"builder/model/text", "builder/model/language", "builder/model/render",
                             "builder/model/panels"},
    "builder/view": {"builder/model"},
    "builder/view/editor": {"builder/model", "builder/model/panels"},
    "builder/view/picture": {"builder/model", "builder/model/render"},
    "builder/view/panels": {"builder/model", "builder/model/attach", "builder/model/panels", "builder/view/editor",
                            "builder/view/picture"},
    "builder/view/window": {"builder/model", "builder/model/attach", "builder/model/panels", "builder/view/editor",
                            "builder/view/panels", "builder/view/picture"},
    "util": set(),
    "util/cache": set(),
    "util/record": set(),
}
MOST_UNITS = 8  # in a circle
MOST_FILES = 35  # in one folder, including tests and tables

HANDLERS = "state/handlers"
HANDLER = re.compile(r"^namespace (arbiter::state::)?handlers {", re.M)
SUFFIXES = {".h", ".cpp", ".def"}


def room_of(name):
    """Returns the innermost room of ALLOWED that contains the file; None if there is none."""
    for folder in pathlib.PurePosixPath(name).parents:
        if str(folder) in ALLOWED:
            return str(folder)
    return None


def is_production(name):
    path = pathlib.PurePosixPath(name)
    return "testing" not in path.parts and not path.stem.endswith(("_test", "_bench"))


def lies_in(inner, outer):
    return inner == outer or inner.startswith(outer + "/")


def read(source):
    """Returns {file: [files of src/ that it includes]}, without tests."""
    graph = {}
    for path, includes in tree.includes(source):
        name = path.relative_to(source).as_posix()
        if path.suffix in SUFFIXES and is_production(name):
            graph[name] = [each for quoted, each in includes if quoted and (source / each).exists()]
    return graph


def wrong_edges(graph):
    for name, includes in graph.items():
        room = room_of(name)
        if room is None:
            continue
        for other in includes:
            target = room_of(other)
            if target is None or lies_in(room, target) or lies_in(target, room):
                continue
            if target.split("/")[0] == room.split("/")[0] and target not in ALLOWED[room]:
                yield f"src/{name}: {room} may not include {other}"


def circles(graph):
    """Returns the strongly connected sets of units, by Tarjan's method without recursion."""
    units = {}
    for name, includes in graph.items():
        unit = units.setdefault(name.rsplit(".", 1)[0], set())
        unit.update(each.rsplit(".", 1)[0] for each in includes)
    index, low, stack, waiting, found = {}, {}, [], set(), []
    for start in units:
        if start in index:
            continue
        work = [(start, iter(sorted(units[start])))]
        index[start] = low[start] = len(index)
        stack.append(start)
        waiting.add(start)
        while work:
            unit, rest = work[-1]
            for other in rest:
                if other not in units:
                    continue
                if other not in index:
                    index[other] = low[other] = len(index)
                    stack.append(other)
                    waiting.add(other)
                    work.append((other, iter(sorted(units[other]))))
                    break
                if other in waiting:
                    low[unit] = min(low[unit], index[other])
            else:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[unit])
                if low[unit] == index[unit]:
                    members = set()
                    while unit not in members:
                        members.add(stack.pop())
                    waiting -= members
                    found.append(sorted(members))
    return found


def crowded(source):
    for folder in sorted({path.parent for path in source.rglob("*") if path.suffix in SUFFIXES}):
        files = sum(path.suffix in SUFFIXES for path in folder.iterdir())
        if files > MOST_FILES:
            yield f"src/{folder.relative_to(source)}: {files} files, more than {MOST_FILES}"


def misplaced(source):
    """Yields sources that implement entry points (namespace handlers) outside of state/handlers."""
    for path in sorted(source.glob("state/**/*.cpp")):
        name = path.relative_to(source).as_posix()
        if is_production(name) and room_of(name) != HANDLERS and HANDLER.search(path.read_text()):
            yield f"src/{name}: entry points belong in {HANDLERS}"


def check(root):
    """Returns the complaints about the tree, and the number of files read."""
    source = root / "src"
    graph = read(source)
    complaints = [*wrong_edges(graph), *crowded(source), *misplaced(source)]
    for members in circles(graph):
        if len(members) > MOST_UNITS:
            complaints.append(f"{len(members)} units reach each other: " + " ".join(members))
    return complaints, len(graph)


def circle(count):
    return {f"src/util/unit{i}.h": f'#include "util/unit{(i + 1) % count}.h"\n'
            for i in range(count)}


PLANTED = [
    # (files, complaints expected)
    ({"src/state/core/a.h": '#include "state/handlers/b.h"\n', "src/state/handlers/b.h": ""}, 1),
    ({"src/state/residency/a.h": '#include "state/raster_draw/b.h"\n',
      "src/state/raster_draw/b.h": ""}, 1),
    ({"src/swrast/setup/a.h": '#include "swrast/cover/b.h"\n', "src/swrast/cover/b.h": ""}, 1),
    ({"src/swrast/cover/b.h": '#include "swrast/setup/a.h"\n', "src/swrast/setup/a.h": ""}, 0),
    ({"src/swrast/draw.h": "", "src/swrast/setup/a.h": '#include "swrast/draw.h"\n',
      "src/swrast/draw.cpp": '#include "swrast/setup/a.h"\n'}, 0),
    ({"src/swrast/setup/a_test.cpp": '#include "swrast/cover/b.h"\n',
      "src/swrast/cover/b.h": ""}, 0),
    ({"src/fp_compiler/back/llvm/program/a.h": '#include "fp_compiler/back/glsl/b.h"\n',
      "src/fp_compiler/back/glsl/b.h": ""}, 1),
    (circle(MOST_UNITS), 0),
    (circle(MOST_UNITS + 1), 1),
    ({"src/state/core/a.cpp": "namespace handlers {\n"}, 1),
    ({"src/state/handlers/a.cpp": "namespace handlers {\n"}, 0),
    ({f"src/util/file{i}.cpp": "" for i in range(MOST_FILES + 1)}, 1),
]


if __name__ == "__main__":
    sys.exit(tree.main(__doc__, check, PLANTED, "{read} files read, {wrong} complaints"))
