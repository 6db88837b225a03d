#!/usr/bin/env python3
"""Tests random states of NV_register_combiners and 2, drawn by the layer on the host and by its rasterizer, against the
equations of section 3.8.12 (src/fp_compiler/testing/evaluate_combiners.cpp).

  run.py --build build [--first SEED] [--count N] [--backend host|swrast|both] [--profile NAME] [--fx9]
         [--json FILE]

With --fx9 the numerics are fx9, and each byte must be the integer that the equations give (evaluate_combiners_fx9.cpp).
Without, a pixel may be one step of 255 from the equations, and a mux whose chooser is within 1e-3 of one half is
undecided. Such pixels are not judged, and with --fx9 neither are those with an input near a rounding boundary. The run
fails if they are more than one in a hundred, or if the rasterizer leaves more than one in fifty draws to the host.

Ends with "N passed, N failed, 0 skipped".
"""

import sys

import drawn_states

if __name__ == "__main__":
    sys.exit(drawn_states.main(__doc__, "tests/combiners_vs_specification/combiners", most_unjudged=0.01,
                               least_drawn=0.98, has_fx9=True))
