"""Coin, the Open Inventor of Debian, through a client of the project: its bump maps draw with programs of
its own, and a scene's SoShaderProgram may hold texts in assembly.
"""

from pathlib import Path

from cases import Case, Program, build_client


class Coin(Program):
    def cases(self, work: Path) -> list[Case]:
        client = build_client(work, "coin.cpp", ["-lCoin", "-lGL", "-lX11"])
        return [Case("coin", [str(client)], recorded=True, least_programs=2)]


PROGRAM = Coin("coin", ("libcoin-dev", "libx11-dev", "g++", "apitrace", "xvfb", "libgl1-mesa-dri"),
               "bump maps and a scene's own programs in assembly")
