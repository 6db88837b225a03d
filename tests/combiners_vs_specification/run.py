#!/usr/bin/env python3
"""Random states of NV_register_combiners and 2, drawn by the layer on the host and by its rasterizer, against the
equations of section 3.8.12 (src/fp_compiler/testing/evaluate_combiners.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--fx9]
         [--json FILE]

With --fx9 the numerics are fx9, and each byte must be the integer that the equations give (evaluate_combiners_fx9.cpp).
Without, a pixel may be one step of 255 from the equations; where a mux's chooser is within 1e-3 of one half nothing is
decided. Such pixels, and with --fx9 those of which an input is as near to being rounded otherwise, are not judged: at
most one in a hundred of them, or the run fails. So it does where the rasterizer leaves more draws to the host than one
in fifty.

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import drawn_states

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/combiners_vs_specification/combiners", most_unjudged=0.01,
                               least_drawn=0.98, has_fx9=True))
