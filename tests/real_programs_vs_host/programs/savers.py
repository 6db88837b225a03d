"""Really Slick Screensavers: with ARB programs (cube maps, state.fog, vertex program matrices) and without."""

from pathlib import Path

from cases import Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# The name, options, seconds, and allowed number of differing pixels. hyperspace draws few frames a second on a
# processor, and the first twenty prepare what its programs read. It reflects at normals from a cube map, whose rounding
# changes the level of detail of the next cube map lookup.
SAVERS = (
    ("hyperspace", ("-S", "100", "-R", "4", "-d", "3"), 30.0, 400),
    ("drempels", (), 4.0, 60),
)
# These use fixed function. Some of hufo_smoke's colors are NaN, which the host clamps to 1.
PLAIN = ("biof", "busyspheres", "colorfire", "cyclone", "euphoria", "feedback", "fieldlines", "flocks", "flux",
         "hufo_smoke", "hufo_tunnel", "lattice", "lorenz", "matrixview", "pixelcity", "plasma", "skyrocket",
         "solarwinds", "spirographx", "sundancer2")
PLAIN_SECONDS = 4.0


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        programs = [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0", *options], stop_after=seconds,
                         recorded=True, wrong_pixels=wrong) for name, options, seconds, wrong in SAVERS]
        return programs + [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0"], stop_after=PLAIN_SECONDS,
                                recorded=True, least_programs=0, frames=40) for name in PLAIN]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "twenty-two, two of them with programs, from a record: their seeds are random")
