#!/usr/bin/env python3
"""Fails on an #include between the rooms inside a room that goes upward, on a folder without a place in
the order, on units that reach each other in a circle of more than eight, on a room of too many files, and
on an entry point of state that lies outside the room of entry points.

A room is a folder. ORDER lists the rooms of each room, the lowest first: a room includes what stands below
it in its list, and nothing else of that list, nor through files of the room that both lie in. Other edges
between a room and one that it lies in are free: the outer one holds what its rooms share, and what puts them
together. A generated header belongs to the room that implements it. A unit is a header and its source. Tests,
benchmarks and what lies in a folder `testing` may see everything.

usage: sub_rooms.py ROOT | sub_rooms.py --self-test
"""

import pathlib
import re
import sys

import tree

# The rooms of each room, the lowest first. include_graph.py has those of src itself.
ORDER = {
    # The document, the command, the window.
    "apps": ["scene", "tools", "builder"],
    "apps/builder": ["model", "view"],
    "apps/builder/model": ["text", "language", "render", "panels", "attach"],
    "apps/builder/view": ["editor", "picture", "panels", "window"],
    "fp_compiler": ["ir", "analysis", "ati", "combiners", "hw", "opt", "back", "texture_shader", "vertex_shader",
                    "front", "doubts"],
    "fp_compiler/back": ["assembly", "llvm", "glsl"],
    "fp_compiler/back/llvm": ["code", "math", "pixel", "sample", "program", "fragment", "engine"],
    "fp_compiler/front": ["words", "c_like", "core", "ati", "bindings", "nv", "assembly", "arb", "native", "nvparse",
                          "reference"],
    "fp_compiler/hw": ["i915", "nv30", "r300"],
    "fp_compiler/hw/r300": ["check", "execute", "lower", "pair", "report"],
    "interposer": ["preload"],
    # Words and panels come first; textures and meshes are made of them; the document has all.
    "apps/scene": ["panel", "texture", "mesh"],
    # What a host can do, and what its state is; plain objects; what a context says it is; a context; what it draws
    # with, and by which of two ways; lists, which execute commands; who watches; entry points; what makes and frees
    # contexts.
    "state": ["capabilities", "mirror", "primitives", "objects", "identity", "share", "core", "client_pixels", "era",
              "imaging", "residency", "report", "programs", "host_draw", "raster_draw", "pixel_commands", "lists",
              "context", "statistics", "control", "hud", "handlers", "lifecycle"],
    "state/handlers": ["entry", "fixed_function", "imaging", "vertex_shader"],
    "state/host_draw": ["evaluators", "stages", "linking", "texturing"],
    "state/programs": ["nv", "variants", "combiners", "texture_shaders", "vertex_shaders"],
    "state/raster_draw": ["functions", "frames", "fixed_function", "vertices", "immediate"],
    "swrast": ["image", "setup", "cover", "strokes", "queue"],
    "apps/tools": ["advise", "check", "launch", "draw", "debug", "ctl", "complete", "doctor", "lsp", "options", "page",
              "render", "report", "stats"],
    "apps/tools/advise": ["rules"],
    "apps/tools/debug": ["trace", "pixel", "draws", "gl"],
    "util": ["text", "numbers", "cache", "hud", "defaults", "record"],
}
# Generated headers that another room than their folder's implements.
GENERATED = {"host/handlers.h": "state/handlers/handlers.h"}
MOST_UNITS = 8  # of a circle
MOST_FILES = 35  # of one folder, tests and tables included

HANDLERS = "state/handlers"
HANDLER = re.compile(r"^namespace (arbiter::state::)?handlers {", re.M)
SUFFIXES = {".h", ".cpp", ".def"}


def is_production(name):
    path = pathlib.PurePosixPath(name)
    return not {"testing", "testdata"} & set(path.parts) and not path.stem.endswith(("_test", "_bench"))


def read(source):
    """Returns {file: [files of src/ that it includes]}, without tests."""
    graph = {}
    for path, includes in tree.includes(source):
        name = path.relative_to(source).as_posix()
        if path.suffix in SUFFIXES and is_production(name):
            graph[name] = [GENERATED.get(each, each) for quoted, each in includes
                           if quoted and (each in GENERATED or (source / each).exists())]
    return graph


