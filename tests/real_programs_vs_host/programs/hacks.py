"""Demonstrations of XScreenSaver, which use no programs: display lists, lighting, fog, textures."""

from pathlib import Path

from cases import Case, Program

FOLDER = Path("/usr/libexec/xscreensaver")
SECONDS = 3.0
HACKS = (
    "atunnel", "boing", "bouncingcow", "cube21", "cubicgrid", "dangerball", "engine", "flyingtoasters", "gears",
    "geodesic", "glhanoi", "glplanet", "hilbert", "juggler3d", "lament", "moebiusgears", "molecule", "morph3d",
    "pipes", "polyhedra", "queens", "sierpinski3d", "superquadrics", "surfaces",
)


class Hacks(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case(f"hacks-{name}", [str(FOLDER / name)], stop_after=SECONDS, recorded=True, api="egl",
                     least_programs=0, frames=40) for name in HACKS]


PROGRAM = Hacks("hacks", ("xscreensaver-gl", "xscreensaver-gl-extra", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "24 demonstrations in fixed function, from a record: their seeds are random")
