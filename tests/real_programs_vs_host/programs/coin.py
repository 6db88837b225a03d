"""Coin, Debian's Open Inventor, through a client of the project.

Its bump maps draw with programs of its own, and a scene's SoShaderProgram may contain assembly texts.
"""

from pathlib import Path

from cases import DRAWN, WITHOUT_ANISOTROPY, Case, Program, build_client

# Coin adds highlights in passes with a vertex program to passes without, and compares depths by LEQUAL. Two
# implementations only agree if they compute depths alike. llvmpipe's passes mostly do not meet; softpipe's and the
# rasterizer's do, bit by bit. The anisotropic filter that Coin enables is implementation-dependent, so that it is off
# in that comparison. softpipe filters texels in floats, the rasterizer as llvmpipe does, with 8 bits; the highlights'
# powers show that at their rims.
SOFTPIPE = {"GALLIUM_DRIVER": "softpipe", **WITHOUT_ANISOTROPY}


class Coin(Program):
    def cases(self, work: Path) -> list[Case]:
        client = build_client(work, "coin.cpp", ["-lCoin", "-lGL", "-lX11"])
        return [Case("coin", [str(client)], recorded=True, least_programs=2,
                     ways_left_out=(*DRAWN, "programs")),
                Case("coin-softpipe", [str(client)], environment=SOFTPIPE, recorded=True, least_programs=2,
                     wrong_pixels=400)]


PROGRAM = Coin("coin", ("libcoin-dev", "libx11-dev", "g++", "apitrace", "xvfb", "libgl1-mesa-dri"),
               "bump maps and a scene's own programs in assembly")