def parting(name, other):
    """(room, its room of `name`, its room of `other`) where the ways of two files part; None where one of them lies
    beside the other's room."""
    here, there = (pathlib.PurePosixPath(each).parent.parts for each in (name, other))
    for level, (mine, others) in enumerate(zip(here, there)):
        if mine != others:
            return "/".join(here[:level]), mine, others
    return None


def wrong_edges(graph):
    for name, includes in graph.items():
        for other in includes:
            room, mine, others = parting(name, other) or (None, None, None)
            order = ORDER.get(room, [])
            if mine in order and others in order and order.index(others) > order.index(mine):
                yield f"src/{name}: {room}/{mine} stands below {other}"


def room_within(room, name):
    """Returns the room of `room` that a file lies in; "" where it lies in `room` itself, None outside of it."""
    folder = str(pathlib.PurePosixPath(name).parent)
    if folder == room:
        return ""
    return folder[len(room) + 1:].split("/")[0] if folder.startswith(room + "/") else None


def ways_through(graph):
    """Yields includes that lead from a room to one above it, by way of files of the room that both lie in."""
    for room, order in ORDER.items():
        found = set()
        for name in graph:
            mine = room_within(room, name)
            if mine not in order:
                continue
            seen, waiting = set(), [each for each in graph[name] if room_within(room, each) == ""]
            while waiting:
                shared = waiting.pop()
                if shared in seen:
                    continue
                seen.add(shared)
                for other in graph.get(shared, []):
                    theirs = room_within(room, other)
                    if theirs == "":
                        waiting.append(other)
                    elif theirs in order and order.index(theirs) > order.index(mine):
                        found.add(f"src/{shared}: leads from {room}/{mine} up to {other}")
        yield from sorted(found)


def without_place(graph):
    """Folders that the list of their room lacks."""
    for folder in sorted({each for name in graph for each in pathlib.PurePosixPath(name).parents}):
        room = str(folder.parent)
        if room != "." and folder.name not in ORDER.get(room, []):
            yield f"src/{folder}: has no place in the order of {room}"


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
        if is_production(name) and not name.startswith(HANDLERS + "/") and HANDLER.search(path.read_text()):
            yield f"src/{name}: entry points belong in {HANDLERS}"


def check(root):
    """Returns the complaints about the tree, and the number of files read."""
    source = root / "src"
    graph = read(source)
    complaints = [*wrong_edges(graph), *ways_through(graph), *without_place(graph), *crowded(source),
                  *misplaced(source)]
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
    ({"src/swrast/setup/a.h": '#include "swrast/b.h"\n', "src/swrast/b.h": '#include "swrast/c.h"\n',
      "src/swrast/c.h": '#include "swrast/cover/d.h"\n', "src/swrast/cover/d.h": ""}, 1),
    ({"src/swrast/cover/a.h": '#include "swrast/b.h"\n', "src/swrast/b.h": '#include "swrast/setup/d.h"\n',
      "src/swrast/setup/d.h": ""}, 0),
    ({"src/state/lists/a.cpp": '#include "host/handlers.h"\n'}, 1),
    ({"src/state/handlers/a.cpp": '#include "host/handlers.h"\n'}, 0),
    ({"src/apps/tools/check/a.cpp": '#include "apps/tools/draw/b.h"\n', "src/apps/tools/draw/b.h": ""}, 1),
    ({"src/apps/builder/model/text/a.h": '#include "apps/builder/view/window/b.h"\n',
      "src/apps/builder/view/window/b.h": ""}, 1),
    ({"src/fp_compiler/front/words/a.h": '#include "fp_compiler/front/ati/words.def"\n',
      "src/fp_compiler/front/ati/words.def": ""}, 1),
    ({"src/state/host_draw/variants/a.h": ""}, 1),
    ({"src/state/host_draw/linking/a.h": '#include "state/lists/b.h"\n', "src/state/lists/b.h": ""}, 1),
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
