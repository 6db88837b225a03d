"""Really Slick Screensavers: with ARB programs (cube maps, state.fog, vertex program matrices) and without."""

from pathlib import Path

from cases import HOST_FILTERS_IN_FLOATS, Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# hyperspace reflects at normals that it reads from a cube map, whose roundings come back as other levels of
# detail of the cube map that it then looks up: 216 of 786,432 pixels in the worst of 120 frames, with the
# host's filter in floats.
# Name, options, seconds, environment. hyperspace draws few frames a second on a processor, and the
# first twenty prepare what its programs read.
SAVERS = (
    ("hyperspace", ("-S", "100", "-R", "4", "-d", "3"), 30.0, HOST_FILTERS_IN_FLOATS),
    ("drempels", (), 4.0, {}),
)
# In fixed function. feedback's picture is its last one's texture, so that what filters round grows from frame to
# frame; hufo_smoke's colours are at times no numbers, which the host clamps to 1.
PLAIN = ("biof", "busyspheres", "colorfire", "cyclone", "euphoria", "fieldlines", "flocks", "flux", "hufo_smoke",
         "hufo_tunnel", "lattice", "lorenz", "matrixview", "pixelcity", "plasma", "skyrocket", "solarwinds",
         "spirographx", "sundancer2")
GROWING = "feedback"
PLAIN_SECONDS = 4.0


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        def plain(name: str, environment: dict[str, str]) -> Case:
            return Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0"], environment=environment,
                        stop_after=PLAIN_SECONDS, recorded=True, least_programs=0, frames=40)

        programs = [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0", *options], environment=environment,
                         stop_after=seconds, recorded=True, wrong_pixels=400 if environment else 60)
                    for name, options, seconds, environment in SAVERS]
        return [*programs, *(plain(name, {}) for name in PLAIN), plain(GROWING, HOST_FILTERS_IN_FLOATS)]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "twenty-two, two of them with programs, from a record: their seeds are random")
