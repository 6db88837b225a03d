"""The checks of a run (runner.py) that single rows of comparisons.py have. A check returns complaints, a line each."""

import array
import collections
import dataclasses
import re
import statistics

import checks
import sides
from runner import BARE

# Of blended layers, whose alpha is a product of a width and a length, and at the corners of what was clipped.
STROKE_ROUNDING, STROKE_PIXELS = 4, 3
# In one picture of forty a point is between two rows within its last bit. Also, the ends of a smooth line's dashes
# differ slightly between Mesa 25 and both Mesa 22 and the rasterizer.
A_ROW = 48


def strokes(run):
    wrong = sides.far_pictures(run.bare, run.layer, STROKE_ROUNDING, A_ROW)
    close = [line for line in sides.far_pictures(run.bare, run.layer, STROKE_ROUNDING, STROKE_PIXELS)
             if "smooth stippled" not in line]
    return wrong + (close if len(close) > len(run.bare) / 40 else [])


def depth_buffers(what, bare, layer):
    """Compares depths of 32 bits to the last bit, and colors."""
    if not what.endswith(" depth"):
        return checks.far_line(what, *sides.distances(bare, layer))
    apart = [abs(x - y) for x, y in zip(array.array("I", bare), array.array("I", layer))]
    return checks.far_line(what, sum(d > 0 for d in apart), max(apart, default=0))


# The fraction of pixels, for one target, one way of sampling and one projection, that may differ: triangles and quads
# whose level of detail is halfway between two levels within the last bits of their coordinates.
HALFWAY = 0.003
KIND = re.compile(r"seed \d+ (?P<kind>\w+ by (?:fixed function|\w+)(?: in perspective)?)")


def levels(run):
    """Each pixel must use the same levels of detail."""
    if wrong := checks.same_names(run):
        return wrong
    apart, pixels, seen = collections.Counter(), collections.Counter(), set()
    for (what, bare), (_, layer) in zip(run.bare, run.layer):
        if bare:
            kind = KIND.match(what)["kind"]
            apart[kind] += sides.distances(bare, layer, 0)[0]
            pixels[kind] += len(bare) // 4
            seen.update(bare[0::4])
    wrong = [f"'{kind}': {count} of {pixels[kind]} pixels are of another level or face"
             for kind, count in apart.items() if count > HALFWAY * pixels[kind]]
    return wrong + ([f"{len(seen)} levels alone are seen"] if len(seen) < 9 else [])


OTHER = ", t is another"  # OpenGL's rule, which no host follows: the reference is the picture without it


def compared(run):
    wrong = sides.differences(*([each for each in side if OTHER not in each[0]] for side in (run.bare, run.layer)))
    ours = dict(run.layer)
    for what, picture in run.layer:
        far, worst = sides.distances(picture, ours[what.replace(OTHER, "")], 0)
        if far:
            wrong.append(f"'{what}': {far} pixels are not those where t is r, by up to {worst}")
    return wrong


def of_whole_lists(run):
    """Compares with the bare host's records, or with those of whole lists if lists that set the current normal draw
    differently. Mesa 25.0.7 gives the first vertices of a list the normal that a later command sets."""
    whole = run.case.records(dataclasses.replace(BARE, env={"LISTS_WHOLE": "1"}), run.way)
    return sides.differences([theirs if sides.distances(mine[1], theirs[1])[0] else mine
                              for mine, theirs in zip(run.bare, whole, strict=True)], run.layer)


def unused(run):
    """The rasterizer must not be used where no program is."""
    return ["the rasterizer is used where no program is"] if run.drawn or run.given else []


def materials(run):
    """Compares all but some pictures. Mesa 22.3.6 draws some primitives wrong that get a part of a material later, and
    back sides with some lights. They differ from the same vertices with their materials set outside of Begin and End,
    and from computed values."""
    return sides.differences(*([(what, b"" if "two sides" in what or "grows" in what else picture)
                                for what, picture in side] for side in (run.bare, run.layer)))


def materials_outside(run):
    """Compares with the layer's picture of the same materials outside of primitives."""
    return [f"{line}, of primitives without materials within"
            for line in sides.differences(run.again(own_words=("cut",)).layer, run.layer)]


# One picture for each of: factors, equations, and the layers; the last record has the errors.
BLENDED = 2 * (15 * 15 + 5 * 5) + 1 + 1
# Whoever fills the pictures, the rasterizer draws the blended squares.
SQUARES = 64 * (BLENDED - 2)


def blended(run):
    wrong = [] if len(run.bare) == BLENDED else [f"{len(run.bare)} records, not {BLENDED}"]
    if len({picture for _, picture in run.bare}) < BLENDED // 2:
        wrong.append("pictures are alike that are to differ")
    return wrong


def seen_changes(run):
    """A change that is invisible on the bare host fails too, as nothing would be tested."""
    seen = collections.defaultdict(dict)
    for name, picture in run.bare:
        what, when = name.rsplit(": ", 1)
        seen[what][when] = picture
    return [f"{what}: {second} is not to be seen in pixels" for what, moments in seen.items()
            for first, second in (("before", "after"), ("pushed", "popped"))
            if first in moments and moments[first] == moments.get(second)]


POISON = 85, 170, 157  # patterns of fresh memory: of two bare runs, and of the layer's


