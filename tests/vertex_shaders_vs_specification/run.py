#!/usr/bin/env python3
"""Tests random shaders of EXT_vertex_shader, defined by its commands. The layer draws with them on the host and by its
rasterizer; the reference is the specification's table of operations
(src/fp_compiler/testing/vertex_shader/evaluate.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--json FILE]

Every result is read from a buffer of floats. A result is not judged if a disturbance of 1e-4 in each operation changes
it by more than half of its tolerance, for example if a floor is next to a whole number. The run fails if that happens
to more than one in five, or if the rasterizer leaves more than one in fifty draws to the host.

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "combiners_vs_specification"))
import drawn_states  # noqa: E402

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/vertex_shaders_vs_specification/vertex_shaders", most_unjudged=0.2,
                               least_drawn=0.98))
