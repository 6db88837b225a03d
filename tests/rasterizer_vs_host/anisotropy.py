"""Judges a detailed plane that is drawn at steep angles with anisotropic filters of 2, 4, 8 and 16 to 1. The pictures
of bare hosts and of the rasterizer are compared with a reference of 256 samples a pixel, and with each other.

Differences are root mean squares over the picture, in 255ths."""

import math

# The two hosts of Mesa. llvmpipe draws the same for any limit above 1, softpipe and the layer depend on it.
HOSTS = ("llvmpipe", "softpipe")
MOST = (1, 2, 4, 8, 16)
# The difference of pictures that are equal except for the rounding of weights and levels.
SAME = 1.5
# If the limit causes the blur, softpipe and the rasterizer may be equally near.
NEARER = 1.05


def distance(a, b):
    """Returns the difference of red, green and blue; alpha is 255 everywhere."""
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / (len(a) * 3 // 4))


def figures(run):
    """Returns {view: (the bare host's distances from the reference, the layer's, those between the two)}. Each has an
    element for each of MOST."""
    bare, layer = dict(run.bare), dict(run.layer)
    rows = {}
    for view in (name.removesuffix(": reference") for name in bare if name.endswith(": reference")):
        names = [f"{view}: {most}" for most in MOST]
        rows[view] = (*([distance(bare[f"{view}: reference"], side[name]) for name in names] for side in (bare, layer)),
                      [distance(bare[name], layer[name]) for name in names])
    return rows


def near(run):
    wrong = [] if figures(run) else ["there are no views"]
    for view, (bare, layer, apart) in figures(run).items():
        lines = []
        if run.case.driver == "llvmpipe" and apart[0] > SAME:
            lines.append("without anisotropy the two differ")
        lines += [f"at {most} to 1 the host is nearer to the reference"
                  for most, ours, other in list(zip(MOST, layer, bare))[1:] if ours > NEARER * other]
        if any(more > less + SAME for less, more in zip(layer, layer[1:])):
            lines.append("more samples are worse")
        wrong += [f"{view}: {line}" for line in lines]
    return wrong


def drawn(run):
    """Returns the bounds of the rasterizer's draws."""
    return len(figures(run)) * len(MOST), math.inf


def tell(run):
    return "from the reference bare, under the layer, and between the two" + "".join(
        f"\n     {view:33}" + "    ".join("".join(f"{d:6.2f}" for d in row) for row in rows)
        for view, rows in figures(run).items())
