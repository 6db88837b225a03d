#!/usr/bin/env python3
"""Compares random materials between Begin and End on the bare host and under the layer, whose rasterizer draws the
primitives with them.

  run_materials.py --build build [--first SEED] [--count N] [--backend swrast]

Ends with "N passed, N failed, 0 skipped".
"""

import argparse
import sys

import sides
from x_server import XServer


def has_picture(what):
    """True if the bare host's picture must equal the layer's. Mesa 22.3.6 draws some primitives wrong that get a part
    of a
    material later, and back sides with some lights (they differ from the same vertices with their materials set outside
    of
    Begin and End, and from computed values)."""
    return "two sides" not in what and "grows" not in what


def judge(bare, layer):
    def shown(records):
        return [(what, picture if has_picture(what) else b"") for what, picture in records]
    return sides.differences(shown(bare), shown(layer))


def judge_cut(args, layer):
    """Compares with the layer's picture of the same materials outside of primitives."""
    with XServer() as display:
        env = sides.environment(sides.layer_of(args.build.resolve()), args.backend, {"DISPLAY": display})
        cut = sides.run([args.build.resolve() / "tests/rasterizer_vs_host/rasterizer-materials", args.first, args.count,
                         "cut"], env)
    return [f"{line}, of primitives without materials within" for line in sides.differences(cut, layer)]


def main():
    args = sides.seeded_arguments(__doc__, 20)
    bare, wrong, part = sides.compare(args, "rasterizer-materials",
                                      lambda bare, layer: judge(bare, layer) + judge_cut(args, layer))
    # The host gets strips in which a command other than Material(f)(v) sets materials, or a query is made.
    if not sides.mostly_ours(args, part, 5):
        wrong.append("too many draws are the host's")
    if args.backend == "swrast":  # also with late machine code, so that the host draws some primitives
        auto = argparse.Namespace(**{**vars(args), "backend": "auto", "count": max(args.count // 4, 1)})
        wrong += [f"auto: {line}" for line in sides.compare(auto, "rasterizer-materials", judge)[1]]
    return sides.conclude(args, "seeds", bare, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
