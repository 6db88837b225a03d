#!/usr/bin/env python3
"""Random stages of NV_texture_shader, 2 and 3, before register combiners and before texture environments, drawn by
the layer on the host and by its rasterizer, against the words of the specifications
(src/fp_compiler/testing/evaluate_texture_shaders.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--fx9]
         [--json FILE]

With --fx9 the numerics are fx9 and the combiners are random states, of which each byte must be the integer that their
equations give (evaluate_combiners_fx9.cpp) of what the stages' texels are rounded to.

A pixel may be one step of 255 from the specification. Where coordinates are within 1e-3 texels of another texel (or
name two faces of a cube map, as a grey that a dependent read takes for a direction does), or a quotient is of numbers
near zero, nothing is decided and the pixel is not judged: at most seven in a hundred of them, or the run fails. So it
does where the rasterizer leaves more draws to the host than it may: those with textures of signed colours, which it
does not sample, are the host's.

Ends with "N passed, N failed, 0 skipped".
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "combiners_vs_specification"))
import drawn_states  # noqa: E402

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/texture_shaders_vs_specification/texture_shaders", most_unjudged=0.07,
                               least_drawn=0.5, has_fx9=True))
