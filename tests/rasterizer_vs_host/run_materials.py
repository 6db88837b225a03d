#!/usr/bin/env python3
"""Materials between Begin and End by chance, on the bare host and under the layer, whose rasterizer draws the
primitives with them.

  run_materials.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import sys

import sides
from x_server import XServer


def has_picture(what):
    """Whether the bare host's picture is to be that of the layer. Mesa 22.3.6 draws some primitives wrong that get a
    part of a material further on, and back sides of some lights (neither is as the same vertices are with their
    materials given outside of Begin and End, or on paper)."""
    return "two sides" not in what and "grows" not in what


def judge(bare, layer):
    def shown(records):
        return [(what, picture if has_picture(what) else b"") for what, picture in records]
    return sides.differences(shown(bare), shown(layer))


def judge_cut(args, layer):
    """What the layer makes of the same materials outside of primitives."""
    with XServer() as display:
        env = sides.environment(sides.layer_of(args.build.resolve()), args.backend, {"DISPLAY": display})
        cut = sides.run([args.build.resolve() / "tests/rasterizer_vs_host/rasterizer-materials", args.first, args.count,
                         "cut"], env)
    return [f"{line}, of primitives without materials within" for line in sides.differences(cut, layer)]


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-materials",
                                      lambda bare, layer: judge(bare, layer) + judge_cut(args, layer))
    # What another command than Material(f)(v) sets in a strip is the host's, and what is asked within.
    if not sides.mostly_ours(args, part, 5):
        wrong.append("too many draws are the host's")
    if args.backend == "swrast":  # and with code that is compiled meanwhile, so that some primitives are the host's
        auto = argparse.Namespace(**{**vars(args), "backend": "auto", "count": max(args.count // 4, 1)})
        wrong += [f"auto: {line}" for line in sides.compare(auto, "rasterizer-materials", judge)[1]]
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
