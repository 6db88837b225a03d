#!/usr/bin/env python3
"""Fails on an #include against the order of the rooms.

    interposer -> dispatch -> state -> {control, enumerants -> fp_compiler, swrast, host} -> util

tools and builder include control, scene, fp_compiler, swrast and the public interface; scene includes
fp_compiler; demonstrations are clients and include none of it. swrast includes only a plain ABI header of
the compiler. External headers are checked too: control, the compiler and util use no GL and no X11,
scene no Qt either, and nothing that enters an application uses libepoxy, which is the clients' loader.

usage: include_graph.py ROOT | include_graph.py --self-test
"""

import pathlib
import re
import sys

import tree

# The rooms that a room may include directly or indirectly.
ALLOWED = {
    "util": set(),
    "control": {"util", "public"},
    "fp_compiler": {"util"},
    "enumerants": {"fp_compiler"},
    "swrast": {"util", "public"},
    "host": {"util", "public"},
    "state": {"control", "enumerants", "fp_compiler", "swrast", "host", "util", "public"},
    "dispatch": {"state", "control", "enumerants", "fp_compiler", "swrast", "host", "util", "public"},
    "interposer": {"dispatch", "state", "control", "enumerants", "fp_compiler", "swrast", "host", "util",
                   "public"},
    "scene": {"fp_compiler", "util"},
    "tools": {"control", "scene", "enumerants", "fp_compiler", "swrast", "util", "public"},
    "builder": {"control", "fp_compiler", "scene", "util", "public"},
    "demos": {"public"},
    "public": set(),
    "precompiled": {"precompiled"},  # the build adds these headers to libraries; no source includes them
}

# Single headers that may be included across an edge that is otherwise forbidden.
EXCEPTIONS = {("swrast", "fp_compiler/abi.h")}

WINDOWS = r"GL/|GLES\d?/|EGL/|KHR/|X11/|glvnd/"
LOADERS = r"epoxy/|GLFW/"
FORBIDDEN_OUTSIDE = {
    "util": re.compile(WINDOWS + "|" + LOADERS),
    "control": re.compile(WINDOWS + "|" + LOADERS),
    "fp_compiler": re.compile(WINDOWS + "|" + LOADERS),
    "scene": re.compile(WINDOWS + "|" + LOADERS + "|Q[A-Z]|Qt"),
    "host": re.compile(LOADERS),
    "swrast": re.compile(LOADERS),
    "state": re.compile(LOADERS),
    "dispatch": re.compile(LOADERS),
    "interposer": re.compile(LOADERS),
}


def room_of(path, root):
    parts = path.relative_to(root).parts
    if parts[0] == "src" and len(parts) > 2:
        return parts[2] if parts[1] == "apps" else parts[1]
    if parts[0] == "demos":
        return "demos"
    if parts[0] == "include":
        return "public"
    return None


def is_test(path):
    return path.stem.endswith("_test") or path.stem.endswith("_bench")


def target_room(name, quoted, source, root):
    """Returns (room, name from src/) of an include; (None, name) if it is external."""
    if quoted:
        # The folder of the including file is searched first, as the compiler does.
        beside = (source.parent / name).resolve()
        if beside.exists() and root.resolve() in beside.parents:
            room = room_of(beside, root.resolve())
            if room:
                inside = beside.relative_to(root.resolve())
                return room, str(pathlib.Path(*inside.parts[1:]))
    if (root / "include" / name).exists():
        return "public", name
    first = name.removeprefix("apps/").split("/")[0]
    if "/" in name and (first in ALLOWED or (root / "src" / name.split("/")[0]).is_dir()):
        return first, name  # generated into a room by the build
    return None, name


def check(root):
    """Returns the complaints about the tree at root, and the number of includes read."""
    complaints, edges = [], 0
    sources = [each for folder in ("src", "demos", "include")
               for each in tree.includes(root / folder)]
    for source, includes in sources:
        room = room_of(source, root)
        if room is None:
            continue
        where = source.relative_to(root)
        if room not in ALLOWED:
            complaints.append("%s: room '%s' has no row in the include graph" % (where, room))
            continue
        for quoted, name in includes:
            edges += 1
            target, inside = target_room(name, quoted, source, root)
            if target is None:
                outside = FORBIDDEN_OUTSIDE.get(room)
                if outside and outside.match(name) and not is_test(source):
                    complaints.append("%s: %s may not include <%s>" % (where, room, name))
            elif target != room and target not in ALLOWED[room] \
                    and (room, inside) not in EXCEPTIONS:
                complaints.append("%s: %s -> %s (%s) is no edge of the graph"
                                  % (where, room, target, name))
    return complaints, edges


# Files that each planted tree has besides its own.
PRESENT = {name: "" for name in ("src/state/core/context.h", "src/host/table.h", "src/util/hash.h",
                                 "demos/common/window.h")}
PLANTED = [
    # ({file: text}, complaints expected)
    ({"src/util/hash.h": '#include "state/core/context.h"\n'}, 1),
    ({"src/fp_compiler/front/lexer.cpp": "#include <GL/gl.h>\n"}, 1),
    ({"src/swrast/cover/bins.cpp": '#include "fp_compiler/ir/ir.h"\n'}, 1),
    ({"src/swrast/cover/bins.cpp": '#include "fp_compiler/abi.h"\n'}, 0),
    ({"src/control/server.cpp": '#include "state/core/context.h"\n'}, 1),
    ({"src/host/table.h": '#include "../state/context.h"\n'}, 1),
    ({"src/dispatch/generated.cpp": '#include "interposer/fronts.h"\n'}, 1),
    ({"src/state/context.cpp": '#include <epoxy/gl.h>\n'}, 1),
    ({"src/state/context.cpp": '#include "host/table.h"\n#include "util/hash.h"\n'}, 0),
    ({"src/apps/scene/mesh.cpp": "#include <GL/gl.h>\n#include <QImage>\n"}, 2),
    ({"src/kitchen/sink.h": ""}, 1),
    ({"demos/twirl.cpp": '#include "fp_compiler/compiler.h"\n'}, 1),
    ({"demos/twirl.cpp": '#include <epoxy/gl.h>\n#include "common/window.h"\n'}, 0),
]


if __name__ == "__main__":
    sys.exit(tree.main(__doc__, check, [(PRESENT | files, expected) for files, expected in PLANTED],
                       "{read} includes read, {wrong} against the graph"))
