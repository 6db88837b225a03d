#!/usr/bin/env python3
"""Compares fixed function without any program: random scenes on the bare host and under the layer, whose rasterizer
draws
them; with ARBITER_FIXED_FUNCTION=programs it must draw none.

  run_fixed.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides
from x_server import XServer


def of_whole_lists(args, bare):
    """Returns the bare host's records, or those of whole lists if lists that set the current normal draw differently.
    Mesa 25.0.7 gives the first vertices of a list the normal that a later command sets."""
    with XServer() as display:
        whole = sides.run([args.build.resolve() / "tests/rasterizer_vs_host/rasterizer-fixed", args.first, args.count],
                          sides.environment(extra={"DISPLAY": display, "LISTS_WHOLE": "1"}))
    return [theirs if sides.distances(mine[1], theirs[1])[0] else mine
            for mine, theirs in zip(bare, whole, strict=True)]


def main():
    args = sides.seeded_arguments(__doc__, 10)
    passed = failed = 0
    count = args.count
    for mode in ("always", "programs"):
        # In the second mode it only checks that the rasterizer draws nothing.
        args.count = count if mode == "always" else max(count // 5, 1)
        bare, wrong, part = sides.compare(args, "rasterizer-fixed",
                                          lambda bare, layer: sides.differences(of_whole_lists(args, bare), layer),
                                          {"ARBITER_FIXED_FUNCTION": mode})
        drawn, given = part.get("drawn", 0), part.get("given_to_host", {})
        if mode == "programs" and (drawn or given):
            wrong.append("the rasterizer is used where no program is")
        if mode == "always" and not sides.mostly_ours(args, part, 20):
            wrong.append("too many draws are the host's")
        print(f"{'FAIL' if wrong else 'pass'} {mode}: {args.count} scenes from seed {args.first}, {len(bare)} "
              f"records; the rasterizer drew {drawn}, the host {given}")
        for line in wrong[:12]:
            print(f"     {line}")
        passed, failed = passed + (not wrong), failed + bool(wrong)
    print(f"{passed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
