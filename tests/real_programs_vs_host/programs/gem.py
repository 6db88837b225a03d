"""Gem, the graphics of Pure Data: a cube whose colors are a hash of the pixel's place, by the
example program that comes with it. Each rounding is visible.
"""

from pathlib import Path

from cases import DATA, Case, PrepareError, Program

TEXT = Path("/usr/share/gem/examples/data/random.fp")


class Gem(Program):
    def cases(self, work: Path) -> list[Case]:
        if not TEXT.exists():
            raise PrepareError("gem-doc is not installed, or without its examples")
        command = ["pd", "-nogui", "-noaudio", "-nomidi", "-lib", "Gem", "-open",
                   str(DATA / "gem.pd")]
        return [Case("gem", command, stop_after=6.0, recorded=True, frames=30)]


PROGRAM = Gem("gem", ("gem", "gem-doc", "puredata-core", "apitrace", "xvfb", "libgl1-mesa-dri"),
              "a hash of the pixel's place, by Gem's own example")
