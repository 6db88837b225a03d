"""Demonstrations of XScreenSaver, which use no program text: display lists, lighting, fog, textures."""

from pathlib import Path

from cases import DRAWN, Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
SECONDS = 3.0
HACKS = (
    "atunnel", "boing", "bouncingcow", "cube21", "cubicgrid", "dangerball", "flyingtoasters", "gears", "geodesic",
    "glhanoi", "glplanet", "juggler3d", "lament", "moebiusgears", "molecule", "morph3d", "pipes", "polyhedra",
    "queens", "sierpinski3d", "superquadrics", "surfaces",
)
# Spheres that lie in each other: who is seen depends on the last bit of depths, which llvmpipe computes
# otherwise for each state of lighting. softpipe's are the same for both, as the rasterizer's are.
SOFTPIPE = {"GALLIUM_DRIVER": "softpipe"}


class Hacks(Program):
    def cases(self, work: Path) -> list[Case]:
        def case(name: str, suffix: str = "", **more) -> Case:
            return Case(f"hacks-{name}{suffix}", [str(FOLDER / name)], stop_after=SECONDS, recorded=True,
                        api="egl", least_programs=0, frames=40, **more)

        # engine's discs lie in one plane under matrices of their own, so that the last bit of a depth says
        # which is seen: llvmpipe and softpipe differ from each other in more pixels than the rasterizer
        # does from either.
        hosts = [case(name, ways_left_out=DRAWN) for name in ("engine", "hilbert")]
        return [*(case(name) for name in HACKS), *hosts, case("hilbert", "-softpipe", environment=SOFTPIPE)]


PROGRAM = Hacks("hacks", ("xscreensaver-gl", "xscreensaver-gl-extra", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "24 demonstrations in fixed function, from a record: their seeds are random")
