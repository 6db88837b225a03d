"""Judges random primitives with random fragment programs and nearest and linear filters. Bytes and floats must be equal
to the last bit. Inputs often lie on edges of texels and on ties of cube map axes, where the last bit of an input
selects another texel. Programs use all instructions. Only the results in the tables below may differ."""

import array
import dataclasses
import math

import checks
import depth_planes
import sides


@dataclasses.dataclass(frozen=True)
class Row:
    """A result in which two correct implementations may differ."""
    section: str
    why: str
    relative: float = 0.0  # allowed relative difference of floats
    absolute: float = 0.0


STEP = 2.0 ** -23
# The last instruction of a program "about" one of these is compared with the row's bounds, bytes with a step of 255.
# OpenGL 2.1, 2.1.1, requires results to be "accurate to about 1 part in 10^5", and no order.
ABOUT = {
    "RSQ": Row("2.1.1", "the host divides by a root, in more time than an estimate and a step", relative=2 * STEP),
    "LG2": Row("2.1.1", "the host divides, and loses the last bits below 1", relative=2 * STEP, absolute=2 * STEP),
    "POW": Row("2.1.1", "the host's LG2 times the exponent, which enlarges its errors", relative=2.0 ** -15),
    "LIT": Row("2.1.1", "its z is POW", relative=2.0 ** -15),
    "LRP": Row("3.11.5.14", "the host computes c + a * (b - c), which loses b where c is large", absolute=2 * STEP),
    "terms that cancel": Row("2.1.1", "the host takes (b - a) + a for b", absolute=2 * STEP),
    "terms with a factor in common": Row("2.1.1", "the host takes a * b + a * c for a * (b + c)", absolute=2 * STEP),
    "a third term": Row("2.1.1", "the host adds it to the first of two products", absolute=2 * STEP),
    "constants in sums": Row("2.1.1", "the host adds those of several instructions up", absolute=2 * STEP),
}
# No program has these.
UNDEFINED = {
    "POW and LG2 of what is not above 0": Row("3.11.5.12", "undefined, for POW by way of LG2"),
    "LIT's 0^0": Row("3.11.5.13", "1, and 0 on the host"),
    "SCS's z and w": Row("3.11.5.23", "undefined"),
    "XPD's w": Row("3.11.5.29", "undefined"),
    "TXP with a fourth component not above 0": Row("3.11.6.2", "undefined"),
    "lookups beyond 2^31 texels": Row("3.8.7", "CLAMP_TO_EDGE is the last texel, and the first on the host"),
    "lookups at infinities and at no number": Row("3.8.7", "undefined"),
    "flat colours": Row("2.14.7", "of the provoking vertex, and interpolated in the host's own fragment programs"),
    "levels of detail": Row("3.8.8", "may be approximated: row levels of comparisons.py"),
}


def about(what):
    """Returns the row for a picture, None if each bit counts."""
    return next((row for name, row in ABOUT.items() if f": about {name}:" in what), None)


def near(x, y, row):
    if x == y or (x != x and y != y):
        return True
    bound = row.absolute + row.relative * max(abs(x), abs(y)) if row else 0.0
    return math.isfinite(bound) and abs(x - y) <= bound


def differing(what, a, b):
    """Returns a line about the difference of two pictures, or nothing. NaNs are equal."""
    row = about(what)
    # Debian's 32-bit x86 Mesa computes new vertices and lines with x87's precision. Some of many triangles are cut.
    if a == b or sides.HOST_HAS_X87 and (not depth_planes.uncut(what) or " many " in what):
        return None
    if what.startswith("floats"):
        one, other = array.array("f", a), array.array("f", b)
        apart = [i for i, (x, y) in enumerate(zip(one, other)) if not near(x, y, row)]
    else:
        one, other = a, b
        apart = [i for i, (x, y) in enumerate(zip(a, b)) if abs(x - y) > (row is not None)]
    worst = max((abs(one[i] - other[i]) for i in apart), default=0)
    return checks.far_line(what, len({i // 4 for i in apart}), worst) if len(a) == len(b) else f"'{what}': another size"


alike = checks.each(differing)
