"""Judges passes that compare depths for equality. Passes that meet on the bare host must meet under the layer, however
they transform their vertices, and whoever draws the frame. Passes that only meet under the layer are no fault, as hosts
differ in that."""

import re

import checks
import sides
from runner import Way

# The host may draw a frame with its own order of operations in the transformation, and the rasterizer the next. The
# back end `host` must meet as the bare host does, to the pixel. Under the legacy numerics vertex programs are GLSL on
# the host, which clips them by planes in eye space, and fixed function in clip space.
WAYS = (Way("auto", "auto", {"ARBITER_DEBUG": "steady"}),
        Way("auto, late code", "auto", {"ARBITER_DEBUG": "late-code"}),
        Way("swrast", "swrast"), Way("host", "host"),
        Way("host, legacy numerics", "host", {"ARBITER_NUMERICS": "legacy"}))
HOSTS = ("llvmpipe", "softpipe")
# With x87, softpipe's vertices are computed there. Where a sum of products is rounded depends on its operations, so
# that GLSL meets fixed function only by chance.
ALONE_BY_X87 = {"llvmpipe": set(), "softpipe": {"fixed", "invariant"}}
# The fraction of pixels that met which may be missing under the layer, as the two rasterizers may cover edges
# differently.
LOST = 0.01
# With so few pixels the fraction says nothing.
FEW = 12


def met(picture):
    """Returns the pixels of the second pass, which is white; the first one is blue."""
    return {i for i in range(0, len(picture), 4) if picture[i] > 127}


def covered(picture):
    return {i for i in range(0, len(picture), 4) if picture[i + 2] > 127}


def transforms(what):
    """Returns the names of the first and second pass's transformation."""
    return [way.split(" by ")[0] for way in re.sub(r"^seed \d+: (clipped, )?", "", what).split(", then ")]


def meet(run):
    """Checks each pair of passes. On the back end `host`, passes that do not meet bare may not meet here either. Under
    the legacy numerics user clip planes cut not all ways' transformations at the same places."""
    exact, legacy = run.way.name == "host", "legacy" in run.way.name
    alone = ALONE_BY_X87[run.case.driver] if sides.HOST_HAS_X87 and legacy else set()

    def lost(what, bare, layer):
        first, second = transforms(what)
        if legacy and "clipped" in what or first != second and {first, second} & alone:
            return None
        if exact:
            return checks.far_line(what, *sides.distances(bare, layer))
        wanted = met(bare)
        count = len((wanted & covered(layer)) - met(layer))
        return f"'{what}': {count} of {len(wanted)} pixels are lost" if count > max(FEW, LOST * len(wanted)) else None
    return checks.each(lost)(run)


def some_meet(run):
    """The comparison must be able to show something: some passes must meet on the bare host, and others not."""
    counts = [(what, len(met(picture))) for what, picture in run.bare]
    if sum(count > 100 for _, count in counts) < len(counts) // 2:
        return ["too few passes meet on the bare host"]
    return [f"'{what}': {what[what.rindex('GL'):]}" for what, _ in counts if "GL_" in what]
