"""Really Slick Screensavers with ARB programs: cube maps, state.fog, vertex program matrices."""

from pathlib import Path

from cases import Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
# hyperspace reflects at normals that it reads from a cube map. llvmpipe filters those to 8 bits with
# weights of 8 bits, which its next lookup enlarges to noise of half a colour; told to filter as
# it does other formats, in floats, it and the rasterizer agree but for the levels of detail of a last
# cube map at those directions: 2,676 of 786,432 pixels in the worst of 40 frames, none without
# mipmaps.
IN_FLOATS = {"GALLIVM_PERF": "no_aos_sampling"}
# Name, options, seconds, environment. hyperspace draws few frames a second on a processor, and the
# first twenty prepare what its programs read.
SAVERS = (
    ("hyperspace", ("-S", "100", "-R", "4", "-d", "3"), 30.0, IN_FLOATS),
    ("drempels", (), 4.0, {}),
)


class Savers(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case(f"savers-{name}", [str(FOLDER / name), "-r", "-y", "0", *options],
                     environment=environment, stop_after=seconds, recorded=True,
                     wrong_pixels=4000 if environment else 60)
                for name, options, seconds, environment in SAVERS]


PROGRAM = Savers("savers", ("rss-glx", "apitrace", "xvfb", "libgl1-mesa-dri"),
                 "hyperspace and drempels, from a record: their seeds are random")
