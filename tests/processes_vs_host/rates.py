"""Compares failure rates, for rows in which the bare host itself sometimes fails, as exit() does in a handler that
interrupted malloc: does the layer fail more often? A failure only counts as the host's if the bare host failed in
the same way, in runs of its own.
"""
import math
import time

AT_MOST = 240  # bare runs, until one ends in the way that the layer's did
AT_LEAST = 60  # runs of each
DOUBT = 0.01   # the probability below which the layer's number counts as worse


def chance(bare_failures, bare_runs, layer_failures, layer_runs):
    """Returns the probability that at least this many of the failures are the layer's if both are alike (Fisher)."""
    failures, runs = bare_failures + layer_failures, bare_runs + layer_runs
    return sum(math.comb(layer_runs, k) * math.comb(bare_runs, failures - k)
               for k in range(layer_failures, min(failures, layer_runs) + 1)) / math.comb(runs, failures)


def compare(end, bare_run, layer_run, seconds=math.inf):
    """Returns (worse, words).

    `bare_run` and `layer_run` make a run with a new seed and return how it ended, or None if it was right; `end` is how
    one of the layer's ended. If after that many seconds there are too few runs to judge, it counts as worse."""
    until = time.monotonic() + seconds
    again = sum(layer_run() is not None for _ in range(6))
    if again >= 5 and all(bare_run() != end for _ in range(6)):  # that is no chance
        return True, f"{end}, and {again} of 6 more runs fail"
    # The runs alternate, as the machine's load affects asynchronous events.
    bare, layer = [], []
    while len(bare) < AT_MOST and (not bare or time.monotonic() < until):
        if len(bare) >= AT_LEAST and {end, None, *layer} <= {None, *bare}:
            break
        bare.append(bare_run())
        layer.append(layer_run())
    if len(bare) < AT_LEAST:
        return True, f"{end}, and no time to compare: {len(bare)} runs of each in {seconds:.0f} s"
    if end not in bare:
        return True, f"{end}, and never in {len(bare)} bare runs"
    others = sorted({e for e in layer if e is not None and e not in bare})
    failures = sum(e is not None for e in bare)
    failed = sum(e is not None for e in layer)
    words = f"fails in {failed} of {len(layer)} runs, bare {failures} of {len(bare)} ({end})"
    if others:
        return True, f"{words}; {', '.join(others)} never bare"
    return chance(failures, len(bare), failed, len(layer)) < DOUBT, words
