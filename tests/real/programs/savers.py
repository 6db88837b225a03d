"""Really Slick Screensavers with ARB programs: cube maps, state.fog, matrices in vertex programs."""

from pathlib import Path

from cases import Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# Name, frames between two snapshots: one draws five frames a second on a processor, one a hundred.
SAVERS = (("hyperspace", 2), ("drempels", 20))


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0"], stop_after=4.0,
                     replay_every=every) for name, every in SAVERS]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "hyperspace and drempels, from a record: their seeds are random")
