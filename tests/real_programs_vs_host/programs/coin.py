"""Coin, the Open Inventor of Debian, through a client of the project: its bump maps draw with programs of
its own, and a scene's SoShaderProgram may hold texts in assembly.
"""

from pathlib import Path

from cases import DRAWN, WITHOUT_ANISOTROPY, Case, Program, build_client

# Coin adds highlights in passes with a vertex program to passes without, and compares depths by LEQUAL: no two
# implementations meet in the same pixels unless they compute depths alike. llvmpipe's do not meet mostly; those of
# softpipe and of the rasterizer all do, bit by bit.
# The anisotropy that Coin asks for is each filter's own: it is off in that comparison.
SOFTPIPE = {"GALLIUM_DRIVER": "softpipe", **WITHOUT_ANISOTROPY}


class Coin(Program):
    def cases(self, work: Path) -> list[Case]:
        client = build_client(work, "coin.cpp", ["-lCoin", "-lGL", "-lX11"])
        return [Case("coin", [str(client)], recorded=True, least_programs=2, ways_left_out=DRAWN),
                Case("coin-softpipe", [str(client)], environment=SOFTPIPE, recorded=True, least_programs=2)]


PROGRAM = Coin("coin", ("libcoin-dev", "libx11-dev", "g++", "apitrace", "xvfb", "libgl1-mesa-dri"),
               "bump maps and a scene's own programs in assembly")
