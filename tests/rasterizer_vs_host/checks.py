"""The checks of a run (runner.py) that many rows share. A check returns complaints, a line each."""

import sides


def alike(run):
    """Compares the records, but for a rounding of 1 in 255."""
    return sides.differences(run.bare, run.layer)


def alike_but_for(rounding, few=0):
    """Compares the records. Up to `few` pixels of a picture may differ by more than `rounding`."""
    return lambda run: sides.far_pictures(run.bare, run.layer, rounding, few)


def same_names(run):
    """Compares the records' names alone."""
    pairs = [(bare, layer) for (bare, _), (layer, _) in zip(run.bare, run.layer) if bare != layer]
    if len(run.bare) == len(run.layer) and not pairs:
        return []
    return ["other records" + "".join(f": bare '{bare}', layer '{layer}'" for bare, layer in pairs[:1])]


def each(differing):
    """Compares record by record. differing(what, bare, layer) returns a line, or nothing."""
    return lambda run: same_names(run) or [line for (what, bare), (_, layer) in zip(run.bare, run.layer)
                                           if (line := differing(what, bare, layer))]


def far_line(what, far, worst):
    """Returns the line about pixels that differ; nothing if none do."""
    return f"'{what}': {far} pixels differ, by up to {worst}" if far else None


def has_drawn(run):
    """The rasterizer must draw, except where the host draws everything."""
    return ["the rasterizer drew nothing"] if run.backend != "host" and not run.drawn else []


def mostly_ours(least):
    """The rasterizer, when it must draw, must draw more than `least` times what the host does."""
    return lambda run: ["too many draws are the host's"] if run.backend == "swrast" and \
        run.drawn <= least * sum(run.given.values()) else []


def all_ours(run):
    """The rasterizer, when it must draw, must draw everything."""
    return ["draws of the host's"] if run.backend == "swrast" and (not run.drawn or run.given) else []


def counted(figure, bounds):
    """Holds a figure of the statistics. `bounds`: a function of the run that returns (least, most), or None."""
    def check(run):
        part = run.part
        for word in figure.split("."):
            part = part.get(word, {})
        value, limits = part or 0, bounds(run)
        return [] if not limits or limits[0] <= value <= limits[1] else \
            [f"{value} {figure}, not {limits[0]} to {limits[1]}"]
    return check


def shows_something(run):
    """The bare host must show something: otherwise nothing would be compared."""
    return [] if any(any(picture) for _, picture in run.bare) else ["the bare host shows nothing"]


def each_shows(run):
    """Each of the bare host's pictures must have red or blue."""
    return [f"'{what}': nothing is drawn" for what, picture in run.bare
            if picture and not any(picture[0::4]) and not any(picture[2::4])]
