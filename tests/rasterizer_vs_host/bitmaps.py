"""Judges bitmaps under random state: pictures, depths, raster positions and errors must be equal. Hosts do not all
implement the specification's texture coordinates, fog and second color of bitmaps, DrawPixels and CopyPixels; these are
compared with colors computed here. Bitmaps that a host keeps for later must not crash a program, with any back end."""

import checks
import sides
from runner import Way

# The RGBA that OpenGL 2.1 (2.13, 3.7, 3.9, 3.10) defines for the values of rasterizer-bitmaps.
RULES = {
    "rule texture coordinates": (64, 191, 128, 255),
    "rule texture coordinates of another unit": (128, 32, 255, 255),
    "rule secondary colour": (96, 191, 207, 255),
    "rule colour sum": (96, 191, 207, 255),
    "rule fog": (112, 96, 143, 255),  # (4 - 1) / 4 of the color
    "rule fog of a depth": (112, 96, 143, 255),
    "rule fog of a program": (112, 96, 143, 255),
    "rule a texture": (0, 0, 255, 255),
}
# Texts by glXUseXFont, and whether the host writes anything.
FONTS = {"font before": True, "font in names of GenLists": True, "font in other names": True,
         "font in another context": True, "font of another context": True,
         "font and a list of the application's": True, "font deleted": False}
# Bitmaps that sample, followed by a change and a draw: what is drawn, and the numbers of each.
LETTERS = {"letters": (0, 255, 0), "triangle": (255, 255, 0, 255)}
CHANGES, DRAWS = range(3), range(6)


def rules(run):
    found = dict(run.layer)
    return [f"{name}: {tuple(found.get(name, b''))}, not {colour}"
            for rule, colour in RULES.items() for name in (rule, rule + " of DrawPixels", rule + " of CopyPixels")
            if run.backend != "host" and sides.distances(found.get(name, b""), bytes(colour))[0]]


def frames(run):
    """Checks that a bitmap and an image have their fog in every frame, whoever draws the rest of it."""
    wanted = bytes(RULES["rule fog"] * 2)
    return [f"{what}: {tuple(found)}" for what, found in run.layer if sides.distances(found, wanted)[0]]


def letters(run):
    found = dict(run.layer)
    return [f"{what}: {tuple(found.get(what, b''))}" for what, colour in LETTERS.items()
            if found.get(what, b"")[:len(colour)] != bytes(colour)]


def fonts(run):
    if any(what == "fonts: none" for what, _ in run.bare):
        return ["the X server has no font 'fixed', which is one of those that are built into it"]
    seen = {what: any(picture[0::4]) for what, picture in run.bare if picture}
    return [f"'{what}': {'nothing is' if not seen.get(what) else 'something is'} written"
            for what, is_seen in FONTS.items() if seen.get(what) != is_seen]


# The scenes are drawn by one context each, then by two of a share group in turns.
WAYS = (Way("scenes", words=("{first}", "{count}"), checks=(checks.alike, checks.mostly_ours(4))),
        Way("shared scenes", words=("shared", "{first}", "{count}")),
        Way("fonts", words=("fonts",), checks=(checks.alike, fonts)),
        Way("frames", "auto", words=("frames",), checks=(frames,), is_alone=True),
        Way("rules", words=("rules",), checks=(rules,), is_alone=True),
        *(Way(f"letters {change} {draw}, {backend}", backend, words=("letters", str(change), str(draw)),
              checks=(letters,), is_alone=True)
          for backend in ("auto", "host", "swrast") for change in CHANGES for draw in DRAWS))
