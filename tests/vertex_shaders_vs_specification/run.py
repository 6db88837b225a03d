#!/usr/bin/env python3
"""Random shaders of EXT_vertex_shader, defined by its commands and drawn with by the layer on the host and by its
rasterizer, against the table of operations of the specification
(src/fp_compiler/testing/vertex_shader/evaluate.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--json FILE]

Every result is read from a buffer of floats. Where a disturbance of 1e-4 in each operation changes a result by more
than half of what it may differ by, as where a floor is next to a whole number, nothing is decided and the result is not
judged: at most one in five of them, or the run fails. So it does where the rasterizer leaves more draws to the host
than one in fifty.

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "combiners_vs_specification"))
import drawn_states  # noqa: E402

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/vertex_shaders_vs_specification/vertex_shaders", most_unjudged=0.2,
                               least_drawn=0.98))
