"""Really Slick Screensavers with ARB programs: cube maps, state.fog, vertex program matrices."""

from pathlib import Path

from cases import Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# Name, options, seconds, frames between two snapshots. hyperspace draws few frames a second on a
# processor, and the first twenty prepare what its programs read.
SAVERS = (
    ("hyperspace", ("-S", "100", "-R", "4", "-d", "3"), 30.0, 5),
    ("drempels", (), 4.0, 20),
)


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0", *options],
                     stop_after=seconds, recorded=True)
                for name, options, seconds, every in SAVERS]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "hyperspace and drempels, from a record: their seeds are random")
