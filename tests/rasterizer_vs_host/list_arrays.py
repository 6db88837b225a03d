"""Judges vertex arrays and primitives in display lists: pictures and errors must be equal, and the rasterizer draws
what it can."""

import math

import sides
from runner import Way

# The least number of draws of the rasterizer: lists, and a triangle after each. The host gets lists that restart
# primitives, contain errors or lack positions, and, of lists from before the first program, also those with any state.
ORDERS = {"programs-first": 209, "lists-first": 187, "no-programs": 209}
# There are more if lists are executed too: the triangles after those.
EXECUTED = {"programs-first": 294, "lists-first": 187, "no-programs": 294}
# After arrays with colors the current color is undefined (OpenGL 2.1, 2.8). Mesa uses the value that the previously
# compiled list set, which is a separate list only if the layer keeps none. Hosts split quads that are not flat freely,
# and differently at once and in lists.
UNDEFINED = ("no positions after", "client mode 7 arrays while compiled after",
             "buffer mode 7 arrays while compiled after")
WAYS = Way("compiled", words=("compiled",)), Way("executed", words=("executed",))


def as_at_once(rows):
    """Returns the bare host's rows. If a list draws differently from its commands executed at once, with every
    component given, the latter count. Mesa 25.0.7 gives vertices of a list the coordinates of later ones with more
    components."""
    by_name = dict(rows)
    found = []
    for name, pixels in rows:
        end = " after" if name.endswith(" after") else ""
        directly = by_name.get(name.removesuffix(" after") + " directly" + end, pixels)
        found.append((name, directly if sides.distances(pixels, directly)[0] else pixels))
    return found


def name_in(line):
    """Returns the picture's name in a line of sides.differences."""
    return line.split("'")[1] if "'" in line else line


def alike(run):
    """Compares with the bare host, which makes lists alike. Mesa 22.3.6 refuses commands behind a primitive of a list
    that it also executes, so that there lists are called after compilation. It draws quads of arrays differently in
    lists, and therefore also restarts: those pictures may match either."""
    bares = [run.bare] + ([run.case.bare_of(Way(words=("called",)))] if run.way.name == "executed" else [])
    layered = [row for row in run.layer if row[0] not in UNDEFINED]
    wrong = [sides.differences(as_at_once([row for row in bare if row[0] not in UNDEFINED]), layered) for bare in bares]
    names = set.intersection(*({name_in(line) for line in lines} for lines in wrong))
    return [line for line in wrong[0] if name_in(line) in names]


def drawn(run):
    """Returns the bounds of the rasterizer's draws."""
    return (EXECUTED if run.way.name == "executed" else ORDERS)[run.name], math.inf