def defined(case, way, attempts=3):
    """Returns the records that two bare runs agree on: a host without MIT-SHM shows uninitialised memory if a window
    has grown since its buffers were made. It may crash from it: in one of twenty runs under AddressSanitizer, inside
    its driver."""
    def bare_run(poison):
        for attempt in range(1, attempts + 1):
            try:
                return case.records(dataclasses.replace(BARE, fresh=poison), way)
            except sides.Died:
                if attempt == attempts:
                    raise
    return [one if one == other else None for one, other in zip(bare_run(POISON[0]), bare_run(POISON[1]))]


def mixed(run):
    if len(run.bare) != len(run.layer):
        return [f"{len(run.layer)} records for {len(run.bare)}"]
    kept = [(bare, layer) for bare, layer in zip(run.bare, run.layer) if bare]
    wrong = sides.differences(*zip(*kept))
    if len(kept) < len(run.bare) * 3 // 4:
        wrong.append(f"only {len(kept)} of {len(run.bare)} pictures are defined")
    if run.backend != "host" and not run.given:
        wrong.append("the host drew nothing")
    return wrong


DRAWS = 12  # in a frame of the row steady
FIRST = 8  # frames until machine code is there
STARTS = 4  # more starts: on a busy machine one may not wait long enough for the machine code on disk


def steady_draws(run):
    """Returns the bounds of the rasterizer's draws, of all frames."""
    return ((run.count - FIRST) * DRAWS, run.count * DRAWS) if run.name == "whole" else (0, FIRST * DRAWS)


def draws_from_the_start(run):
    """If the rasterizer drew a program's frames completely, it draws from the start at the next run."""
    drawn = []
    while run.name == "whole" and len(drawn) < STARTS:
        again = run.again()
        drawn.append(again.drawn)
        if (wrong := checks.alike(again)) or again.drawn == run.count * DRAWS:
            return wrong
    return [f"starts after it drew {drawn} of {run.count * DRAWS}"] if drawn else []


# The host draws only the trial frames (7 and the first), or all but those.
TRIAL_FRAMES = 16


def back_off(run):
    """Compares the pictures, and judges which side drew: the frames' times, in the second record, depend on the
    machine."""
    wrong = sides.differences(run.bare[:1], run.layer[:1])
    figures = run.part.get("back_off", {})
    on_host = figures.get("frames_on_host", 0)
    if not figures.get("trials"):
        wrong.append("there was no trial")
    if run.name == "cheap" and on_host < run.count // 2:
        wrong.append(f"only {on_host} of {run.count} frames are the host's")
    if run.name == "dear" and on_host > TRIAL_FRAMES:
        wrong.append(f"{on_host} frames are the host's")
    return wrong


def tell_times(run):
    """Returns the frame times of both sides, which are not judged."""
    bare, layer = (statistics.median([int(time) for time in times.split()][run.count * 2 // 3:]) / 1000
                   for _, times in (run.bare[1], run.layer[1]))
    return f"{bare:.2f} ms a frame bare, {layer:.2f} layered; {run.part.get('back_off')}; drew {run.drawn}"


# Scenes that the two sides round differently, and by how many steps of 255: one of a thousand lit vertices.
# With x87 the host also rounds the product of two matrices otherwise, which a vertex program reads.
STILL_ROUNDED = {"lit-apart": 1, "materials": 1, "vertex-program": 1 if sides.HOST_HAS_X87 else 0}
# A scene that changes once: only after its draw does the first frame turn out to be a mixed one.
ONCE = ("anisotropy-mixed",)
# Two contexts also draw these in turns; the second one starts with the results about the first.
TWO = ("anisotropy", "anisotropy-by-program", "color-sum-late", "letters-in-fog", "stipple-in-perspective")


def still(run):
    """No picture may differ from the first one."""
    pictures = [(what, picture) for what, picture in run.layer if picture]
    lines = [f"'{what}'" for what, picture in run.layer if not picture and what != "errors"]
    if run.name in ONCE and len(pictures) > 1:
        pictures = pictures[1:]
    for what, picture in pictures[1:]:
        far, worst = sides.distances(pictures[0][1], picture, STILL_ROUNDED.get(run.name, 0))
        if far:
            lines.append(f"'{what}': {far} pixels change, by up to {worst}")
    return lines


def read_from_disk(run):
    """A second start must read its machine code from disk: the functions are the same, nothing is stored again, and
    they are ready in a fraction of the time."""
    def objects():
        return {path: path.stat().st_ino for path in run.case.cache.glob("**/code/**/*")
                if path.is_file() and path.name != "key"}
    stored, second = objects(), run.again()
    made, taken = (part.get("machine_code", {}) for part in (run.part, second.part))
    holds = {
        "the first start stores its functions": len(stored) >= 3,
        "the second has as many functions": made.get("functions", 0) >= 3
        and made["functions"] == taken.get("functions"),
        "the second stores nothing": stored == objects(),
        # Compiling a function takes some milliseconds, loading it a fraction of one.
        "the second does not compile": 0 < 3 * taken.get("compile_microseconds", 0)
        < made.get("compile_microseconds", 0),
        # Draws wait here: under auto, on a busy machine, the host may draw before the library is loaded.
        "all draws of the second are the rasterizer's": second.drawn > 0 and not second.given,
    }
    return [f"it does not hold that {what}: {made}, then {taken}, {len(stored)} objects"
            for what, is_so in holds.items() if not is_so]
