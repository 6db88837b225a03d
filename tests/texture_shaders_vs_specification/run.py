#!/usr/bin/env python3
"""Tests random stages of NV_texture_shader, 2 and 3, before register combiners and before texture environments. The
layer draws them on the host and by its rasterizer; the reference follows the specifications
(src/fp_compiler/testing/evaluate_texture_shaders.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--fx9]
         [--json FILE]

With --fx9 the numerics are fx9 and the combiners are random states. Each byte must be the integer that their equations
give (evaluate_combiners_fx9.cpp) for the rounded texels of the stages.

A pixel may be one step of 255 from the specification. A pixel is not judged if coordinates are within 1e-3 texels of
another texel (or of another face of a cube map, as when a dependent read uses a grey as a direction), or if a quotient
is of numbers near zero. The run fails if those are more than seven in a hundred, or if the rasterizer leaves too many
draws to the host: it may leave those with textures of signed colors, which it does not sample.

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "combiners_vs_specification"))
import drawn_states  # noqa: E402

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/texture_shaders_vs_specification/texture_shaders", most_unjudged=0.07,
                               least_drawn=0.5, has_fx9=True))
