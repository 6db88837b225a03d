"""Really Slick Screensavers with ARB programs: cube maps, state.fog, vertex program matrices."""

from pathlib import Path

from cases import HOST_FILTERS_IN_FLOATS, Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# hyperspace reflects at normals that it reads from a cube map. With the host's filter in floats what differs
# are the levels of detail of the cube map that it then looks up: 2,676 of 786,432 pixels in the
# worst of 40 frames, none without mipmaps.
# Name, options, seconds, environment. hyperspace draws few frames a second on a processor, and the
# first twenty prepare what its programs read.
SAVERS = (
    ("hyperspace", ("-S", "100", "-R", "4", "-d", "3"), 30.0, HOST_FILTERS_IN_FLOATS),
    ("drempels", (), 4.0, {}),
)


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0", *options],
                     environment=environment, stop_after=seconds, recorded=True,
                     wrong_pixels=2400 if environment else 60)
                for name, options, seconds, environment in SAVERS]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "hyperspace and drempels, from a record: their seeds are random")
