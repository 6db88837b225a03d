#!/usr/bin/env python3
"""Compares textures in vertex programs: random sequences under the layer, drawn by the host and by the rasterizer; a
bare
host has no such programs. The host waits for its draws to a texture before a vertex program samples it: Mesa 22.3.6's
llvmpipe does not, and gives other pixels from run to run. The rasterizer must make nearly all of its draws.

  run_vertex_textures.py --build build [--first SEED] [--count N] [--backend auto]

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import sides


def main():
    args = sides.seeded_arguments(__doc__, 40)
    found, wrong, part = sides.compare(args, "rasterizer-vertex-textures", sides.differences,
                                       {"ARBITER_PROFILE": "nv40"}, host=["finish"])
    if not sides.mostly_ours(args, part, 50):
        wrong.append("too many draws are the host's")
    return sides.conclude(args, "sequences", found, wrong, part)


if __name__ == "__main__":
    sys.exit(main())
